# SPDX-License-Identifier: BSD-3-Clause
"""Known answers for evaluate_trace.py where a burr cut: half a space, and a made list of cuts."""

import contextlib
import io
import json
import math
import os
import sqlite3
import tempfile
import unittest
import zlib

import evaluate_trace
import numpy as np
import trace_cuts
import trace_volume

N = 41  # voxels of 1 mm along an axis; the solid is below the middle, with 100 in each mm of depth
RADIUS = 4.0  # mm, of the burr
LEAST, GREATEST = -300.0, 300.0  # so a wall has 100 a voxel, too, and 133 more from 2 voxels on
DEEP = np.array([0.0, 0.0, -3.9])  # mm: within a ball around the middle
SHALLOW = np.array([0.0, 0.0, -0.01])  # a hundredth of a voxel within the solid
FREE = np.array([0.0, 0.0, 15.0])
STEPS = [["time", "int64", "ns"], *[["device_" + axis, "float64", "m"] for axis in "xyz"],
         ["cut_at", "int64", ""], ["force_x", "float64", "N"], ["contacts", "uint8", ""]]
CUTS = [["step", "uint16", ""], *[[f"{end}_{axis}", "float64", "m"] for end in ("from", "to") for axis in "xyz"],
        ["radius", "float64", "m"], ["isovalue", "float64", ""], ["removed", "float64", "m3"]]


def half_space(side=(1.0, 1.0, 1.0), dtype="float32"):
    """A volume around the origin whose surface is the plane z = 0."""
    side = np.array(side)
    z = (np.arange(N) - (N - 1) / 2) * side[2]
    values = np.broadcast_to(np.clip(-100 * z / side[2], LEAST, GREATEST)[:, None, None], (N, N, N))
    return trace_volume.Volume(values.astype(dtype), -(N - 1) / 2 * side * 1e-3, np.diag(side) * 1e-3)


def write_nrrd(path, voxels):
    kind = "float" if voxels.dtype.kind == "f" else "short"
    low = -(N - 1) / 2
    header = (f"NRRD0005\ntype: {kind}\ndimension: 3\nsizes: {N} {N} {N}\nspace: LPS\nspace directions: "
              f"(1,0,0) (0,1,0) (0,0,1)\nspace origin: ({low},{low},{low})\nendian: little\nencoding: raw\n\n")
    with open(path, "wb") as file:
        file.write(header.encode() + voxels.tobytes())


def planes(values, width):
    whole = np.array([int(v) for v in values], np.uint64).astype("<u8").view(np.uint8).reshape(-1, 8)
    return whole[:, :width].T.tobytes()


def packed(layout, columns, rounded):
    """A block as app/recording/README.md says; `columns` by the names of the layout."""
    data = b""
    for number, (name, kind, _, *per_unit) in enumerate(layout):
        dtype = np.dtype("int64" if per_unit else kind)
        values = np.array(columns[name]) * (per_unit[0] if per_unit else 1)
        column = np.ascontiguousarray(np.rint(values) if per_unit else values, dtype)
        bits = [int.from_bytes(column[n:n + 1].tobytes(), "little") for n in range(len(column))]
        if not rounded:
            data += planes(bits, dtype.itemsize)
            continue
        order = min(number % 4, len(bits))
        for _ in range(order):
            bits = [(b - a) % 2**64 for a, b in zip([0] + bits, bits)]
        signed = [b - 2**64 if b >= 2**63 else b for b in bits]
        bits = [-2 * d - 1 if d < 0 else 2 * d for d in signed]
        width = max((d.bit_length() + 7) // 8 for d in bits) if bits else 0
        data += bytes([order, width]) + planes(bits[:order], 8) + planes(bits[order:], width)
    return zlib.compress(data)


def write_recording(path, device, cuts, cut_at=(), rounded=False, event=None):
    """`device` (ticks, 3) in m; cuts as (tick, from, to, radius) in mm, at the isovalue 0. In two blocks."""
    if os.path.exists(path):
        os.unlink(path)
    steps = [entry if entry[0] != "force_x" or not rounded else [*entry, 1e6] for entry in STEPS]
    file = sqlite3.connect(path)
    file.executescript(f"""PRAGMA synchronous = OFF; PRAGMA user_version = {8 if rounded else 7};
                       CREATE TABLE meta (key, value); CREATE TABLE step (first, count, data);
                       CREATE TABLE cut (first, count, data); CREATE TABLE event (kind, text);
                       CREATE TABLE scene (volume)""")
    file.executemany("INSERT INTO meta VALUES (?, ?)",
                     [("step_layout", json.dumps(steps)), ("cut_layout", json.dumps(CUTS))])
    low = -(N - 1) / 2 * 1e-3
    file.execute("INSERT INTO scene VALUES (?)", [json.dumps(
        {"dims": [N] * 3, "origin_m": [low] * 3, "spacing_m": [1e-3] * 3, "least": LEAST})])
    if event:
        file.execute("INSERT INTO event VALUES (?, '')", [event])
    ticks = len(device)
    for first, end in ((0, 5), (5, ticks)):
        here = range(first, end)
        columns = {"time": [n * 1_000_000 for n in here], "force_x": [0.5 * n for n in here],
                   "contacts": [n % 3 for n in here], "cut_at": [20_000 * (n in cut_at) for n in here],
                   **{"device_" + axis: device[first:end, a] for a, axis in enumerate("xyz")}}
        file.execute("INSERT INTO step VALUES (?, ?, ?)", [first, len(here), packed(steps, columns, rounded)])
        made = [cut for cut in cuts if cut[0] in here]
        columns = {"step": [cut[0] - first for cut in made], "radius": [cut[3] * 1e-3 for cut in made],
                   "isovalue": [0.0] * len(made), "removed": [1e-9] * len(made),
                   **{f"{end}_{axis}": [cut[1 + e][a] * 1e-3 for cut in made]
                      for e, end in enumerate(("from", "to")) for a, axis in enumerate("xyz")}}
        if made:
            file.execute("INSERT INTO cut VALUES (?, ?, ?)", [first, len(made), packed(CUTS, columns, rounded)])
    file.commit()
    file.close()


class Made:
    """A list of cuts without a file."""

    def __init__(self, cuts):
        self.tick = np.array([cut[0] for cut in cuts])
        self.way_from, self.way_to = (np.array([cut[end] for cut in cuts]) * 1e-3 for end in (1, 2))
        self.radius, self.isovalue = np.array([cut[3] for cut in cuts]) * 1e-3, np.zeros(len(cuts))
        self.cut_at = np.zeros(100, int)


def carved(volume, *cuts):
    trace_cuts.Carving(volume, Made(cuts)).until(100)
    return volume


def wall(volume, ways, start, guess):
    """Where the surface is along unit vectors (n, 3), mm from `start`; found by halving."""
    low, high = np.full(len(ways), guess - 1.5), np.full(len(ways), guess + 1.5)
    for _ in range(40):
        middle = 0.5 * (low + high)
        solid = volume.values((start + middle[:, None] * ways) * 1e-3) >= 0
        low, high = np.where(solid, low, middle), np.where(solid, middle, high)
    return low


def down(count):
    """Unit vectors at random, down into the solid."""
    ways = np.random.default_rng(5).normal(size=(count, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    ways[:, 2] = -np.abs(ways[:, 2])
    return ways[ways[:, 2] < -0.4]


class EvaluateCuts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        write_nrrd(self.path("volume.nrrd"), half_space().voxels)
        with open(self.path("shell.csv"), "w", encoding="ascii") as file:
            file.write("x,y,z\n0,0,0\n")

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def judge(self, places, cuts, left=None, volume="volume.nrrd", shift=0.0, **recorded):
        """The point that is the tool is at `places`, by the tick, mm, and else far away."""
        ticks = 12
        device = np.stack([np.arange(ticks) * 1e-5, np.zeros(ticks), np.full(ticks, 0.03)], axis=1)
        with open(self.path("trace.csv"), "w", encoding="ascii") as file:
            file.write(",".join(f"c{i}" for i in range(22)) + "\n")
            for tick in range(ticks):
                proxy = np.asarray(places.get(tick, FREE)) * 1e-3
                row = [tick * 1e-3, *device[tick], 1, 0, 0, 0, *proxy, 1, 0, 0, 0, *[0] * 7]
                file.write(",".join(repr(float(x)) for x in row) + "\n")
        write_recording(self.path("r.palpate"), device + shift, cuts, **recorded)
        saved = []
        if left is not None:
            saved = ["--left", self.path("left.nrrd")]
            write_nrrd(saved[1], left)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            code = evaluate_trace.main(
                ["--volume", self.path(volume), "--isovalue", "0", "--json", "--shell", self.path("shell.csv"),
                 "--recording", self.path("r.palpate"), *saved, self.path("trace.csv")])
        return code, json.loads(out.getvalue()) if out.getvalue() else None

    def test_voxels_have_the_values_of_the_profile(self):
        ball = (0, (0, 0, 0), (0, 0, 0), RADIUS)
        floats, whole = carved(half_space(), ball), carved(half_space(dtype="int16"), ball)
        # by hand: i, j, k from the middle; 100 (distance - 4 - 0.165 / 4), from 2 voxels on 100 / 0.75 more
        oblique = math.sqrt(40) - 4.04125
        values = {(0, 0, -4): -4.125, (0, 0, -5): 95.875, (0, 3, -4): 95.875, (0, 0, -1): -300.0,
                  (0, 0, -7): 300.0, (0, 8, 1): -100.0, (2, 0, -6): 100 * oblique + 100 / 0.75 * (oblique - 2)}
        for place, value in values.items():
            at = tuple(20 + np.array(place[::-1]))
            self.assertAlmostEqual(float(floats.voxels[at]), value, 3, place)
            self.assertEqual(int(whole.voxels[at]), math.floor(value + 0.5), place)
        # slices of 2 mm: half a millimetre before the wall is a quarter of a voxel across them
        slices = carved(half_space((1.0, 1.0, 2.0)), (0, (0, 0, 0), (0, 0, 0), 7.5))
        way, side = math.sqrt(8**2 + 2**2), math.sqrt(8**2 + 4**2) / math.sqrt(8**2 + 2**2)  # obliquely
        oblique = 100 * ((way - 7.5) / side - 0.165 * side / 7.5)
        for place, value in {(0, 0, -4): 25 - 16.5 * 2 / 7.5, (0, 8, -1): oblique}.items():
            self.assertAlmostEqual(float(slices.voxels[tuple(20 + np.array(place[::-1]))]), value, 3, place)

    def test_the_wall_is_where_the_ball_was(self):
        ways = down(400)
        # 0.041 voxels from here if the bias were left out
        middle = np.array([0.3, 0.2, 0])
        found = wall(carved(half_space(), (0, middle, middle, RADIUS)), ways, middle, 4.0)
        self.assertAlmostEqual(found.mean(), RADIUS, delta=0.005)
        self.assertLess(np.abs(found - RADIUS).max(), 0.06)
        # a way: around its middle it is a cylinder
        across = ways * [0, 1, 1]
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        groove = carved(half_space(), (0, (-1.8, 0, 0), (1.8, 0, 0), RADIUS))
        self.assertAlmostEqual(wall(groove, across, np.zeros(3), 4.0).mean(), RADIUS, delta=0.03)
        end = np.array([1.8, 0, 0])
        onward = ways[ways[:, 0] > 0]
        self.assertAlmostEqual(wall(groove, onward, end, 4.0).mean(), RADIUS, delta=0.02)
        # voxels that are no cubes
        slices = carved(half_space((1.0, 1.0, 2.0)), (0, (0, 0, 0), (0, 0, 0), 7.5))
        self.assertAlmostEqual(wall(slices, ways, np.zeros(3), 7.5).mean(), 7.5, delta=0.05)

    def test_a_pose_counts_over_what_is_cut_when_it_moves(self):
        ball = (4, (0, 0, 0), (0, 0, 0), RADIUS)  # begins at the end of tick 4
        for rounded in (False, True):
            code, found = self.judge({5: DEEP, 6: SHALLOW, 11: DEEP}, [ball], rounded=rounded)
            self.assertEqual((code, found["max_penetration_mm"], found["undecided_ticks"]), (0, 0.0, 0))
            self.assertEqual((found["cuts"], found["removed_mm3"]), (1, 1.0))
            # in its own tick it is not made yet
            code, found = self.judge({4: SHALLOW, 5: DEEP}, [ball], rounded=rounded)
            self.assertEqual((code, found["penetrating_ticks"], found["penetration_tick"]), (1, 1, 4))
            self.assertAlmostEqual(found["max_penetration_mm"], 0.01, 6)
            # nor is it beside it, or where no cut was made
            self.assertEqual(self.judge({9: SHALLOW + [8, 0, 0]}, [ball], rounded=rounded)[0], 1)
            code, found = self.judge({9: SHALLOW}, [], rounded=rounded)
            self.assertEqual(code, 1)
            self.assertAlmostEqual(found["max_penetration_mm"], 0.01, 6)

    def test_a_pose_beyond_the_wall_is_as_deep_as_it_is(self):
        cuts = [(1, (0, 0, 0), (0, 0, -0.5), RADIUS), (6, (0, 0, -0.5), (0, 0, -1.0), RADIUS)]
        for tick, z in ((2, -0.5), (6, -0.5), (7, -1.0)):  # where the ball is that was cut last
            for way in down(20)[:5]:
                end = np.array([0.0, 0.0, z])
                code, found = self.judge({tick: end + (RADIUS + 0.2) * way}, cuts)
                self.assertEqual((code, found["penetration_tick"]), (1, tick))
                self.assertAlmostEqual(found["max_penetration_mm"], 0.2, delta=0.06)

    def test_a_cut_that_may_be_in_part_is_not_judged(self):
        ball = (4, (0, 0, 0), (0, 0, 0), RADIUS)
        code, found = self.judge({5: SHALLOW, 6: DEEP}, [ball], cut_at=[4])  # the budget ended tick 4
        self.assertEqual((code, found["undecided_ticks"], found["max_penetration_mm"]), (2, 1, 0.0))
        # whole before the next begins, whatever the budget did
        again = (7, (0, 0, 0), (0, 0, 0.1), RADIUS)
        code, found = self.judge({6: FREE, 7: DEEP}, [ball, again], cut_at=range(4, 12))
        self.assertEqual((code, found["undecided_ticks"]), (0, 0))
        # what neither leaves is a penetration all the same
        code, found = self.judge({5: [0, 0, -4.5]}, [ball], cut_at=[4])
        self.assertEqual((code, found["undecided_ticks"]), (1, 0))
        # rows of more than a tick's work, of 30 voxels: 900 x 3 units
        large = (4, (0, 0, 0), (0, 0, 0), 12.0)
        self.assertEqual(self.judge({5: DEEP}, [large])[1]["undecided_ticks"], 1)
        self.assertEqual(self.judge({6: DEEP}, [large])[0], 0)

    def test_what_the_run_left_is_compared(self):
        ball = (4, (0, 0, 0), (0, 0, 0), RADIUS)
        for kind, bounds in (("float32", (0.0, 0.0, 0.1)), ("int16", (0, 1, 2))):
            write_nrrd(self.path("typed.nrrd"), half_space(dtype=kind).voxels)
            for plus, code in zip(bounds, (0, 0, 1)):
                left = carved(half_space(dtype=kind), ball).voxels
                left[15, 20, 20] += plus
                found = self.judge({}, [ball], left, "typed.nrrd")
                self.assertEqual(found[0], code, (kind, plus, found))
                self.assertEqual(found[1]["left"]["other_voxels"], int(plus != 0))
            self.assertEqual(self.judge({}, [], left, "typed.nrrd")[0], 1)  # a cut that was not recorded
        # a cut under way in the end may have left what is between
        left = carved(half_space(), ball).voxels
        left[:20] = half_space().voxels[:20]
        self.assertEqual(self.judge({}, [ball], left)[0], 1)
        self.assertEqual(self.judge({}, [ball], left, cut_at=range(4, 12))[0], 0)

    def test_what_is_not_of_this_run_is_refused(self):
        self.assertEqual(self.judge({}, [], shift=1e-9)[0], 2)
        for event in ("edit", "gap"):
            self.assertEqual(self.judge({}, [], event=event)[0], 2)
        write_nrrd(self.path("other.nrrd"), half_space().voxels + np.float32(1.0))
        self.assertEqual(self.judge({}, [], volume="other.nrrd")[0], 2)
