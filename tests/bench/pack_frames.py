#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Packs palpate-frames with the libraries that it needs, for a machine with a graphics card.

Usage: pack_frames.py PALPATE_FRAMES OUT.tar.gz

The archive has a folder `frames` with a script `measure`, which is run on the other machine:

    frames/measure [SCAN] [options of palpate-frames] --out RESULT.json

It needs an X display on the graphics card (DISPLAY), glibc as new as this machine's, and the
card's own OpenGL libraries; all else is in the archive. Without a scan it draws the demo skull.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

# of the other machine: the C library, and what belongs to its driver and display
THEIRS = re.compile(r"^(ld-linux|libc\.so|libm\.so|libdl|libpthread|librt|libresolv|libGL|libEGL|"
                    r"libOpenGL|libdrm|libnvidia|libgbm|libglapi|libX11|libxcb\.so)")
PLUGINS = ["platforms/libqxcb.so", "xcbglintegrations/libqxcb-glx-integration.so",
           "imageformats/libqsvg.so", "iconengines/libqsvgicon.so"]
MEASURE = """#!/bin/sh
here=$(cd "$(dirname "$0")" && pwd)
if [ -z "$DISPLAY" ]; then
  echo "There is no X display: start one on the graphics card and set DISPLAY." >&2
  exit 4
fi
LD_LIBRARY_PATH="$here/lib" QT_PLUGIN_PATH="$here/plugins" exec "$here/palpate-frames" "$@"
"""


def libraries_of(binary):
    """Name and path of each shared library that the loader finds for it."""
    listed = subprocess.run(["ldd", binary], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^\s*(\S+) => (/\S+)", listed, re.MULTILINE)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    if not program.is_file():
        sys.exit(f"There is no program {program}; build the target palpate-frames first.")
    plugins = pathlib.Path(subprocess.run(
        ["qtpaths6", "--query", "QT_INSTALL_PLUGINS"], capture_output=True, text=True,
        check=False).stdout.strip() or "/usr/lib/x86_64-linux-gnu/qt6/plugins")
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made) / "frames"
        (folder / "lib").mkdir(parents=True)
        shutil.copy2(program, folder / "palpate-frames")
        binaries = [program]
        for plugin in PLUGINS:
            if not (plugins / plugin).is_file():
                continue
            (folder / "plugins" / plugin).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(plugins / plugin, folder / "plugins" / plugin)
            binaries.append(plugins / plugin)
        for binary in binaries:
            for name, path in libraries_of(binary):
                if not THEIRS.match(name):
                    shutil.copy2(os.path.realpath(path), folder / "lib" / name)
        measure = folder / "measure"
        measure.write_text(MEASURE)
        measure.chmod(0o755)
        with tarfile.open(out, "w:gz", compresslevel=6) as archive:
            archive.add(folder, arcname="frames")
    print(f"{out}: {out.stat().st_size / 1e6:.0f} MB")


main()
