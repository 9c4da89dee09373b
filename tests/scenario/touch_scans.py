#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every hand on a made scan and every real one, judged by the evaluator that shares no code with Palpate.

touch_scans.py CLI EVALUATOR SCANS WORK [--only NAME] [--hands tap,slide] [--seconds S]
touch_scans.py CLI EVALUATOR SCANS WORK --cut [--only NAME] [--hands mill] [--seconds S]

With --cut a burr cuts, the evaluator carries out the recorded cuts itself, and phantoms are cut, too. Each run
is repeated. Ticks have five times the usual counted budget: one that the budget ends may leave a part of a cut,
and which part is not recorded. With PALPATE_TEST_ALL all hands cut, with 1000 and 5000 N/m at 1 and 4 kHz, and
with the usual budget as well, where at most a hundredth of the ticks may stay undecided, for 2 s each.

Exit 0 when every run holds its bounds, 1 otherwise, 77 (skipped) where the scans are absent.
"""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys

# name: path under SCANS, or none for the scan that is made here; isovalue, tool, most frozen ticks as a
# share of contact ticks
SCANS = {
    "made": (None, 150, "drill", 0.25),
    "bunny": ("stanford_bunny/bunny_512x512x361_airflat.nrrd", 1500, "cane", 0.20),
    "engine": ("volvis_classics/engine.nhdr", 90, "wrench", 0.20),
    "head-bone": ("visible_human_female_head/vhf_head_512x512x234.nrrd", 300, "drill", 0.30),
    "slab-bone": ("visible_human_female_head/dicom_slab", 300, "drill", 0.30),
    "phantom-bone": ("philips_head_phantom/bone_1mm", 300, "drill", 0.30),
}
HANDS = ["tap", "slide", "wedge", "pry", "hook", "jerk", "twist"]
CUTTING_HANDS = ["plunge", "mill", "hollow"]
PHANTOMS = {"sphere": 300, "halfspace": 300, "mastoid": 300}  # that are cut: isovalue
BURRS = {"bunny": "burr-3", "mastoid": "burr-3"}  # where voxels are small; others: burr-4
WIDE_BUDGET = ["--budget", "1000"]


def made(path):
    """Writes a hollow ball with a noisy wall and a groove around it, in oblique voxels of unequal sides."""
    import numpy as np
    spacing, dims = np.array([0.7, 0.7, 1.4]), (48, 96, 96)
    k, j, i = np.indices(dims)
    places = np.stack([i, j, k]).astype(float) - np.array([47.3, 47.8, 23.6])[:, None, None, None]
    x, y, z = places * spacing[:, None, None, None]
    radius = np.sqrt(x * x + y * y + z * z)
    outside = radius - 27.0 + 1.5 * np.exp(-(z / 3.0) ** 2)
    wall = np.clip(0.5 - outside / 1.4, 0, 1)
    inside = np.clip(0.5 - (radius - 19.0) / 1.4, 0, 1)
    values = -1000 + 1600 * wall - 560 * inside + np.random.default_rng(3).normal(0, 25, dims)
    # a turn by the angle of a triangle of 3, 4 and 5, so that the numbers are exact
    header = ("NRRD0004\ntype: short\ndimension: 3\nsizes: 96 96 48\nspace: left-posterior-superior\n"
              "space directions: (0.56,0.42,0) (-0.42,0.56,0) (0,0,1.4)\nspace origin: (-20,30,100)\n"
              "space units: \"mm\" \"mm\" \"mm\"\nendian: little\nencoding: raw\n\n")
    path.write_bytes(header.encode() + np.round(values).astype("<i2").tobytes())
    return path


def volume_of(name, scans, work):
    """Where a scan is; the made one is written first. None for a real one that is absent."""
    path = SCANS[name][0]
    if path is None:
        return made(work / "made.nrrd")
    return scans / path if (scans / path).exists() else None


def call(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stderr}{done.stdout}")
    return done.stdout


def phantom(name, args):
    call([args.cli, "convert", "--phantom", name, args.work / f"{name}.nrrd"])
    return args.work / f"{name}.nrrd"


def judged_as(volume, name, args):
    """An NRRD of the volume: the evaluator reads nothing else."""
    if not volume.is_dir():
        return volume
    call([args.cli, "convert", volume, args.work / f"{name}.nrrd"])
    return args.work / f"{name}.nrrd"


def touch(name, volume, args):
    """Runs the hands on a scan; prints what came out, and returns the bounds that were missed."""
    _, isovalue, tool, most_frozen = SCANS[name]
    failures = []
    shell = args.work / f"{tool}.csv"
    call([args.cli, "tool", tool, "--out", shell])
    judged = judged_as(volume, name, args)
    for hand in args.hands.split(",") if args.hands else HANDS:
        trace = args.work / f"{name}-{hand}.csv"
        command = [args.cli, "run", "--volume", volume, "--isovalue", str(isovalue), "--tool", tool,
                   "--hand", hand, "--seconds", args.seconds, "--stiffness", args.stiffness, "--json"]
        report = json.loads(call(command + ["--trace", trace]))
        verdict = json.loads(call([sys.executable, args.evaluator, "--volume", judged, "--isovalue",
                                   str(isovalue), "--shell", shell, "--json", trace]))
        bounds = {
            "penetration": verdict["max_penetration_mm"] == 0.0 and report["max_penetration_mm"] == 0.0,
            "finite": verdict["nonfinite"] == 0 and report["nonfinite"] == 0,
            "contact": verdict["contact_share"] >= 0.20,
            # beyond the surface, in the solid or along the force from where the proxy is held:
            # no wall thinner than 4 mm has 2 mm of depth, and a tip that gives way by turning
            # leaves little along the force
            "depth": max(verdict["device_depth_mm"], verdict["device_offset_mm"]) >= 2.0,
        }
        if hand in ("tap", "slide", "hook"):
            bounds["frozen"] = verdict["frozen_share"] < most_frozen
        if hand == "slide":
            bounds["travel"] = verdict["travel"]["ratio"] >= 0.90
        if not args.no_repeat and hand == "slide":
            again = args.work / f"{name}-{hand}-again.csv"
            call(command + ["--trace", again])
            bounds["identical"] = trace.read_bytes() == again.read_bytes()
        missed = [bound for bound, held in bounds.items() if not held]
        print(f"{name:13} {hand:6} mean {report['mean_us']:6.1f} p99 {report['p99_us']:6.0f} max "
              f"{report['max_us']:6.0f} us  contact {verdict['contact_share']:.2f}  depth "
              f"{verdict['device_depth_mm']:5.2f} mm  coupling {report['coupling_mm']:6.3f} mm  frozen "
              f"{verdict['frozen_share']:.3f}  travel {verdict['travel']['ratio']:.3f}  "
              f"beyond {verdict['device_offset_mm']:5.2f} mm  "
              f"{'FAILED: ' + ', '.join(missed) if missed else 'held'}", flush=True)
        failures += [f"{name} {hand} {bound}" for bound in missed]
    return failures


def cuts(hands, seconds, is_long):
    """The runs in which a burr cuts, as options; and whether none of their ticks ends by its budget."""
    for hand in hands:
        for stiffness in ("1000", "5000") if is_long else ("1000",):
            for rate in ("1000", "4000") if is_long else ("1000",):
                options = ["--hand", hand, "--stiffness", stiffness, "--rate", rate, "--seconds", seconds]
                yield options + WIDE_BUDGET, True
        if is_long:
            yield ["--hand", hand, "--stiffness", "1000", "--rate", "1000", "--seconds", seconds], False


def cut(name, volume, args):
    """Has a burr cut a scan; prints what came out, and returns the bounds that were missed."""
    isovalue = PHANTOMS[name] if name in PHANTOMS else SCANS[name][1]
    tool = BURRS.get(name, "burr-4")
    failures = []
    shell, judged = args.work / f"{tool}.csv", judged_as(volume, name, args)
    call([args.cli, "tool", tool, "--out", shell])
    is_long = bool(os.environ.get("PALPATE_TEST_ALL"))
    hands = args.hands.split(",") if args.hands and not is_long else CUTTING_HANDS
    for options, is_wide in cuts(hands, "2" if is_long else args.seconds, is_long):
        trace, recording, left = (args.work / f"{name}-cut.{kind}" for kind in ("csv", "palpate", "nrrd"))
        command = [args.cli, "run", "--volume", volume, "--isovalue", str(isovalue), "--tool", tool, "--cut",
                   *options, "--trace", trace, "--save-volume", left, "--json"]
        recording.unlink(missing_ok=True)
        report = json.loads(call(command + ["--record", recording]))
        judging = [sys.executable, args.evaluator, "--volume", judged, "--isovalue", str(isovalue), "--shell",
                   shell, "--recording", recording, "--left", left, "--json", trace]
        judgement = subprocess.run(judging, capture_output=True, text=True, check=False)
        if not judgement.stdout:
            raise SystemExit(f"{' '.join(map(str, judging))}: {judgement.stderr}")
        verdict = json.loads(judgement.stdout)
        digests = [hashlib.sha256(path.read_bytes()).digest() for path in (trace, left)]
        call(command)
        bounds = {
            "penetration": verdict["max_penetration_mm"] == 0.0 and report["max_penetration_mm"] == 0.0,
            "decided": verdict["undecided_ticks"] <= (0 if is_wide else 0.01 * verdict["ticks"]),
            "finite": verdict["nonfinite"] == 0 and report["nonfinite"] == 0,
            "contact": verdict["contact_share"] >= 0.20,
            "removed": verdict["lowered_voxels"] > 0 and verdict["removed_mm3"] > 0.0,
            # the recording has the whole of a last cut, which the usual budget may have left undone
            "volume": (not is_wide
                       or abs(verdict["removed_mm3"] - report["cutting"]["removed_mm3"]) < 1e-6),
            "as cut": verdict["left"]["as_cut"],
            "identical": digests == [hashlib.sha256(path.read_bytes()).digest() for path in (trace, left)],
        }
        missed = [bound for bound, held in bounds.items() if not held]
        print(f"{name:13} {tool} {' '.join(options):70} cuts {verdict['cuts']:5} removed "
              f"{verdict['removed_mm3']:7.2f} mm3, {verdict['removed_voxels']:4} voxels  deepest "
              f"{verdict['max_penetration_mm']:g} mm  contact {verdict['contact_share']:.2f}  undecided "
              f"{verdict['undecided_ticks']}  otherwise {verdict['left']['other_voxels']} of "
              f"{verdict['lowered_voxels']}  {'FAILED: ' + ', '.join(missed) if missed else 'held'}", flush=True)
        failures += [f"{name} {' '.join(options)} {bound}" for bound in missed]
        for path in (trace, recording, left):
            path.unlink()
    return failures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cli")
    parser.add_argument("evaluator")
    parser.add_argument("scans", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--only", help="names of scans, with commas")
    parser.add_argument("--hands")
    parser.add_argument("--seconds", default="4")
    parser.add_argument("--stiffness", default="1000")
    parser.add_argument("--no-repeat", action="store_true")
    parser.add_argument("--cut", action="store_true")
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    failures, absent = [], []
    names = [*SCANS, *PHANTOMS] if args.cut else SCANS
    for name in args.only.split(",") if args.only else names:
        volume = phantom(name, args) if name in PHANTOMS else volume_of(name, args.scans, args.work)
        if volume is None:
            print(f"NOT CHECKED: the scan {name} is not in {args.scans}")
            absent.append(name)
        elif args.cut:
            failures += cut(name, volume, args)
        else:
            failures += touch(name, volume, args)
    return 1 if failures else 77 if absent else 0


if __name__ == "__main__":
    sys.exit(main())
