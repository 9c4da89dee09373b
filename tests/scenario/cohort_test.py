#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cohorts: the same tables however the work is split, and bad manifests refused by name.

Usage: cohort_test.py PALPATE-CLI WORK
"""
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

CLI, WORK = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
NAME = "Mustermann"  # a name in a path: it must stand in no output
TABLES = ("group_touches.tsv", "group_replays.tsv")
HOW = ("--seconds", "1.2", "--hand", "tap,slide", "--tool", "sphere")


def cli(*words, expect=0):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != expect:
        raise AssertionError(f"{words}: exit {done.returncode}, not {expect}\n{done.stderr}")
    return done


def rows(folder, table="group_touches.tsv"):
    with open(folder / table, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))


def tables(folder):
    return [(folder / table).read_bytes() for table in TABLES]


class Cohort(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        cls.scans = WORK / NAME
        cls.scans.mkdir(parents=True)
        for phantom in ("sphere", "slot", "wedge"):
            cli("convert", "--phantom", phantom, cls.scans / f"{phantom}.nrrd")
        (cls.scans / "torn.nrrd").write_bytes((cls.scans / "slot.nrrd").read_bytes()[:5000])
        cli("run", "--volume", cls.scans / "sphere.nrrd", "--isovalue", "0", "--tool", "sphere", "--hand",
            "tap", "--seconds", "0.5", "--stiffness", "500", "--record", WORK / "tap.palpate")
        cls.manifest = WORK / "scans.tsv"
        cls.manifest.write_text(
            "label\tpath\tisovalue\trepetitions\trecording\n"
            f"one\t{NAME}/sphere.nrrd\t0\t2\tn/a\n"
            f"two\t{NAME}/slot.nrrd\t0\t\tn/a\n"
            f"torn\t{NAME}/torn.nrrd\t0\t\tn/a\n"
            f"no-unit\t{NAME}/wedge.nrrd\tbone\t\tn/a\n"
            f"again\t{NAME}/sphere.nrrd\t0\t\ttap.palpate\n"
            f"gone\t{NAME}/gone.nrrd\t0\t\tn/a\n", encoding="utf-8")
        cls.serial = WORK / "serial"
        cls.said = cli("cohort", cls.manifest, cls.serial, *HOW)

    def test_each_touch_is_a_row_and_what_cannot_be_read_is_one_with_its_reason(self):
        found = rows(self.serial)
        self.assertEqual([(row["label"], row["hand"], row["repetition"]) for row in found],
                         [("one", "tap", "1"), ("one", "tap", "2"), ("one", "slide", "1"),
                          ("one", "slide", "2"), ("two", "tap", "1"), ("two", "slide", "1"),
                          ("torn", "n/a", "n/a"), ("no-unit", "n/a", "n/a"), ("gone", "n/a", "n/a")])
        for row in found[:6]:
            self.assertEqual((row["status"], row["penetration_mm"], row["verdict"]), ("ok", "0", "sound"))
            self.assertGreater(float(row["contact_share"]), 0.2)
            self.assertGreater(float(row["force_max_N"]), 0.5)
            self.assertGreater(float(row["work_per_tick"]), 0.0)
            self.assertNotEqual(row["left_out"], "n/a")
        self.assertEqual([row["status"] for row in found[6:]], ["refused"] * 3)
        self.assertEqual(found[6]["reason"], "truncated")
        self.assertEqual(found[7]["reason"], "isovalue-needs-hounsfield-units")
        self.assertNotEqual(found[8]["reason"], "n/a")
        replay, = rows(self.serial, "group_replays.tsv")
        self.assertEqual((replay["label"], replay["status"], replay["differing"]), ("again", "ok", "0"))
        self.assertGreater(int(replay["steps"]), 400)
        # the repetitions are other aims
        self.assertNotEqual(found[0]["force_mean_N"], found[1]["force_mean_N"])

    def test_the_same_tables_however_the_work_is_split(self):
        beside = WORK / "beside"
        cli("cohort", self.manifest, beside, *HOW, "--jobs", "2")
        self.assertEqual(tables(beside), tables(self.serial))
        parts = [WORK / f"part{n}" for n in (1, 2, 3)]
        for n, part in enumerate(parts, 1):
            cli("cohort", self.manifest, part, *HOW, "--shard", f"{n}/3")
        merged = WORK / "merged"
        first = cli("cohort", "merge", self.manifest, *parts[:2], "--out", WORK / "less", *HOW, expect=4)
        self.assertRegex(first.stderr, r"not run yet \((one|two|torn|no-unit|again|gone)")
        cli("cohort", "merge", self.manifest, *parts, "--out", merged, *HOW)
        self.assertEqual(tables(merged), tables(self.serial))
        for name in ("index.html", "dataset_description.json", "scans/one.html", "pictures/one_axial.bmp"):
            self.assertTrue((merged / name).is_file(), name)
        # one task was killed and is run again: what it had done is not done anew
        again = WORK / "again"
        shutil.copytree(self.serial / "jobs", again / "jobs")
        (again / "jobs" / "two.json").unlink()
        done = cli("cohort", self.manifest, again, *HOW)
        self.assertIn("1 of 1: two", done.stderr)
        self.assertEqual(tables(again), tables(self.serial))

    def test_a_touch_is_the_run_of_the_same_options(self):
        manifest = WORK / "own.tsv"
        manifest.write_text(f"label\tpath\nown\t{NAME}/sphere.nrrd\n", encoding="utf-8")
        mesh = pathlib.Path(__file__).resolve().parents[2] / "resources" / "tools" / "probe.obj"
        how = {"--isovalue": 0, "--seconds": 1, "--stiffness": 700, "--angular-stiffness": 0.4, "--friction": 0.3,
               "--field": "spline", "--normals": "cell", "--epsilon": 0.1, "--sub-steps": 3, "--budget": 40,
               "--rate": 2000, "--tool-unit": "m"}
        options = [str(word) for pair in how.items() for word in pair]
        out = WORK / "own"
        cli("cohort", manifest, out, *options, "--hand", "tap", "--tool-mesh", mesh, "--seed", "6", "--jobs", "2")
        row, = rows(out)
        run = json.loads(cli("run", "--volume", self.scans / "sphere.nrrd", *options, "--hand", "tap", "--tool", mesh,
                             "--seed", "7", "--json").stdout)
        self.assertEqual((row["status"], row["tool"], row["seed"]), ("ok", "mesh", "7"))
        for column in ("friction", "field", "normals", "epsilon_voxels", "sub_steps", "rate_Hz", "budget_work",
                       "angular_stiffness_Nm_rad", "stiffness_N_m", "seed"):
            told = run["settings"][column]
            self.assertEqual(row[column], told if isinstance(told, str) else f"{told:g}", column)
        for column, value in (("force_max_N", run["max_force_N"]), ("torque_max_Nm", run["max_torque_Nm"]),
                              ("work_per_tick", run["work_per_tick"]), ("contacts_max", run["max_contacts"]),
                              ("coupling_mm", run["coupling_metric_mm"])):
            self.assertAlmostEqual(float(row[column]) / value, 1.0, delta=2e-5, msg=column)
        page = (out / "index.html").read_text()
        self.assertNotIn("probe.obj", page)
        self.assertIn("another manifest", cli("cohort", "merge", manifest, out, "--out", WORK / "no2", *options, "--hand",
                                              "tap", "--tool-mesh", mesh, "--seed", "5", expect=3).stderr)
        for wrong in (("--hand", "wave"), ("--tool", "spoon"), ("--tool", "mesh"), ("--rate", "3000")):
            cli("cohort", manifest, WORK / "no3", "--isovalue", "0", *wrong, expect=2)

    def test_shards_of_another_manifest_or_build_are_refused(self):
        other = cli("cohort", "merge", self.manifest, self.serial, "--out", WORK / "no", "--seconds", "2",
                    "--hand", "tap,slide", "--tool", "sphere", expect=3)
        self.assertIn("another manifest", other.stderr)
        mixed = WORK / "mixed"
        shutil.copytree(self.serial / "jobs", mixed / "jobs")
        job = json.loads((mixed / "jobs" / "one.json").read_text())
        job["build"] = "0123"
        (mixed / "jobs" / "one.json").write_text(json.dumps(job))
        self.assertIn("build", cli("cohort", "merge", self.manifest, mixed, "--out", WORK / "no", *HOW,
                                   expect=3).stderr)

    def test_no_path_and_no_name_is_written(self):
        for path in self.serial.rglob("*"):
            if path.is_file():
                text = path.read_bytes()
                self.assertNotIn(NAME.encode(), text, path)
                self.assertNotIn(str(WORK).encode(), text, path)

    def test_tables_have_dictionaries_and_pages_their_parts(self):
        for name in ("touches", "costs", "replays"):
            table, dictionary = f"group_{name}.tsv", json.loads((self.serial / f"group_{name}.json").read_text())
            self.assertEqual(list(rows(self.serial, table)[0]), list(dictionary))
        description = json.loads((self.serial / "dataset_description.json").read_text())
        self.assertEqual(description["DatasetType"], "derivative")
        page = (self.serial / "index.html").read_text()
        for part in ("Distribution: greatest force", "Refused", "isovalue-needs-hounsfield-units",
                     "scans/two.html"):
            self.assertIn(part, page)
        scan = (self.serial / "scans" / "one.html").read_text()
        self.assertIn("../pictures/one_coronal.bmp", scan)
        self.assertIn("<span class='left'>R</span>", scan)

    def test_another_release_is_compared_row_by_row(self):
        before = WORK / "before"
        shutil.copytree(self.serial, before)
        table = before / "group_touches.tsv"
        lines = table.read_text().splitlines()
        cells = lines[1].split("\t")
        cells[lines[0].split("\t").index("force_max_N")] = "123.5"
        table.write_text("\n".join([lines[0], "\t".join(cells), *lines[2:]]) + "\n")
        out = WORK / "compared"
        cli("cohort", "merge", self.manifest, self.serial, "--out", out, "--before", before, *HOW)
        page = (out / "index.html").read_text()
        self.assertIn("1 of them differ", page)
        self.assertIn("123.5", page)

    def test_a_bids_folder_is_a_manifest(self):
        folder = WORK / "bids"
        for subject in ("01", "02"):
            (folder / f"sub-{subject}" / "ct").mkdir(parents=True)
            shutil.copy(self.scans / "sphere.nrrd", folder / f"sub-{subject}" / "ct" / f"sub-{subject}_ct.nrrd")
        (folder / "derivatives" / "sub-01").mkdir(parents=True)
        shutil.copy(self.scans / "sphere.nrrd", folder / "derivatives" / "sub-01" / "sub-01_x.nrrd")
        out = WORK / "bids-out"
        cli("cohort", folder, out, "--isovalue", "0", *HOW)
        self.assertEqual(sorted({row["label"] for row in rows(out)}), ["sub-01", "sub-02"])

    def test_the_plan_is_of_the_headers(self):
        plan = json.loads(cli("cohort", self.manifest, "--plan", "--json", *HOW).stdout)
        self.assertEqual((plan["lines"], plan["rows"]), (6, 13))
        self.assertGreaterEqual(plan["shards"], 1)
        self.assertGreater(plan["memory_MB"], 200)

    def test_bad_manifests_are_refused_by_name(self):
        good = f"path\tlabel\thand\tisovalue\tseconds\n{NAME}/sphere.nrrd\ta\ttap\t0\t1\n"
        for old, new, words in (
                ("path\t", "pfad\t", "\"pfad\""), ("\ttap", "\ttip", "Line 2.*\"tip\".*tap, slide"),
                ("\t0\t1", "\t0,5\t1", "\"0,5\" in column isovalue"), ("\t0\t1", "\t0\t1s", "\"1s\""),
                ("\t0\t1", "\t0", "4 cells and not 5"), ("\ta\t", "\tMüller Hans\t", "is no label"),
                (f"{NAME}/sphere.nrrd", "", "Line 2 of the manifest has no path"),
                ("\t1\n", f"\t1\n{NAME}/slot.nrrd\ta\ttap\t0\t1\n", "\"a\" is there twice")):
            bad = WORK / "bad.tsv"
            bad.write_text(good.replace(old, new, 1), encoding="utf-8")
            self.assertRegex(cli("cohort", bad, WORK / "bad", expect=3).stderr, words)
            self.assertFalse((WORK / "bad").exists())
        cli("cohort", WORK / "none.tsv", WORK / "bad", expect=3)
        cli("cohort", expect=2)
        cli("cohort", self.manifest, WORK / "bad", "--shard", "3/2", expect=2)

    def test_three_thousand_rows_are_joined(self):
        many = WORK / "many"
        (many / "jobs").mkdir(parents=True)
        template = json.loads((self.serial / "jobs" / "one.json").read_text())
        lines = ["label\tpath"]
        for n in range(750):
            label = f"scan-{n:04d}"
            lines.append(f"{label}\tx.nrrd")
            template["job"] = template["section"] = label
            for table in template["outcome"]["tables"]:
                for row in table["rows"]:
                    row[0] = label
            (many / "jobs" / f"{label}.json").write_text(json.dumps(template))
        manifest = WORK / "many.tsv"
        manifest.write_text("\n".join(lines) + "\n")
        # the study's name is that of the manifest, which merging says where it differs
        wrong = cli("cohort", "merge", manifest, many, "--out", WORK / "all", *HOW, expect=3)
        self.assertIn("manifest", wrong.stderr)
        probe = WORK / "probe"
        cli("cohort", manifest, probe, *HOW, "--shard", "1/750")
        name = json.loads(next((probe / "jobs").iterdir()).read_text())["study"]
        for path in (many / "jobs").iterdir():
            path.write_text(path.read_text().replace(template["study"], name))
        cli("cohort", "merge", manifest, many, "--out", WORK / "all", *HOW)
        self.assertEqual(len(rows(WORK / "all")), 3000)

    def test_gnu_parallel_gives_the_same_tables(self):
        if shutil.which("parallel") is None:
            self.skipTest("there is no GNU parallel here")
        out = WORK / "parallel"
        script = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "cluster" / "parallel"
        path = f"{CLI.parent}:{os.environ['PATH']}"
        subprocess.run([script, self.manifest, out, *HOW], check=True, capture_output=True,
                       env={**os.environ, "PATH": path})
        self.assertEqual(tables(out), tables(self.serial))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
