# SPDX-License-Identifier: BSD-3-Clause
"""What many files read brings no VTK with it, through whatever it includes. Run as:
light_headers.py TREE, or light_headers.py --plant SCRATCH to see that a fault is found."""
import re
import sys
from pathlib import Path

LIGHT = ["app/application.h"]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def reached(tree, header):
    """The way from a header to each that it includes: {name: names from the header to it}."""
    ways, ahead = {header: [header]}, [header]
    while ahead:
        name = ahead.pop(0)
        file = tree / name
        if not file.is_file():
            continue  # of a library
        for included in INCLUDE.findall(file.read_text(encoding="utf-8")):
            if included not in ways:
                ways[included] = ways[name] + [included]
                ahead.append(included)
    return ways


def faults(tree):
    found = []
    for header in LIGHT:
        if not (tree / header).is_file():
            found.append(f"{header} is not there: nothing was checked")
            continue
        for name, way in reached(tree, header).items():
            if name.startswith("vtk"):
                found.append(" -> ".join(way))
    return found


def plant(scratch):
    (scratch / "app").mkdir(parents=True, exist_ok=True)
    (scratch / "ui").mkdir(exist_ok=True)
    (scratch / "app/application.h").write_text('#include <memory>\n#include "ui/far.h"\n')
    (scratch / "ui/far.h").write_text('#include "ui/farther.h"\n')
    (scratch / "ui/farther.h").write_text("#include <string>\n")
    if faults(scratch):
        sys.exit("a header without VTK is taken for one with it")
    (scratch / "ui/farther.h").write_text("#include <vtkSmartPointer.h>\n")
    expected = ["app/application.h -> ui/far.h -> ui/farther.h -> vtkSmartPointer.h"]
    if faults(scratch) != expected:
        sys.exit(f"a planted fault was not found: {faults(scratch)}")


if len(sys.argv) == 3 and sys.argv[1] == "--plant":
    plant(Path(sys.argv[2]))
elif len(sys.argv) == 2:
    found = faults(Path(sys.argv[1]))
    if found:
        sys.exit("These headers bring VTK into whoever includes them:\n" + "\n".join(found))
else:
    sys.exit(__doc__)
