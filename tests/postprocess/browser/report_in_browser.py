#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's page in headless Chromium: the first screen of 1440 x 900 holds verdict, scene and response; a click on a peak
changes all views to that speed, the wheel moves, values under the pointer are the tables'; pictures load, one is enlarged, tables are copied and
seen whole, on the screen, on a telephone and on paper; without scripts pictures and tables are there; nothing comes from a network,
and nothing complains.

usage: report_in_browser.py PROGRAM SCENE_WRITER WORK_FOLDER
Exit code 77 (skipped) without Chromium.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import time

import chromium
from shown_page import HEIGHT, VIEWS, WIDTH, click_peak, opened, rows_of, shown
from speed_checks import check_any_speed, check_bands, check_honest_wheel, check_names, check_saved_views, check_shared_speeds

SKIPPED = 77
PAPER_WIDTH, PAPER_HEIGHT = 277 / 25.4 * 96, 188 / 25.4 * 96  # px: A4 on its side, margins of 10 mm, 12 mm at the foot


def check_opening(browser, page):
    """In less than 2 s, once; what else the machine does may hold it up before."""
    seconds = []
    while not seconds or min(seconds) >= 2 and len(seconds) < 10:
        seconds.append(opened(browser, page))
    print("opened in", ", ".join(f"{s:.2f} s" for s in seconds))
    assert min(seconds) < 2, seconds


def check_first_screen(browser):
    bottoms = browser.value("['.decision table', '.lead'].map(name => "
                            "document.querySelector(name).getBoundingClientRect().bottom)")
    assert bottoms[0] < bottoms[1] <= HEIGHT, bottoms
    lead, scene = (browser.value(f"document.querySelector('{name}').textContent") for name in (".lead", "#brief"))
    for question in ("How bad", "Where", "Why", "Margin", "Trust"):
        assert question in lead, question
    for word in ("lobe", "clearance", "Interference", "Damping", "Speeds"):
        assert word in scene, word


def check_peaks(browser, report):
    """A click on each critical speed: all views are of that speed."""
    for number, peak in enumerate(rows_of(os.path.join(report, "critical_speeds.csv"))):
        before = browser.value(VIEWS + ".map(view => view.innerHTML)")
        click_peak(browser, number)
        assert shown(browser).startswith(f"{float(peak['speed [rpm]']):.0f} rpm, critical: {peak['wave']}"), (shown(browser), peak)
        after = browser.value(VIEWS + ".map(view => view.innerHTML)")
        assert number == 0 or all(a != b for a, b in zip(before, after)), [a != b for a, b in zip(before, after)]


def readout(browser, view, across, up):
    """What is told above view `view` at shares of its width and height."""
    x, y = browser.value(f"(() => {{ const view = {VIEWS}[{view}]; view.scrollIntoView({{block: 'center'}});"
                         "const box = view.querySelector('.frame').getBoundingClientRect();"
                         f"return [box.left + {across} * box.width, box.bottom - {up} * box.height]; }})()")
    browser.hover(x, y)
    return browser.value(f"{VIEWS}[{view}].previousSibling.querySelector('output').textContent")


def check_values(browser, report):
    """Under the pointer: the maps' tables, in total and of one nodal diameter."""
    for view, edge in ((1, "leading"), (2, "trailing")):
        rows = rows_of(os.path.join(report, "figures", f"interaction_map_{edge}_edge.csv"))
        for part, column in (("total", "total [mm]"), ("4", "nodal diameter 4 [mm]")):
            browser.value("(() => { const choice = document.querySelector('select[aria-label=\"Nodal diameters\"]');"
                          f"choice.value = '{part}'; choice.dispatchEvent(new Event('change')); }})()")
            for across, up in ((0.3, 0.3), (0.6, 0.5), (0.8, 0.7)):
                told = readout(browser, view, across, up)
                rpm, order, value = (float(found) for found in re.fullmatch(r"(\S+) rpm, \S+ Hz \(EO (\S+)\): (\S+) mm", told).groups())
                row = min(rows, key=lambda row: (abs(float(row["speed [rpm]"]) - rpm), abs(float(row["engine order"]) - order)))
                assert abs(float(row[column]) - value) <= 6e-4 * value + 1e-12, (told, row)
    assert re.fullmatch(r"\d+ rpm: \S+ mm; .*", readout(browser, 0, 0.5, 0.5))
    assert "sector" in readout(browser, 3, 0.5, 0.5) and "EO" in readout(browser, 5, 0.5, 0.5)


def check_zoom_and_keys(browser):
    ticks = "document.querySelector('#live-response svg .axes').textContent"
    whole = browser.value(ticks)
    browser.value("document.querySelector('button[aria-label=\"Tip amplitude over speed: zoom in\"]').click()")
    assert browser.value(ticks) != whole
    browser.value("document.querySelector('button[aria-label=\"Whole: Tip amplitude over speed: show all of it\"]').click()")
    assert browser.value(ticks) == whole
    before = shown(browser)
    x, y = browser.value("(box => [box.left + 0.3 * box.width, box.top + 60])(document.querySelector('#live-response svg').getBoundingClientRect())")
    for count in (1, 2):
        browser.click(x, y, count)
    time.sleep(0.4)
    assert shown(browser) == before, "a double-click chose a speed"
    browser.value("document.querySelector('#live-response svg').focus()")
    browser.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowRight")
    assert shown(browser) != before
    edge = browser.value(VIEWS + "[3].innerHTML")
    browser.value("(() => { const edge = document.querySelector('select[aria-label=\"Edge\"]'); edge.value = 'trailing';"
                  "edge.dispatchEvent(new Event('change')); })()")
    assert browser.value(VIEWS + "[3].innerHTML") != edge


def check_columns(browser):
    """The keyboard and the pointer learn at a column's head what it means; paper has the list."""
    heads = browser.value("[...document.querySelectorAll('.decision th[scope=col], #critical ~ div th[scope=col]')].map(head => "
                          "[head.textContent, head.dataset.help ?? ''])")
    assert len(heads) > 20 and all(len(help) > 20 for _, help in heads), [name for name, help in heads if not help]
    seen = browser.value("""(() => { const head = document.querySelector('.decision th button.help'), note = document.querySelector('#column-help');
      const told = [note.hidden]; head.dispatchEvent(new FocusEvent('focus')); told.push(note.hidden, note.textContent === head.parentElement.dataset.help);
      document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'})); told.push(note.hidden); return told; })()""")
    assert seen == [True, False, True, True], seen


def check_stress(browser, report):
    """The curve has what speeds.csv has; at a speed that is not critical the number stands in words."""
    told = browser.value("(() => { const view = document.querySelector('svg.stress'); return [view.querySelector('path.stress').getAttribute('d').split(/[ML]/).length - 1,"
                         "view.querySelectorAll('circle.recovered').length]; })()")
    rows = [row for row in rows_of(os.path.join(report, "speeds.csv")) if not row["failure"]]
    assert told == [len(rows), len(rows_of(os.path.join(report, "critical_speeds.csv")))], told
    lines = browser.value("[...document.querySelectorAll('svg.stress path.limit')].map(line => line.getBoundingClientRect().top)")
    assert len(lines) == 2 and len(set(lines)) == 2, lines  # Goodman's, yield strength
    row = rows[2]
    browser.value("(typed => { typed.value = '%s'; typed.dispatchEvent(new Event('change')); })(document.querySelector('input.typed'))" % row["speed [rpm]"])
    words = browser.value("document.querySelector('#shown-answers').textContent")
    estimated = float(re.search(r"about (\S+) MPa", words)[1])
    assert abs(estimated - float(row["von Mises, vibration, estimated [MPa]"])) <= 0.06 * estimated, (words, row)


def check_instant(browser):
    """One instant in all views: the slider moves the cursors of motion, force, contact and path, and a click in the motion moves the slider."""
    places = "[...document.querySelectorAll('svg.chart .now')].map(mark => mark.getAttribute('x1') ?? mark.getAttribute('cx'))"
    before = browser.value(places)
    browser.value("(slider => { slider.value = Math.round(slider.max / 3); slider.dispatchEvent(new Event('input')); })"
                  "(document.querySelector('input[aria-label=\"Rotor angle\"]'))")
    after = browser.value(places)
    assert len(before) == len(after) == 4 and all(a != b for a, b in zip(before, after)), (before, after)
    x, y = browser.value(f"(view => {{ view.scrollIntoView({{block: 'center'}}); const box = view.querySelector('.frame').getBoundingClientRect();"
                         f"return [box.left + box.width / 2, box.top + box.height / 2]; }})({VIEWS}[3])")
    browser.click(x, y)
    time.sleep(0.4)
    share = browser.value("(slider => slider.value / slider.max)(document.querySelector('input[aria-label=\"Rotor angle\"]'))")
    assert abs(share - 0.5) < 0.01 and "sector 0" in browser.value("document.querySelector('#at-instant').textContent"), share


def check_pictures_and_tables(browser, report):
    images, loaded = browser.value("(images => [images.length, images.filter(i => i.naturalWidth > 0).length])([...document.images])")
    assert images >= 19 and loaded == images, (images, loaded)
    assert browser.value("[...document.images].every(image => image.alt.length > 30)")
    made = browser.value("document.querySelector('#run').textContent")
    assert re.search(r"tiprub-postprocess \d.*case.toml of \d{4}-\d\d-\d\d.*pictures and tables [\d.]+ s; at most \d+.\d\d GB of memory", made, re.S), made
    with open(os.path.join(report, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    assert [peak["speed [rpm]"] for peak in summary["critical_speeds"]] and summary["verdict"]["How bad"] in browser.value(
        "document.querySelector('.lead').textContent")
    assert browser.value("[...document.querySelectorAll('th')].every(cell => cell.scope)")
    waves = browser.value("(rows => { const column = [...rows[0].cells].findIndex(cell => cell.textContent === 'wave');"
                          "return rows.slice(1).map(row => row.cells[column].textContent); })([...document.querySelectorAll('#critical ~ div table')[0].rows])")
    assert waves == [row["wave"] for row in rows_of(os.path.join(report, "critical_speeds.csv"))], waves
    figure = "document.querySelectorAll('figure')[1]"
    browser.value(f"{figure}.querySelector('button').click()")
    assert browser.value(f"{figure}.classList.contains('large')")
    browser.value("document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}))")
    assert not browser.value(f"{figure}.classList.contains('large')")
    assert browser.value("document.querySelectorAll('button.copy').length == 2 * document.querySelectorAll('table').length")
    dead = browser.value("[...document.querySelectorAll('a[href]')].map(a => a.getAttribute('href')).filter(to => !/^(#|data:)/.test(to))")
    assert dead == [], dead
    copied = browser.value("(() => { let copied; document.execCommand = () => { copied = document.querySelector('body > textarea').value;"
                           "return true; }; document.querySelector('button.copy').click(); return copied; })()")
    assert copied.count("\n") + 1 == browser.value("document.querySelector('table').rows.length") and "\t" in copied
    assert browser.value("[...document.querySelectorAll('.scroll')].every(box => box.closest('details') || box.scrollWidth <= box.clientWidth)")


def check_sizes(browser, page):
    """Nothing wider than the window, by day and by night."""
    for width, scheme in ((390, "light"), (390, "dark"), (1024, "dark"), (WIDTH, "light")):
        opened(browser, page, width, HEIGHT, scheme=scheme)
        wide = browser.value("document.documentElement.scrollWidth")
        assert wide <= width, (width, wide, browser.value("[...document.querySelectorAll('main *')].filter(element => !element.closest('.scroll, svg')"
                                                          "&& element.getBoundingClientRect().right > innerWidth).map(element => element.outerHTML.slice(0, 200))"))
        ground, ink = browser.value("(style => [style.backgroundColor, style.color])(getComputedStyle(document.body))")
        brightness = [sum(map(int, re.findall(r"\d+", colour)[:3])) for colour in (ground, ink)]
        assert (brightness[0] > brightness[1]) == (scheme == "light") and abs(brightness[0] - brightness[1]) > 400, (ground, ink)
        paper = browser.value("(context => { context.drawImage(document.querySelector('#campbell ~ figure img'), 0, 0);"
                              "return context.getImageData(2, 2, 1, 1).data[0]; })(document.createElement('canvas').getContext('2d'))")
        assert (paper > 128) == (scheme == "light"), (scheme, paper)


def check_narrow(browser, page):
    """The columns to decide by stay in sight."""
    for width in (1440, 1024, 820, 390):
        opened(browser, page, width, HEIGHT)
        seen = browser.value("""[...document.querySelectorAll('.decision th[scope=col], #critical ~ .scroll th[scope=col]')]
          .filter(head => /^(critical speed|speed|wave|tip|Goodman|validity|outside validity)/.test(head.textContent))
          .map(head => [head.textContent, head.getBoundingClientRect().right, head.closest('.scroll').getBoundingClientRect().right])""")
        assert len(seen) >= 9 and all(0 < right <= edge + 1 for _, right, edge in seen), (width, seen)


def check_paper(browser, work, page):
    """Columns and figures by layout, and by what a reader of the PDF finds, where there is one."""
    opened(browser, page)
    browser.media("print")
    browser.size(round(PAPER_WIDTH), round(PAPER_HEIGHT))
    found = browser.value("""(() => {
      const seen = element => element.getClientRects().length > 0, tables = [...document.querySelectorAll('table')].filter(seen);
      const sections = [...document.images].map(image => image.closest('section'));
      return {pictures: [...document.images].every(seen), live: [...document.querySelectorAll('svg.chart')].some(seen),
        right: Math.max(...tables.map(table => table.getBoundingClientRect().right)),
        torn: sections.filter(section => getComputedStyle(section).breakInside !== 'avoid' || !section.querySelector('h2')).length,
        tallest: Math.max(...sections.map(section => section.getBoundingClientRect().height)),
        heads: tables.every(table => getComputedStyle(table.tHead).display === 'table-header-group'),
        version: document.querySelector('.paper-only').getClientRects().length && document.querySelector('.paper-only').textContent,
        numbered: getComputedStyle(document.querySelector('figcaption'), '::before').content,
        stress: document.querySelector('#stress ~ figure img')?.naturalWidth > 0,
        bands: decodeURIComponent(document.querySelector('#response ~ figure img').src).includes('Goodman above'),
        abreast: sections.filter(section => section.getBoundingClientRect().left > innerWidth / 3).length,
        columns: tables.flatMap(table => [...table.rows[0].cells].map(cell => cell.textContent))}; })()""")
    assert found["pictures"] and not found["live"] and found["torn"] == 0 and found["heads"], found
    assert found["version"].startswith("tiprub-postprocess") and "Figure" in found["numbered"] and found["abreast"] > 5, found
    assert found["stress"] and found["bands"], found
    assert found["right"] <= PAPER_WIDTH + 1 and found["tallest"] <= PAPER_HEIGHT, found
    paper = os.path.join(work, "report.pdf")
    with open(paper, "wb") as file:
        file.write(browser.pdf())
    if shutil.which("pdftotext"):
        text = subprocess.run(["pdftotext", "-layout", paper, "-"], stdout=subprocess.PIPE, text=True, check=True).stdout
        missing = {word for column in found["columns"] for word in column.split() if word not in text}
        assert not missing, missing


def check_hardest_contact(browser, angle):
    """The wheel stops where the largest sum of forces was recorded."""
    browser.value("document.querySelector('button[aria-label=\"Hardest contact: Pause where the casing pushes most\"]').click()")
    browser.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    expected = browser.value("""unpacked('wheel-data').then(data => {
      const motion = data.motions[0], force = data.array('motion/0/force'), rows = force.length / motion.samples;
      const sums = Array.from({length: motion.samples}, (_, s) => Array.from({length: rows}, (_, row) => force[row * motion.samples + s])
        .reduce((a, b) => a + b));
      return 360 * ((motion.first_sample + sums.indexOf(Math.max(...sums))) % motion.samples) / motion.samples_per_revolution; })""")
    assert abs(browser.value(angle) - expected) <= 0.51, (browser.value(angle), expected)


def check_probe(browser):
    """A click tells the values at a node; the largest stress is marked where the tables have it; the instants of the views are the wheel's."""
    words = "document.querySelector('#probed').textContent"
    assert re.search(r"largest stress of the vibration, \S+ MPa, .*sector \d", browser.value(words)), browser.value(words)
    x, y = browser.value("(box => [box.left + box.width / 2, box.top + box.height / 2, box.width])(document.querySelector('canvas.wheel').getBoundingClientRect())")[:2]
    for across in (0, -60, 60, -120, 120, -180, 180, -240, 240):  # the wheel has a bore
        browser.click(x + across, y)
        if "Node marked blue" in browser.value(words):
            break
    assert re.search(r"Node marked blue: sector \d, radius \S+ mm.* moves \S+ mm now; .* MPa of the vibration", browser.value(words)), browser.value(words)
    browser.value("(slider => { slider.value = 250; slider.dispatchEvent(new Event('input')); })(document.querySelector('input[aria-label=\"Instant of the period\"]'))")
    told, at = browser.value("[document.querySelector('#live-wheel output').textContent, document.querySelector('#at-instant').textContent]")
    turned = [float(re.search(pattern, text)[1]) for pattern, text in ((r"at (\d+) deg", told), (r"^(\d+) deg", at))]
    assert abs(turned[0] - turned[1]) <= 1.01, (told, at)


def check_wheel(browser, page):
    """Pixels change over a period, and with the colours; nothing moves in a pause; a click on another peak shows its motion."""
    opened(browser, page)
    pixels = "document.querySelector('canvas.wheel').toDataURL()"
    browser.value("document.querySelector('#in-motion').scrollIntoView()")
    browser.wait("document.querySelector('canvas.wheel')")
    angle = "parseFloat(document.querySelector('#live-wheel output').textContent.match(/at (\\d+) deg/)[1])"
    frames = []
    for turned in (10, 100, 190):
        browser.wait(f"{angle} >= {turned}")
        frames.append(browser.value(pixels))
    assert len(set(frames)) == 3 and min(map(len, frames)) > 5000, [len(frame) for frame in frames]
    browser.value("document.querySelector('button[aria-label=\"Play or pause the motion\"]').click()")
    browser.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    still = browser.value(pixels)
    browser.value("new Promise(done => setTimeout(done, 300))")
    assert browser.value(pixels) == still
    seen = {still}
    for label, chosen in (("Shown", "mode/2"), ("Shown", "rest"), ("Shown", "motion/0"), ("Colours", "spin"), ("Colours", "both")):
        browser.value(f"(choice => {{ choice.value = '{chosen}'; choice.dispatchEvent(new Event('change')); }})"
                      f"(document.querySelector('select[aria-label=\"{label}\"]'))")
        seen.add(browser.value(pixels))
    browser.value("document.querySelector('canvas.wheel').focus()")
    browser.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft")
    browser.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    seen.add(browser.value(pixels))
    assert len(seen) >= 6, len(seen)  # the motion chosen may be the one that was there
    check_hardest_contact(browser, angle)
    check_probe(browser)
    shown_motion = "document.querySelector('select[aria-label=\"Shown\"]').value"
    click_peak(browser, 1)
    assert browser.value(shown_motion) == "motion/1"
    check_honest_wheel(browser)


def check_comparison(browser, program, work):
    """With another response of the same model: its curve, its maps, its critical speeds beside these."""
    other = os.path.join(work, "another_study_with_a_name_without_a_space" * 3, "report")  # no window is that wide
    shutil.copytree(os.path.join(work, "report"), other)
    subprocess.run([program, "-q", "case.toml", "model.h5", "response.h5", "--compare", other, "--compare", "report", "-o", "compared"],
                   check=True, cwd=work, stdout=subprocess.DEVNULL)
    compared = os.path.join(work, "compared")
    rows = rows_of(os.path.join(compared, "comparison.csv"))
    assert len(rows) == 2 * len(rows_of(os.path.join(compared, "critical_speeds.csv")))
    assert all(abs(float(row["shift [%]"])) < 1e-6 for row in rows), rows
    opened(browser, os.path.join(compared, "report.html"))
    assert browser.value("[...document.querySelectorAll('#live-response path.other')].map(path => path.getAttribute('d').length > 100)") == [True, True]
    tables = browser.value("[...document.querySelector('#compared').closest('section').querySelectorAll('tbody')].map(body => body.rows.length)")
    assert tables == [3, len(rows) // 2, len(rows) // 2], tables
    reports = rows_of(os.path.join(compared, "reports.csv"))
    assert [row["report"] for row in reports][::2] == ["this report", "report"] and len({row["largest [rpm]"] for row in reports}) == 1, reports
    assert reports[0]["speeds to avoid"].endswith("Goodman's utilisation is not known without --fields.") and reports[1]["its stress with spin [MPa]"], reports
    words = browser.value("document.querySelector('#compared').closest('section').querySelector('h3 + p').textContent")
    assert words.startswith("The largest critical speed is") and "speed +0.0 %, amplitude +0.0 %" in words and "differ" not in words, words
    own = readout(browser, 1, 0.6, 0.5)
    browser.value("(choice => { choice.value = '1'; choice.dispatchEvent(new Event('change')); })"
                  "(document.querySelector('select[aria-label=\"Maps of\"]'))")
    assert readout(browser, 1, 0.6, 0.5) == own != ""
    check_sizes(browser, os.path.join(compared, "report.html"))


def check_without_webgl(browser, page):
    script = browser.call("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = (get => function(kind, ...more) {"
                          "return kind === 'webgl' ? null : get.call(this, kind, ...more); })(HTMLCanvasElement.prototype.getContext)")
    opened(browser, page)
    assert browser.value("document.querySelector('#live-wheel img').naturalWidth") > 0
    browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])


def check_without_scripts(browser, page):
    browser.media()
    browser.size(WIDTH, HEIGHT)
    browser.scripts(False)
    browser.open(page)
    browser.scripts(True)
    found = browser.value("[[...document.images].every(image => image.getClientRects().length > 0), "
                          "[...document.querySelectorAll('.live-only')].some(element => element.getClientRects().length > 0), "
                          "document.querySelectorAll('table').length, document.images[0].getBoundingClientRect().top]")
    assert found[0] and not found[1] and found[2] > 5 and found[3] <= HEIGHT, found


def made_report(program, writer, work):
    """Its folder; the wheel's strengths are known."""
    subprocess.run([writer, work], check=True, cwd=work)
    with open(os.path.join(work, "case.toml"), "a", encoding="utf-8") as case:
        case.write("\n[material]\nultimate_strength = 150e6\nendurance_limit = 40e6\nyield_strength = 60e6\n")
    subprocess.run([program, "-q", "case.toml", "model.h5", "cycles_response.h5", "--fields", "fields.h5", "-o", "report"],
                   check=True, cwd=work, stdout=subprocess.DEVNULL)
    return os.path.join(work, "report")


def main(program, writer, work):
    if chromium.installed() is None:
        print("skipped: no Chromium on this machine; .ci/install-packages packages-gate.txt brings it")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    report = made_report(program, writer, work)
    page = os.path.join(report, "report.html")
    with chromium.Chromium(work) as browser:
        check_opening(browser, page)
        check_first_screen(browser)
        check_peaks(browser, report)
        check_values(browser, report)
        check_zoom_and_keys(browser)
        check_columns(browser)
        check_stress(browser, report)
        check_bands(browser, report)
        check_names(browser)
        check_instant(browser)
        check_any_speed(browser, page, report)
        check_shared_speeds(browser, page)
        check_saved_views(browser)
        opened(browser, page)
        check_pictures_and_tables(browser, report)
        check_sizes(browser, page)
        check_narrow(browser, page)
        if browser.value("document.createElement('canvas').getContext('webgl') !== null"):
            check_wheel(browser, page)
        else:
            print("not tested: the wheel in motion, as this Chromium has no WebGL")
        check_without_webgl(browser, page)
        check_comparison(browser, program, work)
        check_paper(browser, work, page)
        check_without_scripts(browser, page)
        assert browser.errors == [], browser.errors
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:4])))
