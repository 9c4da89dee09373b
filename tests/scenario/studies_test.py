#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A study in its quick form, as a user runs it: the whole, in shards, stopped and taken up again.

    studies_test.py PALPATE_CLI SCHEMA STUDY FOLDER SHARDS

Runs the last two of so many shards: 2 are the whole study, more are a part of it, its quickest jobs, in
which the same is looked at. What the studies measure in time is not asserted; what must hold at any speed is.
"""

import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: results.json cannot be checked; skipped.")
    sys.exit(77)


def study(program, *arguments):
    return subprocess.run([program, "study", *arguments], capture_output=True, text=True)


def filled_pipe():
    """Both ends of a pipe into which nothing more goes: who writes waits until it is read."""
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    for size in (4096, 1):
        try:
            while True:
                os.write(writing, b" " * size)
        except BlockingIOError:
            pass
    os.set_blocking(writing, True)
    return reading, writing


def read(folder):
    return json.loads((folder / "results.json").read_text())


def stopped(program, name, shard, folder):
    """The exit code of a study that is stopped after its first job: 0 if that was too late."""
    told, telling = filled_pipe()
    begun = subprocess.Popen([program, "study", name, "--quick", "--shard", shard, "--out", str(folder)],
                             stdout=subprocess.DEVNULL, stderr=telling)
    os.close(telling)
    while begun.poll() is None and not list((folder / "jobs").glob("*.json")):
        time.sleep(0.02)
    begun.send_signal(signal.SIGINT)
    with open(told, "rb") as words:  # until here it could not tell of its first job, and so not go on
        words.read()
    code = begun.wait(timeout=900)
    assert code in (0, 130), f"stopped it exits with {code}, not 130"
    return code


def main():
    program, schema, name, root, shards = sys.argv[1:6]
    root, shards = pathlib.Path(root), int(shards)
    is_whole = shards == 2
    shutil.rmtree(root, ignore_errors=True)
    schema = json.loads(pathlib.Path(schema).read_text())

    # the first of the shards: begun, stopped, and taken up again
    first, second, whole = root / "first", root / "second", root / "whole"
    for _ in range(5):  # jobs that take milliseconds may all be done before it is stopped
        if stopped(program, name, f"{shards - 1}/{shards}", first) == 130:
            break
        shutil.rmtree(first)
    assert first.exists(), "it was never stopped before its last job"
    some = read(first)
    assert some["jobs"] and some["missing"], "stopped, a study keeps what is done and says what is not"
    done = {job["job"]: job["seconds"] for job in some["jobs"]}
    for n, folder in ((shards - 1, first), (shards, second)):
        ended = study(program, name, "--quick", "--shard", f"{n}/{shards}", "--out", str(folder))
        assert ended.returncode == 0, ended.stderr
    for job in read(first)["jobs"]:
        if job["job"] in done:
            assert job["seconds"] == done[job["job"]], f"{job['job']} was run twice"
    assert not {job["job"] for job in read(first)["jobs"]} & {job["job"] for job in read(second)["jobs"]}

    # put together they are the whole, in which nothing is left to run, or say what is missing
    ended = study(program, "merge", str(first), str(second), "--out", str(whole), "--json")
    assert ended.returncode == (0 if is_whole else 4), ended.stderr
    assert is_whole or "jobs were not run yet" in ended.stderr, ended.stderr
    if is_whole:
        merged = (whole / "results.json").read_text()
        ended = study(program, name, "--quick", "--out", str(whole), "--json")
        assert (whole / "results.json").read_text() == merged
    results = read(whole)
    jsonschema.validate(results, schema)
    assert bool(results["missing"]) != is_whole, results["missing"]
    assert {job["job"] for job in results["jobs"]} == {job["job"] for half in (first, second)
                                                       for job in read(half)["jobs"]}
    print(f"{name}: {sum(job['seconds'] for job in results['jobs']):.0f} s, {len(results['cases'])} cases")
    printed = json.loads(ended.stdout)
    assert printed["cases"] == results["cases"], "--json prints the cases of results.json"

    # every case holds
    failing = [case for case in results["cases"] if not case["pass"]]
    for case in failing:
        print(f"does not hold: {case['name']}: {case['value']} {case['unit']}, "
              f"{case['sense']} {case['bound']}; {case['note']}")
    assert not failing
    assert ended.returncode == (0 if is_whole else 4), ended.returncode
    assert len(results["cases"]) == len({case["name"] for case in results["cases"]}), "names twice"

    # the page is well-formed, asks for nothing, and shows every plot
    html = (whole / "report.html").read_text()
    page = xml.etree.ElementTree.fromstring(html.replace("<!DOCTYPE html>", "", 1))
    assert not [tag for tag in page.iter() if {"src", "href"} & set(tag.attrib)]
    def is_zero(plot):  # a sentence in place of a diagram
        values = [value for one in plot["series"] for point in one["points"] for value in point[1:4] if value is not None]
        return bool(values) and not any(values)

    titles = {plot["title"] for job in results["jobs"] for plot in job["plots"] if not is_zero(plot)}
    shown = {"".join(caption.itertext()) for caption in page.iter("figcaption")}
    assert titles == shown, titles ^ shown
    for image in page.iter("svg"):
        assert image.find("title").text and image.find("desc").text

    rows = list(csv.DictReader((whole / "results.csv").open()))
    assert sum(row["kind"] == "case" for row in rows) == len(results["cases"])
    assert all(None not in row and None not in row.values() for row in rows)

    # two studies are not mixed
    refused = study(program, name, "--quick", "--seed", "2", "--out", str(whole))
    assert refused.returncode == 3 and "mixed" in refused.stderr, refused.stderr
    # a case that does not hold, planted in what one job wrote, is exit code 4, and named first
    planted = root / "planted"
    shutil.copytree(whole, planted)
    for path in sorted((planted / "jobs").iterdir()):
        job = json.loads(path.read_text())
        if not job["outcome"]["cases"]:
            continue
        case = job["outcome"]["cases"][0]
        case["value"] = case["bound"] + (1 if case["sense"] == "at most" else -1)
        path.write_text(json.dumps(job))
        break
    ended = study(program, "merge", str(planted), "--out", str(root / "told"))
    assert ended.returncode == 4 and "1 cases do not hold" in ended.stderr, ended
    page = xml.etree.ElementTree.fromstring(
        (root / "told" / "report.html").read_text().replace("<!DOCTYPE html>", "", 1))
    assert case["name"] in {"".join(cell.itertext()) for cell in page.iter("td")}

    for wrong in (["--shard", "3/2"], ["--shard", "1"], ["--shard", "0/2"], []):
        arguments = wrong + ["--out", str(root / "x")] if wrong else []
        assert study(program, name, *arguments).returncode == 2, wrong
    assert study(program, name, "--quick", "--out", "/proc/none").returncode == 4


if __name__ == "__main__":
    main()
