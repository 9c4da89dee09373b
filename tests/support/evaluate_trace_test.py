# SPDX-License-Identifier: BSD-3-Clause
"""Known answers for evaluate_trace.py: an analytic sphere, and traces with planted faults."""

import contextlib
import gzip
import io
import json
import math
import os
import tempfile
import unittest

import evaluate_trace
import numpy as np
import trace_cuts_test
import trace_volume

R = 12.0  # mm, of the sphere
TIP = 2.0  # mm, of the octahedron's six points from its middle
GAP = 0.1  # mm, at which the proxy rests: above the error of trilinear interpolation
TICKS = 300
FREE = 100  # ticks before the contact
MIDDLE = np.array([30.0, -200.0, 900.0])  # mm, LPS: far from the origin, as scans are


def voxels(n=41, plateau=False):
    """100 x depth in mm below the sphere's surface; as a plateau, 0 and 1000."""
    at = np.arange(n) - (n - 1) / 2
    k, j, i = np.meshgrid(at, at, at, indexing="ij")
    depth = R - np.sqrt(i * i + j * j + k * k)
    return np.where(depth > 0, 1000, 0) if plateau else 100 * depth


def write_nrrd(path, values, dtype="<f4", pack=False, detached=False, space="LPS"):
    kind = {"f4": "float", "i2": "short", "u1": "unsigned char"}[dtype[-2:]]
    n = values.shape[0]
    sign = np.array(trace_volume.SPACES[space.lower()])
    origin = (MIDDLE - (n - 1) / 2) * sign
    axes = " ".join("(" + ",".join(str(float(x)) for x in row) + ")" for row in np.diag(sign))
    data = values.astype(dtype).tobytes()
    lines = ["NRRD0005", "# a sphere", "type: " + kind, "dimension: 3", f"sizes: {n} {n} {n}",
             "space: " + space, "space directions: " + axes,
             "space origin: (" + ",".join(str(x) for x in origin) + ")",
             "endian: " + ("big" if dtype[0] == ">" else "little"),
             "encoding: " + ("gzip" if pack else "raw"), "modality:=CT"]
    if detached:
        lines.append("data file: payload.bin")
    data = gzip.compress(data) if pack else data
    with open(path, "wb") as file:
        file.write(("\n".join(lines) + "\n\n").encode())
        if not detached:
            file.write(data)
    if detached:
        with open(os.path.join(os.path.dirname(path), "payload.bin"), "wb") as file:
            file.write(data)


def pose(height, turn):
    """On the arc around the sphere at this height (mm), metres and quaternion: turned with it, so
    that the lowest point of the octahedron points at the middle."""
    place = (MIDDLE + height * np.array([math.sin(turn), 0.0, math.cos(turn)])) * 1e-3
    return [*place, math.cos(turn / 2), 0.0, math.sin(turn / 2), 0.0]


def rows():
    """Free, then 200 ticks around the sphere: device 3 mm deep, proxy resting a GAP above it."""
    result = []
    for k in range(TICKS):
        if k < FREE:
            free = pose(R + TIP + 5.0, 0.0)
            result.append([k * 1e-3, *free, *free, *[0.0] * 6, 0])
            continue
        turn = 1e-3 * (k - FREE)
        device, proxy = pose(R + TIP - 3.0, turn), pose(R + TIP + GAP, turn)
        force = 1000.0 * (np.array(proxy[:3]) - device[:3])
        result.append([k * 1e-3, *device, *proxy, *force, *[0.0] * 3, 1])
    return result


class EvaluateTrace(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.volume = self.path("sphere.nrrd")
        write_nrrd(self.volume, voxels())
        with open(self.path("shell.csv"), "w", encoding="ascii") as file:
            file.write("x,y,z\n")
            for axis in range(3):
                for sign in (-1, 1):
                    file.write(",".join(str(sign * TIP * 1e-3 * (a == axis)) for a in range(3)))
                    file.write("\n")

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def judge(self, trace, volume=None, isovalue=0.0):
        with open(self.path("trace.csv"), "w", encoding="ascii") as file:
            file.write(",".join(f"c{i}" for i in range(22)) + "\n")
            file.writelines(",".join(repr(float(x)) for x in row) + "\n" for row in trace)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            code = evaluate_trace.main(
                ["--volume", volume or self.volume, "--isovalue", str(isovalue), "--json",
                 "--shell", self.path("shell.csv"), self.path("trace.csv")])
        return code, json.loads(out.getvalue()) if out.getvalue() else None

    def test_a_sound_trace_gives_its_known_figures(self):
        code, found = self.judge(rows())
        self.assertEqual(code, 0)
        self.assertEqual(found["max_penetration_mm"], 0.0)
        self.assertEqual(found["contact_ticks"], TICKS - FREE)
        self.assertAlmostEqual(found["contact_share"], 2 / 3)
        self.assertAlmostEqual(found["device_offset_mm"], 3.0 + GAP, 9)
        self.assertAlmostEqual(found["coupling_mm"], 3.0 + GAP, 9)
        # the point is 3 mm deep; the nearest voxel outside may lie askew by part of a voxel
        self.assertAlmostEqual(found["device_depth_mm"], 3.0, delta=0.25)
        self.assertEqual(found["frozen_ticks"], 0)
        self.assertEqual(found["force_against_ticks"], 0)
        self.assertEqual(found["free_force_N"], 0.0)
        self.assertAlmostEqual(found["max_force_N"], 3.1)
        # concentric arcs: the ways are as the heights
        ratio = (R + TIP + GAP) / (R + TIP - 3.0)
        self.assertAlmostEqual(found["travel"]["ratio"], ratio, 3)
        self.assertAlmostEqual(found["travel"]["following"], ratio, 3)
        self.assertAlmostEqual(found["travel"]["device_mm"], (R + TIP - 3.0) * 0.199, 3)

    def test_a_planted_penetration_is_found(self):
        trace = rows()
        trace[177][8:15] = pose(R + TIP - 0.2, 1e-3 * 77)
        code, found = self.judge(trace)
        self.assertEqual(code, 1)
        self.assertAlmostEqual(found["max_penetration_mm"], 0.2, delta=0.02)
        self.assertEqual(found["penetration_tick"], 177)
        self.assertEqual(found["penetrating_ticks"], 1)

    def test_a_turn_alone_can_plant_it(self):
        # turned about its own middle by 45 degrees, then shifted down: two points share the depth
        trace = rows()
        place = (MIDDLE + np.array([0, 0, R + TIP * math.sqrt(0.5) - 0.5])) * 1e-3
        trace[50][8:15] = [*place, math.cos(math.pi / 8), 0.0, math.sin(math.pi / 8), 0.0]
        x, z = TIP * math.sqrt(0.5), R - 0.5
        code, found = self.judge(trace)
        self.assertEqual((code, found["penetration_tick"]), (1, 50))
        self.assertAlmostEqual(found["max_penetration_mm"], R - math.hypot(x, z), delta=0.02)

    def test_depth_on_a_plateau_is_the_distance_to_a_legal_voxel(self):
        block = self.path("block.nrrd")
        write_nrrd(block, voxels(plateau=True), "<i2")
        trace = rows()
        trace[10][8:15] = pose(R + TIP - 4.0, 0.0)  # the tip on the axis, at 8 mm
        code, found = self.judge(trace, block, 500.0)
        self.assertEqual((code, found["penetration_tick"]), (1, 10))
        self.assertAlmostEqual(found["max_penetration_mm"], 4.0, delta=0.01)  # voxel at 12 mm: 0

    def test_frozen_ticks_are_counted(self):
        trace = rows()
        for k in range(201, 251):  # 50 ticks at the pose of tick 200; the device goes on
            trace[k][8:15] = trace[200][8:15]
        _, found = self.judge(trace)
        self.assertEqual(found["frozen_ticks"], 50)
        self.assertAlmostEqual(found["frozen_share"], 0.25)
        for k in range(201, 251):  # a device at rest: that is no freeze
            trace[k][1:8] = trace[200][1:8]
        self.assertEqual(self.judge(trace)[1]["frozen_ticks"], 0)

    def test_what_is_no_number_or_pushes_inwards_shows(self):
        trace = rows()
        trace[150][20] = math.nan
        trace[160][15:18] = [-x for x in trace[160][15:18]]
        trace[20][17] = 0.5
        code, found = self.judge(trace)
        self.assertEqual((code, found["nonfinite"]), (1, 1))
        self.assertEqual(found["force_against_ticks"], 1)
        self.assertEqual(found["free_force_N"], 0.5)

    def test_every_way_to_write_the_volume_gives_the_same(self):
        trace = rows()
        trace[177][8:15] = pose(R + TIP - 0.2, 1e-3 * 77)
        expected = self.judge(trace)
        ways = [{"dtype": ">f4", "pack": True}, {"pack": True, "detached": True},
                {"dtype": ">f4", "detached": True}]
        for number, way in enumerate(ways):
            path = self.path(f"way{number}.nhdr")
            write_nrrd(path, voxels(), **way)
            self.assertEqual(self.judge(trace, path), expected)
        # a space with other signs holds the sphere mirrored, which is the same sphere
        for space in ("RAS", "LAS"):
            path = self.path(space + ".nrrd")
            write_nrrd(path, voxels(), space=space)
            found = self.judge(trace, path)[1]
            self.assertAlmostEqual(found["max_penetration_mm"],
                                   expected[1]["max_penetration_mm"], 6)

    def test_beyond_the_grid_is_background(self):
        path = self.path("cut.nrrd")
        values = np.full((3, 3, 3), 10.0)
        values[0, 0, 0] = 2.0  # the least voxel
        write_nrrd(path, values)
        volume = trace_volume.read(path)
        ways = np.array([0.0, 1.0, 1.5, 2.0, 5000.0])[:, None] * [1e-3, 0, 0]
        found = volume.values(MIDDLE * 1e-3 + ways)
        self.assertTrue(np.allclose(found, [10, 10, 6, 2, 2], atol=1e-9), found)

    def test_what_cannot_be_judged_is_refused(self):
        self.assertEqual(self.judge(rows(), self.path("absent.nrrd"))[0], 2)
        self.assertEqual(self.judge([])[0], 2)
        self.assertEqual(self.judge(rows(), isovalue=-1e9)[0], 2)
        with open(self.volume, "r+b") as file:
            file.truncate(10_000)
        self.assertEqual(self.judge(rows())[0], 2)


def run():
    """0 if every known answer is met."""
    load = unittest.defaultTestLoader.loadTestsFromTestCase
    suite = unittest.TestSuite([load(EvaluateTrace), load(trace_cuts_test.EvaluateCuts)])
    return 0 if unittest.TextTestRunner(verbosity=1).run(suite).wasSuccessful() else 1
