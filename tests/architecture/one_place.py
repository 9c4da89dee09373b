#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where a colour of the window is written elsewhere than in ui/style, a style sheet is set, or
a field for a number is not a NumberBox.

Usage: one_place.py ROOT
       one_place.py --plant SCRATCH   (proves that it can fail)

Every source of ui, and those of app that make widgets, are read: a colour in hexadecimal, a QColor
with numbers, one of Qt's named colours, numbers given to VTK as a colour, and Qt's own fields for
numbers, which take "0,5" for 5 in English.
"""
import pathlib
import re
import shutil
import sys

FOLDERS = ("ui", "app/window")
HERE = ("ui/style/", "ui/controls/number_box.")
LITERALS = {
    "a colour in hexadecimal": re.compile(r'"[^"\n]*#[0-9a-fA-F]{6}\b'),
    "a QColor of numbers": re.compile(r"\bQColor\s*\w*\s*[({]\s*(?:0x[0-9a-fA-F]+|\d+)\s*,"),
    "a colour that Qt names": re.compile(
        r"\bQt::(?:white|black|red|green|blue|cyan|magenta|yellow|gray|grey|dark\w+|light[Gg]r[ae]y)\b"),
    "rgb() or rgba() of numbers": re.compile(r"\brgba?\(\s*\d|\bqRgba?\(\s*\d"),
    "numbers as a colour of VTK": re.compile(r"\bSet\w*(?:Color|Background\w*)\(\s*\d*\.\d+\s*,"),
    "a style sheet": re.compile(r"\bsetStyleSheet\("),
    "a field for a number": re.compile(
        r"\bnew Q(?:Double)?SpinBox\b|\bpublic Q(?:Double)?SpinBox\b|\bQInputDialog::get(?:Double|Int)\b"),
}


def literals(root):
    """(what is found as "file:line: kind", how many files were read)"""
    found, files = [], 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix not in (".h", ".cpp") or name.startswith(HERE):
                continue
            files += 1
            for number, line in enumerate(path.read_text().splitlines(), 1):
                code = line.split("//")[0]
                found += [f"{name}:{number}: {kind}" for kind, literal in LITERALS.items()
                          if literal.search(code)]
    return found, files


def plant(scratch):
    """Each kind of literal is found once, and none in ui/style or a comment."""
    shutil.rmtree(scratch, ignore_errors=True)
    (scratch / "ui/style").mkdir(parents=True)
    (scratch / "app/window").mkdir(parents=True)
    planted = ('const double d = QInputDialog::getDouble(this, "Thickness", "mm");',
               'const char* c = "background: #c81e1e";', "const QColor kInk{238, 150, 255};",
               "painter.fillRect(rect(), Qt::black);", 'const char* d = "rgba(16, 18, 22, 170)";',
               "look->SetColor(1.0, 0.85, 0.2);", 'off->setStyleSheet("padding: 6px");')
    (scratch / "ui/planted.cpp").write_text("\n".join(planted) + "\n// Qt::red\n")
    (scratch / "ui/style/look.h").write_text(planted[2] + "\n")
    found, files = literals(scratch)
    kinds = sorted(line.split(": ", 1)[1] for line in found)
    if kinds != sorted(LITERALS) or files != 1:
        sys.exit(f"what was planted was not found: {found}")
    print(f"{len(found)} planted lines were found.")


if __name__ == "__main__":
    if sys.argv[1] == "--plant":
        plant(pathlib.Path(sys.argv[2]))
    else:
        wrong, read = literals(pathlib.Path(sys.argv[1]))
        if wrong:
            sys.exit("\n".join(wrong) + "\nColours belong in ui/style, numbers in a NumberBox.")
        print(f"{read} files have no colour and no field for a number of their own.")
