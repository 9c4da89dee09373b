# SPDX-License-Identifier: BSD-3-Clause
"""Slices of a made head as DICOM files, byte by byte, of somebody whose names are nowhere else."""
import array
import concurrent.futures
import math
import pathlib
import random
import secrets
import struct
import subprocess

CT = "1.2.840.10008.5.1.4.1.1.2"
ENHANCED = {"CT": "1.2.840.10008.5.1.4.1.1.2.1", "MR": "1.2.840.10008.5.1.4.1.1.4.1"}
EXPLICIT = "1.2.840.10008.1.2.1"

# other transfer syntaxes, by the programs that make them
CONVERTED = {
    "implicit": ["dcmconv", "+ti"],
    "big-endian": ["dcmconv", "+tb"],
    "deflated": ["dcmconv", "+td"],
    "jpeg-lossless": ["dcmcjpeg", "+e1"],
    "jpeg-ls": ["dcmcjpls", "+el"],
    "rle": ["dcmcrle"],
    "jpeg-2000": ["gdcmconv", "--j2k"],
}


class Person:
    """Somebody whose every text is found again where it is written."""

    def __init__(self):
        word = lambda: secrets.token_hex(5).upper()
        self.name, self.id = f"PLANTED{word()}^{word()}", f"ID{word()}"
        self.accession, self.birth = f"AN{word()}", "19410203"
        self.date = "20240305"  # of the study
        self.study, self.series = f"STUDY{word()}", f"SERIES{word()}"

    def texts(self):
        return [*self.name.split("^"), self.id, self.accession, self.birth, self.study, self.series]


def uid():
    return f"2.25.{secrets.randbits(100)}"


def element(group, number, kind, value):
    if isinstance(value, str):
        value = value.encode()
    if len(value) % 2:
        value += b"\0" if kind in ("UI", "OB") else b" "
    head = struct.pack("<HH", group, number) + kind.encode()
    long = kind in ("OB", "OW", "SQ", "UN")
    return head + (struct.pack("<HI", 0, len(value)) if long else struct.pack("<H", len(value))) + value


def us(value):
    return struct.pack("<H", value)


def sequence(group, number, *items):
    """A sequence with stated lengths."""
    return element(group, number, "SQ", b"".join(
        struct.pack("<HHI", 0xfffe, 0xe000, len(item)) + item for item in items))


def file_of(sop_class, instance, body):
    """A data set of explicit little endian as a file."""
    meta = (element(2, 1, "OB", b"\0\1") + element(2, 2, "UI", sop_class) + element(2, 3, "UI", instance)
            + element(2, 0x10, "UI", EXPLICIT) + element(2, 0x12, "UI", "1.2.3.4"))
    return bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body


def origin(person, study, series, instance, modality, sop_class):
    """Whose image this is: the elements up to the patient's birth date."""
    return (element(8, 8, "CS", "ORIGINAL\\PRIMARY\\AXIAL") + element(8, 0x16, "UI", sop_class)
            + element(8, 0x18, "UI", instance) + element(8, 0x20, "DA", person.date)
            + element(8, 0x50, "SH", person.accession) + element(8, 0x60, "CS", modality)
            + element(8, 0x1030, "LO", person.study) + element(8, 0x103e, "LO", person.series)
            + element(0x10, 0x10, "PN", person.name) + element(0x10, 0x20, "LO", person.id)
            + element(0x10, 0x30, "DA", person.birth))


def signed_pixels():
    return (element(0x28, 0x100, "US", us(16)) + element(0x28, 0x101, "US", us(16))
            + element(0x28, 0x102, "US", us(15)) + element(0x28, 0x103, "US", us(1)))


def dicom(person, study, series, instance, k, columns, rows, pixels, modality="CT", sop_class=CT, extra=b"",
          number=1):
    """One slice as a file: explicit little endian, signed 16 bits."""
    return file_of(sop_class, instance, origin(person, study, series, instance, modality, sop_class)
                   + element(0x18, 0x50, "DS", "1") + element(0x20, 0xd, "UI", study)
                   + element(0x20, 0xe, "UI", series) + element(0x20, 0x11, "IS", str(number))
                   + element(0x20, 0x13, "IS", str(k + 1)) + element(0x20, 0x32, "DS", f"0\\0\\{k}")
                   + element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0") + element(0x20, 0x52, "UI", study + ".9")
                   + extra + element(0x28, 2, "US", us(1)) + element(0x28, 4, "CS", "MONOCHROME2")
                   + element(0x28, 0x10, "US", us(rows)) + element(0x28, 0x11, "US", us(columns))
                   + element(0x28, 0x30, "DS", "1\\1") + signed_pixels() + element(0x28, 0x1052, "DS", "0")
                   + element(0x28, 0x1053, "DS", "1") + element(0x7fe0, 0x10, "OW", pixels))


def enhanced(person, study, series, instance, side, frames, modality="CT"):
    """One file of several frames. Their functional groups place them, against the order of the file."""
    sop_class = ENHANCED[modality]
    shared = (sequence(0x20, 0x9116, element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"))
              + sequence(0x28, 0x9110, element(0x18, 0x50, "DS", "1") + element(0x28, 0x30, "DS", "1\\1"))
              + sequence(0x28, 0x9145, element(0x28, 0x1052, "DS", "-24") + element(0x28, 0x1053, "DS", "1")
                         + element(0x28, 0x1054, "LO", "HU" if modality == "CT" else "US")))
    places = [sequence(0x20, 0x9113, element(0x20, 0x32, "DS", f"0\\0\\{-k}")) for k in range(len(frames))]
    return file_of(sop_class, instance, origin(person, study, series, instance, modality, sop_class)
                   + element(0x20, 0xd, "UI", study) + element(0x20, 0xe, "UI", series)
                   + element(0x20, 0x11, "IS", "1") + element(0x20, 0x13, "IS", "1")
                   + element(0x20, 0x52, "UI", study + ".9") + element(0x28, 2, "US", us(1))
                   + element(0x28, 4, "CS", "MONOCHROME2") + element(0x28, 8, "IS", str(len(frames)))
                   + element(0x28, 0x10, "US", us(side)) + element(0x28, 0x11, "US", us(side)) + signed_pixels()
                   + sequence(0x5200, 0x9229, shared) + sequence(0x5200, 0x9230, *places)
                   + element(0x7fe0, 0x10, "OW", b"".join(frames)))


class Head:
    """A made head of shells with noise: signed 16 bits, little endian; no two planes are alike."""
    side = 512
    # radius as a share of the side, and the mean value [HU] within it
    SHELLS = ((0.42, 40), (0.39, 1100), (0.36, 30), (0.06, 5))
    POOL = 8192

    def __init__(self):
        chance = random.Random(3)
        # from the air inwards
        self.pools = [self.noisy(chance, mean) for mean in (-1000, *(mean for _, mean in self.SHELLS))]

    def noisy(self, chance, mean):
        """Values around a mean, as bytes: the rows are cut out of them."""
        return array.array("h", (round(chance.gauss(mean, 12.0)) for _ in range(self.POOL))).tobytes()

    def plane(self, k):
        chance = random.Random(k)
        middle, z, rows = self.side // 2, k - 110, []
        for j in range(self.side):
            chords = [(radius * self.side) ** 2 - (j - middle) ** 2 - z * z for radius, _ in self.SHELLS]
            halves = [math.isqrt(int(chord)) for chord in chords if chord > 0]
            # into each shell on the left, and out of it on the right
            ends = [middle - half for half in halves] + [middle + half for half in reversed(halves)] + [self.side]
            order = [*range(len(halves) + 1), *reversed(range(len(halves)))]
            start = 0
            for pool, end in zip(order, ends):
                at = 2 * chance.randrange(self.POOL - self.side)
                rows.append(self.pools[pool][at:at + 2 * (end - start)])
                start = end
        return b"".join(rows)

    def crop(self, k, side):
        plane, row = self.plane(k), self.side * 2
        at = (self.side - side) // 2
        return b"".join(plane[(at + j) * row + 2 * at:(at + j) * row + 2 * (at + side)] for j in range(side))


class Series:
    """A folder of slices, and who they are."""

    def __init__(self, folder, head, person, slices, side, syntax="explicit", study=None, number=1):
        self.folder, self.person, self.count, self.side = pathlib.Path(folder), person, slices, side
        self.study, self.series = study or uid(), uid()
        self.instances = []
        self.folder.mkdir(parents=True)
        for k in range(slices):
            self.instances.append(uid())
            pixels = head.plane(k + 60) if side == head.side else head.crop(k + 60, side)
            path = self.folder / f"{k:04}.dcm"
            path.write_bytes(dicom(person, self.study, self.series, self.instances[-1], k, side, side, pixels,
                                   number=number))
        if syntax == "explicit":
            return

        def convert(path):
            made = path.with_suffix(".made")
            subprocess.run([*CONVERTED[syntax], path, made], check=True, capture_output=True)
            made.replace(path)

        with concurrent.futures.ThreadPoolExecutor(4) as beside:
            list(beside.map(convert, self.files()))

    def files(self):
        return sorted(self.folder.iterdir())
