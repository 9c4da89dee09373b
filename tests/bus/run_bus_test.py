#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Boots Debian's own kernel under emulation, runs bus_test in it and says what became of it.

run_bus_test.py PROGRAM KERNELS WORK: PROGRAM is bus_test, KERNELS the folder in which packaging/test
puts Debian's package of a kernel (linux-image-*.deb) and udev, unpacked; WORK a folder for what is
unpacked of the kernel, the guest's file system and its words. Ends with 77 where something is missing to boot with.
"""
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import time

SKIPPED = 77
LONGEST = 600  # s: a guest that takes longer hangs; 56 s on a free machine, several times that on a busy one
NEEDED = ("qemu-system-x86_64", "busybox", "dpkg-deb", "ldd", "strip")


def skip(why):
    print(f"SKIPPED: {why} No driver was tried on a real bus.")
    sys.exit(SKIPPED)


def unpacked(package, work):
    """Where the kernel and the modules of the package lie; unpacked once."""
    place = work / package.stem
    if not place.exists():
        fresh = work / "unpacking"
        shutil.rmtree(fresh, ignore_errors=True)
        fresh.mkdir()
        whole = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", package], stdout=subprocess.PIPE)
        subprocess.run(
            ["tar", "-x", "-C", fresh, "--wildcards", "./boot/vmlinuz-*",
             *(f"./lib/modules/*/kernel/drivers/{kind}/*" for kind in ("usb", "hid", "input"))],
            stdin=whole.stdout, check=True)
        if whole.wait() != 0:
            sys.exit(f"{package} is not a whole package: delete it and run packaging/test again.")
        fresh.rename(place)
    return place


def main():
    program, kernels, work = (pathlib.Path(word) for word in sys.argv[1:4])
    if platform.machine() != "x86_64":
        skip(f"the guest is x86_64, this machine {platform.machine()}.")
    for name in NEEDED:
        if shutil.which(name) is None:
            skip(f"there is no {name} here; packaging/dependencies names its package.")
    packages = sorted(kernels.glob("linux-image-*.deb"), key=lambda path: path.stat().st_mtime)
    if not packages:
        skip(f"there is no Debian kernel package in {kernels}; packaging/test fetches it.")

    kernel = unpacked(packages[-1], work)
    subprocess.run([pathlib.Path(__file__).with_name("mkinit.sh"), kernel, kernels / "udev", program,
                    work / "init.gz"], check=True)
    said, console = work / "said.txt", work / "console.txt"
    said.unlink(missing_ok=True)
    # time by counted instructions: what is slow on a busy host is not slow in the guest
    begun = time.monotonic()
    guest = subprocess.Popen(
        ["qemu-system-x86_64", "-accel", "tcg", "-icount", "shift=1,sleep=off", "-cpu", "max", "-m", "512",
         "-nodefaults", "-display", "none", "-no-reboot",
         "-serial", f"file:{console}", "-serial", f"file:{said}",
         "-kernel", next(kernel.glob("boot/vmlinuz-*")), "-initrd", work / "init.gz",
         "-append", "console=ttyS0 quiet panic=-1 tsc=reliable nokaslr"])
    try:
        guest.wait(timeout=LONGEST)
        ended = f"The guest ended after {time.monotonic() - begun:.1f} s."
    except subprocess.TimeoutExpired:
        guest.kill()
        guest.wait()
        ended = f"The guest did not end within {LONGEST} s."

    text = said.read_text(errors="replace").replace("\r", "") if said.exists() else ""
    print(text)
    print(ended)
    passed = re.search(r"^\[  PASSED  \] (\d+) tests?\.$", text, re.MULTILINE)
    if "bus_test ended with 0" in text and passed and int(passed[1]) > 0:
        return
    print("What the kernel said last:")
    print("\n".join(console.read_text(errors="replace").splitlines()[-40:]))
    sys.exit(1)


main()
