#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""axe-core finds nothing serious in a report's page, by day and by night, on a wide and on a narrow screen.

usage: accessibility.py REPORT_PAGE CACHE_FOLDER
axe-core comes from npm, pinned by version and digest, once; it stays in the cache folder. Exit code 77 (skipped) without Chromium, and
without npm or its network where the cache is empty.
"""
import hashlib
import os
import shutil
import subprocess
import sys
import tarfile

import chromium

SKIPPED = 77
PACKAGE, DIGEST = "axe-core@4.14.1", (
    "1477dafa598d8d065f273d6af302aa203c02e83131707b7fa648cd41bd3d6b73"
    "4f8c22a0dab86ee6a6f64b8afbe804b214d36db85a2826965edfb3a0b9d546b5")
SERIOUS = ("serious", "critical")
RULES = "{rules: {'label-content-name-mismatch': {enabled: true}, 'target-size': {enabled: true}}}"  # beside those that are on by default
LIVE = "document.documentElement.classList.contains('live')"


def fetched(cache):
    """The package's file; None, and said so, where it can't be had."""
    os.makedirs(cache, exist_ok=True)
    path = os.path.join(cache, PACKAGE.replace("@", "-") + ".tgz")
    if not os.path.exists(path):
        if shutil.which("npm") is None:
            print(f"skipped: no npm on this machine to fetch {PACKAGE} with (apt-get install npm)")
            return None
        run = subprocess.run(["npm", "pack", PACKAGE, "--silent", "--fetch-retries=1", "--fetch-timeout=20000"], cwd=cache, timeout=120,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            print(f"skipped: npm could not fetch {PACKAGE}; is there no network? {run.stderr[-300:]}")
            return None
    with open(path, "rb") as file:
        found = hashlib.sha512(file.read()).hexdigest()
    assert found == DIGEST, f"{path}: not the file that was pinned; remove it, or look at where npm gets it from"
    return path


def script_of(path):
    with tarfile.open(path) as package:
        return package.extractfile("package/axe.min.js").read().decode()


def check(browser, page, axe):
    for width, scheme in ((1440, "light"), (1440, "dark"), (390, "light")):
        browser.size(width, 900, mobile=width < 600)
        browser.media("screen", scheme)
        browser.open(page)
        browser.wait(LIVE)
        browser.value("document.querySelector('#in-motion').scrollIntoView()")
        browser.wait("document.querySelector('canvas.wheel, #live-wheel img')")
        browser.value(axe + "; 0")
        passed, found = browser.value(f"axe.run({RULES}).then(found => [found.passes.length, found.violations.map(rule => [rule.impact, rule.id, "
                                      "rule.nodes.slice(0, 3).map(node => node.html.slice(0, 200) + ': ' + node.failureSummary)])])")
        print(f"{width} px, {scheme}: {passed} rules hold, {len(found)} don't", found)
        assert passed > 20 and not [rule for rule in found if rule[0] in SERIOUS], found


def main(page, cache):
    if chromium.installed() is None:
        print("skipped: no Chromium on this machine")
        return SKIPPED
    package = fetched(cache)
    if package is None:
        return SKIPPED
    with chromium.Chromium(cache) as browser:
        check(browser, page, script_of(package))
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:3])))
