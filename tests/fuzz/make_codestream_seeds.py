#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of codestream_fuzz: requests to palpate-decode with a small frame, made by dcmtk and
gdcm, of each coding whose header is parsed here, and compressed pixel data.

Usage: make_codestream_seeds.py [FOLDER]   (default: corpus/codestream, beside this file)
"""
import pathlib
import struct
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scenario"))
import damaged_codestreams_test as made  # noqa: E402

CODING = {"jpeg-baseline": 1, "jpeg-extended": 2, "jpeg-lossless-any": 3, "jpeg-lossless": 3, "rle": 8}
COLUMNS, ROWS = 12, 8


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "corpus" / "codestream"
    folder.mkdir(parents=True, exist_ok=True)
    for name, command, bits in made.CODINGS:
        if name not in CODING:
            continue
        with tempfile.TemporaryDirectory() as place:
            data = made.encoded(pathlib.Path(place), command, made.slice_bytes(COLUMNS, ROWS, bits))
        _, begin, end = made.frame_span(data)
        frame = data[begin:end]
        request = struct.pack("<QIIIIII", len(frame), CODING[name], COLUMNS, ROWS, 1 if bits == 8 else 2, bits, 0)
        (folder / name).write_bytes(b"\0" + request + frame)
        if name == "rle":
            item = struct.pack("<II", 0xe000fffe, len(frame)) + frame
            table = struct.pack("<II", 0xe000fffe, 8) + struct.pack("<II", 0, len(item))
            (folder / "two-frames").write_bytes(
                b"\1\1" + table + item + item + struct.pack("<II", 0xe0ddfffe, 0))


if __name__ == "__main__":
    main()
