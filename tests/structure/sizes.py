#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and functions stay small enough to read.   sizes.py ROOT"""
import ast
import sys

import cpp_functions
import source_tree

FILE_LINES = 400
FUNCTION_LINES = 40


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno, f"def {node.name}"


def long_files(texts):
    for path, text in texts.items():
        if text.count("\n") > FILE_LINES:
            yield f"{path}: has {text.count(chr(10))} lines, at most {FILE_LINES}"


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
    source_tree.report([*long_files(texts), *long_functions(texts)],
                       f"{len(paths)} files are of readable size")


if __name__ == "__main__":
    main(sys.argv[1])
