#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes resources/help/components.md and packaging/components.spdx: what Palpate is made of, from the
list in packaging/dependencies, the facts below, and the versions that Debian 12 has installed here.

Usage: components.py          fails where the two files are not current (77: a package is missing)
       components.py --write  writes them
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent / "resources/help/components.md"
SPDX = HERE / "components.spdx"

# development package: name, licence (SPDX), how it is used, what happens if it fails.
# "shared": linked as a shared library; "header": compiled in
LINKED = {
    "libeigen3-dev": ("Eigen", "MPL-2.0", "header", "the touch computes wrongly; the tests of the touch compare with closed forms"),
    "libexpected-dev": ("tl::expected", "CC0-1.0", "header", "an error is not reported"),
    "libhwy-dev": ("Highway", "Apache-2.0", "shared", "the field computes wrongly; tests compare each set of instructions with plain code"),
    "libcli11-dev": ("CLI11", "BSD-3-Clause", "header", "an option is misread"),
    "libreaderwriterqueue-dev": ("ReaderWriterQueue", "BSD-2-Clause", "header", "samples of the force curve are lost"),
    "nlohmann-json3-dev": ("JSON for Modern C++", "MIT", "header", "views, edits and answers in JSON are misread; a strict check follows"),
    "libsqlite3-dev": ("SQLite", "blessing", "shared", "a recording is damaged; the touch goes on"),
    "libhdf5-dev": ("HDF5", "BSD-3-Clause", "shared", "an export is damaged; the recording stays"),
    "libvtk9-dev": ("VTK", "BSD-3-Clause", "shared", "the picture is wrong or the window ends; the motors are stopped first"),
    "libvtk-dicom-dev": ("vtk-dicom", "BSD-3-Clause", "shared", "a header is misread; Palpate checks its structure before and its geometry after"),
    "libteem-dev": ("teem", "LGPL-2.1-or-later WITH Teem-exception", "shared", "an NRRD volume is misread; Palpate checks the header itself"),
    "libdcmtk-dev": ("DCMTK", "BSD-3-Clause", "shared", "a slice or a transfer is refused: it decodes and fetches in processes of its own"),
    "libcharls-dev": ("CharLS", "BSD-3-Clause", "shared", "a slice is refused: it decodes in a process of its own"),
    "libopenjp2-7-dev": ("OpenJPEG", "BSD-2-Clause", "shared", "a slice is refused: it decodes in a process of its own"),
    "libtheora-dev": ("Theora", "BSD-3-Clause", "shared", "no film without ffmpeg"),
    "libogg-dev": ("Ogg", "BSD-3-Clause", "shared", "no film without ffmpeg"),
    "libseccomp-dev": ("libseccomp", "LGPL-2.1-only", "shared", "compressed slices are refused, since their decoder cannot be confined"),
    "libdeflate-dev": ("libdeflate", "MIT", "shared", "a volume is refused"),
    "libarchive-dev": ("libarchive", "BSD-2-Clause", "shared", "an archive is refused, or the program ends while it opens one"),
    "libhidapi-dev": ("hidapi", "BSD-3-Clause", "shared", "a device is lost; the force ends. Of its three licences BSD is chosen"),
    "libusb-1.0-0-dev": ("libusb", "LGPL-2.1-or-later", "shared", "the Falcon is lost; the force ends"),
    "libwebsockets-dev": ("libwebsockets", "MIT", "shared", "the Inverse3 is lost; the force ends"),
    "libssl-dev": ("OpenSSL", "Apache-2.0", "shared", "a connection of palpate-fetch is refused, or a certificate is trusted that should not be"),
    "libsecret-1-dev": ("libsecret", "LGPL-2.1-or-later", "shared", "a password is not found; palpate-fetch asks for another login"),
    "zlib1g-dev": ("zlib", "Zlib", "shared", "a compressed volume is refused"),
    "libspdlog-dev": ("spdlog and fmt", "MIT", "shared", "the log is missing; the program goes on"),
    "libdw-dev": ("elfutils, libdw", "LGPL-3.0-or-later OR GPL-2.0-or-later", "shared", "a crash report is missing or damaged, or the program ends while it makes one"),
    "qt6-base-dev": ("Qt 6 base", "LGPL-3.0-only", "shared", "the window ends; the motors are stopped first"),
    "qt6-svg-dev": ("Qt 6 SVG", "LGPL-3.0-only", "shared", "symbols are missing"),
    "libgl-dev": ("GLVND, OpenGL", "MIT", "shared", "no picture; the window says so"),
    "libegl-dev": ("GLVND, EGL", "MIT", "shared", "no picture; the window says so"),
}
# parts of a package above, or what only builds
WITHIN = {"libqt6opengl6-dev"}
ONLY_BUILDS = {"g++", "cmake", "ninja-build", "ccache", "lld", "pkgconf", "qt6-l10n-tools"}


def listed():
    """{section: {package: what it is for}}"""
    section, found = "", {}
    for line in (HERE / "dependencies").read_text().splitlines():
        name, _, words = (part.strip() for part in line.partition("#"))
        if name.startswith("["):
            section = name[1:-1]
        elif name:
            found.setdefault(section, {})[name] = words
    return found


def version(package):
    """The maker's version, without Debian's revision, which changes with each security update."""
    shown = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True)
    if shown.returncode or not shown.stdout:
        print(f"{package} is not installed, so nothing was compared.")
        sys.exit(77)
    return re.sub(r"[-+.~](dfsg|ds|really|repack|\d{8}).*|-[^-]*$", "", re.sub(r"^\d+:", "", shown.stdout))


def main():
    found = listed()
    unknown = set(found["build-time"]) - set(LINKED) - WITHIN - ONLY_BUILDS
    if unknown or set(LINKED) - set(found["build-time"]):
        print("packaging/components.py and packaging/dependencies differ:",
              *sorted(unknown | (set(LINKED) - set(found["build-time"]))))
        return 1
    if bad := [name for name, row in LINKED.items() if re.match(r"A?GPL", row[1])]:
        print("licences that must not be linked:", *bad)
        return 1
    release = re.search(r"project\(\w+ VERSION (\S+)", (HERE.parent / "CMakeLists.txt").read_text()).group(1)
    page = ["# What Palpate is made of", "",
            "Made by `packaging/components.py` from the list of packages that Palpate is built with. Palpate itself is BSD-3-Clause. "
            "No library under the GPL is linked; those under the LGPL are linked as shared libraries. All of them are Debian 12's own packages, "
            "with Debian's security updates.", "",
            "| component | package | version in Debian 12 | licence | linked as | used for | if it fails |", "|---|---|---|---|---|---|---|"]
    spdx = ["SPDXVersion: SPDX-2.3", "DataLicense: CC0-1.0", "SPDXID: SPDXRef-DOCUMENT", f"DocumentName: palpate-{release}",
            f"DocumentNamespace: urn:palpate:{release}:components", "Creator: Tool: packaging/components.py",
            "Creator: Organization: The Palpate authors", "Created: 2026-11-25T00:00:00Z", "",
            "ExtractedLicenseInfo placeholder"]
    spdx.pop()
    spdx += ["PackageName: palpate", "SPDXID: SPDXRef-palpate", f"PackageVersion: {release}", "PackageDownloadLocation: NOASSERTION",
             "FilesAnalyzed: false", "PackageLicenseConcluded: BSD-3-Clause", "PackageLicenseDeclared: BSD-3-Clause",
             "PackageCopyrightText: NOASSERTION", "Relationship: SPDXRef-DOCUMENT DESCRIBES SPDXRef-palpate", ""]
    for package, (name, licence, how, failure) in LINKED.items():
        here = version(package)
        use = found["build-time"][package] or {"libogg-dev": "films", "qt6-svg-dev": "symbols", "libgl-dev": "the picture",
                                               "libegl-dev": "the picture"}.get(package, "")
        linked = {"header": "headers, compiled in", "shared": "shared library"}[how]
        page.append(f"| {name} | `{package}` | {here} | {licence.replace(' WITH Teem-exception', ', with an exception for linking')} | {linked} | {use} | {failure} |")
        reference = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", package)
        stated = licence.replace(" WITH Teem-exception", "")
        spdx += [f"PackageName: {name}", f"SPDXID: {reference}", f"PackageVersion: {here}", "PackageDownloadLocation: NOASSERTION",
                 "FilesAnalyzed: false", f"PackageLicenseConcluded: {stated}", f"PackageLicenseDeclared: {stated}",
                 "PackageCopyrightText: NOASSERTION",
                 f"ExternalRef: PACKAGE-MANAGER purl pkg:deb/debian/{package}@{here}?distro=bookworm",
                 f"Relationship: SPDXRef-palpate {'STATIC' if how == 'header' else 'DYNAMIC'}_LINK {reference}", ""]
    page += ["", "## Programs beside Palpate", "", "| package | used for |", "|---|---|"]
    page += [f"| `{name}` | {words or 'letters'} |" for name, words in found["run-time"].items()]
    page += ["", "ffmpeg (GPL) is a program of its own and not linked: where it is installed, films are MP4. The makers' libraries of some haptic "
             "devices are opened at run time, and are not part of Palpate.", "", "## Known anomalies", "",
             "Faults of these components that Palpate works around are listed in `datasets/readers/README.md` of the source. Cases of Palpate's own "
             "studies that do not hold are listed in `app/study/README.md`.", ""]
    wrong = 0
    for path, lines in ((PAGE, page), (SPDX, spdx)):
        text = "\n".join(lines)
        if "--write" in sys.argv:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path.name} is not current; run packaging/components.py --write.")
            wrong = 1
    print(f"{len(LINKED)} components, {wrong} wrong.")
    return wrong


sys.exit(main())
