#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's page in headless Chromium: the first screen of 1440 x 900 holds verdict, scene and response; pictures load, a click
enlarges one, tables can be copied and are seen whole, on the screen and on paper; nothing comes from a network.

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
WIDTH, HEIGHT = 1440, 900
PAPER_WIDTH, PAPER_HEIGHT = 277 / 25.4 * 96, 190 / 25.4 * 96  # px: A4 on its side, margins of 10 mm
# Runs after the page's own script; leaves what it found in an attribute that the dump shows.
PROBE = """<script>
window.addEventListener('load', () => {
  const images = [...document.querySelectorAll('figure img')], tables = [...document.querySelectorAll('table')];
  const shown = tables.filter(table => !table.closest('details'));
  const bottom = element => element.getBoundingClientRect().bottom + window.scrollY;
  const found = {
    images: images.length, loaded: images.filter(image => image.naturalWidth > 0).length,
    first_screen: [document.querySelector('.lead'), document.querySelector('#brief'), images[0]].map(bottom),
    first_image: images[0].alt, verdict: document.querySelector('.lead').textContent,
    scene: document.querySelector('#brief').textContent,
    cut: shown.filter(table => table.parentElement.scrollWidth > table.parentElement.clientWidth).length,
    wide: document.documentElement.scrollWidth > document.documentElement.clientWidth,
    tables: tables.length, buttons: document.querySelectorAll('button').length, first_rows: tables[0].rows.length,
    outside: performance.getEntriesByType('resource').map(entry => entry.name).filter(name => !name.startsWith('data:')),
  };
  images[0].click();
  found.enlarged = images[0].parentElement.classList.contains('large');
  document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
  found.closed = !images[0].parentElement.classList.contains('large');
  let copied = '';
  document.execCommand = () => { copied = document.querySelector('body > textarea').value; return true; };
  document.querySelector('button').click();
  found.copied_rows = copied.split('\\n').length;
  found.tabs = copied.includes('\\t');
  for (const rule of document.styleSheets[0].cssRules)  // as on paper
    if (rule.media && rule.media.mediaText === 'print') rule.media.mediaText = 'all';
  document.body.style.width = 'PAPER_WIDTHpx';
  found.right_ends = shown.map(table => table.getBoundingClientRect().right);
  found.columns = shown.flatMap(table => [...table.rows[0].cells].map(cell => cell.textContent));
  const sections = images.map(image => image.closest('section'));
  found.headed = sections.filter(section => section && section.querySelector('h2')).length;
  found.torn = sections.filter(section => getComputedStyle(section).breakInside !== 'avoid').length;
  found.tallest = Math.max(...sections.map(section => section.getBoundingClientRect().height));
  document.body.dataset.found = JSON.stringify(found);
});
</script></body>""".replace("PAPER_WIDTH", f"{PAPER_WIDTH:.0f}")


def run_browser(browser, work, *arguments):
    return subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                           f"--user-data-dir={work}/profile", f"--window-size={WIDTH},{HEIGHT}",
                           "--virtual-time-budget=20000", *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True, timeout=240).stdout


def check_screen(found):
    assert found["images"] >= 23 and found["loaded"] == found["images"]
    assert found["enlarged"] and found["closed"]
    assert found["buttons"] == found["tables"] > 0
    assert found["copied_rows"] == found["first_rows"] and found["tabs"]
    assert found["outside"] == [] and not found["wide"] and found["cut"] == 0
    assert found["first_image"] == "Response" and max(found["first_screen"]) <= HEIGHT, found["first_screen"]
    for question in ("How bad", "Where", "Why", "Margin", "Trust"):
        assert question in found["verdict"], question
    for word in ("lobe", "clearance", "Interference", "Damping", "Speeds"):
        assert word in found["scene"], word


def check_paper(browser, work, page, found):
    """Columns by layout, and by what a reader of the PDF finds, where there is one."""
    assert max(found["right_ends"]) <= PAPER_WIDTH + 1, found["right_ends"]
    assert found["headed"] == found["images"] and found["torn"] == 0 and found["tallest"] <= PAPER_HEIGHT, found["tallest"]
    paper = os.path.join(work, "report.pdf")
    run_browser(browser, work, "--no-pdf-header-footer", f"--print-to-pdf={paper}", "file://" + page)
    with open(paper, "rb") as file:
        assert file.read(5) == b"%PDF-"
    if shutil.which("pdftotext"):
        text = subprocess.run(["pdftotext", "-layout", paper, "-"], stdout=subprocess.PIPE, text=True, check=True).stdout
        missing = {word for column in found["columns"] for word in column.split() if word not in text}
        assert not missing, missing


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
    written = os.path.join(work, "report", "report.html")
    with open(written, encoding="utf-8") as file:
        page = file.read()
    assert page.count("</body>") == 1
    probed = os.path.join(work, "report", "probed.html")
    with open(probed, "w", encoding="utf-8") as file:
        file.write(page.replace("</body>", PROBE))
    match = re.search(r'data-found="([^"]*)"', run_browser(browser, work, "--dump-dom", "file://" + probed))
    assert match, "the page's script did not run to its end"
    found = json.loads(match.group(1).replace("&quot;", '"').replace("&amp;", "&"))
    print(found)
    check_screen(found)
    check_paper(browser, work, written, found)
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:4])))
