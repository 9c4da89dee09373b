# SPDX-License-Identifier: BSD-3-Clause
# The help of resources/help as HTML and as man pages:
#   sphinx-build -c packaging/help -b html resources/help OUT
#   sphinx-build -c packaging/help -b man resources/help OUT
import pathlib
import re

root = pathlib.Path(__file__).resolve().parents[2]
project = "Palpate"
author = "The Palpate authors"
copyright = author
release = version = re.search(r"project\(\w+ VERSION (\S+)", (root / "CMakeLists.txt").read_text()).group(1)
today = release  # a date would make every build another one
extensions = ["myst_parser"]
exclude_patterns = ["*/*.md"]  # translations are for the window
myst_heading_anchors = 3
html_theme = "classic"
html_show_sourcelink = False
html_copy_source = False
html_use_index = False
html_last_updated_fmt = None
html_theme_options = {"sidebarwidth": 280, "body_max_width": "60em"}
man_show_urls = False
man_pages = [
    ("palpate", "palpate", "see a CT scan, and feel it through a haptic device", author, 1),
    ("palpate-cli", "palpate-cli", "describe, convert and touch scans without a window", author, 1),
    ("palpate-fetch", "palpate-fetch", "fetch scans from a PACS", author, 1)]
nitpicky = True


def adapt(app, name, source):
    text = source[0]
    if name == "index":  # what the window lists by itself
        text += "\n```{toctree}\n:hidden:\n:glob:\n*\n```\n"
    if app.builder.name != "html":  # a man page does not show where a link leads
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    source[0] = text


def setup(app):
    app.connect("source-read", adapt)
