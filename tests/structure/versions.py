#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One version everywhere: CMake's project, the newest release of the changelog, the citation, the README, the Python package.

usage: versions.py ROOT
"""
import re
import sys

import source_tree

PLACES = (("CMakeLists.txt", r"^project\(tiprub VERSION ([\d.]+)"), (".github/CHANGELOG.md", r"^## (\d[\d.]*)"),
          (".github/CITATION.cff", r"^version: ([\d.]+)$"), ("README.md", r"latest release is\s+(\d+\.\d+\.\d+)"),
          ("postprocess/python/tiprub/__init__.py", r'^__version__ = "([\d.]+)"$'))


def main(root):
    found = {}
    for path, pattern in PLACES:
        version = re.search(pattern, source_tree.read(root, path), re.M)
        found[path] = version[1] if version else "none"
    said = next(iter(found.values()))
    faults = [f"{path}: says version {version}, {PLACES[0][0]} says {said}" for path, version in found.items() if version != said]
    source_tree.report(faults, f"all say version {said}")


if __name__ == "__main__":
    main(sys.argv[1])
