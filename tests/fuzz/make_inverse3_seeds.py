# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of inverse3_fuzz: small messages of every kind that it tells apart."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent


def device(name="049D", **more):
    return {"device_id": name, "state": {"cursor_position": {"x": 0.01, "y": -0.12, "z": 0.15}},
            "status": {"calibrated": True, "in_use": False, "power_supply": True, "ready": True,
                       "started": True}, **more}


def grip(**state):
    return {"device_id": "61548",
            "state": {"orientation": {"w": 0.7, "x": 0, "y": 0.7, "z": 0}, **state}}


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else HERE / "corpus/inverse3")
    folder.mkdir(parents=True, exist_ok=True)
    seeds = {
        "inventory": {"session_id": 7, "inverse3": [device(config={
            "basis": {"permutation": "XYZ"}, "handedness": "right"})],
            "verse_grip": [grip(button=True, hall=0)]},
        "state": {"inverse3": [device()], "wireless_verse_grip": [grip(
            buttons={"a": True, "b": False, "c": True}, hall=3)]},
        "none": {"inverse3": []},
        "two": {"inverse3": [device("A1"), device("B-2_x")]},
        "not-ready": {"inverse3": [device(status={"calibrated": False, "ready": True})]},
        "other-basis": {"inverse3": [device(config={"basis": {"permutation": "XZY"}})]},
        "old": {"inverse3": {"049D": {"state": {"cursor_position": {"x": 0, "y": 0, "z": 0}}}}},
    }
    for name, seed in seeds.items():
        (folder / name).write_text(json.dumps(seed))
    (folder / "deep").write_text('{"inverse3":' + "[" * 200)


main()
