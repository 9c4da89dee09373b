#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tools and hands from CSV files, and a folder for temporary files that is none: what is meant is
done, and what would be lost or guessed is refused.

Usage: input_files_test.py PALPATE_CLI FOLDER
"""
import os
import pathlib
import subprocess
import sys
import zipfile


def main():
    cli, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    faults = []

    def expect(code, words, *arguments, environment=None):
        done = subprocess.run([cli, *map(str, arguments)], capture_output=True, text=True, timeout=60,
                              env={**os.environ, **(environment or {})})
        said = done.stdout + done.stderr
        if done.returncode != code or words not in said:
            faults.append(f"{arguments}: exit {done.returncode}, not {code}, or no \"{words}\": {said}")

    def write(name, text):
        (folder / name).write_text(text)
        return folder / name

    out = folder / "out.csv"
    sound = write("sound.csv", "x,y,z\n0,0,0\n0,0,0.1\n")
    expect(0, "", "tool", sound, "--out", out)
    expect(0, "", "tool", write("SOUND.Csv", sound.read_text()), "--out", out)
    expect(0, "", "convert", "--phantom", "sphere", folder / "OUT.NRRD")
    expect(2, "must end in .nrrd", "convert", "--phantom", "sphere", folder / "out.raw")
    expect(2, "leave out --points", "tool", sound, "--points", 5, "--out", out)
    expect(2, "leave out --tool-unit", "tool", sound, "--tool-unit", "mm", "--out", out)
    expect(3, "first line", "tool", write("bare.csv", "0,0,0\n0,0,0.1\n"), "--out", out)
    expect(3, "10 m", "tool", write("far.csv", "x,y,z\n0,0,0\n1e155,0,0\n"), "--out", out)
    expect(0, "unusual", "tool", write("long.csv", "x,y,z\n0,0,0\n1,0,0\n"), "--out", out, "--json")
    expect(3, "in line 2", "tool", write("comma.csv", "x;y;z\n0,5;0;0\n"), "--out", out)

    run = ["run", "--phantom", "sphere", "--isovalue", 1000, "--tool", "probe", "--seconds", 0.01,
           "--stiffness", 500, "--hand"]
    pose = "0,0,0,0.03,1,0,0,0\n1,0,0,0.02,1,0,0,0\n"
    names = "t,x,y,z,w,i,j,k\n"
    expect(0, "", *run, write("hand.csv", names + pose))
    expect(3, "first line", *run, write("bare_hand.csv", pose))
    expect(3, "100 m", *run, write("far_hand.csv", names + pose + "2,0,1e155,0,1,0,0,0\n"))

    archive = folder / "study.zip"
    with zipfile.ZipFile(archive, "w") as packed:
        packed.writestr("a", "nothing")
    expect(3, "temporary files", "info", archive, environment={"TMPDIR": "/nonexistent"})

    print("\n".join(faults) or "as it should be")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
