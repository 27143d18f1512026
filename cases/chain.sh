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

# The user's own files have no digests here: make looks at their age.
made_of() { # VALUES FILE...
  echo "$1"
  shift
  for file; do cat ".chain/$file.sha256" "${MODEL_OF:-.}/.chain/$file.sha256" 2> /dev/null; done
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
  model=$(dirname "$1")/$(tiprub-simulate "$@" --tables 2> /dev/null | sed -nE 's/^budget_model = "(.+)"$/\1/p')
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

# Notes the digests of files that a stage has made, of which it may have left some out, and what the first was made of.
note() { # 'FILE...' VALUES FILE...
  for file in $1; do
    test ! -e "$file" || sha256sum "$file" > ".chain/${file##*/}.sha256"
  done
  made=${1%% *}
  shift
  made_of "$@" > ".chain/${made##*/}.made_of"
  set_back "$made"
}

# Gives the date of the file that was just made to make's own files that are dated ahead of it, by another clock or one that was
# set back. Otherwise make would make it again and again.
set_back() { # FILE
  for file in $from_other_case response.h5 response_up.h5 response_down.h5; do
    test ! -e ".chain/$file.sha256" || test -L "$file" || test ! "$file" -nt "$1" || touch -r "$1" "$file"
  done
}

# Removes what make has made. The user's own files stay, even if they have the same names.
clean() { # OWN_FILE...
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
