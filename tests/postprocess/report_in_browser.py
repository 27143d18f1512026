#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's page in headless Chromium: pictures load, a click enlarges one, tables can be copied, the first is seen whole,
nothing comes from a network.

usage: report_in_browser.py PROGRAM SCENE_WRITER WORK_FOLDER
Exit code 77 (skipped) without Chromium.
"""
import json
import os
import re
import shutil
import subprocess
import sys

SKIPPED = 77
# Runs after the page's own script; leaves what it found in an attribute that the dump shows.
PROBE = """<script>
window.addEventListener('load', () => {
  const images = [...document.querySelectorAll('figure img')], tables = [...document.querySelectorAll('table')];
  images[0].click();
  const enlarged = images[0].parentElement.classList.contains('large');
  document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
  let copied = '';
  document.execCommand = () => { copied = document.querySelector('body > textarea').value; return true; };
  document.querySelector('button').click();
  document.body.dataset.found = JSON.stringify({
    images: images.length, loaded: images.filter(image => image.naturalWidth > 0).length,
    enlarged: enlarged, closed: !images[0].parentElement.classList.contains('large'),
    tables: tables.length, buttons: document.querySelectorAll('button').length,
    copied_rows: copied.split('\\n').length, first_rows: tables[0].rows.length, tabs: copied.includes('\\t'),
    outside: performance.getEntriesByType('resource').map(entry => entry.name).filter(name => !name.startsWith('data:')),
    cut: tables[0].parentElement.scrollWidth > tables[0].parentElement.clientWidth,
    wide: document.documentElement.scrollWidth > document.documentElement.clientWidth,
    summary_first: document.querySelector('.lead').compareDocumentPosition(images[0]) & Node.DOCUMENT_POSITION_FOLLOWING
  });
});
</script></body>"""


def main(program, writer, work):
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None:
        print("skipped: no Chromium on this machine")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    subprocess.run([writer, work], check=True, cwd=work)
    subprocess.run([program, "-q", "case.toml", "model.h5", "response.h5", "--fields", "fields.h5", "-o", "report"],
                   check=True, cwd=work, stdout=subprocess.DEVNULL)
    with open(os.path.join(work, "report", "report.html"), encoding="utf-8") as file:
        page = file.read()
    assert page.count("</body>") == 1
    probed = os.path.join(work, "report", "probed.html")
    with open(probed, "w", encoding="utf-8") as file:
        file.write(page.replace("</body>", PROBE))
    dump = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                           f"--user-data-dir={work}/profile", "--window-size=1280,900", "--virtual-time-budget=20000",
                           "--dump-dom", "file://" + probed], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          timeout=240).stdout
    match = re.search(r'data-found="([^"]*)"', dump)
    assert match, "the page's script did not run to its end"
    found = json.loads(match.group(1).replace("&quot;", '"'))
    print(found)
    assert found["images"] >= 23 and found["loaded"] == found["images"]
    assert found["enlarged"] and found["closed"]
    assert found["buttons"] == found["tables"] > 0
    assert found["copied_rows"] == found["first_rows"] and found["tabs"]
    assert found["outside"] == [] and not found["wide"] and not found["cut"] and found["summary_first"]
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:4])))
