#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: chain.sh COMMAND ARGUMENT...: what chain.mk asks about the stages and the files of a case, in the case's folder.
#
# It takes from the environment
#   BIN       the folder of the programs
#   MODEL_OF  the folder of the case whose model this one links to; empty if there is none
# A case may come from anybody, and make runs what it finds in the text that it is given. Therefore no text of a case is
# printed here, but digests and fixed names only.
#
# Beside each file that make has made stands its digest, .chain/FILE.sha256. A file is make's own as long as its bytes have
# this digest, or if it is a link into MODEL_OF. Every other file is the user's: it is neither overwritten nor removed.
PATH=$BIN:$PATH
from_other_case='sector.msh model.h5 fields.h5'
sweeps='response response_up response_down'

# Prints the name of a stage's stamp, .chain/STAGE-DIGEST. The digest is that of all values that the stage reads of its
# case: a stage is up to date if there is a stamp of this name. A case that the stage refuses has the digest of nothing;
# write_stamp then shows what is wrong.
name_stamp() { # STAGE CASE OPTION...
  stage=$1
  shift
  digest=$("tiprub-$stage" "$@" --tables 2> /dev/null | sha256sum)
  echo ".chain/$stage-${digest%% *}"
}

# Puts a stage's stamp in the place of its former one.
write_stamp() { # STAMP CASE OPTION...
  stamp=$1
  stage=${stamp#.chain/}
  stage=${stage%%-*}
  shift
  mkdir -p .chain && rm -f ".chain/$stage"-* && "tiprub-$stage" "$@" --tables > "$stamp"
}

# Prints "up" and "down" if [postprocess] asks for this case's own sweep, "other" for each sweep in a file of the user's.
name_sweeps() { # CASE OPTION...
  tiprub-postprocess "$@" --tables 2> /dev/null | sed -nE \
    -e 's/^response_(up|down) = "response_\1\.h5"$/\1/p; t' -e 's/^response_(up|down) = "[^"].*/other/p'
}

is_linked() { # FILE
  test -n "$MODEL_OF" && test "$(readlink "$1")" = "$MODEL_OF/$1"
}

is_made() { # FILE
  is_linked "$1" || sha256sum --status -c ".chain/$1.sha256" 2> /dev/null
}

# Prints those files that stand there and that make has no note of. They are not read: this is asked whenever make starts.
name_others() { # FILE...
  for file; do
    if test -e "$file" && ! test -e ".chain/$file.sha256" && ! is_linked "$file"; then echo "$file"; fi
  done
}

# Fails at the first file that make did not make.
require_own() { # FILE...
  for file; do
    test ! -e "$file" || is_made "$file" || { echo "$file: $(hint)" >&2; exit 1; }
  done
}

hint() {
  echo "make did not make it, and does not overwrite it; move it away, or name your own files as MESH and MODEL in the Makefile"
}

# Notes that make has made these files. A stage may leave one out.
note() { # FILE...
  for file; do
    test ! -e "$file" || sha256sum "$file" > ".chain/$file.sha256"
  done
}

# Removes what make has made, except for the user's own files, which may bear the same names.
clean() { # OWN_FILE...
  for file in $from_other_case $(for sweep in $sweeps; do echo "$sweep.h5 ${sweep}_full.h5"; done); do
    for own; do test "$own" != "$file" || continue 2; done
    if is_made "$file"; then
      rm -f "$file"
    elif test -e "$file"; then
      echo "$file: kept; make did not make it"
    fi
  done
  clean_report
  for sweep in $sweeps; do rm -rf "$sweep.h5.speeds" "${sweep}_full.h5.speeds"; done
  rm -rf .chain report.tiprub.part ./*.tiprub.part.*
}

# tiprub-postprocess leaves in its report the list of the files that it wrote; others stay.
clean_report() {
  test -f report/.tiprub-files || return 0
  (
    cd report && find . ! -type d -printf '%P\0' | grep -zFxf .tiprub-files | xargs -0r rm -f -- && rm .tiprub-files
  ) && find report -depth -type d -empty -delete
}

"$@"
