#!/usr/bin/python3
"""Opens a page in headless Chromium as wide and as narrow screens show it, light and dark, and looks for what is wrong.

Checked at each width: the page is laid out that wide and no wider, the console is silent, every figure is drawn. With
--pictures the page is kept as PNG. Exit status: 0 nothing is wrong, 1 something is, 77 there is no Chromium.
"""

import argparse
import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

WIDTHS = {1280: False, 390: True}  # CSS pixels; whether the screen is a phone's
TALLEST = 8_000  # CSS pixels: Chromium draws no pictures above 16384 of the screen's
SKIPPED = 77

FACTS = """({
  inner: window.innerWidth, scroll: document.documentElement.scrollWidth, height: document.documentElement.scrollHeight,
  figures: document.querySelectorAll('figure').length,
  undrawn: [...document.querySelectorAll('figure')].filter(figure => {
    const drawing = figure.querySelector('svg, img');
    if (!drawing) return true;
    const box = drawing.getBoundingClientRect();
    return box.width < 50 || box.height < 50 || (drawing.tagName === 'IMG' && !drawing.naturalWidth)
        || (drawing.tagName === 'svg' && drawing.querySelectorAll('path, use').length < 5);
  }).map(figure => figure.id)
})"""


class Browser:
    """Chromium, spoken to over the DevTools protocol through a pipe: messages are JSON that end with a zero byte."""

    def __init__(self, program: str, profile: str):
        commands, self.commands = os.pipe()
        self.answers, answers = os.pipe()

        def connect() -> None:
            # The protocol's pipes are file descriptors 3 and 4. Higher ones first, so that neither overwrites the other.
            high = [os.dup2(commands, 103), os.dup2(answers, 104)]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        arguments = [program, "--headless", "--remote-debugging-pipe", f"--user-data-dir={profile}", "--disable-gpu", "--hide-scrollbars",
                     "--no-first-run", "about:blank"]
        if os.geteuid() == 0:
            arguments.insert(1, "--no-sandbox")
        self.process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=connect,
                                        close_fds=False)
        os.close(commands)
        os.close(answers)
        self.last, self.rest, self.session = 0, b"", ""
        self.events: list[dict[str, Any]] = []

    def receive(self) -> dict[str, Any]:
        while b"\0" not in self.rest:
            data = os.read(self.answers, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self.rest += data
        message, _, self.rest = self.rest.partition(b"\0")
        return json.loads(message)

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        self.last += 1
        message = {"id": self.last, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") != self.last:
                self.events.append(answer)
            elif "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']['message']}")
            else:
                return answer["result"]

    def wait_for(self, method: str) -> None:
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.receive())

    def close(self) -> None:
        self.process.kill()
        self.process.wait()


def complaints_of(events: list[dict[str, Any]]) -> list[str]:
    """What the page wrote to the console, and exceptions."""
    found = []
    for event in events:
        parameters = event.get("params", {})
        if event.get("method") == "Runtime.exceptionThrown":
            found.append(parameters["exceptionDetails"]["text"])
        elif event.get("method") == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            found.append(" ".join(str(argument.get("value", "")) for argument in parameters["args"]))
        elif event.get("method") == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            found.append(parameters["entry"]["text"])
        elif event.get("method") == "Network.loadingFailed":
            found.append("something could not be loaded: " + parameters["errorText"])
    return found


def look(browser: Browser, address: str, width: int, theme: str, picture: Path | None, top: int, tallest: int) -> list[str]:
    """What is wrong with the page at this width."""
    browser.events.clear()
    browser.call("Emulation.setDeviceMetricsOverride", width=width, height=844 if WIDTHS[width] else 800, mobile=WIDTHS[width],
                 deviceScaleFactor=2 if WIDTHS[width] else 1)
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])
    browser.call("Page.navigate", url=address)
    browser.wait_for("Page.loadEventFired")
    facts = browser.call("Runtime.evaluate", expression=FACTS, returnByValue=True)["result"]["value"]
    wrong = complaints_of(browser.events)
    if facts["inner"] != width:
        wrong.append(f"innerWidth is {facts['inner']}")
    if facts["scroll"] > width:
        wrong.append(f"scrollWidth is {facts['scroll']}")
    if facts["figures"] == 0:
        wrong.append("there is no figure")
    wrong += [f"{name or 'a figure'} is not drawn" for name in facts["undrawn"]]
    if picture and top >= facts["height"]:
        wrong.append(f"the page ends above {top} px: there is nothing to keep")
    elif picture:
        clip = {"x": 0, "y": top, "width": width, "height": min(facts["height"] - top, tallest), "scale": 1}
        data = browser.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)["data"]
        picture.write_bytes(base64.b64decode(data))
    print(f"{width} px, {theme}: {facts['figures']} figures, {facts['height']} px high, "
          + ("nothing is wrong" if not wrong else "; ".join(wrong)))
    return wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path, nargs="?", default=Path("build/report/index.html"))
    parser.add_argument("--from", dest="top", type=int, default=0, metavar="PIXELS", help="where on the page pictures begin")
    parser.add_argument("--height", type=int, default=TALLEST, metavar="PIXELS", help="of pictures, at most")
    parser.add_argument("--pictures", type=Path, metavar="DIR", help="keep what was seen as PNG")
    arguments = parser.parse_args()
    program = shutil.which("chromium")
    if not program:
        print("check_page: there is no Chromium; Debian's package is chromium", file=sys.stderr)
        return SKIPPED
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    wrong = []
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(program, profile)
        try:
            target = browser.call("Target.createTarget", url="about:blank")["targetId"]
            browser.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            for domain in ("Page", "Runtime", "Log", "Network"):
                browser.call(f"{domain}.enable")
            for width in WIDTHS:
                for theme in ("light", "dark"):
                    picture = arguments.pictures / f"report_{width}_{theme}.png" if arguments.pictures else None
                    wrong += look(browser, arguments.page.resolve().as_uri(), width, theme, picture, arguments.top, arguments.height)
        finally:
            browser.close()
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
