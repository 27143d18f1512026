#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Only tiprub-reduce loads deal.II: the other programs start in milliseconds. No program loads a library that it does not use.

usage: libraries.py FOLDER_OF_THE_PROGRAMS
"""
import os
import subprocess
import sys

import source_tree

LIBRARY = "libdeal.ii"
LOADS_IT = {"tiprub-mesh": False, "tiprub-reduce": True, "tiprub-simulate": False, "tiprub-postprocess": False}


def main(folder):
    faults = []
    for program, wanted in LOADS_IT.items():
        loaded = subprocess.run(["ldd", os.path.join(folder, program)], stdout=subprocess.PIPE, text=True, check=True).stdout
        if (LIBRARY in loaded) != wanted:
            faults.append(f"{program}: {'does not load' if wanted else 'loads'} {LIBRARY}")
        unused = subprocess.run(["ldd", "-u", os.path.join(folder, program)], stdout=subprocess.PIPE, text=True, check=False).stdout
        faults += [f"{program}: uses nothing of {line.strip()}" for line in unused.splitlines() if line.startswith("\t")]
    source_tree.report(faults, f"of the programs, tiprub-reduce loads {LIBRARY}")


if __name__ == "__main__":
    main(sys.argv[1])
