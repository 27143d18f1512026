#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# msh 2.2 repeats an element for each of its groups. Taken as elements of their own, blades with a name were twice as
# stiff and heavy as a disc without one, and nothing was said. A sector must give the same bytes in all formats.
# usage: formats.sh MESHER CONVERTER PROGRAM CASE FOLDER
mesher=$1 convert=$2 program=$3 case=$4 folder=$5
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" && "$mesher" -q "$case" -o all.msh || exit 1
# Takes the group of a volume, its number, out of a file that has so many names then.
without() {
  sed -e "/^3 $1 \"/d" -e "s/ 2 1 $1 0 \$/ 1 1 0 /" -e "/^.PhysicalNames/{n;s/.*/$2/;}"
}
without 2 8 <all.msh >blade.msh
without 3 7 <blade.msh >none.msh
for named in all blade none; do
  "$program" -q "$case" $named.msh --modes modes.h5 >expected || exit 1
  for format in "2.2 text" "2.2 binary" "4.0 text" "4.1 binary"; do
    "$convert" $named.msh $format copy.msh || exit 1
    "$program" -q "$case" copy.msh --modes modes.h5 >copied || exit 1
    cmp expected copied || { echo "msh $format, named parts: $named" >&2; exit 1; }
  done
done
