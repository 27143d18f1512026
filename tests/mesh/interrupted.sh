#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Stops the mesher with SIGTERM while its scratch file is there: nothing may stay behind. Writing takes a moment only,
# so a run may end before the signal reaches it; then it is tried again.
# usage: interrupted.sh PROGRAM CASE FOLDER
program=$1 case=$2 folder=$3
for attempt in 1 2 3 4 5 6 7 8 9 10; do
  rm -rf "$folder" && mkdir -p "$folder" || exit 1
  "$program" -q "$case" -o "$folder/sector.msh" &
  mesher=$!
  while kill -0 $mesher 2>/dev/null && [ ! -e "$folder/sector.tiprub.part.msh" ]; do :; done
  kill -TERM $mesher 2>/dev/null
  wait $mesher
  code=$?
  if [ $code -eq 143 ]; then
    left=$(ls "$folder")
    [ -z "$left" ] && exit 0
    echo "exit code $code, but left behind: $left" >&2
    exit 1
  fi
done
echo "the signal never arrived in time; last exit code $code" >&2
exit 1
