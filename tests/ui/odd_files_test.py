#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The window, where a pipe, a folder, a device, a link to itself or a file without end lies in the place of
each file that it opens, where a view names what is no scan, and where a picture would be written over the scan.
It neither hangs nor crashes, and says why it refuses.

Use: odd_files_test.py PALPATE PALPATE-CLI FOLDER (with a display)
"""
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "scenario"))
from input_files_test import HOSTILE, make  # noqa: E402

program, cli, folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), pathlib.Path(sys.argv[3]).absolute()
LONG = 300  # s: what hangs, hangs for ever
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
picture = folder / "picture.png"


def environment(home):
    return dict(os.environ, HOME=str(home), XDG_CONFIG_HOME=str(home / "config"), XDG_DATA_HOME=str(home / "data"),
                XDG_STATE_HOME=str(home / "state"), XDG_CACHE_HOME=str(home / "cache"))


def expect(code, words, home, *options):
    picture.unlink(missing_ok=True)
    done = subprocess.run([program, "--no-notice", "--screenshot", str(picture), *map(str, options)], env=environment(home),
                          cwd=folder, capture_output=True, text=True, timeout=LONG, stdin=subprocess.DEVNULL)
    assert done.returncode == code and words in done.stderr, (home.name, options, done)
    assert picture.exists() == (code == 0), (home.name, options)


plain = folder / "plain"
plain.mkdir()
scan = folder / "scan.nrrd"
subprocess.run([cli, "convert", "--phantom", "sphere", scan], check=True, capture_output=True)
session = folder / "session.palpate"
subprocess.run([cli, "run", "--phantom", "sphere", "--isovalue", "1000", "--tool", "probe", "--hand", "tap", "--stiffness",
                "500", "--seconds", "0.3", "--record", session], check=True, capture_output=True)

for kind in ("pipe", "folder", "device", "circle", "sparse"):
    home = folder / kind
    recordings = home / "data/Palpate/Palpate/recordings"
    for name in ("config/Palpate/Palpate.conf", "cache/Palpate/Palpate/demo.voxels", "state/palpate/palpate.log",
                 "state/palpate/crash-aaaaaa.raw", "state/palpate/crash-report.txt", "data/Palpate/Palpate/installation.key",
                 "data/Palpate/Palpate/recordings-labels.json", "data/Palpate/Palpate/recordings/session-0001.palpate",
                 "data/Palpate/Palpate/recordings/session-0002.palpate.part", "odd.palpate-view", "odd.palpate"):
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        make(kind, home / name)
    expect(0, "", home, "--phantom", "demo", "--after", 1)
    if kind == "sparse":
        continue  # a view of 1 TiB is refused as the others are
    expect(3, "odd.palpate-view", plain, home / "odd.palpate-view")
    expect(3, "odd.palpate", plain, home / "odd.palpate")

# views whose scan is none
own = (HOSTILE / "itself.palpate-view").read_text()
for name, place in (("itself", "itself.palpate-view"), ("other", "itself.palpate-view"), ("played", session.name)):
    view = folder / f"{name}.palpate-view"
    view.write_text(own.replace('"itself.palpate-view"', f'"{place}"'))
    expect(3, "as its scan", plain, view)
# and not by its name
(folder / "link.nrrd").symlink_to("itself.palpate-view")
(folder / "linked.palpate-view").write_text(own.replace('"itself.palpate-view"', '"link.nrrd"'))
expect(3, "link.nrrd", plain, folder / "linked.palpate-view")

# a recording, and numbers that are none
expect(0, "", plain, session)
for option, number in (("--after", "nan"), ("--after", "1e300"), ("--isovalue", "nan"), ("--isovalue", "inf")):
    expect(2, number, plain, "--phantom", "sphere", option, number)

# the picture would replace the scan
before = scan.read_bytes()
link = folder / "link.png"
link.symlink_to(scan.name)
picture = link
done = subprocess.run([program, "--no-notice", "--screenshot", str(link), str(scan)], env=environment(plain), cwd=folder,
                      capture_output=True, text=True, timeout=LONG, stdin=subprocess.DEVNULL)
assert done.returncode == 4 and "would be lost" in done.stderr, done
assert scan.read_bytes() == before
print("as it should be")
