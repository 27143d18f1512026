# SPDX-License-Identifier: GPL-3.0-or-later
"""Headless Chromium, driven over a pipe by its DevTools protocol; nothing but Python's own library is needed.

    with Chromium(folder) as browser:
        browser.open(path); browser.value("document.title"); browser.errors
"""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import threading
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")


def installed():
    return next((found for found in map(shutil.which, NAMES) if found), None)


class Chromium:
    """One page. `errors`: what its console and its exceptions said."""

    def __init__(self, folder, timeout=110):
        self.folder, self.timeout, self.errors, self.number = folder, timeout, [], 0

    def __enter__(self):
        command_read, self.command = os.pipe()
        self.answers, answer_write = os.pipe()
        self.profile = tempfile.mkdtemp(dir=self.folder)

        def as_3_and_4():
            os.dup2(command_read, 13), os.dup2(answer_write, 14)
            os.dup2(13, 3), os.dup2(14, 4)

        self.process = subprocess.Popen(
            [installed(), "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--remote-debugging-pipe", "--hide-scrollbars",
             "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--user-data-dir={self.profile}",
             "about:blank"], preexec_fn=as_3_and_4, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(command_read), os.close(answer_write)
        self.deadline = threading.Timer(5 * self.timeout, self.process.kill)
        self.deadline.start()
        self.rest, self.session = b"", None
        page = next(target for target in self.call("Target.getTargets")["targetInfos"] if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")
        return self

    def __exit__(self, *_):
        self.deadline.cancel()
        self.process.kill()
        self.process.wait()
        os.close(self.command), os.close(self.answers)
        shutil.rmtree(self.profile, ignore_errors=True)

    def messages(self):
        while True:
            message, end, after = self.rest.partition(b"\0")
            if end:
                self.rest = after
                yield json.loads(message)
                continue
            more = os.read(self.answers, 1 << 20)
            assert more, "Chromium has ended"
            self.rest += more

    def note(self, message):
        method, what = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = what["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        if method == "Log.entryAdded" and what["entry"]["level"] == "error":
            self.errors.append(what["entry"]["text"])
        if method == "Runtime.consoleAPICalled" and what["type"] in ("error", "assert"):
            self.errors.append(str(what["args"]))

    def call(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.command, data):]
        for answer in self.messages():
            self.note(answer)
            if answer.get("id") == self.number:
                assert "error" not in answer, (method, answer)
                return answer["result"]

    def open(self, path):
        """Goes to a file and waits until it is loaded; returns the seconds that it took."""
        begin = time.monotonic()
        self.call("Page.navigate", url="file://" + path)
        for message in self.messages():
            self.note(message)
            if message.get("method") == "Page.loadEventFired":
                return time.monotonic() - begin

    def value(self, expression):
        """Of an expression, or of the promise that it is."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in answer, (expression[:200], answer["exceptionDetails"].get("exception"))
        return answer["result"].get("value")

    def wait(self, condition):
        begin = time.monotonic()
        while not self.value(f"Boolean({condition})"):
            assert time.monotonic() - begin < self.timeout, (condition, self.errors)
            time.sleep(0.02)
        return time.monotonic() - begin

    def size(self, width, height, mobile=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def media(self, medium="screen", scheme="light"):
        self.call("Emulation.setEmulatedMedia", media=medium, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def scripts(self, on):
        self.call("Emulation.setScriptExecutionDisabled", value=not on)

    def click(self, x, y, count=1):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=count)

    def hover(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def screenshot(self, path=None, whole=False):
        image = base64.b64decode(self.call("Page.captureScreenshot", captureBeyondViewport=whole,
                                           **({"clip": self.whole()} if whole else {}))["data"])
        if path:
            with open(path, "wb") as file:
                file.write(image)
        return image

    def whole(self):
        size = self.call("Page.getLayoutMetrics")["cssContentSize"]
        return {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}

    def pdf(self):
        return base64.b64decode(self.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"])
