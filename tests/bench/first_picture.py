#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times the command `palpate SCAN` from its start to the first picture of a surface on the screen.

Usage: first_picture.py PALPATE [SCAN.nrrd | --phantom NAME] [--before PALPATE] [--runs N]
                        [--out FILE.json]

It starts the real program on a screen of its own (Xvfb) and looks at the screen every 5 ms, so it
sees what a user sees. Each run is followed by one that only reads and decodes the file: it holds
all voxels in memory at the end, and shares no code with Palpate. With --before another build takes
its turn as well. All are run once to warm up, then N times in turn; the medians count. The files
are then in the system's cache. "read_s" is empty for a phantom, and for what is not an NRRD of one
file with raw or gzip voxels.
"""

import argparse
import ctypes
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
import zlib

SCREEN = (1280, 900)
LINES = [(320, y, 480, 1) for y in range(140, 740, 40)]  # of the 3-D view: x, y, width, height
GROUND = 60  # brighter than this is no ground of the view
SURFACE = 0.05  # share of such pixels that is a surface, and more than a bar of progress
LONGEST = 120.0  # s
SETTLES = 2.0  # s: what a start keeps for the next one is written by then


class XImage(ctypes.Structure):
    """The beginning of Xlib's."""

    _fields_ = [(name, ctypes.c_int) for name in ("width", "height", "xoffset", "format")] + [
        ("data", ctypes.POINTER(ctypes.c_char))
    ] + [
        (name, ctypes.c_int)
        for name in ("byte_order", "bitmap_unit", "bitmap_bit_order", "bitmap_pad", "depth",
                     "bytes_per_line", "bits_per_pixel")
    ]


class Screen:
    """An Xvfb of its own, and what is on it."""

    def __init__(self):
        told, tells = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(tells), "-screen", "0", f"{SCREEN[0]}x{SCREEN[1]}x24", "-noreset"],
            pass_fds=[tells], stderr=subprocess.DEVNULL)
        os.close(tells)
        with os.fdopen(told) as number:
            self.name = ":" + number.readline().strip()
        self.x = x = ctypes.CDLL("libX11.so.6")
        x.XOpenDisplay.restype = ctypes.c_void_p
        x.XOpenDisplay.argtypes = [ctypes.c_char_p]
        x.XDefaultRootWindow.restype = ctypes.c_ulong
        x.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
        x.XGetImage.restype = ctypes.POINTER(XImage)
        x.XGetImage.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int,
                                ctypes.c_uint, ctypes.c_uint, ctypes.c_ulong, ctypes.c_int]
        x.XDestroyImage.argtypes = [ctypes.POINTER(XImage)]
        self.display = x.XOpenDisplay(self.name.encode())
        self.root = x.XDefaultRootWindow(self.display)

    def close(self):
        self.server.terminate()
        self.server.wait()

    def pixels(self, box):
        """Four bytes a pixel: blue, green, red, and one of no meaning."""
        z_pixmap = 2
        image = self.x.XGetImage(self.display, self.root, *box, ctypes.c_ulong(-1).value, z_pixmap)
        bits = ctypes.string_at(image.contents.data, image.contents.bytes_per_line * box[3])
        self.x.XDestroyImage(image)
        return bits

    def shows_surface(self):
        green = b"".join(self.pixels(line)[1::4] for line in LINES)
        return sum(value > GROUND for value in green) > SURFACE * len(green)


def first_picture(screen, palpate, what, home):
    """Seconds to the first picture, and the most memory of the process by then, MB."""
    env = dict(os.environ, DISPLAY=screen.name, XDG_CONFIG_HOME=home, XDG_STATE_HOME=home,
               XDG_DATA_HOME=home, XDG_CACHE_HOME=home, XDG_RUNTIME_DIR=home)
    begun = time.perf_counter()
    process = subprocess.Popen([palpate, "--no-notice", *what], env=env,
                               stderr=subprocess.DEVNULL)
    while not screen.shows_surface():
        if process.poll() is not None or time.perf_counter() - begun > LONGEST:
            process.kill()
            process.wait()
            sys.exit(f"{palpate} {' '.join(what)} showed no surface")
        time.sleep(0.005)
    seconds = time.perf_counter() - begun
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    time.sleep(SETTLES)
    process.terminate()
    process.wait()
    while screen.shows_surface():  # the window goes
        time.sleep(0.02)
    return seconds, int(re.search(r"VmHWM:\s*(\d+)", status).group(1)) / 1024


def reading(path):
    """Seconds to have the voxels of an NRRD in memory; nothing if it is of another kind."""
    with open(path, "rb") as file:
        head = file.read(1 << 16)
    end = head.find(b"\n\n")
    if not head.startswith(b"NRRD") or end < 0 or b"\ndata file:" in head[:end]:
        return None
    encoding = re.search(rb"\nencoding: *(\w+)", head[:end + 1]).group(1)
    if encoding not in (b"raw", b"gzip", b"gz"):
        return None
    begun = time.perf_counter()
    with open(path, "rb") as file:
        file.seek(end + 2)
        if encoding == b"raw":
            voxels = bytearray(os.path.getsize(path) - end - 2)
            file.readinto(voxels)
        else:
            packed = file.read()
            length = int.from_bytes(packed[-4:], "little")  # as the stream's end has it
            voxels = zlib.decompress(packed, zlib.MAX_WBITS + 16, length)
    seconds = time.perf_counter() - begun
    return seconds if voxels else None


def read_apart(path):
    """The same in a process of its own, whose memory is as fresh as Palpate's."""
    run = subprocess.run([sys.executable, __file__, "--read", path], check=True,
                         capture_output=True, text=True)
    return json.loads(run.stdout)


def machine():
    lines = subprocess.run(["lscpu"], capture_output=True, text=True, check=False).stdout
    model = re.search(r"Model name:\s*(.*)", lines)
    return {"cpu": model.group(1) if model else "unknown", "cores": os.cpu_count()}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("palpate")
    parser.add_argument("scan", nargs="?")
    parser.add_argument("--phantom", default="demo")
    parser.add_argument("--before", help="another build, which takes its turn")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--out")
    args = parser.parse_args()
    what = [args.scan] if args.scan else ["--phantom", args.phantom]
    builds = {"palpate": args.palpate} | ({"before": args.before} if args.before else {})
    screen = Screen()
    homes = {name: tempfile.TemporaryDirectory() for name in builds}
    try:
        first = {}
        seconds = {name: [] for name in builds}
        memory = {name: 0.0 for name in builds}
        read = []
        for run in range(args.runs + 1):
            for name, program in builds.items():
                took, most = first_picture(screen, program, what, homes[name].name)
                if run > 0:
                    seconds[name].append(took)
                else:
                    first[name] = took
                memory[name] = max(memory[name], most)
            took = read_apart(args.scan) if args.scan else None
            if run > 0 and took is not None:
                read.append(took)
    finally:
        screen.close()
        for home in homes.values():
            home.cleanup()
    result = {"machine": machine(), "of": pathlib.Path(what[-1]).name, "runs": args.runs,
              "read_s": round(statistics.median(read), 3) if read else None}
    for name, all_runs in seconds.items():
        result[name] = {"first_picture_s": round(statistics.median(all_runs), 3),
                        "least_s": round(min(all_runs), 3), "first_start_s": round(first[name], 3),
                        "most_memory_MB": round(memory[name])}
        if read:
            # of neighbours, which had the same share of the machine
            result[name]["over_reading"] = round(
                statistics.median(p / r for p, r in zip(all_runs, read)), 2)
    text = json.dumps(result, indent=2)
    print(text)
    if args.out:
        pathlib.Path(args.out).write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--read"]:
        print(json.dumps(reading(sys.argv[2])))
    else:
        main()
