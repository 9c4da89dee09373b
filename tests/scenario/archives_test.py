#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `palpate-cli info` makes of archives: a series in each form, and what must be refused.

Usage: archives_test.py PALPATE_CLI

Whatever happens, nothing stays in the folder for temporary files.
"""
import bz2
import gzip
import io
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "support"))

from dicom_slices import Head, Person, Series  # noqa: E402

MOST_S = 20.0  # of CPU


def cpu_seconds():
    """Of the processes that have ended: a busy machine does not count."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def info(cli, path, temporary):
    began = cpu_seconds()
    done = subprocess.run([cli, "info", str(path), "--json"], capture_output=True, timeout=900,
                          env={**os.environ, "TMPDIR": str(temporary)})
    said = json.loads(done.stdout)
    return said, done.returncode, cpu_seconds() - began


def without_names(said):
    return {key: value for key, value in said.items() if key not in ("message", "series")}


def archives(series, to):
    """The series as each kind of archive, in folders of its own."""
    files = sorted(series.iterdir())
    with zipfile.ZipFile(to / "a.zip", "w", zipfile.ZIP_DEFLATED, compresslevel=1) as out:
        out.writestr("AUTORUN.INF", "[autorun]\r\n")
        for n, file in enumerate(files):
            # any language, and a name of ours
            out.write(file, f"Müller_Jürgen/山田 {n % 3}/{file.name}")
        out.writestr("in-use", "")
    yield to / "a.zip"
    for name, mode in (("a.tar", "w"), ("a.tar.gz", "w:gz"), ("a.tar.xz", "w:xz"),
                       ("a.tar.bz2", "w:bz2")):
        # one slice in every other, and links that must not be followed
        with tarfile.open(to / name, mode, **({"preset": 0} if mode == "w:xz" else {})) as out:
            for file in files:
                out.add(file, f"./study/{file.name}")
            link = tarfile.TarInfo("study/passwd")
            link.type, link.linkname = tarfile.SYMTYPE, "/etc/passwd"
            out.addfile(link)
        yield to / name
    # their names do not matter
    for name, copy in (("a.tar.gz", "A.TGZ"), ("a.zip", "A.ZIP"), ("a.tar.gz", "study"), ("a.tar.xz", "study.dat")):
        yield pathlib.Path(shutil.copy(to / name, to / copy))


def broken(series, to):
    """Archives that must be refused, with the reason."""
    file = sorted(series.iterdir())[0]
    whole = (to / "a.zip").read_bytes()
    (to / "cut.zip").write_bytes(whole[:len(whole) // 2])
    yield to / "cut.zip", "truncated"
    with zipfile.ZipFile(to / "up.zip", "w") as out:
        out.write(file, "study/../../slice.dcm")
    yield to / "up.zip", "outside-folder"
    with zipfile.ZipFile(to / "deep.zip", "w") as out:
        out.write(file, "d/" * 40 + "slice.dcm")
    yield to / "deep.zip", "outside-folder"
    # the flag of a password, in the local and the central header
    with zipfile.ZipFile(to / "locked.zip", "w") as out:
        out.write(file, "slice.dcm")
    locked = bytearray((to / "locked.zip").read_bytes())
    locked[6] |= 1
    central = locked.rfind(b"PK\x01\x02")
    locked[central + 8] |= 1
    (to / "locked.zip").write_bytes(locked)
    yield to / "locked.zip", "unreadable"
    # 1.1 GB in 1 MB. A gzip file may consist of several streams, so one is written again and again
    zeros = tarfile.TarInfo("zeros.raw")
    zeros.size = 1100 << 20
    (to / "bomb.tar.gz").write_bytes(gzip.compress(zeros.tobuf()) + gzip.compress(bytes(1 << 20)) * 1100)
    yield to / "bomb.tar.gz", "too-large"
    # 200,001 entries
    entry = tarfile.TarInfo("empty").tobuf()
    (to / "many.tar.gz").write_bytes(gzip.compress(entry * 2000) * 100 + gzip.compress(entry + bytes(1024)))
    yield to / "many.tar.gz", "too-large"
    with zipfile.ZipFile(to / "letters.zip", "w") as out:
        out.writestr("letter.txt", "no scan")
    yield to / "letters.zip", "unreadable"
    (to / "empty.tar").write_bytes(b"")
    yield to / "empty.tar", "truncated"
    # what is no archive that is unpacked is called by its name
    for name, begins, kind in (("a.rar", b"Rar!\x1a\x07\x01\0", "RAR"), ("A.TGZ", b"Rar!\x1a\x07\0", "RAR"),
                               ("a.cab", b"MSCF\0\0\0\0", "CAB"), ("a.lzh", b"\x20\x20-lh5-", "LHA"),
                               ("letter.gz", gzip.compress(b"no scan"), "gzip"),
                               ("letter.bz2", bz2.compress(b"no scan"), "bzip2")):
        (to / name).write_bytes(begins + bytes(600))
        yield to / name, "unreadable", f"\"{name}\" is packed", kind
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w") as out:
        out.write(file, "slice.dcm")
    with zipfile.ZipFile(to / "nested.zip", "w") as out:
        out.writestr("inner.zip", inner.getvalue())
    yield to / "nested.zip", "unreadable"


def slow(series, path):
    """An archive of which the first slice is out long before the rest: noise, which takes bzip2 seconds."""
    file = sorted(series.iterdir())[0]
    first = tarfile.TarInfo("study/slice.dcm")
    first.size = file.stat().st_size
    block = random.Random(1).randbytes(1 << 19)
    rest = tarfile.TarInfo("study/noise.raw")
    rest.size = 128 * len(block)
    with path.open("wb") as out:
        out.write(bz2.compress(first.tobuf() + file.read_bytes() + bytes(-first.size % 512) + rest.tobuf()))
        out.write(bz2.compress(block) * 128)


def main():
    cli = sys.argv[1]
    wrong = []
    with tempfile.TemporaryDirectory() as place:
        temporary, made = pathlib.Path(place) / "temporary", pathlib.Path(place) / "made"
        temporary.mkdir()
        made.mkdir()
        series = Series(pathlib.Path(place) / "series", Head(), Person(), 16, 128).folder

        def check_empty(after):
            left = [p.name for p in temporary.iterdir()]
            if left:
                wrong.append(f"{after}: leaves {left}")
                shutil.rmtree(temporary / left[0])

        folder, _, _ = info(cli, series, temporary)
        for path in archives(series, made):
            said, code, _ = info(cli, path, temporary)
            if code != 0 or without_names(said) != without_names(folder):
                wrong.append(f"{path.name}: {code}, {without_names(said)}")
            check_empty(path.name)
        for path, reason, *words in broken(series, made):
            said, code, seconds = info(cli, path, temporary)
            told = said.get("reasons", [said.get("error", {}).get("code")])
            sentence = said.get("message") or said["error"]["message"]
            if code != 3 or told != [reason] or not sentence.endswith(".") or any(w not in sentence for w in words):
                wrong.append(f"{path.name}: {code}, {told}, not {reason}: {sentence}")
            if seconds > MOST_S:
                wrong.append(f"{path.name}: {seconds:.0f} s")
            check_empty(path.name)

        # what a killed process leaves is swept up by the next one, and what is in use is not
        env = {**os.environ, "TMPDIR": str(temporary)}
        slow(series, made / "slow.tar.bz2")
        child = subprocess.Popen([cli, "info", str(made / "slow.tar.bz2")], env=env,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while child.poll() is None and not list(temporary.rglob("study/*")):
            time.sleep(0.002)
        child.send_signal(signal.SIGSTOP)
        info(cli, made / "a.zip", temporary)
        if not list(temporary.iterdir()):
            wrong.append("a folder in use was swept away, or the archive was read too fast to see")
        child.send_signal(signal.SIGKILL)
        child.wait()
        if not list(temporary.iterdir()):
            wrong.append("nothing was left by the killed process: the check is void")
        info(cli, series, temporary)
        check_empty("a killed process")
    print("\n".join(wrong) or "Archives are what they must be.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
