#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders, files and functions stay small enough to read.   sizes.py ROOT"""
import ast
import collections
import os
import sys

import cpp_functions
import source_tree

FOLDER_FILES = 25
FILE_LINES = 400
SMALL_FILE_LINES = 100  # of half of the headers and their .cc
FUNCTION_LINES = 40


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno, f"def {node.name}"


def full_folders(paths):
    for folder, count in sorted(collections.Counter(os.path.dirname(path) for path in paths).items()):
        if count > FOLDER_FILES:
            yield f"{folder}: holds {count} files, at most {FOLDER_FILES}; give it storeys"


def long_files(texts):
    for path, text in texts.items():
        if text.count("\n") > FILE_LINES:
            yield f"{path}: has {text.count(chr(10))} lines, at most {FILE_LINES}"
    lengths = sorted(text.count("\n") for path, text in texts.items() if path.endswith((".h", ".cc")))
    if lengths[(len(lengths) - 1) // 2] >= SMALL_FILE_LINES:
        yield f"half of the headers and .cc files must have under {SMALL_FILE_LINES} lines, the median has {lengths[len(lengths) // 2]}"


def long_functions(texts):
    for path, text in texts.items():
        found = python_functions(text) if path.endswith(".py") else ()
        found = cpp_functions.functions(text) if path.endswith((".h", ".cc")) else found
        for first, last, signature in found:
            if last - first + 1 > FUNCTION_LINES:
                yield f"{path}:{first}: a function of {last - first + 1} lines, at most {FUNCTION_LINES}: {signature}"


def main(root):
    paths = source_tree.files(root)
    texts = {path: source_tree.read(root, path) for path in paths}
    source_tree.report([*full_folders(paths), *long_files(texts), *long_functions(texts)],
                       f"{len(paths)} files are of readable size")


if __name__ == "__main__":
    main(sys.argv[1])
