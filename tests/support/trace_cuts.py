# SPDX-License-Identifier: BSD-3-Clause
"""What a burr cut in a run, from its recording and without any code of Palpate. For evaluate_trace.py.

The tables and their blocks are read as app/recording/README.md publishes them. Each cut is carried out
here, in float64, as haptics/carving/README.md describes it ("The wall", "The burr").

A cut begins at the end of its tick, after the motion. It is whole by then if its rows are within the
2,200 units that a tick does, and the budget did not end that tick. A row of n voxels takes 1 + n/12, so a
ball of 4 mm in voxels of 0.2 mm takes some 2,200, and in those of the tests' scans less. If not, it is whole
some ticks later, at the latest before the next cut begins. Until then what is left lies between the voxels
without the cut and with it: a pose that is legal without is legal, one that is not legal with it is not, and
one between the two cannot be decided."""

import json
import sqlite3
import zlib

import numpy as np

TICK_WORK = 2200
PROFILE_BACK, PROFILE_SOLID = 3.0, 1.5  # voxels from the wall to the background, to the greatest value
STRAIGHT, REACH, MOST_BACK = 2.0, 2.75, 8.0  # voxels
BIAS = 0.165
ROUNDED_LAYOUTS, WITH_CUTS = (4, 6, 8), (7, 8)  # of user_version


def integers(planes, width, count):
    """Whole numbers (uint64) from byte planes, the lowest bytes of all first."""
    whole = np.zeros((count, 8), np.uint8)
    whole[:, :width] = np.frombuffer(planes, np.uint8, width * count).reshape(width, count).T
    return whole.view("<u8")[:, 0]


def rows(packed, count, layout, rounded):
    """A block's columns by name: arrays of `count` numbers."""
    data, at, columns = zlib.decompress(packed), 0, {}
    for name, kind, _, *per_unit in layout:
        dtype = np.dtype(kind if not per_unit else "int64").newbyteorder("<")
        if rounded:
            order, width = data[at], data[at + 1]
            at += 2
            first = integers(data[at:], 8, order)
            at += 8 * order
            stored = np.concatenate([first, integers(data[at:], width, count - order)])
            at += width * (count - order)
            values = (stored >> np.uint64(1)) ^ (np.uint64(0) - (stored & np.uint64(1)))
            for _ in range(order):
                values = np.cumsum(values, dtype=np.uint64)  # modulo 2^64
        else:
            values = integers(data[at:], dtype.itemsize, count)
            at += dtype.itemsize * count
        low = values.view(np.uint8).reshape(count, 8)[:, :dtype.itemsize]
        column = np.ascontiguousarray(low).view(dtype)[:, 0]
        columns[name] = column / per_unit[0] if per_unit else column
    if at != len(data):
        raise ValueError("a block of the recording has another length than its layout")
    return columns


class Recording:
    """The cuts of a run, the tick in which each began, and the work at which a tick was cut off."""

    def __init__(self, path):
        file = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        try:
            self._read(file)
        except (sqlite3.Error, KeyError, json.JSONDecodeError, zlib.error) as wrong:
            raise ValueError(f"{path}: no recording: {wrong!r}") from wrong
        finally:
            file.close()

    def _read(self, file):
        meta = dict(file.execute("SELECT key, value FROM meta"))
        version = file.execute("PRAGMA user_version").fetchone()[0]
        rounded = version in ROUNDED_LAYOUTS
        scenes = file.execute("SELECT volume FROM scene").fetchall()
        kinds = {kind for kind, in file.execute("SELECT kind FROM event")}
        if len(scenes) != 1 or kinds & {"gap", "edit"}:
            raise ValueError("a recording with gaps, edits, kept tissues or more scenes than one")
        self.volume = json.loads(scenes[0][0])
        if {"edits", "walls"} & set(self.volume):
            raise ValueError("a recording over an edited volume")

        def table(name, layout):
            blocks = file.execute(f"SELECT first, count, data FROM {name} ORDER BY first")
            return [(first, rows(data, count, layout, rounded)) for first, count, data in blocks if count]

        steps = table("step", json.loads(meta["step_layout"]))
        self.device = np.concatenate(
            [np.stack([block[f"device_{axis}"] for axis in "xyz"], axis=1) for _, block in steps])
        self.cut_at = np.concatenate([block["cut_at"] for _, block in steps])
        ends = np.cumsum([0] + [len(block["cut_at"]) for _, block in steps])
        if [first for first, _ in steps] != ends[:-1].tolist():
            raise ValueError("a recording with steps that are missing")
        cuts = table("cut", json.loads(meta["cut_layout"])) if version in WITH_CUTS else []

        def all_of(*names):
            columns = [np.stack([block[name] for name in names], axis=1) for _, block in cuts]
            return np.concatenate([np.zeros((0, len(names))), *columns])

        self.tick = np.concatenate(
            [np.zeros(0, int), *[first + block["step"].astype(int) for first, block in cuts]])
        self.way_from, self.way_to = (all_of(*[f"{end}_{axis}" for axis in "xyz"]) for end in ("from", "to"))
        self.radius, self.isovalue, self.removed = all_of("radius", "isovalue", "removed").T
        if (np.diff(self.tick) <= 0).any() or (self.tick >= len(self.cut_at)).any():
            raise ValueError("cuts that are not in the order of the ticks")

    def fits(self, volume, trace):
        """Raises ValueError where another volume or another run was recorded."""
        mine, whole = self.volume, volume.voxels.dtype.kind != "f"
        if tuple(mine["dims"]) != volume.voxels.shape[::-1] or \
                not np.allclose(mine["origin_m"], volume.origin, atol=1e-9) or \
                not np.allclose(mine["spacing_m"], volume.spacing, rtol=1e-6) or \
                abs(mine["least"] - volume.background) > (0 if whole else 1e-6 * abs(volume.background)):
            raise ValueError("the recording is of another volume")
        if trace.nonfinite == 0 and not np.array_equal(self.device, trace.device):
            raise ValueError("the recording is of another run than the trace")


class Carving:
    """A volume from which a recording's cuts are taken, tick by tick."""

    def __init__(self, volume, recording):
        self.volume, self.recording = volume, recording
        self.greatest = float(volume.flat.max())
        self.next = 0  # the first cut that is not made yet
        self.lowered = np.zeros(volume.voxels.shape, bool)
        self.removed = 0  # voxels at the isovalue that are below it now
        self.whole_after = [self._whole_after(n) for n in range(len(recording.tick))]

    def _box(self, n):
        """Slices [k, j, i] that hold every voxel which the cut lowers."""
        volume, cut = self.volume, self.recording
        ends = volume.index(np.stack([cut.way_from[n], cut.way_to[n]]))
        side = volume.spacing.max()
        reach = (cut.radius[n] + (REACH + BIAS * side / cut.radius[n]) * side) / volume.spacing
        low = np.maximum(np.ceil(ends.min(axis=0) - reach).astype(int), 0)
        high = np.minimum(np.floor(ends.max(axis=0) + reach).astype(int) + 1, volume.dims)
        return tuple(slice(a, max(a, b)) for a, b in zip(low[::-1], high[::-1]))

    def _whole_after(self, n):
        """The tick at the end of which this cut is certainly whole."""
        ticks, cut_at = self.recording.tick, self.recording.cut_at
        k, j, i = (s.stop - s.start for s in self._box(n))
        work = k * j * (1 + i // 12)
        latest = ticks[n + 1] - 1 if n + 1 < len(ticks) else len(cut_at)
        tick = ticks[n]
        while tick < latest:
            work -= TICK_WORK if cut_at[tick] == 0 else 0
            if work <= 0:
                break
            tick += 1
        return tick

    def _after(self, n):
        """A cut's box, and the values in it with the cut."""
        volume, cut, box = self.volume, self.recording, self._box(n)
        s, least, greatest = cut.isovalue[n], volume.background, self.greatest
        a, b = volume.index(np.stack([cut.way_from[n], cut.way_to[n]])) * volume.spacing
        axes = [np.arange(along.start, along.stop) * side for along, side in zip(box[::-1], volume.spacing)]
        p = np.stack(np.meshgrid(*axes[::-1], indexing="ij")[::-1], axis=-1) - a
        way = b - a
        along = np.clip(p @ way / max(way @ way, 1e-300), 0.0, 1.0)
        p -= along[..., None] * way
        away = np.maximum(np.linalg.norm(p, axis=-1), 1e-300)
        # a wall across the normal n moves by a voxel for each |n * spacing| of the way along n
        side = np.maximum(np.linalg.norm(p * volume.spacing, axis=-1) / away, volume.spacing.min())
        d = (away - cut.radius[n]) / side - BIAS * side / cut.radius[n]
        slope = min((s - least) / PROFILE_BACK, (greatest - s) / PROFILE_SOLID)
        steep = max(0.0, greatest - s - slope * STRAIGHT) / (REACH - STRAIGHT)
        most = np.maximum(least, s + slope * d + steep * np.maximum(0.0, d - STRAIGHT))
        most[d < -min((s - least) / slope, MOST_BACK)] = least
        if volume.voxels.dtype.kind != "f":
            most = np.floor(most + 0.5)
        return box, np.minimum(volume.voxels[box], most).astype(volume.voxels.dtype)

    def until(self, tick):
        """Makes all cuts that are whole when this tick moves."""
        while self.next < len(self.whole_after) and self.whole_after[self.next] < tick:
            box, after = self._after(self.next)
            before, s = self.volume.voxels[box], self.recording.isovalue[self.next]
            self.lowered[box] |= after < before
            self.removed += int(np.count_nonzero((before >= s) & (after < s)))
            self.volume.voxels[box] = after
            self.next += 1

    def with_cut_under_way(self, tick, ask):
        """ask() over the voxels as they would be if the cut under way were whole in this tick; None where
        none is."""
        if self.next == len(self.whole_after) or self.recording.tick[self.next] >= tick:
            return None
        box, after = self._after(self.next)
        before = self.volume.voxels[box].copy()
        self.volume.voxels[box] = after
        answer = ask()
        self.volume.voxels[box] = before
        return answer

    def differences(self, left):
        """Makes all cuts. How the voxels that the run left (a Volume) differ from these, as an array of
        sizes. A voxel in the box of a last cut that may not be whole may lie between with it and without."""
        here = self.volume.voxels
        if left.voxels.shape != here.shape or left.voxels.dtype != here.dtype:
            raise ValueError("the saved volume has another grid or type")
        self.until(len(self.recording.cut_at))
        if self.next < len(self.whole_after):
            box, after = self._after(self.next)
            here[box] = np.clip(left.voxels[box], after, here[box])
        apart = np.flatnonzero(left.flat != self.volume.flat)
        return np.abs(left.flat[apart].astype(float) - self.volume.flat[apart].astype(float))
