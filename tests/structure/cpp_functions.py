# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of a C++ file and their lengths, without a compiler: braces, and what stands before them."""
import re

NOT_CODE = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'', re.S)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
SCOPE = re.compile(r"\b(?:namespace|class|struct|union|extern)\b")
AFTER_PARAMETERS = re.compile(r"\)\s*(?:const|noexcept|override|final|mutable|&|\s)*(?:->[^{};=]+)?$")


def code_of(text):
    """The text with blanks for comments, literals and directives; lines stay where they are."""
    def blank(match):
        return "".join("\n" if letter == "\n" else " " for letter in match.group())

    return PREPROCESSOR.sub(blank, NOT_CODE.sub(blank, text))


def kind_of(head):
    """What a brace opens outside of functions: a scope, a function, or a value."""
    plain = re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", head))
    if "(" not in plain:
        return "scope" if SCOPE.search(plain) else "value"
    if "=" in re.sub(r"\([^()]*\)|operator\s*[<>=!+\-*/]=*", "", plain) and "](" not in plain.replace(" ", ""):
        return "value"
    if AFTER_PARAMETERS.search(plain):
        return "function"
    return "function" if re.search(r"\)\s*(?:noexcept)?\s*:[^:]", plain) and plain.rstrip()[-1] in ")}," else "value"


def functions(text):
    """(first line, last line, signature's start) of each function."""
    code, found, head_start = code_of(text), [], 0
    inside, depth, start = [], 0, None
    for at, letter in enumerate(code):
        if letter == "{":
            if start is None:
                head = code[head_start:at]
                kind = kind_of(head)
                if kind == "function":
                    start, depth = head_start + len(head) - len(head.lstrip()), len(inside)
                elif kind == "scope":
                    head_start = at + 1
            inside.append(letter)
        elif letter == "}":
            inside.pop()
            if start is not None and len(inside) == depth:
                first, last = code.count("\n", 0, start) + 1, code.count("\n", 0, at) + 1
                if not re.match(r"\s*[,{]", code[at + 1:at + 80]):  # or else a value in a constructor's list
                    found.append((first, last, text.split("\n")[first - 1].strip()))
                    head_start = at + 1
                start = None
            elif start is None and (SCOPE.search(code[head_start:at]) is None or ";" not in code[head_start:at]):
                head_start = at + 1 if not re.match(r"\s*[,{]", code[at + 1:at + 80]) else head_start
        elif start is None and letter == ";":
            head_start = at + 1
        elif start is None and letter == ":" and re.search(r"\b(?:public|private|protected)\s*$", code[head_start:at]):
            head_start = at + 1
    return found
