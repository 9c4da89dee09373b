#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of view_file_fuzz to corpus/view_file."""
import copy
import json
import pathlib

VIEW = {
    "palpate_view": 2,
    "scan": {"dims": [4, 5, 6], "spacing_m": [1e-3, 1e-3, 2e-3], "origin_m": [0.0, 0.1, -0.1],
             "direction": [1, 0, 0, 0, -1, 0, 0, 0, 1], "scalar": "int16", "hash": None},
    "edits": [], "isovalue": 300.0, "marks": [],
    "view": {"camera": {"eye_m": [0, -1, 0], "focus_m": [0, 0, 0], "up": [0, 0, 1],
                        "parallel": False, "half_height_m": 0.1},
             "cross_m": [0, 0, 0], "grey": {"level": 200, "width": 1600},
             "slices": [{"zoom": 1, "shift_m": [0, 0]}] * 4,
             "voxels": {"interpolation": "linear", "slab": "none", "thickness_m": 0.005},
             "tool_plane": {"along": False, "depth_m": 0},
             "surface": {"colours": "ivory", "second": None},
             "layout": {"arrangement": "volume_large", "tool_view": False, "active": 0,
                        "alone": False, "shares": []}},
}


def seeds():
    yield "least", VIEW
    marks = copy.deepcopy(VIEW)
    marks["marks"] = [
        {"kind": "distance", "text": "Distance 1", "places_m": [[0, 0, 0], [0.01, 0, 0]]},
        {"kind": "angle", "text": "a", "places_m": [[0, 0, 0], [0.01, 0, 0], [0, 0.02, 0]]},
        {"kind": "point", "text": "p", "places_m": [[0.1, 0.2, 0.3]]},
        {"kind": "note", "text": "thin wall \u00b1", "places_m": [[0, 0, 0]]}]
    yield "marks", marks
    whole = copy.deepcopy(marks)
    whole["scan"]["hash"] = "0123456789abcdef" * 5
    whole["scan"]["place"] = "../scan"
    whole["edits"] = []
    whole["tool"] = "probe"
    whole["view"]["camera"]["parallel"] = True
    whole["view"]["voxels"] = {"interpolation": "nearest", "slab": "mean", "thickness_m": 0.0073}
    whole["view"]["tool_plane"] = {"along": True, "depth_m": -0.0125}
    whole["view"]["surface"] = {"colours": "vessels", "second": -300, "second_opacity": 0.5}
    whole["view"]["layout"] = {"arrangement": "four_up", "tool_view": True, "active": 4,
                               "alone": True,
                               "shares": [[1.25, 0.5, 1.5], [0.75, 1, 1], [1, 1]]}
    yield "whole", whole
    later = copy.deepcopy(VIEW)
    later["palpate_view"] = 3
    yield "later", later
    yield "earlier", {"palpate_view": 1}


folder = pathlib.Path(__file__).parent / "corpus" / "view_file"
folder.mkdir(parents=True, exist_ok=True)
for name, words in seeds():
    (folder / name).write_text(json.dumps(words))
