#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every hand on a made scan and every real one for a long time, soft, at the stiffness that is allowed, and beyond.

long_hands.py CLI SCANS [--seconds S] [--stiffness 50,allowed,20000] [--only NAME] [--hands A,B] [--log FILE]

At what is allowed, a run must end with 0: every number finite, no shell point ever inside, no force
above the bound. Beyond it, `run` must say so at the start, and end with 0, or with 4 at the first
number that is not finite. Runs that FILE already holds are not run again, so a study that was
stopped goes on. Twenty simulated minutes take one to two of a core.
Exit 0 when every run holds, 1 otherwise, 77 (skipped) where the scans are absent.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from touch_scans import HANDS, SCANS, volume_of

# N: a coupling of 7200 N/m, the stiffest that is allowed, that a hand stretches by 50 mm
MOST_FORCE = 360.0


def begun(cli, volume, isovalue, tool, hand, seconds, stiffness):
    command = [cli, "run", "--volume", volume, "--isovalue", str(isovalue), "--tool", tool, "--hand", hand,
               "--seconds", seconds, "--stiffness", str(stiffness), "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout), done.stderr


def missed(code, report, said, stiffness):
    """What does not hold, in words."""
    allowed = report["allowed_stiffness_N_m"]
    wrong = []
    if report["max_penetration_mm"] != 0.0:
        wrong.append(f"penetration {report['max_penetration_mm']} mm")
    if stiffness <= allowed:
        if code != 0 or report["nonfinite"] != 0:
            wrong.append(f"exit {code}, {report['nonfinite']} not finite")
        if not report["max_force_N"] <= MOST_FORCE:
            wrong.append(f"force {report['max_force_N']} N")
    else:
        if "more than the" not in said:
            wrong.append("not a word about what is allowed")
        if (code, report["nonfinite"]) not in ((0, 0), (4, 1)):
            wrong.append(f"exit {code}, {report['nonfinite']} not finite")
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cli")
    parser.add_argument("scans", type=pathlib.Path)
    parser.add_argument("--seconds", default="1200")
    parser.add_argument("--stiffness", default="allowed,50,20000")
    parser.add_argument("--only")
    parser.add_argument("--hands", default=",".join(HANDS))
    parser.add_argument("--log", type=pathlib.Path)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        return all_runs(args, pathlib.Path(work))


def all_runs(args, work):
    kept, volumes = {}, {}
    for name in SCANS:
        if args.only in (None, name):
            volumes[name] = volume_of(name, args.scans, work)
    if absent := [name for name, volume in volumes.items() if volume is None]:
        print(f"NOT CHECKED: {', '.join(absent)} are not in {args.scans}")
    if args.log and args.log.exists():
        for line in args.log.read_text().splitlines():
            row = json.loads(line)
            kept[row["run"]] = row
    for wish in args.stiffness.split(","):
        for name, volume in volumes.items():
            if volume is None:
                continue
            _, isovalue, tool, _ = SCANS[name]
            stiffness = float(wish) if wish != "allowed" else None
            for hand in args.hands.split(","):
                run = f"{name} {hand} {wish} {args.seconds}"
                if run not in kept:
                    if stiffness is None:  # what a short run says is allowed
                        told = begun(args.cli, volume, isovalue, tool, hand, "0.1", 50)[1]
                        stiffness = told["allowed_stiffness_N_m"]
                    code, report, said = begun(args.cli, volume, isovalue, tool, hand, args.seconds, stiffness)
                    kept[run] = {"run": run, "stiffness": stiffness, "exit": code, "ticks": report["ticks"],
                                 "max_force_N": report["max_force_N"], "nonfinite": report["nonfinite"],
                                 "max_penetration_mm": report["max_penetration_mm"],
                                 "missed": missed(code, report, said, stiffness)}
                    if args.log:
                        with args.log.open("a") as log:
                            log.write(json.dumps(kept[run]) + "\n")
                row = kept[run]
                print(f"{name:13} {hand:6} {row['stiffness']:6.0f} N/m  {row['ticks']:8} ticks  most force "
                      f"{row['max_force_N']:.4g} N  exit {row['exit']}  "
                      f"{'FAILED: ' + ', '.join(row['missed']) if row['missed'] else 'held'}", flush=True)
    return 1 if any(row["missed"] for row in kept.values()) else 77 if absent else 0


if __name__ == "__main__":
    sys.exit(main())
