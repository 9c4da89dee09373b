#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of README.md, haptics/MEASURED.md and results/README.md, all of one commit.

Usage: figures.py measure --scans DATA [--build BUILD]
       figures.py write | check

`measure` runs the measuring programs of BUILD (build/release) one after another, takes their figures into
results/figures.json, and then writes. What a program said is kept in BUILD/figures until the commit changes, so a run
that was stopped continues. It takes two hours on two cores, and refuses changes that are not committed: figures are of
a commit. `write` puts the figures of results/figures.json into the pages, between a line <!-- figures: NAME --> and the
next <!-- end of figures -->. `check` fails where a page says something else.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEPT = ROOT / "tests/bench/results/figures.json"
PAGES = [ROOT / "README.md", ROOT / "haptics/MEASURED.md", ROOT / "tests/bench/results/README.md"]
SCENES = ["bunny", "engine", "hole", "bone"]
SCANS = ["scan-bunny", "scan-engine", "scan-bone", "scan-skin", "scan-tooth"]
NORMALS = ["central", "spline", "cell"]
BUDGETS_US = [100, 200, 500]


def git(*arguments):
    return subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True, check=True).stdout.strip()


class Programs:
    """Runs the measuring programs, or takes what they said before at this commit."""

    def __init__(self, build, commit):
        self.build = build
        self.kept = build / "figures" / commit
        self.kept.mkdir(parents=True, exist_ok=True)

    def bench(self, name, *arguments):
        kept = self.kept / f"{name}.json"
        if not kept.exists():
            print(f"palpate-bench {' '.join(arguments)}", flush=True)
            run = subprocess.run([self.build / "tests/bench/palpate-bench", *arguments, "--json"],
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
            kept.write_text(run.stdout)
        return json.loads(kept.read_text())

    def study(self, name):
        out = self.kept / name
        print(f"palpate-study {name}", flush=True)
        run = subprocess.run([self.build / "app/cli/palpate-study", name, "--out", out], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, check=False)
        if run.returncode not in (0, 4):
            sys.exit(f"palpate-study {name} ended with {run.returncode}.")
        return json.loads((out / "results.json").read_text())


def taken(results, fields, scenes=None, methods=("literal", "accept-inside", "penalty", "god object", "ours")):
    """Of each scene and method the fields, in the order of the program."""
    return [{field: one.get(field) for field in ("scene", "method", *fields)} for one in results
            if one["method"] in methods and (scenes is None or one["scene"] in scenes)]


def measured(programs, scans):
    methods = programs.bench("methods", "--counted", "--no-sweep", "--scans", scans)
    only = [word for scan in SCANS for word in ("--only", scan)]
    normals = {"central": methods}
    for normal in NORMALS[1:]:
        normals[normal] = programs.bench(normal, "--counted", "--no-sweep", "--scans", scans, "--normal", normal, *only)
    rates = programs.bench("rates", "--counted", "--rates", "--hands", "8", "--quick", "--seconds", "1", "--no-sweep",
                           "--scans", scans)
    clock = programs.bench("clock", "--rates", "--quick", "--seconds", "1", "--no-sweep", "--scans", scans)
    flat = programs.bench("flat", "--only", "sweep")
    accuracy = programs.study("accuracy")
    normal_fields = ("coupling_mm", "frozen", "fine_noise_N", "penetration_mm")
    return {
        "machine": methods["machine"],
        "methods": taken(methods["results"], ("mean_us", "p999_us", "coupling_mm", "frozen", "truly_stuck",
                                              "penetration_mm", "wall_passages", "residual_mm_median",
                                              "residual_mm_mean", "surface_step_N", "ideal_step_N", "force_step_N")),
        "normals": {normal: taken(said["results"], normal_fields, SCANS, ("ours",))
                    for normal, said in normals.items()},
        "rates": {"counted": taken(rates["rates"], ("coupling_mm", "frozen"), None, rate_names(rates)),
                  "clock": taken(clock["rates"], ("mean_us", "p999_us", "cut"), None, rate_names(clock))},
        "flat": [row for row in flat["sweep"] if row["scene"] == "flat"],
        "fields": fields_of(accuracy),
    }


def rate_names(said):
    return list(dict.fromkeys(one["method"] for one in said["rates"]))


def fields_of(accuracy):
    """Of each field: medians of position and own normal on three solids, without noise and with, and what is left of
    thin plates."""
    found = {}
    for plot in (plot for job in accuracy["jobs"] for plot in job["plots"]):
        match = re.fullmatch(r"\w+, (no|2 %) noise: (position of the surface|normal)", plot["title"])
        for series in plot["series"]:
            of = found.setdefault(series["name"], {}) if match or plot["title"] == "Thin plates" else {}
            if match:
                key = match.group(2) + ("" if match.group(1) == "no" else ", noise")
                of.setdefault(key, []).extend(point[1] for point in series["points"] if point[5] in ("", "cell"))
            elif plot["title"] == "Thin plates":
                left = {round(point[0], 3): point[1] for point in series["points"]}
                of["left"] = [left[thick] for thick in (0.7, 0.8, 0.9)]
    return found


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(row) + " |" for row in rows)]


def extent(values, form):
    least, most = form.format(min(values)), form.format(max(values))
    return least if least == most else f"{least} to {most}"


def methods_lines(figures):
    rows = []
    for one in figures["methods"]:
        rows.append([one["scene"], one["method"], f"{one['mean_us']:.1f}", f"{one['p999_us']:.0f}",
                     f"{one['coupling_mm']:.2f}", f"{100 * one['frozen']:.1f} %", f"{100 * one['truly_stuck']:.2f} %",
                     f"{one['penetration_mm']:.4f}", str(one["wall_passages"]),
                     f"{one['residual_mm_median']:.4f} / {one['residual_mm_mean']:.3f}"])
    return table(["scene", "method", "mean us", "p99.9 us", "coupling mm", "frozen", "truly stuck", "deepest mm", "walls",
                  "residual median / mean mm"], rows)


def normals_lines(figures):
    rows = []
    for normal in NORMALS:
        at = {one["scene"]: one for one in figures["normals"][normal]}
        rows.append([normal] + [f"{at[scan]['coupling_mm']:.2f}, {100 * at[scan]['frozen']:.1f}, "
                                f"{at[scan]['fine_noise_N']:.3f}" for scan in SCANS])
    return table(["normal", *SCANS], rows)


def slides_lines(figures):
    rows = []
    for one in figures["methods"]:
        if one["method"] == "ours" and one["surface_step_N"] is not None:
            rows.append([one["scene"]] + [f"{one[field]:.3f}" for field in ("surface_step_N", "ideal_step_N",
                                                                          "force_step_N")])
    return table(["", "ball, lowered", "ideal proxy", "Palpate"], rows)


def rates_lines(figures):
    scenes = list(dict.fromkeys(one["scene"] for one in figures["rates"]["counted"]))

    def all_of(kind, field, scene, form, times=1.0):
        return ", ".join(form.format(times * one[field]) for one in figures["rates"][kind] if one["scene"] == scene)
    rows = [[scene, all_of("clock", "mean_us", scene, "{:.0f}"), all_of("clock", "p999_us", scene, "{:.0f}"),
             all_of("clock", "cut", scene, "{:.1f}", 100.0), all_of("counted", "coupling_mm", scene, "{:.2f}"),
             all_of("counted", "frozen", scene, "{:.1f}", 100.0)] for scene in scenes]
    return table(["scene", "mean [us]", "p99.9 [us]", "cut [%]", "coupling [mm]", "frozen [%]"], rows)


def flat_lines(figures):
    points = sorted({row["points"] for row in figures["flat"]})
    rows = []
    for count in points:
        at = {row["budget_us"]: row["lag_mm"] for row in figures["flat"] if row["points"] == count}
        if all(budget in at for budget in BUDGETS_US):
            rows.append([f"{count:,}"] + [f"{at[budget]:.3f}" for budget in BUDGETS_US])
    return table(["points"] + [f"{budget} us" for budget in BUDGETS_US], rows)


def fields_lines(figures):
    rows = []
    for field, of in figures["fields"].items():
        rows.append([field] + [extent(of[key], form) for key, form in
                               (("position of the surface", "{:.3f}"), ("normal", "{:.2g}"),
                                ("position of the surface, noise", "{:.3f}"), ("normal, noise", "{:.1f}"))] +
                    [", ".join(f"{100 * left:.0f}" for left in of["left"]) + " %"])
    return table(["", "position", "normal", "position, noise", "normal, noise",
                  "what is left of a plate of 0.7, 0.8, 0.9 voxel"], rows)


def commit_lines(figures):
    machine = figures["machine"]
    return [f"Of {figures['commit']}, on {machine['cpu']} ({machine['cores']} cores, {machine['vectors']}, "
            f"{machine['compiler']})."]


def readme_lines(figures):
    ours = [one for one in figures["methods"] if one["method"] == "ours" and one["scene"] in SCANS]
    literal = [one for one in figures["methods"] if one["method"] == "literal" and one["scene"] in SCANS]
    inside = max(one["penetration_mm"] for one in ours)
    frozen, stuck = [[100 * one[field] for one in ours] for field in ("frozen", "truly_stuck")]
    results = "[results](tests/bench/results/README.md)"
    return [
        f"- **{inside:g} mm**: the deepest point of the tool inside the surface, for every simulated hand on five CT "
        "scans, judged by an independent [evaluator](tests/README.md).",
        f"- **{extent(stuck, '{:.1f}')} %** of contact ticks with the tool truly stuck, at 1000 N/m and 1 kHz: it stands "
        "still behind a moving hand, although a place within 0.5 mm is nearer to the hand. It stands still, rightly or "
        f"not, in {extent(frozen, '{:.0f}')} %; with the paper's algorithm in "
        f"{extent([100 * one['frozen'] for one in literal], '{:.0f}')} % ({results}).",
        f"- **{extent([one['mean_us'] for one in ours], '{:.0f}')} µs** of a tick's 1,000 µs ({results}, all of "
        f"{figures['commit']}). [What does not hold](app/study/README.md#what-does-not-hold)",
    ]


LINES = {"how well it works": readme_lines, "methods": methods_lines, "normals": normals_lines, "slides": slides_lines,
         "rates": rates_lines, "flat": flat_lines, "fields": fields_lines, "commit": commit_lines}


def page_with(text, figures):
    def region(match):
        lines = LINES[match.group(1)](figures)
        return f"<!-- figures: {match.group(1)} -->\n" + "\n".join(lines) + "\n<!-- end of figures -->"
    return re.sub(r"<!-- figures: ([a-z ]+) -->\n.*?<!-- end of figures -->", region, text, flags=re.S)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["measure", "write", "check"])
    parser.add_argument("--scans")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    options = parser.parse_args()
    if options.what == "measure":
        if not options.scans:
            parser.error("measure needs --scans DATA, the folder of scans")
        if git("status", "--porcelain", "--untracked-files=no"):
            sys.exit("There are changes that are not committed: figures are of a commit. Commit them, build, and retry.")
        commit = git("rev-parse", "--short=8", "HEAD")
        KEPT.write_text(json.dumps({"commit": commit, **measured(Programs(options.build, commit), options.scans)},
                                   indent=1) + "\n")
    figures = json.loads(KEPT.read_text())
    stale = []
    for page in PAGES:
        text = page.read_text()
        wanted = page_with(text, figures)
        if options.what != "check":
            page.write_text(wanted)
        elif text != wanted:
            stale.append(str(page.relative_to(ROOT)))
    if stale:
        sys.exit(f"{', '.join(stale)}: other figures than those of {KEPT.relative_to(ROOT)}; run tests/bench/figures.py "
                 "write.")


if __name__ == "__main__":
    main()
