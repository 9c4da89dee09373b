# SPDX-License-Identifier: BSD-3-Clause
"""What a run of packaging/test came to: the time of each phase, the longest tests, and the counts.

test_report.py ROOT LENGTH CACHE: reads build/test.phases (preset, phase, seconds, status), the tests that
ctest wrote to build/PRESET.tests.xml, and ccache's log. Prints a summary, whose last line is
"N passed, N failed", and writes build/test.json; after --all also tests/last_all_run.json. Exit code 1
if anything failed.
"""
import collections
import json
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

LONGEST = 20


def minutes(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def tests_of(path):
    """Each test of a preset: its name, what happened to it, and its seconds."""
    for case in xml.etree.ElementTree.parse(path).getroot().iter("testcase"):
        if case.find("skipped") is not None:
            outcome = "skipped"
        else:
            outcome = "passed" if case.get("status") == "run" else "failed"
        yield {"preset": path.name.removesuffix(".tests.xml"), "name": case.get("name"), "outcome": outcome,
               "seconds": round(float(case.get("time")), 2)}


def compiled(log):
    """How many compilations ccache answered, and how many it passed on."""
    lines = log.read_text().splitlines() if log.is_file() else []
    return {"from the cache": sum(line in ("direct_cache_hit", "preprocessed_cache_hit") for line in lines),
            "by the compiler": lines.count("cache_miss")}


def commit_of(root):
    def git(*words):
        return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True).stdout.strip()

    # what the run itself writes is no change
    changed = [line for line in git("status", "--porcelain").splitlines() if "tests/last_all_run.json" not in line]
    return git("rev-parse", "HEAD") + (", changed" if changed else "")


def main():
    root, length, cache = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    build = root / "build"
    phases = []
    for line in (build / "test.phases").read_text().splitlines():
        preset, name, seconds, status = line.split("\t")
        phases.append({"preset": preset, "phase": name, "seconds": int(seconds), "failed": status != "0"})
    tests = [test for path in sorted(build.glob("*.tests.xml")) for test in tests_of(path)]
    counts = collections.Counter(test["outcome"] for test in tests)
    # a build that failed, or a ctest that never ended, is a failure of its own
    reported = {test["preset"] for test in tests}
    broken = [phase for phase in phases if phase["failed"] and
              (phase["phase"] != "testing" or phase["preset"] not in reported)]
    longest = sorted(tests, key=lambda test: -test["seconds"])[:LONGEST]
    report = {
        "length": length, "commit": commit_of(root), "cores": os.cpu_count(), "cache": cache == "ON",
        "compiled": compiled(build / "ccache.log"), "seconds": sum(phase["seconds"] for phase in phases),
        "passed": counts["passed"], "failed": counts["failed"] + len(broken), "skipped": counts["skipped"],
        "not_passed": [test for test in tests if test["outcome"] != "passed"],
        "phases": phases, "longest": longest,
    }
    text = json.dumps(report, indent=1) + "\n"
    (build / "test.json").write_text(text)
    if length == "all":
        (root / "tests/last_all_run.json").write_text(text)

    print("\nThe phases:")
    for phase in phases:
        print(f"  {minutes(phase['seconds']):>6}  {phase['preset']} {phase['phase']}"
              + (", FAILED" if phase["failed"] else ""))
    print(f"  {minutes(report['seconds']):>6}  in all; {report['compiled']['from the cache']} compilations from the "
          f"cache, {report['compiled']['by the compiler']} by the compiler")
    print("The longest tests:")
    for test in longest:
        print(f"  {test['seconds']:6.1f} s  {test['preset']} {test['name']}")
    for test in report["not_passed"]:
        print(f"{test['outcome']}: {test['preset']} {test['name']}")
    for phase in broken:
        print(f"failed: {phase['preset']} {phase['phase']}")
    print(f"All of this is in {build / 'test.json'}.")
    print(f"{report['passed']} passed, {report['failed']} failed")
    return 1 if report["failed"] or not report["passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
