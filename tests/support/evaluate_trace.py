#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Judges a trace of `palpate-cli run` without any code of Palpate.

  evaluate_trace.py --volume V.nrrd --isovalue S --shell SHELL.csv TRACE.csv
                    [--recording R.palpate [--left LEFT.nrrd]] [--json]
  evaluate_trace.py --self-test

The volume is an NRRD in millimetres (attached, or detached beside its header; raw or gzip); the
shell is the x,y,z in metres that `palpate-cli tool --out` writes; the trace has 22 columns: t_s,
device pose, proxy pose (each x,y,z,qw,qx,qy,qz), force, torque, contacts.

With the recording of the same run (`--cut --record R.palpate --save-volume LEFT.nrrd`) the volume changes:
the proxy of a tick is judged over the voxels as they stood when it moved, that is with all cuts that began
in earlier ticks. They are carried out here, too (trace_cuts.py). What is measured:

  max_penetration_mm    deepest shell point over all proxy poses: 0 where F < s, else (F - s) over
                        the slope of its trilinear cell, and where that vanishes the distance to
                        the nearest voxel with F < s. `penetration_tick` says where.
  contact_ticks         ticks with contacts > 0, and their share
  device_depth_mm       how far the deepest shell point at a device pose lies inside: the distance
                        to the surface towards the nearest voxel with F < s, over the ticks in
                        contact with the largest offset and as many others; where a burr cut, in
                        what it left in the end
  device_offset_mm      largest distance of proxy and device along the force
  coupling_mm           mean distance of proxy and device in contact, by the tool's mass metric
  frozen_share          of the contact ticks: the proxy within 1e-6 mm of where it was
                        (translation + radius x rotation) while more than 0.1 mm (mass metric)
                        from a device that moves
  travel                tangential way of proxy and device over ticks in contact, in the plane
                        normal to the force, and their ratio; `following` is the part of the
                        proxy's that goes the device's way
  force_against_ticks   ticks with a force whose product with (proxy - device) is not positive
  free_force_N          largest force in a tick without contact
  nonfinite             numbers in the trace that are none
  cuts                  of the recording; `removed_mm3` as it has them, `lowered_voxels` and
                        `removed_voxels` (from the isovalue or above to below it) as found here
  undecided_ticks       in which the proxy lies in what the cut under way may have left or not
  left                  the voxels of LEFT.nrrd that are others than here, and the largest
                        difference; they are `as_cut` if whole numbers differ by one at most, and in
                        two or at most 1 % of the lowered voxels, as floats round otherwise than
                        doubles, and others by 1e-5 of the scan's range

Exit: 0 sound; 1 a penetration, a non-finite number, or voxels left otherwise; 2 it cannot be judged;
77 no numpy.
"""

import argparse
import json
import math
import sys

sys.dont_write_bytecode = True  # the source tree stays as it is

try:
    import numpy as np
except ModuleNotFoundError as missing:
    print(f"{missing}; install python3-numpy", file=sys.stderr)
    sys.exit(77)  # ctest reads it as skipped

import trace_cuts
import trace_volume

COLUMNS = 22
STILL_MM = 1e-6
BEHIND_MM = 0.1
DEPTH_TICKS = 8  # ticks of either kind looked at for device_depth_mm
POINTS_AT_ONCE = 200_000


def rotations(q):
    """Matrices (n, 3, 3) of quaternions (n, 4), w first."""
    w, x, y, z = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


def turn_between(q_from, q_to):
    """Rotation vectors (n, 3) that take one orientation to the other, the shorter way."""
    a, b = q_from[:, 1:], q_to[:, 1:]
    w = np.sum(q_from * q_to, axis=1)
    v = q_from[:, :1] * b - q_to[:, :1] * a + np.cross(a, b)
    # q_to conj(q_from): the vector part is w_f v_t - w_t v_f - v_t x v_f
    sign = np.where(w < 0, -1.0, 1.0)
    size = np.linalg.norm(v, axis=1)
    angle = 2 * np.arctan2(size, sign * w)
    scale = np.divide(angle, size, out=np.full_like(size, 2.0), where=size > 0)
    return v * (sign * scale)[:, None]


class Trace:
    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            names = file.readline().strip().split(",")
            if len(names) != COLUMNS:
                raise ValueError(f"{path}: {len(names)} columns in the header, not {COLUMNS}")
            rows = [line.split(",") for line in file if line.strip()]
        if not rows or any(len(row) != COLUMNS for row in rows):
            raise ValueError(f"{path}: no ticks, or a line without {COLUMNS} columns")
        table = np.array(rows, dtype=float)
        self.nonfinite = int(np.count_nonzero(~np.isfinite(table)))
        table = table[np.isfinite(table).all(axis=1)]
        self.t = table[:, 0]
        self.device, self.device_q = table[:, 1:4], table[:, 4:8]
        self.proxy, self.proxy_q = table[:, 8:11], table[:, 11:15]
        self.force, self.torque = table[:, 15:18], table[:, 18:21]
        self.contacts = table[:, 21]
        for q in (self.device_q, self.proxy_q):
            if len(q) and np.abs(np.linalg.norm(q, axis=1) - 1).max() > 1e-9:
                raise ValueError(f"{path}: a quaternion that is not unit")


def read_shell(path):
    points = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)
    if points.shape[1] != 3 or not len(points) or not np.isfinite(points).all():
        raise ValueError(f"{path}: a shell is lines of x,y,z below one header line")
    return points


def placed(shell, position, q):
    """The shell's points (ticks, points, 3) in W, metres."""
    return np.einsum("tij,nj->tni", rotations(q), shell) + position[:, None, :]


def depth_of(volume, isovalue, points):
    """Deepest of these points, mm; 0 if all are legal."""
    points = points[volume.values(points) >= isovalue]
    return float(volume.penetration(points, isovalue).max() * 1e3) if len(points) else 0.0


def penetrations(volume, isovalue, shell, trace, carving=None):
    """Deepest shell point of each proxy pose, mm, and the ticks that cannot be decided. A carving makes
    its cuts on the way; they only lower the field, so a point that was legal before them stays so."""
    deepest, undecided = np.zeros(len(trace.t)), 0
    batch = max(1, POINTS_AT_ONCE // len(shell))
    nearly = isovalue - 1e-9 * (abs(isovalue) + abs(volume.background))  # beyond all rounding
    for begin in range(0, len(trace.t), batch):
        if carving:
            carving.until(begin)
        ticks = slice(begin, begin + batch)
        points = placed(shell, trace.proxy[ticks], trace.proxy_q[ticks])
        maybe = (volume.values(points.reshape(-1, 3)) >= nearly).reshape(len(points), -1)
        for n in np.flatnonzero(maybe.any(axis=1)):
            tick, here = begin + n, points[n][maybe[n]]
            if carving:
                carving.until(tick)
            deepest[tick] = depth_of(volume, isovalue, here)
            if carving and deepest[tick] > 0.0:
                least = carving.with_cut_under_way(tick, lambda: depth_of(volume, isovalue, here))
                if least == 0.0:
                    deepest[tick] = 0.0
                    undecided += 1
    return deepest, undecided


def what_was_cut(carving, left):
    """Figures of the cuts, once all are made; `left`: what the run saved, or none."""
    recording = carving.recording
    apart = carving.differences(left) if left else None
    result = {
        "cuts": len(recording.tick),
        "removed_mm3": float(recording.removed.sum() * 1e9),
        "removed_voxels": carving.removed,
        "lowered_voxels": int(np.count_nonzero(carving.lowered)),
    }
    if left:
        largest = float(apart.max(initial=0.0))
        if left.voxels.dtype.kind == "f":
            as_cut = largest <= 1e-5 * (carving.greatest - left.background)
        else:
            as_cut = largest <= 1.0 and len(apart) <= max(2, 0.01 * result["lowered_voxels"])
        result["left"] = {"other_voxels": len(apart), "largest": largest, "as_cut": bool(as_cut)}
    return result


def device_depth(volume, isovalue, shell, trace, candidates):
    """How deep the deepest shell point at these ticks' device poses is, mm."""
    depth = 0.0
    for tick in candidates:
        one = slice(tick, tick + 1)
        points = placed(shell, trace.device[one], trace.device_q[one])[0]
        points = points[volume.values(points) >= isovalue]
        for p in points:
            depth = max(depth, volume.depth(p, isovalue, at_least=depth))
    return depth * 1e3


def coupling_distances(shell, trace):
    """Mass-metric distance of proxy and device in each tick, mm, for a mass of 1."""
    centred = shell - shell.mean(axis=0)
    squares = np.sum(centred**2, axis=1)
    inertia = np.eye(3) * squares.mean() - centred.T @ centred / len(shell)
    inertia += 1e-6 * squares.max() * np.eye(3)
    turn = turn_between(trace.proxy_q, trace.device_q)
    turn_P = np.einsum("tji,tj->ti", rotations(trace.proxy_q), turn)
    shift = trace.device - trace.proxy
    energy = np.sum(shift**2, axis=1) + np.einsum("ti,ij,tj->t", turn_P, inertia, turn_P)
    return np.sqrt(energy) * 1e3


def steps(position, q, radius):
    """Way from the tick before, mm: translation + radius x rotation."""
    shift = np.linalg.norm(np.diff(position, axis=0), axis=1)
    turn = np.linalg.norm(turn_between(q[:-1], q[1:]), axis=1)
    return (shift + radius * turn) * 1e3


def depth_candidates(contact, offset):
    """Ticks in contact to look at for the device's depth: some with the largest offset, apart in
    time since neighbours say the same again, and as many spread evenly."""
    touching = np.flatnonzero(contact)
    chosen = []
    for tick in touching[np.argsort(-offset[touching], kind="stable")]:
        if all(abs(int(tick) - other) > 20 for other in chosen):
            chosen.append(int(tick))
        if len(chosen) == DEPTH_TICKS:
            break
    even = np.linspace(0, len(touching) - 1, min(DEPTH_TICKS, len(touching))).astype(int)
    return sorted(set(chosen) | {int(tick) for tick in touching[even]})


def evaluate(volume, isovalue, shell, trace, carving=None, left=None):
    ticks = len(trace.t)
    radius = float(np.linalg.norm(shell, axis=1).max())
    contact = trace.contacts > 0
    result = {"ticks": ticks, "points": len(shell), "nonfinite": trace.nonfinite}

    deepest, undecided = penetrations(volume, isovalue, shell, trace, carving)
    if carving:
        carving.until(ticks)
        result["undecided_ticks"] = undecided
        result.update(what_was_cut(carving, left))
    result["max_penetration_mm"] = float(deepest.max(initial=0.0))
    result["penetrating_ticks"] = int(np.count_nonzero(deepest))
    result["penetration_tick"] = int(deepest.argmax()) if deepest.any() else None
    result["contact_ticks"] = int(contact.sum())
    result["contact_share"] = float(contact.mean()) if ticks else 0.0
    result["max_contacts"] = int(trace.contacts.max(initial=0))

    # the offset along the force, and how deep the device is where that is largest
    force_size = np.linalg.norm(trace.force, axis=1)
    pushed = force_size > 0
    normal = np.divide(trace.force, force_size[:, None], out=np.zeros_like(trace.force),
                       where=pushed[:, None])
    offset = np.sum(normal * (trace.proxy - trace.device), axis=1) * 1e3
    coupling = coupling_distances(shell, trace)
    result["device_offset_mm"] = float(offset[contact].max(initial=0.0))
    candidates = depth_candidates(contact, offset)
    result["device_depth_mm"] = device_depth(volume, isovalue, shell, trace, candidates)
    result["coupling_mm"] = float(coupling[contact].mean()) if contact.any() else 0.0
    apart = np.linalg.norm(trace.proxy - trace.device, axis=1) > 0
    against = pushed & apart & (offset <= 0)
    result["force_against_ticks"] = int(against.sum())
    result["max_force_N"] = float(force_size.max(initial=0.0))
    result["free_force_N"] = float(force_size[~contact].max(initial=0.0))

    # how proxy and device moved, from the second tick on
    proxy_steps = steps(trace.proxy, trace.proxy_q, radius)
    device_steps = steps(trace.device, trace.device_q, radius)
    touching = contact[1:]
    frozen = (touching & (proxy_steps < STILL_MM) & (coupling[1:] > BEHIND_MM)
              & (device_steps > STILL_MM))
    result["frozen_ticks"] = int(frozen.sum())
    result["frozen_share"] = float(frozen.sum() / max(1, contact.sum()))

    # tangential ways, over steps that begin and end in contact
    sliding = contact[1:] & contact[:-1] & pushed[1:]
    n = normal[1:][sliding]
    along = []
    for position in (trace.proxy, trace.device):
        step = np.diff(position, axis=0)[sliding]
        along.append(step - np.sum(step * n, axis=1, keepdims=True) * n)
    sizes = [np.linalg.norm(a, axis=1) for a in along]
    way = np.divide(along[1], sizes[1][:, None], out=np.zeros_like(along[1]),
                    where=sizes[1][:, None] > 0)
    travel, led = (float(s.sum() * 1e3) for s in sizes)
    following = float(np.sum(along[0] * way) * 1e3)
    result["travel"] = {
        "proxy_mm": travel,
        "device_mm": led,
        "ratio": travel / led if led > 0 else None,
        "following": following / led if led > 0 else None,
    }
    result["sound"] = (result["max_penetration_mm"] == 0.0 and trace.nonfinite == 0 and ticks > 0
                       and result.get("left", {"as_cut": True})["as_cut"])
    return result


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("trace", nargs="?")
    parser.add_argument("--volume", help="NRRD")
    parser.add_argument("--isovalue", type=float)
    parser.add_argument("--shell", help="CSV of x,y,z in metres")
    parser.add_argument("--recording", help="of the same run, in which a burr cut")
    parser.add_argument("--left", help="NRRD that the run saved; with --recording")
    parser.add_argument("--json", action="store_true", help="one object on standard output")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args(arguments)
    if options.self_test:
        import evaluate_trace_test

        return evaluate_trace_test.run()
    if not (options.trace and options.volume and options.shell) or options.isovalue is None:
        parser.error("a trace, --volume, --isovalue and --shell are needed")
    if options.left and not options.recording:
        parser.error("--left needs --recording")
    try:
        volume = trace_volume.read(options.volume)
        if not math.isfinite(options.isovalue) or options.isovalue <= volume.background:
            raise ValueError("the isovalue must be above the background")
        trace = Trace(options.trace)
        carving = left = None
        if options.recording:
            recording = trace_cuts.Recording(options.recording)
            recording.fits(volume, trace)
            carving = trace_cuts.Carving(volume, recording)
            left = trace_volume.read(options.left) if options.left else None
        result = evaluate(volume, options.isovalue, read_shell(options.shell), trace, carving, left)
    except (OSError, ValueError) as wrong:
        print(f"evaluate_trace: {wrong}", file=sys.stderr)
        return 2
    if options.json:
        print(json.dumps(result))
    else:
        for name, value in result.items():
            print(f"{name:22} {value}")
    if not result["sound"]:
        return 1
    return 2 if result.get("undecided_ticks") else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
