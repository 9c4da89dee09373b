#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Recordings as a user of the command line meets them: made, replayed, over another volume,
interrupted, killed, without room, and recovered.

Use: recordings_test.py PALPATE-CLI FOLDER SESSIONS
"""
import contextlib
import json
import os
import pathlib
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import time

program, folder, sessions = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
environment = dict(os.environ, HOME=str(folder / "home"), XDG_DATA_HOME=str(folder / "home/data"))


def call(*arguments, code=0, **more):
    done = subprocess.run([program, *map(str, arguments), "--json"], capture_output=True, text=True,
                          env=environment, **more)
    assert done.returncode == code, (arguments, done.returncode, done.stdout, done.stderr)
    return json.loads(done.stdout)


def touch(seconds, *more):
    return ("run", "--volume", folder / "ball.nrrd", "--isovalue", "1000", "--tool", "probe", "--hand",
            "slide", "--stiffness", "1000", "--seconds", seconds, *more)


call("convert", "--phantom", "sphere", folder / "ball.nrrd")
r = folder / "r.palpate"

# made, twice the same path, replayed to the bit
made = call(*touch(40, "--friction", "0.3", "--record", r))["recording"]
assert made["steps"] == 40000 and made["lost"] == 0 and made["bytes_per_step"] <= 300, made
said = call("replay", r, "--volume", folder / "ball.nrrd")
assert said["steps"] == 40000 and said["differing"] == 0 and said["skipped"] == 0, said
assert said["volume"] == "same" and said["same_build"], said
# the window has another build than this program; of one installation they have version and commit
windows = folder / "window.palpate"
shutil.copy(r, windows)
with sqlite3.connect(windows) as database:
    database.execute("UPDATE meta SET value = 'the window''s' WHERE key = 'build'")
    about = json.loads(database.execute("SELECT value FROM meta WHERE key = 'about'").fetchone()[0])
known = "-" not in about["commit"] and about["commit"] != "unknown"
assert call("replay", windows, "--volume", folder / "ball.nrrd")["same_build"] == known, about
with sqlite3.connect(windows) as database:
    database.execute("UPDATE meta SET value = ? WHERE key = 'about'", (json.dumps(about | {"commit": "0" * 12}),))
assert not call("replay", windows, "--volume", folder / "ball.nrrd")["same_build"], about
# it is no scan, and who asks hears that
done = subprocess.run([program, "info", str(r)], capture_output=True, text=True, env=environment)
assert done.returncode == 3 and "is a recording" in done.stderr, done
# through the limits of a device, its ramp included
call(*touch(2, "--device", "falcon", "--record", r))
said = call("replay", r, "--volume", folder / "ball.nrrd")
assert said["differing"] == 0, said

# another volume: by its voxels, and by its geometry
whole = (folder / "ball.nrrd").read_bytes()
head = whole.index(b"\n\n") + 2
size = (len(whole) - head) // 1000
voxels = bytearray(whole)
for k in range(head + len(whole) // 3, head + len(whole) // 3 + 4 * size):
    voxels[k] ^= 1
(folder / "other.nrrd").write_bytes(voxels)
said = call("replay", r, "--volume", folder / "other.nrrd", code=4)
assert said["volume"] == "another" and "not the one" in said["error"]["message"], said
# also where the hand never came: nothing differs, and it is another all the same
voxels = bytearray(whole)
voxels[-1] ^= 1
(folder / "corner.nrrd").write_bytes(voxels)
said = call("replay", r, "--volume", folder / "corner.nrrd", code=4)
assert said["volume"] == "another" and said["differing"] == 0, said
assert "not the one" in said["error"]["message"], said
said = call("replay", r, "--phantom", "torus", code=4)
assert said["volume"] == "another" and "another-volume" in said["reasons"], said
assert "not the one" in said["error"]["message"], said
call("replay", r, code=2)
call("replay", folder / "none.palpate", "--phantom", "sphere", code=3)
# of another installation nobody can tell
stranger = dict(environment, XDG_DATA_HOME=str(folder / "stranger"), HOME=str(folder / "stranger"))
done = subprocess.run([program, "replay", r, "--volume", folder / "ball.nrrd", "--json"],
                      capture_output=True, text=True, env=stranger)
assert json.loads(done.stdout)["differing"] == 0, done
assert json.loads(done.stdout)["volume"] == "unknown", done

# what earlier builds felt is what this one feels (sessions/README.md)
if " fma " in pathlib.Path("/proc/cpuinfo").read_text():
    kept = sorted(sessions.glob("*.palpate"))
    assert len(kept) == 4, kept
    for session in kept:
        said = call("replay", session, "--phantom", session.stem.split("-")[0])
        assert said["steps"] == 1600 and said["skipped"] == said["differing"] == 0, (session, said)

    # of an edited volume: the hand felt the edits, and other voxels than were felt are told
    cut = sessions / "sphere-cut.palpate"
    stored = {}
    for name, change in {
            "whole": lambda words: (words.pop("edits"), words.pop("edits_digest")),
            "other": lambda words: words.update(edits_digest="%x" % (int(words["edits_digest"], 16) ^ 1)),
            "damaged": lambda words: words["edits"][0].update(more=1)}.items():
        stored[name] = folder / f"{name}.palpate"
        shutil.copyfile(cut, stored[name])
        with contextlib.closing(sqlite3.connect(stored[name])) as file, file:
            words = json.loads(file.execute("SELECT volume FROM scene").fetchone()[0])
            assert [edit["edit"] for edit in words["edits"]] == ["plane", "lasso", "crop"], words
            change(words)
            file.execute("UPDATE scene SET volume = ?", (json.dumps(words),))
    said = call("replay", stored["whole"], "--phantom", "sphere", code=4)
    assert said["differing"] > 400, said
    said = call("replay", stored["other"], "--phantom", "sphere", code=4)
    assert said["reasons"] == ["other-edits"] and "differing" not in said, said
    print(said["error"]["message"])
    call("replay", stored["damaged"], "--phantom", "sphere", code=3)

    # the first recordings said no rate: all were at 1 kHz
    early = folder / "early.palpate"
    shutil.copyfile(sessions / "demo-pry.palpate", early)
    with contextlib.closing(sqlite3.connect(early)) as file, file:
        rows = file.execute("SELECT id, text FROM event WHERE kind = 'start'").fetchall()
        for row, text in rows:
            words = json.loads(text)
            assert words.pop("rate") == 1000, words
            file.execute("UPDATE event SET text = ? WHERE id = ?", (json.dumps(words), row))
    said = call("replay", early, "--phantom", "demo")
    assert rows and said["steps"] == 1600 and said["skipped"] == said["differing"] == 0, said
else:
    print("SKIPPED: the kept sessions, which want a processor with fused multiplication")

# interrupted: what was run until then is a whole recording
i = folder / "i.palpate"
running = subprocess.Popen([program, *map(str, touch(600, "--record", i))], env=environment,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE)
while running.poll() is None and not i.with_suffix(".palpate.part").exists():
    time.sleep(0.01)
time.sleep(1)
running.send_signal(signal.SIGINT)
running.communicate(timeout=900)
assert running.returncode == 130 and i.exists(), running
said = call("replay", i, "--volume", folder / "ball.nrrd")
assert said["steps"] > 500 and said["differing"] == 0, said

# killed: nothing takes its place until it is recovered
k = folder / "k.palpate"
part = folder / "k.palpate.part"
running = subprocess.Popen([program, *map(str, touch(600, "--record", k))], env=environment,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE)
while running.poll() is None and not part.exists():
    time.sleep(0.01)
time.sleep(1.5)
running.kill()
running.communicate()
assert part.exists() and not k.exists()
# copied without what lies beside it, it says so
(folder / "copied").mkdir()
alone = folder / "copied" / "k.palpate.part"
shutil.copy(part, alone)
said = subprocess.run([program, "recover", str(alone)], capture_output=True, text=True, env=environment)
assert said.returncode == 3 and "k.palpate.part-wal" in said.stderr, said
left = max(file.stat().st_mtime for file in (part, folder / "k.palpate.part-wal"))
time.sleep(1.1)
call("replay", part, "--phantom", "sphere", code=3)
call("export", part, "--format", "csv", "--out", folder / "x.csv", code=3)
call(*touch(1, "--record", k), code=4)
said = call("recover", part)
assert said["steps"] > 500 and said["lost"] == 0 and not part.exists(), said
assert abs(k.stat().st_mtime - left) < 0.01  # its date is when it was recorded
said = call("replay", k, "--volume", folder / "ball.nrrd")
assert said["differing"] == 0, said
call("recover", part, code=3)

# no room: the run goes on, and what was written before is there
f = folder / "f.palpate"
done = subprocess.run(
    [program, *map(str, touch(20, "--record", f))], capture_output=True, text=True, env=environment,
    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2_500_000, 2_500_000)))
assert done.returncode == 4 and "recording stopped" in done.stderr, done
assert "ticks: 20000" in done.stdout, done
said = call("recover", folder / "f.palpate.part")
assert 0 < said["steps"] < 20000, said
call("replay", f, "--volume", folder / "ball.nrrd")

# not even for the first of it: then nothing is left. The limit holds for the memory of the voxels,
# too, so there are fewer of them.
lines = whole[:head].replace(b"sizes: 64 64 64", b"sizes: 32 32 32")
lines = lines.replace(b"(1,0,0) (0,1,0) (0,0,1)", b"(2,0,0) (0,2,0) (0,0,2)")
assert len(whole) - head == 2 * 64**3, len(whole)
halves = b"".join(whole[head + 2 * at:head + 2 * at + 2] for at in
                  (64 * (64 * k + j) + i for k in range(0, 64, 2) for j in range(0, 64, 2)
                   for i in range(0, 64, 2)))
(folder / "ball.nrrd").write_bytes(lines + halves)
done = subprocess.run(
    [program, *map(str, touch(1, "--record", f.with_name("g.palpate")))], capture_output=True,
    text=True, env=environment,
    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (150_000, 150_000)))
assert done.returncode == 4 and "Nothing was recorded" in done.stderr, done
assert not list(folder.glob("g.palpate*")), list(folder.iterdir())

# what cannot be written is told before anything is run
call(*touch(1, "--record", "/proc/r.palpate"), code=4)
call(*touch(1, "--record", folder), code=4)
shutil.rmtree(folder)
print("made, replayed, interrupted, killed, filled and recovered")
