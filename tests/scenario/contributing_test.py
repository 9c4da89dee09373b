#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The patches of CONTRIBUTING.md, applied to a copy of the tree, build and do what they say.

Use: contributing_test.py ROOT FOLDER

FOLDER keeps the copy and its headless build. So a second run compiles only what has changed; the
first takes minutes.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from checks import check, outcome

ROOT, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
FRESH, TREE, BUILD = FOLDER / "fresh", FOLDER / "tree", FOLDER / "build"
# the copy may lie within a checkout, and must not be taken for a part of it
OUTSIDE = dict(os.environ, GIT_CEILING_DIRECTORIES=str(FOLDER))


def files_of(folder):
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def copy_tree():
    """What git knows of, or would add, into FRESH."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others",
                             "--exclude-standard"], capture_output=True)
    if listed.returncode != 0:
        print("skipped: not a checkout")
        sys.exit(77)
    shutil.rmtree(FRESH, ignore_errors=True)
    for name in filter(None, os.fsdecode(listed.stdout).split("\0")):
        if (ROOT / name).is_file():
            (FRESH / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, FRESH / name)


def update_tree():
    """TREE becomes FRESH; files that are the same keep their times, so they are not built again."""
    TREE.mkdir(parents=True, exist_ok=True)
    wanted = files_of(FRESH)
    for name in files_of(TREE) - wanted:
        (TREE / name).unlink()
    for name in wanted:
        old, new = TREE / name, FRESH / name
        if not old.is_file() or old.read_bytes() != new.read_bytes():
            old.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(new, old)
    shutil.rmtree(FRESH)


def run(*command):
    done = subprocess.run(command, cwd=TREE, capture_output=True, text=True, env=OUTSIDE)
    if done.returncode != 0:
        print((done.stdout + done.stderr)[-4000:])
    return done


copy_tree()
patches = re.findall(r"^```diff\n(.*?)^```$", (ROOT / "CONTRIBUTING.md").read_text(), re.M | re.S)
check(len(patches) == 2, f"CONTRIBUTING.md has {len(patches)} patches, for a tool and for a format")
for patch in patches:
    applied = subprocess.run(["git", "apply", "-"], input=patch, text=True, cwd=FRESH,
                             capture_output=True, env=OUTSIDE)
    check(applied.returncode == 0, "a patch of CONTRIBUTING.md does not apply: " + applied.stderr)
update_tree()
# not optimised, since it touches for a second only, and with sources joined: it is compiled sooner
configured = run("cmake", "--preset", "headless", "-B", BUILD, "-DPALPATE_TESTS=OFF",
                 "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_UNITY_BUILD=ON")
if not check(configured.returncode == 0, "the copy is not configured") or not check(
        run("cmake", "--build", BUILD, "--target", "palpate-cli").returncode == 0,
        "palpate-cli is not built"):
    sys.exit(outcome())

CLI = BUILD / "app/cli/palpate-cli"
points = FOLDER / "points.csv"
unknown = subprocess.run([CLI, "tool", "no-such-tool", "--out", points], capture_output=True, text=True)
check("spike" in unknown.stderr, "the new tool is not among those that are listed: " + unknown.stderr)
check("Spike" in run(CLI, "tool").stdout, "the new tool is not in the list of tools")
check(run(CLI, "tool", "spike", "--out", points).returncode == 0, "the new tool has no points")
check(len(points.read_text().splitlines()) == 5, "the new tool has other points than its mesh")

recording, forces = FOLDER / "touch.palpate", FOLDER / "forces.tsv"
recording.unlink(missing_ok=True)
check(run(CLI, "run", "--phantom", "sphere", "--isovalue", "1000", "--tool", "spike", "--hand", "tap",
          "--seconds", "1", "--stiffness", "500", "--record", recording).returncode == 0,
      "the new tool touches nothing")
exported = run(CLI, "export", recording, "--format", "forces", "--out", forces, "--json")
if check(exported.returncode == 0, "the new format is not written"):
    check(json.loads(exported.stdout)["steps"] == 1000, "the export has other steps than the recording")
    lines = forces.read_text().splitlines()
    check(lines[0] == "t_s\tforce_N" and len(lines) == 1001, "the new format's file is another")
    check(max(float(line.split("\t")[1]) for line in lines[1:]) > 0.1, "no force was felt")
sys.exit(outcome())
