#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails where folders include each other in a circle, and prints the includes that close it; and
where a folder has more sources than a reader looks over.

Usage: include_circles.py ROOT
       include_circles.py --plant SCRATCH   (proves that it can fail)

A node is a folder at the first level below app, datasets, haptics and ui, or a file in the root of
one of these (header and source are one). The folders and files in datasets/readers and app/window
are nodes too.
"""
import pathlib
import re
import shutil
import sys

TOPS = ("app", "datasets", "haptics", "ui")
INCLUDE = re.compile(r'^\s*#\s*include\s*"((?:%s)/[^"]+)"' % "|".join(TOPS), re.M)


ROOMS = ("datasets/readers/", "app/window/")  # whose folders are nodes of their own
MOST = 25  # sources (.cpp) of a folder


def node(path):
    parts = path.split("/")
    level = 3 if path.startswith(ROOMS) else 2
    return "/".join(parts[:level]) if len(parts) > level else path.rsplit(".", 1)[0]


def graph(root):
    """{node: {node it includes: ["file includes file", …]}}, and how many files were read."""
    edges, files = {}, 0
    for top in TOPS:
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            files += 1
            name = path.relative_to(root).as_posix()
            for included in INCLUDE.findall(path.read_text()):
                if node(included) != node(name):
                    edges.setdefault(node(name), {}).setdefault(node(included), []).append(
                        f"{name} includes {included}")
    return edges, files


def circles(edges):
    """The groups of nodes that reach each other."""
    def reach(start):
        seen, todo = set(), [start]
        while todo:
            for after in edges.get(todo.pop(), {}):
                if after not in seen:
                    seen.add(after)
                    todo.append(after)
        return seen

    reached = {start: reach(start) for start in edges}
    inside = [n for n in edges if n in reached[n]]
    return sorted({tuple(sorted(m for m in inside if m in reached[n] and n in reached[m]))
                   for n in inside})


def full(root):
    """The folders with too many sources: ["folder has number sources"]."""
    counts = {}
    for top in TOPS:
        for path in (root / top).rglob("*.cpp"):
            folder = path.parent.relative_to(root).as_posix()
            counts[folder] = counts.get(folder, 0) + 1
    return [f"{folder} has {count} sources" for folder, count in sorted(counts.items()) if count > MOST]


def check(root):
    edges, files = graph(root)
    found = circles(edges)
    for circle in found:
        print("A circle: " + ", ".join(circle))
        for start in circle:
            for end in circle:
                for line in edges[start].get(end, []):
                    print("  " + line)
    print(f"{files} files, {len(edges)} nodes, {len(found)} circles.")
    return files, found


def plant(scratch):
    shutil.rmtree(scratch, ignore_errors=True)

    def write(name, *included):
        path = scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(f'#include "{i}"\n' for i in included))

    write("haptics/a/one.h", "haptics/b/two.h", "haptics/a/other.h")
    write("haptics/b/deep/two.cpp", "haptics/c.h")
    write("haptics/c.cpp", "app/d/three.h")
    write("ui/e.h", "haptics/a/one.h")
    assert check(scratch) == (4, []), "a circle was found where there is none"
    write("datasets/readers/e/one.h", "datasets/readers/f/two.h")
    write("datasets/readers/f/two.h", "datasets/readers/g.h")
    assert check(scratch)[1] == [], "a circle was found where there is none"
    write("datasets/readers/g.h", "datasets/readers/e/one.h")
    files, found = check(scratch)
    assert found == [("datasets/readers/e", "datasets/readers/f", "datasets/readers/g")], found
    (scratch / "datasets/readers/g.h").unlink()
    write("app/d/three.h", "haptics/a/one.h")
    files, found = check(scratch)
    assert found == [("app/d", "haptics/a", "haptics/b", "haptics/c")], found
    for n in range(MOST):
        write(f"haptics/b/deep/{n}.cpp")
    assert full(scratch) == ["haptics/b/deep has 26 sources"], full(scratch)


if sys.argv[1] == "--plant":
    plant(pathlib.Path(sys.argv[2]))
else:
    files, found = check(pathlib.Path(sys.argv[1]))
    too_full = full(pathlib.Path(sys.argv[1]))
    for line in too_full:
        print(f"{line}, more than {MOST}: part the folder")
    sys.exit(1 if found or too_full or files < 100 else 0)
