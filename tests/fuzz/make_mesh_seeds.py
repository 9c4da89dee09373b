#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of mesh_fuzz: a tetrahedron in each format, and files that are laid out otherwise.

Usage: make_mesh_seeds.py [FOLDER]   (default: corpus, beside this file)
"""
import pathlib
import struct
import sys

PLACES = ((0, 0, 0), (20, 0, 0), (0, 30, 0), (0, 0, 40))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
STL, OBJ, PLY = b"\0", b"\1", b"\2"  # the first byte, as mesh_fuzz.cpp takes it


def binary_stl(faces=FACES):
    corners = [struct.pack("<12fH", 0, 0, 0, *(x for v in face for x in PLACES[v]), 0) for face in faces]
    return STL + b" " * 80 + struct.pack("<I", len(corners)) + b"".join(corners)


def ascii_stl():
    text = "solid t\n"
    for face in FACES:
        rows = "".join("vertex %g %g %g\n" % PLACES[v] for v in face)
        text += f"facet normal 0 0 0\nouter loop\n{rows}endloop\nendfacet\n"
    return STL + (text + "endsolid t\n").encode()


def obj():
    text = "# t\n" + "".join("v %g %g %g\n" % p for p in PLACES) + "vt 0 0\nvn 0 0 1\n"
    return OBJ + (text + "f 1/1 3/1 2/1\nf 1//1 2//1 4//1\nf -4 -1 \\\n-2\nf 2/1/1 3 4\nf 1 2 3 4\n").encode()


def ply(form):
    head = (f"ply\nformat {form} 1.0\ncomment t\nelement vertex 4\nproperty float x\nproperty float y\n"
            "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n").encode()
    if form == "ascii":
        rows = "".join("%g %g %g\n" % p for p in PLACES) + "".join("3 %d %d %d\n" % f for f in FACES)
        return PLY + head + rows.encode()
    order = "<" if form == "binary_little_endian" else ">"
    rows = b"".join(struct.pack(order + "3f", *p) for p in PLACES)
    return PLY + head + rows + b"".join(struct.pack(order + "B3i", 3, *f) for f in FACES)


def main():
    here = pathlib.Path(__file__).resolve().parent
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else here / "corpus") / "mesh"
    folder.mkdir(parents=True, exist_ok=True)
    seeds = {"stl-binary": binary_stl(), "stl-ascii": ascii_stl(), "obj": obj()}
    seeds.update({f"ply-{form}": ply(form)
                  for form in ("ascii", "binary_little_endian", "binary_big_endian")})
    cases = here.parent / "cases"
    for case in sorted((cases / "reports/ply").glob("*.ply")) + sorted((cases / "hostile").glob("*.ply")):
        seeds[f"case-{case.stem}"] = PLY + case.read_bytes()
    for name, content in seeds.items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
