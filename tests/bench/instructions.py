#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of a tick on a fixed trace of each scene, under valgrind's callgrind.

Usage: instructions.py PALPATE_TRACE KEPT.json [--keep] [--only SCENE]

A slow-down shows without a clock: the counts are compared with those kept, and more than 5 % of
difference fails. --keep writes them down instead. The vectors are those valgrind offers (AVX2),
the same on every machine that has them; compiler and flags are the build's, so compare like with
like. Takes a minute or two a scene.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCENES = ["bunny", "engine", "hole", "bone", "uncut", "burr"]
TOLERANCE = 0.05
BURR_TOLERANCE = 0.02  # of a burr that is not held, over the same trace without one


def counted(trace, scene):
    """Instructions and counted work a tick."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={out}",
             trace, scene], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            sys.exit(f"{scene}: valgrind exits {run.returncode}: {run.stderr[-500:]}")
        told = json.loads(run.stdout)
        total = int(re.search(r"^totals: (\d+)", out.read_text(), re.M).group(1))
    return {"instructions_per_tick": round(total / told["ticks"]),
            "work_per_tick": round(told["work"] / told["ticks"], 1), "ticks": told["ticks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("trace")
    parser.add_argument("kept", type=pathlib.Path)
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--only")
    options = parser.parse_args()
    kept = json.loads(options.kept.read_text()) if options.kept.exists() else {}
    worse = 0
    for scene in SCENES:
        if options.only and scene != options.only:
            continue
        now = counted(options.trace, scene)
        line = f"{scene:8} {now['instructions_per_tick']:9} instructions a tick"
        line += f", work {now['work_per_tick']}"
        if scene in kept:
            change = now["instructions_per_tick"] / kept[scene]["instructions_per_tick"] - 1.0
            line += f", {100 * change:+.1f} % against what was kept"
            worse += abs(change) > TOLERANCE and not options.keep
        print(line, flush=True)
        kept[scene] = now
        if scene == "burr" and "uncut" in kept:
            more = now["instructions_per_tick"] / kept["uncut"]["instructions_per_tick"] - 1.0
            print(f"a burr that is not held: {100 * more:+.2f} %")
            worse += more > BURR_TOLERANCE
    if options.keep:
        options.kept.write_text(json.dumps(kept, indent=1) + "\n")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
