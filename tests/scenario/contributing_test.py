#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The patches of tests/scenario/contributing, of which CONTRIBUTING.md speaks, applied to a copy of the
tree, build and do what they say.

Use: contributing_test.py ROOT BINARY FOLDER [--apply]

With --apply they are only applied. BINARY is a build of ROOT in a folder below it. The copy is built in its place, in a mount namespace
of its own, so that only what the patches change is compiled. Where the system allows no such
namespace, the copy has a headless build of its own, which takes minutes. FOLDER keeps copy and build.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from checks import check, outcome

ROOT, BINARY, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
TREE, BUILD = FOLDER / "tree", FOLDER / "build"
# the copy may lie within a checkout, and must not be taken for a part of it
OUTSIDE = dict(os.environ, GIT_CEILING_DIRECTORIES=str(FOLDER))


def copy_tree():
    """What git knows of, or would add, into TREE, with the times of ROOT: it is not built again."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others",
                             "--exclude-standard"], capture_output=True)
    if listed.returncode != 0:
        print("skipped: not a checkout")
        sys.exit(77)
    shutil.rmtree(TREE, ignore_errors=True)
    for name in filter(None, os.fsdecode(listed.stdout).split("\0")):
        if (ROOT / name).is_file():
            (TREE / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, TREE / name)


def in_place(script):
    """Runs a shell script that sees the copy and BUILD in the places of ROOT and BINARY."""
    new = ["unshare", "--mount"] if os.geteuid() == 0 else ["unshare", "--map-root-user", "--mount"]
    place = TREE / BINARY.relative_to(ROOT)
    place.mkdir(parents=True, exist_ok=True)
    mounts = 'mount --bind "$1" "$2" && mount --rbind "$3" "$4" && cd "$4" && '
    return run(*new, "sh", "-c", mounts + script, "sh", BUILD, place, TREE, ROOT)


def build():
    """Builds palpate-cli of the copy, and the window where it is built here."""
    shutil.rmtree(BUILD, ignore_errors=True)
    BUILD.mkdir(parents=True)
    if BINARY.is_relative_to(ROOT) and in_place("true").returncode == 0:
        shutil.copytree(BINARY, BUILD, dirs_exist_ok=True, symlinks=True,
                        ignore=lambda folder, names: ["tests"] if folder == str(BINARY) else [])
        window = "app/palpate" if (BINARY / "app/palpate").exists() else ""
        return in_place(f'cmake --build "{BINARY}" --target app/cli/palpate-cli {window}')
    print("no mount namespace: the copy is built from nothing")
    # not optimised, since it touches for a second only, and with sources joined: it is compiled sooner
    configured = run("cmake", "--preset", "headless", "-B", BUILD, "-DPALPATE_TESTS=OFF",
                     "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_UNITY_BUILD=ON")
    if configured.returncode != 0:
        return configured
    return run("cmake", "--build", BUILD, "--target", "palpate-cli")


def run(*command):
    done = subprocess.run(command, cwd=TREE, capture_output=True, text=True, env=OUTSIDE)
    if done.returncode != 0:
        print((done.stdout + done.stderr)[-4000:])
    return done


copy_tree()
FILES = {"tool": 3, "format": 2, "driver": 5, "panel": 5, "sentence": 2}  # that each may touch
for name, most in FILES.items():
    patch = ROOT / "tests/scenario/contributing" / f"{name}.diff"
    applied = subprocess.run(["git", "apply", patch], text=True, cwd=TREE, capture_output=True, env=OUTSIDE)
    check(applied.returncode == 0, f"{patch.name} does not apply: {applied.stderr}")
    touched = len(re.findall("^diff --git", patch.read_text(), re.M))
    check(touched <= most, f"{patch.name} touches {touched} files, more than {most}")
if "--apply" in sys.argv:
    sys.exit(outcome())
if not check(build().returncode == 0, "palpate-cli is not built"):
    sys.exit(outcome())

CLI = BUILD / "app/cli/palpate-cli"
points = FOLDER / "points.csv"
unknown = subprocess.run([CLI, "tool", "no-such-tool", "--out", points], capture_output=True, text=True)
check("spike" in unknown.stderr, "the new tool is not among those that are listed: " + unknown.stderr)
check("Spike" in run(CLI, "tool").stdout, "the new tool is not in the list of tools")
check(run(CLI, "tool", "spike", "--out", points).returncode == 0, "the new tool has no points")
check(len(points.read_text().splitlines()) == 5, "the new tool has other points than its mesh")

entries = json.loads(run(CLI, "devices", "--json").stdout)
check("Foot pedal" in json.dumps(entries), "the new driver is not asked for its devices")

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
