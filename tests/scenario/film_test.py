#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A recording as a film: `palpate-cli run --record`, then `export --format video`.

Usage: film_test.py PALPATE_CLI

Under a virtual display. ffprobe counts the frames and tells their times.
"""
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FPS, SPEED, SIZE = 25, 0.5, (640, 360)
ISOVALUE = 1000.0


def cli_said(cli, *arguments, **options):
    done = subprocess.run([cli, *map(str, arguments), "--json"], capture_output=True, timeout=900,
                          **options)
    return json.loads(done.stdout), done


def probed(film):
    done = subprocess.run(
        ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
         "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames:frame=pts_time"
         ":format_tags", "-of", "json", str(film)], capture_output=True, check=True, text=True)
    assert not done.stderr, done.stderr
    return json.loads(done.stdout)


def decoded(film, size=SIZE):
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", str(film), "-f", "rawvideo", "-pix_fmt",
                          "rgb24", "-"], capture_output=True, check=True).stdout
    frame = 3 * size[0] * size[1]
    assert len(raw) % frame == 0
    return [raw[n:n + frame] for n in range(0, len(raw), frame)]


def coloured(frame, wanted):
    return sum(1 for n in range(0, len(frame), 3) if wanted(*frame[n:n + 3]))


def trace_times(trace):
    with open(trace, newline="") as file:
        return [round(float(row["t_s"]) * 1e9) for row in csv.DictReader(file)]


def check_film(said, folder, codec, times):
    film, steps = pathlib.Path(said["film"]), pathlib.Path(said["steps"])
    assert film.parent == folder and steps.parent == folder
    found = probed(film)
    stream, = found["streams"]
    assert stream["codec_name"] == codec, stream
    assert (stream["width"], stream["height"]) == SIZE, stream
    assert stream["r_frame_rate"] == f"{FPS}/1", stream
    assert stream["pix_fmt"] == "yuv420p", stream
    with open(steps, newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == said["frames"] == int(stream["nb_read_frames"]) == len(found["frames"])
    for n, (row, frame) in enumerate(zip(rows, found["frames"])):
        assert int(row["frame"]) == n
        assert abs(float(row["film_time_s"]) - float(frame["pts_time"])) < 1e-3, (row, frame)
        # the last step at or before its time
        at = times[0] + n * SPEED / FPS * 1e9
        sequence = max(k for k, t in enumerate(times) if t <= at + 0.5)
        assert (int(row["sequence"]), int(row["time_ns"])) == (sequence, times[sequence]), row
    # nothing of whoever made it
    tags = found.get("format", {}).get("tags", {})
    assert set(tags) <= {"major_brand", "minor_version", "compatible_brands"}, tags
    return rows


def main():
    cli = pathlib.Path(sys.argv[1]).resolve()
    for program in ("ffmpeg", "ffprobe"):
        if shutil.which(program) is None:
            print(f"no {program}: skipped")
            return 77
    if not os.environ.get("DISPLAY"):
        print("no X display: skipped")
        return 77
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        recording, out = work / "r.palpate", work / "out"
        said, done = cli_said(cli, "run", "--phantom", "sphere", "--isovalue", ISOVALUE, "--tool",
                              "sphere", "--hand", "slide", "--seconds", 2, "--stiffness", 1000,
                              "--record", recording, "--trace", work / "trace.csv",
                              env={**os.environ, "HOME": name})
        assert done.returncode == 0, done.stderr
        times = trace_times(work / "trace.csv")
        assert len(times) == 2000
        film = ["export", recording, "--format", "video", "--phantom", "sphere", "--size", f"{SIZE[0]}x{SIZE[1]}",
                "--fps", FPS, "--speed", SPEED]

        # MP4
        out.mkdir()
        said, done = cli_said(cli, *film, "--out", out / "film.mp4", "--burn-in")
        assert done.returncode == 0, done.stderr
        assert said["film"].endswith("/film.mp4") and said["codec"] == "h264", said
        rows = check_film(said, out, "h264", times)
        assert len(rows) == 100, len(rows)
        assert sorted(os.listdir(out)) == ["film.frames.csv", "film.mp4"], os.listdir(out)
        pictures = decoded(out / "film.mp4")
        for n in (0, 50, 99):
            blue = coloured(pictures[n], lambda r, g, b: b > r + 50 and b > g + 15)
            orange = coloured(pictures[n], lambda r, g, b: r > b + 70 and r > g + 40)
            ivory = coloured(pictures[n], lambda r, g, b: r > 60 and b < r < b + 60)
            assert blue + orange > 30 and ivory > 3000, (n, blue, orange, ivory)
        again = cli_said(cli, *film, "--out", work / "again", "--burn-in")[0]
        assert decoded(again["film"]) == pictures

        # at 4 kHz
        shutil.rmtree(out)
        out.mkdir()
        fast = work / "fast.palpate"
        said, done = cli_said(cli, "run", "--phantom", "sphere", "--isovalue", ISOVALUE, "--tool",
                              "sphere", "--hand", "slide", "--seconds", 0.4, "--stiffness", 1000,
                              "--rate", 4000, "--record", fast, "--trace", work / "fast.csv",
                              env={**os.environ, "HOME": name})
        assert done.returncode == 0, done.stderr
        fast_times = trace_times(work / "fast.csv")
        assert len(fast_times) == 1600
        said, done = cli_said(cli, "export", fast, *film[2:], "--out", out / "fast.mp4")
        assert done.returncode == 0, done.stderr
        assert len(check_film(said, out, "h264", fast_times)) == 20

        # where no program is found an MP4 is refused, and Ogg is made
        bare = {**os.environ, "PATH": str(work / "nothing")}
        shutil.rmtree(out)
        out.mkdir()
        refused = cli_said(cli, *film, "--out", out / "film.mp4", env=bare)[1]
        assert refused.returncode != 0 and b"install the package ffmpeg" in refused.stderr, refused.stderr
        assert os.listdir(out) == [], os.listdir(out)
        said, done = cli_said(cli, *film, "--out", out / "film.ogv", env=bare)
        assert done.returncode == 0, done.stderr
        assert said["film"].endswith("/film.ogv") and said["codec"] == "theora", said
        check_film(said, out, "theora", times)
        assert sorted(os.listdir(out)) == ["film.frames.csv", "film.ogv"], os.listdir(out)
        assert len(decoded(out / "film.ogv")) == 100

        # refusals: one sentence, no file
        shutil.rmtree(out)
        out.mkdir()
        blind = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        text = work / "text.palpate"
        text.write_text("this is no recording")
        for arguments, environment, code, reason in (
                (film, blind, 4, "no-display"),
                (film, {**os.environ, "DISPLAY": ":65530"}, 4, "no-display"),
                (film, {**os.environ, "MESA_GL_VERSION_OVERRIDE": "2.1",
                        "LIBGL_ALWAYS_SOFTWARE": "1"}, 4, "no-graphics"),
                (["export", recording, "--format", "video", "--phantom", "torus"], None, 4, "another-volume"),
                (["export", text, "--format", "video"], None, 3, "no-recording"),
                (["export", work / "none.palpate", "--format", "video"], None, 3, "not-found"),
                (film + ["--from", 5], None, 2, None),
                (film + ["--rate", 10], None, 2, None),
                (["export", recording, "--format", "csv", "--size", "640x360"], None, 2, None),
                (film[:4] + ["--size", "640"], None, 2, None),
                (film[:4] + ["--size", "641x360"], None, 2, None),
                (film[:4] + ["--size", "-2x99999999999"], None, 2, None),
                (film[:4] + ["--fps", "0"], None, 2, None),
                (film[:4] + ["--camera", "elsewhere"], None, 2, None)):
            said, done = cli_said(cli, *arguments, "--out", out / "film", env=environment)
            assert done.returncode == code, (arguments, done)
            assert reason is None or said["reasons"] == [reason], said
            sentence = done.stderr.decode().strip().splitlines()[-1]
            assert said["error"]["message"] == sentence and len(sentence) < 300, done.stderr
            assert os.listdir(out) == [], os.listdir(out)

        # interrupted
        slow = [cli, *film[:-2], "--speed", 0.01, "--out", out / "film", "--json"]
        process = subprocess.Popen([str(a) for a in slow], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        while not any(entry.startswith("film.mp4.part") for entry in os.listdir(out)):
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        said = json.loads(process.communicate(timeout=900)[0])
        assert process.returncode == 130 and said["error"]["code"] == 130, said
        assert os.listdir(out) == [], os.listdir(out)

        # interrupted while a frame is drawn that takes long, before ffmpeg has opened its file
        late = work / "late"
        late.mkdir()
        (late / "ffmpeg").write_text(
            f"#!/bin/sh\nsleep 3\n{shutil.which('ffmpeg')} \"$@\"\ntouch {late}/done\n")
        (late / "ffmpeg").chmod(0o755)
        large = ["3840x2160" if a == f"{SIZE[0]}x{SIZE[1]}" else a for a in film]
        process = subprocess.Popen(
            [str(a) for a in (cli, *large, "--out", out / "film", "--json")],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            env={**os.environ, "PATH": f"{late}:{os.environ['PATH']}"})
        while not any(entry.startswith("film.mp4.part") for entry in os.listdir(out)):
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=900)
        assert process.returncode == 130
        for _ in range(60):  # ended with the program, or still to find that nobody draws
            if (late / "done").exists():
                break
            time.sleep(0.1)
        assert os.listdir(out) == [], os.listdir(out)
    print("a recording becomes a film")
    return 0


if __name__ == "__main__":
    sys.exit(main())
