#!/usr/bin/python3
"""outside: frames and arrays are data, as files are: the same readings give the same answer, however they are handed over."""
import os
import tempfile
import unittest

import numpy as np
import pandas

import flexslip
from package import SOURCE

os.chdir(SOURCE)
SPECIMEN = {"diameter": "34.8 um", "modulus": ("29.6 GPa", "3 %"), "span": "1278 um", "stiffness": "90.65 N/m"}


class Records(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.export = flexslip.read("examples/simulated/test.csv")
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

    def test_outside_frames_that_are_no_record_are_refused_in_their_own_words(self):
        stage, force = self.stage, self.force
        for frame, keywords, told in (
                (pandas.DataFrame({"a": stage, "b": force}), {}, "'a', 'b'; say which"),
                (pandas.DataFrame({"Weg": stage, "Kraft": force}), {"displacement": "crosshead"}, "column 'Weg': expected a unit"),
                (pandas.DataFrame({"Weg (mm)": stage, "Kraft (N)": force}), {}, 'displacement="crosshead"'),
                (pandas.DataFrame({"Weg (mm)": stage, "Kraft (N)": force}), {"stage": "spam", "force": "Kraft (N)"}, "columns Weg (mm), Kraft (N), found spam")):
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
        self.assertGreater(told.sum(), 300)
        np.testing.assert_array_equal(residual[told] + self.usual.curves.model_force[told], self.usual.curves.force[told])


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
            np.testing.assert_array_equal(campaign.table.mu0, of_file.table.mu0)
            self.assertEqual(list(campaign.tests.file), ["frame:2", "frame:3"])
            report = os.path.join(folder, "report")
            flexslip.campaign(frame, "examples/simulated/case.toml", report=report, figures=False)
            again = flexslip.campaign(frame, "examples/simulated/case.toml", report=report, figures=False)
            self.assertEqual(again, campaign)
        with self.assertRaisesRegex(flexslip.InputError, "^frame:1: column 'diametre \\[um\\]'.*did you mean 'diameter'"):
            flexslip.campaign(frame.rename(columns={"diameter": "diametre [um]"}).drop(columns="name"), "examples/simulated/case.toml")


class Equality(unittest.TestCase):
    def test_identity_equal_fits_are_equal(self):
        fit, again = (flexslip.fit("examples/simulated/case.toml") for _ in range(2))
        other = flexslip.fit("examples/simulated/case.toml", stiffness="100 N/m")
        self.assertTrue(fit == again and hash(fit) == hash(again) and not fit != again)
        self.assertNotEqual(fit, other)
        self.assertEqual(fit.parameters, again.parameters)
        self.assertEqual(fit.params.mu0, again.params.mu0)
        self.assertNotEqual(fit.params.mu0, other.params.mu0)
        self.assertEqual(fit.profile, again.profile)
        self.assertNotEqual(fit.profile, other.profile)
        self.assertNotEqual(fit, fit.parameters)
        self.assertNotEqual(fit, 3)


if __name__ == "__main__":
    unittest.main()
