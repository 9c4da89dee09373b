#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs palpate-bench in its shortest form and checks its JSON, and what no clock can blur.

Usage: short_form_test.py PALPATE_BENCH
Asserts no time: the machine may be busy.
"""

import json
import math
import subprocess
import sys

RESULT = ["scene", "method", "mean_us", "p50_us", "p99_us", "p999_us", "max_us",
          "coupling_mm", "frozen", "wall_passages", "fine_noise_N", "residual_mm_median",
          "residual_mm_mean", "penetration_mm", "samples_per_tick", "contacts_max"]
RATIO = ["scene", "mean", "p999", "max", "coupling"]
METHODS = ["literal", "charitable", "accept-inside", "penalty", "god object", "ours"]


def main():
    command = [sys.argv[1], "--quick", "--json", "--counted", "--no-sweep", "--rates", "--only", "hole",
               "--seconds", "0.3"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    wrong = []

    def expect(truth, what):
        if not truth:
            wrong.append(what)

    expect(run.returncode == 0, f"exit code {run.returncode}")
    report = json.loads(run.stdout)
    results = report["results"]
    expect([r["method"] for r in results] == METHODS, "the six methods, literal first")
    for result in results:
        for field in RESULT:
            expect(field in result, f"{result.get('method')} has no {field}")
        for field, value in result.items():
            expect(not isinstance(value, float) or math.isfinite(value), f"{field} is not finite")
        expect(result["p50_us"] <= result["p99_us"] <= result["max_us"], "quantiles in order")
        expect(0.0 <= result["frozen"] <= 1.0, "frozen is a share")
    expect([r["scene"] for r in report["ratios"]] == ["hole"], "one ratio a scene")
    for ratio in report["ratios"]:
        for field in RATIO:
            expect(field in ratio, f"ratio has no {field}")
    rates = report["rates"]
    expect([r["method"] for r in rates] == [f"ours, {k} kHz" for k in (1, 2, 4)], "three rates")
    for result in rates:
        expect(result["penetration_mm"] == 0.0, f"{result['method']} is inside")
        expect(result["wall_passages"] == 0, f"{result['method']} passes walls")
        expect(result["ticks"] % (1000 * int(result["method"][6]) // 10) == 0, "ticks by the rate")
    # the same hand, the same proxy: as far from it and as much at rest
    expect(rates[2]["coupling_mm"] < 1.05 * rates[0]["coupling_mm"], "coupling at 4 kHz")
    literal, inside, penalty, ours = results[0], results[2], results[3], results[-1]
    expect(ours["penetration_mm"] == 0.0, f"ours is {ours['penetration_mm']} mm inside")
    expect(ours["wall_passages"] == 0, f"ours passes {ours['wall_passages']} walls")
    # the slow slide is on the flat top, where nothing falls: proxy, ideal proxy and ball agree
    steps = [ours.get(field, math.inf) for field in ("force_step_N", "ideal_step_N", "surface_step_N")]
    expect(0.0 < min(steps) and max(steps) < 0.002, f"the steps of a slow slide are {steps} N")
    # never vacuous: the peg touches, the judge sees who enters and who freezes
    expect(ours["contacts_max"] >= 3, "the peg touches the hole")
    expect(inside["penetration_mm"] > 0.0, "accept-inside penetrates, and is seen to")
    expect(penalty["penetration_mm"] > 0.0, "the penalty method penetrates, and is seen to")
    expect(literal["frozen"] > 0.5, "literal freezes, and is seen to")

    for what in wrong:
        print("WRONG:", what)
    if wrong:
        print(run.stderr)
    print(f"{len(results)} results, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
