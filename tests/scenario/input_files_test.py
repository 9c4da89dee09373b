#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tools and hands from CSV files, and a folder for temporary files that is none: what is meant is
done, and what would be lost or guessed is refused. Files that were made to hurt (tests/cases/hostile), and
pipes, folders, devices, links to themselves and files without end where a file belongs: each ends with a
sentence, within limits of time and memory that the system enforces.

Usage: input_files_test.py PALPATE_CLI FOLDER
"""
import os
import pathlib
import resource
import shutil
import sqlite3
import struct
import subprocess
import sys
import zipfile


HOSTILE = pathlib.Path(__file__).resolve().parents[1] / "cases" / "hostile"
SECONDS, BYTES = 20, 700_000_000  # of a processor, of memory that may be written; some need 5 s to unpack 1 GiB


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_DATA, (BYTES, BYTES))


def make(kind, path):
    """Something other than a plain file at a path."""
    if path.is_symlink() or path.exists():
        shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "device":
        path.symlink_to("/dev/zero")
    elif kind == "circle":
        path.symlink_to(path.name)
    elif kind == "sparse":
        with open(path, "wb") as file:
            file.truncate(1 << 40)


def repeated_pages(recording, page_of):
    """Makes an inner page of a table point to one inner page again and again, five deep: 1e13 rows in a small file."""
    content = bytearray(recording)
    size = struct.unpack(">H", content[16:18])[0]
    size = 65536 if size == 1 else size
    count = len(content) // size
    leaf = content[(page_of - 1) * size:page_of * size]
    cells = 400

    def inner(child):
        page = bytearray(size)
        places = [size - 8 * (n + 1) for n in range(cells)]
        page[0:12] = struct.pack(">BHHHBI", 5, 0, cells, places[-1], 0, child)
        for n, place in enumerate(places):
            page[12 + 2 * n:14 + 2 * n] = struct.pack(">H", place)
            page[place:place + 6] = struct.pack(">I", child) + bytes((0x80 | (n + 1) >> 7, (n + 1) & 0x7f))
        return page

    levels = 5
    content += leaf  # page count + 1
    child = count + 1
    for _ in range(levels):
        content += inner(child)
        child = len(content) // size
    content[(page_of - 1) * size:page_of * size] = inner(child)
    content[28:32] = struct.pack(">I", len(content) // size)  # its size, as the file states it
    return bytes(content)


def main():
    cli, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    faults = []

    def expect(code, words, *arguments, environment=None, limit=None):
        try:
            done = subprocess.run([cli, *map(str, arguments)], capture_output=True, text=True, preexec_fn=limit,
                                  stdin=subprocess.DEVNULL, env={**os.environ, **(environment or {})}, timeout=300)
        except subprocess.TimeoutExpired:
            faults.append(f"{arguments}: waits, as for a pipe that nobody writes")
            return
        said = done.stdout + done.stderr
        if done.returncode != code or words not in said:
            faults.append(f"{arguments}: exit {done.returncode}, not {code}, or no \"{words}\": {said}")

    def write(name, text):
        (folder / name).write_text(text)
        return folder / name

    out = folder / "out.csv"
    sound = write("sound.csv", "x,y,z\n0,0,0\n0,0,0.1\n")
    expect(0, "", "tool", sound, "--out", out)
    expect(0, "", "tool", write("SOUND.Csv", sound.read_text()), "--out", out)
    expect(0, "", "convert", "--phantom", "sphere", folder / "OUT.NRRD")
    expect(2, "must end in .nrrd", "convert", "--phantom", "sphere", folder / "out.raw")
    expect(2, "leave out --points", "tool", sound, "--points", 5, "--out", out)
    expect(2, "leave out --tool-unit", "tool", sound, "--tool-unit", "mm", "--out", out)
    expect(3, "first line", "tool", write("bare.csv", "0,0,0\n0,0,0.1\n"), "--out", out)
    expect(3, "10 m", "tool", write("far.csv", "x,y,z\n0,0,0\n1e155,0,0\n"), "--out", out)
    expect(0, "unusual", "tool", write("long.csv", "x,y,z\n0,0,0\n1,0,0\n"), "--out", out, "--json")
    expect(3, "in line 2", "tool", write("comma.csv", "x;y;z\n0,5;0;0\n"), "--out", out)

    run = ["run", "--phantom", "sphere", "--isovalue", 1000, "--tool", "probe", "--seconds", 0.01,
           "--stiffness", 500, "--hand"]
    pose = "0,0,0,0.03,1,0,0,0\n1,0,0,0.02,1,0,0,0\n"
    names = "t,x,y,z,w,i,j,k\n"
    expect(0, "", *run, write("hand.csv", names + pose))
    expect(3, "first line", *run, write("bare_hand.csv", pose))
    expect(3, "100 m", *run, write("far_hand.csv", names + pose + "2,0,1e155,0,1,0,0,0\n"))

    archive = folder / "study.zip"
    with zipfile.ZipFile(archive, "w") as packed:
        packed.writestr("a", "nothing")
    expect(3, "temporary files", "info", archive, environment={"TMPDIR": "/nonexistent"})

    # files that were made to hurt
    touch = ["--isovalue", 1000, "--tool", "probe", "--hand", "tap", "--stiffness", 500, "--seconds", 0.01]
    for name, words in (("spacing_comma.nrrd", '"spacings"'), ("list.nhdr", "64 bytes that"), ("bzip2_lie.nrrd", "voxels"),
                        ("skipped_body.tar.gz", "too"), ("dicom_one_slice_without_rescale", "no rescale slope"),
                        ("dicom_intercept_twice", "(0028,1052) twice"), ("dicom_float_pixels", "floating-point")):
        expect(3, words, "info", HOSTILE / name, limit=limited)
        expect(3, words, "run", "--volume", HOSTILE / name, *touch, limit=limited)
    expect(0, "spacing_mm: [0.5,0.5,2.5]", "info", HOSTILE / "space_time.nrrd", limit=limited)
    for name, words in (("deep_edits", "damaged"), ("generated_texts", "no recording of Palpate")):
        recording = HOSTILE / f"{name}.palpate"
        expect(3, words, "replay", recording, "--phantom", "sphere", limit=limited)
        expect(3, words, "export", recording, "--format", "csv", "--out", folder / "x.csv", limit=limited)
        expect(3, words, "export", recording, "--format", "video", "--out", folder / "x.mp4", limit=limited)
    expect(3, "in line 2", "tool", HOSTILE / "comma_points.csv", "--out", out, limit=limited)
    expect(3, "as a mesh", "tool", HOSTILE / "no_z.ply", "--out", out, limit=limited)
    expect(0, "triangles: 1", "tool", HOSTILE / "long_line.ply", "--out", out, limit=limited)

    # a recording whose pages lead to each other
    session = folder / "session.palpate"
    session.unlink(missing_ok=True)
    expect(0, "", "run", "--phantom", "sphere", *touch, "--record", session)
    # (that of the steps is sought by its numbers, which lead to its one leaf whatever lies between: what is read is right)
    for table in ("step_times", "event", "scene", "meta"):
        with sqlite3.connect(session) as file:
            page = file.execute("SELECT rootpage FROM sqlite_schema WHERE name = ?", (table,)).fetchone()[0]
        circle = folder / f"{table}.palpate"
        circle.write_bytes(repeated_pages(session.read_bytes(), page))
        expect(3, "damaged", "replay", circle, "--phantom", "sphere", limit=limited)

    # what is no plain file, where one belongs
    place = folder / "place"
    labelled = folder / "labelled.nrrd"
    expect(0, "", "convert", "--phantom", "sphere", labelled)
    manifest = ["cohort", place, folder / "cohort-out", "--isovalue", 1000]
    for kind in ("pipe", "folder", "device", "circle", "sparse"):
        for ending, commands in ((".csv", (["tool", place, "--out", out], [*run, place])),
                                 (".stl", (["tool", place, "--out", out],)), (".ply", (["tool", place, "--out", out],)),
                                 (".obj", (["tool", place, "--out", out],)), (".tsv", (manifest,)),
                                 (".nrrd", (["info", place], ["info", labelled, "--labels", place])), (".mha", (["info", place],)), (".nii", (["info", place],)),
                                 (".dcm", (["info", place],)), (".zip", (["info", place],)),
                                 (".palpate", (["replay", place, "--phantom", "sphere"],
                                               ["export", place, "--format", "csv", "--out", folder / "x.csv"])),
                                 (".palpate.part", (["recover", place],))):
            named = place.with_name("place" + ending)
            make(kind, named)
            for command in commands:
                if kind == "folder" and ending == ".tsv":
                    continue  # a dataset
                expect(3, "place", *[named if word is place else word for word in command], limit=limited)
        # the key of the installation: a recording is made without it, and says so
        data = folder / "data"
        (data / "Palpate" / "Palpate").mkdir(parents=True, exist_ok=True)
        make(kind, data / "Palpate" / "Palpate" / "installation.key")
        session.unlink(missing_ok=True)
        expect(0, "", "run", "--phantom", "sphere", *touch, "--record", session, limit=limited,
               environment={"XDG_DATA_HOME": str(data)})

    # what is read is not written over, whatever leads to it
    scan = folder / "scan.nrrd"
    expect(0, "", "convert", "--phantom", "sphere", scan)
    before = scan.read_bytes()
    table = folder / "manifest.tsv"
    table.write_text("path\tlabel\tisovalue\nscan.nrrd\tone\t1000\n")
    for target, names in ((table, ("group_scans.tsv", "index.html")), (scan, ("pictures/one_axial.bmp", "index.html"))):
        for name in names:
            results = folder / "results"
            shutil.rmtree(results, ignore_errors=True)
            (results / name).parent.mkdir(parents=True)
            (results / name).symlink_to(target)
            subprocess.run([cli, "cohort", table, results, "--tool", "probe", "--hand", "tap", "--repetitions", "1",
                            "--seconds", "0.05"], capture_output=True, stdin=subprocess.DEVNULL)
            if scan.read_bytes() != before or not table.read_text().startswith("path"):
                faults.append(f"a cohort has written over {target} by {name}")

    print("\n".join(faults) or "as it should be")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
