# SPDX-License-Identifier: GPL-3.0-or-later
"""Any speed of the page: chosen, named in the address, zoomed into, saved; and the wheel at it."""
import csv
import json
import os
import re
import time

from shown_page import VIEWS, opened, rows_of, shown


def event(selector, kind, value=None):
    """Script: an element hears an event, after it took a value."""
    return (f"(element => {{ {'' if value is None else f'element.value = {json.dumps(value)};'} element.dispatchEvent(new Event('{kind}')); }})"
            f"(document.querySelector({json.dumps(selector)}))")


def ticks_of(browser, view):
    return browser.value(f"[...{VIEWS}[{view}].querySelectorAll('.axes text')].map(text => text.textContent)")


def check_any_speed(browser, page, report):
    """Typed, or a row of a table: the views show it, the address names it, and back leads to the one before."""
    opened(browser, page)
    rows = rows_of(os.path.join(report, "speeds.csv"))
    speeds = [float(row["speed [rpm]"]) for row in rows]
    first = shown(browser)
    between = 0.4 * speeds[1] + 0.6 * speeds[2]
    browser.value(event("input.typed", "change", str(between)))
    assert shown(browser).startswith(f"{speeds[2]:.0f} rpm"), (shown(browser), speeds[:4])
    told = browser.value("document.querySelector('#shown-answers').textContent")
    low, high = ([float(row["largest [mm]"]) for row in rows_of(os.path.join(report, "figures", "response.csv"))][i] for i in (1, 2))
    assert "was not simulated" in told and abs(float(re.search(r"moves by (\S+) mm", told)[1]) - (0.4 * low + 0.6 * high)) < 0.01 * (low + high), told
    browser.value("document.querySelector('.decision button.row-speed').click()")
    peak = rows_of(os.path.join(report, "critical_speeds.csv"))[0]
    assert shown(browser).startswith(f"{float(peak['speed [rpm]']):.0f} rpm, critical: {peak['wave']}"), (shown(browser), peak["wave"])
    address = browser.value("location.hash")
    browser.value("new Promise(done => { addEventListener('popstate', () => done(), {once: true}); history.back(); })")
    assert shown(browser).startswith(f"{speeds[2]:.0f} rpm"), shown(browser)
    browser.value("new Promise(done => { addEventListener('popstate', () => done(), {once: true}); history.back(); })")
    assert shown(browser) == first
    browser.call("Page.navigate", url="about:blank")
    opened(browser, page + address + "&nd=2&from=1000&to=99999")
    assert shown(browser).startswith(f"{float(peak['speed [rpm]']):.0f} rpm, critical")
    assert browser.value("document.querySelector('select[aria-label=\"Nodal diameters\"]').value") == "2"


def check_shared_speeds(browser, page):
    """Response, maps and Campbell diagram zoom along speed together; the cross stands at one speed in all; a flat box leaves y alone."""
    opened(browser, page)
    campbell = browser.value(VIEWS + ".findIndex(view => view.getAttribute('aria-label').startsWith('Campbell'))")
    whole = [ticks_of(browser, view) for view in (0, 1, 2, campbell)]
    x, y, width = browser.value("(() => { const frame = document.querySelector('#live-response .frame'); frame.scrollIntoView({block: 'center'});"
                                "const box = frame.getBoundingClientRect(); return [box.left, box.top + 40, box.width]; })()")
    crossed = "[...document.querySelectorAll('svg.chart')].filter(view => view.querySelector('.cross line')).length"
    browser.hover(x + 0.5 * width, y)
    assert browser.value(crossed) == 5  # response, stress, two maps, Campbell diagram
    browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x + 0.2 * width, y=y, button="left", clickCount=1)
    for kind, to in (("mouseMoved", 0.5), ("mouseMoved", 2), ("mouseReleased", 2)):  # released outside
        browser.call("Input.dispatchMouseEvent", type=kind, x=x + to * width, y=y + 3, button="left", buttons=1, clickCount=1)
    zoomed = [ticks_of(browser, view) for view in (0, 1, 2, campbell)]
    assert all(a != b for a, b in zip(whole, zoomed)) and browser.value("document.querySelector('.zoom-box')") is None
    assert browser.value("/&from=/.test(location.hash)")
    amplitudes = [[text for text in ticks if "." in text] for ticks in (whole[0], zoomed[0])]
    assert amplitudes[0] == amplitudes[1], amplitudes
    browser.value("document.querySelector('button[aria-label^=\"Whole: Campbell\"]').click()")
    assert [ticks_of(browser, view) for view in (0, 1, 2, campbell)] == whole
    before = shown(browser)
    for count in (1, 2):  # a slow double-click: the first one has chosen a speed
        browser.click(x + 0.3 * width, y, count)
        time.sleep(0.4 if count == 1 else 0.1)
    assert shown(browser) == before, "a slow double-click chose a speed"


def bands_in(words):
    """Ends [rpm] of the speeds to avoid, as they are told."""
    return [tuple(map(float, found)) for found in re.findall(r"(\d+) to (\d+) rpm \(", words)]


def touching(bands):
    """Left ends and widths, where bands that touch are one."""
    joined = []
    for left, width in bands:
        if joined and left - sum(joined[-1]) < 1e-6:
            joined[-1][1] = left + width - joined[-1][0]
        else:
            joined.append([left, width])
    return joined


def check_bands(browser, report):
    """The words on top, the shading of both charts and the verdict at any speed agree on the speeds to avoid."""
    with open(os.path.join(report, "summary.json"), encoding="utf-8") as file:
        told = bands_in(json.load(file)["verdict"]["Avoid"])
    assert told and all(a[1] < b[0] for a, b in zip(told, told[1:])), told
    assert bands_in(browser.value("document.querySelector('.lead').textContent.split('Avoid')[1].split('Margin')[0]")) == told
    for name in ("#live-response svg.chart:not(.stress)", "svg.stress"):
        shaded = browser.value(f"""(svg => {{ const frame = svg.querySelector('.frame'), left = Number(frame.getAttribute('x')), width = Number(frame.getAttribute('width'));
          return [...svg.querySelectorAll('rect.avoid')].map(band => [Number(band.getAttribute('x')), Number(band.getAttribute('width'))]
            .map((pixels, k) => (pixels - (k ? 0 : left)) / width)); }})(document.querySelector({json.dumps(name)}))""")
        low, high = browser.value("unpacked('speed-data').then(data => data.axes.speed)")
        shaded = touching(shaded)  # the words tell the grades of such bands together
        for (first, last), (left, width) in zip(told, shaded):
            expected = [(min(high, max(low, rpm)) - low) / (high - low) for rpm in (first, last)]
            assert abs(expected[0] - left) < 0.01 and abs(expected[1] - left - width) < 0.01, (told, shaded)
        assert len(shaded) == len(told), (told, shaded)
    rows = [row for row in rows_of(os.path.join(report, "speeds.csv")) if not row["failure"]]
    for row in rows[1::8]:  # whether it is critical or not
        rpm = float(row["speed [rpm]"])
        if min(abs(rpm - end) for band in told for end in band) < 1:  # the ends are told in whole numbers
            continue
        browser.value(event("input.typed", "change", row["speed [rpm]"]))
        verdict = browser.value("[...document.querySelectorAll('#shown-answers dt')].find(head => head.textContent === 'Verdict').nextSibling.textContent")
        inside = [band for band in told if band[0] <= rpm <= band[1]]
        assert verdict.startswith("To be avoided: inside" if inside else "Outside the speeds to avoid: "), (verdict, told)
        if not inside:
            away = min(max(first - rpm, rpm - last) for first, last in told)
            assert abs(float(re.search(r": (\S+) rpm", verdict)[1]) - away) <= 0.006 * away + 1, (verdict, told)
        for phrase in ("|u| ", " MPa", "Goodman's utilisation", "How sure: ", row["motion"].split(",")[0]):
            assert phrase in verdict, (phrase, verdict)
    between = 0.5 * (float(rows[0]["speed [rpm]"]) + float(rows[1]["speed [rpm]"]))
    for rpm, phrase in ((between, "How sure: on the line between"), (1, "Not known: outside the simulated speeds.")):
        browser.value(event("input.typed", "change", str(rpm)))
        assert phrase in browser.value("document.querySelector('#shown-answers').textContent"), rpm


def check_names(browser):
    """Names of waves, engine orders and families in the charts over speed: there, and apart."""
    for view, label in enumerate(browser.value(VIEWS + ".map(view => view.getAttribute('aria-label'))")):
        kinds = {"Tip": ("wave",), "Interaction": ("order",), "Campbell": ("order", "family")}.get(label.split()[0], ())
        for kind in kinds:
            boxes = browser.value(f"[...{VIEWS}[{view}].querySelectorAll('.{kind}-name')].map(name => name.getBoundingClientRect())"
                                  ".map(box => [box.left, box.top, box.right, box.bottom])")
            assert boxes, (label, kind)
            for i, a in enumerate(boxes):
                for b in boxes[:i]:
                    over = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
                    assert min(over) <= 3, (label, kind, a, b)  # px: a line's box is higher than its letters


def check_saved_views(browser):
    """What a view saves: its picture with its looks, and its numbers."""
    saved = browser.value("""(() => { const found = [], create = URL.createObjectURL; URL.createObjectURL = blob => { found.push(blob); return create(blob); };
      HTMLAnchorElement.prototype.click = () => {};
      for (const name of ['SVG', 'CSV']) for (const view of document.querySelectorAll(`button[aria-label^="${name}: "]`)) view.click();
      URL.createObjectURL = create; return Promise.all(found.map(blob => blob.text())); })()""")
    pictures = [text for text in saved if text.startswith("<svg")]
    assert len(pictures) == 10 and all("stroke:" in text for text in pictures), len(pictures)
    for text in saved:
        if not text.startswith("<svg"):
            columns = [len(row) for row in csv.reader(text.splitlines())]
            assert len(set(columns)) == 1 and len(columns) > 5, text[:200]


def check_honest_wheel(browser):
    """At a speed without a motion of the wheel it shows none, and says so; the mouse's wheel moves the page but with a key the view."""
    browser.value("document.querySelector('#in-motion').scrollIntoView()")
    x, y = browser.value("(box => [box.left + box.width / 2, box.top + 60])(document.querySelector('canvas.wheel').getBoundingClientRect())")
    for modifiers, moves in ((0, True), (2, False)):
        top = browser.value("scrollY")
        browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=60, modifiers=modifiers)
        # A busy machine scrolls late. A series of turns keeps its first target.
        browser.value(f"""new Promise(done => {{ const end = performance.now() + {10000 if moves else 1000};
          const look = () => setTimeout(scrollY !== {top} || performance.now() > end ? done : look, 100); look(); }})""")
        browser.value("new Promise(done => setTimeout(done, 1000))")
        assert (browser.value("scrollY") != top) == moves, (modifiers, top)
    browser.value(event("input.typed", "change", "1"))
    seen = browser.value("[document.querySelector('canvas.wheel').getClientRects().length, document.querySelector('.blank').textContent]")
    assert seen[0] == 0 and "No motion of the whole wheel was recovered at" in seen[1], seen
