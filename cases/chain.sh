#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: chain.sh COMMAND ARGUMENT...: what chain.mk asks about the stages and the files of a case, in the folder of the case.
#
# It takes from the environment
#   BIN       the folder of the programs
#   MODEL_OF  the folder of the case whose model this one links to; empty if there is none
#   MADE      the files that rules of the case's own Makefile make; empty if there are none
# A case may come from a stranger, and make runs what it finds in a text that it is given. Therefore no text of a case is
# printed here, only digests and fixed names.
#
# For each FILE that make has made there is .chain/FILE.sha256 with its digest. A file is make's own as long as its bytes have
# this digest, or if it is a link into MODEL_OF. All other files are the user's, and are neither overwritten nor removed.
# .chain/FILE.made_of tells what it was made of: the digest of the values that the stage read, and those of the files.
# .chain/FILE.begun tells the same while the stage runs. If it is still there, the run was killed before it could note anything,
# and a file that is newer is taken for what the run has made.
PATH=$BIN:$PATH
from_other_case='sector.msh model.h5 fields.h5'
responses='_full _plain _one_term'  # that tiprub-simulate may write beside its output
sweeps='response response_up response_down'

# Prints the digest of all values that the stage reads of its case. A case that the stage refuses has the digest of nothing;
# look then shows what is wrong.
name_values() { # STAGE CASE OPTION...
  stage=$1
  shift
  digest=$("tiprub-$stage" "$@" --tables 2> /dev/null | sha256sum)
  echo "${digest%% *}"
}

look() { # STAGE CASE OPTION...
  stage=$1
  shift
  command -v "tiprub-$stage" > /dev/null || { missing "$stage" >&2; exit 1; }
  "tiprub-$stage" "$@" --tables > /dev/null
}

missing() { # STAGE
  package=tiprub
  test "$1" != reduce || package=tiprub-reduce
  echo "tiprub-$1 is neither in $BIN nor on the PATH; on Debian it is in the package $package"
}

# The user's own files may be large, and are not read: another one has another size or date, even if it is an older one. A copy of
# the folder keeps both, but not the inodes.
made_of() { # VALUES FILE|own:FILE...
  echo "$1"
  shift
  for file; do
    case $file in
      --) break ;;
      own:*) stat -Lc '%s %Y' "${file#own:}" ;;
      *) cat ".chain/$file.sha256" "${MODEL_OF:-.}/.chain/$file.sha256" ;;
    esac
  done 2> /dev/null
}

# Prints "yes" if FILE was made of these values and files, as they are now.
is_made_of() { # FILE VALUES FILE...
  note=.chain/${1##*/}.made_of
  shift
  made_of "$@" | cmp -s - "$note" && echo yes
}

# Prints "up" and "down" if [postprocess] asks for this case's own sweep, "other" for each sweep in a file of the user's.
name_sweeps() { # CASE OPTION...
  tiprub-postprocess "$@" --tables 2> /dev/null | sed -nE \
    -e 's/^response_(up|down) = "response_\1\.h5"$/\1/p; t' -e 's/^response_(up|down) = "[^"].*/other/p'
}

# Prints the file that error budgets compare with, if there is one.
name_budget_model() { # CASE OPTION...
  model=$(tiprub-simulate "$@" --tables 2> /dev/null | sed -nE 's/^budget_model = "(.+)"$/\1/p')
  case $model in /*) ;; *) model=$(dirname "$1")/$model ;; esac
  if test -f "$model"; then echo "$model"; fi
}

# Prints the full fields of that model, if make made both there.
name_budget_fields() { # CASE OPTION...
  model=$(name_budget_model "$@")
  fields=${model%model.h5}fields.h5
  if test "$fields" != "${model}fields.h5" && test -f "$fields"; then echo "$fields"; fi
}

is_linked() { # FILE
  test -n "$MODEL_OF" && test "$(readlink "$1")" = "$MODEL_OF/$1"
}

is_made() { # FILE
  is_linked "$1" || sha256sum --status -c ".chain/$1.sha256" 2> /dev/null
}

# Prints those of the files that exist and that make has no digest of. They are not read, because make asks whenever it starts.
name_others() { # FILE...
  settle
  for file; do
    if test -e "$file" && ! test -e ".chain/$file.sha256" && ! is_linked "$file"; then echo "$file"; fi
  done
}

# Fails at the first file that make did not make. The others are about to be made anew.
require_own() { # FILE...
  mkdir -p .chain
  for file; do
    test ! -e "$file" || is_made "$file" || { echo "$file: $(hint)" >&2; exit 1; }
  done
}

# Fails if FILE, which a rule of the case's own Makefile would make of SOURCE, is the user's.
require_made() { # FILE SOURCE
  mkdir -p .chain
  test ! -e "$1" || is_made "$1" || { echo "$1: make did not make it, and does not overwrite it; to use it, remove $2" >&2; exit 1; }
}

hint() {
  echo "make did not make it, and does not overwrite it; move it away, or name your own files as MESH and MODEL in the Makefile"
}

# Runs the command of a stage, which may leave out some of the files, and notes what it has made, even if a signal ends it.
run() { # 'FILE...' VALUES FILE... -- COMMAND...
  files=$1
  shift
  require_own $files
  made=$(made_of "$@")
  for file in $files; do echo "$made" > ".chain/$file.begun"; done
  set_back ".chain/${files%% *}.begun"
  while test "$1" != --; do shift; done
  shift
  show "$@"
  trap : INT HUP                            # the terminal sends these to the program, too,
  trap 'kill $! 2> /dev/null' TERM          # and make sends this to its child only
  env --default-signal=INT,QUIT "$@" &      # which a shell has ignored in the background
  while wait $!; code=$?; kill -0 $! 2> /dev/null; do :; done
  trap '' INT HUP TERM
  if test $code = 0; then
    for file in $files; do keep "$file" "$made"; done
  else
    settle
    for file in $files; do rm -f ".chain/$file.begun"; done
  fi
  return $code
}

# Prints a command as one may type it.
show() { # WORD...
  line=
  for word; do
    case $word in
      '' | *[!A-Za-z0-9_./:=,+-]*) word="'$(printf %s "$word" | sed "s/'/'\\\\''/g")'" ;;
    esac
    line="$line $word"
  done
  printf '%s\n' "${line# }"
}

# Notes the digest of a file that was made, and what it was made of.
keep() { # FILE MADE_OF
  noted=.chain/${1##*/}
  if test -e "$1"; then sha256sum "$1" > "$noted.sha256" && echo "$2" > "$noted.made_of"; fi && rm -f "$noted.begun"
}

# Does so for what a run has made that was ended or killed.
settle() {
  for mark in .chain/*.begun; do
    file=$(basename "$mark" .begun)
    if test -e "$mark" && test "$file" -nt "$mark"; then keep "$file" "$(cat "$mark")"; fi
  done
}

note() { # FILE VALUES FILE...
  keep "$1" "$(shift; made_of "$@")"
  set_back "$1"
}

# Gives the date of a file that was just made to make's own files that are dated ahead of it, by another clock or one that was
# set back. Otherwise make would make it again and again.
set_back() { # FILE
  for file in $from_other_case response.h5 response_up.h5 response_down.h5; do
    test ! -e ".chain/$file.sha256" || test -L "$file" || test ! "$file" -nt "$1" || touch -r "$1" "$file"
  done
}

# Removes what make has made. The user's own files stay, even if they have the same names.
clean() { # OWN_FILE...
  settle
  for file in $MADE $from_other_case $(for sweep in $sweeps; do for more in '' $responses; do echo "$sweep$more.h5"; done; done); do
    for own; do test "$own" != "$file" || continue 2; done
    if is_made "$file"; then
      rm -f "$file"
    elif test -e "$file"; then
      echo "$file: kept; make did not make it"
    fi
  done
  clean_report
  for sweep in $sweeps; do for more in '' $responses; do rm -rf "$sweep$more.h5.speeds"; done; done
  rm -rf .chain report.tiprub.part ./*.tiprub.part.*
}

# tiprub-postprocess leaves a list of its files in the report. Other files in that folder stay.
clean_report() {
  test -f report/.tiprub-files || return 0
  (
    cd report && find . ! -type d -printf '%P\0' | grep -zFxf .tiprub-files | xargs -0r rm -f -- && rm .tiprub-files
  ) && find report -depth -type d -empty -delete
}

"$@"
