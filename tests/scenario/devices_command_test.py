#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate-cli devices: what is known of haptic devices, on a machine that has some or none.

Use: devices_command_test.py PALPATE-CLI
"""
import json
import subprocess
import sys

program = sys.argv[1]
TROUBLES = {"none", "not-plugged-in", "no-permission", "no-library", "no-service", "in-use", "no-firmware",
            "not-homed", "needs-calibration", "not-started", "motors-hot", "force-off", "refused", "lost"}
RATED = {"force_N", "continuous_force_N", "torque_Nm", "stiffness_N_m", "angular_stiffness_Nm_rad",
         "damping_Ns_m", "workspace_m", "resolution_m", "rate_Hz"}


def run(*arguments, code=0):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=900)
    assert done.returncode == code, (arguments, done.returncode, done.stdout, done.stderr)
    return done


said = json.loads(run("devices", "--json").stdout)
assert set(said) == {"drivers", "devices"}, said.keys()
devices = said["devices"]
for device in devices:
    assert set(device) == {"id", "name", "sensed", "actuated", "present", "trouble", "why", "rating"}, device
    assert device["name"] and 0 < device["sensed"] <= 7 and 0 <= device["actuated"] <= 7, device
    assert device["trouble"] in TROUBLES and isinstance(device["present"], bool), device
    # a sentence where something is wrong, or only opening tells whether it is here
    assert device["why"] or (device["present"] and device["trouble"] == "none"), device
    rating = device["rating"]
    if rating is not None:
        assert set(rating) == RATED | {"name", "source"} and rating["source"], rating
        assert all(rating[key] >= 0.0 for key in RATED), rating
        assert (rating["force_N"] > 0.0) == (device["actuated"] > 0), device
# each device once, the ones that are here first, every driver at least once
ids = [device["id"] for device in devices]
assert len(set(ids)) == len(ids), ids
present = [device["present"] for device in devices]
assert present == sorted(present, reverse=True), present
assert {i.split(":")[0] for i in ids} == set(said["drivers"]), (ids, said["drivers"])

# people get the same lines
table = run("devices").stdout
for device in devices:
    assert device["id"] in table and device["why"] in table, (device, table)
assert table.splitlines()[0].split() == ["id", "device", "sensed", "actuated", "force", "state"], table

# it takes no arguments
run("devices", "falcon", code=2)
