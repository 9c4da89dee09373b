#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The files that are installed beside the programs, held to their formats and to each other.

Usage: files_test.py desktop|modalias|mime|icons|versions|pages ROOT SCRATCH
"""
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree

check, root, scratch = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
desktop = root / "packaging/desktop"
METAINFO = scratch.parents[1] / "packaging/org.palpate.palpate.metainfo.xml"  # as it is installed
MIME = desktop / "palpate.mime.xml"
SIZES = (16, 22, 24, 32, 48, 64, 128, 256, 512)


def clean(*command):
    """Runs a tool that must say nothing is wrong; skips the test without the tool."""
    if shutil.which(command[0]) is None:
        print(f"Not checked: there is no {command[0]}.")
        sys.exit(77)
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout + ran.stderr


def entry(key):
    """The value of a key of the desktop entry, in its first group."""
    return re.search(rf"^{key}=(.*)$", (desktop / "palpate.desktop").read_text(), re.M).group(1)


def tree(path):
    return xml.etree.ElementTree.parse(path).getroot()


def check_desktop():
    for name in (METAINFO, MIME):
        clean("xmllint", "--noout", name)
    for icon in sorted((root / "resources/icons").rglob("*.svg")):
        clean("xmllint", "--noout", icon)
    assert clean("desktop-file-validate", desktop / "palpate.desktop") == ""
    told = clean("appstreamcli", "validate", "--pedantic", "--no-net", METAINFO)
    assert not re.search(r"^[EWIP]:", told, re.M), told
    assert entry("Exec") == "palpate %F" and "inode/directory" not in entry("MimeType")
    types = {name.get("type") for name in tree(MIME)}
    named = set(entry("MimeType").strip(";").split(";"))
    assert named == types | {"application/dicom"}, named ^ types
    provided = {media.text for media in tree(METAINFO).iter("mediatype")}
    assert provided == named, provided ^ named
    # what the menu starts are options that there are
    action = re.search(r"^Exec=palpate (--.*)$", (desktop / "palpate.desktop").read_text(), re.M).group(1)
    page = (root / "resources/help/palpate.md").read_text()
    assert all(f"`{word} " in page for word in action.split() if word.startswith("--")), action


def check_modalias():
    """A modalias for each device that a rule lets the user have, and no other."""
    rules = set()
    for line in (root / "packaging/70-palpate.rules").read_text().splitlines():
        if line.startswith("#") or 'TAG+="uaccess"' not in line:
            continue
        vendor = re.search(r'idVendor\}=="(\w+)"', line)
        products = re.search(r'idProduct\}=="([\w|]+)"', line)
        if vendor:
            for product in products.group(1).upper().split("|") if products else ["*"]:
                rules.add(f"usb:v{vendor.group(1).upper()}p{product}d*")
        else:
            bus, maker, product = re.search(r'KERNELS=="(\w+):(\w+):(\w+)\.', line).groups()
            rules.add(f"hid:b{bus}g*v0000{maker.upper()}p0000{product.upper()}")
    stated = {alias.text for alias in tree(METAINFO).iter("modalias")}
    assert len(rules) > 20 and rules == stated, rules ^ stated
    assert {"usb:v0403pCB48d*", "usb:v1451p*d*", "hid:b0005g*v0000256Fp0000C63A"} <= stated, stated


def check_mime():
    """The types are taken by the desktop's database, and files of each are known by their beginning."""
    data = scratch / "mime-data"
    shutil.rmtree(data, ignore_errors=True)
    (data / "mime/packages").mkdir(parents=True)
    for system in pathlib.Path("/usr/share/mime/packages").glob("*.xml"):
        shutil.copy(system, data / "mime/packages")
    shutil.copy(MIME, data / "mime/packages/palpate.xml")
    clean("update-mime-database", data / "mime")
    files = data / "files"
    files.mkdir()
    session = root / "tests/scenario/sessions/demo-slide.palpate"
    nifti = bytearray(352)
    nifti[344:348] = b"n+1\0"
    samples = {  # a name without an ending that tells, what is in it, the type
        "recording": (session.read_bytes()[:4096], "application/x-palpate-recording"),
        "volume": (b"NRRD0004\ntype: short\n", "application/x-nrrd"),
        "image": (b"ObjectType = Image\nNDims = 3\n", "application/x-metaimage"),
        "brain": (bytes(nifti), "application/x-nifti"),
        "v.nhdr": (b"NRRD0005\n", "application/x-nrrd-header"),
        "v.mhd": (b"ObjectType = Image\n", "application/x-metaimage-header"),
        "b.nii.gz": (b"\x1f\x8b", "application/x-nifti-compressed"),
        "s.palpate-view": (b"{}", "application/x-palpate-view"),
        "t": (b"some text\n", "text/plain")}
    import os
    for name, (content, wanted) in samples.items():
        (files / name).write_bytes(content)
        if shutil.which("gio") is None:
            print("Not checked: there is no gio.")
            sys.exit(77)
        told = subprocess.run(["gio", "info", "-a", "standard::content-type", files / name], text=True,
                              capture_output=True, env={**os.environ, "XDG_DATA_HOME": str(data), "XDG_DATA_DIRS": str(data)}).stdout
        assert f"content-type: {wanted}\n" in told + "\n", (name, wanted, told)


def check_icons():
    for size in SIZES:
        png = (root / f"resources/icons/desktop/palpate-{size}.png").read_bytes()
        assert struct.unpack(">II", png[16:24]) == (size, size), size
        assert len(png) < 40_000, size
    symbolic = (root / "resources/icons/desktop/palpate-symbolic.svg").read_text()
    assert len(set(re.findall(r"#[0-9a-f]{6}", symbolic))) == 1, "a symbolic icon has one colour"
    if shutil.which("rsvg-convert") is None:
        print("Whether the pictures are those of the drawings was not checked: there is no rsvg-convert.")
        sys.exit(77)
    out = scratch / "icons"
    out.mkdir(parents=True, exist_ok=True)
    clean(root / "resources/icons/desktop/render.sh", out)
    for size in SIZES:
        name = f"palpate-{size}.png"
        assert (out / name).read_bytes() == (root / "resources/icons/desktop" / name).read_bytes(), name


def check_versions():
    version = re.search(r"project\(\w+ VERSION (\S+)", (root / "CMakeLists.txt").read_text()).group(1)
    assert tree(METAINFO).find("releases/release").get("version") == version
    assert re.search(r"^## (\S+?),", (root / "CHANGELOG.md").read_text(), re.M).group(1) == version
    assert f"version: {version}\n" in (root / "CITATION.cff").read_text()
    assert (root / "packaging/debian/changelog").read_text().startswith(f"palpate ({version}-")


def check_pages():
    """The help becomes HTML without a warning, and the man pages are those of the help."""
    if not pathlib.Path("/usr/bin/sphinx-build").exists():
        print("Not checked: there is no sphinx-build.")
        sys.exit(77)
    out = scratch / "pages"
    shutil.rmtree(out, ignore_errors=True)
    clean("/usr/bin/sphinx-build", "-q", "-W", "-c", root / "packaging/help", "-b", "html", "-d", out / "doctrees",
          root / "resources/help", out / "html")
    assert (out / "html/messages.html").read_text().count("<section") > 30
    clean("env", "PATH=/usr/bin:/bin", root / "packaging/help/man.sh", out / "man")
    for page in ("palpate.1", "palpate-cli.1", "palpate-fetch.1"):
        assert (out / "man" / page).read_text() == (root / "packaging/man" / page).read_text(), \
            f"{page} is not that of the help; run packaging/help/man.sh"


{name[6:]: f for name, f in globals().items() if name.startswith("check_")}[check]()
print(f"{check}: as it should be.")
