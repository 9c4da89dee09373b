#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of recording_fuzz: a small recording, a torn one, and each part by itself.

Usage: make_recording_seeds.py [FOLDER]   (default: corpus/recording, beside this file)
"""
import json
import pathlib
import re
import sqlite3
import struct
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
SCHEMA = re.search(r'R"\((.*?)\)"', (HERE / "../../app/recording/schema.h").read_text(),
                   re.S).group(1)
# widths of the columns of a step and of a contact, as app/recording/block.cpp has them
STEP_WIDTH = 38 * 8 + 3 * 4 + 4
CONTACT_WIDTH = 7 * 4
STEP_COLUMNS = 38 + 3 + 3
CONTACT_COLUMNS = 7
NOTHING = bytes([0, 0])  # a column of differences that are all zero

START = json.dumps({
    "scene": 1, "proxy": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], "turn": [0, 0, 0],
    "limits": {"force": 12, "torque": None, "ramp_time": 1, "slew_time": 0.02, "rise_time": 0.002,
               "continuous_force": None, "guard_passivity": True},
    "force_state": 4, "reason": 1, "withheld": 0, "let_go": False, "gain": 1, "slewing": False,
    "slew_left": 0, "heat": 0, "sent_force": [0, 0, 0], "sent_torque": [0, 0, 0],
    "passivity": {"device": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], "begun": False, "waited": 0,
                  "slow_linear": [0, 0, 0], "slow_angular": [0, 0, 0], "slow_force": [0, 0, 0],
                  "slow_torque": [0, 0, 0], "made": 0, "turns": 0, "power": 0, "power_before": 0, "direction": 0, "since": 0,
                  "share": 1}})
SETTINGS = json.dumps({
    "field": "trilinear", "normal": "central",
    "plan": {name: True for name in ("free_space", "empty_space", "unspent_room", "far_gradients",
                                     "central_differences", "still_rows")},
    "epsilon": 0.05, "sub_steps": 8, "points": 1, "vertices": 1, "triangles": 0,
    "shell_radius_m": 0.001, "shell_inertia_m2": [1, 0, 0, 0, 1, 0, 0, 0, 1],
    "shell_spacing_m": 0, "shell_origin_m": [0, 0, 0]})
VOLUME = json.dumps({
    "dims": [8, 8, 8], "spacing_m": [0.001] * 3, "origin_m": [0, 0, 0],
    "direction": [1, 0, 0, 0, 1, 0, 0, 0, 1], "scalar": "int16", "least": 0, "greatest": 100,
    "unit": "HU", "modality": "CT", "orientation_known": True, "resampled": False,
    "slices_left_out": 0})
POINT = struct.pack("<3d", 0.0, 0.0, 0.001)


def rounded_steps(count, contacts):
    """Zeros but for the number of contacts, each, and the check, once differenced."""
    return (NOTHING * (STEP_COLUMNS - 1) + bytes([0, 1]) + bytes([2 * contacts] * count) +
            bytes([1, 1]) + struct.pack("<Q", 10) + bytes([1] * (count - 1)))


def recording(steps=3, contacts=2, rounded=False):
    """A whole file, of the smallest pages."""
    if rounded:
        version, contacts = 4, steps
        step_data, contact_data = rounded_steps(steps, 1), NOTHING * CONTACT_COLUMNS
    else:
        version = 2
        step_data, contact_data = bytes(steps * STEP_WIDTH), bytes(contacts * CONTACT_WIDTH)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "r"
        base = sqlite3.connect(path)
        base.executescript("PRAGMA page_size = 512; PRAGMA application_id = 1346456656;"
                           f"PRAGMA user_version = {version};" + SCHEMA)
        base.executemany("INSERT INTO meta VALUES (?, ?)",
                         [("palpate", "0.1.0"), ("build", "x"), ("vectors", "AVX2")])
        base.execute("INSERT INTO step VALUES (0, ?, 0, ?, ?)",
                     (steps, steps, zlib.compress(step_data)))
        if contacts:
            base.execute("INSERT INTO contact VALUES (0, ?, ?)",
                         (contacts, zlib.compress(contact_data)))
        base.execute("INSERT INTO event VALUES (1, 0, 0, 'start', NULL, ?)", (START,))
        base.execute("INSERT INTO event VALUES (2, 0, 0, 'isovalue', 300.0, NULL)")
        point = zlib.compress(POINT)
        base.execute("INSERT INTO scene VALUES (1, 'probe', ?, ?, NULL, ?, ?, ?)",
                     (SETTINGS, VOLUME, point, point, zlib.compress(b"")))
        base.commit()
        base.close()
        return path.read_bytes()


CROP = '{"edit":"crop","end":[9,8,7],"first":[0,1,2]}'
LASSO = ('{"camera":[1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.5],"edit":"lasso","from_m":0.0,'
         '"inside":true,"isovalue":300.0,"outline":[0.0,0.0,0.1,0.0,0.0,0.1],"parallel":false,'
         '"until_m":1.0}')


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else HERE / "corpus/recording")
    folder.mkdir(parents=True, exist_ok=True)
    whole = recording(contacts=0)
    seeds = {
        "file": b"\0" + whole,
        "file-contacts": b"\0" + recording(),
        "file-torn": b"\0" + whole[: len(whole) // 2],
        "part": b"\1" + whole,
        "start": b"\2" + START.encode(),
        "scene": b"\3" + SETTINGS.encode() + b"\n" + VOLUME.encode() + b"\n" + POINT,
        "block": b"\4" + bytes([2, 0, 0, 0]) + bytes(2 * STEP_WIDTH),
        "block-contacts": b"\4" + bytes([1, 1, 0, 7]) + bytes(CONTACT_WIDTH + STEP_WIDTH - 1) + b"\1",
        "file-rounded": b"\0" + recording(rounded=True),
        "block-rounded": b"\6" + bytes([3, 0, 0, 0]) + rounded_steps(3, 0),
        "block-rounded-contacts": b"\6" + bytes([2, 2, 0, 4]) + bytes([0, 1, 4, 6]) +
                                  NOTHING * (CONTACT_COLUMNS - 1) + rounded_steps(2, 1),
        "edit-crop": b"\5" + CROP.encode(),
        "edit-lasso": b"\5" + LASSO.encode(),
        "text": b"\0this is no recording",
    }
    for name, seed in seeds.items():
        (folder / name).write_bytes(seed)


main()
