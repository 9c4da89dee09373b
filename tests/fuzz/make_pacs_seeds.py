#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of multipart_fuzz and qido_fuzz: make_pacs_seeds.py [CORPUS]."""
import json
import pathlib
import sys


def ui(*texts):
    return {"vr": "UI", "Value": list(texts)}


STUDY = {"0020000D": ui("1.2.3"), "00080020": {"vr": "DA", "Value": ["20240305"]},
         "00100010": {"vr": "PN", "Value": [{"Alphabetic": "A^B"}]}, "00100020": {"vr": "LO", "Value": ["1"]},
         "00081030": {"vr": "LO", "Value": ["head"]}}
SERIES = {"0020000D": ui("1.2.3"), "0020000E": ui("1.2.3.4"), "00080060": {"vr": "CS", "Value": ["CT"]},
          "00200011": {"vr": "IS", "Value": [3]}, "00201209": {"vr": "IS", "Value": ["120"]},
          "0008103E": {"vr": "LO", "Value": ["thin"]}}
QIDO = {
    "studies": (0, [STUDY, {**STUDY, "0020000D": ui("1.2.4")}]),
    "series": (1, [SERIES, {**SERIES, "0020000E": ui("1.2.3.5")}]),
    "images": (2, [{"00080018": ui("1.2.3.4.5")}, {"00080018": ui("1.2.3.4.6")}]),
    "path": (0, [{"0020000D": ui("../../etc")}, {"0020000D": ui()}]),
    "empty": (1, []),
    "nested": (1, [{**SERIES, "00081140": {"vr": "SQ", "Value": [STUDY]}}]),
}
QUOTED = b'multipart/related; type="application/dicom"; boundary="b"\n'
PLAIN = b"multipart/related; boundary=b; type=application/dicom\n"
PART = b"Content-Type: application/dicom\r\n"
MULTIPART = {
    "one": b"\x03" + QUOTED + b"--b\r\n" + PART + b"\r\nDICM\r\n--b--",
    "two": b"\x01" + PLAIN + b"preamble\r\n--b\r\n" + PART * 2 + b"\r\none\r\n--b \r\n\r\ntwo\r\n--b--\r\nend",
    "lengths": b"\x05" + PLAIN + b"--b\r\nContent-Length: 999\r\n\r\n\r\n\r\n-\r\n--c\r\n--b--",
    "empty": b"\x02" + PLAIN + b"--b--",
    "cut-off": b"\x07" + QUOTED + b"--b\r\n" + PART + b"\r\nDICM\r\n--",
    "no-line": b"\x07" + PLAIN + b"--bc\r\n\r\nDICM\r\n--b--",
}

corpus = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("corpus"))
for name, (kind, entries) in QIDO.items():
    (corpus / "qido").mkdir(parents=True, exist_ok=True)
    (corpus / "qido" / name).write_bytes(bytes([kind]) + json.dumps(entries).encode())
for name, text in MULTIPART.items():
    (corpus / "multipart").mkdir(parents=True, exist_ok=True)
    (corpus / "multipart" / name).write_bytes(text)
