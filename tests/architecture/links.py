#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where a relative link or an anchor in a Markdown file of the tree leads nowhere.

Usage: links.py ROOT
       links.py --plant SCRATCH   (proves that it can fail)

Links to other hosts are not followed. Code blocks and inline code are not searched for links.
"""
import pathlib
import re
import shutil
import sys
import urllib.parse

SKIPPED = ("build", "out", ".git")
LINK = re.compile(r"\[[^\]\[]*\]\(\s*<?([^)\s>]+)>?[^)]*\)|^\s*\[[^\]]+\]:\s*(\S+)", re.M)


def without_code(text):
    """The text with fenced blocks and inline code blanked out; lines keep their numbers."""
    lines, fence = [], None
    for line in text.split("\n"):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if fence:
            if mark and mark.group(1).startswith(fence):
                fence = None
            line = ""
        elif mark:
            fence = mark.group(1)
            line = ""
        lines.append(re.sub(r"`[^`]*`", lambda code: " " * len(code.group()), line))
    return "\n".join(lines)


def headings(text):
    """The anchors of a file's headings, as GitHub makes them."""
    found, fence = set(), None
    for line in text.split("\n"):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark:
            fence = None if fence else mark.group(1)
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if fence or not heading:
            continue
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1)).lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        again, number = anchor, 0
        while again in found:
            number += 1
            again = f"{anchor}-{number}"
        found.add(again)
    return found


def markdown_files(root):
    return [path for path in sorted(root.rglob("*.md"))
            if path.relative_to(root).parts[0] not in SKIPPED]


def check(root):
    """(number of links followed, ["file:line: what is wrong", …])"""
    followed, wrong = 0, []
    for path in markdown_files(root):
        text = without_code(path.read_text())
        for link in LINK.finditer(text):
            target = link.group(1) or link.group(2)
            if re.match(r"[a-z][a-z0-9+.-]*:", target, re.I):
                continue
            followed += 1
            place = f"{path.relative_to(root)}:{text.count(chr(10), 0, link.start()) + 1}"
            name, _, anchor = target.partition("#")
            # a translated page of the help has the links of its English one, as the window resolves them
            help_folder = root / "resources/help"
            like = help_folder / path.name if path.parent.parent == help_folder else path
            end = like.parent / urllib.parse.unquote(name) if name else like
            if not end.exists():
                wrong.append(f"{place}: '{target}' is not there")
            elif root.resolve() not in (end.resolve(), *end.resolve().parents):
                wrong.append(f"{place}: '{target}' is outside the tree")
            elif anchor and (end.suffix != ".md" or
                             urllib.parse.unquote(anchor) not in headings(end.read_text())):
                wrong.append(f"{place}: '{target}' names no heading of {end.name}")
    for line in wrong:
        print(line)
    print(f"{followed} links, {len(wrong)} broken.")
    return followed, wrong


def plant(scratch):
    shutil.rmtree(scratch, ignore_errors=True)
    (scratch / "a").mkdir(parents=True)
    (scratch / "README.md").write_text(
        "# One\n\n## What it is, and isn't\n\n## Two\n\n## Two\n\n[a](a/README.md#here) [one](#one)\n"
        "[b](#what-it-is-and-isnt) [c](#two-1) [d](a) [far](https://example.org/x.md)\n"
        "```\n# No heading\n[in code](gone.md)\n```\n`[too](gone.md)` ![e](a/e.png)\n")
    (scratch / "a/README.md").write_text("# Here\n\n[up](../README.md)\n")
    (scratch / "a/e.png").write_bytes(b"")
    followed, wrong = check(scratch)
    assert (followed, wrong) == (7, []), "a broken link was found where there is none"
    (scratch / "a/more.md").write_text(
        "[a](gone.md)\n\n[b](../README.md#three) [c](../README.md#no-heading)\n[d](../../)\n[e]: gone\n")
    wrong = check(scratch)[1]
    places = [line.split(": ")[0] for line in wrong]
    assert places == ["a/more.md:1", "a/more.md:3", "a/more.md:3", "a/more.md:4", "a/more.md:5"], wrong


if sys.argv[1] == "--plant":
    plant(pathlib.Path(sys.argv[2]))
else:
    followed, wrong = check(pathlib.Path(sys.argv[1]))
    sys.exit(1 if wrong or followed < 10 else 0)
