#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a language that nobody speaks: every letter with an accent, and two fifths more of them. A
test shows the window in it. What is still without an accent is not translated, and what is cut off
has too little room for other languages.

Usage: pseudo.py SOURCES.ts PSEUDO.ts   (the sources of a translation, whatever its own words)
"""
import math
import re
import sys
import xml.etree.ElementTree as ElementTree

PLAIN = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
ACCENTED = "áƀčďéƒğĥíĵķĺḿñóṕɋŕšťúṽŵẋýžÁƁČĎÉƑĞĤÍĴĶĹḾÑÓṔɊŔŠŤÚṼŴẊÝŽ"
LONGER = 0.4
# places of arguments, tags, and the kinds of files of a dialog stay as they are; of the rest, words
PARTS = re.compile(r"(%(?:L?[1-9]|\([1-9]\)|n)|</?\w+>|\([^()]*\*[^()]*\)|[^\W\d_]+)")


def pseudo(text):
    parts = PARTS.split(text)
    words = [i for i, part in enumerate(parts) if part.isalpha()]
    missing = math.ceil(LONGER * sum(len(part) for i, part in enumerate(parts) if i % 2 == 0 or i in words))
    for i in words:
        made = ""
        for n, c in enumerate(parts[i]):
            made += ACCENTED[PLAIN.index(c)] if c in PLAIN else c
            # not the letter of the keyboard, which would then stand there twice
            if missing > 0 and c in "aeiouyAEIOUY" and not (n == 0 and parts[i - 1].endswith("&")):
                made += made[-1].lower()
                missing -= 1
        parts[i] = made
    for n in range(missing if words else 0):
        parts[words[n % len(words)]] += "é"
    return "".join(parts)


def main():
    tree = ElementTree.parse(sys.argv[1])
    tree.getroot().set("language", "en_GB")  # of two forms, as German
    for message in tree.iter("message"):
        words = pseudo(message.findtext("source") or "")
        translation = message.find("translation")
        translation.attrib.pop("type", None)
        forms = translation.findall("numerusform")
        for form in forms or [translation]:
            form.text = words
    tree.write(sys.argv[2], encoding="utf-8", xml_declaration=True)


main()
