#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Stops the reduction with SIGTERM in the middle of its work: nothing of a model may stay behind.
# usage: interrupted.sh MESHER PROGRAM CASE FOLDER
mesher=$1 program=$2 case=$3 folder=$4
rm -rf "$folder" && mkdir -p "$folder" && "$mesher" -q "$case" -o "$folder/sector.msh" || exit 1
"$program" -q "$case" "$folder/sector.msh" -o "$folder/model.h5" &
reducer=$!
# Loading and reading take a third of a second of CPU time, the reduction many.
ticks=$(($(getconf CLK_TCK) * 6 / 10))
while kill -0 $reducer 2>/dev/null; do
  set -- $(cat /proc/$reducer/stat 2>/dev/null)
  [ "${14:-0}" -ge $ticks ] && break
  sleep 0.05
done
kill -TERM $reducer || { echo "the run ended before the signal" >&2; exit 1; }
wait $reducer
code=$?
left=$(ls "$folder")
[ $code -eq 143 ] && [ "$left" = sector.msh ] && exit 0
echo "exit code $code, left behind: $left" >&2
exit 1
