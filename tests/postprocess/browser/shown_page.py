# SPDX-License-Identifier: GPL-3.0-or-later
"""A report's page as its tests open it, read it and click in it."""
import csv
import time

WIDTH, HEIGHT = 1440, 900
LIVE = "document.documentElement.classList.contains('live')"
VIEWS = "[...document.querySelectorAll('svg.chart:not(.stress)')]"  # that of stress stands only where there are full fields


def opened(browser, page, width=WIDTH, height=HEIGHT, medium="screen", scheme="light"):
    browser.size(width, height, mobile=width < 600)
    browser.media(medium, scheme)
    seconds = browser.open(page) + browser.wait(LIVE + " && document.querySelectorAll('svg.chart .frame').length >= 8")
    assert browser.value("performance.getEntriesByType('resource').map(e => e.name).filter(n => !/^(data|blob):/.test(n))") == []
    return seconds


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def shown(browser):
    return browser.value("document.querySelector('#shown-speed').textContent")


def click_peak(browser, number):
    """In the response, where a peak's name stands, far above the curve."""
    x, y = browser.value(f"(() => {{ const svg = document.querySelector('#live-response svg'); svg.scrollIntoView({{block: 'center'}});"
                         f"const box = svg.getBoundingClientRect(), name = svg.querySelectorAll('.wave-name')[{number}];"
                         "return [box.left + Number(name.getAttribute('x')), box.top + 60]; })()")
    browser.click(x, y)
    time.sleep(0.4)  # until it can't be the first half of a double-click
