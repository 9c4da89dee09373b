#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A study's page in a browser: every picture is drawn, nothing runs out of its picture or page.

    report_test.py REPORT_HTML FOLDER

Leaves what a reader would see, light, dark and on paper, in FOLDER.
"""

import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

# asks the browser where it put things, and writes the answer where --dump-dom shows it
LOOK = """
<pre id="seen"></pre><script>
const seen = {pictures: 0, flat: [], cut: [], over: [], many: [], wide: document.documentElement.scrollWidth -
              document.documentElement.clientWidth, ground: getComputedStyle(document.body).backgroundColor,
              ink: getComputedStyle(document.body).color, fetched: performance.getEntriesByType("resource").length};
for (const svg of document.querySelectorAll("svg")) {
  const title = svg.querySelector("title").textContent, frame = svg.getBoundingClientRect();
  seen.pictures++;
  if (frame.width < 300 || frame.height < 100) seen.flat.push(title);
  for (const part of svg.querySelectorAll("text, circle, rect, path")) {
    const box = part.getBoundingClientRect();
    if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 ||
        box.bottom > frame.bottom + 1) seen.cut.push(title + ": " + (part.textContent || part.tagName));
  }
  const words = [...svg.querySelectorAll("text")], boxes = words.map(word => word.getBoundingClientRect());
  for (let n = 0; n < words.length; n++) for (let m = 0; m < n; m++)
    if (boxes[n].left < boxes[m].right && boxes[m].left < boxes[n].right && boxes[n].top + 2 < boxes[m].bottom &&
        boxes[m].top + 2 < boxes[n].bottom)
      seen.over.push(title + ": " + words[n].textContent + " / " + words[m].textContent);
  const looks = [...svg.querySelectorAll("g[class^=s] > text:not(.setting)")].map(word => word.parentNode.getAttribute("class"));
  if (new Set(looks).size < looks.length) seen.many.push(title + ": " + looks.length);
}
document.getElementById("seen").textContent = JSON.stringify(seen);
</script></body>"""


def browse(browser, *arguments):
    with tempfile.TemporaryDirectory() as profile:
        # the page is ours, and a test may run as root, where the browser has no sandbox
        return subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu",
                               "--disable-dev-shm-usage", f"--user-data-dir={profile}",
                               "--window-size=1200,1600", *arguments],
                              capture_output=True, text=True, timeout=900)


def distinct_rows(png):
    """How many rows of an 8-bit picture are different, as stored: a blank page has next to none."""
    data = png.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert depth == 8 and kind in (2, 6), (depth, kind)
    packed, at = b"", 8
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    rows = zlib.decompress(packed)
    stride = 1 + width * (3 if kind == 2 else 4)
    return len({rows[n * stride:(n + 1) * stride] for n in range(height)})


def main():
    report, out = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    browser = shutil.which("chromium")
    if browser is None:
        print("chromium is not installed: the page is not looked at; skipped.")
        sys.exit(77)
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    html = report.read_text()
    copy = out / "looked-at.html"
    copy.write_text(html.replace("</body>", LOOK))
    grounds = {}
    for mode, option in (("light", []), ("dark", ["--force-dark-mode", "--blink-settings=preferredColorScheme=0"])):
        shown = browse(browser, *option, "--dump-dom", copy.as_uri())
        found = re.search(r'<pre id="seen">(.*?)</pre>', shown.stdout, re.S)
        assert found, f"{browser} showed no page: {shown.stderr[-2000:]}"
        seen = json.loads(found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
        assert seen["pictures"] == html.count("<svg ") > 0, seen["pictures"]
        assert not seen["flat"], f"too small to read: {seen['flat']}"
        assert not seen["cut"], f"runs out of its picture: {seen['cut'][:20]}"
        assert not seen["over"], f"one over the other: {seen['over'][:20]}"
        assert not seen["many"], f"series that look alike: {seen['many']}"
        assert seen["wide"] <= 0, f"the page is {seen['wide']} pixels wider than the window"
        assert seen["fetched"] == 0, "the page asks for something"
        grounds[mode] = (seen["ground"], seen["ink"])
        picture = out / f"{mode}.png"
        browse(browser, *option, f"--screenshot={picture}", report.as_uri())
        assert distinct_rows(picture) > 50, f"{picture} shows next to nothing"
    assert grounds["light"] != grounds["dark"], f"dark mode changes nothing: {grounds}"
    paper = out / "paper.pdf"
    browse(browser, f"--print-to-pdf={paper}", "--no-pdf-header-footer", report.as_uri())
    assert paper.read_bytes().startswith(b"%PDF") and paper.stat().st_size > 10_000
    print(f"{seen['pictures']} pictures, {grounds}")


if __name__ == "__main__":
    main()
