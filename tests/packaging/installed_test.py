#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `cmake --install` puts somewhere works there, and says nothing of where it was built.

Usage: installed_test.py CMAKE BUILD SOURCE SCRATCH

The programs run from a copy under another prefix than the one that they were built for; the helpers
that the build leaves beside its programs are not there.
"""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys

cmake, build, source, scratch = sys.argv[1], *(pathlib.Path(word).absolute() for word in sys.argv[2:5])
shutil.rmtree(scratch, ignore_errors=True)
stage = scratch / "stage"
subprocess.run([cmake, "--install", build, "--prefix", "/opt/palpate"], check=True, stdout=subprocess.DEVNULL,
               env={**os.environ, "DESTDIR": str(stage)})
prefix = scratch / "moved"
(stage / "opt/palpate").rename(prefix)
assert not list(stage.rglob("*.*")), "something was installed outside the prefix"

files = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if path.is_file()}
wanted = {
    "bin/palpate", "bin/palpate-cli", "bin/palpate-fetch", "libexec/palpate/palpate-decode", "libexec/palpate/palpate-draw",
    "libexec/palpate/palpate-study",
    "lib/udev/rules.d/70-palpate.rules", "share/applications/palpate.desktop",
    "share/metainfo/org.palpate.palpate.metainfo.xml", "share/mime/packages/palpate.xml",
    "share/man/man1/palpate.1", "share/man/man1/palpate-cli.1", "share/man/man1/palpate-fetch.1",
    "share/bash-completion/completions/palpate", "share/bash-completion/completions/palpate-cli",
    "share/bash-completion/completions/palpate-fetch", "share/zsh/site-functions/_palpate-fetch",
    "share/fish/vendor_completions.d/palpate-fetch.fish",
    "share/zsh/site-functions/_palpate", "share/zsh/site-functions/_palpate-cli",
    "share/fish/vendor_completions.d/palpate.fish", "share/fish/vendor_completions.d/palpate-cli.fish",
    "share/icons/hicolor/scalable/apps/palpate.svg", "share/icons/hicolor/symbolic/apps/palpate-symbolic.svg",
    "share/palpate/schemas/run.schema.json", "share/palpate/schemas/results.schema.json",
    "share/doc/palpate/help/index.md", "share/doc/palpate/LICENSE"}
wanted |= {f"share/icons/hicolor/{s}x{s}/apps/palpate.png" for s in (16, 22, 24, 32, 48, 64, 128, 256, 512)}
assert not wanted - files, f"not installed: {sorted(wanted - files)}"
for name in sorted(files):
    content = (prefix / name).read_bytes()
    for place in (str(build), str(source)):
        assert place.encode() not in content or name.startswith(("bin/", "libexec/")), f"{name} names {place}"

cli = prefix / "bin/palpate-cli"


def said(*words, code=0, environment=None):
    ran = subprocess.run([cli, *map(str, words)], capture_output=True, text=True, env=environment)
    assert ran.returncode == code, (words, ran.returncode, ran.stdout, ran.stderr)
    return ran.stdout


def run_length_coded():
    """A CT slice of 4 x 4 pixels, coded by RLE: two segments of 16 bytes that all are their own."""
    def element(group, number, kind, value):
        value = value if isinstance(value, bytes) else value.encode()
        value += (b"\0" if kind == "UI" else b" ") * (len(value) % 2)
        return struct.pack("<HH2sH", group, number, kind.encode(), len(value)) + value

    def number(group, place, value):
        return element(group, place, "US", struct.pack("<H", value))

    segment = bytes([15]) + bytes(range(16)) + b"\0"
    frame = struct.pack("<16I", 2, 64, 64 + len(segment), *[0] * 13) + segment + segment
    meta = element(2, 0x10, "UI", "1.2.840.10008.1.2.5")
    return (bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta
            + element(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(8, 0x18, "UI", "1.2.3.1")
            + element(8, 0x60, "CS", "CT") + element(0x20, 0xD, "UI", "1.2.3.2") + element(0x20, 0xE, "UI", "1.2.3.3")
            + element(0x20, 0x32, "DS", "0\\0\\0") + element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")
            + number(0x28, 2, 1) + element(0x28, 4, "CS", "MONOCHROME2") + number(0x28, 0x10, 4) + number(0x28, 0x11, 4)
            + element(0x28, 0x30, "DS", "1\\1") + number(0x28, 0x100, 16) + number(0x28, 0x101, 16)
            + number(0x28, 0x102, 15) + number(0x28, 0x103, 0)
            + struct.pack("<HH2sHI", 0x7FE0, 0x10, b"OB", 0, 0xFFFFFFFF)
            + struct.pack("<HHI", 0xFFFE, 0xE000, 0) + struct.pack("<HHI", 0xFFFE, 0xE000, len(frame)) + frame
            + struct.pack("<HHI", 0xFFFE, 0xE0DD, 0))


# a compressed slice: the decoder is found from the program's own place
slice_ = scratch / "slice.dcm"
slice_.write_bytes(run_length_coded())
out = scratch / "out.nrrd"
said("convert", slice_, out)
assert out.stat().st_size > 0
(prefix / "libexec/palpate/palpate-decode").rename(scratch / "palpate-decode")
refused = json.loads(said("convert", slice_, out, "--json", code=3))
assert "no-decoder" in refused["reasons"], refused
(scratch / "palpate-decode").rename(prefix / "libexec/palpate/palpate-decode")

# studies are another program's
assert "stability" in said("study", "--help")

# films are another program's, and without it the sentence says so
said("run", "--phantom", "sphere", "--isovalue", 1000, "--tool", "sphere", "--hand", "tap", "--seconds", 0.2,
     "--stiffness", 500, "--record", scratch / "t.palpate")
assert "--burn-in" in said("export", "--help")
said("export", scratch / "t.palpate", "--format", "csv", "--out", scratch / "t.csv")
(prefix / "libexec/palpate/palpate-draw").rename(scratch / "palpate-draw")
assert "--burn-in" not in said("export", "--help")
told = json.loads(said("export", scratch / "t.palpate", "--format", "video", "--out", scratch / "t.mp4", "--json",
                       code=4))
assert "palpate-draw" in told["error"]["message"], told

# the window's program asks for nothing but a display
quiet = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
quiet["XDG_STATE_HOME"] = str(scratch / "state")
ran = subprocess.run([prefix / "bin/palpate", "--version"], capture_output=True, text=True, env=quiet)
assert ran.returncode == 0 and ran.stdout.strip(), ran
# several files, as a file manager names them, are taken, and brackets in a name are no list
for paths in (["a.dcm", "b.dcm"], ["[a]", "b.dcm"]):
    ran = subprocess.run([prefix / "bin/palpate", *paths], capture_output=True, text=True, env=quiet)
    assert ran.returncode == 4 and "X display" in ran.stderr, ran
# its log names its build
log = next(scratch.rglob("palpate.log")).read_text()
build = bytes.fromhex(re.search(r"build\W+([0-9a-f]{40})", log).group(1))
assert build in (prefix / "bin/palpate").read_bytes(), log
# no command needs a library of the window, and the window and palpate-cli none of the network
windowless = ("libQt6Widgets", "libGL.so", "libQt6Network", "libdcmnet")
for name, not_needed in (("palpate-cli", windowless), ("../libexec/palpate/palpate-study", windowless),
                         ("palpate-fetch", ("libQt6Widgets", "libGL.so", "libvtk")),
                         ("palpate", ("libQt6Network", "libdcmnet"))):
    libraries = subprocess.run(["ldd", prefix / "bin" / name], capture_output=True, text=True).stdout
    assert not any(library in libraries for library in not_needed), (name, libraries)
# what fetches scans runs where it was moved to, and its child too
ran = subprocess.run([prefix / "bin/palpate-fetch", "echo", "--dimse", "127.0.0.1:1", "--called", "NOBODY", "--json"],
                     capture_output=True, text=True)
assert ran.returncode == 4 and json.loads(ran.stdout)["error"]["reason"] == "port", ran
print(f"{len(files)} files, installed and moved.")
