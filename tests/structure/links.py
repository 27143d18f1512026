#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""No link of a page is dead, none of a case leads to the tests, which are not installed with it, and each message in
cases/troubleshooting.md is one that a program gives.

usage: links.py ROOT
"""
import os
import re
import sys

import source_tree

SKIPPED = {".git", "node_modules"}


def pages(root):
    for folder, inner, names in os.walk(root):
        inner[:] = [name for name in inner if name not in SKIPPED and not name.startswith("build")]
        yield from (os.path.relpath(os.path.join(folder, name), root) for name in names if name.endswith(".md"))


def anchors(text):
    """Of the headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(root, page):
    text = source_tree.read(root, page)
    for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"```.*?```", "", text, flags=re.S)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not os.path.exists(os.path.join(root, there)):
            yield f"{page}: {target} leads to no file"
        elif page.startswith("cases/") and there.startswith("tests/"):
            yield f"{page}: {target} leads to the tests, which are not installed with the cases"
        elif anchor and anchor not in anchors(source_tree.read(root, there)):
            yield f"{page}: {target} leads to no heading of {there}"


def unknown_messages(root):
    sources = [source_tree.read(root, path) for path in source_tree.files(root, source_tree.ROOMS)]
    said = re.sub(r'"\s*\n\s*"', "", "\n".join(sources))
    page = "cases/troubleshooting.md"
    for message in re.findall(r"^\| `(.*?)` \|", source_tree.read(root, page), re.M):
        if message not in said:
            yield f"{page}: no program says {message!r}"


def main(root):
    found = sorted(pages(root))
    faults = [fault for page in found for fault in dead_links(root, page)]
    source_tree.report([*faults, *unknown_messages(root)], f"the links of {len(found)} pages lead somewhere")


if __name__ == "__main__":
    main(sys.argv[1])
