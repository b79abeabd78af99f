#!/usr/bin/python3
"""outside: every number in Python is that of the command line's JSON and CSV, to the last bit, for the shipped examples and the spicules."""
import concurrent.futures
import csv
import importlib.util
import io
import json
import math
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import flexslip
from package import DESIGN, EXAMPLES, SOURCE, SPICULES, campaign_of_examples, case, fitted, told

os.chdir(SOURCE)


class Json(unittest.TestCase):
    """The text of to_json() is the program's: so are names, order and bits."""

    maxDiff = 2000

    def same(self, answer, *call):
        self.assertEqual(answer.to_json(), told(*call, "--json", "--quiet"))

    def test_outside_fit(self):
        for name in EXAMPLES:
            for model in "roughness", "constant":
                with self.subTest(name, model=model):
                    self.same(flexslip.fit(case(name), model=model), "fit", case(name), "--model", model)

    def test_outside_fit_with_options(self):
        self.same(flexslip.fit(case("simulated"), false_alarms=1, suspect_limit=0.4), "fit", case("simulated"),
                  "--false-alarms", "1", "--suspect-limit", "0.4")
        self.same(flexslip.fit(case("surface")), "fit", case("surface"))

    def test_outside_fit_of_keywords_is_that_of_flags(self):
        """To the letter, but that what is to be done is said in keys to who has no flags."""
        by_keywords = flexslip.fit("examples/simulated/test.csv", diameter="34.8 um", span="1278 um", stiffness="90.65 N/m", stage="stage", force="force").to_json()
        by_flags = told("fit", "examples/simulated/test.csv", "--diameter", "34.8 um", "--span", "1278 um", "--stiffness", "90.65 N/m", "--stage", "stage",
                        "--force", "force", "--json", "--quiet")
        for here, there in zip(by_keywords.split("\n"), by_flags.split("\n"), strict=True):
            if here != there:
                self.assertRegex(here, r'^ *"(remedy|next)": "[^-]*\[rig\]')
                self.assertRegex(there, r'^ *"(remedy|next)": ".*--')

    def test_outside_fit_with_a_key_changed(self):
        for given in ({"set": {"rig.stiffness": "100 N/m"}}, {"stiffness": 100.0}, {"rig": {"stiffness": "0.1 N/mm"}}):
            fit = flexslip.fit(case("simulated"), **given)
            other = json.loads(told("fit", case("simulated"), "--set", "rig.stiffness=100 N/m", "--json"))
            self.assertEqual(json.loads(fit.to_json()), other)

    def test_outside_a_fit_without_an_answer(self):
        fit = flexslip.fit(case("simulated"), modulus="1 GPa")
        self.assertFalse(fit.success)
        self.assertIn("the columns and their units", fit.message)
        self.assertEqual(fit.to_json(), told("fit", case("simulated"), "--set", "specimen.modulus=1 GPa", "--json"))

    def test_outside_simulate(self):
        for name in "simulated", "cracked", "cyclic":
            truth = f"examples/{name}/truth.toml"
            with self.subTest(name):
                self.same(flexslip.simulate(truth), "simulate", truth)
                self.same(flexslip.simulate(truth, energies=True, noise="10 uN", seed=7, points=50), "simulate", truth, "--energies", "--noise",
                          "10 uN", "--seed", "7", "--points", "50")
                self.same(flexslip.simulate(truth, noise=1e-5, seed=7), "simulate", truth, "--noise", "1e-5 N", "--seed", "7")

    def test_outside_friction_profile(self):
        for name in EXAMPLES:
            self.same(flexslip.friction_profile(case(name)), "invert", case(name))

    def test_outside_design(self):
        self.same(flexslip.design(DESIGN), "design", DESIGN)
        self.same(flexslip.design(DESIGN, decide=True, noise="10 uN"), "design", DESIGN, "--decide", "--noise", "10 uN")
        self.same(flexslip.design(DESIGN, over={"stiffness": ("10 N/m", 1000.0, 9), "mu0": (0, 1, 5)}), "design", DESIGN, "--over",
                  "stiffness=10 N/m:1000 N/m:9", "--over", "mu0=0:1:5")
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/open.toml"  # its friction is not stated
            text = pathlib.Path(DESIGN).read_text(encoding="utf-8")
            pathlib.Path(path).write_text(text[:text.index("[friction]")] + text[text.index("[stage]"):], encoding="utf-8")
            self.same(flexslip.design(path), "design", path)
            self.assertEqual([each.parameter for each in flexslip.design(path).open.ranges], ["mu0", "amplitude", "wavelength"])
            with self.assertWarnsRegex(UserWarning, "amplitude is not stated: the map is for 0.175"):
                flexslip.design(path, over={"mu0": (0, 1, 3)})

    def test_outside_equilibrium(self):
        self.same(flexslip.equilibrium(DESIGN), "equilibrium", DESIGN)
        self.same(flexslip.equilibrium(DESIGN, points=77, longest=1.7e-3), "equilibrium", DESIGN, "--points", "77", "--longest", "1.7 mm")
        self.same(flexslip.equilibrium(DESIGN, roller_radius="50 um"), "equilibrium", DESIGN, "--set", "rig.roller_radius=50 um")
        self.same(flexslip.equilibrium_region(DESIGN, points=30, levels=7), "equilibrium", DESIGN, "--region", "--points", "30", "--levels", "7")

    def test_outside_modulus(self):
        for name in EXAMPLES:
            self.same(flexslip.modulus(case(name)), "modulus", case(name))
        self.same(flexslip.modulus(case("simulated"), friction_range=(0.2, 0.4)), "modulus", case("simulated"), "--friction", "0.2", "0.4")
        self.same(flexslip.modulus(case("simulated"), friction_range=0.3), "modulus", case("simulated"), "--friction", "0.3")
        self.same(flexslip.modulus(case("simulated"), window=(0.1, "40 %")), "modulus", case("simulated"), "--window", "0.1", "40 %")
        other = flexslip.modulus(case("simulated"), window=(0.999, 1))
        self.assertFalse(other.success)
        self.assertIn("does not rise linearly", other.message)

    def test_outside_sweep_has_the_numbers_of_the_programs_table(self):
        import pandas

        axes = {"stiffness": ("10 N/m", 1000.0, 5, "log"), "mu0": [0.3, 0.5], "diameter": ["34.8 um", "2 mm"]}  # of which the last makes no beam
        found = flexslip.sweep(DESIGN, axes=axes, threads=2)
        table = told("sweep", DESIGN, "--set", 'sweep.method="grid"', "--set", 'sweep.axes.stiffness={from="10 N/m",to="1000.0 N/m",points=5,spacing="log"}',
                     "--set", "sweep.axes.mu0=[0.3,0.5]", "--set", 'sweep.axes.diameter=["34.8 um","2 mm"]', "--quiet")
        written = pandas.read_csv(io.StringIO(table), float_precision="round_trip")
        units = found.attrs["units"]
        self.assertEqual([name if units.get(name, "1") == "1" else f"{name} [{units[name]}]" for name in found.columns], list(written.columns))
        pandas.testing.assert_frame_equal(found, written.set_axis(found.columns, axis=1), check_exact=True)
        self.assertEqual(sorted(set(found.status)), ["impossible", "ok"])
        self.assertTrue(found.snaps[found.status == "impossible"].isna().all())
        one = flexslip.design(DESIGN, stiffness=float(found.stiffness[4]), set={"friction.mu0": float(found.mu0[4])})
        self.assertEqual(found.snaps[4], one.snaps)
        sampled = flexslip.sweep(DESIGN, axes={"mu0": (0.1, 0.6), "stiffness": (20.0, 200.0, "log")}, samples=8, seed=3)
        self.assertEqual((len({*sampled.mu0}), sampled.snaps.dtype.kind), (8, "i"))

    def test_outside_campaign(self):
        self.same(flexslip.campaign("examples"), "campaign", "examples")

    def test_outside_read(self):
        for file in sorted(SOURCE.glob("tests/instruments/fixtures/*.csv"))[:12]:
            if text := told("read", file, "--json"):
                self.assertEqual(flexslip.read(file).to_json(), text, file)


    @unittest.skipUnless(importlib.util.find_spec("openpyxl"), "no openpyxl to write a workbook with")
    def test_outside_read_a_sheet_of_a_workbook(self):
        import openpyxl

        book = openpyxl.Workbook()
        for title in "first", "second":
            sheet = book.create_sheet(title)
            sheet.append(["Extension (mm)", "Load (N)"])
            for i in range(30):
                sheet.append([i / 8, i / 3 + len(title)])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "tests.xlsx"
            book.save(path)
            for sheet in "second", 3:
                export = flexslip.read(path, sheet=sheet)
                self.assertEqual(export.to_json(), told("read", path, "--sheet", sheet, "--json"))
                self.assertEqual(export.si("force")[0], 6)


def columns(text):
    rows = list(csv.reader(io.StringIO(text)))
    return {title.split(" [")[0]: [float(cell) if cell.replace(".", "").replace("-", "").replace("e", "").isdigit() or cell == "nan" else cell
                                   for cell in cells] for title, *cells in zip(*rows)}


class Tables(unittest.TestCase):
    """Arrays are the columns of the files that the program writes."""

    def same(self, table, text, titles):
        written = columns(text)
        for name, title in titles.items():
            np.testing.assert_array_equal(np.asarray(table.column(name), dtype=float), np.array(written[title]), name)

    def test_outside_curves_profile_and_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            base = pathlib.Path(folder)
            told("fit", case("simulated"), "--quiet", "--curves", base / "c", "--profile", base / "p", "--draws", base / "d")
            fit = fitted("simulated")
            same = {name: name for name in ("model_force", "replay_force", "mu", "mu_error")}
            self.same(fit.curves, (base / "c").read_text(), {"stage": "w_s", "deflection": "w", "force": "F", "length": "S", **same})
            self.same(fit.profile, (base / "p").read_text(), {"length": "S", "mu": "mu", "mu_error": "mu_error"})
            drawn = columns((base / "d").read_text())
            np.testing.assert_array_equal(fit.draws.length, drawn["length"])
            self.assertEqual(fit.draws.profiles.shape, (20, len(drawn["mu"])))
            for k in range(20):
                np.testing.assert_array_equal(fit.draws.profiles[k], drawn[f"draw_{k + 1}"])

    def test_outside_states_on_rollers(self):
        w, q = np.linspace(0.02, 0.4, 20), np.linspace(-0.5, 1, 20)
        supports = {"roller_radius": 0.078, "thickness": 0.0125}
        flags = "--roller-radius", "0.078", "--thickness", "0.0125"
        with tempfile.TemporaryDirectory() as folder:
            def written(*call, **rows):
                path = pathlib.Path(folder) / "rows.csv"
                path.write_text("\n".join([",".join(rows), *(",".join(map(repr, row)) for row in zip(*(column.tolist() for column in rows.values())))]))
                return columns(told(*call, path, *flags))

            states = flexslip.elastica_on_rollers(w, q, **supports)
            by_program = written("state", w=w, q=q)
            for name in states._fields:
                np.testing.assert_array_equal(getattr(states, name), by_program[name], name)
            back = flexslip.elastica_on_rollers_inverse(w, states.F, **supports)
            by_program = written("invert", w=w, F=states.F)
            for name in back._fields:
                np.testing.assert_array_equal(getattr(back, name), by_program[name], name)
            seen = w >= 2 * 0.0125
            np.testing.assert_allclose(back.q[seen], q[seen], atol=1e-8)  # F tells q where w is 20 times its error of 1e-11 and more

    def test_outside_campaign_report_is_that_of_the_program_and_goes_on_from_it(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder) / "ours", pathlib.Path(folder) / "theirs"
            campaign = flexslip.campaign("examples", report=ours, figures=False)
            told("campaign", "examples", "--quiet", "--report", theirs, "--no-figures")
            for path in sorted(theirs.rglob("*")):
                if path.is_file() and path.suffix != ".xlsx":
                    self.assertEqual((ours / path.relative_to(theirs)).read_bytes(), path.read_bytes(), path.name)
            frame = campaign.to_frame()
            written = columns((theirs / "tests.csv").read_text())
            np.testing.assert_array_equal(frame["mu0"].to_numpy(), written["mu0"])
            self.assertEqual(list(frame.index), written["test"])

    def test_identity_a_record_of_arrays_has_the_numbers_of_its_file(self):
        export = flexslip.read("examples/simulated/test.csv")
        keys = {"diameter": "34.8 um ± 0.1 %", "modulus": ("29.6 GPa", "888 MPa"), "span": "1278 um ± 0.1 %", "stiffness": "90.65 N/m ± 0.1 %", "material": "glass",
                "support_material": "steel", "supports": "edges", "record": {"gain_error": "0.1 %", "preload_error": "0 um"}}
        of_file = fitted("simulated").to_dict()
        of_arrays = flexslip.fit(stage=export.si("crosshead"), force=export.si("force"), **keys).to_dict()
        in_units = flexslip.fit(stage=(export.si("crosshead") * 1e6, "um"), force=list(export.si("force")), **keys).to_dict()
        for name in of_file:
            if name not in ("name", "provenance", "preparation"):
                self.assertEqual(json.dumps(of_file[name]), json.dumps(of_arrays[name]), name)
        self.assertTrue(math.isclose(in_units["parameters"]["mu0"]["value"], of_file["parameters"]["mu0"]["value"], rel_tol=1e-6))


class Spicules(unittest.TestCase):
    """The campaign of the paper's 26 tests, in ten lines."""

    @unittest.skipUnless(SPICULES.is_dir(), "no campaign data in ../shared/data/spicules")
    def test_outside_campaign_of_the_spicules_in_ten_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            table, common = pathlib.Path(folder) / "cases.csv", pathlib.Path(folder) / "common.toml"
            # The ten lines.
            import pandas
            rows = pandas.read_csv(SPICULES / "specimens.csv")
            pandas.DataFrame({
                "name": rows.test, "file": [str(SPICULES / "ss" / f"SS{int(name[2:]):02d}.csv") for name in rows.test],
                "bending_stiffness [N m^2]": rows.EI_over_L3_N_per_m * 1278e-6**3, "bending_stiffness uncertainty": "3 %",
                "stiffness [N/m]": rows.cantilever_stiffness_N_per_m, "until": rows.index_of_failure.astype(int)}).to_csv(table, index=False)
            common.write_text(flexslip.Case(span=1278e-6, record=dict(file="-", stage="w_s_m [m]", force="F_N [N]")).toml.replace('file = "-"\n', ""))
            campaign = flexslip.campaign(table, common)
            frame = campaign.to_frame()
            # As many.
            self.assertEqual(len(frame), 26)
            self.assertEqual(campaign.to_json(), told("campaign", table, "--common", common, "--json", "--quiet"))


class Kept(unittest.TestCase):
    def test_identity_what_is_pickled_comes_back_with_all_its_numbers(self):
        for answer in (fitted("cyclic"), flexslip.fit(case("simulated"), modulus="1 GPa"), flexslip.simulate("examples/cyclic/truth.toml"),
                       flexslip.friction_profile(case("simulated")), flexslip.design(DESIGN), flexslip.design(DESIGN, over={"mu0": (0, 1, 3)}),
                       campaign_of_examples(), flexslip.read("examples/simulated/test.csv"), flexslip.equilibrium(DESIGN, points=50),
                       flexslip.equilibrium_region(DESIGN, points=9, levels=5), flexslip.modulus(case("simulated"))):
            again = pickle.loads(pickle.dumps(answer))
            self.assertEqual(again.to_json(), answer.to_json())
            self.assertEqual(repr(again), repr(answer))
            for table in (each for each in (getattr(answer, "designs", None), getattr(answer, "curves", None), getattr(answer, "curve", None)) if each is not None):
                self.assertEqual(pickle.loads(pickle.dumps(table[0])).to_dict(), table[0].to_dict())
            if hasattr(answer, "to_frame"):
                self.assertTrue(again.to_frame().equals(answer.to_frame()), answer)


REDUCED = """reduced = true
[rig]
stiffness = 30
[friction]
model = "rough"
mu0 = 0.6
rms = 0.1
correlation_length = 0.01
seed = 3
[stage]
program = [0, 0.5, 0.2]
step = 0.002
"""


class Reduced(unittest.TestCase):
    """Cases in the model's own variables."""

    def test_outside_a_reduced_case_of_keywords_is_that_of_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "reduced.toml"
            path.write_text(REDUCED)
            of_file = flexslip.simulate(path)
            self.assertEqual(of_file.to_json(), told("simulate", path, "--json"))
        of_keywords = flexslip.simulate(reduced=True, stiffness=30, friction={"model": "rough", "mu0": 0.6, "rms": 0.1, "correlation_length": 0.01, "seed": 3},
                                        stage={"program": [0, 0.5, 0.2], "step": 0.002})
        self.assertEqual(of_keywords.to_json(), of_file.to_json())
        self.assertEqual(of_file.to_frame().attrs["units"]["force"], "EI/L^2")
        self.assertIn("EI/L^2", str(of_file.path.describe()))
        fit = flexslip.fit(reduced=True, stiffness=30, bending_stiffness=("fit"), stage=of_file.path.stage[:250], force=of_file.path.force[:250])
        self.assertTrue(fit.success, fit.message)
        self.assertEqual(fit.params["wavelength"].unit if "wavelength" in fit.params else fit.params["correlation_length"].unit, "L")


class Running(unittest.TestCase):
    """Beside other work."""

    def test_identity_processes_give_the_same(self):
        with concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
            for name, fit in zip(EXAMPLES, pool.map(flexslip.fit, map(case, EXAMPLES))):
                self.assertEqual(fit.to_json(), fitted(name).to_json())

    def test_identity_threads_give_the_same(self):
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for name, fit in zip(EXAMPLES * 2, pool.map(flexslip.fit, map(case, EXAMPLES * 2))):
                self.assertEqual(fit.to_json(), fitted(name).to_json())

    def test_outside_other_threads_run_during_a_fit(self):
        begun, done = threading.Event(), threading.Event()

        def work():
            begun.set()
            flexslip.fit(case("simulated"))
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        begun.wait()
        turns = 0
        while not done.is_set():
            turns += 1
        thread.join()
        self.assertGreater(turns, 100)  # a handful, where the lock is held: a turn takes microseconds, the fit a tenth of a second

    def interrupted(self, call):
        """What a program says in which the call, over and over, meets Ctrl-C."""
        with tempfile.TemporaryDirectory() as folder:
            program = ("import flexslip, os, signal, threading\n"
                       "threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
                       f"while True: {call}\n")
            ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, env={**os.environ, "TMPDIR": folder})
            self.assertEqual(os.listdir(folder), [])
        return ended.stderr

    def test_outside_ctrl_c_ends_what_takes_long(self):
        # Each of the last three takes hours to its end, which none reaches.
        for call in ("flexslip.campaign('examples', jobs=1)", "flexslip.fit('examples/simulated/case.toml')",
                     "flexslip.design('examples/design.toml', over={'stiffness': ('1 N/m', '1e5 N/m', 1000), 'mu0': (0.01, 0.9, 1000)})",
                     "flexslip.sweep('examples/design.toml', axes={'stiffness': ('1 N/m', '1e5 N/m', 1000), 'mu0': (0.01, 0.9, 1000)})",
                     "flexslip.simulate('examples/design.toml', set={'stage.program': [0, '400 um'] * 100000}, stage={'step': 'continuous'}, points=2)"):
            with self.subTest(call):
                self.assertIn("KeyboardInterrupt", self.interrupted(call))


class Errors(unittest.TestCase):
    """How the errors of the parameters go together."""

    def test_identity_a_bending_stiffness_that_is_held_leaves_of_an_error_what_goes_with_nothing(self):
        # Of two that are Gaussian together, the one given the other has sqrt(1 - r^2) of its deviation.
        for name in ("simulated",):
            fit = fitted(name)
            stiffness, r = fit.params.bending_stiffness, fit.correlation().loc["mu0", "bending_stiffness"]
            held = flexslip.fit(case(name), set={"specimen.bending_stiffness": {"value": stiffness.value, "uncertainty": "0.001 %"}, "specimen.modulus": None})
            with self.subTest(name):
                self.assertLess(r, -0.3)
                self.assertAlmostEqual(held.params.mu0.stderr / fit.params.mu0.stderr, math.sqrt(1 - r * r), delta=0.08)

    def test_limit_a_covariance_is_that_of_something(self):
        for name in ("simulated", "cyclic"):
            fit = fitted(name)
            correlation, covariance = fit.correlation(), fit.covariance()
            with self.subTest(name):
                self.assertGreater(np.linalg.eigvalsh(correlation.to_numpy()).min(), -1e-12)
                self.assertEqual(list(correlation.index), list(covariance.columns))
                for parameter in covariance.index:
                    self.assertEqual(covariance.loc[parameter, parameter], fit.params[parameter].stderr ** 2)
        self.assertEqual(flexslip.fit(case("simulated"), model="constant").covariance().shape, (0, 0))


if __name__ == "__main__":
    unittest.main()
