#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate-cli among other programs: interrupted, without a program that it starts, with nowhere to answer to, given files that it
would write over, names that steer a terminal and numbers that are none, thirty of it at once, and a
system that speaks German.

Use: command_line_test.py PALPATE-CLI FOLDER
"""
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import resource
import shutil
import signal
import stat
import subprocess
import sys
import time

from checks import check, outcome

program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
folder = folder.resolve()
environment = {k: v for k, v in os.environ.items() if not k.startswith("XDG_")}
environment["HOME"] = str(folder / "home")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def start(*words, **how):
    return subprocess.Popen([program, *words], env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, **how)


def begins(running):
    """Until it waits for signals: before, it is still being loaded."""
    while running.poll() is None:
        status = pathlib.Path(f"/proc/{running.pid}/status").read_text()
        if int(status.split("SigBlk:")[1].split()[0], 16) & 1 << signal.SIGTERM - 1:
            break
        time.sleep(0.01)
    time.sleep(0.2)


def call(*words, code=0, env=None, **how):
    done = subprocess.run([program, *words], capture_output=True, env=env or environment, **how)
    check(done.returncode == code, f"{words}: {done.returncode} in place of {code}: {done}")
    return done


def touch(volume, *more, tool="probe", hand="slide", seconds="0.2"):
    return ("run", *volume, "--isovalue", "0", "--tool", tool, "--hand", hand, "--stiffness", "1000",
            "--seconds", seconds, *more)


SPHERE = ("--phantom", "sphere")


def nrrd(path, edge):
    """A volume of so many GiB of nothing, which takes no room."""
    head = (f"NRRD0005\ntype: uint8\ndimension: 3\nsizes: {edge} {edge} {edge}\nspace: "
            "left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: "
            "(0,0,0)\nencoding: raw\n\n").encode()
    path.write_bytes(head)
    os.truncate(path, len(head) + edge ** 3)


def left(place):
    return sorted(path.name for path in place.iterdir())


def is_interrupted():
    place = folder / "interrupted"
    place.mkdir()
    big = place / "big.nrrd"
    nrrd(big, 2560)  # 16 GiB: nobody reads it before he is interrupted
    there = left(place)
    commands = {"info": ("info", big), "convert": ("convert", big, place / "o.nrrd"),
                # deep in a library, which is not asked whether it goes on
                "tool": ("tool", "probe", "--points", "10000000", "--out", place / "t.csv"),
                "run": touch(("--volume", big), "--trace", place / "t.csv")}
    for name, words in commands.items():
        for number in SIGNALS:
            running = start(*words, "--json")
            begins(running)
            running.send_signal(number)
            said, told = running.communicate()
            check(running.returncode == 130, f"{name}, {number.name}: {running.returncode} {told}")
            check(json.loads(said or b"{}").get("error", {}).get("code") == 130,
                  f"{name}, {number.name}: {said}")
            check(told.count(b"\n") == 1 and len(told) > 5, f"{name}, {number.name}: {told}")
            check(left(place) == there, f"{name}, {number.name}: left {left(place)}")
    # while it writes
    nrrd(place / "some.nrrd", 1024)
    there = left(place)
    running = start("convert", place / "some.nrrd", place / "o.nrrd")
    while running.poll() is None and left(place) == there:
        time.sleep(0.001)
    running.send_signal(signal.SIGINT)
    running.communicate()
    check(running.returncode == 130 and left(place) == there, f"{running}: left {left(place)}")
    # a recording is closed
    for number in SIGNALS:
        recording = place / f"{number.name}.palpate"
        running = start(*touch(SPHERE, "--record", recording, "--trace", place / "t.csv",
                               seconds="600"))
        while running.poll() is None and not recording.with_suffix(".palpate.part").exists():
            time.sleep(0.01)
        time.sleep(0.3)
        # twice, as a shell and a program between them do
        running.send_signal(number)
        running.send_signal(number)
        running.communicate()
        check(running.returncode == 130, f"run, {number.name}: {running.returncode}")
        check(recording.exists() and not recording.with_suffix(".palpate.part").exists(),
              f"run, {number.name}: the recording was not closed")
        call("replay", recording, *SPHERE)
        check((place / "t.csv").read_bytes().endswith(b"\n"), "the trace is not whole")
        os.remove(place / "t.csv")
    # nohup
    running = start(*touch(SPHERE, "--trace", place / "t.csv", seconds="2"),
                    preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    begins(running)
    running.send_signal(signal.SIGHUP)
    running.communicate()
    check(running.returncode == 0, f"under nohup: {running.returncode}")
    shutil.rmtree(place)


def answers_or_fails():
    place = folder / "answers"
    place.mkdir()
    call("convert", *SPHERE, place / "v.nrrd")
    call(*touch(SPHERE, "--record", place / "r.palpate"))
    commands = {"info": ("info", place / "v.nrrd"), "devices": ("devices",),
                "convert": ("convert", *SPHERE, place / "o.nrrd"),
                "tool": ("tool", "probe", "--out", place / "t.csv"), "run": touch(SPHERE),
                "replay": ("replay", place / "r.palpate", *SPHERE),
                "export": ("export", place / "r.palpate", "--format", "hdf5", "--out",
                           place / "e.h5")}
    read, write = os.pipe()
    os.close(read)
    with open("/dev/full", "wb") as full:
        for name, words in commands.items():
            for json_too in ((), ("--json",)):
                for where, how in (("full", {"stdout": full}), ("broken", {"stdout": write}),
                                   ("closed", {"preexec_fn": lambda: os.close(1)})):
                    done = subprocess.run([program, *words, *json_too], env=environment,
                                          stderr=subprocess.PIPE, **how)
                    check(done.returncode == 4 and done.stderr.count(b"\n") == 1,
                          f"{name} {json_too}, {where}: {done.returncode} {done.stderr}")
        done = subprocess.run([program, "--help"], stdout=full)
        check(done.returncode == 4, f"--help: {done.returncode}")
    os.close(write)
    # the answer of one that has no output must not end in a file that it writes
    done = subprocess.run([program, *touch(SPHERE, "--trace", place / "t.csv"), "--json"],
                          env=environment, stderr=subprocess.PIPE, preexec_fn=lambda: os.close(1))
    lines = (place / "t.csv").read_text().splitlines()
    check(len(lines) == 201 and all(line.count(",") == 21 for line in lines), "a trace with more")
    shutil.rmtree(place)


def is_whole_or_not_there():
    place = folder / "whole"
    place.mkdir()
    call("convert", *SPHERE, place / "v.nrrd")
    shell = call("tool", "probe", "--out", "/dev/stdout").stdout
    writes = {"t.csv": ("tool", "probe", "--out"), "o.nrrd": ("convert", *SPHERE),
              "trace.csv": touch(SPHERE, "--trace")}

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))
    for name, words in writes.items():
        call(*words, place / name)
        whole = (place / name).read_bytes()
        check(len(whole) > 5000, f"{name} is too short for this test")
        (place / name).write_bytes(b"old")
        there = left(place)
        call(*words, place / name, code=4, preexec_fn=limit)
        check((place / name).read_bytes() == b"old" and left(place) == there,
              f"{name}: no room, and {left(place)}")
        # a link stays one
        (place / "link").symlink_to(name)
        (place / f"link-{name}").symlink_to(name)
        call(*words, place / f"link-{name}")
        check((place / name).read_bytes() == whole and (place / f"link-{name}").is_symlink(),
              f"{name} through a link")
        (place / "link").unlink()
        # what is no file is written as it is
        os.mkfifo(place / "pipe")
        with concurrent.futures.ThreadPoolExecutor() as readers:
            heard = readers.submit((place / "pipe").read_bytes)
            call(*words, place / "pipe")
            os.close(os.open(place / "pipe", os.O_RDWR | os.O_NONBLOCK))  # if nobody came
            check(heard.result() == whole, f"{name} through a pipe")
        check(stat.S_ISFIFO((place / "pipe").stat().st_mode), "the pipe is gone")
        (place / "pipe").unlink()
        check(call(*words, "/dev/stdout").stdout == whole, f"{name} to standard output")
        with open(place / "appended", "wb") as out:  # after what is there, and not in its place
            out.write(b"before\n")
            out.flush()
            subprocess.run([program, *words, "/dev/stdout"], env=environment, stdout=out,
                           stderr=subprocess.DEVNULL, check=True)
        check((place / "appended").read_bytes() == b"before\n" + whole, f"{name} appended")
        call(*words, "/dev/null")
        call(*words, "/dev/full", code=4)
        call(*words, place, code=4)
        check(left(place).count(name) == 1 and not [n for n in left(place) if "part" in n],
              f"{name}: left {left(place)}")
    check(shell.startswith(b"x_m,y_m,z_m\n") and shell.count(b"\n") > 100, "the shell")
    shutil.rmtree(place)


def loses_no_input():
    place = folder / "inputs"
    place.mkdir()
    call("convert", *SPHERE, place / "v.nrrd")
    call(*touch(SPHERE, "--trace", place / "hand.csv", "--record", place / "r.palpate"))
    call("tool", "probe", "--out", place / "tool.csv")
    shutil.copy(pathlib.Path(__file__).parents[2] / "resources/tools/probe.obj", place / "tool.obj")
    text, voxels = (place / "v.nrrd").read_bytes().split(b"\n\n", 1)
    (place / "beside.raw").write_bytes(voxels)
    (place / "beside.nhdr").write_bytes(text + b"\ndata file: beside.raw\n\n")
    (place / "sub").mkdir()
    for name in left(place):
        if name != "sub":
            (place / "sub" / f"soft-{name}").symlink_to(place / name)
            os.link(place / name, place / "sub" / f"hard-{name}")
    before = {path: path.read_bytes() for path in place.rglob("*") if path.is_file()}
    volume = ("--volume", place / "v.nrrd")

    def names(name):
        yield place / name
        yield place / "sub" / ".." / name
        yield place / "sub" / f"soft-{name}"
        yield place / "sub" / f"hard-{name}"

    for option in ("--trace", "--record"):
        for out in names("v.nrrd"):
            call(*touch(volume, option, out), code=2)
        for out in names("hand.csv"):
            call(*touch(SPHERE, option, out, hand=place / "hand.csv"), code=2)
        for tool in ("tool.csv", "tool.obj"):
            for out in names(tool):
                call(*touch(SPHERE, option, out, tool=place / tool), code=2)
        for out in (*names("beside.raw"), *names("beside.nhdr")):
            call(*touch(("--volume", place / "beside.nhdr"), option, out), code=2)
    for out in names("tool.obj"):
        call("tool", place / "tool.obj", "--out", out, code=2)
    for out in names("v.nrrd"):
        call("convert", place / "v.nrrd", out, code=2)
    (place / "r.h5").symlink_to("r.palpate")
    (place / "e_motion.tsv").symlink_to("r.palpate")
    call("export", place / "r.palpate", "--format", "hdf5", "--out", place / "r.h5", code=2)
    call("export", place / "r.palpate", "--format", "motion-bids", "--out", place / "e", code=2)
    (place / "e.columns.json").symlink_to("r.palpate")
    call("export", place / "r.palpate", "--format", "csv", "--out", place / "e.csv", code=2)
    said = call(*touch(SPHERE, "--trace", place / "new", "--record", place / "sub/../new"), code=2)
    check(b"--record" in said.stderr and b"--trace" in said.stderr, f"one file for two: {said}")
    for path, content in before.items():
        check(path.read_bytes() == content, f"{path} was lost")
    # what is not read is replaced
    call(*touch(volume, "--trace", place / "hand.csv"))
    check((place / "hand.csv").read_bytes() != b"", "the trace")
    shutil.rmtree(place)


def steers_no_terminal():
    place = folder / "names"
    place.mkdir()
    names = (b"a\x1b[31mred.nrrd", b"two\nlines\r.nrrd", b"c1\xc2\x9b2J.nrrd", b"no\xff\x9butf8.nrrd",
             b"\xe2\x80\xaeback.nrrd", b"del\x7f\x07.nrrd")
    steering = {*range(0x20), 0x7f, *range(0x80, 0xa0), *range(0x202a, 0x202f)} - {0x0a}
    for name in names:
        path = os.fsencode(place) + b"/" + name
        commands = [(("info", path), 3), (("convert", *SPHERE, path), 0), ((name,), 2)]
        if name in names[:4:3]:
            commands += [(("convert", path, path), 2), (("info", path), 0),
                         (("tool", path + b".csv", "--out", "/dev/null"), 3),
                         (("tool", "probe", "--out", b"/no/" + path), 4),
                         (("run", b"--" + name), 2), (("recover", path), 3),
                         (("study", "plan", "--quick", "--shard", name, "--out", path), 2),
                         (("export", path, "--format", "motion-bids", "--out", path), 3)]
        for words, code in commands:
            for json_too in ((), ("--json",)):
                done = call(*words, *json_too, code=code)
                for text in (done.stdout, done.stderr):
                    shown = text.decode()  # UTF-8, whatever the name
                    check(not steering & set(map(ord, shown)), f"{words} says {text}")
                check(done.stderr.count(b"\n") == (code != 0), f"{words}: {done.stderr}")
                if json_too:
                    json.loads(done.stdout)
    shutil.rmtree(place)


def reads_numbers_whole():
    naturals = ("-1", "1e5x", "1e3", "0x10", "1,5", "1.5", "nan", "inf", "", " 1", "1 ",
                "99999999999999999999999", "+", "010")
    reals = ("1e5x", "0x10", "1,5", "nan", "inf", "-inf", "1e999", "", "1 ", "--")
    run, tool = touch(SPHERE), ("tool", "probe", "--out", "/dev/null")
    export = ("export", folder / "no.palpate", "--format", "hdf5", "--out", folder / "no.h5")
    study = ("study", "plan", "--quick", "--out", folder / "no")
    without = {name: tuple(word for i, word in enumerate(run)
                           if name not in (word, run[max(i - 1, 0)]))
               for name in ("--isovalue", "--seconds", "--stiffness")}
    # each way of being none once, and of every option some
    some_naturals, some_reals = ("-1", "1e3", "0x10", ""), ("nan", "1e5x", "")
    cases = [(run, "--seed", naturals), (run, "--friction", reals)]
    cases += [(run, o, some_naturals) for o in ("--points", "--every", "--series")]
    cases += [(run, "--angular-stiffness", some_reals)]
    cases += [(without[o], o, some_reals) for o in without]
    cases += [(tool, "--points", some_naturals), (study, "--seed", some_naturals)]
    cases += [(study, "--shard", ("", "0/1", "2/1", "1/2x", "x", "-1/2", "1/99999999999999"))]
    cases += [(export, o, some_reals) for o in ("--from", "--to", "--rate")]
    listed = call("export", "--help").stdout.decode()
    if "--size" in listed:  # the desktop build
        cases += [(export, "--fps", some_naturals), (export, "--speed", some_reals),
                  (export, "--size", ("abc", "1280", "1280x", "x720", "1280x720x", "1280X720", "",
                                      "99999999999x720", "-1280x720", "1280x7e2"))]
    cases += [(run, option, ("",)) for option in
              ("--device", "--trace", "--record", "--field", "--normal", "--tool-unit")]
    # a box is six of them
    cases += [(run + ("--box", "0", "1", "0", "1", "0"), None, some_naturals)]
    for words, option, values in cases:
        for value in values:
            line = words + ((option, value) if option else (value,))
            done = call(*line, code=2)
            check((option or "--box").encode() in done.stderr, f"{line[-2:]}: {done.stderr}")
    # what is missing is told by its name
    for line, named in ((("bogus",), "bogus"), (("study", "bogus"), "bogus"),
                        (run + ("--bogus",), "--bogus")):
        check(named.encode() in call(*line, code=2).stderr, f"{line}: not named")
    for line in ((), ("info", ""), ("convert", "", ""), ("tool", "", "--out", "/dev/null"),
                 ("tool", "probe", "--out", ""), touch(("--volume", "")), touch(("--phantom", "")),
                 touch(SPHERE, tool=""), touch(SPHERE, hand=""), ("replay", "", *SPHERE),
                 ("recover", ""), ("export", "", *export[2:])):
        call(*line, code=2)


def starts_the_studies():
    studies = program.parent / "palpate-study"
    for words in (("accuracy", "--help"), ("merge", "--help")):
        done = subprocess.run([studies, *words], env=environment, capture_output=True)
        check(done.stdout.replace(b"palpate-study", b"palpate-cli study") == call("study", *words).stdout,
              f"palpate-study {words} says {done}")
    # where they are missing
    place = folder / "alone"
    place.mkdir()
    alone = shutil.copy(program, place)
    for words in (("study", "accuracy", "--out", place / "o"), ("study", "--help"), ("cohort", "m.tsv", place / "o")):
        for json_too in ((), ("--json",)):
            done = subprocess.run([alone, *words, *json_too], env=environment, capture_output=True)
            check(done.returncode == 4 and b"palpate-study" in done.stderr and done.stderr.count(b"\n") == 1,
                  f"alone, {words}: {done}")
            check(not json_too or json.loads(done.stdout)["error"]["code"] == 4, f"alone, {words}: {done}")
    check(left(place) == ["palpate-cli"], f"alone: left {left(place)}")
    shutil.rmtree(place)


def reads_the_part_that_is_named():
    place = folder / "part"
    place.mkdir()
    call("convert", *SPHERE, place / "v.nrrd")  # 64 voxels of 1 mm each way
    call("convert", place / "v.nrrd", place / "part.nrrd",
         "--box", "1", "21", "2", "33", "3", "47", "--every", "2")
    part = json.loads(call("info", place / "part.nrrd", "--json").stdout)
    check(part["dims"] == [10, 16, 22], f"a part of {part['dims']} voxels")
    check(part["origin_mm"] == [-30.5, -29.5, -28.5], f"a part at {part['origin_mm']}")
    shutil.rmtree(place)


def lists_the_structures_of_label_maps():
    place = folder / "labels"
    place.mkdir()
    call("convert", *SPHERE, place / "v.nrrd")  # 64 voxels of 1 mm each way
    size, keys = 8, "Segment0_ID:=a\nSegment0_Name:=PLNT^Jane\nSegment0_LabelValue:=7\nSegment0_Color:=1 0 0\n"
    origin = json.loads(call("info", place / "v.nrrd", "--json").stdout)["origin_mm"]
    head = ("NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 8 8 8\n"
            "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: ({},{},{})\nencoding: raw\n")
    voxels = bytes(7 * (n % size < 4) for n in range(size ** 3))
    labels = place / "l.seg.nrrd"
    labels.write_bytes((head.format(*(o + 10.5 for o in origin)) + keys + "\n").encode() + voxels)
    said = call("info", "--labels", labels, place / "v.nrrd", "--json").stdout
    check(b"PLNT" not in said, "info prints names unasked")
    structures = json.loads(said)["labels"][0]["structures"]
    # eight voxels of 2 mm from 9.5 mm on along each axis, of which four are marked along x
    check(structures == [{"number": 1, "colour": [1.0, 0.0, 0.0], "voxels": 8 * 16 * 16, "volume_mm3": 2048.0,
                          "box": {"first": [10, 10, 10], "end": [18, 26, 26]},
                          "centre_mm": [origin[0] + 13.5, origin[1] + 17.5, origin[2] + 17.5]}],
          f"structures {structures}")
    table = place / "names.ctbl"
    table.write_text("7 PLNT_canal 0 255 0 255\n")
    labels.write_bytes((head.format(*(o + 10.5 for o in origin)) + "\n").encode() + voxels)
    named = json.loads(call("info", place / "v.nrrd", "--names", "--table", table, "--labels", labels,
                            "--json").stdout)["labels"][0]["structures"][0]
    check(named["name"] == "PLNT_canal" and named["colour"] == [0.0, 1.0, 0.0], f"a table names {named}")
    labels.write_bytes((head.format(*(o + 10.5 for o in origin)) + keys + "\n").encode() + voxels)
    surface = place / "box.stl"
    corners = [(20 + 10 * (n & 1), 20 + 10 * (n >> 1 & 1), 20 + 10 * (n >> 2)) for n in range(8)]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    text = "solid\n"
    for a, b, c, d in quads:
        for triangle in ((a, b, c), (a, c, d)):
            text += "facet normal 0 0 0\nouter loop\n"
            # RAS
            text += "".join("vertex {} {} {}\n".format(-(origin[0] + corners[n][0] - 0.5),
                                                       -(origin[1] + corners[n][1] - 0.5),
                                                       origin[2] + corners[n][2] - 0.5) for n in triangle)
            text += "endloop\nendfacet\n"
    surface.write_text(text + "endsolid\n")
    inside = json.loads(call("info", place / "v.nrrd", "--labels", surface, "--space", "ras",
                             "--json").stdout)["labels"][0]["structures"][0]
    check(inside["box"] == {"first": [20] * 3, "end": [30] * 3} and inside["voxels"] == 1000, f"a surface {inside}")
    unsaid = call("info", place / "v.nrrd", "--labels", surface, "--json", code=3)
    check(json.loads(unsaid.stdout)["reasons"] == ["surface-space"], f"no space: {unsaid}")
    named = json.loads(call("info", place / "v.nrrd", "--names", "--labels", labels, "--json").stdout)
    check(named["labels"][0]["structures"][0]["name"] == "PLNT^Jane", f"named {named}")
    # how far a point is from that box, tick for tick
    point, passing, trace = place / "point.csv", place / "passing.csv", place / "t.csv"
    point.write_text("x,y,z\n0,0,0\n")
    passing.write_text("t,x,y,z,qw,qx,qy,qz\n0,-0.04,-0.016,-0.014,1,0,0,0\n2,-0.0231,-0.03,-0.014,1,0,0,0\n")
    scan = "--volume", place / "v.nrrd", "--labels", labels
    report = json.loads(call(*touch((*scan, "--watch", "1", "--trace", trace, "--json"), tool=point, hand=passing,
                                    seconds="2")).stdout)
    least = [(o + 9.5) / 1e3 for o in origin]
    most = [low + side / 1e3 for low, side in zip(least, (8, 16, 16))]
    near = []
    for row in csv.DictReader(trace.open()):
        beyond = [max(low - at, at - high) for low, at, high in
                  zip(least, (float(row[f"proxy_{axis}_m"]) for axis in "xyz"), most)]
        away = math.hypot(*(max(0.0, by) for by in beyond)) or max(beyond)
        near.append(float(row["nearest_to_1_m"]))
        check(abs(near[-1] - min(away, 0.02)) < 0.55e-3 and row["tip_to_1_m"] == row["nearest_to_1_m"],
              f"distance to a box: {row}, not {away}")
    check(len(near) == 2000 and min(near) < 0.009 and len(set(near)) > 1500, f"distances {near[::100]}")
    watched = report["watched"][0]
    check(watched["number"] == 1 and abs(watched["least_mm"] - 1e3 * min(near)) < 1e-5 and
          watched["error_mm"] == 0.55 and watched["told_up_to_mm"] == 20.0, f"watched {watched}")
    none = call(*touch((*scan, "--watch", "2"), tool=point), code=2)
    check(b"no structure 2" in none.stderr, f"structure 2: {none}")
    # of four columns two lie in the scan
    labels.write_bytes((head.format(origin[0] - 3.5, origin[1] + 0.5, origin[2] + 0.5) + "\n").encode() + voxels)
    half = json.loads(call("info", place / "v.nrrd", "--labels", labels, "--json").stdout)["labels"][0]
    check(half["structures"][0]["outside"] == 0.5 and "50 % of what \"l.seg.nrrd\"" in half["notes"][0], f"half {half}")
    told = call(*touch((*scan, "--watch", "1"), tool=point))
    check(b"50 % of what" in told.stderr, f"a run says {told.stderr}")
    # for people a table, and a line for each remark
    lines = call("info", place / "v.nrrd", "--labels", labels, "--names").stdout.decode().split("\n")
    table = lines[lines.index("labels:") + 1:]
    check(table[0].split()[:3] == ["number", "voxels", "volume"] and table[1].split()[:2] == ["1", "1024"]
          and table[1].endswith("50 %") and table[2].startswith("note: 50 %") and max(map(len, lines)) < 120, f"{lines}")
    labels.write_bytes((head.format(900, 0, 0) + "\n").encode() + voxels)
    away = call("info", place / "v.nrrd", "--labels", labels, "--json", code=3)
    check(b"outside the scan" in away.stderr and json.loads(away.stdout)["reasons"] == ["labels-elsewhere"],
          f"elsewhere: {away}")
    shutil.rmtree(place)


def seg_nrrd(path):
    """Of a .seg.nrrd: the keys, the size, the millimetres of an index, and the voxels of each layer."""
    head, voxels = path.read_bytes().split(b"\n\n", 1)
    lines = head.decode().splitlines()[1:]
    fields = dict(line.split(": ", 1) for line in lines if ":=" not in line and not line.startswith("#"))
    keys = dict(line.split(":=", 1) for line in lines if ":=" in line)
    check((fields["space"], fields["encoding"], fields["type"]) == ("left-posterior-superior", "raw", "uint8"),
          f"fields {fields}")
    sizes = [int(word) for word in fields["sizes"].split()]
    layers = sizes.pop(0) if len(sizes) == 4 else 1
    vectors = [[float(part) for part in word[1:-1].split(",")] for word in fields["space directions"].split()
               if word != "none"]
    origin = [float(part) for part in fields["space origin"][1:-1].split(",")]
    check(len(voxels) == layers * sizes[0] * sizes[1] * sizes[2], f"{len(voxels)} bytes of {layers} x {sizes}")

    def place(*index):
        return [origin[a] + sum(n * vector[a] for n, vector in zip(index, vectors)) for a in range(3)]
    return keys, sizes, place, [voxels[layer::layers] for layer in range(layers)]


def writes_the_structures_of_phantoms():
    place = folder / "structures"
    place.mkdir()
    scan, labels = place / "m.nrrd", place / "m.seg.nrrd"
    call("convert", "--phantom", "mastoid", scan, "--labels-out", labels)
    said = json.loads(call("info", "--phantom", "mastoid", "--json").stdout)
    named = json.loads(call("info", scan, "--labels", labels, "--names", "--json").stdout)
    check(named["labels"][0]["structures"] == said["structures"], f"{named['labels']} for {said['structures']}")
    both = json.loads(call("info", "--phantom", "mastoid", "--labels", labels, "--names", "--json").stdout)
    check(both["structures"] == both["labels"][0]["structures"] == said["structures"], "a phantom with its labels")
    keys, size, where, layers = seg_nrrd(labels)
    check(size == said["dims"] and len(layers) == 2, f"{size} in {len(layers)} layers")  # the nerve lies in its canal
    of = {}
    for n, structure in enumerate(said["structures"]):
        key = f"Segment{n}_"
        check(keys[key + "Name"] == structure["name"] and keys[key + "Extent"] == "0 119 0 127 0 119", f"{key} {keys}")
        check([float(part) for part in keys[key + "Color"].split()] == structure["colour"], f"{key} {keys}")
        layer, label = layers[int(keys[key + "Layer"])], int(keys[key + "LabelValue"])
        check(layer.count(label) == structure["voxels"] > 0, f"{structure} has {layer.count(label)} voxels")
        of[structure["name"]] = lambda i, j, k, layer=layer, label=label: \
            layer[(k * size[1] + j) * size[0] + i] == label
    # by formulas of this test's own: the antrum is a ball, the canal is open to the left, the plate is above
    seen = 0
    for k in range(size[2]):
        for j in range(0, size[1], 3):
            for i in range(0, size[0], 2):
                x, y, z = where(i, j, k)
                ball = ((x + 1) ** 2 + (y - 3) ** 2 + (z - 9) ** 2) ** 0.5 - 4
                seen += ball <= 0
                check(of["Antrum"](i, j, k) == (ball <= 0) or abs(ball) < 1e-6, f"antrum at {x, y, z}")
                check(not of["Ear canal"](i, j, k) or (x > -3 and y < -4), f"canal at {x, y, z}")
                check(not of["Dura plate"](i, j, k) or z > 12, f"plate at {x, y, z}")
                check(not of["Facial nerve"](i, j, k) or of["Facial canal"](i, j, k), f"nerve at {x, y, z}")
    check(seen > 500, f"{seen} voxels of the antrum")
    for words in (("convert", *SPHERE, scan, "--labels-out", labels), ("convert", scan, place / "o.nrrd", "--labels-out", labels),
                  ("convert", "--phantom", "demo", scan, "--labels-out", place / "l.nrrd"),
                  ("convert", "--phantom", "demo", labels, "--labels-out", labels),
                  ("info", scan, "--phantom", "demo"), ("info", "--phantom", "none")):
        call(*words, code=2)
    check("structures" not in json.loads(call("info", *SPHERE, "--json").stdout), "a sphere with structures")
    shutil.rmtree(place)


def lists_series_a_line_each():
    series = pathlib.Path(__file__).resolve().parents[1] / "cases" / "hostile" / "dicom_intercept_twice"
    said = call("info", series, code=3).stdout.decode().splitlines()
    check(said[0].startswith("series: index 0, modality CT, dims [16,12,10], "), f"a series as {said[0]}")


def ticks_of(running):
    """Of the processor, that a process has used."""
    return sum(map(int, pathlib.Path(f"/proc/{running.pid}/stat").read_text().split()[13:15]))


def keeps_one_key():
    place = folder / "key"
    home = place / "home"
    place.mkdir()
    env = dict(environment, HOME=str(home))
    call("convert", *SPHERE, place / "v.nrrd", env=env)
    shutil.rmtree(home, ignore_errors=True)
    volume = ("--volume", place / "v.nrrd")
    # all wait for the reader of their trace, and then want the key in the same moment
    gate = place / "gate"
    os.mkfifo(gate)
    running = [subprocess.Popen([program, *touch(volume, "--trace", gate, "--record",
                                                 place / f"{n}.palpate")], env=env,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
               for n in range(30)]
    spent, before = 0, -1
    while spent == 0 or spent != before or any(ticks_of(one) == 0 for one in running):
        time.sleep(0.3)
        before, spent = spent, sum(map(ticks_of, running))
    reader = subprocess.Popen(["cat", gate], stdout=subprocess.DEVNULL)
    for one in running:
        check(one.wait() == 0, "a run among thirty failed")
    reader.wait()
    kept = [path for path in home.rglob("*") if path.is_file()]
    check([path.name for path in kept] == ["installation.key"], f"kept: {kept}")
    check(kept[0].stat().st_size == 32 and kept[0].stat().st_mode & 0o777 == 0o600, "the key's file")
    for n in range(30):
        said = json.loads(call("replay", place / f"{n}.palpate", *volume, "--json", env=env).stdout)
        check(said["volume"] == "same", f"recording {n} of thirty: {said['volume']}")
    # damaged, it is told of and kept
    for torn in (b"", b"torn", bytes(33)):
        kept[0].write_bytes(torn)
        done = call("replay", place / "0.palpate", *volume, "--json", env=env)
        check(json.loads(done.stdout)["volume"] == "unknown" and b"installation.key" in done.stderr,
              f"a torn key: {done}")
        check(kept[0].read_bytes() == torn, "a torn key was replaced")
    # what the environment says of folders counts where it is absolute
    for name, expected in (("relative", place / "other/.local/share"),
                           (str(place / "data"), place / "data")):
        env = dict(environment, HOME=str(place / "other"), XDG_DATA_HOME=name, XDG_CONFIG_HOME=name,
                   XDG_CACHE_HOME=name, XDG_RUNTIME_DIR=name)
        call(*touch(volume, "--record", place / "x.palpate"), env=env, cwd=place)
        check(list(expected.rglob("installation.key")), f"XDG_DATA_HOME={name}: no key in {expected}")
        check(not (place / "relative").exists(), "a relative folder was made")
    shutil.rmtree(place)


def speaks_one_language():
    place = folder / "locale"
    place.mkdir()
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", place / "de_DE.UTF-8"], capture_output=True)
    check(made.returncode == 0, f"no German locale (packaging/dependencies: locales): {made}")
    call(*touch(SPHERE, "--record", place / "r.palpate"))  # two touches differ in the time of their ticks
    answers = []
    for name in ("C", "de_DE.UTF-8"):
        env = dict(environment, LOCPATH=str(place), LC_ALL=name, LANGUAGE=name)
        volume, trace, exported = place / "v.nrrd", place / "t.csv", place / "e"
        call("convert", *SPHERE, volume, env=env)
        call(*touch(("--volume", volume), "--trace", trace), env=env)
        exported.mkdir()
        call("export", place / "r.palpate", "--out", exported / "e.csv", "--format", "csv", env=env)
        answers.append([path.read_bytes() for path in (volume, trace, exported / "e.csv")] +
                       [call("info", volume, "--json", env=env).stdout,
                        call("info", place / "none.nrrd", env=env, code=3).stderr])
        check(b"0." in answers[-1][1] and b"0." in answers[-1][2], "no decimals were compared")
        shutil.rmtree(exported)
        volume.unlink()
        trace.unlink()
    for part, c, german in zip(("volume", "trace", "export", "answer", "refusal"), *answers):
        check(c == german, f"the {part} follows the system's language")
    shutil.rmtree(place)


for test in (is_interrupted, answers_or_fails, is_whole_or_not_there, loses_no_input,
             steers_no_terminal, reads_numbers_whole, starts_the_studies, reads_the_part_that_is_named,
             lists_series_a_line_each, lists_the_structures_of_label_maps,
             writes_the_structures_of_phantoms, keeps_one_key, speaks_one_language):
    begun = time.monotonic()
    test()
    print(f"{test.__name__}: {time.monotonic() - begun:.1f} s", flush=True)
shutil.rmtree(folder)
sys.exit(outcome())
