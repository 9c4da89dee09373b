#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every figure of a rehearsal report, computed again from the exports of its recordings.

Usage: rehearsal_test.py PALPATE_CLI FOLDER

A needle goes into the ear canal of the mastoid phantom, which is guarded, along its walls, and against the
bone outside; a burr taps the bone. The script computes the figures from the exported tables, from the points
of the tools, and from the label map, and shares no code with Palpate. Distances are compared with closed
forms, too. Then it looks whether it finds what is wrong on purpose: two labels swapped, a mirrored map,
distances in voxels, an injury that is left out. The report with both sessions stays in FOLDER.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys

from checks import check, outcome

try:
    import numpy as np
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

CLI, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDER.mkdir(parents=True, exist_ok=True)
VOXEL = 0.4e-3  # m
MARGINS = [1.0, 2.0, 5.0]  # mm, where none are asked for
OWN_NAME = "duct <7> & so on"
# of datasets/README.md and the phantom's source, in metres: axis from, to, radius
CAPSULES = {6: ((-1, 3, 9), (-1, 3, 9), 4.0), 7: ((-4.2, -10.4, -2), (-4.2, -9.8, 6), 2.7),
            8: ((19.5, -8.5, 2), (2.8, -10.3, 3), 3.75)}
NERVE = 5


def call(*arguments, code=0):
    done = subprocess.run([CLI, *map(str, arguments), "--json"], capture_output=True, text=True)
    check(done.returncode == code, f"{arguments[:3]} ends with {done.returncode}: {done.stderr[-400:]}")
    return json.loads(done.stdout)


# what was done

def turn_to(direction):
    """The unit quaternion that turns -z there."""
    d = np.asarray(direction) / np.linalg.norm(direction)
    axis = np.cross((0.0, 0.0, -1.0), d)
    q = np.array([1.0 - d[2], *axis])
    return q / np.linalg.norm(q)


def rotation(q):
    """(n, 3, 3) of quaternions (n, 4)."""
    w, x, y, z = np.asarray(q, float).T
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)


def points_of(tool):
    path = FOLDER / f"{tool}.csv"
    call("tool", tool, "--out", path)
    return np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)


def tip_of(points):
    return points[points[:, 2] < points[:, 2].min() + 1e-4].mean(axis=0)


def write_hand(points, name="hand"):
    """Into the canal, to its walls, out, and against the bone beside it."""
    start, end = (np.array(p) * 1e-3 for p in CAPSULES[8][:2])
    along = (end - start) / np.linalg.norm(end - start)
    aside = np.cross(along, (0.0, 0.0, 1.0))
    aside /= np.linalg.norm(aside)
    deep = start + 8e-3 * along
    ways = [(0.0, start - 15e-3 * along), (1.5, deep), (2.0, deep + 6e-3 * aside), (2.5, deep),
            (3.0, deep - 6e-3 * aside), (3.5, deep), (4.3, start - 15e-3 * along),
            (4.9, np.array((24e-3, 5e-3, 6e-3))), (5.4, np.array((15e-3, 5e-3, 6e-3))),
            (6.0, np.array((24e-3, 5e-3, 6e-3)))]
    q = turn_to(along)
    offset = rotation(q[None])[0] @ tip_of(points)
    times, places = zip(*ways)
    with open(FOLDER / f"{name}.csv", "w") as file:
        file.write("t,x,y,z,qw,qx,qy,qz\n")
        for t in np.arange(0.0, 6.005, 0.01):
            place = [np.interp(t, times, [p[a] for p in places]) - offset[a] for a in range(3)]
            file.write(",".join(repr(float(n)) for n in (t, *place, *q)) + "\n")


# the label maps, read and written here

def read_seg(path):
    """For each structure, from 1, which voxels belong to it, [k, j, i]; and what stands around them."""
    whole = path.read_bytes()
    head, voxels = whole[:whole.index(b"\n\n")].decode(), whole[whole.index(b"\n\n") + 2:]
    field = lambda name: re.search(rf"^{name}:=?\s*(.*)$", head, re.M).group(1)
    sizes = [int(n) for n in field("sizes").split()]
    layers = sizes[0] if len(sizes) == 4 else 1
    data = np.frombuffer(voxels, np.uint8).reshape(*sizes[::-1][:3], layers)
    masks, n = {}, 0
    while re.search(rf"^Segment{n}_LabelValue:=", head, re.M):
        layer = int(field(f"Segment{n}_Layer"))
        masks[n + 1] = data[..., layer] == int(field(f"Segment{n}_LabelValue"))
        n += 1
    names = [field(f"Segment{m}_Name") for m in range(n)]
    origin = np.array([float(x) for x in field("space origin").strip("()").split(",")]) * 1e-3
    return whole, masks, names, origin


def write_nrrd(path, data, origin):
    """A plain label map on the grid of the phantom."""
    k, j, i = data.shape
    o = ",".join(repr(1e3 * float(x)) for x in origin)
    path.write_bytes(
        f"NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: {i} {j} {k}\n"
        f"space directions: (0.4,0,0) (0,0.4,0) (0,0,0.4)\nspace origin: ({o})\n"
        "kinds: domain domain domain\nencoding: raw\n\n".encode() + data.astype(np.uint8).tobytes())


# what a recording says in the tables of its exports

class Session:
    def __init__(self, recording, tool):
        name = recording.stem
        call("export", recording, "--format", "csv", "--out", FOLDER / f"{name}.csv")
        call("export", recording, "--format", "motion-bids", "--out", FOLDER / name)
        with open(FOLDER / f"{name}.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        column = lambda key: np.array([float(row[key] or "nan") for row in rows])
        self.ns = np.array([int(row["time_s"].replace(".", "")) for row in rows])
        self.place = np.stack([column("proxy_" + a) for a in "xyz"], axis=1)
        self.turn = rotation(np.stack([column("proxy_quat_" + a) for a in "wxyz"], axis=1))
        self.force = np.linalg.norm(np.stack([column("force_" + a) for a in "xyz"], axis=1), axis=1)
        self.touches = column("contacts") > 0
        self.points = points_of(tool)
        self.tip = self.place + self.turn @ tip_of(self.points)
        self.told = {}  # structure: (of the tip, of the nearest point), m, as they were told live
        for key in rows[0]:
            if key.startswith("nearest_to_"):
                number = int(key.rsplit("_", 1)[1])
                self.told[number] = (column(f"tip_to_{number}"), column(key))
        contacts = np.loadtxt(FOLDER / f"{name}_contacts.tsv", delimiter="\t", skiprows=1, ndmin=2)
        self.of_tick = contacts[:, 0].astype(int)
        self.at = self.place[self.of_tick] + contacts[:, 1:4]
        self.normal, self.push = contacts[:, 4:7], contacts[:, 7]

    def shell(self, every):
        for n in range(0, len(self.ns), every):
            yield n, self.place[n] + self.points @ self.turn[n].T

    def pushes(self, mask, origin):
        """The push on a structure in each tick, and whether it is touched."""
        at = np.rint((self.at - 0.5 * VOXEL * self.normal - origin) / VOXEL).astype(int)
        inside = ((at >= 0) & (at < np.array(mask.shape[::-1]))).all(axis=1)
        hit = np.zeros(len(at), bool)
        i, j, k = at[inside].T
        hit[inside] = mask[k, j, i]
        push, touched = np.zeros(len(self.ns)), np.zeros(len(self.ns), bool)
        np.add.at(push, self.of_tick[hit], self.push[hit])
        touched[self.of_tick[hit]] = True
        return push, touched


def episodes(ns, on):
    """Beginnings and ends; a pause below 0.1 s parts nothing."""
    found = []
    for t in ns[on]:
        if found and t - found[-1][1] < 100_000_000:
            found[-1][1] = t
        else:
            found.append([t, t])
    return found


def figures_of(session):
    ns, tip = session.ns, session.tip
    lasts = np.append(np.diff(ns), 0)
    known = np.where(lasts <= 5_000_000, lasts, 0) * 1e-9
    path, idle, ends, begin = 0.0, 0.0, [], 0
    for n in range(1, len(ns) + 1):
        last = n == len(ns)
        gap = not last and ns[n] - ns[n - 1] > 5_000_000
        if not (last or gap or ns[n] - ns[begin] >= 20_000_000):
            continue
        end = n - 1 if last or gap else n
        length, lasted = np.linalg.norm(tip[end] - tip[begin]), (ns[end] - ns[begin]) * 1e-9
        path += length
        if not session.touches[begin:n].any() and length < 0.005 * lasted:
            idle += lasted
        ends += [begin, end]
        begin = n
    box = np.ptp(tip[ends], axis=0)
    contact = known[session.touches].sum()
    most = int(session.force.argmax())
    return {"time_s": (ns[-1] - ns[0]) * 1e-9, "unknown_s": lasts[lasts > 5_000_000].sum() * 1e-9,
            "path_mm": 1e3 * path, "economy": np.cbrt(box.prod()) / path, "idle_s": idle,
            "contacts": len(episodes(ns, session.touches)), "contact_s": contact,
            "contact_share": contact / known.sum(),
            "force_mean_N": (session.force * known)[session.touches].sum() / contact if contact else None,
            "force_largest_N": session.force[most], "force_largest_N_at_s": ns[most] * 1e-9}


def near(a, b, most):
    return (a is None) == (b is None) and (a is None or abs(a - b) <= most)


def judge(said, session, number, mask, origin, exact, margins):
    """What is wrong in what a report says of a structure. `exact`: (tip, nearest) in metres for each tick, and by
    how much they may be wrong [m]: a number, as distances that were told live are the same, or a bound for each."""
    faults = []
    tip, nearest, bound = exact
    ns, seconds = session.ns, np.append(np.diff(session.ns), 0)
    seconds = np.where(seconds <= 5_000_000, seconds, 0) * 1e-9
    bound_of = lambda n: bound if np.isscalar(bound) else bound[n]

    def distance(key, of):
        least = int(of.argmin())
        if not near(said[key], 1e3 * min(of[least], 0.020), 1e3 * bound_of(least)):
            faults.append(f"{key} is {said[key]} in place of {1e3 * of[least]}")
        if key + "_at_s" in said:
            n = int(np.abs(ns * 1e-9 - said[key + "_at_s"]).argmin())
            if abs(of[n] - of[least]) > 2.0 * bound_of(least):
                faults.append(f"{key} is not at {said[key + '_at_s']} s")
        elif of[least] < 0.020 - bound_of(least):
            faults.append(f"{key} has no time")

    distance("nearest_mm", nearest)
    distance("nearest_of_tip_mm", tip)
    if [w["margin_mm"] for w in said["within"]] != margins:
        faults.append(f"margins {said['within']}")
    for within in said["within"]:
        low = seconds[nearest <= 1e-3 * within["margin_mm"] - bound].sum()
        high = seconds[nearest <= 1e-3 * within["margin_mm"] + bound].sum()
        if not low - 1e-6 <= within["within_s"] <= high + 1e-6:
            faults.append(f"within {within} in place of {low} to {high}")
    push, touched = session.pushes(mask, origin)
    time = seconds[touched].sum()
    for key, value, most in (("touch_s", time, 1e-6),
                             ("touch_mean_N", (push * seconds).sum() / time if time else None, 1e-6),
                             ("touch_largest_N", push[touched].max() if touched.any() else None, 1e-6)):
        if not near(said[key], value, most):
            faults.append(f"{key} is {said[key]} in place of {value}")
    if touched.any():
        at = int(np.abs(ns * 1e-9 - said.get("touch_largest_N_at_s", -1.0)).argmin())
        if abs(push[at] - push.max()) > 1e-6:
            faults.append("the largest force is at another time")
    # surely, and perhaps, where the distance is known by a bound alone
    surely, perhaps = touched | (nearest <= -bound), touched | (nearest <= bound)
    low, high = seconds[surely].sum(), seconds[perhaps].sum()
    if not low - 1e-6 <= said["encounters_s"] <= high + 1e-6:
        faults.append(f"encounters_s is {said['encounters_s']} in place of {low} to {high}")
    if said["encounters"] != len(said["moments"]):
        faults.append(f"{said['encounters']} encounters and {len(said['moments'])} moments")
    if np.isscalar(bound):
        found = episodes(ns, surely)
        if len(found) != said["encounters"] or any(
                abs(f[0] * 1e-9 - m["from_s"]) > 2e-3 or abs(f[1] * 1e-9 - m["to_s"]) > 2e-3
                for f, m in zip(found, said["moments"])):
            faults.append(f"moments {said['moments']} in place of {found}")
    else:
        covered = np.zeros(len(ns), bool)
        for m in said["moments"]:
            covered |= (ns * 1e-9 >= m["from_s"] - 1e-6) & (ns * 1e-9 <= m["to_s"] + 1e-6)
        if (surely & ~covered).any():
            faults.append("a contact is in no moment")
    return [f"structure {number}: {fault}" for fault in faults]


def capsule(points, number):
    a, b, radius = (np.array(p) * 1e-3 for p in CAPSULES[number])
    along = b - a
    t = np.clip((points - a) @ along / max(along @ along, 1e-30), 0.0, 1.0)
    return np.linalg.norm(points - a - t[:, None] * along, axis=1) - radius


def closed(session, number, error):
    """As `judge` wants them: inside, in the middle, a distance is known half as well."""
    tip, nearest = capsule(session.tip, number), np.empty(len(session.ns))
    for n, points in session.shell(1):
        nearest[n] = capsule(points, number).min()
    return tip, nearest, np.where(nearest < 0.0, 2.0, 1.0) * error + 1e-6


def midpoints(mask, origin):
    """Where a structure's surface lies: between two voxels of which one belongs to it."""
    found = []
    for axis, step in ((2, (1, 0, 0)), (1, (0, 1, 0)), (0, (0, 0, 1))):
        k, j, i = np.nonzero(np.diff(mask.astype(np.int8), axis=axis))
        found.append(np.stack([i, j, k], axis=1) + 0.5 * np.array(step))
    return origin + VOXEL * np.concatenate(found)


def brute(session, mask, origin, every, told):
    """The distances told of the nearest point, against the least over all points and all of the surface."""
    surface, worst = midpoints(mask, origin), 0.0
    for n, points in session.shell(every):
        least = min(np.sqrt(((points[at:at + 64, None] - surface) ** 2).sum(axis=2)).min()
                    for at in range(0, len(points), 64))
        if min(least, told[n]) < 0.0195:
            worst = max(worst, abs(least - abs(told[n])))
    return worst


def compare(said, session, what):
    for key, value in figures_of(session).items():
        most = 1e-9 if value is None else max(1e-6, 1e-9 * abs(value))
        if key == "force_largest_N_at_s":
            at = int(np.abs(session.ns * 1e-9 - said[key]).argmin())
            check(abs(session.force[at] - session.force.max()) <= 1e-9, f"{what}: {key}")
        else:
            check(near(said[key], value, most), f"{what}: {key} is {said[key]} in place of {value}")


def none(faults, what):
    for fault in faults:
        check(False, f"{what}: {fault}")
    print(what, "as it should be" if not faults else "is wrong")


# the sessions

bone, labels = FOLDER / "bone.nrrd", FOLDER / "bone.seg.nrrd"
call("convert", "--phantom", "mastoid", bone, "--labels-out", labels)
whole, masks, names, origin = read_seg(labels)
check(len(masks) == 8 and masks[8].any(), f"structures {names}")
write_hand(points_of("needle"))
a, b = FOLDER / "a.palpate", FOLDER / "b.palpate"
touch = ["run", "--phantom", "mastoid", "--isovalue", 300, "--stiffness", 500]
call(*touch, "--tool", "needle", "--hand", FOLDER / "hand.csv", "--seconds", 6, "--labels", labels,
     "--watch", f"{NERVE},6,7,8", "--feel", "8=guarded:2:1.5", "--record", a)
call(*touch, "--tool", "burr-4", "--hand", "tap", "--seconds", 2, "--record", b)
first, second = Session(a, "needle"), Session(b, "burr-4")
check(sorted(first.told) == [NERVE, 6, 7, 8] and not second.told, f"told {sorted(first.told)}")

# the figures of both
out = FOLDER / "report"
call("report", a, b, "--phantom", "mastoid", "--labels", labels, "--watch", f"{NERVE},6,7,8",
     "--margin", "7=12.5", "--margin", "7=3", "--name", f"7={OWN_NAME}", "--out", out)
report = json.loads((out / "report.json").read_text())
compare(report["sessions"][0], first, "needle")
compare(report["sessions"][1], second, "burr")
error = {s["number"]: 1e-3 * s["error_mm"] for s in report["structures"]}
check(all(0.0 < e <= 0.56 * VOXEL for e in error.values()), f"errors {error}")
check(all(abs(s["told_up_to_mm"] - 20.0) < 1e-6 for s in report["structures"]), "told up to 20 mm")


def judged(sessions, exact):
    """What is wrong in the sessions of a report, by distances that were told or by closed forms."""
    faults = []
    for said, session in zip(sessions, (first, second)):
        for one in said["structures"]:
            number = one["number"]
            if exact == "told" and number in session.told:
                of = (*session.told[number], 1e-8)
            elif exact == "closed" and number in CAPSULES:
                of = closed(session, number, error[number])
            else:
                continue
            margins = [3.0, 12.5] if number == 7 else MARGINS
            faults += judge(one, session, number, masks[number], origin, of, margins)
    return faults


none(judged(report["sessions"], "told"), "figures by what was told")
none(judged(report["sessions"], "closed"), "figures by closed forms")
worst = brute(first, masks[NERVE], origin, 60, first.told[NERVE][1])
check(worst <= error[NERVE] + 1e-6, f"the nerve is {1e3 * worst} mm off")
of = {s["number"]: s for s in report["sessions"][0]["structures"]}
check(of[8]["guarded"] and not of[7]["guarded"], "the canal was guarded")
check(of[8]["encounters"] >= 1 and of[8]["nearest_mm"] < -2.0, f"the needle was in the canal: {of[8]}")
check(of[8]["injuries"] == of[8]["encounters"] and of[7]["injuries"] == 0, "contacts while it was guarded are injuries")
check(report["sessions"][0]["contacts"] >= 3, "the needle touched two walls and the bone")
for session, compared in zip(report["sessions"], (4 * len(first.ns), 0)):
    check(session["recorded_distances"] == {"compared": compared, "differing": 0}, "recorded distances")

# two structures that share all that is touched
halves = FOLDER / "halves.nrrd"
j = np.arange(masks[8].shape[1])[None, :, None]
halved = np.where(origin[1] + VOXEL * j < -9.5e-3, 1, 2) * np.ones(masks[8].shape, np.uint8)
write_nrrd(halves, halved, origin)
said = call("report", a, "--labels", halves, "--watch", "1,2", "--out", FOLDER / "halves.json", code=3)
check(said["reasons"] == ["no-structures"], f"the guarded canal is in no map: {said}")
said = call("report", b, "--labels", halves, "--out", FOLDER / "halves.json")
check(said["files"] == [str(FOLDER / "halves.json")], "one file alone")
touched = 0.0
for one in said["sessions"][0]["structures"]:
    push, hit = second.pushes(halved == one["number"], origin)
    seconds = np.append(np.diff(second.ns), 0) * 1e-9
    touched += one["touch_s"]
    check(near(one["touch_s"], seconds[hit].sum(), 1e-6), f"touch_s {one}")
    check(near(one["touch_largest_N"], push[hit].max() if hit.any() else None, 1e-6), f"largest {one}")
check(touched > 0.0, "the burr touched nothing")

# without the distances that were told, the report measures the same
call(*touch, "--tool", "needle", "--hand", FOLDER / "hand.csv", "--seconds", 6, "--record", FOLDER / "c.palpate")
said = call("report", FOLDER / "c.palpate", "--labels", labels, "--watch", f"{NERVE},6,7,8",
            "--margin", "7=12.5", "--margin", "7=3", "--out", FOLDER / "c.csv")
for one in said["sessions"][0]["structures"]:
    then = json.loads(json.dumps(of[one["number"]]))
    for said in (one, then):
        for key in ("guarded", "injuries"):
            said.pop(key)
        for moment in said["moments"]:
            moment.pop("guarded")
    check(one == then, f"watched or not: {one} and {then}")

# the same figures in the table
with open(out / "report.csv", newline="") as file:
    for row in csv.DictReader(file):
        said = report["sessions"][int(row["session"]) - 1]
        if row["structure"]:
            said = next(s for s in said["structures"] if s["number"] == int(row["structure"]))
            check((row["error_mm"] != "") == (row["unit"] == "mm"), f"error of {row}")
            if row["unit"] == "mm":
                twice = 2.0 if float(row["value"]) < 0.0 else 1.0
                check(near(float(row["error_mm"]), twice * 1e3 * error[int(row["structure"])], 1e-9), f"error of {row}")
        if row["figure"] == "within_s":
            value = next(w["within_s"] for w in said["within"] if w["margin_mm"] == float(row["margin_mm"]))
        else:
            value = said[row["figure"]]
        check(near(value, float(row["value"]) if row["value"] else None, 0.0), f"table: {row}")
        if row["at_s"]:
            check(said[row["figure"] + "_at_s"] == float(row["at_s"]), f"table: {row}")

# what a burr takes of a structure and lays bare of one, from the voxels before and after alone
def values_of(path):
    text = path.read_bytes()
    body = text.index(b"\n\n") + 2
    sizes = [int(n) for n in re.search(rb"sizes: (.*)", text[:body]).group(1).split()]
    return np.frombuffer(text[body:], np.int16).reshape(sizes[::-1]).astype(float)


write_hand(points_of("burr-4"), "drill")
axes = np.stack(np.meshgrid(*(origin[axis] + VOXEL * np.arange(masks[8].shape[2 - axis]) for axis in range(3)),
                            indexing="ij"), axis=-1).transpose(2, 1, 0, 3)
beyond = capsule(axes.reshape(-1, 3), 8).reshape(masks[8].shape)
sleeve = ~masks[8] & (beyond < 2.0e-3)
sleeves = FOLDER / "sleeves.nrrd"
write_nrrd(sleeves, np.where(masks[8], 1, np.where(sleeve, 2, 0)), origin)
drilled, left = FOLDER / "drilled.palpate", FOLDER / "left.nrrd"
call(*touch, "--tool", "burr-4", "--hand", FOLDER / "drill.csv", "--seconds", 4, "--labels", sleeves, "--feel",
     "1=guarded:0.5:0.1", "--cut", "--record", drilled, "--save-volume", left)
call("report", drilled, "--phantom", "mastoid", "--labels", sleeves, "--out", FOLDER / "drilled.json")
said = json.loads((FOLDER / "drilled.json").read_text())["sessions"][0]
before, after = values_of(bone), values_of(left)
slope = (300 - before.min()) / 3.0  # of the wall's profile
# of a ball of this radius, straight within 3/16 of a voxel and rounded over 5/8 beyond
at_wall = (0.165 + (1 + 0.625**2) / 12) * VOXEL / (2e-3 + 0.05 * VOXEL)


def part(values):
    depth = at_wall + (values - 300) / slope
    size = np.minimum(np.abs(depth), 0.8125)
    beyond = np.maximum(size - 0.1875, 0.0)
    return 0.5 + np.sign(depth) * (size - beyond**2 / 1.25)


gone = (part(before) - part(after)) * (VOXEL * 1e3) ** 3
bare = (before >= 300) & (after < 300)
exposed = 0.0
for side, axis in enumerate((2, 1, 0)):
    cut = lambda of, first: np.take(of, range(first, of.shape[axis] - 1 + first), axis)
    is_of, behind = cut(masks[8], 0), cut(masks[8], 1)
    faces = (is_of & ~behind & cut(bare, 1)) | (behind & ~is_of & cut(bare, 0))
    at = axes[tuple(np.argwhere(faces).T)] + 0.5 * VOXEL * np.eye(3)[side]
    h = 1e-6 * np.eye(3)
    normals = np.stack([capsule(at + h[b], 8) - capsule(at - h[b], 8) for b in range(3)], axis=1)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    exposed += np.abs(normals[:, side]).sum() * (VOXEL * 1e3) ** 2
canal, wall = said["structures"]
check(gone[sleeve].sum() > 1.0 and near(wall["removed_mm3"], gone[sleeve].sum(), 1e-3),
      f"of the wall {wall['removed_mm3']} in place of {gone[sleeve].sum()}")
check(near(canal["removed_mm3"], gone[masks[8]].sum(), 1e-3), f"of the canal {canal['removed_mm3']}")
check(wall["removed_mm3"] + canal["removed_mm3"] < said["removed_mm3"], f"in all {said['removed_mm3']}")
check(exposed > 2.0 and near(canal["exposed_mm2"], exposed, 0.1 * exposed),
      f"exposed {canal['exposed_mm2']} in place of {exposed}")
check(canal["burr_injuries"] >= 1 and any(m["burr"] and m["guarded"] for m in canal["moments"]) and
      wall["burr_injuries"] == 0, f"injuries by the burr {canal['burr_injuries']}")
check(said["strokes"] >= 1 and said["cut_speed_mean_mm_s"] > 0.0, f"speed {said['cut_speed_mean_mm_s']}")
call("report", drilled, "--labels", sleeves, "--out", FOLDER / "unseen.json")
for one in json.loads((FOLDER / "unseen.json").read_text())["sessions"][0]["structures"]:
    check(one["removed_mm3"] is None and one["exposed_mm2"] is None, f"without the scan {one}")

# the page needs nothing else, and has nobody's names but the user's own
texts = {path.name: path.read_text() for path in out.iterdir()}
check(sorted(texts) == ["report.csv", "report.html", "report.json"], f"files {sorted(texts)}")
html = texts["report.html"]
check(not re.search(r"<script|<link|src\s*=|href\s*=|url\(|@import", html), "the page fetches something")
check("duct &lt;7&gt; &amp; so on" in html and "<7>" not in html, "the user's own name")
for name, text in texts.items():
    for found in [n for n in names if n in text] + [w for w in ("palpate-test", str(FOLDER), "a.palpate") if w in text]:
        check(False, f"{name} has {found}")
for one in report["definitions"]:
    check(one["title"] in html and len(one["means"]) > 20, f"definition {one}")

# what is wrong is found
header = whole[:whole.index(b"\n\n") + 2]
layered = np.frombuffer(whole[len(header):], np.uint8).reshape(*masks[8].shape, -1)
field = lambda n, key: int(re.search(rf"^Segment{n - 1}_{key}:=(\d+)$", header.decode(), re.M).group(1))
places = {n: (field(n, "Layer"), field(n, "LabelValue")) for n in (6, 8)}
swapped = header.decode()
for n, other in ((6, 8), (8, 6)):
    for key, value in zip(("Layer", "LabelValue"), places[other]):
        swapped = re.sub(rf"^Segment{n - 1}_{key}:=\d+$", f"Segment{n - 1}_{key}:={value}", swapped, flags=re.M)
(FOLDER / "swapped.seg.nrrd").write_bytes(swapped.encode() + layered.tobytes())
(FOLDER / "mirrored.seg.nrrd").write_bytes(header + layered[:, :, ::-1].tobytes())
for plant in ("swapped", "mirrored"):
    said = call("report", a, "--labels", FOLDER / f"{plant}.seg.nrrd", "--watch", f"{NERVE},6,7,8",
                "--margin", "7=12.5", "--margin", "7=3", "--out", FOLDER / plant)
    check(said["sessions"][0]["recorded_distances"]["differing"] > 1000, f"{plant}: not said")
    check("label map is another one" in (FOLDER / plant / "report.html").read_text(), f"{plant}: not on the page")
    for exact in ("told", "closed"):
        check(len(judged(said["sessions"], exact)) > 2, f"{plant} is not found by distances that were {exact}")
for plant in ("voxels", "missed"):
    wrong = json.loads(json.dumps(report["sessions"]))
    for one in wrong[0]["structures"]:
        if plant == "voxels":
            one["nearest_mm"] /= 1e3 * VOXEL
        elif one["moments"]:
            one["moments"].pop()
            one["encounters"] -= 1
    for exact in ("told", "closed"):
        check(judged(wrong, exact), f"{plant} is not found by distances that were {exact}")

# what makes no sense is refused
ask = ["report", a, "--labels", labels, "--watch", "8", "--out", FOLDER / "x"]
for words in (["--margin", "8=0"], ["--margin", "8=20"], ["--margin", "7=1"], ["--margin", "x"], ["--name", "8="],
              ["--name", "3=a"], ["--margin", "8=1e", "--name", "8=b"]):
    call(*ask, *words, code=2)
call("report", a, "--out", FOLDER / "x", code=2)
call("report", a, b, a, "--labels", labels, "--out", FOLDER / "x", code=2)
call("report", a, "--labels", labels, "--out", labels, code=4)
said = call("report", a, "--phantom", "demo", "--labels", labels, "--out", FOLDER / "x", code=4)
check(said["reasons"] == ["another-volume"], f"another scan: {said}")
check(not (FOLDER / "x").exists(), "a report was left")
sys.exit(outcome())
