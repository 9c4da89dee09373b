#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The window is killed, told to end, or loses its display while its user marks and cuts a scan. At most the last
second is lost, the next start offers the rest, and nothing of the patient is in what was kept.

The real program runs on a display of its own; keys and mouse are those of a keyboard and a mouse (XTest).

Use: journal_test.py PALPATE FOLDER [KILLS] [SEED]
Exit 77 (skipped) where XTest or Xvfb is absent.
"""
import atexit
import ctypes
import json
import os
import pathlib
import random
import shutil
import signal
import stat
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "scenario"))
import nobody_test as nobody  # noqa: E402  (it reads the same arguments, and empties the folder)

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
kills = int(sys.argv[3]) if len(sys.argv) > 3 else 4
seed = int(sys.argv[4]) if len(sys.argv) > 4 else random.randrange(10**6)
print(f"seed {seed}", flush=True)
chance = random.Random(seed)
LONG = 180  # s: far more than it takes on a machine that is busy
if shutil.which("Xvfb") is None:
    print("SKIPPED: xvfb is not installed (packaging/dependencies)")
    sys.exit(77)
try:
    X11, XTST = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
except OSError as error:
    print(f"SKIPPED: {error} (packaging/dependencies: at-spi2-core)")
    sys.exit(77)
X11.XOpenDisplay.restype = ctypes.c_void_p
X11.XDefaultRootWindow.restype = ctypes.c_ulong
X11.XStringToKeysym.restype = ctypes.c_ulong

home = folder / "PLNTHOME"
home.mkdir(parents=True)
data, state = home / "data", folder / "state"
# its own folder for temporary files: a scan in the system's is no recent place, and the build may lie there
(folder / "tmp").mkdir()
environment = dict(os.environ, TMPDIR=str(folder / "tmp"), HOME=str(home), XDG_CONFIG_HOME=str(home / "config"), XDG_DATA_HOME=str(data),
                   XDG_STATE_HOME=str(state), LC_ALL="C.UTF-8")
who = nobody.unmistakable()
words = nobody.planted + ["PLNT", "Jane", str(folder)]
scan = folder / "PLNTFOLDER_Jane"
scan.mkdir()
for k in range(nobody.N):
    (scan / f"PLNTFILE_{k}.dcm").write_bytes(nobody.slice_of(k, who))


running = []
atexit.register(lambda: [process.kill() for process in running if process.poll() is None])


class Display:
    """A display of its own, with a keyboard and a mouse."""

    def __init__(self):
        told, tells = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(tells), "-screen", "0", "1280x900x24", "-noreset"],
                                       pass_fds=[tells], stderr=subprocess.DEVNULL)
        running.insert(0, self.server)
        os.close(tells)
        with os.fdopen(told) as words:
            self.name = ":" + words.readline().strip()
        self.x = ctypes.c_void_p(X11.XOpenDisplay(self.name.encode()))

    def key(self, *names):
        """Keys that are held together."""
        codes = [X11.XKeysymToKeycode(self.x, ctypes.c_ulong(X11.XStringToKeysym(name.encode()))) for name in names]
        for code in codes:
            XTST.XTestFakeKeyEvent(self.x, code, 1, 0)
        for code in reversed(codes):
            XTST.XTestFakeKeyEvent(self.x, code, 0, 0)
        X11.XSync(self.x, 0)

    def button(self, down):
        XTST.XTestFakeButtonEvent(self.x, 1, down, 0)
        X11.XSync(self.x, 0)

    def move(self, x, y):
        XTST.XTestFakeMotionEvent(self.x, -1, x, y, 0)
        X11.XSync(self.x, 0)

    def click(self, x, y):
        self.move(x, y)
        self.button(1)
        self.button(0)

    def drag(self, pause, *places):
        """With a pause before each place: moves that come together count as the last of them."""
        self.move(*places[0])
        self.button(1)
        for place in places[1:]:
            time.sleep(pause)
            self.move(*place)
        time.sleep(pause)
        self.button(0)

    def focus(self):
        """Gives the keyboard to the window under the pointer, as a window manager does."""
        root, child = ctypes.c_ulong(X11.XDefaultRootWindow(self.x)), ctypes.c_ulong()
        number, mask, other = ctypes.c_int(), ctypes.c_uint(), ctypes.c_ulong()
        X11.XQueryPointer(self.x, root, ctypes.byref(other), ctypes.byref(child), ctypes.byref(number),
                          ctypes.byref(number), ctypes.byref(number), ctypes.byref(number), ctypes.byref(mask))
        if child.value:
            X11.XSetInputFocus(self.x, child, 1, ctypes.c_ulong(0))
        X11.XSync(self.x, 0)

    def end(self):
        # the client's library would end this process with its display
        self.server.kill()
        self.server.wait()


def log():
    return "".join(path.read_text() for path in sorted((state / "palpate").glob("palpate*.log"), reverse=True))


def wait(process, what, found):
    end = time.monotonic() + LONG
    while True:
        result = found()
        if result:
            return result
        assert process.poll() is None, (what, process.returncode, log())
        assert time.monotonic() < end, (what, log()[-3000:], list(data.rglob("*")))
        time.sleep(0.02)


def press(process, display, what, done, *keys, first=()):
    """Presses keys until they were heard: what comes before the window is ready for it does nothing, and a machine
    with much to do is ready later."""
    for pause in (0.5, 2.0, 6.0, 20.0):
        if first:
            display.key(*first)
        time.sleep(pause)
        display.focus()
        display.key(*keys)
        end = time.monotonic() + 5.0 + 2.0 * pause
        while time.monotonic() < end:
            if done():
                return
            time.sleep(0.02)
    wait(process, what, done)


def works():
    """What is kept, newest first. A file is there whole or not at all."""
    found = []
    for file in data.rglob("*.palpate-view"):
        try:
            found.append((file.stat().st_mtime_ns, json.loads(file.read_text())))
        except FileNotFoundError:
            pass  # it went meanwhile
    return [work for _, work in sorted(found, key=lambda one: one[0], reverse=True)]


def marks():
    return max((len(work["marks"]) for work in works()), default=0)


def cuts():
    return max((len(work["edits"]) for work in works()), default=0)


def nothing_of_a_patient():
    for file in data.rglob("*"):
        if "journal" not in file.parts or not file.exists():
            continue
        mode = stat.S_IMODE(file.stat().st_mode)
        assert mode == (0o700 if file.is_dir() else 0o600), (file, oct(mode))
        if file.is_file():
            text = file.read_bytes().decode()
            for word in words:
                assert word not in text and word not in str(file.relative_to(data)), (word, file)


def started(display, *arguments):
    opened = log().count(" scan-opened ")
    process = subprocess.Popen([program, "--no-notice", "--surface", "mesh", *map(str, arguments)],
                               env=dict(environment, DISPLAY=display.name))
    running.append(process)
    if arguments:
        wait(process, "the scan", lambda: log().count(" scan-opened ") > opened)
    return process


SLICE, SPACE = (1040, 260), (440, 420)  # a slice, and the 3-D view beside the ball
OFFERED, RESUMED = " work-offered ", " work-resumed"
HOWS = [signal.SIGKILL, signal.SIGTERM, "display", signal.SIGHUP]
most_late = 0.0
for n in range(kills):
    how = HOWS[n % len(HOWS)]
    if n % 12 == 0 and n > 0:  # as many marks as somebody sets in an hour: then all over again
        for work in list(data.rglob("*.palpate-view")):
            work.unlink()
    had_marks, had_cuts, offered, resumed = marks(), cuts(), log().count(OFFERED), log().count(RESUMED)
    display = Display()
    process = started(display, scan, "--isovalue", 300)
    if had_marks > 0:
        wait(process, "the offer", lambda: log().count(OFFERED) > offered)
        last = [line for line in log().splitlines() if OFFERED in line][-1]
        assert f"marks={had_marks} edits={had_cuts}" in last, (had_marks, had_cuts, last)
    display.move(*SPACE)
    display.focus()
    if had_marks > 0:
        press(process, display, "the work is back", lambda: log().count(RESUMED) > resumed, "Alt_L", "c")
    pressed = []  # when each mark was made
    before = had_marks

    def mark():
        display.click(*SLICE)
        display.key("v")
        display.key("Return")
        display.key("Escape")
        pressed.append(time.monotonic())

    # the first is waited for: it tells how late this machine is
    while marks() <= before:
        mark()
        begun = time.monotonic()
        while marks() <= before and time.monotonic() < begun + 5.0:
            time.sleep(0.01)
        assert process.poll() is None and len(pressed) < 30, (process.poll(), log()[-2000:])
    late = time.monotonic() - begun
    most_late = max(most_late, late)
    if had_cuts == 0 or chance.random() < 0.3:
        # what is pressed before the cut is shown cuts nothing: a machine with much to do gets more time
        for pause in (0.3, 1.0, 3.0, 9.0):
            display.key("Alt_L", "e")
            display.key("s")
            time.sleep(pause)
            x, y = chance.randint(520, 600), chance.randint(320, 500)  # on the ball, beside the tool
            display.drag(0.1 * pause, (x, y), (x + 40, y), (x + 40, y + 40), (x, y + 40), (x + 5, y + 5))
            time.sleep(pause)
            display.key("Return")
            end = time.monotonic() + 5.0 + 2.0 * pause
            while cuts() == 0 and time.monotonic() < end:
                time.sleep(0.05)
            for _ in range(3):  # the preview, the tool
                display.key("Escape")
            if had_cuts > 0 or cuts() > 0:  # another may remove nothing more
                break
        assert cuts() > 0, (process.poll(), log()[-2000:])
    done = marks()
    pressed.clear()
    placed = log().count(" mark-placed")
    made = []  # when the window had come to each mark, as its log says: by a machine that is late none is lost
    end = time.monotonic() + chance.uniform(0.0, 3.5)
    while time.monotonic() < end:
        mark()
        time.sleep(chance.uniform(0.02, 0.4))
        made += [time.monotonic()] * (log().count(" mark-placed") - placed - len(made))
    killed = time.monotonic()
    if how == "display":
        display.end()
    else:
        process.send_signal(how)
    code = process.wait(timeout=LONG)
    assert code == {signal.SIGKILL: -signal.SIGKILL, "display": 1}.get(how, 0), (how, code)
    # a machine that is busy is later: as much as it was before, and as it was with the keys
    heard_late = max([then - at for at, then in zip(pressed, made)] +
                     [killed - at for at in pressed[len(made):len(made) + 1]], default=0.0)
    slack = 1.0 + 2.0 * max(0.3, late, heard_late)
    safe = sum(at < killed - slack for at in made) if how in (signal.SIGKILL, "display") else len(made)
    print(f"{n}: {how}, {done} marks kept, then {len(pressed)} made, {len(made)} of them heard, {marks() - done} kept, "
          f"at least {safe} needed; the first was kept after {late:.2f} s", flush=True)
    assert marks() >= done + max(0, safe), (how, done, safe, marks())
    assert cuts() >= max(1, had_cuts), cuts()
    nothing_of_a_patient()
    if how != "display":
        display.end()

# a start without a scan knows where it is, and says so; ended by its user, nothing is left to offer
display = Display()
offered, opened = log().count(OFFERED), log().count(" scan-opened ")
process = started(display)
wait(process, "the offer at the start", lambda: log().count(OFFERED) > offered)
display.move(*SPACE)
press(process, display, "its scan", lambda: log().count(" scan-opened ") > opened, "Alt_L", "c")
had = marks()
wait(process, "the work is back", lambda: len(works()) == 1 and marks() == had)
time.sleep(1.5)
press(process, display, "its end", lambda: process.poll() is not None, "Alt_L", "d", first=("Control_L", "q"))
code = process.wait(timeout=LONG)
assert code == 0, code
assert not works(), works()
offered = log().count(OFFERED)
process = started(display, scan, "--isovalue", 300)
process.send_signal(signal.SIGTERM)
code = process.wait(timeout=LONG)
assert code == 0 and log().count(OFFERED) == offered, (code, log())
for word in words:
    assert word not in log(), word
print(f"{kills} times killed; at most {most_late:.2f} s until a mark was kept")
