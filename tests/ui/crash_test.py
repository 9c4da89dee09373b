#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The window crashes while it shows a scan. It leaves no core dump, whatever signal ends it, its log and
its report name nobody, and the next start says what happened. palpate-cli leaves no core dump either.

Use: crash_test.py PALPATE FOLDER PALPATE-CLI (with a display)
"""
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "scenario"))
import nobody_test as nobody  # noqa: E402  (it reads the same arguments, and empties the folder)

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
LONG = 180  # s: far more than it takes on a machine that is busy
home = folder / "PLNTHOME"
home.mkdir(parents=True)
state = folder / "state" / "palpate"
environment = dict(os.environ, HOME=str(home), XDG_CONFIG_HOME=str(home / "config"), XDG_DATA_HOME=str(home / "data"),
                   XDG_STATE_HOME=str(folder / "state"))


def log():
    return "".join(path.read_text() for path in sorted(state.glob("palpate*.log"), reverse=True))


def begun(*words):
    def allow_core():
        resource.setrlimit(resource.RLIMIT_CORE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    return subprocess.Popen(list(map(str, words)), env=environment, cwd=folder, preexec_fn=allow_core)


def started(*options):
    return begun(program, "--no-notice", *options)


def wait_for(process, what, count=1):
    end = time.monotonic() + LONG
    while log().count(what) < count:
        assert process.poll() is None, (what, process.returncode, log())
        assert time.monotonic() < end, (what, log())
        time.sleep(0.05)


def work(process, seconds):
    """Waits until it has used so much of a processor, as a loop that goes on will: a machine that is busy takes longer."""
    def used():
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    end = time.monotonic() + LONG
    while used() < seconds:
        assert process.poll() is None, process.returncode
        assert time.monotonic() < end, used()
        time.sleep(0.05)


def rest(process):
    """Waits until the main thread sleeps: where it draws by code that the graphics made as it ran, a stack has no
    names."""
    end = time.monotonic() + LONG
    asleep = 0
    while asleep < 10:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
        asleep = asleep + 1 if fields[0] == "S" else 0
        assert time.monotonic() < end, fields
        time.sleep(0.02)


def ended(process):
    process.send_signal(signal.SIGTERM)
    code = process.wait(timeout=LONG)
    assert code == 0, code


# a scan with a person in it, and a file that is refused
who = nobody.unmistakable()
words = nobody.planted + ["PLNT", "Jane", str(folder), home.name]
scan = folder / "PLNTFOLDER_Jane"
scan.mkdir()
for k in range(nobody.N):
    (scan / f"PLNTFILE_{k}.dcm").write_bytes(nobody.slice_of(k, who))
process = started(scan, "--isovalue", 300, "--log-level", "debug")
wait_for(process, " scan-opened from=file columns=24 rows=24 slices=24 ")
ended(process)
refused = folder / "PLNTFILE_Jane.nrrd"
refused.write_text("NRRD0004\ntype: PLNTTYPE\n\n")
process = started(refused)
wait_for(process, " not-opened id=")
ended(process)
assert " start version=" in log() and " graphics " in log(), log()
for word in words:
    assert word not in log(), (word, log())
assert [path.name for path in state.iterdir()] == ["palpate.log"], list(state.iterdir())

# what is not wanted is not written
before = log()
process = started(refused, "--log-level", "off", "--screenshot", folder / "none.png")  # it ends by itself
code = process.wait(timeout=LONG)
assert code == 3, code
assert log() == before, log()
assert subprocess.run([program, "--log-level", "loud"], env=environment, capture_output=True).returncode == 2

# no signal that dumps leaves a dump, also where the system makes them
volume = folder / "PLNTVOLUME.nrrd"
volume.write_bytes(b"NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: 96 96 80\n"
                   b"space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\nendian: little\n\n"
                   + random.Random(7).randbytes(2 * 96 * 96 * 80))
DUMPING = [signal.SIGSEGV, signal.SIGTRAP, signal.SIGSYS, signal.SIGXCPU, signal.SIGILL, signal.SIGABRT, signal.SIGBUS,
           signal.SIGFPE, signal.SIGQUIT]
pattern = pathlib.Path("/proc/sys/kernel/core_pattern").read_text().strip()
sleeper = begun("/bin/sleep", LONG)
sleeper.send_signal(signal.SIGSEGV)
sleeper.wait()
cores_are_here = bool(list(folder.glob("core*")))
for core in folder.glob("core*"):
    core.unlink()


def crash(process, how):
    process.send_signal(how)
    code = process.wait(timeout=LONG)
    # the window and the command line take the first SIGQUIT for a wish to end
    assert code == -how or how == signal.SIGQUIT, (how, code)
    assert not list(folder.glob("core*")), (how, list(folder.glob("core*")))


for how in DUMPING:
    process = begun(os.path.abspath(sys.argv[3]), "run", "--volume", volume, "--isovalue", 1500, "--tool", "sphere", "--hand",
                    "slide", "--stiffness", 500, "--seconds", 3600)
    work(process, 0.3)
    crash(process, how)
opened = log().count(" scan-opened ")
for how in (DUMPING if os.environ.get("PALPATE_TEST_ALL") else DUMPING[1:4]) + [signal.SIGSEGV]:
    process = started(volume, "--isovalue", 1500, "--surface", "raycast")
    opened += 1
    wait_for(process, " scan-opened ", opened)
    rest(process)
    crash(process, how)
assert len(list(state.glob("crash-*.raw"))) == 1, list(state.iterdir())

# the next start makes a report of it, and leaves the crash itself no longer there
told = log().count(" crash-report")
process = started("--phantom", "sphere")
wait_for(process, " crash-report", told + 1)
ended(process)
report = (state / "crash-report.txt").read_text()
assert "SIGSEGV" in report and "palpate+0x" in report and " main" in report, report
assert " scan-opened from=file columns=96 " in report, report
assert not list(state.glob("*.raw")), list(state.iterdir())
for word in words:
    assert word not in report, (word, report)
print(report.partition("\nThe log before:")[0])
if not cores_are_here:
    print(f"SKIPPED in part: core dumps go elsewhere here (core_pattern is {pattern!r})")
    sys.exit(77)
