# SPDX-License-Identifier: BSD-3-Clause
"""Writes corpus/falcon: what a Falcon's USB chip says, one small file for each way of saying it."""
import pathlib

STATUS = b"\x01\x60"


def number(value):
    return bytes(0x41 + (value >> 4 * nibble & 15) for nibble in range(4))


def reply(encoders, homed=7, buttons=0):
    letters = b"".join(number(value & 0xFFFF) for value in encoders)
    return b"<" + letters + bytes([0x41 + 16 * homed + buttons]) + b"A>"


def transfer(payload):
    return bytes([2 + len(payload)]) + STATUS + payload


def seeds():
    here, there = reply((-200, -190, -210)), reply((-180, -200, -190), buttons=5)
    yield "whole", b"\0" + transfer(here) + transfer(there)
    yield "joined", b"\0" + transfer(here + there + here)
    yield "split", b"\0" + transfer(here[:7]) + transfer(here[7:]) + transfer(b"")
    yield "garbage", b"\0" + transfer(b">>x<<<" + here + b"<AA>" + there)
    yield "exchange", b"\1" + 8 * (transfer(here) + transfer(there))
    yield "homing", b"\1" + 4 * transfer(reply((0, 0, 0), 3)) + 4 * transfer(here)
    yield "jump", b"\1" + 3 * transfer(here) + 3 * transfer(reply((3000, -190, -210)))
    yield "late", b"\1" + transfer(here) + 2 * transfer(b"") + 4 * transfer(here + there)
    yield "unplugged", b"\1" + 3 * transfer(here) + b"\xff"
    yield "busy", b"\1" + 3 * transfer(here) + b"\xfe\xfe" + transfer(here)
    # silence while it is asked whether firmware runs; then the boot program, and the echo
    silence, echoes = 10 * b"\0", transfer(62 * b"f") + transfer(62 * b"f") + transfer(26 * b"f")
    hello = b"\0" + transfer(b"\x0a\x44\x2c\x0d") + b"\0" + transfer(b"\x41")
    yield "loaded", b"\2" + silence + hello + echoes + transfer(here)
    yield "wrong-echo", b"\2" + silence + hello + transfer(61 * b"f" + b"g")
    yield "leading-zero", b"\2" + silence + b"\0" + transfer(b"\0\x0a\x44\x2c\x0d")


folder = pathlib.Path(__file__).parent / "corpus" / "falcon"
folder.mkdir(parents=True, exist_ok=True)
for name, content in seeds():
    (folder / name).write_bytes(content)
