# SPDX-License-Identifier: BSD-3-Clause
"""What a short script does for a series by WADO-RS: reader.py URL FOLDER asks once, reads all and
writes the parts as files. palpate-fetch is timed beside it."""
import pathlib
import sys
import urllib.request

request = urllib.request.Request(sys.argv[1], headers={
    "Accept": 'multipart/related; type="application/dicom"; transfer-syntax=*'})
with urllib.request.urlopen(request) as answer:
    boundary = answer.headers.get_param("boundary").encode()
    body = answer.read()
parts = body.split(b"\r\n--" + boundary)
for number, part in enumerate(parts):
    _, _, image = part.partition(b"\r\n\r\n")
    if image:
        pathlib.Path(sys.argv[2], f"{number}.dcm").write_bytes(image)
