#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A recording's exports hold what was recorded, to the bit, as other programs read them.

Usage: exports_test.py PALPATE_CLI ROOT

Python's own sqlite3 and zlib (app/recording/rows.py), h5py, a reader of TSV and a reader of MCAP
written from its specification are held against the trace of the same run.
"""
import bisect
import csv
import json
import math
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time

from checks import check, outcome

try:
    import h5py
    import numpy
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

CLI, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(ROOT / "app/recording"), str(ROOT / "tests/support")]
import read_mcap  # noqa: E402
import rows  # noqa: E402

AXES = "xyz"
POSE = ["x", "y", "z", "qw", "qx", "qy", "qz"]
BIDS_ENDINGS = ["_motion.tsv", "_contacts.tsv", "_events.tsv", "_channels.tsv", "_channels.json",
               "_motion.json", "_events.json"]
GREATEST_GROWTH_KB = 12 * 1024  # from 6 s to 60 s; the least export of the difference is 9 MB
PEAK = """
import os, sys
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ,
                       file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
_, status, usage = os.wait4(child, 0)
assert status == 0
print(usage.ru_maxrss)
"""
NOTE = "tab\there, two\nlines, ünïcode and \"quotes\""
PLAIN_NOTE = NOTE.replace("\t", " ").replace("\n", " ")

# what BIDS 1.11.0 knows of a _motion.json; its validator refuses every other key
MOTION_KEYS = {
    "TaskName", "TaskDescription", "Instructions", "InstitutionName", "InstitutionAddress",
    "InstitutionalDepartmentName", "Manufacturer", "ManufacturersModelName", "DeviceSerialNumber",
    "SoftwareVersions", "SamplingFrequency", "SamplingFrequencyEffective", "RecordingDuration",
    "SubjectArtefactDescription", "TrackedPointsCount", "TrackingSystemName", "MissingValues",
    "MotionChannelCount", *(kind + "ChannelCount" for kind in (
        "ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY", "MAGN", "MISC", "ORNT", "POS", "VEL"))}
COLUMN_KEYS = {"LongName", "Description", "Levels", "Units", "TermURL"}  # of a column's description
FRAME_KEYS = {"SpatialAxes", "RotationOrder", "RotationRule", "Description"}


def bits(number):
    return struct.pack("<d", number)


def same(what, ours, theirs):
    """Two tables of numbers, to the bit."""
    if not check(len(ours) == len(theirs), f"{what}: {len(ours)} rows in place of {len(theirs)}"):
        return
    for i, (a, b) in enumerate(zip(ours, theirs)):
        if [bits(float(x)) for x in a] != [bits(float(x)) for x in b]:
            check(False, f"{what}: row {i} is {list(a)} in place of {list(b)}")
            return


def cli(*words, expect=0, **how):
    done = subprocess.run([CLI, *map(str, words), "--json"], capture_output=True, timeout=900, **how)
    check(done.returncode == expect,
          f"{' '.join(map(str, words))}: {done.returncode} in place of {expect}: {done.stderr}")
    said = json.loads(done.stdout) if done.stdout else {}
    if expect in (2, 3, 4, 130):
        sentence = said.get("error", {}).get("message", "")
        check(sentence.endswith((".", ")")) and len(sentence) > 20, f"no sentence: {said}")
    return said


def record(folder, name, seconds, tool="probe", hand="slide"):
    cli("run", "--phantom", "sphere", "--isovalue", 0, "--tool", tool, "--hand", hand, "--seconds",
        seconds, "--stiffness", 1000, "--trace", folder / (name + ".csv"), "--record",
        folder / (name + ".palpate"))
    return folder / (name + ".palpate")


def export(recording, format, out, *more, **how):
    return cli("export", recording, "--format", format, "--out", out, *more, **how)


# readers: each gives columns of the steps, the contacts of each step, and the events

def from_rows(path):
    steps = list(rows.steps(str(path)))
    contacts = [[] for _ in steps]
    at = {step["sequence"]: i for i, step in enumerate(steps)}
    for c in rows.contacts(str(path)):
        contacts[at[c["sequence"]]].append(
            [c["arm_" + a] for a in AXES] + [c["normal_" + a] for a in AXES] + [c["push"]])
    file = sqlite3.connect(path)
    events = [(t, kind, value, text or "") for t, kind, value, text in file.execute(
        "SELECT time_ns, kind, value, text FROM event WHERE kind <> 'start' ORDER BY time_ns, id")]
    file.close()
    return {"time": [s["time"] for s in steps],
            "device": [[s["device_" + n] for n in POSE] for s in steps],
            "proxy": [[s["proxy_" + n] for n in POSE] for s in steps],
            "force": [[s["force_" + a] for a in AXES] for s in steps],
            "torque": [[s["torque_" + a] for a in AXES] for s in steps],
            "settings": [[s[n] for n in ("isovalue", "stiffness", "angular_stiffness", "friction", "force_scale",
                                         "position_scale",
                                         "scene")] for s in steps],
            "tick": [[s[n] for n in ("sequence", "cpu", "cut_at", "late_ticks", "missed_ticks",
                                     "force_state", "flags", "contacts")] for s in steps],
            "contacts": contacts, "events": events}


def bytes_of_steps(path):
    file = sqlite3.connect(path)
    size = sum(file.execute(f"SELECT sum(length(data)) FROM {table}").fetchone()[0]
               for table in ("step", "contact"))
    file.close()
    return size


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE))


def ns_of(seconds):
    whole, decimals = seconds.lstrip("-").split(".")
    check(len(decimals) == 9, f"{seconds} has not nine decimals")
    return (-1 if seconds.startswith("-") else 1) * (int(whole) * 10**9 + int(decimals))


def from_bids(prefix):
    channels = table(f"{prefix}_channels.tsv")
    check(channels[0][:6] == ["name", "component", "type", "tracked_point", "units",
                              "reference_frame"], "the channels' columns")
    names = [row[0] for row in channels[1:]]
    check(len(set(names)) == len(names), "two channels of one name")
    motion = table(f"{prefix}_motion.tsv")
    check(all(len(row) == len(names) for row in motion), "columns are not the channels")
    facts = json.load(open(f"{prefix}_motion.json", encoding="utf-8"))
    for key in ("TaskName", "SamplingFrequency", "TrackingSystemName"):
        check(key in facts, f"_motion.json lacks {key}")
    check(facts["MotionChannelCount"] == len(names) and facts["TrackedPointsCount"] == 2,
          "the counts of _motion.json")
    for kind in ("POS", "ORNT", "LATENCY", "MISC"):
        check(facts[kind + "ChannelCount"] == sum(r[2] == kind for r in channels[1:]),
              f"the count of {kind} in _motion.json")
    frames = json.load(open(f"{prefix}_channels.json", encoding="utf-8"))["reference_frame"]
    check({row[5] for row in channels[1:]} - {"n/a"} == set(frames["Levels"]), "reference frames")
    column = {name: [row[i] for row in motion] for i, name in enumerate(names)}

    def columns(*wanted, number=float):
        return [list(map(number, row)) for row in zip(*[column[name] for name in wanted])]

    pose = ["x", "y", "z", "quat_w", "quat_x", "quat_y", "quat_z"]
    first = int(column["time"][0])
    check([ns_of(t) for t in column["latency"]] == [int(t) - first for t in column["time"]],
          "latencies are not times since the first row")
    read = {"time": list(map(int, column["time"])),
            "device": columns(*["device_" + n for n in pose]),
            "proxy": columns(*["proxy_" + n for n in pose]),
            "force": columns(*["force_" + a for a in AXES]),
            "torque": columns(*["torque_" + a for a in AXES]),
            "settings": columns("isovalue", "stiffness", "angular_stiffness", "friction", "force_scale",
                                         "position_scale", "scene"),
            "tick": columns("step", "cpu", "cut_at", "late_ticks", "missed_ticks", "force_state",
                            "flags", "contacts", number=int)}
    if os.path.exists(f"{prefix}_contacts.tsv"):
        read["contacts"] = [[] for _ in motion]
        for row in table(f"{prefix}_contacts.tsv")[1:]:
            read["contacts"][int(row[0])].append(list(map(float, row[1:])))
    events = table(f"{prefix}_events.tsv")
    check(events[0] == ["onset", "duration", "trial_type", "value", "note"], "the events' columns")
    read["events"] = [(ns_of(onset) + first, kind, None if value == "n/a" else float(value),
                       "" if note == "n/a" else note) for onset, _, kind, value, note in events[1:]]
    levels = json.load(open(f"{prefix}_events.json", encoding="utf-8"))["trial_type"]["Levels"]
    check({row[2] for row in events[1:]} <= set(levels), "a kind of event is not told of")
    return read


def is_bids(prefix):
    """Every key of every sidecar is one that BIDS knows, and every value of a kind it allows."""
    sidecars = sorted(pathlib.Path(prefix).parent.glob(pathlib.Path(prefix).name + "_*.json"))
    check([f.name.rsplit("_", 1)[1] for f in sidecars] ==
          ["channels.json", "events.json", "motion.json"], f"sidecars: {sidecars}")
    for sidecar in sidecars:
        facts = json.loads(sidecar.read_text(encoding="utf-8"))
        if sidecar.name.endswith("_motion.json"):
            check(set(facts) <= MOTION_KEYS, f"not of BIDS: {set(facts) - MOTION_KEYS}")
            for key, value in facts.items():
                number = key.endswith("Count") or key.startswith(("Sampling", "Recording"))
                check(isinstance(value, (int, float) if number else str), f"{key} is {value}")
            continue
        columns = table(str(sidecar)[:-len("json")] + "tsv")[0]
        for column, told in facts.items():
            check(column in columns, f"{sidecar.name} tells of {column}, which is no column")
            check(set(told) <= COLUMN_KEYS, f"{sidecar.name}, {column}: {set(told) - COLUMN_KEYS}")
            for level in told.get("Levels", {}).values():
                check(isinstance(level, str) or
                      column == "reference_frame" and set(level) <= FRAME_KEYS,
                      f"{sidecar.name}, {column}: {level}")
    # and what BIDS has no key for is told in words
    made_by = json.loads(pathlib.Path(f"{prefix}_motion.json").read_text())["SoftwareVersions"]
    check("Palpate" in made_by and "build" in made_by and "cpu" in made_by, made_by)
    scene = [row for row in table(f"{prefix}_channels.tsv") if row[0] == "scene"][0][6]
    check("1: tool probe, field trilinear" in scene and "dims [64,64,64]" in scene and '"' not in scene, scene)
    if shutil.which("bids-validator"):
        validates(prefix)


def validates(prefix):
    with tempfile.TemporaryDirectory() as scratch:
        place = pathlib.Path(scratch)
        motion = place / "sub-01/motion"
        motion.mkdir(parents=True)
        (place / "dataset_description.json").write_text(
            '{"Name": "touch", "BIDSVersion": "1.11.0", "Authors": ["A. Hand", "B. Eye"]}')
        (place / "README").write_text("A hand felt a phantom, and this is how it moved.\n" * 5)
        (place / "participants.tsv").write_text("participant_id\nsub-01\n")
        for ending in BIDS_ENDINGS:
            if ending != "_contacts.tsv":
                shutil.copy(f"{prefix}{ending}",
                            motion / f"sub-01_task-touch_tracksys-palpate{ending}")
        done = subprocess.run(["bids-validator", "--json", place], capture_output=True, text=True)
        issues = json.loads(done.stdout)["issues"]
        check(done.returncode == 0 and not issues["errors"], f"bids-validator: {issues['errors']}")
        # 1.15 takes the first row of every table for names of columns; BIDS allows _motion.tsv none
        found = {(w["key"], f["file"]["name"].rsplit("_", 1)[1] if f["file"] else "") for w in issues["warnings"]
                 for f in w["files"]}
        check(found <= {("CUSTOM_COLUMN_WITHOUT_DESCRIPTION", "motion.tsv")}, f"bids-validator: {found}")


def from_hdf5(path):
    with h5py.File(path) as file:
        def joined(*names):
            return numpy.column_stack([file[name][:] for name in names]).tolist()

        def look(name, dataset):
            if isinstance(dataset, h5py.Dataset):
                check("unit" in dataset.attrs and "meaning" in dataset.attrs, f"{name} has no unit")
                check(dataset.chunks and dataset.shuffle and dataset.compression == "gzip",
                      f"{name} is not chunked and compressed")
        file.visititems(look)
        for name, unit in (("time", "ns"), ("device/position", "m"), ("device/orientation", "1"),
                           ("proxy/position", "m"), ("force", "N"), ("torque", "N.m"), ("events/time", "ns")):
            check(file[name].attrs["unit"] in (unit, unit.encode()), f"hdf5: {name} in {file[name].attrs['unit']}")
        check(file["time"].dtype == "int64" and file["force"].dtype == "float64", "types")
        scene = file["scenes/1"].attrs
        check(scene["tool"] == "probe" and list(scene["dims"]) == [64, 64, 64] and
              scene["dims"].dtype == "int64", "the scene's facts")
        check(scene["direction"].shape == (3, 3), "the scene's direction")
        check("physics_data" not in file and "metadata" not in file, "what was not drilled has groups of drilling")
        read = {"time": file["time"][:].tolist(),
                "device": joined("device/position", "device/orientation"),
                "proxy": joined("proxy/position", "proxy/orientation"),
                "force": file["force"][:].tolist(), "torque": file["torque"][:].tolist(),
                "settings": joined("settings/isovalue", "settings/stiffness",
                                   "settings/angular_stiffness", "settings/friction", "settings/force_scale",
                                   "settings/position_scale", "tick/scene"),
                "tick": list(zip(*[file[n][:].tolist() for n in (
                    "step", "tick/cpu", "tick/cut_at", "tick/late", "tick/missed",
                    "tick/force_state", "tick/flags", "tick/contacts")]))}
        if "contacts" in file:
            every = numpy.column_stack([file["contacts/" + n][:] for n in
                                        ("arm", "normal", "push")]).astype(float).tolist()
            read["contacts"] = [every[first:first + count] for first, count in zip(
                file["contacts/first"][:].tolist(), file["tick/contacts"][:].tolist())]
        read["events"] = [(t, kind.decode(), None if math.isnan(value) else value, note.decode())
                          for t, kind, value, note in zip(*[file["events/" + n][:] for n in (
                              "time", "kind", "value", "note")])]
        return read


def from_mcap(path):
    file = read_mcap.read(path)
    topics = file["topics"]
    check(file["order"] == sorted(file["order"]), "messages are not in order of time")
    check(file["metadata"]["scene 1"]["tool"] == "probe" and
          len(json.loads(file["metadata"]["scene 1"]["tool_origin_m"])) == 3, "the scene's facts in MCAP")
    try:
        import jsonschema
        for topic, schema in file["schemas"].items():
            for _, message in topics[topic][::500]:
                jsonschema.validate(message, {**schema, "required": list(schema["properties"]),
                                              "additionalProperties": False})
    except ImportError:
        pass

    def vector(v):
        return [v[a] for a in AXES]

    def poses(topic):
        found = []
        for t, m in topics[topic]:
            check(m["timestamp"] == {"sec": t // 10**9, "nsec": t % 10**9}, "a pose's time")
            q = m["pose"]["orientation"]
            found.append(vector(m["pose"]["position"]) + [q["w"]] + vector(q))
        return found

    # settings hold until the next ones
    settings, changes = [], topics["/settings"]
    for t, _ in topics["/tick"]:
        while len(changes) > 1 and changes[1][0] <= t:
            changes = changes[1:]
        now = changes[0][1]
        settings.append([now[n] for n in ("isovalue", "stiffness", "angular_stiffness", "friction", "force_scale",
                                         "position_scale",
                                          "scene")])
    read = {"time": [t for t, _ in topics["/tick"]], "device": poses("/device"),
            "proxy": poses("/proxy"), "settings": settings,
            "force": [vector(m["force"]) for _, m in topics["/wrench"]],
            "torque": [vector(m["torque"]) for _, m in topics["/wrench"]],
            "tick": [[m[n] for n in ("step", "cpu_ns", "cut_at", "late", "missed", "force_state",
                                     "flags", "contacts")] for _, m in topics["/tick"]],
            "events": [(t, m["kind"], m["value"], m["note"]) for t, m in topics["/event"]]}
    if topics["/contacts"]:
        read["contacts"] = [[vector(c["arm"]) + vector(c["normal"]) + [c["push"]]
                             for c in m["contacts"]] for _, m in topics["/contacts"]]
    return read


FORMATS = {"motion-bids": ("", from_bids), "hdf5": (".h5", from_hdf5), "mcap": (".mcap", from_mcap)}


def whole(format, out):
    if format == "csv":
        return [str(out), str(out.with_suffix(".columns.json"))]
    return [f"{out}{ending}" for ending in BIDS_ENDINGS] if format == "motion-bids" else [str(out)]


def compare(what, read, truth, chosen=None, contacts=True):
    """`chosen`: which of the true steps."""
    chosen = range(len(truth["time"])) if chosen is None else chosen
    check(read["time"] == [truth["time"][i] for i in chosen], f"{what}: times differ")
    for name in ("device", "proxy", "force", "torque", "settings", "tick"):
        same(f"{what} {name}", read[name], [truth[name][i] for i in chosen])
    if contacts:
        same(f"{what} counts", [[len(c)] for c in read["contacts"]],
             [[len(truth["contacts"][i])] for i in chosen])
        same(f"{what} contacts", [c for step in read["contacts"] for c in step],
             [c for i in chosen for c in truth["contacts"][i]])
    else:
        check("contacts" not in read, f"{what}: has contacts")


def holds_the_trace(folder):
    recording = record(folder, "session", 3)
    # what a run without a user does not have
    file = sqlite3.connect(recording)
    file.execute("INSERT INTO event (sequence, time_ns, kind, value, text) VALUES "
                 "(1200, 1200400000, 'mark', NULL, ?), (2000, 2000000000, 'late', 3, NULL)", (NOTE,))
    file.commit()
    file.close()
    truth = from_rows(recording)
    with open(folder / "session.csv") as trace:
        lines = [list(map(float, line)) for line in list(csv.reader(trace))[1:]]
    check(len(lines) == 3000, "the trace has not 3000 rows")
    check(truth["time"] == [round(line[0] * 1e9) for line in lines], "times are not the trace's")
    for name, begin, end in (("device", 1, 8), ("proxy", 8, 15), ("force", 15, 18),
                             ("torque", 18, 21)):
        same(f"recording {name}", truth[name], [line[begin:end] for line in lines])
    check([len(c) for c in truth["contacts"]] == [int(line[21]) for line in lines], "contacts")
    check(sum(map(len, truth["contacts"])) > 1000, "the hand hardly touched")
    events = [(t, kind, value, text.replace("\t", " ").replace("\n", " "))
              for t, kind, value, text in truth["events"]]
    check((1200400000, "mark", None, PLAIN_NOTE) in events and len(events) >= 7, "events")
    for format, (ending, read) in FORMATS.items():
        out = folder / f"whole{ending}"
        said = export(recording, format, out)
        check(said["files"] == whole(format, out), f"{format}: files are {said['files']}")
        check(said["steps"] == 3000 and said["events"] == len(events), f"{format}: counts")
        check(said["bytes"] == sum(os.path.getsize(f) for f in said["files"]), f"{format}: bytes")
        found = read(out)
        compare(format, found, truth)
        check(found["events"] == events, f"{format}: events are {found['events']}")
    is_bids(folder / "whole")
    return recording, truth


def read_nrrd(path):
    """The voxels by i, j, k, their spacing and origin [m]; of files that palpate-cli has written."""
    header, voxels = pathlib.Path(path).read_bytes().split(b"\n\n", 1)
    fields = dict(re.findall(r"^([a-z ]+): (.*)$", header.decode(), re.MULTILINE))
    check(fields["type"] == "int16" and fields["encoding"] == "raw", f"{path}: {fields}")
    directions = numpy.array([list(map(float, column.split(","))) for column in
                              re.findall(r"\(([^)]*)\)", fields["space directions"])])
    origin = numpy.array(list(map(float, fields["space origin"].strip("()").split(","))))
    sizes = list(map(int, fields["sizes"].split()))
    return numpy.frombuffer(voxels, "<i2").reshape(sizes, order="F"), directions * 1e-3, origin * 1e-3


def is_a_drilling_recording(folder):
    """What a burr did, read by the names that FIVRS has published: today's, and those of its scripts that look at the
    root. It is what the recorded cuts come to, and what they have left."""
    cli("convert", "--phantom", "sphere", folder / "cube.nrrd")
    scan, name = folder / "drilled.nrrd", folder / "drilled"
    # no two sides are the same
    cli("convert", folder / "cube.nrrd", scan, "--box", 2, 62, 7, 64, 0, 61)
    for rate in (1000, 2000):
        cli("run", "--volume", scan, "--isovalue", 0, "--tool", "burr-6", "--hand", "slide", "--seconds", 3, "--rate", rate,
            "--stiffness", 1500, "--cut", "--burr-energy", 0.3, "--record", f"{name}.palpate", "--save-volume",
            f"{name}.left.nrrd")
        said = export(f"{name}.palpate", "hdf5", f"{name}.h5", "--volume", scan)
        before, directions, origin = read_nrrd(scan)
        left, _, _ = read_nrrd(f"{name}.left.nrrd")
        check(before.shape == (60, 57, 61) and numpy.array_equal(directions, 1e-3 * numpy.eye(3)), "the scan")
        cuts, steps = list(rows.cuts(f"{name}.palpate")), list(rows.steps(f"{name}.palpate"))
        times = {step["sequence"]: step["time"] * 1e-9 for step in steps}
        check(len(cuts) > 1000 and all(cut["radius"] == cuts[0]["radius"] and cut["isovalue"] == 0 for cut in cuts),
              f"{len(cuts)} cuts")

        with h5py.File(f"{name}.h5") as file:
            group = file["physics_data/intermittent_data"]
            stamps = group["voxels_removed/voxel_time_stamp"][()]
            removed = group["voxels_removed/voxel_removed"][()]
            colour = group["voxels_removed/voxel_color"][()]
            check(removed.shape == (said["removed_voxels"], 4) and colour.shape == (len(removed), 5) and
                  len(removed) > 300, f"{removed.shape} voxels, {colour.shape} colours")
            check((numpy.diff(stamps) > 0).all() and set(stamps) <= set(times.values()), "stamps are no times of steps")
            check(numpy.array_equal(numpy.unique(removed[:, 0]), numpy.arange(len(stamps))) and
                  (numpy.diff(removed[:, 0]) >= 0).all() and numpy.array_equal(colour[:, 0], removed[:, 0]),
                  "not every stamp has its voxels")
            check((colour[:, 1:] == [255, 249, 219, 255]).all(), "colours")
            check(file["metadata_v3/voxel_volume"][()] == 1.0, "the volume of a voxel")
            check(group["burr_change/burr_size"][()].tolist() == [6.0] and
                  group["burr_change/time_stamp"][()].tolist() == [times[0]], "the burr")
            wrench, at = (group["drill_force_feedback/" + n][()] for n in ("wrench", "time_stamp"))
            same("wrench", wrench, [[step[f"{of}_{a}"] for of in ("force", "torque") for a in AXES] for step in steps])
            check(at.tolist() == list(times.values()), "times of forces")
            # where view_voxel_data.py looks
            for one in ("voxels_removed/voxel_time_stamp", "voxels_removed/voxel_color", "voxels_removed/voxel_removed",
                        "burr_change/burr_size", "drill_force_feedback/wrench"):
                check(numpy.array_equal(file[one][()], group[one][()]), f"{one} at the root")
            check(file["metadata/voxel_volume"][()] == 1.0, "the volume of a voxel at the root")
            check(len(file["removed_volume"]) == len(steps), "our own names")

        # those that were within the surface and are not in what was left, each once
        index = removed[:, 1:].astype(int)
        gone = numpy.argwhere((before >= 0) & (left < 0))
        check(sorted(map(tuple, index)) == sorted(map(tuple, gone)), f"{len(index)} voxels, and {len(gone)} are gone")
        # by the first cut whose ball reached it, the ball's edge as haptics/carving tells; whole numbers blur it
        begin = numpy.array([[cut["from_" + a] for a in AXES] for cut in cuts])
        way = numpy.array([[cut["to_" + a] for a in AXES] for cut in cuts]) - begin
        edge, blur = cuts[0]["radius"] + 0.165e-6 / cuts[0]["radius"], 3e-6
        wrong = 0
        for row, *voxel in removed:
            offset = origin + 1e-3 * numpy.array(voxel) - begin
            along = numpy.clip((offset * way).sum(1) / numpy.maximum((way * way).sum(1), 1e-30), 0, 1)
            distance = numpy.linalg.norm(offset - along[:, None] * way, axis=1)
            reached, surely = (numpy.flatnonzero(distance < edge + b) for b in (blur, -blur))
            wrong += not (len(reached) and times[cuts[reached[0]]["sequence"]] <= stamps[int(row)] and
                          (not len(surely) or stamps[int(row)] <= times[cuts[surely[0]]["sequence"]]))
        check(wrong == 0, f"{wrong} voxels have another time than their first cut")

        # a part: the same voxels at the same times, whatever the rate
        export(f"{name}.palpate", "hdf5", f"{name}.part.h5", "--volume", scan, "--from", 1, "--to", 2, "--rate", 50)
        with h5py.File(f"{name}.part.h5") as file:
            group = file["physics_data/intermittent_data"]
            in_part = (stamps >= 1) & (stamps <= 2)
            check(0 < in_part.sum() < len(stamps) and
                  numpy.array_equal(group["voxels_removed/voxel_time_stamp"][()], stamps[in_part]), "stamps of a part")
            of_part = removed[in_part[removed[:, 0].astype(int)]]
            check(numpy.array_equal(group["voxels_removed/voxel_removed"][()][:, 1:], of_part[:, 1:]), "voxels of a part")
            check(group["voxels_removed/voxel_removed"][0, 0] == 0, "rows of a part")
            check(len(group["drill_force_feedback/wrench"]) == len(file["time"]) == 51, "forces of a part")
    # the same to the byte; without the scan it says what it lacks; of another scan it is refused
    export(f"{name}.palpate", "hdf5", f"{name}.again.h5", "--volume", scan)
    check(open(f"{name}.again.h5", "rb").read() == open(f"{name}.h5", "rb").read(), "two exports differ")
    done = subprocess.run([CLI, "export", f"{name}.palpate", "--format", "hdf5", "--out", f"{name}.h5"], capture_output=True)
    check(done.returncode == 0 and b"--volume" in done.stderr, f"without the scan: {done}")
    with h5py.File(f"{name}.h5") as file:
        check(list(file["physics_data/intermittent_data"]) == ["burr_change", "drill_force_feedback"] and
              "voxels_removed" not in file and file["metadata/voxel_volume"][()] == 1.0, "without the scan")
    export(f"{name}.palpate", "hdf5", f"{name}.h5", "--volume", folder / "cube.nrrd", expect=4)
    export(f"{name}.palpate", "mcap", f"{name}.mcap", "--volume", scan, expect=2)


def holds_distances(folder):
    """Distances to structures, in the recording and its exports as in the trace; none of them where none is watched."""
    cli("convert", "--phantom", "sphere", folder / "scan.nrrd")
    origin = ",".join(map(str, cli("info", folder / "scan.nrrd")["origin_mm"]))
    marked = bytes(9 if n // 4096 > 53 else 4 if n % 64 < 14 else 7 if n == 100_060 else 0 for n in range(64**3))
    (folder / "labels.nrrd").write_bytes(
        (f"NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 64 64 64\n"
         f"space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: ({origin})\nencoding: raw\n\n").encode() + marked)
    for rate, most in ((1000, 0.0), (2000, 0.51e-7)):
        name = folder / f"watched{rate}"
        cli("run", "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd", "--watch", "3,1", "--isovalue", 0,
            "--tool", "probe", "--hand", "slide", "--seconds", 2, "--stiffness", 1000, "--rate", rate,
            "--trace", f"{name}.csv", "--record", f"{name}.palpate")
        with open(f"{name}.csv") as trace:
            lines = list(csv.DictReader(trace))
        columns = [f"{what}_to_{number}" for number in (1, 3) for what in ("tip", "nearest")]
        truth = numpy.array([[line[column + "_m"] for column in columns] for line in lines], "float32")
        check(len(truth) == 2 * rate and len({tuple(row) for row in truth}) > rate, "the distances hardly change")

        def holds(what, found):
            check(found.shape == truth.shape and numpy.abs(found - truth).max() <= most, f"{what} at {rate} Hz: distances")

        holds("rows.py", numpy.array([[row[c] for c in columns] for row in rows.distances(f"{name}.palpate")], "float32"))
        for format, (ending, _) in {**FORMATS, "csv": (".table.csv", None)}.items():
            export(f"{name}.palpate", format, f"{name}{ending}")
        with h5py.File(f"{name}.h5") as file:
            holds("hdf5", numpy.column_stack([file[f"structures/{number}/{what}"][:] for number in (1, 3)
                                              for what in ("tip", "nearest")]))
        messages = [m["structures"] for _, m in read_mcap.read(f"{name}.mcap")["topics"]["/structures"]]
        check(all([one["number"] for one in m] == [1, 3] for m in messages), "mcap: numbers of structures")
        holds("mcap", numpy.array([[one[what] for one in m for what in ("tip", "nearest")] for m in messages], "float32"))
        with open(f"{name}.table.csv", encoding="utf-8", newline="") as file:
            holds("csv", numpy.array([[row[c] for c in columns] for row in csv.DictReader(file)], "float32"))
        names = [row[0] for row in table(f"{name}_channels.tsv")[1:]]
        holds("bids", numpy.array([[row[names.index(c)] for c in columns] for row in table(f"{name}_motion.tsv")], "float32"))
        # what was recorded is what a replay comes to
        said = cli("replay", f"{name}.palpate", "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd")
        check(said["differing"] == 0 and said["distances"] == 4 * rate and said["differing_distances"] == 0,
              f"a replay with structures: {said}")
    # felt otherwise, and still the same in a replay; without the structures it says what it lacks
    felt = folder / "felt.palpate"
    force = {}
    for name, feels in (("as", ()), ("felt", ("--feel", "1=softer:200", "--feel", "3=guarded:15:2"))):
        force[name] = cli("run", "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd", "--isovalue", 0,
                          "--tool", "probe", "--hand", "slide", "--seconds", 2, "--stiffness", 1000,
                          *(("--record", felt) if feels else ()), *feels)["max_force_N"]
    check(force["as"] != force["felt"], f"structures are felt as the scan has them: {force}")
    said = cli("replay", felt, "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd")
    check(said["steps"] == 2000 and said["differing"] == 0 == said["differing_distances"], f"a replay of what was felt: {said}")
    cli("replay", felt, "--volume", folder / "scan.nrrd", expect=3)
    cli("replay", felt, "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd", "--watch", 1, expect=3)
    # walls: solid and not there, made again from the label map
    scan = "--volume", folder / "scan.nrrd"
    walls = folder / "walls.palpate"
    said = cli("run", *scan, "--labels", folder / "labels.nrrd", "--isovalue", 0, "--tool", "probe", "--hand", "slide", "--seconds", 1,
               "--stiffness", 1000, "--feel", "1=solid", "--feel", "3=not-there", "--record", walls)
    check(said["max_force_N"] != force["as"] and said["max_penetration_mm"] == 0.0 and said["contact_ticks"] > 100,
          f"a run with walls: {said}")
    check([one["bytes"] > 0 for one in said["structures"] if one["name"] == "walls"] == [True], f"walls: {said['structures']}")
    again = cli("replay", walls, *scan, "--labels", folder / "labels.nrrd")
    check(again["steps"] == 1000 and again["differing"] == 0, f"a replay with walls: {again}")
    check("no-structures" in cli("replay", walls, *scan, expect=3)["reasons"], "walls without the label map")
    voxels = (folder / "labels.nrrd").read_bytes()
    at = voxels.index(b"\n\n") + 2
    (folder / "swapped.nrrd").write_bytes(voxels[:at] + voxels[at:].translate(bytes.maketrans(b"\x04\x09", b"\x09\x04")))
    check("other-structures" in cli("replay", walls, *scan, "--labels", folder / "swapped.nrrd", expect=3)["reasons"],
          "walls with two labels swapped")
    for wrong in ("1=solid:2", "1=not-there:1", "1=softer", "1=softer:0", "x=softer:1", "1=guarded:25:1", "9=softer:1", "1=softer:1:2", "1=hard:1"):
        cli("run", "--volume", folder / "scan.nrrd", "--labels", folder / "labels.nrrd", "--feel", wrong, "--isovalue", 0, "--tool",
            "probe", "--hand", "slide", "--seconds", 2, "--stiffness", 1000, expect=2)
    explained = json.loads((folder / "watched1000.table.columns.json").read_text())["columns"]["tip_to_3"]
    check(explained["unit"] == "m" and "structure 3" in explained["meaning"], f"csv explains {explained}")


def is_one_table(folder, recording, truth):
    """What a spreadsheet makes of it: a line of names, numbers, and the events as words."""
    out = folder / "whole.csv"
    said = export(recording, "csv", out)
    check(said["files"] == whole("csv", out) and said["steps"] == 3000, f"csv: {said}")
    check(said["bytes"] == sum(os.path.getsize(f) for f in said["files"]), "csv: bytes")
    with open(out, encoding="utf-8", newline="") as file:
        names, *rows_ = csv.reader(file)
    check(names[0] == "time_s" and names[-1] == "events" and len(set(names)) == len(names), f"csv: {names}")
    check(len(rows_) == 3000 and all(len(row) == len(names) for row in rows_), "csv: rows of another length")
    column = {name: [row[i] for row in rows_] for i, name in enumerate(names)}
    pose = ["x", "y", "z", "quat_w", "quat_x", "quat_y", "quat_z"]
    check([ns_of(t) for t in column["time_s"]] == truth["time"], "csv: times differ")
    for name, wanted in (("device", ["device_" + n for n in pose]), ("proxy", ["proxy_" + n for n in pose]),
                         ("force", ["force_" + a for a in AXES]), ("torque", ["torque_" + a for a in AXES])):
        same(f"csv {name}", [[row[i] for i in map(names.index, wanted)] for row in rows_], truth[name])
    # each event is in the first row that is not before it
    events = [e for e in truth["events"] if e[1] != "camera"]
    check(said["events"] == len(events), f"csv: {said['events']} events in place of {len(events)}")
    for time_ns, kind, value, note in events:
        row = min(bisect.bisect_left(truth["time"], time_ns), 2999)
        words = column["events"][row].split(" | ")
        wanted = kind + (f" {value:g}" if value is not None else "")
        plain = note.replace("\t", " ").replace("\n", " ")
        check(any(w.startswith(wanted) and w.endswith(plain) for w in words), f"csv: {words} lack {wanted} {note}")
    explained = json.load(open(whole("csv", out)[1], encoding="utf-8"))
    check(list(explained["columns"]) == names, "the dictionary's columns are not the table's")
    check(all(c["meaning"] for c in explained["columns"].values()), "a column without a meaning")
    meanings = {explained["columns"][f"{point}_{part}"]["meaning"]
                for point in ("device", "proxy") for part in ("x", "quat_w")}
    check(len(meanings) == 4, f"columns that mean the same: {meanings}")
    check(all(not re.match("[A-Z] ", c["meaning"]) for c in explained["columns"].values()), "a unit with a capital")
    units = {name: c.get("unit") for name, c in explained["columns"].items()}
    for name, unit in (("time_s", "s"), ("device_x", "m"), ("proxy_z", "m"), ("proxy_quat_w", None), ("force_z", "N"),
                       ("torque_y", "N.m")):
        check(units[name] == unit, f"csv: {name} in {units[name]} in place of {unit}")
    check("left, posterior, superior" in explained["frame"], explained["frame"])
    said = export(recording, "csv", folder / "slow.csv", "--rate", 100, "--from", 1)
    check(said["steps"] == 200, f"csv: {said}")


def says_what_decided(folder):
    """Every format tells of the run, and its sentences are true of its numbers."""
    recording = folder / "rubbed.palpate"
    run = cli("run", "--phantom", "halfspace", "--isovalue", 1000, "--tool", "hook", "--hand", "slide", "--seconds", 3,
              "--stiffness", 900, "--friction", 0.3, "--epsilon", 0.04, "--sub-steps", 6, "--seed", 3, "--budget", 150,
              "--record", recording)
    decided = {"program": "palpate-cli", "commit": run["made_by"]["commit"], "run_scene": "halfspace",
               "run_hand": "slide", "run_seed": 3, "run_device": "none", "run_budget_work": 15000}
    of_scene = {"field": "trilinear", "normals": "central", "epsilon_voxels": 0.04, "sub_steps": 6}
    sentences = ("quaternion", "tool_origin", "force_law")
    export(recording, "csv", folder / "rubbed.csv")
    explained = json.load(open(folder / "rubbed.columns.json", encoding="utf-8"))
    export(recording, "hdf5", folder / "rubbed.h5")
    export(recording, "mcap", folder / "rubbed.mcap")
    export(recording, "motion-bids", folder / "rubbed")
    logged = read_mcap.read(folder / "rubbed.mcap")
    with h5py.File(folder / "rubbed.h5") as file:
        told = {"csv": (explained["recording"], explained["scenes"]["1"]),
                "hdf5": (dict(file.attrs), dict(file["scenes/1"].attrs)),
                "mcap": (logged["metadata"]["recording"], logged["metadata"]["scene 1"])}
        numbers = {"hdf5": file["friction_force"][:].tolist()}
    for format, (facts, scene) in told.items():
        for name, value in decided.items():
            check(str(facts.get(name)) == str(value), f"{format}: {name} is {facts.get(name)}, not {value}")
        for name, value in of_scene.items():
            check(str(scene.get(name)) == str(value), f"{format}: {name} is {scene.get(name)}, not {value}")
        check(str(facts["export_version"]) == "1" and str(facts["rate_Hz"]) == "1000", f"{format}: {facts}")
        check(all(str(facts[name]).endswith(".") for name in sentences), f"{format}: lacks a sentence")
    software = json.load(open(folder / "rubbed_motion.json", encoding="utf-8"))["SoftwareVersions"]
    check(all(f"{name} {value}" in software for name, value in decided.items()), f"motion-bids: {software}")
    frame = open(folder / "rubbed_channels.json", encoding="utf-8").read()
    check(all(word in frame for word in ("quaternion", "tool's origin", "the stiffness times")), f"motion-bids: {frame}")

    # friction: the coupling's force across the pushes; never beyond the cone, and on it while the tool slides
    truth = from_rows(recording)
    wanted, shares = [], []
    for device, proxy, contacts in zip(truth["device"], truth["proxy"], truth["contacts"]):
        force = 900.0 * (numpy.array(proxy[:3]) - numpy.array(device[:3]))
        pushes = sum((contact[6] * numpy.array(contact[3:6]) for contact in contacts), numpy.zeros(3))
        size = float(numpy.linalg.norm(pushes))
        along = float(force @ pushes) / size if size > 0 else 0.0
        wanted.append((force - along * pushes / size).tolist() if size > 0 else [0.0] * 3)
        if along > 0.5:
            shares.append(math.hypot(*wanted[-1]) / along)
    names = ["friction_force_" + axis for axis in AXES]
    with open(folder / "rubbed.csv", encoding="utf-8", newline="") as file:
        numbers["csv"] = [[float(row[name]) for name in names] for row in csv.DictReader(file)]
    numbers["mcap"] = [[m["friction_force"][a] for a in AXES] for _, m in logged["topics"]["/wrench"]]
    for format, read in numbers.items():
        check(len(read) == len(wanted) and max(abs(a - b) for ours, theirs in zip(read, wanted)
                                               for a, b in zip(ours, theirs)) < 1e-4, f"{format}: friction")
    check(len(shares) > 1000, f"{len(shares)} steps in contact")
    shares.sort()
    check(shares[-1] < 0.305 and abs(shares[len(shares) * 9 // 10] - 0.3) < 0.003,
          f"friction over push: {shares[-1]} at most, mostly {shares[len(shares) * 9 // 10]}; not 0.3")

    # the quaternion turns the tool into the scan: each contact is at one of the tool's points
    cli("tool", "hook", "--out", folder / "points.csv")
    points = numpy.genfromtxt(folder / "points.csv", delimiter=",", skip_header=1)
    furthest = 0.0
    for proxy, contacts in list(zip(truth["proxy"], truth["contacts"]))[::20]:
        w, v = proxy[3], numpy.array(proxy[4:7])
        for contact in contacts:
            turned = points + 2 * w * numpy.cross(v, points) + 2 * numpy.cross(v, numpy.cross(v, points))
            furthest = max(furthest, numpy.linalg.norm(turned - numpy.array(contact[:3]), axis=1).min())
    check(furthest < 1e-6, f"a contact is {furthest} m from the tool's points")


def has_no_date(folder, recording):
    """Made again later, it is the same to the byte."""
    before = {f: open(f, "rb").read() for format, (ending, _) in FORMATS.items()
              for f in whole(format, folder / f"whole{ending}")}
    time.sleep(1.1)
    for format, (ending, _) in FORMATS.items():
        export(recording, format, folder / f"whole{ending}")
    for f, content in before.items():
        check(open(f, "rb").read() == content, f"{f} is another one each time")


def chooses(folder, recording, truth):
    times = truth["time"]
    for begin, end, rate in ((None, None, 100), (None, None, 30), (0.5, 1.0, None), (1.25, None, 7),
                             (0.0995, 0.1005, None), (None, 0.7, 999), (None, None, 50000)):
        words = [w for option, value in (("--from", begin), ("--to", end), ("--rate", rate))
                 if value is not None for w in (option, value)]
        first, last = (begin or 0) * 1e9, (end if end is not None else 1e9) * 1e9
        inside = [i for i, t in enumerate(times) if first <= t <= last]
        chosen = inside
        if rate:
            chosen, least, most = [], max(first, 0), min(last, times[-1])
            for n in range(math.ceil(least * rate / 1e9 - 1e-9), math.floor(most * rate / 1e9) + 1):
                before = bisect.bisect_right(inside, round(n * 1e9 / rate), key=times.__getitem__)
                if before and inside[before - 1] not in chosen[-1:]:
                    chosen.append(inside[before - 1])
        events = [e for e in truth["events"] if first <= e[0] <= last]
        for format, (ending, read) in FORMATS.items():
            out = folder / f"chosen{ending}"
            said = export(recording, format, out, *words)
            check(said["steps"] == len(chosen) > 0 and said["events"] == len(events),
                  f"{format} {words}: {said} in place of {len(chosen)}, {len(events)}")
            found = read(out)
            compare(f"{format} {words}", found, truth, chosen)
            check([e[0] for e in found["events"]] == [e[0] for e in events], f"{format} events")
    for format, (ending, read) in FORMATS.items():
        out = folder / f"without{ending}"
        said = export(recording, format, out, "--no-contacts")
        check(not any("contacts" in f for f in said["files"]), f"{format}: a file of contacts")
        compare(format + " --no-contacts", read(out), truth, contacts=False)


def left_in(folder):
    return sorted(p.name for p in folder.iterdir())


def refuses(folder, recording):
    other = folder / "refused"
    other.mkdir()
    (other / "file").write_text("in the way")
    (other / "folder.h5").mkdir()
    (other / "folder.mcap").mkdir()
    (other / "folder.csv").mkdir()
    (other / "folder_motion.tsv").mkdir()
    for format, (ending, _) in {**FORMATS, "csv": (".csv", None)}.items():
        for out in (other / f"no-folder/x{ending}", other / f"file/x{ending}",
                    other / f"folder{ending}"):
            export(recording, format, out, expect=4)
        # an old one stays, whatever becomes of the new one
        out = other / f"old{ending}"
        old = whole(format, out)
        for f in old:
            pathlib.Path(f).write_text("old")
        export(recording, format, out, "--from", 100, expect=3)
        check(all(pathlib.Path(f).read_text() == "old" for f in old), f"{format}: the old is gone")

        def limited(most):
            def limit():
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
            return limit
        # no room: at once, in the middle, near the end
        bytes = max(os.path.getsize(f) for f in whole(format, folder / f"whole{ending}"))
        for most in (100, bytes // 2, bytes - 200):
            export(recording, format, out, expect=4, preexec_fn=limited(most))
        check(all(pathlib.Path(f).read_text() == "old" for f in old), f"{format}: the old is gone")
        export(recording, format, out)
        check(all(pathlib.Path(f).stat().st_size > 100 for f in old), f"{format}: the old stays")
        for f in old:
            os.remove(f)
    export(recording, "motion-bids", str(other) + "/", expect=4)
    export(recording, "csv", other / "x.tsv", expect=2)
    check(left_in(other) == ["file", "folder.csv", "folder.h5", "folder.mcap", "folder_motion.tsv"],
          f"left behind: {left_in(other)}")

    # what is no recording, or one that is broken
    content = recording.read_bytes()
    (other / "text.palpate").write_text("a letter\n" * 1000)
    (other / "empty.palpate").write_bytes(b"")
    (other / "cut.palpate").write_bytes(content[:len(content) // 2])
    foreign = sqlite3.connect(other / "foreign.palpate")
    foreign.execute("CREATE TABLE step (first INTEGER)")
    foreign.commit()
    foreign.close()
    (other / "part.palpate.part").write_bytes(content)
    (other / "block.palpate").write_bytes(content)
    block = sqlite3.connect(other / "block.palpate")
    block.execute("UPDATE step SET data = randomblob(length(data)) WHERE first > 1000")
    block.commit()
    block.close()
    randomly = random.Random(7)
    noisy = bytearray(content)
    for _ in range(400):
        noisy[randomly.randrange(20_000, len(noisy))] ^= 1 << randomly.randrange(8)
    (other / "noisy.palpate").write_bytes(noisy)
    there = left_in(other)
    for name in [n for n in there if ".palpate" in n] + ["absent.palpate", "folder.h5"]:
        for format, (ending, _) in FORMATS.items():
            export(other / name, format, other / f"out{ending}", expect=3)
    check(left_in(other) == there, f"left behind: {left_in(other)}")

    for words in (["--format", "xml"], ["--rate", 0], ["--rate", "nan"], ["--from", "x"],
                  ["--from", 2, "--to", 1], ["--out", folder / "x.txt"]):
        line = {"--format": "hdf5", "--out": folder / "x.h5",
                **dict(zip(words[::2], words[1::2]))}
        cli("export", recording, *[w for pair in line.items() for w in pair], expect=2)


def names_no_file(folder):
    """A tool of the user's own, whose name is nobody's business."""
    secret = folder / "Mustermann-Erika"
    secret.mkdir()
    cli("tool", "probe", "--out", secret / "Praxis-Nord.csv")
    recording = record(secret, "Sitzung-Erika", 0.5, tool=secret / "Praxis-Nord.csv")
    for format, (ending, _) in FORMATS.items():
        for name in export(recording, format, folder / f"nameless{ending}")["files"]:
            content = open(name, "rb").read()
            for word in (b"Mustermann", b"Praxis", b"Sitzung", b"Erika", str(folder).encode(),
                         os.uname().nodename.encode()):
                check(len(word) < 4 or word not in content, f"{name} holds {word}")


def stays_small(folder):
    short, long = record(folder, "six", 6), record(folder, "sixty", 60)
    cancelled = 0
    for format, (ending, _) in FORMATS.items():
        peaks = []
        for recording in (short, long):
            # from a process that is small itself: a child begins with its parent's peak
            peaks.append(int(subprocess.run(
                [sys.executable, "-S", "-c", PEAK, CLI, "export", recording, "--format", format,
                 "--out", folder / f"size{ending}"], capture_output=True, check=True).stdout))
        print(f"{format}: peak {peaks[0]} kB for 6 s, {peaks[1]} kB for 60 s", flush=True)
        check(peaks[1] < peaks[0] + GREATEST_GROWTH_KB, f"{format}: memory grows: {peaks} kB")

        # and it can be stopped on the way
        place = folder / f"stopped-{format}"
        place.mkdir()
        child = subprocess.Popen([CLI, "export", long, "--format", format, "--out",
                                  place / f"x{ending}"], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL)
        while child.poll() is None and not left_in(place):
            time.sleep(0.001)
        child.send_signal(signal.SIGINT)
        code = child.wait(300)
        cancelled += code == 130
        check(code in (0, 130), f"{format}: stopped with {code}")
        check(code == 0 or left_in(place) == [], f"{format}: left behind {left_in(place)}")
    check(cancelled > 0, "no export was still going on when it was stopped")


def keeps_the_rate(folder):
    """Four times the steps, each a quarter of a millisecond: in every export, and again to the bit.
    Bytes of a second: at most twice those at 1 kHz."""
    fast = folder / "fast.palpate"
    run = ("run", "--phantom", "sphere", "--isovalue", 0, "--tool", "probe", "--hand", "slide",
           "--seconds", 1, "--stiffness", 1000)
    said = cli(*run, "--rate", 4000, "--record", fast, "--trace", folder / "fast.csv")
    check(said["ticks"] == 4000 and said["max_penetration_mm"] == 0.0, f"at 4 kHz: {said}")
    check(said["recording"]["steps"] == 4000, f"steps at 4 kHz: {said['recording']}")
    truth = from_rows(fast)
    steps = truth["time"]
    check([b - a for a, b in zip(steps, steps[1:])] == [250_000] * 3999, "the times of the steps")
    # what went in is exact, what came out is rounded
    with open(folder / "fast.csv") as trace:
        lines = [list(map(float, line)) for line in list(csv.reader(trace))[1:]]
    same("device at 4 kHz", truth["device"], [line[1:8] for line in lines])
    for name, begin, halves in (("proxy", 8, [0.5e-9] * 3 + [0.5e-8] * 4), ("force", 15, [0.5e-6] * 3),
                                ("torque", 18, [0.5e-7] * 3)):
        off = max(abs(a - b) / half for row, line in zip(truth[name], lines)
                  for a, b, half in zip(row, line[begin:], halves))
        check(0.9 < off < 1.000001, f"{name} at 4 kHz is off by {off} of half its rounding")
    check([len(c) for c in truth["contacts"]] == [int(line[21]) for line in lines], "contacts at 4 kHz")
    for format, (ending, read) in FORMATS.items():
        said = export(fast, format, folder / f"fast{ending}")
        check(said["steps"] == 4000, f"{format} at 4 kHz: {said}")
        compare(f"{format} at 4 kHz", read(folder / f"fast{ending}"), truth)
    facts = json.load(open(folder / "fast_motion.json", encoding="utf-8"))
    check(facts["SamplingFrequency"] == 4000.0 and
          abs(facts["SamplingFrequencyEffective"] - 4000.0) < 1e-6, f"the rate: {facts}")
    again = cli("replay", fast, "--phantom", "sphere")
    check(again["steps"] == 4000 and again["differing"] == 0, f"replayed: {again}")
    slow = cli(*run, "--record", folder / "slow.palpate")
    grown = bytes_of_steps(fast) / bytes_of_steps(folder / "slow.palpate")
    check(slow["ticks"] == 1000 and 1.0 < grown <= 2.0, f"at 4 kHz a second has {grown} times the bytes")
    cli(*run, "--rate", 3000, expect=2)
    cli(*run, "--rate", 4000, "--device", "falcon", expect=2)
    cli(*run, "--rate", 4000, "--device", "omega.6")


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        recording, truth = holds_the_trace(folder)
        says_what_decided(folder)
        export(recording, "mcap", folder / "short.mcap", "--from", 0.5, "--to", 0.6)
        missed = read_mcap.changes_missed(folder / "short.mcap", folder / "changed.mcap")
        check(missed == [], f"the reader of MCAP misses changed bytes at {missed}")
        is_one_table(folder, recording, truth)
        holds_distances(folder)
        is_a_drilling_recording(folder)
        has_no_date(folder, recording)
        chooses(folder, recording, truth)
        refuses(folder, recording)
        names_no_file(folder)
        keeps_the_rate(folder)
        stays_small(folder)
    return outcome()


if __name__ == "__main__":
    sys.exit(main())
