#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `palpate-cli surface` writes, as another reader reads it: closed, turned outwards, where the
phantom's formula says, in three formats and both frames; with pieces, crops, and grids that are
oblique, mirrored or full of noise.

Use: surface_test.py PALPATE-CLI FOLDER [SCANS]
"""
import array
import json
import math
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys

CLI, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
faults = []


def check(holds, what):
    if not holds:
        faults.append(what)
        print("FAULT:", what)
    return holds


def cli(*words, expect=0):
    done = subprocess.run([CLI, *map(str, words), "--json"], capture_output=True, text=True, timeout=300)
    check(done.returncode == expect, f"{words}: {done.returncode}: {done.stderr}")
    return json.loads(done.stdout), done.stderr


# the three formats: (points, triangles, header)

def read_stl(data):
    count, = struct.unpack_from("<I", data, 80)
    check(len(data) == 84 + 50 * count, "an STL of another size than its count says")
    check(not data.startswith(b"solid"), "a binary STL that begins as a text")
    number, points, triangles = {}, [], []
    for at in range(84, len(data), 50):
        each = struct.unpack_from("<12f", data, at)
        corners = [each[n:n + 3] for n in (3, 6, 9)]
        normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        size = math.sqrt(dot(normal, normal))
        if size > 1e-3 and dot(normal, each[:3]) < 0.99 * size:
            check(False, f"an STL with the normal {each[:3]} in place of {normal}")
        for corner in corners:
            if corner not in number:
                number[corner] = len(points)
                points.append(corner)
        triangles.append(tuple(number[corner] for corner in corners))
    return points, triangles, data[:80].decode()


def read_obj(data):
    lines = data.decode().split("\n")
    points = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
    triangles = [tuple(int(n) - 1 for n in line.split()[1:]) for line in lines if line.startswith("f ")]
    return points, triangles, "\n".join(line for line in lines if line.startswith("#"))


def read_ply(data):
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode()
    corners = int(re.search(r"element vertex (\d+)", header).group(1))
    faces = int(re.search(r"element face (\d+)", header).group(1))
    check(len(data) == end + 12 * corners + 13 * faces, "a PLY of another size than its header says")
    points = list(struct.iter_unpack("<3f", data[end:end + 12 * corners]))
    each = list(struct.iter_unpack("<B3i", data[end + 12 * corners:]))
    check(all(face[0] == 3 for face in each), "a face that is no triangle")
    return points, [face[1:] for face in each], header


READERS = {".stl": read_stl, ".obj": read_obj, ".ply": read_ply}


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class Mesh:
    def __init__(self, path, what):
        self.points, self.triangles, self.header = READERS[path.suffix](path.read_bytes())
        self.what = what
        check(self.triangles, f"{what}: no triangle")
        check(len(set(self.points)) == len(self.points), f"{what}: two corners at one place")
        check({n for t in self.triangles for n in t} == set(range(len(self.points))),
              f"{what}: a corner without a triangle")
        # each edge is in two triangles, once in each direction
        edges = [edge for a, b, c in self.triangles for edge in ((a, b), (b, c), (c, a))]
        once = set(edges)
        check(all(a != b for a, b in once), f"{what}: a triangle with two equal corners")
        check(len(once) == len(edges), f"{what}: an edge twice in one direction")
        check(all((b, a) in once for a, b in once), f"{what}: an edge without its other triangle")
        first = self.points[0]
        near = [minus(p, first) for p in self.points]
        self.volume = sum(dot(near[a], cross(near[b], near[c])) for a, b, c in self.triangles) / 6
        check(self.volume > 0, f"{what}: turned inwards, {self.volume} mm3")
        self.low = [min(p[a] for p in self.points) for a in range(3)]
        self.high = [max(p[a] for p in self.points) for a in range(3)]

    def is_box(self, low, high, within):
        check(all(abs(x - y) < within for x, y in zip([*self.low, *self.high], [*low, *high])),
              f"{self.what}: it reaches from {self.low} to {self.high}, not from {low} to {high}")

    def holds(self, volume, within):
        check(abs(self.volume - volume) < within, f"{self.what}: {self.volume} mm3 in place of {volume}")


def surface(name, *words, what=None):
    path = FOLDER / name
    said, told = cli("surface", *words, "--out", path)
    check(said.get("bytes") == path.stat().st_size, f"{name}: {said}")
    expected = re.search(rf"^{said.get('triangles')} triangles, (?:about )?(\d+) MB\.$", told, re.M)
    check(expected, f"{name}: it said {told}")
    check(-0.02 * said["bytes"] < 1e6 * int(expected[1]) - said["bytes"] < 1e6 + 0.02 * said["bytes"],
          f"{name}: it said {told}, and has {said['bytes']} bytes")
    mesh = Mesh(path, what or name)
    check(len(mesh.triangles) == said["triangles"] and len(mesh.points) == said["corners"], f"{name}: {said}")
    return mesh


def nrrd(name, size, values, directions, origin):
    """Values with i fastest, the directions of i, j and k in LPS, mm."""
    def triple(v):
        return "(" + ",".join(repr(float(x)) for x in v) + ")"
    head = ("NRRD0005\ntype: int16\ndimension: 3\nsizes: " + " ".join(map(str, size)) +
            "\nspace: left-posterior-superior\nspace directions: " + " ".join(map(triple, directions)) +
            "\nspace origin: " + triple(origin) + "\nendian: little\nencoding: raw\n\n")
    path = FOLDER / name
    path.write_bytes(head.encode() + array.array("h", values).tobytes())
    return path


def along(directions, index):
    return [sum(directions[a][c] * index[a] for a in range(3)) for c in range(3)]


def balls(size, directions, origin, centres):
    """The signed distance to balls [(centre, radius)], as numbers that are 1000 at the surface."""
    for k in range(size[2]):
        for j in range(size[1]):
            for i in range(size[0]):
                place = [x + o for x, o in zip(along(directions, (i, j, k)), origin)]
                distance = min(math.dist(place, centre) - radius for centre, radius in centres)
                yield round(min(2000, max(0, 1000 - 200 * distance)))


# three formats, two frames: a box of 30 mm with a ball of 6 mm to the left, 4 mm in front, 2.5 mm on top
for ending in READERS:
    lps = surface("marker" + ending, "--phantom", "marker", "--isovalue", 1000)
    lps.is_box([-15, -19, -15], [21, 15, 17.5], 1.0)
    check("LPS" in lps.header and "mm" in lps.header and "RAS" not in lps.header, f"{ending}: {lps.header}")
    ras = surface("marker-ras" + ending, "--phantom", "marker", "--isovalue", 1000, "--frame", "ras")
    ras.is_box([-21, -15, -15], [15, 19, 17.5], 1.0)
    check("RAS" in ras.header and "LPS" not in ras.header, f"{ending}: {ras.header}")
    ball = lambda r: 2 / 3 * math.pi * r ** 3  # its half outside of the box
    for mesh in lps, ras:
        mesh.holds(30 ** 3 + ball(6) + ball(4) + ball(2.5), 6 * 30 ** 2 * 0.1)

sphere = surface("sphere.stl", "--phantom", "sphere", "--isovalue", 1000)
sphere.is_box([-20] * 3, [20] * 3, 0.1)
sphere.holds(4 / 3 * math.pi * 20 ** 3, 4 * math.pi * 20 ** 2 * 0.05)
check(max(abs(math.hypot(*p) - 20) for p in sphere.points) < 0.05, "a corner that is not on the ball")

# a solid that meets the border is closed there, at the outer faces of the voxels
half = surface("halfspace.ply", "--phantom", "halfspace", "--isovalue", 1000)
half.is_box([-32, -32, -32], [32, 32, 0], 0.05)
half.holds(64 * 64 * 32, 64 * 64 * 0.05)
check(surface("gyroid.stl", "--phantom", "gyroid", "--isovalue", 1000).volume > 96 ** 3 * 0.4, "half of the gyroid")

# grids that are anisotropic, oblique and mirrored
third = math.sqrt(1 / 3)
turn = [(third, third, third), (math.sqrt(1 / 2), -math.sqrt(1 / 2), 0.0)]
turn.append(cross(*turn))
size, spacing = (50, 34, 24), (0.6, 0.9, 1.4)
centres = [((-4.0, 0.0, 0.0), 6.0), ((6.0, 3.0, -4.0), 3.0)]
content = 4 / 3 * math.pi * (6 ** 3 + 3 ** 3)
for name, flips in ("right-handed", (1, 1, 1)), ("mirrored", (-1, 1, 1)), ("mirrored-k", (1, 1, -1)):
    directions = [[x * spacing[a] * flips[a] for x in turn[a]] for a in range(3)]
    origin = [-x for x in along(directions, [(n - 1) / 2 for n in size])]
    scan = nrrd(name + ".nrrd", size, balls(size, directions, origin, centres), directions, origin)
    for frame, sign in ("lps", 1), ("ras", -1):
        there = [((sign * x, sign * y, z), r) for (x, y, z), r in centres]
        both = surface(f"{name}-{frame}.stl", scan, "--isovalue", 1000, "--frame", frame)
        both.holds(content, content * 0.05)
        both.is_box([min(c[a] - r for c, r in there) for a in range(3)],
                    [max(c[a] + r for c, r in there) for a in range(3)], 0.3)
        one = surface(f"{name}-{frame}-largest.ply", scan, "--isovalue", 1000, "--frame", frame, "--largest")
        one.holds(4 / 3 * math.pi * 6 ** 3, content * 0.05)
        one.is_box([x - 6 for x in there[0][0]], [x + 6 for x in there[0][0]], 0.3)

# every way in which corners of a cell can be solid, and voxels that have the isovalue itself
chance = random.Random(7)
cube = [(0.3, 0, 0), (0, 0.3, 0), (0, 0, 0.3)]
for levels in 2, 3, 9:
    values = [chance.randrange(levels) for _ in range(18 * 19 * 20)]
    noise = nrrd(f"noise{levels}.nrrd", (18, 19, 20), values, cube, (80, -90, 700))
    for words in [], ["--largest"]:
        surface(f"noise{levels}.stl", noise, "--isovalue", 1, *words, what=f"noise of {levels} levels {words}")

# parts that were removed in a saved view: a crop of the ball to its half, then a cut to a quarter
view = {
    "palpate_view": 2,
    "scan": {"dims": [64, 64, 64], "spacing_m": [1e-3] * 3, "origin_m": [-0.0315] * 3,
             "direction": [1.0, 0, 0, 0, 1.0, 0, 0, 0, 1.0], "scalar": "int16", "hash": None},
    "edits": ['{"edit":"crop","end":[64,64,32],"first":[0,0,0]}',
              '{"edit":"plane","isovalue":1000.0,"normal":[1.0,0.0,0.0],"point_m":[0.0,0.0,0.0]}'],
    "isovalue": 1000.0, "marks": [],
    "view": {"camera": {"eye_m": [0, -1, 0], "focus_m": [0, 0, 0], "up": [0, 0, 1], "parallel": False,
                        "half_height_m": 0.1},
             "surface": {"colours": "ivory", "second": None}, "cross_m": [0, 0, 0],
             "grey": {"level": 200, "width": 1600}, "slices": [{"zoom": 1, "shift_m": [0, 0]}] * 4,
             "voxels": {"interpolation": "linear", "slab": "none", "thickness_m": 0.01},
             "tool_plane": {"along": False, "depth_m": 0},
             "layout": {"arrangement": "one", "tool_view": False, "active": 0, "alone": False, "shares": []}}}
(FOLDER / "quarter.palpate-view").write_text(json.dumps(view))
quarter = surface("quarter.obj", "--phantom", "sphere", "--isovalue", 1000, "--view",
                  FOLDER / "quarter.palpate-view")
quarter.is_box([-20, -20, -20], [0, 20, 0], 0.6)
quarter.holds(math.pi * 20 ** 3 / 3, math.pi * 20 ** 2 * 0.6)
view["scan"]["dims"] = [64, 64, 63]
(FOLDER / "other.palpate-view").write_text(json.dumps(view))

# what is refused leaves no file
no = FOLDER / "no.stl"
said, told = cli("surface", "--phantom", "sphere", "--isovalue", 1000, "--out", no, "--view",
                 FOLDER / "other.palpate-view", expect=4)
check("another scan" in told, told)
said, told = cli("surface", "--phantom", "sphere", "--isovalue", 99999, "--out", no, expect=3)
check("no surface" in told and "99999" in told, told)
for isovalue in -11000, -20000:
    said, told = cli("surface", "--phantom", "sphere", "--isovalue", isovalue, "--out", no, expect=3)
    check("whole scan is solid" in told and "-11000" in told and "13000" in told, told)
cli("surface", "--phantom", "sphere", "--isovalue", 1000, "--out", FOLDER / "no.vtk", expect=2)
cli("surface", "--isovalue", 1000, "--out", no, expect=2)
# so far away that numbers of STL cannot part its corners
values = [chance.randrange(9) for _ in range(9 ** 3)]
far = nrrd("far.nrrd", (9, 9, 9), values, [(0.01, 0, 0), (0, 0.01, 0), (0, 0, 0.01)], (9000, 0, 0))
said, told = cli("surface", far, "--isovalue", 4, "--out", no, expect=3)
check("not closed" in told, told)
check(not list(FOLDER.glob("no.*")), "a refused surface left a file")

# a head with thin bone
if len(sys.argv) > 3:
    scan = pathlib.Path(sys.argv[3]) / "philips_head_phantom/bone_1mm"
    if scan.exists():
        surface("head.ply", scan, "--isovalue", 300, "--every", 3)
    else:
        print("NOT RUN: there is no", scan)

print("faults:", len(faults))
sys.exit(bool(faults))
