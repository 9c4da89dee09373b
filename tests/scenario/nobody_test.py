#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Nobody is in any output: a series with unmistakable values in every attribute that tells who,
when or where is touched, recorded, replayed and exported, and none of them is found again.

Use: nobody_test.py PALPATE-CLI FOLDER
"""
import json
import os
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import sys
import zlib

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
N = 24  # voxels along an edge

# what the basic profile of DICOM PS3.15 E.1 removes, and some that people write into
TEXT = [
    (0x0008, 0x0050, "SH"), (0x0008, 0x0080, "LO"), (0x0008, 0x0081, "ST"), (0x0008, 0x0090, "PN"),
    (0x0008, 0x0092, "ST"), (0x0008, 0x0094, "SH"), (0x0008, 0x1010, "SH"), (0x0008, 0x1030, "LO"),
    (0x0008, 0x103E, "LO"), (0x0008, 0x1040, "LO"), (0x0008, 0x1048, "PN"), (0x0008, 0x1050, "PN"),
    (0x0008, 0x1060, "PN"), (0x0008, 0x1070, "PN"), (0x0008, 0x1080, "LO"), (0x0008, 0x2111, "ST"),
    (0x0010, 0x0010, "PN"), (0x0010, 0x0020, "LO"), (0x0010, 0x0021, "LO"), (0x0010, 0x1000, "LO"),
    (0x0010, 0x1001, "PN"), (0x0010, 0x1005, "PN"), (0x0010, 0x1040, "LO"), (0x0010, 0x1060, "PN"),
    (0x0010, 0x1090, "LO"), (0x0010, 0x2000, "LO"), (0x0010, 0x2110, "LO"), (0x0010, 0x2150, "LO"),
    (0x0010, 0x2154, "SH"), (0x0010, 0x2160, "SH"), (0x0010, 0x2180, "SH"), (0x0010, 0x21B0, "LT"),
    (0x0010, 0x21F0, "LO"), (0x0010, 0x4000, "LT"), (0x0018, 0x1000, "LO"), (0x0018, 0x1004, "LO"),
    (0x0018, 0x1030, "LO"), (0x0018, 0x1400, "LO"), (0x0018, 0x4000, "LT"), (0x0020, 0x0010, "SH"),
    (0x0020, 0x4000, "LT"), (0x0032, 0x1032, "PN"), (0x0032, 0x1060, "LO"), (0x0032, 0x4000, "LT"),
    (0x0038, 0x0010, "LO"), (0x0038, 0x0300, "LO"), (0x0038, 0x0500, "LO"), (0x0040, 0x0006, "PN"),
    (0x0040, 0x0241, "AE"), (0x0040, 0x0253, "SH"), (0x0040, 0x0254, "LO"), (0x0040, 0x1001, "SH"),
    (0x0040, 0x1400, "LT"), (0x0040, 0x2016, "LO"), (0x4008, 0x0114, "PN"), (0x4008, 0x4000, "ST"),
]
DATES = [(0x0008, 0x0012), (0x0008, 0x0020), (0x0008, 0x0021), (0x0008, 0x0022), (0x0008, 0x0023),
         (0x0010, 0x0030), (0x0032, 0x1000), (0x0038, 0x0020), (0x0040, 0x0244)]
TIMES = [(0x0008, 0x0013), (0x0008, 0x0030), (0x0008, 0x0031), (0x0008, 0x0032), (0x0008, 0x0033)]
UIDS = [(0x0008, 0x0018), (0x0020, 0x000D), (0x0020, 0x000E), (0x0020, 0x0052), (0x0020, 0x0200)]

planted = []  # what must not be found


def element(group, number, kind, value):
    value = value if isinstance(value, bytes) else value.encode()
    if len(value) % 2:
        value += b"\0" if kind == "UI" else b" "
    head = struct.pack("<HH", group, number) + kind.encode()
    if kind in ("OB", "OW", "UT"):
        return head + b"\0\0" + struct.pack("<I", len(value)) + value
    return head + struct.pack("<H", len(value)) + value


def unmistakable():
    elements = {}
    for i, (group, number, kind) in enumerate(TEXT):
        word = f"PLNT{i:02d}WHO"
        planted.append(word)
        elements[group, number] = (kind, word)
    for i, tag in enumerate(DATES):
        elements[tag] = ("DA", f"194{i}0713")
        planted.append(f"194{i}0713")
    for i, tag in enumerate(TIMES):
        elements[tag] = ("TM", f"0317{i:02d}.731913")
        planted.append(f"0317{i:02d}.731913")
    for i, tag in enumerate(UIDS):
        elements[tag] = ("UI", f"1.2.826.0.1.7777.{i}.31415")
    planted.append("1.2.826.0.1.7777")
    return elements


def slice_of(k, who, modality="CT"):
    """The k-th slice of a ball of bone."""
    instance = f"1.2.826.0.1.7777.0.{k + 1}"
    elements = dict(who)
    elements[0x0008, 0x0018] = ("UI", instance)
    for tag, kind, value in (
            ((0x0008, 0x0005), "CS", "ISO_IR 100"), ((0x0008, 0x0016), "UI", "1.2.840.10008.5.1.4.1.1.2"),
            ((0x0008, 0x0008), "CS", "ORIGINAL\\PRIMARY\\AXIAL"),
            ((0x0008, 0x0060), "CS", modality), ((0x0018, 0x0050), "DS", "2"),
            ((0x0020, 0x0013), "IS", str(k + 1)), ((0x0020, 0x0032), "DS", f"0\\0\\{2 * k}"),
            ((0x0020, 0x0037), "DS", "1\\0\\0\\0\\1\\0"), ((0x0028, 0x0002), "US", struct.pack("<H", 1)),
            ((0x0028, 0x0004), "CS", "MONOCHROME2"), ((0x0028, 0x0010), "US", struct.pack("<H", N)),
            ((0x0028, 0x0011), "US", struct.pack("<H", N)), ((0x0028, 0x0030), "DS", "2\\2"),
            ((0x0028, 0x0100), "US", struct.pack("<H", 16)), ((0x0028, 0x0101), "US", struct.pack("<H", 16)),
            ((0x0028, 0x0102), "US", struct.pack("<H", 15)), ((0x0028, 0x0103), "US", struct.pack("<H", 1)),
            ((0x0028, 0x1052), "DS", "0"), ((0x0028, 0x1053), "DS", "1"),
            ((0x0009, 0x0010), "LO", "PLNTPRIVATE"), ((0x0009, 0x1001), "LO", "PLNTSECRET")):
        elements[tag] = (kind, value)
    middle = (N - 1) / 2
    pixels = b"".join(
        struct.pack("<h", int(max(-1000, min(1500, 200 * (8 - ((i - middle) ** 2 + (j - middle) ** 2
                                                             + (k - middle) ** 2) ** 0.5)))))
        for j in range(N) for i in range(N))
    elements[0x7FE0, 0x0010] = ("OW", pixels)
    meta = (element(2, 1, "OB", b"\0\1") + element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2")
            + element(2, 3, "UI", instance) + element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
            + element(2, 0x16, "AE", "PLNTSENDER"))
    return (bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta
            + b"".join(element(*tag, *elements[tag]) for tag in sorted(elements)))


def unfolded(path):
    """All bytes of a file, and of what is packed in it."""
    whole = path.read_bytes()
    yield whole
    if whole.startswith(b"SQLite format 3"):
        base = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        for (table,) in base.execute("SELECT name FROM sqlite_schema WHERE type = 'table'").fetchall():
            for row in base.execute(f"SELECT * FROM {table}"):
                for value in row:
                    if isinstance(value, bytes):
                        yield value
                        try:
                            yield zlib.decompress(value)
                        except zlib.error:
                            pass
                    else:
                        yield str(value).encode()
    if whole.startswith(b"\x89HDF"):
        try:
            import h5py
        except ImportError:
            return
        found = []
        with h5py.File(path) as file:
            def look(name, thing):
                found.append(repr((name, dict(thing.attrs))).encode())
                if isinstance(thing, h5py.Dataset):
                    found.append(repr(thing[()]).encode() + bytes(str(thing.dtype), "ascii"))
                    found.append(thing[()].tobytes() if hasattr(thing[()], "tobytes") else b"")
            look("/", file)
            file.visititems(look)
        yield from found


def main():
    who = unmistakable()
    planted.extend(["PLNTPRIVATE", "PLNTSECRET", "PLNTSENDER", "PLNTFOLDER", "PLNTFILE", "PLNTTOOL"])
    scan = folder / "in" / "PLNTFOLDER_Jane"
    scan.mkdir(parents=True)
    for k in range(N):
        (scan / f"PLNTFILE_{k}.dcm").write_bytes(slice_of(k, who))
    tool = folder / "in" / "PLNTTOOL.csv"
    tool.write_text("x,y,z\n0,0,0\n0.001,0,0\n0,0.001,0\n0,0,0.001\n")
    out = folder / "out"
    out.mkdir()
    environment = dict(os.environ, HOME=str(folder / "home"), XDG_DATA_HOME=str(folder / "home/data"))
    said = []

    def call(*arguments, code=0):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True,
                              env=environment)
        assert done.returncode == code, (arguments, done)
        # a path that the user typed may be shown to him
        words = done.stdout + done.stderr
        for typed in arguments:
            words = words.replace(str(typed), "")
        said.append((arguments[0], words.encode()))
        return done.stdout

    call("info", scan, "--json")
    call("convert", scan, out / "volume.nrrd")
    record = ("run", "--volume", scan, "--isovalue", "300", "--stiffness", "1000", "--seconds", "2",
              "--json")
    call(*record, "--hand", "slide", "--tool", tool, "--trace", out / "t.csv", "--record",
         out / "r.palpate")
    call(*record, "--hand", "tap", "--tool", "probe", "--record", out / "named.palpate")
    replayed = json.loads(call("replay", out / "r.palpate", "--volume", scan, "--json"))
    assert replayed["differing"] == 0 and replayed["volume"] == "same", replayed
    formats = subprocess.run([program, "export", "--help"], capture_output=True, text=True).stdout
    assert all(name in formats for name in ("csv", "motion-bids", "hdf5", "mcap")), formats
    for name, target in (("csv", "e.csv"), ("motion-bids", "e"), ("hdf5", "e.h5"), ("mcap", "e.mcap")):
        call("export", out / "r.palpate", "--format", name, "--out", out / target)
    # a modality that is no code, and no text: neither written nor in the way
    odd = folder / "in" / "PLNTFOLDER_odd"
    odd.mkdir()
    for k in range(N):
        (odd / f"PLNTFILE_{k}.dcm").write_bytes(slice_of(k, who, b"PLNTMODALITY\xff\xfe"))
    planted.append("PLNTMODALITY")
    call("run", "--volume", odd, "--isovalue", "300", "--stiffness", "1000", "--seconds", "0.5",
         "--hand", "tap", "--tool", "probe", "--record", out / "odd.palpate")
    # refused, it says nothing of whom either
    call("run", "--volume", scan, "--isovalue", "-99999", "--tool", "probe", "--hand", "tap",
         "--seconds", "1", "--stiffness", "1", code=3)

    files = [path for root in (out, folder / "home") for path in root.rglob("*") if path.is_file()]
    assert len(files) >= 9, files
    looked = 0
    for path in files:
        for piece in unfolded(path):
            looked += len(piece)
            for word in planted:
                for spelt in (word.encode(), word.encode("utf-16-le")):
                    assert spelt not in piece, f"{word} is in {path.name}"
        assert not any(word in str(path.relative_to(folder)) for word in planted), path
    for command, words in said:
        for word in planted:
            assert word.encode() not in words, f"{command} says {word}"
    named = sqlite3.connect(out / "named.palpate").execute("SELECT tool FROM scene").fetchall()
    assert named == [("probe",)], named
    # it can find what is there
    assert any(b"PLNT00WHO" in piece for piece in unfolded(scan / "PLNTFILE_0.dcm"))
    print(f"{len(planted)} planted values, {len(files)} files, {looked} bytes: none found")


if __name__ == "__main__":
    main()
