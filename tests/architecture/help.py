#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where the help (resources/help) and the program do not agree: a sentence of
resources/messages without its entry, or with other words; a page that is in no list; a panel without
its page; a device without one.

Usage: help.py ROOT
       help.py ROOT --write     (puts the sentences of the catalogue into the entries)
       help.py --plant SCRATCH  (proves that it can fail)

An entry is a line "- `id`: sentence" of a page messages-*.md, in a section that says what to do.
"""
import pathlib
import re
import shutil
import sys

STRINGS = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'
ROW = re.compile(r'\{\s*"([^"]*)"\s*,\s*(%s)\s*\}' % STRINGS)
ENTRY = re.compile(r"^- `([a-z0-9-]+)`(?:: (.*))?$", re.M)


def shown(english):
    """A sentence as the help shows it: an ellipsis for each argument."""
    words = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', english)).replace('\\"', '"')
    return re.sub(r"%\(?[1-9]\)?", "…", words).strip()


def catalogue(root):
    rows = {}
    for table in sorted((root / "resources/messages").glob("*.h")):
        rows.update((m.group(1), shown(m.group(2))) for m in ROW.finditer(table.read_text()))
    return rows


def sections(text):
    """(heading, body) of each section of the second level."""
    parts = re.split(r"^## (.*)$", text, flags=re.M)
    return list(zip(parts[1::2], parts[2::2]))


def check_messages(root, write):
    rows, seen, wrong = catalogue(root), {}, []
    for page in sorted((root / "resources/help").glob("messages-*.md")):
        text = page.read_text()
        if write:
            text = ENTRY.sub(lambda m: f"- `{m.group(1)}`: {rows.get(m.group(1), m.group(2))}", text)
            page.write_text(text)
        for heading, body in sections(text):
            if not ENTRY.sub("", body).strip():
                wrong.append(f"{page.name}: '{heading}' says nothing of what to do")
        for entry in ENTRY.finditer(text):
            key, words = entry.groups()
            if key in seen:
                wrong.append(f"{page.name}: '{key}' has an entry in {seen[key]} already")
            seen[key] = page.name
            if key not in rows:
                wrong.append(f"{page.name}: no message is '{key}'")
            elif words != rows[key]:
                wrong.append(f"{page.name}: '{key}' has other words than its message")
    wrong += [f"'{key}' has no entry in the help" for key in rows if key not in seen]
    return len(rows), wrong


def check_pages(root):
    help_folder, wrong = root / "resources/help", []
    pages = {page.name for page in help_folder.glob("*.md")}
    contents = (help_folder / "index.md").read_text()
    wrong += [f"index.md does not list {name}" for name in sorted(pages)
              if name != "index.md" and f"({name})" not in contents]
    packed = (root / "resources/resources.qrc").read_text()
    wrong += [f"resources.qrc lacks help/{name}" for name in sorted(pages)
              if f"<file>help/{name}</file>" not in packed]
    for page in sorted(help_folder.glob("*.md")):
        if not page.read_text().startswith("# "):
            wrong.append(f"{page.name} does not begin with its title")
    return wrong


def check_panels(root):
    """Each section that a controller adds has a line in ui/help_window.cpp, with a page that is there."""
    table = (root / "ui/help_window.cpp").read_text()
    pages = dict(re.findall(r'\{"(\w+)", "([\w-]+)"\}', table))
    panels, wrong = set(), []
    for source in sorted((root / "app/window").glob("*.cpp")):
        panels |= set(re.findall(r'addPanel\([^;]*?"(\w+Section)"', source.read_text()))
    for name in sorted(panels):
        if name not in pages:
            wrong.append(f"ui/help_window.cpp has no page for the panel '{name}'")
    wrong += [f"ui/help_window.cpp: no page is {page}.md" for page in pages.values()
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


def check(root, write=False):
    rows, wrong = check_messages(root, write)
    panels, of_panels = check_panels(root)
    wrong += check_pages(root) + of_panels + check_hazards(root) + check_syntaxes(root)
    for line in wrong:
        print(line)
    print(f"{rows} messages, {panels} panels, {len(wrong)} wrong.")
    return rows, panels, wrong


def plant(scratch):
    shutil.rmtree(scratch, ignore_errors=True)

    def write(name, text):
        path = scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    write("resources/messages/readers.h",
          '{"cut-off", "\\"%1\\" ends; " "fetch it, %(2)."},\n{"odd-one", "It is odd."},\n')
    write("app/window/one.cpp", 'w.addPanel(p, tr("One"), tr("&One"), "oneSection", ui::Tab::Scan);')
    write("ui/help_window.cpp", '{"oneSection", "one"},')
    write("resources/resources.qrc", "<file>help/one.md</file><file>help/index.md</file>"
          "<file>help/messages-a.md</file>")
    write("resources/help/index.md", "# Help\n[one](one.md) [a](messages-a.md)\n")
    write("resources/help/one.md", "# One\n")
    good = '# A\n## Cut\n- `cut-off`: "…" ends; fetch it, ….\n- `odd-one`: It is odd.\n\nFetch.\n'
    write("resources/help/messages-a.md", good)
    assert check(scratch) == (2, 1, []), "something was found that is not wrong"
    write("resources/help/messages-a.md", good.replace("\nFetch.", "").replace("odd.", "even.")
          + "## Other\n- `cut-off`: x\n- `gone-one`: y\n\nDo.\n")
    write("resources/help/two.md", "Two\n")
    write("app/window/two.cpp", 'w.addPanel(p, tr("Two"), tr("T"),\n "twoSection", ui::Tab::Scan);')
    write("resources/help/hazards.md", "# H\n`Hazards.IsThere` `Hazards.IsNot`\n")
    write("tests/one.cpp", "TEST(Hazards, IsThere) {}\n")
    write("resources/help/dicom-conformance.md", "# D\n| 1.2.840.10008.1.2 |\n")
    write("datasets/readers/dicom/one.cpp", '"1.2.840.10008.1.2.1"')
    wrong = check(scratch)[2]
    for part in ("no test Hazards.IsNot", "differ on 1.2.840.10008.1.2.1", "'Cut' says nothing", "'odd-one' has other words", "'cut-off' has an entry",
                 "no message is 'gone-one'", "index.md does not list two.md", "lacks help/two.md",
                 "two.md does not begin", "no page for the panel 'twoSection'"):
        assert any(part in line for line in wrong), (part, wrong)
    write("resources/help/messages-a.md", good.replace("- `odd-one`: It is odd.\n", ""))
    assert any("'odd-one' has no entry" in line for line in check(scratch)[2])


if sys.argv[1] == "--plant":
    plant(pathlib.Path(sys.argv[2]))
else:
    rows, panels, wrong = check(pathlib.Path(sys.argv[1]), "--write" in sys.argv)
    sys.exit(1 if wrong or rows < 300 or panels < 5 else 0)
