#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of hid_fuzz: what each device sends when all is well, and a little that is not.

Usage: make_hid_seeds.py [FOLDER]   (default: corpus/hid, beside this file)
"""
import pathlib
import struct
import sys

CAP, SPACENAV, POLHEM = 0, 1, 2
REST = (8312, -10366, 19764, 0, 30, 0)


def reports(kind, *parts):
    """The parts, each behind its length."""
    return bytes([kind]) + b"".join(bytes([len(part)]) + part for part in parts)


def axes(number, *values):
    return struct.pack(f"<B{len(values)}h", number, *values)


def event(*values):
    return struct.pack("<8i", *values, *([0] * (8 - len(values))))


def arm(counts, asks=0, button=False):
    counts = list(counts)
    counts[3] += 10000 if button else 0
    return struct.pack("<7h", *counts, asks).ljust(64, b"\0")


WORK = (2000, -6000, 14000, 40, -60, 120)
WAY = [tuple(round(r + (w - r) * i / 20) for r, w in zip(REST, WORK)) for i in range(21)]
SEEDS = {
    "cap-wired": reports(CAP, axes(1, 350, 0, -20), axes(2, 32, 0, 23), bytes([3, 1, 0]),
                         axes(1, 0, 0, 0), axes(2, 0, 0, 0)),
    "cap-wireless": reports(CAP, axes(1, 1, -2, 3, -350, 350, 26), bytes([3, 1, 16, 192, 7])),
    "cap-noise": reports(CAP, bytes(range(1, 65)), b"\x01", b"", axes(2, 1001, -32768, 0)),
    "spacenav": reports(SPACENAV, event(0, 350, -20, 3, 0, 30, 0, 8), event(1, 2, 1),
                        event(2, 2, 0), event(3, 1), event(0x7faa3000)),
    "spacenav-in-pieces": reports(SPACENAV, *(event(0, 100, 0, 0, 0, -2**31, 7, 8)[i:i + 5]
                                              for i in range(0, 32, 5))),
    "polhem": reports(POLHEM, arm((0,) * 6), arm((0,) * 6, 1), arm(REST),
                      *(arm(counts) for counts in WAY)),
    "polhem-button": reports(POLHEM, arm((5,) * 6), arm((5,) * 6, 0, True), arm(REST, 0, True),
                             arm(REST), b"short", arm(REST), arm(WORK)),
}

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1
                      else pathlib.Path(__file__).resolve().parent / "corpus/hid")
folder.mkdir(parents=True, exist_ok=True)
for name, content in SEEDS.items():
    (folder / name).write_bytes(content)
