#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Structures that other programs write, read back to the voxel.

Usage: structures_test.py PALPATE_CLI

A series of slices, and structures of it from formulas. Plastimatch draws them as contours, dcmtk
writes a segmentation in every encoding that it knows, and pydicom reads that one and makes one of
its own. Each must mark the voxels of the formulas: as many, in the same box, with the same centre.
A program that is not there is named, and its part left out.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, outcome  # noqa: E402
from dicom_slices import Head, Person, Series, element, file_of, sequence, uid, us  # noqa: E402

SEG = "1.2.840.10008.5.1.4.1.1.66.4"
SIDE, SLICES = 64, 24
PLACES = [(i, j, k) for k in range(SLICES) for j in range(SIDE) for i in range(SIDE)]

program = sys.argv[1]


def in_shell(i, j, k):
    return 6.2 < ((i - 30.3) ** 2 + (j - 28.7) ** 2 + (1.3 * (k - 11)) ** 2) ** 0.5 < 13.1


def in_block(i, j, k):
    """A block with a hole through some of it, nearer to one side of each axis."""
    return 40 <= i < 52 and 8 <= j < 30 and 3 <= k < 9 and not (44 <= i < 47 and 12 <= j < 20)


SHAPES = {"shell": in_shell, "block": in_block}
MASKS = {name: {place for place in PLACES if inside(*place)} for name, inside in SHAPES.items()}


def measured(mask):
    """What `info` says of a mask, whose voxels are 1 mm apart."""
    axes = list(zip(*mask))
    return {"voxels": len(mask), "first": [min(a) for a in axes], "end": [max(a) + 1 for a in axes],
            "centre": [sum(a) / len(mask) for a in axes]}


def info(*args, code=0):
    done = subprocess.run([program, "info", *map(str, args), "--json"], capture_output=True)
    check(done.returncode == code, f"info {args[1:]} ends with {done.returncode}: {done.stderr[-300:]}")
    return json.loads(done.stdout)


def compare(what, slices, file, masks, options=()):
    """Whether the structures of a file are these masks, in their order."""
    said = info(slices, "--labels", file, *options)["labels"][0]["structures"]
    if not check(len(said) == len(masks), f"{what}: {len(said)} structures"):
        return
    for structure, mask in zip(said, masks):
        should = measured(mask)
        check(structure["voxels"] == should["voxels"] and structure["box"]["first"] == should["first"]
              and structure["box"]["end"] == should["end"]
              and all(abs(a - b) < 1e-6 for a, b in zip(structure["centre_mm"], should["centre"])),
              f"{what}: {structure} in place of {should}")
    print(what, "as it should be")


def here(name):
    if shutil.which(name):
        return True
    print(f"NOT CHECKED: {name} is not here")
    return False


def nrrd_of(values):
    head = ("NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: {0} {0} {1}\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    return head.format(SIDE, SLICES).encode() + bytes(values)


def contours_by_plastimatch(folder, series):
    if not here("plastimatch"):
        return
    bits = folder / "bits.nrrd"
    bits.write_bytes(nrrd_of(sum((place in mask) << n for n, mask in enumerate(MASKS.values()))
                             for place in PLACES))
    subprocess.run(["plastimatch", "convert", "--input-ss-img", bits, "--referenced-ct", series.folder,
                    "--output-dicom", folder / "drawn"], check=True, capture_output=True)
    compare("contours by plastimatch", series.folder, next((folder / "drawn").iterdir()), MASKS.values())
    # a survey finds them beside the slices
    study = folder / "study"
    shutil.copytree(series.folder, study / "ct")
    shutil.copytree(folder / "drawn", study / "rt")
    found = info(study)["structures"]
    check(len(found) == 1 and found[0]["kind"] == "contours" and found[0]["file"].startswith("rt/"),
          f"a survey lists {found}")


def views():
    """Slices along each axis, both ways: the axis, the direction of rows and of columns, and their signs."""
    for axis in range(3):
        along, down = [a for a in range(3) if a != axis]
        for signs in ((1, 1), (-1, 1), (1, -1)):
            yield axis, along, down, signs


def unit(axis, sign):
    return [sign * (a == axis) for a in range(3)]


def text(numbers):
    return "\\".join(f"{n:g}" for n in numbers)


def frames_of(view):
    """For each segment and slice that has some: place of the first pixel, and the pixels."""
    axis, along, down, signs = view
    sizes = (SIDE, SIDE, SLICES)
    for number, mask in enumerate(MASKS.values(), 1):
        for plane in range(sizes[axis]):
            at = lambda c, r: tuple(
                plane if a == axis else (c if signs[0] > 0 else sizes[a] - 1 - c) if a == along
                else r if signs[1] > 0 else sizes[a] - 1 - r for a in range(3))
            pixels = [at(c, r) in mask for r in range(sizes[down]) for c in range(sizes[along])]
            if any(pixels):
                yield number, at(0, 0), pixels


def packed(bits):
    return bytes(sum(bit << n for n, bit in enumerate(bits[at:at + 8])) for at in range(0, len(bits), 8))


def segmentation(series, view, fractional=False):
    axis, along, down, signs = view
    sizes = (SIDE, SIDE, SLICES)
    depth = 8 if fractional else 1
    frames = list(frames_of(view))
    pixels = [bit for _, _, some in frames for bit in some]
    groups = [sequence(0x20, 0x9113, element(0x20, 0x32, "DS", text(place)))
              + sequence(0x62, 0xa, element(0x62, 0xb, "US", us(number))) for number, place, _ in frames]
    shared = (sequence(0x20, 0x9116, element(0x20, 0x37, "DS", text(unit(along, signs[0]) + unit(down, signs[1]))))
              + sequence(0x28, 0x9110, element(0x18, 0x88, "DS", "1") + element(0x28, 0x30, "DS", "1\\1")))
    segments = [element(0x62, 4, "US", us(n)) + element(0x62, 5, "LO", name)
                for n, name in enumerate(MASKS, 1)]
    body = (element(8, 0x16, "UI", SEG) + element(8, 0x18, "UI", uid()) + element(8, 0x60, "CS", "SEG")
            + element(0x10, 0x10, "PN", series.person.name) + element(0x10, 0x20, "LO", series.person.id)
            + element(0x20, 0xd, "UI", series.study) + element(0x20, 0xe, "UI", uid())
            + element(0x20, 0x11, "IS", "7") + element(0x20, 0x52, "UI", series.study + ".9")
            + element(0x28, 2, "US", us(1)) + element(0x28, 4, "CS", "MONOCHROME2")
            + element(0x28, 8, "IS", str(len(frames))) + element(0x28, 0x10, "US", us(sizes[down]))
            + element(0x28, 0x11, "US", us(sizes[along])) + element(0x28, 0x100, "US", us(depth))
            + element(0x28, 0x101, "US", us(depth)) + element(0x28, 0x102, "US", us(depth - 1))
            + element(0x28, 0x103, "US", us(0))
            + element(0x62, 1, "CS", "FRACTIONAL" if fractional else "BINARY") + sequence(0x62, 2, *segments)
            + (element(0x62, 0xe, "US", us(200)) if fractional else b"")
            + sequence(0x5200, 0x9229, shared) + sequence(0x5200, 0x9230, *groups)
            + element(0x7fe0, 0x10, "OB", bytes(150 * bit for bit in pixels) if fractional else packed(pixels)))
    return file_of(SEG, uid(), body)


def segments_by_dcmtk(folder, series):
    for view in views():
        file = folder / "view.dcm"
        file.write_bytes(segmentation(series, view))
        compare(f"segments along {view}", series.folder, file, MASKS.values())
    if not here("dcmconv"):
        return
    plain = next(views())
    ways = {"implicit": ["dcmconv", "+ti"], "undefined lengths": ["dcmconv", "-e", "+te"],
            "deflated": ["dcmconv", "+td"]}
    for name, command in ways.items():
        (folder / "plain.dcm").write_bytes(segmentation(series, plain))
        subprocess.run([*command, folder / "plain.dcm", folder / "way.dcm"], check=True)
        compare(f"segments, {name}", series.folder, folder / "way.dcm", MASKS.values())
    (folder / "plain.dcm").write_bytes(segmentation(series, plain, fractional=True))
    compare("fractions", series.folder, folder / "plain.dcm", MASKS.values())
    subprocess.run(["dcmcrle", folder / "plain.dcm", folder / "way.dcm"], check=True)
    compare("fractions, RLE", series.folder, folder / "way.dcm", MASKS.values())
    subprocess.run(["dcmconv", "+tb", folder / "plain.dcm", folder / "way.dcm"], check=True)
    compare("fractions, big endian", series.folder, folder / "way.dcm", MASKS.values())


def segments_by_pydicom(folder, series):
    try:
        import numpy
        import pydicom
        from pydicom.pixel_data_handlers.numpy_handler import pack_bits
    except ImportError as missing:
        print(f"NOT CHECKED: {missing}")
        return
    # a reader that shares no code with Palpate finds the same masks in the test's own file
    view = list(views())[4]
    file = folder / "own.dcm"
    file.write_bytes(segmentation(series, view))
    data = pydicom.dcmread(file)
    pixels = data.pixel_array
    across = numpy.array(data.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence[0]
                         .ImageOrientationPatient, float)
    found = {1: set(), 2: set()}
    for frame, groups in zip(pixels, data.PerFrameFunctionalGroupsSequence):
        place = numpy.array(groups.PlanePositionSequence[0].ImagePositionPatient, float)
        number = groups.SegmentIdentificationSequence[0].ReferencedSegmentNumber
        for row, column in numpy.argwhere(frame):
            found[number].add(tuple(int(round(x)) for x in place + column * across[:3] + row * across[3:]))
    check(list(found.values()) == list(MASKS.values()), "pydicom reads other masks than were written")
    # and the other way: its bits and its sequences
    data.PixelData = pack_bits(pixels.astype(numpy.uint8).flatten())
    for name in ("SegmentSequence", "SharedFunctionalGroupsSequence", "PerFrameFunctionalGroupsSequence"):
        data[name].is_undefined_length = True
    data.save_as(folder / "theirs.dcm", write_like_original=False)
    compare("segments by pydicom", series.folder, folder / "theirs.dcm", MASKS.values())


def of_another_scan(folder, series, other):
    file = folder / "own.dcm"
    file.write_bytes(segmentation(series, next(views())))
    said = info(other.folder, "--labels", file, code=3)
    check(said["reasons"] == ["another-patient"], f"of another patient: {said}")
    texts = json.dumps(said)
    check(not any(word in texts for word in series.person.texts() + other.person.texts()),
          f"an identifier is told: {texts}")
    compare("agreed", other.folder, file, MASKS.values(), ["--belongs"])


with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    head = Head()
    series = Series(folder / "ct", head, Person(), SLICES, SIDE)
    contours_by_plastimatch(folder, series)
    segments_by_dcmtk(folder, series)
    segments_by_pydicom(folder, series)
    of_another_scan(folder, series, Series(folder / "other", head, Person(), SLICES, SIDE))
sys.exit(outcome())
