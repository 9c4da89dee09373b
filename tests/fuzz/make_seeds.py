#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the made seeds of the fuzzers: small files of every kind that the readers know.

Usage: make_seeds.py [FOLDER]   (default: corpus, beside this file)
"""
import gzip
import pathlib
import struct
import sys
import zlib

SEPARATOR = b"\n=file=\n"  # between the files of a folder, as dicom_fuzz.cpp cuts them
CT = "1.2.840.10008.5.1.4.1.1.2"
ENHANCED_CT = "1.2.840.10008.5.1.4.1.1.2.1"
SYNTAX = {
    "implicit": "1.2.840.10008.1.2",
    "explicit": "1.2.840.10008.1.2.1",
    "big-endian": "1.2.840.10008.1.2.2",
    "deflated": "1.2.840.10008.1.2.1.99",
    "rle": "1.2.840.10008.1.2.5",
    "jpeg": "1.2.840.10008.1.2.4.70",
    "film": "1.2.840.10008.1.2.4.100",
}
LONG = ("OB", "OW", "SQ", "UN", "UT")


class Writer:
    """Data elements in one transfer syntax."""

    def __init__(self, order="<", explicit=True):
        self.order, self.explicit = order, explicit

    def element(self, group, number, kind, value, length=None):
        if isinstance(value, str):
            value = value.encode()
        elif isinstance(value, int):
            value = struct.pack(self.order + {"US": "H", "SS": "h", "UL": "I"}[kind], value)
        if len(value) % 2:
            value += b"\0" if kind in ("UI", "OB") else b" "
        head = struct.pack(self.order + "HH", group, number)
        length = len(value) if length is None else length
        if not self.explicit:
            head += struct.pack(self.order + "I", length)
        elif kind in LONG:
            head += kind.encode() + b"\0\0" + struct.pack(self.order + "I", length)
        else:
            head += kind.encode() + struct.pack(self.order + "H", length)
        return head + value

    def sequence(self, group, number, *items, undefined=False):
        content = b""
        for item in items:
            length = 0xFFFFFFFF if undefined else len(item)
            content += struct.pack(self.order + "HHI", 0xFFFE, 0xE000, length) + item
            if undefined:
                content += struct.pack(self.order + "HHI", 0xFFFE, 0xE00D, 0)
        if undefined:
            content += struct.pack(self.order + "HHI", 0xFFFE, 0xE0DD, 0)
        return self.element(group, number, "SQ", content, 0xFFFFFFFF if undefined else None)


def numbers(*values):
    return "\\".join(f"{v:.8g}" for v in values)


def meta(syntax, instance, sop_class=CT):
    e = Writer().element
    group = (e(2, 1, "OB", b"\0\1") + e(2, 2, "UI", sop_class) + e(2, 3, "UI", instance)
             + e(2, 0x10, "UI", SYNTAX[syntax]))
    return bytes(128) + b"DICM" + e(2, 0, "UL", len(group)) + group


def fragments(*parts):
    """Compressed pixel data: an empty offset table, and the fragments."""
    out = b""
    for part in (b"",) + parts:
        out += struct.pack("<HHI", 0xFFFE, 0xE000, len(part)) + part
    return out + struct.pack("<HHI", 0xFFFE, 0xE0DD, 0)


def dicom(n=0, syntax="explicit", position=None, row=(1, 0, 0), column=(0, 1, 0), spacing=(0.5, 0.5),
          series="1.2.3", instance=None, rows=2, columns=2, bits=16, samples=1, meaning="MONOCHROME2",
          kind="ORIGINAL\\PRIMARY\\AXIAL", with_meta=True, extra=b"", pixels=None, modality="CT",
          rescale=(1, -1024), thickness=1.0):
    """The n-th slice of a series."""
    instance = instance or f"1.2.3.{n + 1}"
    w = Writer(">" if syntax == "big-endian" else "<", syntax != "implicit")
    e = w.element
    body = (e(8, 5, "CS", "ISO_IR 100") + e(8, 8, "CS", kind) + e(8, 0x16, "UI", CT)
            + e(8, 0x18, "UI", instance) + e(8, 0x60, "CS", modality) + e(0x10, 0x10, "PN", "A^B")
            + e(0x18, 0x50, "DS", numbers(thickness)) + e(0x20, 0xE, "UI", series)
            + e(0x20, 0x11, "IS", "1")
            + e(0x20, 0x32, "DS", numbers(*(position or (0, 0, n))))
            + e(0x20, 0x37, "DS", numbers(*row, *column)) + e(0x28, 2, "US", samples)
            + e(0x28, 4, "CS", meaning) + e(0x28, 0x10, "US", rows) + e(0x28, 0x11, "US", columns)
            + e(0x28, 0x30, "DS", numbers(*spacing)) + e(0x28, 0x100, "US", bits)
            + e(0x28, 0x101, "US", bits) + e(0x28, 0x102, "US", bits - 1)
            + e(0x28, 0x103, "US", 1))
    body += extra + e(0x28, 0x1052, "DS", numbers(rescale[1])) + e(0x28, 0x1053, "DS", numbers(rescale[0]))
    if pixels is None:
        body += e(0x7FE0, 0x10, "OW", bytes(rows * columns * samples * bits // 8))
    elif pixels:
        body += e(0x7FE0, 0x10, "OB", pixels, 0xFFFFFFFF)
    if syntax == "deflated":
        deflate = zlib.compressobj(wbits=-15)
        body = deflate.compress(body) + deflate.flush()
    return meta(syntax, instance) + body if with_meta else body


def enhanced(heights, undefined=False):
    """One file of several frames, each placed by its functional groups."""
    w = Writer()
    e = w.element

    def group(number, *elements):
        return w.sequence(*number, b"".join(elements), undefined=undefined)

    shared = (group((0x28, 0x9110), e(0x18, 0x50, "DS", "1"), e(0x28, 0x30, "DS", numbers(0.5, 0.5)))
              + group((0x20, 0x9116), e(0x20, 0x37, "DS", numbers(1, 0, 0, 0, 1, 0)))
              + group((0x28, 0x9145), e(0x28, 0x1052, "DS", "-1024"), e(0x28, 0x1053, "DS", "1"),
                      e(0x28, 0x1054, "LO", "HU")))
    frames = [group((0x20, 0x9113), e(0x20, 0x32, "DS", numbers(0, 0, z))) for z in heights]
    body = (e(8, 8, "CS", "ORIGINAL\\PRIMARY\\VOLUME") + e(8, 0x16, "UI", ENHANCED_CT)
            + e(8, 0x18, "UI", "1.2.9") + e(8, 0x60, "CS", "CT") + e(0x20, 0xE, "UI", "1.2.8")
            + e(0x28, 2, "US", 1) + e(0x28, 4, "CS", "MONOCHROME2")
            + e(0x28, 8, "IS", str(len(heights))) + e(0x28, 0x10, "US", 2) + e(0x28, 0x11, "US", 2)
            + e(0x28, 0x100, "US", 16) + e(0x28, 0x101, "US", 12) + e(0x28, 0x102, "US", 11)
            + e(0x28, 0x103, "US", 0)
            + w.sequence(0x5200, 0x9229, shared, undefined=undefined)
            + w.sequence(0x5200, 0x9230, *frames, undefined=undefined)
            + e(0x7FE0, 0x10, "OW", bytes(8 * len(heights))))
    return meta("explicit", "1.2.9", ENHANCED_CT) + body


def structures(sop_class, modality, *elements):
    """An object that marks parts of a scan."""
    e = Writer().element
    return (meta("explicit", "1.2.9", sop_class) + e(8, 0x16, "UI", sop_class) + e(8, 0x18, "UI", "1.2.9")
            + e(8, 0x60, "CS", modality) + e(0x20, 0xE, "UI", "1.2.8") + b"".join(elements))


def segments(kind, bits, pixels, frames, undefined=False):
    """A segmentation of frames of 4 x 3 pixels, each with its segment and height."""
    w = Writer()
    e = w.element

    def group(number, *some):
        return w.sequence(*number, b"".join(some), undefined=undefined)

    shared = (group((0x20, 0x9116), e(0x20, 0x37, "DS", numbers(1, 0, 0, 0, 1, 0)))
              + group((0x28, 0x9110), e(0x18, 0x88, "DS", "1"), e(0x28, 0x30, "DS", numbers(1, 1))))
    placed = [group((0x20, 0x9113), e(0x20, 0x32, "DS", numbers(0, 0, z)))
              + group((0x62, 0xA), e(0x62, 0xB, "US", n)) for n, z in frames]
    described = [e(0x62, 4, "US", n) + e(0x62, 5, "LO", f"s{n}")
                 + e(0x62, 0xD, "US", struct.pack("<3H", 30000, 40000, 20000)) for n in (1, 2)]
    return structures(
        "1.2.840.10008.5.1.4.1.1.66." + ("7" if kind == "LABELMAP" else "4"), "SEG",
        e(0x28, 2, "US", 1), e(0x28, 4, "CS", "MONOCHROME2"), e(0x28, 8, "IS", str(len(frames))),
        e(0x28, 0x10, "US", 3), e(0x28, 0x11, "US", 4), e(0x28, 0x100, "US", bits),
        e(0x28, 0x101, "US", bits), e(0x28, 0x102, "US", bits - 1), e(0x28, 0x103, "US", 0),
        e(0x62, 1, "CS", kind), w.sequence(0x62, 2, *described, undefined=undefined),
        e(0x62, 0xE, "US", 255), w.sequence(0x5200, 0x9229, shared, undefined=undefined),
        w.sequence(0x5200, 0x9230, *placed, undefined=undefined), e(0x7FE0, 0x10, "OB", pixels))


def contours():
    w = Writer()
    e = w.element
    drawn = [e(0x3006, 0x42, "CS", kind) + e(0x3006, 0x46, "IS", str(len(places) // 3))
             + e(0x3006, 0x50, "DS", numbers(*places))
             for kind, places in (("CLOSED_PLANAR", (-0.4, -0.4, 0, 2.4, -0.4, 0, 2.4, 1.4, 0)),
                                  ("CLOSED_PLANAR", (0.6, 0.6, 1, 2.6, 0.6, 1, 2.6, 1.6, 1, 0.6, 1.6, 1)),
                                  ("POINT", (1, 1, 1)))]
    return structures(
        "1.2.840.10008.5.1.4.1.1.481.3", "RTSTRUCT",
        w.sequence(0x3006, 0x20, e(0x3006, 0x22, "IS", "3") + e(0x3006, 0x24, "UI", "1.2.3.9")
                   + e(0x3006, 0x26, "LO", "canal")),
        w.sequence(0x3006, 0x39, e(0x3006, 0x2A, "IS", "255\\0\\9") + w.sequence(0x3006, 0x40, *drawn)
                   + e(0x3006, 0x84, "IS", "3")))


def nested(depth):
    """Sequences in each other; they end where their lengths say."""
    w = Writer()
    content = b""
    for _ in range(depth):
        content = w.sequence(8, 0x1140, content)
    return content


def dicom_seeds():
    e = Writer().element
    tilted = [dicom(n, position=(0, 0.2 * n, n)) for n in range(3)]
    return {
        "sound": [dicom(n) for n in range(4)],
        "single": [dicom()],
        "tilted": tilted,
        "tilted-uneven": [dicom(n, position=(0, 0.2 * z, z)) for n, z in enumerate((0, 1, 2.3, 3))],
        "uneven": [dicom(n, position=(0, 0, z)) for n, z in enumerate((0, 1, 2.4, 3.1, 4))],
        "missing": [dicom(n) for n in (0, 1, 2, 4, 5)],
        "duplicate": [dicom(0), dicom(1), dicom(1), dicom(2)],
        "same-place": [dicom(0), dicom(1), dicom(2, position=(0, 0, 1))],
        "no-identifiers": [dicom(n, series="", instance=" ") for n in range(2)],
        "mixed-orientation": [dicom(0), dicom(1), dicom(2, column=(0, 0.98, 0.19899749))],
        "mixed-size": [dicom(0), dicom(1, rows=3)],
        "mixed-type": [dicom(0), dicom(1, bits=8)],
        "mixed-spacing": [dicom(0), dicom(1, spacing=(0.5, 0.6))],
        "two-series": [dicom(0), dicom(1), dicom(2, series="1.2.4"), dicom(3, series="1.2.4")],
        "big-endian": [dicom(n, "big-endian") for n in range(2)],
        "implicit": [dicom(n, "implicit") for n in range(2)],
        "deflated": [dicom(n, "deflated") for n in range(2)],
        "no-meta": [dicom(n, with_meta=False) for n in range(2)],
        "no-meta-implicit": [dicom(n, "implicit", with_meta=False) for n in range(2)],
        "rle": [dicom(n, "rle", pixels=fragments(bytes(64) + b"\xfd\0")) for n in range(2)],
        "jpeg": [dicom(0, "jpeg", pixels=fragments(b"\xff\xd8\xff\xc3" + bytes(16) + b"\xff\xd9"))],
        "film": [dicom(0, "film", pixels=fragments(bytes(8)))],
        "padding": [dicom(n, extra=e(0x28, 0x120, "SS", -2000) + e(0x28, 0x121, "SS", -1990))
                    for n in range(2)],
        "enhanced": [enhanced((0, 1, 2))],
        "enhanced-undefined": [enhanced((0, 1, 2.5), undefined=True)],
        "no-geometry": [dicom(0, position=(0, 0, 0), row=(1, 0), column=(0,))],
        "frames-in-one-place": [dicom(0, rows=4, extra=e(0x28, 8, "IS", "2"))],
        "colour": [dicom(0, samples=3, meaning="RGB", bits=8)],
        "inverted": [dicom(n, meaning="MONOCHROME1") for n in range(2)],
        "localizer": [dicom(0, kind="ORIGINAL\\PRIMARY\\LOCALIZER")],
        "no-pixels": [dicom(0, pixels=b"")],
        "cut-off": [dicom(0)[:-3], dicom(1)],
        "nested": [dicom(0, extra=nested(5)), dicom(1, extra=nested(40))],
        "segments-binary": [segments("BINARY", 1, b"\x1f\x82\x40\x01\x02", ((1, 0), (2, 0), (2, 1)))],
        "segments-fractional": [segments("FRACTIONAL", 8, bytes(range(100, 124)), ((1, 0), (1, 3)), True)],
        "segments-in-one": [segments("LABELMAP", 8, bytes((0, 1, 2) * 8), ((1, 0), (1, 1)))],
        "contours": [contours()],
        "index": [meta("explicit", "1.2.7", "1.2.840.10008.1.3.10")],
    }


def nrrd(*fields, magic="NRRD0004", voxels=bytes(16), line="\n"):
    head = line.join((magic,) + fields) + line
    return head.encode() + (line.encode() + voxels if voxels is not None else b"")


def nrrd_seeds():
    sizes = ("type: short", "dimension: 3", "sizes: 2 2 2")
    raw = ("endian: little", "encoding: raw")
    lps = ("space: left-posterior-superior", "space directions: (0.5,0,0) (0,0.5,0) (0,0,1)",
           "space origin: (-1,-2,3)")
    return {
        "plain": nrrd(*sizes, *raw),
        "spacings": nrrd(*sizes, "spacings: 0.5 0.5 1", *raw),
        "units": nrrd(*sizes, "spacings: 0.5 0.5 1", 'units: "cm" "cm" "cm"', *raw),
        "bounds": nrrd(*sizes, "axis mins: 0 0 0", "axis maxs: 1 1 1", "centers: cell cell cell", *raw),
        "lps": nrrd(*sizes, *lps, "kinds: domain domain domain", *raw),
        "ras": nrrd(*sizes, "space: RAS", *lps[1:], *raw),
        "las": nrrd(*sizes, "space: left-anterior-superior", *lps[1:], *raw),
        "scanner": nrrd(*sizes, "space: scanner-xyz", *lps[1:], 'space units: "mm" "mm" "mm"', *raw),
        "space-dimension": nrrd(*sizes, "space dimension: 3", *lps[1:], *raw),
        "frame": nrrd(*sizes, *lps, "measurement frame: (1,0,0) (0,1,0) (0,0,1)", *raw, magic="NRRD0005"),
        "turned": nrrd(*sizes, lps[0], "space directions: (0,0.6,0.8) (0,-0.8,0.6) (1,0,0)", *raw),
        "sheared": nrrd(*sizes, lps[0], "space directions: (1,0.3,0) (0,1,0) (0,0,1)", *raw),
        "words": nrrd("# a comment", "content: head, HU", *sizes, "unit:=HU", "modality:=CT",
                      'labels: "x" "y" "z"', "sample units: HU", "min: 0", "max: 3", "old min: 0",
                      "old max: 1", "number: 8", "block size: 2", *raw),
        "segments": nrrd("type: uchar", "dimension: 4", "sizes: 2 2 2 1", lps[0], "kinds: list domain domain domain",
                         "space directions: none (1,0,0) (0,1,0) (0,0,1)", "space origin: (0,0,0)", "encoding: raw",
                         "Segment0_ID:=Segment_1", "Segment0_Name:=canal \\\\ \u00e4", "Segment0_Color:=1 0.5 0.2",
                         "Segment0_LabelValue:=3", "Segment0_Layer:=1", "Segment1_ID:=Segment_2", voxels=bytes(8)),
        "windows-lines": nrrd(*sizes, *raw, line="\r\n"),
        "double": nrrd("type: double", "dimension: 3", "sizes: 2 1 1", *raw),
        "uchar": nrrd("type: uchar", "dimension: 3", "sizes: 4 2 2", "encoding: raw"),
        "float": nrrd("type: float", "dimension: 3", "sizes: 2 2 1", "endian: big", "encoding: raw"),
        "block": nrrd("type: block", "dimension: 3", "sizes: 2 2 2", "block size: 2", "encoding: raw"),
        "list": nrrd("type: uchar", "dimension: 4", "sizes: 3 2 2 1",
                     "space: left-posterior-superior",
                     "space directions: none (1,0,0) (0,1,0) (0,0,1)", "kinds: vector domain domain domain",
                     "encoding: raw"),
        "time": nrrd("type: uchar", "dimension: 4", "sizes: 2 2 2 2", "kinds: domain domain domain time",
                     "encoding: raw"),
        "ascii": nrrd(*sizes, "encoding: ascii", voxels=b"1 2 3 4 5 6 7 8\n"),
        "hex": nrrd("type: uchar", "dimension: 3", "sizes: 2 2 2", "encoding: hex", voxels=b"0011223344556677"),
        "gzip": nrrd(*sizes, "endian: little", "encoding: gzip", voxels=gzip.compress(bytes(16), mtime=0)),
        "bzip2": nrrd(*sizes, "endian: little", "encoding: bzip2", voxels=b"BZh9" + bytes(12)),
        "byte-skip": nrrd(*sizes, "line skip: 0", "byte skip: -1", *raw),
        "detached": nrrd(*sizes, *raw, "data file: data.raw", "byte skip: 4080", voxels=None),
        "detached-lines": nrrd(*sizes, *raw, "line skip: 1", "datafile: data.raw", voxels=None),
        "detached-list": nrrd("type: uchar", "dimension: 3", "sizes: 8 8 3", "encoding: raw",
                              "data file: LIST 2", "slice_0.raw", "slice_1.raw", "slice_2.raw", voxels=None),
        "detached-numbered": nrrd("type: uchar", "dimension: 3", "sizes: 8 8 3", "encoding: raw",
                                  "data file: slice_%d.raw 0 2 1 2", voxels=None),
        "detached-outside": nrrd(*sizes, *raw, "data file: ../data.raw", voxels=None),
        "all-memory": nrrd("type: uchar", "dimension: 3", "sizes: 999999 999999 999999", "encoding: gzip"),
        "overflow": nrrd("type: short", "dimension: 3", "sizes: 4294967296 4294967296 2", *raw),
        "old": nrrd(*sizes, *raw, magic="NRRD0001"),
    }


def main():
    here = pathlib.Path(__file__).parent
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here / "corpus"
    for kind, seeds in (("nrrd", nrrd_seeds()), ("dicom", dicom_seeds())):
        (folder / kind).mkdir(parents=True, exist_ok=True)
        for name, content in seeds.items():
            data = SEPARATOR.join(content) if isinstance(content, list) else content
            (folder / kind / name).write_bytes(data)


if __name__ == "__main__":
    main()
