#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compressed slices that other programs made, whole, damaged, and with the frames of other slices,
read by palpate-cli: each is refused with a sentence, or gives the same bytes whatever the memory held
before. Nothing ends by a signal, hangs, or shows a patient.

    damaged_codestreams_test.py palpate-cli FOLDER [--of-each N] [--seed S] [--program PATH]

--of-each is how many damages of each kind each coding gets: 1 in the tests, 100 for a study."""
import argparse
import os
import random
import resource
import shutil
import struct
import subprocess
import sys
from pathlib import Path

PLANTED = b"Doe^Planted PATIENT-COMMENT 5501"
LONGEST_S = 15.0  # of a processor
HANGS_S = 900
MOST_KB = 4 * 1024 * 1024


def element(group, number, kind, value):
    if len(value) % 2:
        value += b"\0" if kind == "UI" else b" "
    head = struct.pack("<HH", group, number) + kind.encode()
    if kind in ("OB", "OW"):
        return head + struct.pack("<HI", 0, len(value)) + value
    return head + struct.pack("<H", len(value)) + value


def us(value):
    return struct.pack("<H", value)


def slice_bytes(columns, rows, bits, samples=1, instance="1.2.3.4.5"):
    """A slice of smooth structure with noise, so that every coding has something to do."""
    ct = b"1.2.840.10008.5.1.4.1.1.2"
    meta = (element(2, 1, "OB", b"\0\1") + element(2, 2, "UI", ct) +
            element(2, 3, "UI", instance.encode()) + element(2, 0x10, "UI", b"1.2.840.10008.1.2.1"))
    dice = random.Random(7)
    top = (1 << bits) - 1
    values = []
    for j in range(rows):
        for i in range(columns):
            inside = (i - columns / 2) ** 2 + (j - rows / 2) ** 2 < (min(rows, columns) / 3) ** 2
            value = int(top * (0.7 if inside else 0.1)) + dice.randint(0, top // 20)
            values += [min(value, top)] * samples
    wide = bits > 8
    pixels = b"".join(struct.pack("<H" if wide else "B", v) for v in values)
    if len(pixels) % 2:
        pixels += b"\0"
    allocated = 16 if wide else 8
    body = (element(8, 8, "CS", b"ORIGINAL\\PRIMARY\\AXIAL") + element(8, 0x16, "UI", ct) +
            element(8, 0x18, "UI", instance.encode()) + element(8, 0x60, "CS", b"CT") +
            element(0x10, 0x10, "PN", PLANTED) + element(0x10, 0x4000, "LT", PLANTED * 200) +
            element(0x18, 0x50, "DS", b"1") +
            element(0x20, 0xd, "UI", b"1.2.3") + element(0x20, 0xe, "UI", b"1.2.3.4") +
            element(0x20, 0x11, "IS", b"1") + element(0x20, 0x32, "DS", b"0\\0\\0") +
            element(0x20, 0x37, "DS", b"1\\0\\0\\0\\1\\0") + element(0x28, 2, "US", us(samples)) +
            element(0x28, 4, "CS", b"RGB" if samples == 3 else b"MONOCHROME2") +
            (element(0x28, 6, "US", us(0)) if samples == 3 else b"") +
            element(0x28, 0x10, "US", us(rows)) + element(0x28, 0x11, "US", us(columns)) +
            element(0x28, 0x30, "DS", b"1\\1") + element(0x28, 0x100, "US", us(allocated)) +
            element(0x28, 0x101, "US", us(bits)) + element(0x28, 0x102, "US", us(bits - 1)) +
            element(0x28, 0x103, "US", us(0)) + element(0x28, 0x1052, "DS", b"0") +
            element(0x28, 0x1053, "DS", b"1") +
            element(0x7fe0, 0x10, "OW" if wide else "OB", pixels))
    return (b"\0" * 128 + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body)


# name, encoder of (plain file, coded file), bits that it takes
CODINGS = [
    ("jpeg-baseline", ["dcmcjpeg", "+eb"], 8),
    ("jpeg-extended", ["dcmcjpeg", "+ee"], 12),
    ("jpeg-lossless", ["dcmcjpeg", "+e1"], 16),
    ("jpeg-lossless-any", ["dcmcjpeg", "+el", "+sv", "6"], 12),
    ("jpeg-ls", ["dcmcjpls", "+el"], 16),
    ("jpeg-ls-near", ["dcmcjpls", "+en"], 16),
    ("jpeg-2000", ["gdcmconv", "--j2k"], 16),
    ("rle", ["dcmcrle"], 16),
    ("jpeg-lossless-gdcm", ["gdcmconv", "--jpeg"], 16),
    ("jpeg-ls-gdcm", ["gdcmconv", "--jpegls"], 16),
    ("rle-gdcm", ["gdcmconv", "--rle"], 16),
]
LOSSLESS = {"jpeg-lossless", "jpeg-lossless-any", "jpeg-ls", "jpeg-2000", "rle",
            "jpeg-lossless-gdcm", "jpeg-ls-gdcm", "rle-gdcm"}


def family(name):
    """What codings have in common that one decoder reads and one transfer syntax may name."""
    return next(f for f in ("jpeg-lossless", "jpeg-ls", "jpeg-2000", "rle", "jpeg") if name.startswith(f))


def frame_span(data):
    """Where the first frame's bytes lie: the second item of the pixel data, and its length's place."""
    at = data.rindex(b"\xe0\x7f\x10\x00OB\0\0\xff\xff\xff\xff") + 12
    length = struct.unpack_from("<I", data, at + 4)[0]
    at += 8 + length
    return at + 4, at + 8, at + 8 + struct.unpack_from("<I", data, at + 4)[0]


def with_frame(data, frame):
    length_at, begin, end = frame_span(data)
    if len(frame) % 2:
        frame += b"\0"
    return data[:length_at] + struct.pack("<I", len(frame)) + frame + data[end:]


def seconds():
    """Of a processor, by all programs that were run so far: a busy machine adds none."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Run:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.tried = self.refused = 0
        self.faults = []

    def one(self, arguments, perturb):
        began = seconds()
        try:
            done = subprocess.run([self.program, *arguments], capture_output=True, timeout=HANGS_S,
                                  env={**os.environ, "MALLOC_PERTURB_": str(perturb)})
        except subprocess.TimeoutExpired:
            return None, b"", HANGS_S
        return done.returncode, done.stdout + done.stderr, seconds() - began

    def read(self, name, data, must_be_refused=False, must_be=None):
        """Reads one file as users would; returns its voxels, or None where it is refused."""
        self.tried += 1
        path = self.folder / "slice.dcm"
        path.write_bytes(data)
        results = []
        for perturb in (0, 85, 170):
            out = self.folder / "slice.nrrd"
            out.unlink(missing_ok=True)
            code, said, took = self.one(["convert", str(path), str(out)], perturb)
            voxels = out.read_bytes() if out.exists() else None
            results.append((code, voxels))
            if took > LONGEST_S:
                self.faults.append(f"{name}: {took:.0f} s")
            if code not in (0, 3):
                self.faults.append(f"{name}: exit {code}: {said[-300:]!r}")
            if code == 3 and (len(said.strip()) < 40 or voxels is not None):
                self.faults.append(f"{name}: refused without a sentence, or with a file")
            if PLANTED[:12] in said or (voxels and PLANTED[:12] in voxels):
                self.faults.append(f"{name}: the patient is in the output")
            if code == 3 and perturb == 0:
                break
        if len(set(results)) > 1:
            self.faults.append(f"{name}: not the same twice")
        code, voxels = results[0]
        self.refused += code == 3
        if must_be_refused and code == 0:
            self.faults.append(f"{name}: taken for sound")
            shutil.copy(path, self.folder / f"taken-{name.replace('/', '-').replace(' ', '-')}.dcm")
        if must_be is not None and voxels != must_be:
            self.faults.append(f"{name}: other voxels than the plain slice's (exit {code})")
        return voxels


def encoded(folder, command, plain):
    source, to = folder / "plain.dcm", folder / "coded.dcm"
    source.write_bytes(plain)
    to.unlink(missing_ok=True)
    subprocess.run([*command, str(source), str(to)], check=True, capture_output=True)
    return to.read_bytes()


def header_size(frame, name):
    """Bytes of a frame before its coded data."""
    if name.startswith("rle"):
        return 64
    mark = b"\xff\x93" if name.startswith("jpeg-2000") else b"\xff\xda"
    return frame.index(mark) + 12


def damages(frame, header, dice):
    """Endless damages of every kind, one after the other."""
    while True:
        cut = dice.randint(0, len(frame) - 2)
        yield "cut", frame[:cut]
        at = dice.randint(0, max(0, len(frame) - 512))
        yield "sector", frame[:at] + bytes(min(512, len(frame) - at)) + frame[at + 512:]
        at, bit = dice.randint(0, header - 1), dice.randint(0, 7)
        yield "header bit", frame[:at] + bytes([frame[at] ^ 1 << bit]) + frame[at + 1:]
        changed = bytearray(frame)
        for _ in range(dice.randint(1, 8)):
            changed[dice.randint(0, len(frame) - 1)] = dice.randint(0, 255)
        yield "bytes", bytes(changed)
        at = dice.randint(0, len(frame) - 1)
        yield "missing bytes", frame[:at] + frame[at + dice.randint(1, 64):]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--of-each", type=int, default=6)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    missing = [c[1][0] for c in CODINGS if shutil.which(c[1][0]) is None]
    if missing:
        print("NOT CHECKED:", ", ".join(sorted(set(missing))), "is not here")
        return 77
    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    run = Run(arguments.program, arguments.folder)
    dice = random.Random(arguments.seed)

    columns, rows = 48, 32
    plains = {bits: slice_bytes(columns, rows, bits) for bits in (8, 12, 16)}
    voxels = {bits: run.read(f"plain {bits}", plain) for bits, plain in plains.items()}
    frames = {}
    for name, command, bits in CODINGS:
        data = encoded(arguments.folder, command, plains[bits])
        shown = run.read(f"{name} whole", data, must_be=voxels[bits] if name in LOSSLESS else None)
        if shown is None:
            run.faults.append(f"{name}: refused whole")
        _, begin, end = frame_span(data)
        frames[name] = (data, data[begin:end])

    # frames of other shapes, and of other codings
    shapes = [(columns * 2, rows * 2, 0, 1), (columns * 20, rows * 20, 0, 1), (columns // 2, rows, 0, 1),
              (rows, columns, 0, 1), (columns, rows + 1, 0, 1), (columns, rows, 1, 1),
              (columns, rows, 0, 3)]
    for name, command, bits in CODINGS:
        for w, h, other_depth, samples in (shapes if arguments.of_each > 5 else dice.sample(shapes, 3)):
            other = {8: 16, 12: 8, 16: 8}[bits] if other_depth else (8 if samples == 3 else bits)
            if name in ("jpeg-baseline", "jpeg-extended") and other_depth:
                continue  # the process has one depth
            if samples == 3 and name == "jpeg-extended":
                continue
            try:
                foreign = encoded(arguments.folder, command, slice_bytes(w, h, other, samples))
            except subprocess.CalledProcessError:
                continue
            _, begin, end = frame_span(foreign)
            run.read(f"{name} with a frame of {w}x{h}x{samples} of {other} bits",
                     with_frame(frames[name][0], foreign[begin:end]),
                     # RLE knows a number of pixels, and no rows
                     must_be_refused=family(name) != "rle" or w * h != columns * rows)
    for name, (data, _) in frames.items():
        others = [donor for donor in frames if family(donor) != family(name)]
        for donor in dice.sample(others, min(len(others), max(2, arguments.of_each // 10))):
            run.read(f"{name} with a frame of {donor}", with_frame(data, frames[donor][1]),
                     must_be_refused=True)

    # damages of frames, each kind in turn
    for name, (data, frame) in frames.items():
        kinds = damages(frame, header_size(frame, name), dice)
        for n in range(5 * arguments.of_each):
            kind, bytes_ = next(kinds)
            run.read(f"{name} {kind} {n}", with_frame(data, bytes_),
                     must_be_refused=kind == "cut" and len(bytes_) < len(frame) - 4)

    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    if most > MOST_KB:
        run.faults.append(f"{most} kB resident")
    print(f"{run.tried} files, {run.refused} refused, at most {most // 1024} MB resident")
    for fault in run.faults[:40]:
        print("FAULT", fault)
    print(len(run.faults), "faults")
    return 1 if run.faults else 0


if __name__ == "__main__":
    sys.exit(main())
