#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Brings resources/translations/palpate_*.ts up to date with the sources, or checks them.

Usage: update.py ROOT           (writes: new sentences come as unfinished, gone ones go)
       update.py ROOT --check   (writes nothing; fails where the two differ, or a language is wrong)
       update.py --plant ROOT SCRATCH   (proves that the check can fail)

lupdate finds what is in tr(). The rest is listed here for it: the rows of resources/messages (context
"Messages"), the arguments of functions that call translate() with one of their own parameters, and of
macros that stand for QT_TRANSLATE_NOOP, the formats of exports, and the names of
tools, phantoms and devices.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

STRINGS = r'("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)'  # that the compiler joins
FOLDERS = ("app", "ui")
COMMENT = re.compile(r'//[^\n]*|("(?:[^"\\\n]|\\.)*")')
ROW = re.compile(r'\{\s*"[^"]*"\s*,\s*%s\s*(?:,\s*"[a-z-]*"\s*)?\}' % STRINGS)
OWN = re.compile(r'translate\(\s*"([^"]+)"\s*,\s*(\w+)\)')
MACRO = re.compile(r'#define (\w+)\(\w+\) QT_TRANSLATE_NOOP\("([^"]+)"')
FORMAT = re.compile(r'\{\s*"\w+",\s*"[^"]*",\s*%s,\s*%s,\s*%s' % (STRINGS, STRINGS, STRINGS))
TOOL = re.compile(r'^\s*"[a-z0-9-]+\|([^|"]+)\|([^|"]+)\|[0-9.]+"', re.M)
DEVICE = re.compile(r'\bkName(?: = |\{)("[^"]+")')
PHANTOM = re.compile(r'\{("\w+"), \w+Phantom\}')
STRUCTURE = re.compile(r'(?:\badd\(|\{)("[A-Z][a-z]+(?: [a-z]+)*"),\s*\{\d')
PLACE = re.compile(r"%(?:L?[1-9]|\([1-9]\)|n)")
TAG = re.compile(r"</?\w+>")
QT = ("/usr/lib/qt6/bin", "/usr/lib/qt6/libexec")


def tool(name):
    found = shutil.which(name, path=":".join(QT)) or shutil.which(name)
    if not found:
        print(f"{name} is not there; install qt6-l10n-tools.")
        sys.exit(77)
    return found


def uncommented(path):
    return COMMENT.sub(lambda m: m.group(1) or "", path.read_text())


def unseen(root):
    """[(context, C++ string)] that lupdate does not find by itself."""
    found = []
    for table in sorted((root / "resources/messages").glob("*.h")):
        found += [("Messages", row) for row in ROW.findall(uncommented(table))]
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.cpp")):
            text = uncommented(path)
            for own in OWN.finditer(text):
                context, parameter = own.groups()
                made = re.findall(r'(\w+)(?:\s*=\s*\[[^\]]*\])?\(const char\*\s*%s\b' % parameter,
                                  text[:own.start()])
                if made:
                    calls = re.findall(r'\b%s\(\s*%s' % (made[-1], STRINGS), text)
                    found += [(context, call) for call in calls]
            for name, context in MACRO.findall(text):
                found += [(context, words) for words in re.findall(r"\b%s\(%s" % (name, STRINGS), text)]
    for row in FORMAT.findall(uncommented(root / "app/export/export.h")):
        found += [("app::exporting", word) for word in row]
    for use, title in TOOL.findall((root / "resources/CMakeLists.txt").read_text()):
        found += [("app::ToolController", f'"{word}"') for word in (use, title)]
    for name in PHANTOM.findall((root / "datasets/phantoms/phantoms.cpp").read_text()):
        found.append(("app::phantomTitle", name))
    for path in sorted((root / "datasets/phantoms").glob("*.cpp")):
        found += [("app::structureTitle", name) for name in STRUCTURE.findall(uncommented(path))]
    for path in sorted((root / "haptics/devices").glob("*.cpp")):
        found += [("app::DeviceWatch", name) for name in DEVICE.findall(path.read_text())]
    return list(dict.fromkeys(found))


def update(root, ts, folder):
    """Lets lupdate do it, in `ts`."""
    listed = folder / "unseen.cpp"
    listed.write_text("".join(f'const char* s{n} = QT_TRANSLATE_NOOP("{context}", {text});\n'
                              for n, (context, text) in enumerate(unseen(root))))
    done = subprocess.run(
        [tool("lupdate"), "-silent", "-I.", "-no-obsolete", "-no-ui-lines", "-locations", "none",
         *FOLDERS, str(listed), "-ts", str(ts)],
        cwd=root, capture_output=True, text=True)
    if done.returncode != 0 or "lacks Q_OBJECT" in done.stderr or "Qualifying" in done.stderr:
        sys.exit(done.stderr or "lupdate failed")


def entries(ts):
    """{(context, source, comment): (translations, is_finished)}"""
    found = {}
    for context in ElementTree.parse(ts).iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.findall("numerusform")]
            found[(context.findtext("name"), message.findtext("source") or "",
                   message.findtext("comment") or "")] = (
                forms or [translation.text or ""], translation.get("type") is None)
    return found


def same(pattern, a, b):
    return sorted(pattern.findall(a)) == sorted(pattern.findall(b))


def faults(key, translations, finished):
    """What is wrong with one entry."""
    source = key[1]
    for text in translations:
        if not finished or (source.strip() and not text.strip()):
            yield "is not translated"
        elif not same(PLACE, source, text):
            yield "has other places of arguments"
        elif not same(TAG, source, text):
            yield "has other tags"
        elif (source[:1] == " ", source[-1:] == " ") != (text[:1] == " ", text[-1:] == " "):
            yield "begins or ends with a space where the other does not"
        elif source.endswith("…") != text.endswith("…") and not text.endswith("…)"):
            yield "ends with an ellipsis where the other does not"
        elif bool(re.search(r"&\w", source)) != bool(re.search(r"&\w", text)):
            yield "has a letter for the keyboard where the other has none"
        elif source.endswith(".") != text.endswith("."):
            yield "ends with a full stop where the other does not"
        elif ";;" in source and re.findall(r"\(.*?\)", source) != re.findall(r"\(.*?\)", text):
            yield "has other kinds of files"


def check(root, folder):
    wrong, count = [], 0
    for ts in sorted((root / "resources/translations").glob("palpate_*.ts")):
        fresh = folder / ts.name
        shutil.copy(ts, fresh)
        update(root, fresh, folder)
        stored, wanted = entries(ts), entries(fresh)
        count += len(wanted)
        for key in wanted.keys() - stored.keys():
            wrong.append(f"{ts.name}: {key[0]}: \"{key[1]}\" is missing; run update.py")
        for key in stored.keys() - wanted.keys():
            wrong.append(f"{ts.name}: {key[0]}: \"{key[1]}\" is in no source; run update.py")
        for key, (translations, finished) in stored.items():
            wrong += [f"{ts.name}: {key[0]}: \"{key[1]}\" {fault}"
                      for fault in faults(key, translations, finished)]
    print("\n".join(sorted(wrong) + [f"{count} entries, {len(wrong)} wrong."]))
    return wrong, count


def plant(root, scratch):
    shutil.rmtree(scratch, ignore_errors=True)
    for name in (*FOLDERS, "datasets/phantoms", "haptics/devices", "resources/messages", "resources/translations"):
        shutil.copytree(root / name, scratch / name)
    shutil.copy(root / "resources/CMakeLists.txt", scratch / "resources")
    ts = scratch / "resources/translations/palpate_de.ts"
    text = ts.read_text()

    def change(pattern, how):
        nonlocal text
        found = next(m for m in re.finditer(r"<message>.*?</message>", text, re.S)
                     if re.search(pattern, m.group(), re.S))
        text = text[:found.start()] + how(found.group()) + text[found.end():]

    change("%1.*%2.*<translation>", lambda m: re.sub(r"%2(?=.*</translation>)", "%3", m))
    change("&amp;Undo<", lambda m: re.sub(r"(<translation>.*?)&amp;", r"\1", m))
    change("ve picture…", lambda m: m.replace("…</translation>", "</translation>"))
    change("Half of the ticks", lambda m: m.replace("<translation>", '<translation type="unfinished">'))
    change("has %2 components, not one", lambda m: "")
    ts.write_text(text)
    for name, before, after in (
            ("ui/window/tour.cpp", 'tr("Skip")', 'tr("Skip it all")'),
            ("ui/controls/bindings.cpp", 'bindingWords("replay bar")', 'bindingWords("bar of the replay")')):
        path = scratch / name
        assert before in path.read_text(), name
        path.write_text(path.read_text().replace(before, after))
    with tempfile.TemporaryDirectory() as folder:
        wrong, _ = check(scratch, pathlib.Path(folder))
    planted = ("other places of arguments", "a letter for the keyboard", "an ellipsis",
               "is not translated", "components, not one\" is missing", "Skip it all\" is missing",
               "Skip\" is in no source", "bar of the replay\" is missing",
               "replay bar\" is in no source")
    for part in planted:
        assert any(part in line for line in wrong), part
    assert len(wrong) == len(planted), wrong


def main():
    if sys.argv[1] == "--plant":
        return plant(pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]))
    root = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        if "--check" in sys.argv:
            wrong, count = check(root, pathlib.Path(folder))
            sys.exit(1 if wrong or count < 1000 else 0)
        for ts in sorted((root / "resources/translations").glob("palpate_*.ts")):
            update(root, ts, pathlib.Path(folder))
            print(f"{ts.name}: {sum(not f for _, f in entries(ts).values())} unfinished")


main()
