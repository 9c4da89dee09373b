#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate-cli run: what is allowed is said at once, and what is not finite ends the run. Every named
tool touches, and the README's table of tools is the program's list.

Use: run_command_test.py PALPATE-CLI
"""
import hashlib
import json
import math
import os
import pathlib
import pty
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time as time_module
import zlib

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

# the report is what its schema promises, and says what decided it
ROOT = pathlib.Path(__file__).parents[2]
schema = json.loads((ROOT / "app/cli/run.schema.json").read_text())
beside = {**schema["$defs"]["beside_trace"], "$defs": schema["$defs"]}
try:
    import jsonschema
    validate = jsonschema.validate
except ImportError:
    print("python3-jsonschema is not installed: only the required keys are looked for")

    def validate(report, wanted):
        assert set(wanted["required"]) <= set(report), set(wanted["required"]) - set(report)

SLIDE = ("--tool", "probe", "--hand", "slide", "--stiffness", "800")
with tempfile.TemporaryDirectory() as folder:
    trace = pathlib.Path(folder, "t.csv")
    chosen = {"--epsilon": 0.1, "--sub-steps": 4, "--budget": 50, "--normals": "cell", "--field": "spline",
              "--rate": 2000, "--friction": 0.2, "--seed": 7, "--angular-stiffness": 0.5}
    options = [str(word) for pair in chosen.items() for word in pair]
    done, report = run(*SLIDE, "--seconds", "2", "--trace", str(trace), *options)
    assert done.returncode == 0, done
    validate(report, schema)
    settings = report["settings"]
    names = {"--epsilon": "epsilon_voxels", "--sub-steps": "sub_steps", "--rate": "rate_Hz",
             "--angular-stiffness": "angular_stiffness_Nm_rad"}
    for option, value in chosen.items():
        name, value = ("budget_work", 100 * value) if option == "--budget" else (names.get(option, option[2:]), value)
        assert settings[name] == value, (option, settings)
    assert (settings["scene"], settings["tool"], settings["hand"]) == ("sphere", "probe", "slide"), settings
    assert settings["isovalue"] == 300 and settings["stiffness_N_m"] == 800 and settings["seconds"] == 2, settings
    assert report["ticks"] == 4000 and report["made_by"]["program"] == "palpate-cli", report
    git = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True)
    commit = report["made_by"]["commit"]
    assert git.returncode != 0 or commit == "unknown" or len(commit.removesuffix("-changed")) == 12, commit
    sidecar = json.loads(pathlib.Path(folder, "t.trace.json").read_text())
    validate(sidecar, beside)
    assert sidecar["settings"] == settings and sidecar["made_by"] == report["made_by"], sidecar

    # coupling_mm is the distance of the origins, as the trace has them; the metric counts the turn as well
    rows = [[float(cell) for cell in line.split(",")] for line in trace.read_text().splitlines()[1:]]
    apart = [sum((a - b) ** 2 for a, b in zip(row[1:4], row[8:11])) ** 0.5 for row in rows if row[21] > 0]
    assert len(apart) == report["contact_ticks"] > 100, report
    assert abs(report["coupling_mm"] - 1e3 * sum(apart) / len(apart)) < 1e-9, report
    assert report["coupling_metric_mm"] > report["coupling_mm"] * 1.0001, report

    # each of the new options changes the touch; what is usual, said or not, is the same to the byte
    def traced(*options):
        done, report = run("--tool", "cane", "--hand", "wedge", "--stiffness", "800", "--seconds", "2", "--trace",
                           str(trace), *options)
        assert done.returncode == 0, done
        return trace.read_bytes(), report
    usual, report = traced()
    assert report["cut_ticks"] == 0 and report["ns_per_unit"] > 0, report
    assert traced("--epsilon", "0.05", "--sub-steps", "8", "--budget", "200", "--normal", "central")[0] == usual
    for options in (("--epsilon", "0.2"), ("--sub-steps", "1"), ("--budget", "1"), ("--normals", "cell"),
                    ("--seed", "2")):
        assert traced(*options)[0] != usual, options
    assert traced("--budget", "1")[1]["cut_ticks"] > 50

    # a burr removes what its law says, the proxy stays outside what is left, twice the same to the byte
    def cutting(*options, tool="burr-4"):
        options = options if "--seconds" in options else (*options, "--seconds", "1.5")
        return run("--tool", tool, "--hand", "plunge", "--stiffness", "1000", *options)
    left = pathlib.Path(folder, "left.nrrd")
    done, report = cutting("--cut", "--burr-energy", "5", "--trace", str(trace), "--save-volume", str(left))
    assert done.returncode == 0, done
    validate(report, schema)
    cut, settings = report["cutting"], report["settings"]
    assert (settings["burr_mm"], settings["burr_speed_rpm"], settings["burr_energy_J_mm3"]) == (4, 60000, 5), settings
    power = settings["burr_share"] * cut["mean_force_N"] * settings["burr_speed_rpm"] / 60 * 2 * math.pi * 2e-3
    law = power / settings["burr_energy_J_mm3"] * cut["ticks"] * 1e-3
    assert abs(cut["removed_mm3"] / law - 1) < 0.05 and cut["removed_mm3"] > 1, (cut, law)
    assert abs(cut["removed_J"] / 5 - cut["removed_mm3"]) < 1e-6 * cut["removed_mm3"], cut
    assert report["max_penetration_mm"] == 0 and report["nonfinite"] == 0, report
    path, volume = trace.read_bytes(), left.read_bytes()
    assert cutting("--cut", "--burr-energy", "5", "--trace", str(trace), "--save-volume", str(left))[0].returncode == 0
    assert trace.read_bytes() == path and left.read_bytes() == volume
    whole = pathlib.Path(folder, "whole.nrrd")
    subprocess.run([program, "convert", "--phantom", "sphere", whole], capture_output=True, check=True)
    before, after = whole.read_bytes(), volume
    assert len(before) == len(after) and before != after, (len(before), len(after))
    assert "cutting" not in cutting()[1]

    # its recording holds every cut: a replay makes the same ones and comes to the same voxels, and so does what
    # is recovered after a kill, up to the last step that was committed
    def replayed(recording):
        done = subprocess.run([program, "replay", recording, "--phantom", "sphere", "--json"], capture_output=True,
                              text=True, timeout=900)
        return done, json.loads(done.stdout)

    def recorded(seconds, rate):
        recording = pathlib.Path(folder, f"cut-{rate}.palpate")
        recording.unlink(missing_ok=True)
        done, report = cutting("--cut", "--seconds", str(seconds), "--rate", str(rate), "--burr-vibration", "0.2",
                               "--record", str(recording))
        assert done.returncode == 0, done
        return recording, report
    for rate in (1000, 4000):
        recording, report = recorded(1.2, rate)
        done, again = replayed(recording)
        assert done.returncode == 0 and again["differing"] == again["differing_cuts"] == again["skipped"] == 0, again
        assert again["cuts"] > 300 and again["carved_as_recorded"] is True, again
    part = pathlib.Path(folder, "killed.palpate.part")
    moments = random.Random(4)
    waits = [moments.uniform(0.0, 3.0) for _ in range(100)] if os.environ.get("PALPATE_TEST_ALL") else (0.9, 1.4)
    for wait in waits:
        killed = subprocess.Popen([program, "run", "--phantom", "sphere", "--isovalue", "300", "--tool", "burr-4", "--hand",
                                   "plunge", "--stiffness", "1000", "--cut", "--burr-vibration", "0.2", "--seconds", "60",
                                   "--record",
                                   part.with_suffix("")], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        until = time_module.monotonic() + 60
        wal = pathlib.Path(f"{part}-wal")
        while time_module.monotonic() < until and not (wal.exists() and wal.stat().st_size > 200_000):
            time_module.sleep(0.02)
        time_module.sleep(wait)
        killed.kill()
        killed.wait()
        done = subprocess.run([program, "recover", part, "--json"], capture_output=True, text=True, timeout=60)
        steps = json.loads(done.stdout)["steps"]
        assert done.returncode == 0 and steps > 500, done
        done, found = replayed(part.with_suffix(""))
        assert done.returncode == 0 and found["differing_cuts"] == 0 and found["carved_as_recorded"] is None, found
        part.with_suffix("").unlink()
        assert found["carved"] == replayed(recorded(steps * 1e-3, 1000)[0])[1]["carved"], (steps, found)
    # what may not be cut stays to the voxel; a structure of its own energy and a band of values take theirs; a
    # recording says so, and its replay needs no labels
    head, body = before[:before.index(b"\n\n") + 2], before.index(b"\n\n") + 2
    sizes = [int(n) for n in re.search(rb"sizes: (.*)", head).group(1).split()]
    values = [memoryview(scan)[body:].cast("h") for scan in (before, after)]
    lost = [n for n in range(len(values[0])) if values[1][n] < values[0][n]]
    middle = sorted(n % sizes[0] for n in lost)[len(lost) // 2]
    mask = bytes(1 if n % sizes[0] < middle else 2 for n in range(len(values[0])))
    label_map = pathlib.Path(folder, "halves.nrrd")
    head = re.sub(rb"\ntype: .*", b"\ntype: uchar", head)
    label_map.write_bytes(re.sub(rb"\nendian: .*", b"", head) + mask)
    labels = ("--labels", str(label_map), "--watch", "1")

    def left_of(*options):
        recording = pathlib.Path(folder, "halves.palpate")
        recording.unlink(missing_ok=True)
        done, report = cutting("--cut", "--save-volume", str(left), "--record", str(recording), *options)
        assert done.returncode == 0, done
        assert report["max_penetration_mm"] == 0 and report["nonfinite"] == 0, report
        done, again = replayed(recording)
        assert done.returncode == 0 and again["differing"] == again["differing_cuts"] == 0, again
        assert again["carved_as_recorded"] is True, again
        found = memoryview(left.read_bytes())[body:].cast("h")
        return report["cutting"], [n for n in range(len(found)) if found[n] < values[0][n]]
    cut, gone = left_of("--burr-energy", "5", *labels, "--tissue", "1=never")
    assert gone and all(mask[n] == 2 for n in gone), (len(gone), cut)
    assert any(mask[n] == 1 for n in lost), len(lost)
    cut, gone = left_of("--burr-energy", "5", *labels, "--tissue", "1=8", "--tissue", "2=8")
    assert abs(cut["removed_J"] / cut["removed_mm3"] - 8) < 1e-6, cut
    cut, gone = left_of("--burr-energy", "5", "--burr-band", "-3000=7", "--burr-band", "3e9=2")
    assert abs(cut["removed_J"] / cut["removed_mm3"] - 7) < 1e-6, cut
    for options, code, words in (((*labels, "--tissue", "1=often"), 2, "does not say what cutting a structure takes"),
                                 ((*labels, "--tissue", "1=-2"), 2, "does not say"),
                                 ((*labels, "--tissue", "7=never"), 2, "7"),
                                 (("--burr-band", "700=x"), 2, "from a value on"),
                                 (("--tissue", "1=never"), 2, "--labels")):
        done = cutting("--cut", *options)[0]
        assert done.returncode == code and words in done.stderr, (options, done)
    for options, tool, words in ((("--cut",), "probe", "no burr that cuts; choose one of burr-1"),
                                 (("--save-volume", str(left)), "burr-4", "add --cut"),
                                 (("--burr-speed", "1000"), "burr-4", "--cut"),
                                 (("--cut", "--burr-vibration", "1.5"), "burr-4", "--burr-vibration")):
        done, _ = cutting(*options, tool=tool)
        assert done.returncode == 2 and words in done.stderr, (words, done)

    # a hand from a file starts with its first row, whatever its clock says, and where it ends is said
    hand = pathlib.Path(folder, "hand.csv")
    lines = usual.decode().splitlines()
    later = [lines[0]]
    for line in lines[1:301]:
        time, rest = line.split(",", 1)
        later.append(f"{float(time) + 1234.0!r},{rest}")
    hand.write_text("\n".join(later) + "\n")

    def along(*options):
        return run("--tool", "cane", "--hand", str(hand), "--stiffness", "800", *options)
    done, report = along("--seconds", "0.3", "--trace", str(trace))
    assert done.returncode == 0 and report["settings"]["hand"] == "file" and "seed" not in report["settings"], report
    first, last = trace.read_text().splitlines()[1], trace.read_text().splitlines()[300]
    assert first.split(",")[1:8] == lines[1].split(",")[1:8], first
    assert max(abs(float(a) - float(b)) for a, b in zip(last.split(",")[1:8], lines[300].split(",")[1:8])) < 1e-6
    done, report = along("--seconds", "0.5")
    assert abs(report["hand_ended_s"] - 0.299) < 1e-6 and "ended after 0.29" in done.stderr, (report, done.stderr)

    # names, numbers and times that are wrong are named by column and line
    for old, new, words in (
            ("device_qw,device_qx,device_qy,device_qz", "qx,qy,qz,qw", "Column 5 of"),
            (later[7].split(",")[2], "nan", "column device_y_m of line 8"),
            (later[7].split(",")[2], "one", "in line 8"),
            (later[7].split(",")[0], later[6].split(",")[0], "in line 8")):
        text = "\n".join(later) + "\n"
        at = text.index(later[0] if old.startswith("device") else later[7])
        hand.write_text(text[:at] + text[at:].replace(old, new, 1))
        done, report = along("--seconds", "0.1")
        assert done.returncode == 3 and words in done.stderr, (words, done)

    # a recording tells when it began and which volume it was only if that is asked for
    for wanted in ((), ("--epoch", "--open-hash")):
        recording = pathlib.Path(folder, "r.palpate")
        done, report = run(*SLIDE, "--seconds", "0.1", "--record", str(recording), *wanted)
        assert done.returncode == 0 and ("--epoch" in done.stderr) == bool(wanted), done
        out = pathlib.Path(folder, "e.csv")
        subprocess.run([program, "export", recording, "--format", "csv", "--out", out], capture_output=True, check=True)
        told = json.loads(out.with_suffix(".columns.json").read_text())["recording"]
        assert ("began_unix_ns" in told) == ("voxels_sha256" in told) == bool(wanted), told
        assert told["run_hand"] == "slide" and told["run_seed"] == 1 and told["run_scene"] == "sphere", told
    # an export is a hand: its events are words behind the numbers, and some of its fields are empty
    rows = out.read_text().splitlines()
    rows[1] = rows[1].rsplit(",", 1)[0] + ',"mark: here, ""and"" there"'
    out.write_text("\n".join(rows) + "\n")
    done, report = run("--tool", "probe", "--hand", str(out), "--stiffness", "800", "--seconds", "0.1")
    assert done.returncode == 0 and report["settings"]["hand"] == "file", done
    volume = pathlib.Path(folder, "sphere.nrrd")
    subprocess.run([program, "convert", "--phantom", "sphere", volume], capture_output=True, check=True)
    voxels = volume.read_bytes().split(b"\n\n", 1)[1]
    if b"encoding: raw" not in volume.read_bytes()[:2000]:
        voxels = zlib.decompress(voxels, 31)
    assert told["voxels_sha256"] == hashlib.sha256(voxels).hexdigest(), told
    assert abs(told["began_unix_ns"] * 1e-9 - time_module.time()) < 600, told
    done, _ = run(*SLIDE, "--seconds", "0.1", "--epoch")
    assert done.returncode == 2, done

    # a volume of one value, and 64-bit numbers
    flat = pathlib.Path(folder, "flat.nrrd")
    head = ("NRRD0004\ntype: {}\ndimension: 3\nsizes: 8 8 8\nspace: left-posterior-superior\nspace directions: "
            "(1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nendian: little\nencoding: raw\n\n")
    flat.write_bytes(head.format("short").encode() + struct.pack("<h", 7) * 512)
    done = subprocess.run([program, "run", "--volume", flat, "--isovalue", "300", "--seconds", "1", *SLIDE],
                          capture_output=True, text=True)
    assert done.returncode == 3 and "Every voxel of the volume is 7" in done.stderr, done
    flat.write_bytes(head.format("double").encode() + b"".join(struct.pack("<d", 0.1 * n) for n in range(512)))
    done = subprocess.run([program, "info", flat, "--json"], capture_output=True, text=True)
    assert done.returncode == 0 and "rounded to 32 bits" in json.loads(done.stdout)["message"], done
    done = subprocess.run([program, "convert", flat, pathlib.Path(folder, "c.nrrd")], capture_output=True, text=True)
    assert done.returncode == 0 and "rounded to 32 bits" in done.stderr, done

# a name that does not exist is wrong usage, of whatever it is the name
for option in ("--phantom", "--tool", "--hand", "--device", "--field", "--normal"):
    words = {"--phantom": "sphere", "--tool": "probe", "--hand": "tap", option: "nonesuch"}
    done = subprocess.run([program, "run", "--isovalue", "1000", "--seconds", "0.1", "--stiffness", "500",
                           *[word for pair in words.items() for word in pair]], capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.count("\n") == 1, (option, done)
for words in (("convert", "--phantom", "nonesuch", "x.nrrd"), ("tool", "nonesuch", "--out", "x.csv"),
              ("surface", "--phantom", "nonesuch", "--isovalue", "1", "--out", "x.stl")):
    done = subprocess.run([program, *words], capture_output=True, text=True)
    assert done.returncode == 2 and "nonesuch" in done.stderr, (words, done)

# the paper's scenes have names; the smallest of those by formula is touched
done = subprocess.run([program, "run", "--phantom", "engine", "--isovalue", "90", "--tool", "wrench", "--points", "2126",
                       "--hand", "tap", "--seconds", "1", "--stiffness", "500", "--json"], capture_output=True, text=True)
report = json.loads(done.stdout)
assert done.returncode == 0 and report["settings"]["dims"] == [256, 256, 110], done
assert report["contact_ticks"] > 100 and report["max_penetration_mm"] == 0, report
assert "bunny, engine, bone" in subprocess.run([program, "convert", "--phantom", "nonesuch", "x.nrrd"],
                                               capture_output=True, text=True).stderr

# on a terminal a run tells how far it is, from five seconds on; elsewhere it is quiet
terminal, side = pty.openpty()
long = subprocess.Popen([program, "run", "--phantom", "sphere", "--isovalue", "1000", "--seconds", "86400", *SLIDE],
                        stdout=subprocess.DEVNULL, stderr=side)
os.close(side)
begun = time_module.monotonic()
told = os.read(terminal, 4096).decode()
assert "% of the run, about" in told and time_module.monotonic() - begun > 4, told
long.send_signal(signal.SIGINT)
assert long.wait(timeout=60) == 130
