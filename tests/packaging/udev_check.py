#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The installed udev rules give each device that they name to whoever sits at the machine, and no
other of the same makers.

Usage: udev_check.py RULES (as root, where umockdev and udev are installed)

Where udevadm can verify rules, it does (Debian 12's cannot). Then a device is made up for each product
of the rules, and udev itself says what it would do with it, after all rules of the system: a rule that
comes too late for 73-seat-late.rules counts as none.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

rules = pathlib.Path(sys.argv[1])


def ran(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def products():
    """(subsystem, vendor, product) of each USB device, (bus, vendor, product) of each other."""
    usb, others = [], []
    for line in rules.read_text().splitlines():
        if line.startswith("#") or 'TAG+="uaccess"' not in line:
            continue
        kind = re.search(r'SUBSYSTEM=="(\w+)"', line).group(1)
        vendor = re.search(r'idVendor\}=="(\w+)"', line)
        if vendor:
            product = re.search(r'idProduct\}=="([\w|]+)"', line)
            usb += [(kind, vendor.group(1), one) for one in (product.group(1).split("|") if product else ["0301"])]
        else:
            others.append(re.search(r'KERNELS=="(\w+):(\w+):(\w+)\.', line).groups())
    return usb, others


def described():
    """The devices as umockdev reads them, and whether each is to be had: {path: wanted}."""
    usb, others = products()
    # a receiver of keyboards and mice, a serial board of PJRC's, a serial cable of FTDI's
    foreign = [("hidraw", "046d", "c52b"), ("hidraw", "16c0", "0483"), ("usb", "0403", "6001")]
    text, wanted = [], {}
    for number, (kind, vendor, product) in enumerate(usb + foreign, 1):
        place = f"/devices/usb1/1-{number}"
        text.append(f"P: {place}\nE: DEVNAME=/dev/bus/usb/001/{number:03}\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n"
                    f"E: MAJOR=189\nE: MINOR={number}\nA: idVendor={vendor}\nA: idProduct={product}\n")
        if kind == "hidraw":
            place += f"/hidraw/hidraw{number}"
            text.append(f"P: {place}\nE: DEVNAME=/dev/hidraw{number}\nE: SUBSYSTEM=hidraw\nE: MAJOR=244\nE: MINOR={number}\n")
        wanted[place] = number <= len(usb)
    for number, (bus, vendor, product) in enumerate(others, 100):
        hid = f"/devices/virtual/misc/uhid/{bus}:{vendor}:{product}.0001"
        place = f"{hid}/hidraw/hidraw{number}"
        text.append(f"P: {hid}\nE: SUBSYSTEM=hid\n")
        text.append(f"P: {place}\nE: DEVNAME=/dev/hidraw{number}\nE: SUBSYSTEM=hidraw\nE: MAJOR=244\nE: MINOR={number}\n")
        wanted[place] = True
    return "\n".join(text), wanted


code, said = ran("udevadm", "verify", rules)
if "Unknown command verb" not in said:
    assert code == 0, said
text, wanted = described()
assert sum(wanted.values()) > 20, wanted
with tempfile.NamedTemporaryFile("w", suffix=".umockdev") as devices:
    devices.write(text)
    devices.flush()
    for place, to_be_had in wanted.items():
        code, said = ran("umockdev-run", "-d", devices.name, "--", "udevadm", "test", "--action=add", f"/sys{place}")
        assert code == 0, said
        complaints = [line for line in said.splitlines() if line.startswith(f"{rules}:") or f"{rules.name}:" in line]
        assert not complaints, complaints
        assert ("run: 'uaccess'" in said) == to_be_had, (place, to_be_had, text, said)
print(f"{sum(wanted.values())} devices are given to whoever sits there, {len(wanted) - sum(wanted.values())} others are not.")
