#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where the help (resources/help) and the program do not agree: a reason without one entry
on the page of messages; a page that is in no list; a panel without its page; a device without one.

Usage: help.py ROOT
       help.py --plant SCRATCH  (proves that it can fail)

An entry is a section of messages.md; its reasons are in backquotes in the line below its heading.
"""
import pathlib
import re
import shutil
import sys

REASONS = re.compile(r"^`[a-z-]+`(?:, `[a-z-]+`)*$", re.M)
ROW = re.compile(r'\{\s*"[a-z0-9-]+"\s*(?:,\s*(?:"(?:[^"\\\n]|\\.)*"\s*)+),\s*"([a-z-]+)"\s*\}')
REFUSAL = re.compile(r'\b(?:malformed|unsupported|refused|failed)\(\s*"([a-z-]+)",')


def check_reasons(root):
    """Those of the rows of resources/messages, and those with which the code refuses."""
    wrong, seen, known = [], [], set()
    for section in (root / "resources/help/messages.md").read_text().split("\n## ")[1:]:
        words = REASONS.search(section)
        seen += re.findall(r"[a-z-]+", words.group()) if words else []
        if not words or not section[words.end():].strip():
            wrong.append(f"messages.md: '{section.splitlines()[0]}' lacks its reasons, or what to do")
    wrong += [f"messages.md: '{reason}' has two entries" for reason in sorted(set(seen)) if seen.count(reason) > 1]
    for table in (root / "resources/messages").glob("*.h"):
        known.update(ROW.findall(table.read_text()))
    for folder in ("app", "datasets", "haptics"):
        for source in (root / folder).rglob("*.cpp"):
            known.update(REFUSAL.findall(source.read_text()))
    wrong += [f"messages.md has no entry of the reason '{reason}'" for reason in sorted(known - set(seen))]
    return len(known), wrong


def check_pages(root):
    help_folder, wrong = root / "resources/help", []
    pages = {page.name for page in help_folder.glob("*.md")}
    contents = (help_folder / "index.md").read_text()
    wrong += [f"index.md does not list {name}" for name in sorted(pages)
              if name != "index.md" and f"({name})" not in contents]
    for page in sorted(help_folder.glob("*.md")):
        if not page.read_text().startswith("# "):
            wrong.append(f"{page.name} does not begin with its title")
    return wrong


def headings(page):
    return [len(marks) for marks in re.findall(r"^(#+) ", page.read_text(), re.M)]


def check_translations(root):
    """Links name English headings, so a translated page has as many, of the same levels, and the same links."""
    wrong = []
    for page in sorted((root / "resources/help").glob("*/*.md")):
        name = f"{page.parent.name}/{page.name}"
        english = root / "resources/help" / page.name
        if not english.exists():
            wrong.append(f"{name} translates no page")
            continue
        if headings(page) != headings(english):
            wrong.append(f"{name} has other headings than {page.name}")
        links = [sorted(set(re.findall(r"\]\(([^)]+)\)", one.read_text()))) for one in (page, english)]
        if links[0] != links[1]:
            wrong.append(f"{name} has other links than {page.name}")
    return wrong


def check_panels(root):
    """Each section that a controller adds has a line in ui/dialogs/help_window.cpp, with a page that is there."""
    table = (root / "ui/dialogs/help_window.cpp").read_text()
    pages = dict(re.findall(r'\{"(\w+)", "([\w-]+)"\}', table))
    panels, wrong = set(), []
    for source in sorted((root / "app/window").rglob("*.*")):
        panels |= set(re.findall(r'\bpanels(?:\(\))?\.add\([^;]*?"(\w+Section)"', source.read_text()))
    for name in sorted(panels):
        if name not in pages:
            wrong.append(f"ui/dialogs/help_window.cpp has no page for the panel '{name}'")
    wrong += [f"ui/dialogs/help_window.cpp: no page is {page}.md" for page in pages.values()
              if not (root / f"resources/help/{page}.md").exists()]
    return len(panels), wrong


def check_hazards(root):
    """Each test that is named as the proof of a control is there, in C++ or as a test of CMake."""
    page = root / "resources/help/hazards.md"
    if not page.exists():
        return []
    known = set()
    for source in (root / "tests").rglob("*.cpp"):
        known |= {f"{s}.{n}" for s, n in re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", source.read_text(), re.M)}
    for lists in (root / "tests").rglob("CMakeLists.txt"):
        known |= set(re.findall(r"add_test\(NAME ([\w.]+)", lists.read_text()))
    known |= {name.split(".")[0] + ".*" for name in known}
    return [f"hazards.md: there is no test {name}" for name in re.findall(r"`([A-Z]\w+\.[\w*]+)`", page.read_text())
            if name not in known]


def check_syntaxes(root):
    """The transfer syntaxes of the conformance statement are those of the readers."""
    page = root / "resources/help/dicom-conformance.md"
    if not page.exists():
        return []
    uid = r"1\.2\.840\.10008\.1\.2(?:\.\d+)*"
    stated = set(re.findall(rf"\| ({uid}) \|", page.read_text()))
    read = set()
    for source in (root / "datasets/readers/dicom").glob("*.cpp"):
        read |= set(re.findall(rf'"({uid})"', source.read_text()))
    return [f"dicom-conformance.md and the readers differ on {name}" for name in sorted(stated ^ read)]


def check(root):
    reasons, wrong = check_reasons(root)
    panels, of_panels = check_panels(root)
    wrong += check_pages(root) + check_translations(root) + of_panels + check_hazards(root) + check_syntaxes(root)
    for line in wrong:
        print(line)
    print(f"{reasons} reasons, {panels} panels, {len(wrong)} wrong.")
    return reasons, panels, wrong


def plant(scratch):
    shutil.rmtree(scratch, ignore_errors=True)

    def write(name, text):
        path = scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    write("resources/messages/readers.h", '{"cut-off", "\\"%1\\" ends; " "fetch it.", "truncated"},\n{"a-word", "word"},\n')
    write("datasets/one.cpp", 'return malformed(\n  "bad-header", {"cut-off", {name}});')
    write("app/window/one.cpp", 'panels.add(p, tr("One"), tr("&One"), "oneSection", ui::Tab::Scan);')
    write("ui/dialogs/help_window.cpp", '{"oneSection", "one"},')
    write("resources/help/index.md", "# Help\n[one](one.md) [m](messages.md)\n")
    write("resources/help/one.md", "# One\n")
    good = "# M\n\n## Cut\n\n`truncated`, `bad-header`\n\nFetch.\n"
    write("resources/help/messages.md", good)
    assert check(scratch) == (2, 1, []), "something was found that is not wrong"
    write("resources/help/messages.md", good.replace(", `bad-header`", "") + "\n## Other\n\n`truncated`\n")
    write("resources/help/two.md", "Two\n")
    write("resources/help/de/one.md", "# Eins\n\n## Mehr\n\n[m](messages.md)\n")
    write("resources/help/de/three.md", "# Drei\n")
    write("app/window/two.cpp", 'panels.add(p, tr("Two"), tr("T"),\n "twoSection", ui::Tab::Scan);')
    write("resources/help/hazards.md", "# H\n`Hazards.IsThere` `Hazards.IsNot`\n")
    write("tests/one.cpp", "TEST(Hazards, IsThere) {}\n")
    write("resources/help/dicom-conformance.md", "# D\n| 1.2.840.10008.1.2 |\n")
    write("datasets/readers/dicom/one.cpp", '"1.2.840.10008.1.2.1"')
    wrong = check(scratch)[2]
    for part in ("no test Hazards.IsNot", "differ on 1.2.840.10008.1.2.1", "'Other' lacks", "'truncated' has two entries",
                 "no entry of the reason 'bad-header'", "index.md does not list two.md",
                 "two.md does not begin", "de/one.md has other headings", "de/one.md has other links", "de/three.md translates no page", "no page for the panel 'twoSection'"):
        assert any(part in line for line in wrong), (part, wrong)


if sys.argv[1] == "--plant":
    plant(pathlib.Path(sys.argv[2]))
else:
    reasons, panels, wrong = check(pathlib.Path(sys.argv[1]))
    sys.exit(1 if wrong or reasons < 80 or panels < 5 else 0)
