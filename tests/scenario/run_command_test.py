#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate-cli run: what is allowed is said at once, and what is not finite ends the run. Every named
tool touches, and the README's table of tools is the program's list.

Use: run_command_test.py PALPATE-CLI
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

program = sys.argv[1]


def run(*arguments):
    done = subprocess.run([program, "run", "--phantom", "sphere", "--isovalue", "300", "--json", *arguments],
                          capture_output=True, text=True, timeout=900)
    return done, json.loads(done.stdout)


# within what is allowed nothing is said; beyond it the run goes on and says so; a device has less
still, report = run("--tool", "sphere", "--hand", "tap", "--seconds", "0.3", "--stiffness", "1000")
allowed = report["allowed_stiffness_N_m"]
assert still.returncode == 0 and not still.stderr and 6300 < allowed <= 7200, (still, allowed)
stiff, report = run("--tool", "sphere", "--hand", "tap", "--seconds", "0.3", "--stiffness", "9000")
assert stiff.returncode == 0 and report["ticks"] == 300, stiff
assert "9000 N/m is more than" in stiff.stderr and f"{allowed:.0f} N/m" in stiff.stderr, stiff.stderr
device, report = run("--tool", "sphere", "--hand", "tap", "--seconds", "0.3", "--stiffness", "1700",
                     "--device", "falcon")
assert device.returncode == 0 and "more than the 1500 N/m" in device.stderr, device
assert abs(report["allowed_stiffness_N_m"] - 1500) < 1e-9, report

# a tool so small that its grip turns without inertia: its first contact is no number any more
with tempfile.TemporaryDirectory() as folder:
    tool, trace = pathlib.Path(folder, "tiny.csv"), pathlib.Path(folder, "trace.csv")
    r = "1e-100"
    points = [f"{r},0,0", f"-{r},0,0", f"0,{r},0", f"0,-{r},0", f"0,0,{r}", f"0,0,-{r}"]
    tool.write_text("x,y,z\n" + "\n".join(points) + "\n")
    ended, report = run("--tool", str(tool), "--hand", "twist", "--seconds", "5", "--stiffness", "20000",
                        "--angular-stiffness", "1000", "--trace", str(trace))
    assert ended.returncode == 4, ended
    assert report["nonfinite"] == 1 and 100 < report["ticks"] < 5000, report
    assert f"Tick {report['ticks'] - 1} gave a number that is not finite" in ended.stderr, ended.stderr
    assert len(trace.read_text().splitlines()) == report["ticks"] + 1, "the trace ends with that tick"

# the list of tools is the README's table; each of them touches a ball and a skull, and enters neither
listed = subprocess.run([program, "tool", "--json"], capture_output=True, text=True, timeout=900, check=True)
tools = json.loads(listed.stdout)["tools"]
readme = pathlib.Path(__file__).parents[2] / "app/cli/README.md"
rows = re.findall(r"^\| ([^|]+) \| `([a-z0-9-]+)` \| ([^|]+) \| ([0-9.]+) \| ([0-9.]+) \|$",
                  readme.read_text(), re.M)
assert [(use, name, title) for use, name, title, _, _ in rows] == \
    [(tool["use"], tool["name"], tool["title"]) for tool in tools], (rows, tools)
for (_, name, _, length, tip), tool in zip(rows, tools):
    assert abs(float(length) - tool["length_mm"]) < 0.051, (length, tool)
    assert float(tip) == tool["tip_mm"], (tip, tool)
with tempfile.TemporaryDirectory() as folder:
    for phantom in ("sphere", "demo"):
        volume = pathlib.Path(folder, f"{phantom}.nrrd")  # made once
        subprocess.run([program, "convert", "--phantom", phantom, volume], capture_output=True, check=True)
        for tool in tools:
            done = subprocess.run([program, "run", "--volume", volume, "--isovalue", "300", "--json", "--tool",
                                   tool["name"], "--hand", "tap", "--seconds", "2", "--stiffness", "500"],
                                  capture_output=True, text=True, timeout=900)
            report = json.loads(done.stdout)
            assert done.returncode == 0 and report["ticks"] == 2000, (phantom, tool, done)
            assert report["contact_ticks"] > 500 and report["max_force_N"] > 0.5, (phantom, tool, report)
            assert report["max_penetration_mm"] == 0 and report["nonfinite"] == 0, (phantom, tool, report)
