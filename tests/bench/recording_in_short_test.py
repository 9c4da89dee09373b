#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An hour of recording in a few seconds: no gap, every step there, at most 300 bytes each.

Use: recording_in_short_test.py PALPATE-RECORDING FOLDER
"""
import json
import shutil
import subprocess
import sys

program, folder = sys.argv[1:]
shutil.rmtree(folder, ignore_errors=True)
said = subprocess.run([program, folder, "--live", "3", "--fast", "40"], capture_output=True,
                      text=True, check=True).stdout
figures = json.loads(said)
live, fast = figures["live"], figures["as_fast_as_possible"]
for part, least in ((live, 2000), (fast, 40000)):
    file = part["file"]
    assert file["gaps"] == 0, part
    assert file["steps"] >= least, part
    assert file["bytes_per_step"] <= 300, part
assert fast["file"]["steps"] == 40000, fast
shutil.rmtree(folder)
print(json.dumps({"live": live["file"], "fast": fast["file"]}, indent=1))
