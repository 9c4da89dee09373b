#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where a message has no row in resources/messages, a row no message, or one of them another
number of arguments than the other; and where a library has a sentence that is no row.

Usage: messages.py ROOT
       messages.py --plant SCRATCH   (proves that it can fail)

A message is {"id", {arguments}} in the source. Code that has an id in other ways is not found.
"""
import pathlib
import re
import shutil
import sys

TABLES = "resources/messages"
SOURCES = ("app", "datasets", "haptics", "resources")
LIBRARIES = ("datasets", "haptics")  # all that they tell a user is in the tables
STRINGS = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'  # that the compiler joins
ID = r"[a-z0-9]+(?:-[a-z0-9]+)+"
ROW = re.compile(r'\{\s*"([^"]*)"\s*,\s*(%s)\s*(?:,\s*"[a-z-]*"\s*)?\}' % STRINGS)
MESSAGE = re.compile(r'\{\s*"(%s)"\s*,\s*\{' % ID)
SENTENCE = re.compile(r'(\\"|%|[A-Z]).* .*\.')
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|(R"(\w*)\(.*?\)\2"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\')', re.S)


def uncommented(text):
    """The text without comments; lines keep their numbers."""
    return NOT_CODE.sub(lambda m: m.group(1) or "\n" * m.group().count("\n"), text)


def joined(strings):
    return "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', strings))


def arguments(text, at):
    """How many stand between the brace before `at` and the one that closes it."""
    depth, commas, empty = 1, 0, True
    while True:
        string = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'').match(text, at)
        if string:
            at, empty = string.end(), False
            continue
        c = text[at]
        depth += (c in "([{") - (c in ")]}")
        if depth == 0:
            return 0 if empty else commas + 1
        commas += depth == 1 and c == ","
        empty = empty and c.isspace()
        at += 1


def files_in(root, folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.name.endswith((".h", ".cpp", ".cpp.in")):
                yield path.relative_to(root).as_posix(), uncommented(path.read_text())


def check(root):
    """(number of rows, number of messages, ["what is wrong", …])"""
    rows, used, messages, wrong = {}, set(), 0, []
    for name, text in files_in(root, [TABLES]):
        for row in ROW.finditer(text):
            place = f"{name}:{text.count(chr(10), 0, row.start()) + 1}"
            key, english = row.group(1), joined(row.group(2))
            if not re.fullmatch(ID, key):
                wrong.append(f"{place}: '{key}' is no id in small letters with hyphens")
            if key in rows:
                wrong.append(f"{place}: '{key}' has a row already")
            places = {int(n) for n in re.findall(r"%\(?([1-9])", english)}
            if places != set(range(1, len(places) + 1)):
                wrong.append(f"{place}: '{key}' leaves out an argument")
            rows[key] = (place, len(places))
    for name, text in files_in(root, SOURCES):
        if name.startswith(TABLES):
            continue
        for message in MESSAGE.finditer(text):
            messages += 1
            key = message.group(1)
            place = f"{name}:{text.count(chr(10), 0, message.start()) + 1}"
            if key not in rows:
                wrong.append(f"{place}: '{key}' has no row")
            elif arguments(text, message.end()) != rows[key][1]:
                wrong.append(f"{place}: '{key}' has another number of arguments than its row")
            used.add(key)
        if name.startswith(LIBRARIES):
            for strings in re.finditer(STRINGS, text):
                if SENTENCE.fullmatch(joined(strings.group())):
                    line = text.count("\n", 0, strings.start()) + 1
                    wrong.append(f"{name}:{line}: a sentence that is no row")
    wrong += [f"{place}: no message is '{key}'" for key, (place, _) in rows.items()
              if key not in used]
    for line in wrong:
        print(line)
    print(f"{len(rows)} rows, {messages} messages, {len(wrong)} wrong.")
    return len(rows), messages, wrong


def plant(scratch):
    shutil.rmtree(scratch, ignore_errors=True)

    def write(name, text):
        path = scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    table = ('    {"file-cut-off",\n     "%1 ends; \\"fetch\\" "\n     "it, %2."},\n'
             '    {"disk-full", "the disk is full"},\n    {"both-of", "%(1), and %2."},\n')
    code = ('// {"gone-too", {}}\nreturn malformed({"file-cut-off", {name(a, b), "a, \\"b"}});\n'
            'return {Kind::Full, {"both-of", {{"disk-full", {}}, Message{"disk-full", {\n}}}}};\n'
            'auto known = {"force-dimension", open};\n')
    write("resources/messages/readers.h", table)
    write("datasets/one.cpp", code)
    assert check(scratch) == (3, 4, []), "something was found that is not wrong"
    write("resources/messages/drivers.h",
          '    {"not-used", "Nobody says so."},\n    {"disk-full", "the disk is full"},\n'
          '    {"Bad", "It has %2."},\n')
    write("datasets/one.cpp", code + 'f({"no-row", {}});\nf({"disk-full", {name}});\n'
          'f("The file \\"x\\" "\n  "ends.");\n')
    wrong = check(scratch)[2]
    for part in ("drivers.h:1: no message is 'not-used'", "'disk-full' has a row already",
                 "'Bad' is no id", "'Bad' leaves out", "no message is 'Bad'",
                 "one.cpp:6: 'no-row' has no row",
                 "one.cpp:7: 'disk-full' has another number", "one.cpp:8: a sentence"):
        assert sum(part in line for line in wrong) == 1, (part, wrong)
    assert len(wrong) == 8, wrong


if sys.argv[1] == "--plant":
    plant(pathlib.Path(sys.argv[2]))
else:
    rows, messages, wrong = check(pathlib.Path(sys.argv[1]))
    sys.exit(1 if wrong or rows < 300 or messages < 300 else 0)
