#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The window is told to end by a signal: once, and it closes as its user would close it; twice,
and it is gone at once. Or its display goes.

Use: signals_test.py PALPATE (with a display)
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

program = sys.argv[1]
LONG = 120  # s: far more than it takes on a machine that is busy
SHOWN, DRAWN = " scan-opened ", " graphics "  # what the log says when a scan is on view, and when the window is


def blocked(process):
    for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
        if line.startswith("SigBlk:"):
            return bool(int(line.split()[1], 16) >> (signal.SIGTERM - 1) & 1)
    return False


def state(process):
    """As ps has it: T where it is stopped."""
    return pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0]


def logged(home):
    return "".join(file.read_text() for file in (home / "state").rglob("*.log"))


def started(home, until, *options):
    """A window whose log says this, with preferences of its own; empty: as soon as it listens."""
    environment = dict(os.environ, HOME=str(home), XDG_CONFIG_HOME=str(home / "config"),
                       XDG_DATA_HOME=str(home / "data"), XDG_STATE_HOME=str(home / "state"))
    process = subprocess.Popen([program, *options, "--phantom", "sphere"], env=environment)
    end = time.monotonic() + LONG
    while not (blocked(process) and until in logged(home)):
        assert process.poll() is None, process.returncode
        assert time.monotonic() < end, (until, logged(home))
        time.sleep(0.01)
    return process


def remembered(home):
    files = list((home / "config").rglob("*.conf"))
    return any("geometry" in file.read_text() for file in files)


with tempfile.TemporaryDirectory() as folder:
    for number, (which, until) in enumerate([(signal.SIGTERM, SHOWN), (signal.SIGINT, SHOWN), (signal.SIGHUP, SHOWN),
                                             (signal.SIGQUIT, SHOWN), (signal.SIGTERM, "")]):
        home = pathlib.Path(folder) / str(number)
        home.mkdir()
        process = started(home, until, "--no-notice")
        # what stops or kills others leaves it as it is: it goes on, and can take a force back
        for harmless in (signal.SIGTSTP, signal.SIGTTIN, signal.SIGTTOU, signal.SIGPIPE):
            process.send_signal(harmless)
        time.sleep(0.2)
        assert process.poll() is None and state(process) != "T", (process.poll(), state(process))
        process.send_signal(which)
        code = process.wait(timeout=LONG)
        assert code == 0, (which, until, code)
        # what closing the window does was done; a window that never was has nothing to remember
        assert not until or remembered(home), (which, list(home.rglob("*")))

    # with the notice of the first start still standing there too
    home = pathlib.Path(folder) / "notice"
    home.mkdir()
    process = started(home, DRAWN)
    process.send_signal(signal.SIGTERM)
    code = process.wait(timeout=LONG)
    assert code == 0, code

    # the first closes it, in its own time; the second does not wait for that. The process may be
    # quicker than the second signal, but not every time. Two that are pending together are
    # delivered by their numbers, so either may be the second.
    codes = []
    for number in range(5):
        home = pathlib.Path(folder) / f"twice{number}"
        home.mkdir()
        process = started(home, SHOWN, "--no-notice")
        os.kill(process.pid, signal.SIGTERM)
        time.sleep(0.002)
        os.kill(process.pid, signal.SIGINT)
        codes.append(process.wait(timeout=LONG))
        if codes[-1] != 0:
            break
    assert codes[-1] in (-signal.SIGINT, -signal.SIGTERM) and not any(codes[:-1]), codes

    # the display goes, and the display's library leaves: by exit(), which stops the motors first
    told, tells = os.pipe()
    display = subprocess.Popen(["Xvfb", "-displayfd", str(tells), "-screen", "0", "1280x1024x24", "-noreset"], pass_fds=[tells],
                               stderr=subprocess.DEVNULL)
    os.close(tells)
    os.environ["DISPLAY"] = ":" + os.read(told, 16).decode().strip()
    home = pathlib.Path(folder) / "display"
    home.mkdir()
    process = started(home, SHOWN, "--no-notice")
    display.kill()
    display.wait()
    code = process.wait(timeout=LONG)
    assert code == 1, code
