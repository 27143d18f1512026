#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Processes that share the nodal diameters write the same bytes as one, and end together.
# usage: processes.sh MPIRUN MESHER PROGRAM CASE FOLDER PROCESSES...; or, with "killed" in place of the numbers: one of two is killed.
mpirun="$1 --oversubscribe" mesher=$2 program=$3 case=$4 folder=$5
shift 5
[ "$(id -u)" -eq 0 ] && mpirun="$mpirun --allow-run-as-root"
fail() { echo "$1" >&2; exit 1; }
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" && "$mesher" -q "$case" -o sector.msh || exit 1

if [ "$1" = killed ]; then
  $mpirun -n 2 "$program" -q "$case" sector.msh -o model.h5 --fields fields.h5 2>log &
  launcher=$!
  victim=
  # Loading and reading take a third of a second of CPU time, the reduction many.
  ticks=$(($(getconf CLK_TCK) * 6 / 10))
  while kill -0 $launcher 2>/dev/null; do
    for process in $(pgrep -P $launcher); do
      used=$(cut -d ' ' -f 14 /proc/$process/stat 2>/dev/null)
      tr '\0' '\n' </proc/$process/environ 2>/dev/null | grep -q '^OMPI_COMM_WORLD_RANK=1$' &&
        [ "${used:-0}" -ge $ticks ] && victim=$process
    done
    [ -n "$victim" ] && break
    sleep 0.05
  done
  kill -KILL "$victim" || fail "the run ended before the signal"
  wait $launcher && fail "no failure after a process was killed"
  [ "$(ls)" = "$(printf 'log\nsector.msh')" ] || fail "left behind: $(ls -A)"
  exit 0
fi

for factorization in cholmod mumps; do
  by="--set reduce.factorization=\"$factorization\""
  "$program" -q "$case" sector.msh -o one.h5 --fields one_fields.h5 $by || exit 1
  for processes in "$@"; do
    $mpirun -n "$processes" "$program" "$case" sector.msh -o some.h5 --fields some_fields.h5 $by 2>log || fail "$(cat log)"
    [ "$(grep -c 'sectors of' log)" -eq 1 ] || fail "not one summary: $(cat log)"
    cmp one.h5 some.h5 && cmp one_fields.h5 some_fields.h5 || fail "$processes processes make another model by $factorization"
  done
done
$mpirun -n 2 "$program" "$case" nothing.msh -o none.h5 2>log && fail "no failure without a mesh"
[ "$(grep -c '^tiprub-reduce: error: ' log)" -eq 1 ] || fail "not one message: $(cat log)"
[ ! -e none.h5 ] || fail "a model without a mesh"
