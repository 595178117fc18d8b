# SPDX-License-Identifier: MIT
"""A real headless Chromium, driven through WebDriver (chromedriver), which is plain HTTP: no package of Python is needed."""

import base64
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request


def is_there():
    return shutil.which("chromedriver") is not None and shutil.which("chromium") is not None


def run_tests(pictures, missing=()):
    """Those of the calling file. Exit code 77, which says why: a program that `missing` names, or Chromium, is not there."""
    missing = [*([] if is_there() else ["Chromium (package chromium-driver)"]), *missing]
    if missing:
        print("SKIPPED: not there: " + ", ".join(missing))
        sys.exit(77)
    pictures.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Browser:
    """With `width` and `height` of the window in CSS pixels. To be used in a `with`."""

    def __init__(self, width=1280, height=900, dark=False):
        self.folder = tempfile.TemporaryDirectory()
        port = free_port()
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.base = f"http://127.0.0.1:{port}"
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-dev-shm-usage",
                     f"--user-data-dir={self.folder.name}", f"--window-size={width},{height}"]
        if dark:
            arguments.append("--force-dark-mode")
        try:
            self.wait_for_driver()
            options = {"browserName": "chrome", "goog:chromeOptions": {"args": arguments}, "goog:loggingPrefs": {"browser": "ALL"}}
            self.session = self.call("POST", "/session", {"capabilities": {"alwaysMatch": options}})["sessionId"]
        except BaseException:
            self.driver.kill()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        try:
            self.call("DELETE", f"/session/{self.session}")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.folder.cleanup()

    def wait_for_driver(self):
        for _ in range(600):
            try:
                if self.call("GET", "/status")["ready"]:
                    return
            except (urllib.error.URLError, ConnectionError):
                pass
            time.sleep(0.1)
        raise RuntimeError("chromedriver does not answer")

    def call(self, method, path, content=None):
        data = None if content is None and method != "POST" else json.dumps(content or {}).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.loads(answer.read())["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(f"{method} {path}: {error.read().decode(errors='replace')[:2000]}") from error

    def open(self, url):
        self.call("POST", f"/session/{self.session}/url", {"url": url})

    def run(self, script, *arguments):
        """What the script returns: `return document.title`."""
        return self.call("POST", f"/session/{self.session}/execute/sync", {"script": script, "args": list(arguments)})

    def wait_until(self, script, seconds=60.0):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if value := self.run(script):
                return value
            time.sleep(0.05)
        raise AssertionError(f"not within {seconds} s: {script}")

    def run_async(self, script, *arguments):
        """What the script gives to the function that is its last argument."""
        return self.call("POST", f"/session/{self.session}/execute/async", {"script": script, "args": list(arguments)})

    def patience(self, seconds):
        """With scripts; a busy machine needs it."""
        self.call("POST", f"/session/{self.session}/timeouts", {"script": 1000 * seconds})

    def picture(self, file):
        pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
        pathlib.Path(file).write_bytes(base64.b64decode(self.call("GET", f"/session/{self.session}/screenshot")))

    def devtools(self, command, **parameters):
        return self.call("POST", f"/session/{self.session}/goog/cdp/execute", {"cmd": command, "params": parameters})

    def long_picture(self, file, most_px=6000):
        """Also of what has to be scrolled to, from the top."""
        width, height = self.run("return [innerWidth, document.documentElement.scrollHeight]")
        clip = {"x": 0, "y": 0, "width": width, "height": min(height, most_px), "scale": 1}
        picture = self.devtools("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)["data"]
        pathlib.Path(file).write_bytes(base64.b64decode(picture))

    def screen(self, width, height, dark=False, phone=False):
        """Of any size: a window is never narrower than 500 px."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)
        self.devtools("Emulation.setTouchEmulationEnabled", enabled=phone)
        self.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def print(self, file, width_cm, height_cm):
        page = {"page": {"width": width_cm, "height": height_cm}, "background": True}
        pathlib.Path(file).write_bytes(base64.b64decode(self.call("POST", f"/session/{self.session}/print", page)))

    def complaints(self):
        """Errors and warnings of the page's console since the last call."""
        entries = self.call("POST", f"/session/{self.session}/se/log", {"type": "browser"})
        return [entry["message"] for entry in entries if entry["level"] in ("SEVERE", "WARNING")]
