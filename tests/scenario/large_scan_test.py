#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Touches a raw NRRD of 8 GiB, which no memory of the program's own ever holds.

Usage: large_scan_test.py PALPATE_CLI

The file is sparse: a ball near its middle, and holes. The hand must feel the ball at full
resolution, where it is, and RssAnon must stay below 2 GiB all the while.
"""
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

DIMS = (2048, 2048, 1024)
BYTES = 2 * DIMS[0] * DIMS[1] * DIMS[2]
CENTRE, RADIUS = (1030.0, 1000.0, 500.0), 40.0  # voxels
SPACING_MM = 0.5
TOOL_MM = 2.5  # radius
MOST_ANON_KB = 2 << 20
HEADER = f"""NRRD0005
type: int16
dimension: 3
sizes: {DIMS[0]} {DIMS[1]} {DIMS[2]}
space: left-posterior-superior
space directions: ({SPACING_MM},0,0) (0,{SPACING_MM},0) (0,0,{SPACING_MM})
space origin: (0,0,0)
endian: little
encoding: raw
data file: large.raw
"""


def write_ball(path):
    """The signed distance, three voxels to either side of the surface, times 1000 and about 3000."""
    reach = int(RADIUS) + 4
    with open(path, "wb") as file:
        file.truncate(BYTES)
        for k in range(int(CENTRE[2]) - reach, int(CENTRE[2]) + reach + 1):
            for j in range(int(CENTRE[1]) - reach, int(CENTRE[1]) + reach + 1):
                first = int(CENTRE[0]) - reach
                row = []
                for i in range(first, first + 2 * reach + 1):
                    depth = RADIUS - math.dist((i, j, k), CENTRE)
                    row.append(round(3000 + 1000 * max(-3.0, min(3.0, depth))))
                file.seek(2 * ((k * DIMS[1] + j) * DIMS[0] + first))
                file.write(struct.pack(f"<{len(row)}h", *row))
    return os.stat(path).st_blocks * 512


def run(command):
    """What it printed, the exit code, seconds, and the most kilobytes of its own."""
    with tempfile.TemporaryFile() as out:
        began = time.monotonic()
        child = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL)
        most = 0
        while child.poll() is None:
            try:
                for line in open(f"/proc/{child.pid}/status"):
                    if line.startswith("RssAnon:"):
                        most = max(most, int(line.split()[1]))
            except OSError:
                pass
            time.sleep(0.02)
        out.seek(0)
        return json.loads(out.read()), child.returncode, time.monotonic() - began, most


def main():
    cli = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        try:
            stored = write_ball(folder / "large.raw")
        except OSError as error:
            print(f"NOT CHECKED: no file of 8 GiB can be made here ({error.strerror})")
            return 77
        if stored > 1 << 28:
            print("NOT CHECKED: this file system knows no holes")
            return 77
        (folder / "large.nhdr").write_text(HEADER)
        said, code, seconds, most = run(
            [cli, "run", "--volume", str(folder / "large.nhdr"), "--isovalue", "3000", "--tool",
             "sphere", "--hand", "tap", "--seconds", "2", "--stiffness", "1000", "--json",
             "--trace", str(folder / "trace.csv")])
        print(f"{seconds:.0f} s, RssAnon {most / 1024:.0f} MiB at most; {said}")
        wrong = []
        if code != 0:
            wrong.append(f"exit code {code}")
        if most > MOST_ANON_KB:
            wrong.append(f"RssAnon of {most} kB")
        if not said.get("contact_ticks"):
            wrong.append("nothing was touched")
        if said.get("max_penetration_mm") != 0.0:
            wrong.append("the proxy entered the surface")
        # in contact, the tool's own sphere and the ball touch each other
        distances = []
        for line in open(folder / "trace.csv").readlines()[1:]:
            row = [float(x) for x in line.split(",")]
            if row[-1] > 0:
                proxy_mm = [1e3 * x for x in row[8:11]]
                centre_mm = [SPACING_MM * c for c in CENTRE]
                distances.append(math.dist(proxy_mm, centre_mm) - RADIUS * SPACING_MM)
        if distances and max(abs(d - TOOL_MM) for d in distances) > 0.1 * SPACING_MM:
            wrong.append(f"the surface was met {min(distances)} to {max(distances)} mm from the ball")
        print("\n".join(wrong) or "The ball was felt where it is.")
        return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
