#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The marked numbers of the cases' pages and of the first page are those of their tables.

usage: pages.py ROOT
"""
import os
import subprocess
import sys

if __name__ == "__main__":
    sys.exit(subprocess.run([sys.executable, "-B", os.path.join(sys.argv[1], "cases", "fill_pages.py"), "--check"]).returncode)
