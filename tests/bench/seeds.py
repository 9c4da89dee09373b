#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The quick studies with many seeds: whether every case holds with each of them.

Usage: seeds.py FIRST LAST --out FILE [--study NAME] [--build BUILD] [--at-once N]

Runs `palpate-study accuracy` and `stability` of BUILD (build/release), quick, with each seed from FIRST to LAST, N at a
time, and keeps in FILE (JSON) how many cases there are, which fail, and of each case that has a bound the value that came
nearest to it, with its seed. Seeds that FILE has are not run again; it is of one build. A seed takes some three minutes of
a core. The exit code is 1 if a case fails.
"""

import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(build, study, seed):
    """The results of one quick study."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([build / "app/cli/palpate-study", study, "--quick", "--seed", str(seed), "--out", folder],
                              capture_output=True, text=True, check=False)
        results = pathlib.Path(folder) / "results.json"
        if done.returncode not in (0, 4) or not results.exists():
            sys.exit(f"palpate-study {study} --seed {seed} ended with {done.returncode}: {done.stderr[-500:]}")
        return json.loads(results.read_text())


def room(case):
    """How far from its bound a value is, as a share of the bound; none where the bound is 0 or not a number."""
    if not case["bound"] or case["value"] is None:
        return None
    apart = case["bound"] - case["value"]
    return (apart if case["sense"] == "at most" else -apart) / abs(case["bound"])


def add(kept, seed, results):
    failing = [case["name"] for case in results["cases"] if not case["pass"]]
    kept["seeds"][str(seed)] = {"cases": len(results["cases"]), "failing": failing}
    for case in results["cases"]:
        left = room(case)
        least = kept["nearest"].get(case["name"])
        if left is not None and (least is None or left < least["room"]):
            kept["nearest"][case["name"]] = {"room": left, "value": case["value"], "bound": case["bound"], "seed": seed}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--study", choices=["accuracy", "stability"], action="append")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--at-once", type=int, default=2)
    options = parser.parse_args()
    all_kept = json.loads(options.out.read_text()) if options.out.exists() else {}

    def todo():
        for study in options.study or ["accuracy", "stability"]:
            for seed in range(options.first, options.last + 1):
                if str(seed) not in all_kept.get(study, {}).get("seeds", {}):
                    yield study, seed

    with concurrent.futures.ThreadPoolExecutor(options.at_once) as pool:
        running = {pool.submit(run, options.build, study, seed): (study, seed) for study, seed in todo()}
        for done in concurrent.futures.as_completed(running):
            study, seed = running[done]
            results = done.result()
            kept = all_kept.setdefault(study, {"build": results["build"], "version": results["version"], "seeds": {},
                                               "nearest": {}})
            if kept["build"] != results["build"]:
                sys.exit(f"{options.out} has seeds of another build; name another file.")
            add(kept, seed, results)
            options.out.write_text(json.dumps(all_kept, indent=1) + "\n")
            print(f"{study}, seed {seed}: {len(results['cases'])} cases, {len(kept['seeds'][str(seed)]['failing'])} fail",
                  flush=True)
    failing = False
    for study, kept in all_kept.items():
        cases = [seed["cases"] for seed in kept["seeds"].values()]
        failing_seeds = [seed for seed, of in kept["seeds"].items() if of["failing"]]
        failing = failing or bool(failing_seeds)
        print(f"{study}: {len(cases)} seeds, {sum(cases)} cases, seeds with a case that fails: {failing_seeds or 'none'}")
    sys.exit(1 if failing else 0)


if __name__ == "__main__":
    main()
