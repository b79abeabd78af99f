#!/usr/bin/python3
"""outside: frames and arrays are data, as files are: the same readings give the same answer, however they are handed over."""
import os
import pathlib
import pickle
import shutil
import tempfile
import unittest
import warnings

import numpy as np
import pandas

import flexslip
from package import SOURCE

os.chdir(SOURCE)
SPECIMEN = {"diameter": "34.8 um", "modulus": ("29.6 GPa", "3 %"), "span": "1278 um", "stiffness": "90.65 N/m"}


class Records(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        path = pathlib.Path(folder.name, "test.csv")
        path.write_text("".join((SOURCE / "examples/simulated/test.csv").read_text().splitlines(keepends=True)[:230]))  # the sooner fitted, often
        cls.export = flexslip.read(path)
        cls.stage, cls.force = cls.export.si("crosshead"), cls.export.si("force")
        cls.usual = flexslip.fit(stage=cls.stage, force=cls.force, **SPECIMEN)

    def test_identity_frames_and_arrays_give_the_same_answer(self):
        stage, force = self.stage, self.force
        with_units = pandas.DataFrame({"x": stage, "F": force})
        with_units.attrs["units"] = {"x": "m", "F": "N"}
        for name, arguments, keywords in (
                ("arrays", (stage, force), {}),
                ("export", (self.export.to_frame(),), {}),
                ("own names, in SI", (pandas.DataFrame({"force": force, "stage": stage}),), {}),
                ("own frame", (self.usual.curves.to_frame(),), {}),
                ("titles with units", (pandas.DataFrame({"Weg (m)": stage, "Kraft (N)": force}),), {"displacement": "crosshead"}),
                ("named columns", (with_units,), {"stage": "x", "force": "F"}),
                ("named with units", (pandas.DataFrame({"x": stage, "F": force}),), {"stage": ("x", "m"), "force": ("F", "N")}),
                ("index", (pandas.DataFrame({"force [N]": force}, index=pandas.Index(stage, name="stage [m]")),), {})):
            with self.subTest(name):
                self.assertEqual(flexslip.fit(*arguments, **keywords, **SPECIMEN), self.usual)
        read = flexslip.friction_profile(stage, force, **SPECIMEN)
        self.assertEqual(read, flexslip.friction_profile(stage=stage, force=force, **SPECIMEN))
        frame = pandas.DataFrame({"stage": stage, "force": force})
        self.assertEqual(flexslip.modulus(frame, **SPECIMEN), flexslip.modulus(stage, force, **SPECIMEN))

    def test_identity_the_title_of_a_series_gives_its_unit(self):
        def modulus(stage, force):
            return flexslip.modulus(stage=stage, force=force, **SPECIMEN).modulus.value

        usual, series = modulus(self.stage, self.force), pandas.Series
        frame = self.export.to_frame()  # in µm and mN, as its attrs say
        for stage, force in ((series(1e3 * self.stage, name="Crosshead (mm)"), series(self.force, name="Load (N)")),
                             (series(1e6 * self.stage, name="w_s [µm]"), series(1e3 * self.force, name="F_mN")), (series(1e3 * self.stage, name="Extension_mm"), self.force),
                             (series(self.stage, name="stage"), series(self.force)), (frame.stage, frame.force),
                             ((series(1e3 * self.stage, name="in m"), "mm"), series(self.force, name=3))):
            self.assertAlmostEqual(modulus(stage, force) / usual, 1, delta=1e-9)
        with self.assertRaisesRegex(flexslip.InputError, "^stage: The unit 'N' measures a force, but a unit of length is needed"):
            modulus(series(self.stage, name="Load (N)"), self.force)

    def test_identity_a_frame_of_three_columns_is_fitted_as_its_file(self):
        three = pandas.DataFrame({"w_s_m": self.stage, "w0_m": self.stage - self.force / 90.65, "F_N": self.force})
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "three.csv")
            three.to_csv(path, index=False)
            for keywords in {}, {"displacement": "crosshead"}, {"displacement": "deflection"}:
                with self.subTest(**keywords):
                    of_frame, of_file = flexslip.fit(three, **keywords, **SPECIMEN), flexslip.fit(path, **keywords, **SPECIMEN)
                    self.assertEqual(of_frame, of_file)
                    self.assertEqual("the stage is the column" in of_frame.preparation.done[0], keywords.get("displacement") == "crosshead")
        self.assertEqual(flexslip.fit(three, stage="w_s_m", **SPECIMEN), self.usual)
        with self.assertRaisesRegex(flexslip.InputError, "all three. Leave one out"):
            flexslip.fit(three, stage="w_s_m", deflection="w0_m", force="F_N", **SPECIMEN)

    def test_outside_a_record_in_memory_has_the_name_that_it_is_given(self):
        frame = pandas.DataFrame({"stage": self.stage, "force": self.force})
        self.assertEqual(self.usual.name, "arrays")
        for name in "SS14", "SS14 run 2.1":
            fit = flexslip.fit(frame, name=name, **SPECIMEN)
            self.assertEqual((fit.name, fit.summary().split(":")[0], pickle.loads(pickle.dumps(fit.case)).replace(span="1278 um")), (name, name, fit.case))
            self.assertEqual(fit, self.usual)
            self.assertEqual(flexslip.fit(fit.case).name, name)
        with self.assertRaisesRegex(flexslip.InputError, "^SS15: Only .* at least 30 are needed"):
            flexslip.fit(self.stage[:5], self.force[:5], name="SS15", **SPECIMEN)
        for data, name, needed in (("examples/simulated/case.toml", "SS14", "a record in memory"), (frame, "a/b", "a name without a slash"), (frame, "", "a name without a slash"), (frame, 3, "a name without a slash")):
            with self.assertRaisesRegex(flexslip.InputError, f"^name: This must be {needed}"):
                flexslip.fit(data, name=name)

    def test_outside_cells_without_a_number_are_named(self):
        usual = pandas.DataFrame({"w_s_m": self.stage, "F_N": self.force}, index=[f"r{i}" for i in range(len(self.stage))])
        for cell, found in ((float("nan"), None), (None, None), (pandas.NA, None), ("n/a", "'n/a'"), (float("inf"), "inf")):
            with self.subTest(cell):
                frame = usual.astype({"F_N": object})
                frame.loc["r17", "F_N"] = cell
                for data in (frame,), (frame.w_s_m, frame.F_N):
                    if found is None:
                        with self.assertWarnsRegex(UserWarning, "^column 'F_N': 1 of 227 rows has no number .* at position 17"):
                            self.assertEqual(len(flexslip.fit(*data, **SPECIMEN).curves), 226)
                        continue
                    with self.assertRaisesRegex(flexslip.InputError, f"^column 'F_N', row 'r17': This must be a finite number, not {found}. ") as raised:
                        flexslip.fit(*data, **SPECIMEN)
                    self.assertEqual(raised.exception.key, "record.force")
                with self.assertRaisesRegex(flexslip.InputError, r"^force\[17\]: This must be a finite number.* keep = numpy.isfinite\(stage\) & numpy.isfinite\(force\)"):
                    flexslip.fit(frame.w_s_m.to_numpy(), frame.F_N.to_numpy(), **SPECIMEN)
        self.assertEqual(flexslip.fit(usual.astype(object), **SPECIMEN), self.usual)
        self.assertEqual(flexslip.fit(usual.astype("Float64"), **SPECIMEN), self.usual)

    def test_identity_series_are_paired_by_their_labels_or_refused(self):
        stage, force = pandas.Series(self.stage, name="stage"), pandas.Series(self.force, name="force")
        self.assertEqual(flexslip.fit(stage, force.sample(frac=1, random_state=1), **SPECIMEN), self.usual)
        self.assertEqual(flexslip.fit(stage=(stage, "m"), force=(force[::-1], "N"), **SPECIMEN), self.usual)
        for first, second, told in ((stage[3:], force[:-3], r"6 labels stand in one of them only. .* pass stage.reset_index\(drop=True\)"),
                                    (stage, force.set_axis(force.index + 500), "pass stage.reset_index"), (stage, force.drop(index=7), r'stage.align\(force, join="inner"\)'),
                                    (stage.set_axis([0] * len(stage)), force[1:], "two columns of one DataFrame")):
            with self.assertRaisesRegex(flexslip.InputError, "^force: The index of this Series differs from that of stage: .*" + told):
                flexslip.fit(first, second, **SPECIMEN)
        shifted = [each.reset_index(drop=True) for each in (stage, force.set_axis(force.index + 500))]
        self.assertEqual(flexslip.fit(*shifted, **SPECIMEN), self.usual)
        self.assertTrue(flexslip.fit(*stage.align(force.drop(index=7), join="inner"), **SPECIMEN).success)

    def test_identity_rows_of_a_frame_without_a_reading_are_left_out_as_those_of_its_file(self):
        frame = pandas.DataFrame({"Crosshead (m)": self.stage, "Load (N)": self.force})
        frame.iloc[100, 1] = np.nan
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "holed.csv")
            frame.to_csv(path, index=False)
            of_file = flexslip.fit(path, **SPECIMEN)
        with self.assertWarnsRegex(UserWarning, r"^column 'Load \(N\)': 1 of 227 rows has no number \(NaN\) and is left out, the first at position 100$") as warned:
            of_frame = flexslip.fit(frame, **SPECIMEN)
        self.assertEqual((of_frame, warned.filename), (of_file, __file__))
        np.testing.assert_array_equal(of_frame.curves.row[98:102], [99, 100, 102, 103])
        self.assertEqual(flexslip.fit(of_frame.case), of_file)
        self.assertEqual(pickle.loads(pickle.dumps(of_frame.case)), of_frame.case)
        frame.iloc[100:150, 1] = np.nan
        with self.assertRaisesRegex(flexslip.InputError, r"50 of 227 rows have no number \(NaN\); at most a tenth may. Pass frame.dropna\(subset=\['Load \(N\)'\]\)"):
            flexslip.fit(frame, **SPECIMEN)
        flexslip.fit(frame.dropna(subset=["Load (N)"]), **SPECIMEN)

    def test_outside_text_in_a_column_is_named_with_a_remedy_that_works(self):
        usual = pandas.DataFrame({"Crosshead (m)": self.stage, "Load (N)": self.force})
        texts = usual["Load (N)"].map(repr)
        for column, error, told, remedy in (
                (texts.str.replace(".", ",", regex=False), flexslip.InputError, "text with a decimal comma", lambda text: text.str.replace(",", ".").astype(float)),
                (texts, TypeError, "Convert them: frame", lambda text: text.astype(float)),
                (texts.astype("string"), TypeError, "Convert them: frame", lambda text: text.astype(float)),
                (texts.where(texts.index != 5, "overload"), flexslip.InputError, r"row 5: This must be a finite number, not 'overload'. .*pandas.to_numeric",
                 lambda text: pandas.to_numeric(text, errors="coerce")),
                (usual["Load (N)"].mask(texts.index == 5, np.inf), flexslip.InputError, r"row 5: .* not inf. Leave such rows out", lambda numbers: numbers[np.isfinite(numbers)])):
            with self.subTest(told):
                with self.assertRaisesRegex(error, r"^column 'Load \(N\)'.*" + told):
                    flexslip.fit(usual.assign(**{"Load (N)": column}), **SPECIMEN)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    mended = usual.assign(**{"Load (N)": remedy(column)})
                    self.assertTrue(flexslip.fit(mended, **SPECIMEN).success)
        with self.assertRaisesRegex(flexslip.InputError, r"^column 'Load \(N\)': None of the 227 rows has a number \(NaN\)"):
            flexslip.fit(usual.assign(**{"Load (N)": np.nan}), **SPECIMEN)
        self.assertEqual(flexslip.fit(usual.assign(note="as is, 3,5"), **SPECIMEN), self.usual)

    def test_outside_what_is_no_data_is_told_what_to_pass(self):
        simulation = flexslip.simulate("examples/simulated/truth.toml")
        for data, told in (((np.column_stack([self.stage, self.stage, self.force]),), r"one array of the shape \(227, 3\). Write fit\(data\[:, 0\]"),
                           ((self.stage,), r"not an array. Write fit\(stage, force\)"), ((self.export,), r"not Export. Write fit\(export.to_frame\(\)\)"),
                           ((simulation,), r"not Simulation. Write fit\(simulation.to_frame\(\)\)"), ((self.usual,), r"not Fit. Write fit\.case\."),
                           ((self.stage.astype(object).astype(str), self.force), "as in numpy.asarray")):
            with self.assertRaisesRegex(TypeError, told):
                flexslip.fit(*data, **SPECIMEN)
        self.assertEqual(flexslip.fit(self.export.to_frame(), **SPECIMEN), self.usual)
        self.assertEqual(flexslip.fit(self.usual.case), self.usual)
        with self.assertRaisesRegex(TypeError, r'not int; pass the tests by name, {"G1": frame'):
            flexslip.campaign(3)

    def test_outside_frames_that_are_no_record_are_refused_in_their_own_words(self):
        stage, force = self.stage, self.force
        for frame, keywords, told in (
                (pandas.DataFrame({"a": stage, "b": force}), {}, "'a', 'b'. Say which"),
                (pandas.DataFrame({"Weg": stage, "Kraft": force}), {"displacement": "crosshead"}, "column 'Weg': This must be titled with a unit"),
                (pandas.DataFrame({"Weg (mm)": stage, "Kraft (N)": force}), {}, 'displacement="crosshead"'),
                (pandas.DataFrame({"Weg (mm)": stage, "Kraft (N)": force}), {"stage": "spam", "force": "Kraft (N)"}, "columns Weg (mm), Kraft (N), not spam")):
            with self.assertRaises(flexslip.InputError) as raised:
                flexslip.fit(frame, **keywords, **SPECIMEN)
            self.assertIn(told, str(raised.exception))
            self.assertNotIn("/", str(raised.exception).replace("N/m", ""))  # no path of a file that nobody wrote
        for arguments in (stage,), (stage, force, force), (pandas.DataFrame({"stage": stage, "force": force}), force), ("examples/simulated/case.toml", force):
            self.assertRaises(TypeError, flexslip.fit, *arguments, **SPECIMEN)
        self.assertRaises(TypeError, flexslip.fit, stage, force, force=force, **SPECIMEN)
        with self.assertRaisesRegex(TypeError, "text"):
            flexslip.fit(pandas.DataFrame({"stage": stage.astype(str), "force": force}), **SPECIMEN)

    def test_identity_residual_is_measured_less_fitted(self):
        residual = self.usual.residual
        self.assertEqual(residual.shape, self.usual.curves.force.shape)
        told = np.isfinite(residual)
        self.assertGreater(told.sum(), 200)
        np.testing.assert_array_equal(residual[told] + self.usual.curves.model_force[told], self.usual.curves.force[told])


    def test_identity_the_fit_run_forward_is_what_the_rig_reads_less_what_it_is_off_by(self):
        curves, stiffness = self.usual.curves, 90.65
        with tempfile.TemporaryDirectory() as folder:
            self.usual.draws.to_frame()[["length", "mu"]].to_csv(os.path.join(folder, "mean.csv"), index=False)
            case = os.path.join(folder, "mean.toml")
            stage = curves.stage + curves.deflection_off + curves.force_off / stiffness
            with open(case, "w") as file:
                file.write(f"""[specimen]
diameter = "34.8 um"
bending_stiffness = "{self.usual.params["bending_stiffness"].value} N m^2"
[rig]
span = "1278 um"
stiffness = "{stiffness} N/m"
[friction]
model = "table"
file = "mean.csv"
length = "length [m]"
[stage]
program = ["0 um", "{stage.max()} m"]
step = "0.1 um"
""")
            path = flexslip.simulate(case).path
        off = np.abs(np.interp(stage, path.stage, path.force) - curves.force_off - curves.model_force)
        self.assertLess(np.median(off), 0.02 * np.abs(curves.force_off).max())  # the median: between two steps the force may snap


class OldWorkbooks(unittest.TestCase):
    def test_identity_a_workbook_of_excel_97_is_read_as_its_numbers_in_csv(self):
        try:
            import xlrd  # noqa: F401
            import xlwt
        except ImportError:
            self.skipTest("xlrd and xlwt are not installed")
        rows = [(0.1 * i, 0.01 * i, 0.3 * i + 0.001 * i * i) for i in range(80)]
        book = xlwt.Workbook()
        book.add_sheet("Notes").write(0, 0, "an empty sheet")
        sheet = book.add_sheet("Data")
        for j, title in enumerate(("Time (s)", "Crosshead (mm)", "Load (N)")):
            sheet.write(0, j, title)
            for i, row in enumerate(rows):
                sheet.write(i + 1, j, row[j])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "old.xls"
            book.save(str(path))
            plain = pathlib.Path(folder) / "old.csv"
            plain.write_text("Time (s),Crosshead (mm),Load (N)\n" + "".join(f"{t!r},{w!r},{F!r}\n" for t, w, F in rows))
            for chosen in (None, "Data", 2):
                self.assertEqual(flexslip.read(path, sheet=chosen).data["Load"].tolist(), flexslip.read(plain).data["Load"].tolist())
            of = {"displacement": "crosshead", "stiffness": "1 kN/mm", "span": "64 mm", "width": "10 mm", "height": "4 mm"}
            self.assertEqual(flexslip.modulus(path, **of).modulus, flexslip.modulus(plain, **of).modulus)
            with self.assertRaisesRegex(flexslip.InputError, "has the sheets 'Notes', 'Data', not 'Other'"):
                flexslip.read(path, sheet="Other")


class Campaigns(unittest.TestCase):
    def test_identity_a_frame_is_a_table(self):
        frame = pandas.DataFrame({"name": ["a", "b"], "file": ["examples/simulated/test.csv"] * 2, "diameter": [34.8, 34.9]})
        frame.attrs["units"] = {"diameter": "um"}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tests.csv")
            absolute = frame.assign(file=[os.path.abspath(file) for file in frame["file"]]).rename(columns={"diameter": "diameter [um]"})
            absolute.to_csv(path, index=False)
            of_file = flexslip.campaign(path, "examples/simulated/case.toml")
            campaign = flexslip.campaign(frame, "examples/simulated/case.toml")
            np.testing.assert_array_equal(campaign.to_frame().mu0, of_file.to_frame().mu0)
            self.assertEqual(list(campaign.tests.file), ["examples/simulated/test.csv"] * 2)
            self.assertEqual(list(campaign.to_frame()["file"]), ["examples/simulated/test.csv"] * 2)
            report = os.path.join(folder, "report")
            flexslip.campaign(frame, "examples/simulated/case.toml", report=report, figures=False)
            again = flexslip.campaign(frame, "examples/simulated/case.toml", report=report, figures=False)
            self.assertEqual(again, campaign)
        with self.assertRaisesRegex(flexslip.InputError, "^frame:1: column 'diametre \\[um\\]'.*Did you mean 'diameter'"):
            flexslip.campaign(frame.rename(columns={"diameter": "diametre [um]"}).drop(columns="name"), "examples/simulated/case.toml")


    def test_identity_bare_numbers_of_a_frame_are_in_si_and_its_index_names_the_tests(self):
        common = "examples/simulated/case.toml"
        said = pandas.DataFrame({"name": ["a", "b"], "file": ["examples/simulated/test.csv"] * 2, "diameter": ["34.8 um ± 0.1 um", "34.9 um ± 0.1 um"],
                                 "span": ["1.278 mm", "1.279 mm"], "stiffness": ["90 N/m", "91 N/m"], "until": [400, 410], "first": ["10 um", "20 um"]})
        bare = pandas.DataFrame({"file": said.file, "diameter": [34.8e-6, 34.9e-6], "diameter uncertainty": [1e-7, 1e-7], "rig.span": [1.278e-3, np.float64(1.279e-3)],
                                 "stiffness": [90, 91], "until": [400.0, 410.0], "first": [10e-6, 20e-6]}).set_index(pandas.Index(["a", "b"], name="test"))
        of_words, of_numbers = flexslip.campaign(said, common), flexslip.campaign(bare, common)
        self.assertEqual(list(of_numbers.to_frame().index), ["a", "b"])
        self.assertTrue(of_words.success and of_numbers.success, of_numbers)
        np.testing.assert_array_equal(of_words.to_frame().mu0, of_numbers.to_frame().mu0)
        self.assertEqual(len({*of_numbers.to_frame().mu0}), 2)
        by_file = flexslip.campaign(bare.set_index("file")[:1], common)
        self.assertEqual((list(by_file.to_frame().index), list(by_file.tests.file)), (["test"], ["examples/simulated/test.csv"]))
        of_common = flexslip.campaign(bare.drop(columns="file"), common)  # whose file it is
        self.assertEqual((list(of_common.to_frame().index), list(of_common.tests.file)), (["a", "b"], ["row 'a'", "row 'b'"]))

    def test_identity_tests_in_memory_are_a_campaign_as_their_files_are(self):
        specimen, rig = {"diameter": "34.8 um", "modulus": "29.6 GPa"}, {"span": "1278 um", "stiffness": "90.65 N/m", "supports": "edges"}
        known = {"specimen": specimen, "rig": rig}
        paths = [f"examples/{name}/test.csv" for name in ("simulated", "cyclic")]
        exports = [flexslip.read(path) for path in paths]
        frames = {name: export.to_frame() for name, export in zip(("b", "a"), exports)}
        frames["b"].iloc[100, 1] = np.nan
        with self.assertWarns(UserWarning):
            fits = [flexslip.fit(frame, name=name, **known) for name, frame in frames.items()]
        numbers = [fit.params.mu0.value for fit in fits]
        table = pandas.DataFrame({"file": paths}, index=["b", "a"])
        arrays = {name: (export.si("crosshead"), export.si("force")) for name, export in zip(("b", "a"), exports)}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            of_frames = flexslip.campaign(frames, **known)
        for campaign in of_frames, flexslip.campaign(fits), flexslip.campaign({"b": fits[0], "a": fits[1].case}):
            np.testing.assert_array_equal(campaign.to_frame().mu0, numbers)
            self.assertEqual(list(campaign.to_frame().index), ["b", "a"])
            self.assertEqual(list(campaign.tests.file), ["b", "a"])
            self.assertNotRegex(campaign.to_json(), r"\.toml|\.csv")
        usual = flexslip.campaign(table, **known).to_frame().mu0
        for campaign in (flexslip.campaign(table, flexslip.Case(**known)), flexslip.campaign(table, specimen=specimen, **rig), flexslip.campaign(arrays, **known),
                         flexslip.campaign(table, fits[0].case), flexslip.campaign({"b": paths[0], "a": paths[1]}, flexslip.Case(**known))):
            np.testing.assert_array_equal(campaign.to_frame().mu0, usual)
        self.assertEqual(list(flexslip.campaign(paths, **known, until=200).tests.name), ["test", "test 2"])
        with tempfile.TemporaryDirectory() as folder:
            reported = [flexslip.campaign(arrays, **known, report=os.path.join(folder, "report"), figures=False) for _ in range(2)]
            self.assertEqual(reported[0], reported[1])
            np.testing.assert_array_equal(reported[0].to_frame().mu0, usual)
            self.assertTrue(os.path.exists(os.path.join(folder, "report", "report.html")))

    def test_outside_tests_in_memory_that_are_wrong_are_named(self):
        stage = np.linspace(0, 1e-3, 99)
        known = {"span": "1278 um", "stiffness": "90.65 N/m", "diameter": "34.8 um"}
        good = (stage, stage)
        for tests, keywords, told in (({"a": good, "b": (stage, stage[1:])}, known, "^b: force: This must be as many readings"),
                                      ({"a": good}, {"diameter": "34.8 um", "stiffness": 9.0}, '^a: span: This argument is missing. Add span="1278 um"'), ({}, known, "by name"),
                                      ({"a/b": good}, known, "a slash"), ({"a": good}, {"common": dict(known)}, r"as keywords: campaign\(tests, \*\*common\)")):
            with self.assertRaisesRegex(flexslip.InputError, told):
                flexslip.campaign(tests, **keywords)
        for tests, told in (({"a": 3}, "^a: The data must be a file"), ({"a": good}, "did you mean 'span'")):
            with self.assertRaisesRegex(TypeError, told):
                flexslip.campaign(tests, **(known if "file" in told else {"spann": 3}))
        failed = flexslip.campaign({"a": good})
        self.assertFalse(failed.success)
        self.assertRegex(failed.failures[0].reason, r'pass stiffness="… N/m"')
        for words in failed.failures[0].reason, repr(failed), failed.summary():
            self.assertNotRegex(words, r"\[rig\]|into rig|--|\.toml")

    def test_outside_a_campaign_without_an_answer_says_the_first_cause(self):
        table = pandas.DataFrame({"file": ["examples/simulated/test.csv"] * 3, "span": ["1 mm", "2 N", "3 N"]}, index=["a", "b", "c"])
        for frame, success, told in ((table, True, r"^3 tests: (.|\n)*\nb: column 'span': '2 N' is a force, not a length.* \(alike in 2 tests\)$"),
                                     (table.assign(span=["1 N"] * 3, until=[1, 2, 3]), False, r"^3 tests: 3 NO ANSWER\.\na: column 'span'.*'1 N'.*\(alike in 3 tests\)$")):
            campaign = flexslip.campaign(frame, "examples/simulated/case.toml")
            self.assertEqual(campaign.success, success)
            self.assertRegex(campaign.message, told)
            self.assertEqual(campaign.message, repr(campaign))
            self.assertIn("column &#x27;span&#x27;", campaign._repr_html_())
            self.assertRegex(campaign.failures[-1].reason, "^row 'c': column 'span'")
            self.assertNotIn("frame.csv", campaign.to_json() + campaign.summary() + str(campaign.to_frame().to_dict()))

    def test_outside_a_record_that_is_there_again_counts_once_and_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "copy.csv")
            shutil.copy("examples/simulated/test.csv", copy)
            table = pandas.DataFrame({"name": list("abcd"), "file": ["examples/simulated/test.csv"] * 3 + [copy], "diameter": 34.8e-6})
            campaign = flexslip.campaign(table, "examples/simulated/case.toml")
            self.assertEqual(list(campaign.to_frame().index), ["a"])
            self.assertEqual(list(campaign.notes), [f"'{name}' is omitted: its record is identical to the record of 'a'" for name in "bcd"])
            self.assertIn(campaign.notes[2], repr(campaign))
            table.loc[1:, "diameter"] += 1e-7
            self.assertEqual(list(flexslip.campaign(table, "examples/simulated/case.toml").to_frame().index), ["a", "b"])


class Equality(unittest.TestCase):
    def test_identity_fits_are_equal_wherever_their_readings_were(self):
        export = flexslip.read("examples/simulated/test.csv")
        of_file = flexslip.fit("examples/simulated/test.csv", stage="stage", force="force", **SPECIMEN)
        of_frame, of_arrays = flexslip.fit(export.to_frame(), **SPECIMEN), flexslip.fit(export.si("crosshead"), export.si("force"), name="other", **SPECIMEN)
        self.assertTrue(of_file == of_frame == of_arrays and hash(of_file) == hash(of_frame) == hash(of_arrays))
        self.assertNotEqual(of_file.name, of_frame.name)
        self.assertNotEqual(of_file.provenance, of_frame.provenance)
        other = export.si("force").copy()
        other[100] += 1e-9
        self.assertNotEqual(of_file, flexslip.fit(export.si("crosshead"), other, **SPECIMEN))

    def test_identity_equal_fits_are_equal(self):
        fit, again = (flexslip.fit("examples/simulated/case.toml") for _ in range(2))
        other = flexslip.fit("examples/simulated/case.toml", stiffness="100 N/m")
        self.assertTrue(fit == again and hash(fit) == hash(again) and not fit != again)
        self.assertNotEqual(fit, other)
        self.assertEqual(fit.params, again.params)
        self.assertEqual(fit.params.mu0, again.params.mu0)
        self.assertNotEqual(fit.params.mu0, other.params.mu0)
        self.assertEqual(fit.profile, again.profile)
        self.assertNotEqual(fit.profile, other.profile)
        self.assertNotEqual(fit, fit.params)
        self.assertNotEqual(fit, 3)


if __name__ == "__main__":
    unittest.main()
