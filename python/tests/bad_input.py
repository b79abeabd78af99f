#!/usr/bin/python3
"""outside: bad input from Python is refused by the right exception, which names the value, and nothing crashes; by Hypothesis."""
import errno
import math
import os
import pickle
import tempfile
import traceback
import unittest

import hypothesis
import hypothesis.extra.numpy as arrays
import numpy as np
from hypothesis import strategies as some

import flexslip
from package import DESIGN, SOURCE, case

os.chdir(SOURCE)
CASE = case("simulated")
HEIGHTS = 1e-7 * np.cos(np.arange(128) / 3)
SPECIMEN = {"diameter": "34.8 um", "modulus": "29.6 GPa", "span": "1278 um", "stiffness": "90.65 N/m"}
KEYS = {(key["section"], key["name"]): key for key in flexslip.keys()}
QUANTITIES = [key for key in flexslip.keys() if key["is"] == "quantity" and key["section"] in ("specimen", "rig") and key["unit"] and key["name"] != "strength"]  # which wants a section
EXPECTED = (ValueError, TypeError)  # InputError is a ValueError
hypothesis.settings.register_profile("same every time", derandomize=True, deadline=None, max_examples=150,
                                     suppress_health_check=list(hypothesis.HealthCheck))
hypothesis.settings.load_profile("same every time")

numbers = some.floats(allow_nan=True, allow_infinity=True)
anything = some.one_of(some.none(), some.booleans(), some.integers(), numbers, some.text(max_size=20), some.binary(max_size=8), some.complex_numbers(),
                       some.lists(some.one_of(numbers, some.text(max_size=3)), max_size=4), some.dictionaries(some.text(max_size=5), numbers, max_size=3),
                       some.just(object()), some.just(np.float32(3)), some.just(np.array(3.0)), some.just(np.array([])), some.just(np.ones((2, 2))),
                       some.datetimes(), some.fractions())


class Masked(np.ndarray):
    """A subclass of arrays as users write them."""


def within(values, low, high):
    """Does every number lie between two others? NaN may stand for one that is unknown."""
    values = np.asarray(values, dtype=float)
    return bool(np.all(((values >= low) & (values <= high)) | np.isnan(values)))


class Elastica(unittest.TestCase):
    def in_domain(self, S, q):
        return within(S, 1, np.finfo(float).max) and within(q, -20, 20)

    @hypothesis.given(some.data())
    def test_outside_arrays_of_any_shape_type_and_layout(self, data):
        shape = data.draw(arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=5))
        kinds = some.one_of(arrays.floating_dtypes(endianness="?"), arrays.integer_dtypes(endianness="?"), arrays.boolean_dtypes(),
                            arrays.complex_number_dtypes(), arrays.unicode_string_dtypes(), arrays.datetime64_dtypes())
        S = data.draw(arrays.arrays(data.draw(kinds), shape))
        q = data.draw(arrays.arrays(data.draw(kinds), data.draw(some.one_of(some.just(shape), arrays.array_shapes(max_dims=2, max_side=4)))))
        if data.draw(some.booleans()) and S.ndim:
            S = S[..., ::-1]
        if data.draw(some.booleans()):
            S = S.T
        if data.draw(some.booleans()):
            S = S.view(Masked)
        real = S.dtype.kind in "biuf" and q.dtype.kind in "biuf"
        try:
            with np.errstate(all="ignore"):
                states = flexslip.elastica(S, q)
        except TypeError as error:
            self.assertFalse(real, error)
        except flexslip.InputError as error:
            self.assertTrue(real and not self.in_domain(np.asarray(S, dtype=float), np.asarray(q, dtype=float)), error)
            name, problem = error.field, error.problem
            at = eval(name, {"S": np.asarray(S), "q": np.asarray(q)})  # the place that is named holds the value that is told
            self.assertTrue(problem.endswith(f"not {at.item()!r}."), problem)
        except ValueError as error:
            self.assertIn("broadcast", str(error))
        else:
            self.assertTrue(real)
            self.assertEqual(states.w.shape, np.broadcast_shapes(S.shape, q.shape))

    @hypothesis.given(anything, anything)
    def test_outside_anything_at_all(self, S, q):
        for function in (flexslip.elastica, flexslip.elastica_slopes, flexslip.elastica_details, flexslip.elastica_inverse):
            try:
                with np.errstate(all="ignore"):
                    function(S, q)
            except EXPECTED as error:
                self.assertTrue(str(error))

    @hypothesis.given(some.data())
    def test_outside_states_on_rollers_of_any_arrays(self, data):
        shape = data.draw(arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4))
        kinds = some.one_of(arrays.floating_dtypes(endianness="?"), arrays.integer_dtypes(endianness="?"), arrays.boolean_dtypes(),
                            arrays.complex_number_dtypes(), arrays.unicode_string_dtypes())
        near = arrays.arrays(np.float64, shape, elements=some.floats(0, 0.6))
        drawn = [data.draw(some.one_of(near, arrays.arrays(data.draw(kinds), shape), some.floats(0, 0.6), anything)) for _ in range(4)]
        if data.draw(some.booleans()):
            drawn = [each.T.view(Masked) if isinstance(each, np.ndarray) else each for each in drawn]
        w, q, radius, thickness = drawn
        for call in (lambda: flexslip.elastica_on_rollers(w, q, roller_radius=radius, thickness=thickness),
                     lambda: flexslip.elastica_on_rollers_inverse(w, q, roller_radius=radius, thickness=thickness)):
            try:
                with np.errstate(all="ignore"):
                    states = call()
            except EXPECTED as error:
                self.assertTrue(str(error))
                continue
            deflections = np.asarray(w, dtype=float)
            self.assertTrue(within(deflections, 5e-324, 2))
            together = np.asarray(radius, dtype=float) + np.asarray(thickness, dtype=float) / 2
            self.assertTrue(within(together, 0, np.nextafter(0.45, 0)) and within(thickness, 0, np.nextafter(0.2, 0)))
            self.assertEqual(len({np.shape(each) for each in states}), 1)

    def test_outside_a_value_outside_of_the_domain_is_named_by_its_place(self):
        for call, place in ((lambda: flexslip.elastica_on_rollers([0.1, 0.0], 0.3), "w[1]: "), (lambda: flexslip.elastica_on_rollers(0.1, [math.nan, 30]), "q[1]: "),
                            (lambda: flexslip.elastica([[1.1, math.nan], [math.nan, 0.9]], 0.3), "S[1, 1]: "), (lambda: flexslip.elastica_inverse(math.nan, -1), "F: "),
                            (lambda: flexslip.elastica_on_rollers(0.1, 0.3, roller_radius=[[0.1, 0.5]]), "roller_radius[0, 1]: "),
                            (lambda: flexslip.elastica_on_rollers(0.1, 0.3, roller_radius=0.4, thickness=0.15), "roller_radius: "),
                            (lambda: flexslip.elastica_on_rollers(0.1, 0.3, thickness=-0.1), "thickness: "), (lambda: flexslip.elastica_on_rollers(0.1, 0.3, thickness=0.2), "thickness: "),
                            (lambda: flexslip.elastica_on_rollers_inverse(0.1, [-1.0]), "F[0]: ")):
            with self.assertRaises(flexslip.InputError) as raised:
                call()
            self.assertTrue(str(raised.exception).startswith(place), raised.exception)
        masked = flexslip.elastica_on_rollers(np.ma.array([0.1, np.nan], mask=[False, True]), 0.3, roller_radius=0.05)
        self.assertTrue(masked.F.mask[1] and masked.F[0] == flexslip.elastica_on_rollers(0.1, 0.3, roller_radius=0.05).F)

class Cases(unittest.TestCase):
    @hypothesis.given(some.sampled_from(QUANTITIES), numbers)
    def test_outside_floats_are_taken_in_si_or_refused_by_key(self, key, value):
        name = f"{key['section']}.{key['name']}"
        try:
            case = flexslip.Case(**{key["section"]: {key["name"]: value}})
        except flexslip.InputError as error:
            self.assertTrue(error.key is not None or error.field is not None, error)
            if error.key == name and not value > 0 and " is not a " in (error.problem or ""):
                self.assertTrue(repr(float(value)) in str(error) or "inf" in str(error), (name, error))
        else:
            self.assertGreaterEqual(value, 0)
            text = case[name]
            self.assertEqual(flexslip.Case(**{key["section"]: {key["name"]: text}})[name], text)  # it reads back to the same bits

    @hypothesis.given(some.sampled_from(sorted(KEYS)), anything)
    def test_outside_anything_for_any_key(self, key, value):
        section, name = key
        try:
            flexslip.Case(**({section: {name: value}} if section else {name: value}), reduced=False) if name != "reduced" else flexslip.Case(reduced=value)
        except EXPECTED as error:
            self.assertTrue(str(error))
            self.assertEqual(str(pickle.loads(pickle.dumps(error))), str(error))

    @hypothesis.given(some.text(max_size=200))
    def test_outside_any_text_as_a_case(self, text):
        try:
            flexslip.Case.from_toml(text)
        except EXPECTED as error:
            self.assertTrue(str(error))

    @hypothesis.given(some.dictionaries(some.text(max_size=12), anything, max_size=3))
    def test_outside_any_keywords(self, keywords):
        try:
            flexslip.Case(**keywords)
        except EXPECTED as error:
            self.assertTrue(str(error))

    def test_outside_units_are_held_to_their_key(self):
        for name, value, told in (("span", "3 N", "3 N"), ("span", "3", "'3'"), ("span", "3 parsec", "parsec"), ("diameter", "-3 um", "-3 um"),
                                  ("stiffness", "nan N/m", "nan N/m"), ("modulus", "5 mm", "5 mm")):
            with self.assertRaises(flexslip.InputError) as raised:
                flexslip.Case(**{**SPECIMEN, name: value})
            self.assertEqual(raised.exception.key.split(".")[-1], name)
            self.assertIn(told, str(raised.exception))
            self.assertIsNone(raised.exception.file)
            self.assertIsNone(raised.exception.line)  # no line of a text that nobody wrote


    def test_identity_a_quantity_keeps_its_unit(self):
        self.assertIn('span = "1 mm"', repr(flexslip.Case(span=flexslip.Quantity(1.0, "mm"))))
        self.assertEqual(flexslip.Case(**{**SPECIMEN, "modulus": (flexslip.Quantity(29.6, "GPa"), "3 %")}), flexslip.Case(**{**SPECIMEN, "modulus": ("29.6 GPa", "3 %")}))
        with self.assertRaisesRegex(flexslip.InputError, "span: '.*' is a force, not a length"):
            flexslip.Case(span=flexslip.Quantity(1.0, "N"))

    def test_outside_what_no_case_can_hold_is_named(self):
        for value in (10**400, "1 mm\ud800", {"value": 29.6e9, "uncertainty": [1]}, {"value": None}):
            with self.assertRaisesRegex(flexslip.InputError, "modulus: This must be a modulus or"):
                flexslip.Case(modulus=value)


class Faults(unittest.TestCase):
    def fault(self, call):
        with self.assertRaises(flexslip.InputError) as raised:
            call()
        return raised.exception

    def test_outside_a_fault_is_data(self):
        error = self.fault(lambda: flexslip.Case.from_toml('[rig]\nspan = "1278"\n', "mine.toml"))
        self.assertEqual((error.file, error.line, error.key, error.kind), ("mine.toml", 2, "rig.span", "wrong"))
        self.assertIn("1278", error.problem)
        error = self.fault(lambda: flexslip.Case(friction={"model": "sinusoid", "mu0": 0.5, "amplitude": 1.5, "wavelength": "9 um"}))
        self.assertEqual((error.key, error.kind, error.limit), ("friction.amplitude", "too_much", 1.0))
        error = self.fault(lambda: flexslip.Case(rig={"spam": "1 mm"}))
        self.assertEqual(error.kind, "unknown")
        self.assertIn("span", error.remedy)
        error = self.fault(lambda: flexslip.simulate(**SPECIMEN))
        self.assertEqual(error.kind, "missing")
        error = self.fault(lambda: flexslip.Case.from_toml('[rig]\nspan = "64 mm"\nroller_radius = "5 mm"\nrollers = "pinned"\npin_radius = "1 mm"\n', "pins.toml"))
        self.assertEqual((error.key, error.kind), ("rig.pin_friction", "missing"))

    def test_outside_files_that_are_not_there(self):
        for call in (lambda: flexslip.fit("nothing.toml"), lambda: flexslip.read("nothing.csv"), lambda: flexslip.simulate("nothing.toml"),
                     lambda: flexslip.fit("nothing.csv", displacement="crosshead", **SPECIMEN)):
            error = self.fault(call)
            self.assertIsInstance(error, FileNotFoundError)
            self.assertIn("nothing", error.filename)
            self.assertIn("nothing", str(error))
            self.assertEqual((error.errno, pickle.loads(pickle.dumps(error)).errno), (errno.ENOENT, errno.ENOENT))
            self.assertEqual(str(pickle.loads(pickle.dumps(error))), str(error))
        for file, told in (("examples/simulated/tset.csv", "Did you mean 'examples/simulated/test.csv'?"), ("nowhere/test.csv", "There is no folder 'nowhere' in "),
                           ("examples/simulated/something.csv", f"looked for in {os.path.abspath('examples/simulated')!r}")):
            error = self.fault(lambda: flexslip.fit(file, displacement="crosshead", **SPECIMEN))
            self.assertIn(told, str(error))
            self.assertIn(told, error.remedy)
        for call in (lambda: flexslip.read("examples"), lambda: flexslip.fit("examples", **SPECIMEN)):
            error = self.fault(call)
            self.assertIsInstance(error, IsADirectoryError)
            self.assertEqual((error.filename, error.errno), ("examples", errno.EISDIR))
            self.assertIn("flexslip.campaign takes a folder", error.remedy)

    def test_outside_names_of_files_that_are_no_utf8(self):
        with tempfile.TemporaryDirectory() as folder:
            base = os.fsencode(folder) + b"/\xff-\xc3\xa4"
            with open("examples/simulated/test.csv", "rb") as file, open(base + b".csv", "wb") as copy:
                copy.write(file.read())
            self.assertEqual(flexslip.read(base + b".csv").rows, 426)
            for call in (lambda: flexslip.read(base), lambda: flexslip.fit(base + b".toml"), lambda: flexslip.campaign(base)):
                self.assertEqual(os.fsencode(self.fault(call).file)[:len(base)], base)

    def test_outside_quantities_of_a_reduced_case_have_no_unit_of_si(self):
        case = flexslip.Case(reduced=True, stiffness=30, friction={"model": "constant", "mu0": 0.6}, stage={"program": [0, 0.5], "step": 0.002})
        newtons, reduced = flexslip.Quantity(10.0, "N/m"), flexslip.Quantity(10.0, "EI/L^3")
        for call in (lambda: flexslip.design(case, over={"stiffness": (newtons, 100.0, 3)}), lambda: case.replace(stiffness=newtons),
                     lambda: flexslip.sweep(case, axes={"stiffness": [newtons]})):
            self.assertIn("10.0 N/m", str(self.fault(call)))
        self.assertEqual(case.replace(stiffness=reduced)["rig.stiffness"], 10)
        self.assertEqual(len(flexslip.design(case, over={"stiffness": (reduced, 100.0, 3)})), 3)

    def test_outside_remedies_are_in_words_of_python(self):
        table = "Weg (mm);Kraft (N)\n" + "".join(f"{i / 10};{i / 7:.4f}\n" for i in range(40))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "export.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write(table)
            error = self.fault(lambda: flexslip.fit(path, **SPECIMEN))
        self.assertIn('displacement="crosshead"', error.remedy)
        self.assertIn('displacement="crosshead"', str(error))
        self.assertNotIn("--", str(error))

    def test_outside_what_keywords_made_is_complained_of_in_keywords(self):
        export = flexslip.read("examples/simulated/test.csv")
        stage, force = export.si("crosshead"), export.si("force")
        specimen, rig = {"diameter": "34.8 um", "modulus": "29.6 GPa"}, {"span": "1278 um", "stiffness": 90.65}
        for call, told in ((lambda: flexslip.fit(stage, force, specimen=specimen, stiffness=90.65), 'span: This argument is missing. Add span="1278 um".'),
                           (lambda: flexslip.fit(stage, force, specimen=specimen, span="1278 um"), "stiffness: The displacement 'stage' was measured at the stage, so the stiffness of the load train is needed"),
                           (lambda: flexslip.fit(stage, force, specimen=specimen, span="1278 um", stiffness=20.0), "stiffness: The load train of "),
                           (lambda: flexslip.fit(stage, force, specimen=specimen, span="3 N"), "span: '3 N' is a force, not a length"),
                           (lambda: flexslip.fit(stage[200:], force[200:], rig=rig, diameter="34.8 um"), "Pass modulus or bending_stiffness"),
                           (lambda: flexslip.fit(CASE, stiffness="20 N/m"), "rig.stiffness: The load train of "),
                           (lambda: flexslip.fit(CASE, set={"rig.spam": 3}), "Did you mean 'rig.span'?"),
                           (lambda: flexslip.fit(**specimen, **rig), "no data: pass a file, a DataFrame, or two arrays"),
                           (lambda: flexslip.design(), 'diameter: This argument is missing. Add the diameter of the specimen'),
                           (lambda: flexslip.design(**specimen), 'span: This argument is missing. Add span="557 um", 16 times the thickness (ISO 178)'),
                           (lambda: flexslip.design(**specimen, **rig), 'stage["program"]: This argument is missing. Add program=["0 mm", "639 um"], up to half the span.'),
                           (lambda: flexslip.simulate(**specimen, **rig), 'stage: This argument is missing. Add stage={"program": ["0 um", "900 um"]}.'),
                           (lambda: flexslip.simulate(**specimen, **rig, stage={"program": [0, 1e-4]}), 'Add friction={"model": "sinusoid", "mu0": 0.5'),
                           (lambda: flexslip.design(DESIGN, over={"spam": (1, 2)}), "is not a number of this case"),
                           (lambda: flexslip.surface(HEIGHTS, "0.1 um", noise=-1.0), "noise: '-1.0 m' is not a non-negative length")):
            error = self.fault(call)
            self.assertIn(told, str(error))
            self.assertNotRegex(str(error), r"--|\[(specimen|rig|stage|friction|record)\]|^line|set=")
            for part in error.field, error.problem, error.remedy:
                self.assertNotRegex(part or "", r'--|\[(specimen|rig|stage|friction|record)\]|Add \w+ = |This (value|section) is missing')
            self.assertIsNone(error.line)

    def test_outside_a_name_that_is_not_there_names_those_that_are(self):
        fit = flexslip.fit(CASE)
        for call, told in ((lambda: fit["spam"], "verdict, "), (lambda: fit.params["spam"], "mu0, amplitude, "), (lambda: fit.profile["spam"], "length, "),
                           (lambda: fit.profile.column("spam"), "mu_error"), (lambda: fit.case["rig.spam"], "rig.span, rig.stiffness")):
            with self.assertRaises(KeyError) as raised:
                call()
            self.assertIn(told, str(raised.exception))
            self.assertIn("spam", str(raised.exception))

    def test_outside_a_name_that_is_nearly_right_is_told(self):
        fit = flexslip.fit(CASE)
        for call, error, told in ((lambda: fit.parms, AttributeError, "'params'"), (lambda: fit.mu0, AttributeError, "params.mu0"), (lambda: fit["mu0"], KeyError, "params.mu0"),
                                  (lambda: fit.params.mu, AttributeError, "'mu0'"), (lambda: fit.params["mu"], KeyError, "'mu0'"), (lambda: fit.params.mu0.valeu, AttributeError, "'value'"),
                                  (lambda: fit.friction_share, AttributeError, "energy.friction_share")):
            with self.assertRaises(error) as raised:
                call()
            self.assertIn(f"did you mean {told}?", str(raised.exception))
        self.assertFalse(hasattr(fit, "spam") or hasattr(fit, "_spam") or hasattr(fit.params, "spam"))
        no_answer = flexslip.fit(CASE, modulus="1 GPa")
        self.assertFalse(no_answer.success)
        pickle.loads(pickle.dumps(fit.params)), repr(no_answer.params)

    def test_outside_a_value_that_is_given_twice_is_refused(self):
        for call, told in ((lambda: flexslip.Case(rig={"span": 1.278e-3}, span="2 mm"), "^span: This must be one value, not rig={'span': 0.001278} and span='2 mm'. Leave one out"),
                           (lambda: flexslip.fit(CASE, stiffness=90.0, set={"rig.stiffness": "91 N/m"}), r"^stiffness: .* rig={'stiffness': 90.0} and set={'rig.stiffness': '91 N/m'}")):
            self.assertRegex(str(self.fault(call)), told)
        self.assertEqual(flexslip.Case(rig={"span": None, "stiffness": 90.0}, span="2 mm")["rig.span"], "2 mm")

    def test_outside_a_row_as_a_float_is_told_from_a_position(self):
        for key in "first", "until":
            error = self.fault(lambda: flexslip.Case("test.csv", **{key: np.float64(267)}))
            self.assertRegex(str(error), f'^{key}: This must be a row, which is an int, .* not 267.0. Write 267 for that row, or "267 m"')
            self.assertEqual(flexslip.Case("test.csv", **{key: np.int64(267)})[f"record.{key}"], 267)
            self.assertEqual(flexslip.Case("test.csv", **{key: 267e-6})[f"record.{key}"], {"stage": "267 um"})

    def test_outside_keys_are_taken_out_of_a_case(self):
        case = flexslip.Case(DESIGN)
        constant = {"model": "constant", "mu0": 0.4}
        self.assertEqual(case.replace(friction=constant)["friction"], constant)
        self.assertEqual(flexslip.simulate(DESIGN, friction=constant), flexslip.simulate(case.replace(friction=constant)))
        rest = {"model": "sinusoid", "mu0": 0.5, "amplitude": 0.15, "wavelength": "10.9 um"}
        for given in {"friction": {"phase": None}}, {"set": {"friction.phase": None}}, {"friction.phase": None}:
            self.assertEqual(case.replace(**given)["friction"], rest)
        self.assertEqual(case.replace(friction={"mu0": 0.3})["friction"], {**rest, "mu0": 0.3, "phase": 1})
        self.assertEqual(flexslip.Case(DESIGN, set={"friction.phase": None})["friction"], rest)
        self.assertIn("Did you mean 'friction.phase'", str(self.fault(lambda: case.replace(set={"friction.phaze": None}))))
        self.assertNotIn("friction", case.replace(friction=None).to_dict())
        self.assertEqual(case.replace(modulus=None, bending_stiffness="2 mN mm^2")["specimen"], {"diameter": "34.8 um", "bending_stiffness": "2 mN mm^2"})
        self.assertEqual(case.replace(stiffness="40 N/m").replace(stiffness=None).to_dict()["rig"], {"span": "1.278 mm"})
        two = flexslip.Case(friction={**rest, "other": constant})
        self.assertEqual(two.replace(friction={"other": None})["friction"], rest)
        self.assertEqual(two.replace(friction=constant)["friction"], constant)
        self.assertIn("[friction] amplitude: This value is missing", str(self.fault(lambda: case.replace(friction={"amplitude": None}))))
        self.assertRaisesRegex(TypeError, "did you mean 'span'", lambda: case.replace(spam=None))
        text = '[stage]\nprogram = [  # of one loading\n  "0 mm",\n  "2 mm",\n]\n[friction]\nmodel = "constant"\nmu0 = 0.3\nreference = "2 mm"\ndrift = "1 1/m"\n'
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lines.toml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            changed = flexslip.Case(path).replace(stage={"program": ["0 mm", "3 mm"]})
            error = self.fault(lambda: changed.replace(stage=None, friction={"drift": None}))
            self.assertEqual((error.key, error.line), ("friction.reference", 9))  # where it stands in the file

    def test_outside_exceptions_have_names_that_read_well(self):
        error = self.fault(lambda: flexslip.fit("nothing.toml"))
        self.assertIs(type(error), flexslip.MissingFileError)
        self.assertEqual(traceback.format_exception_only(error)[-1].split(":")[0], "flexslip.MissingFileError")
        self.assertIs(type(self.fault(lambda: flexslip.read("examples"))), flexslip.FolderError)

    def test_outside_a_list_of_values_is_the_values(self):
        case = flexslip.Case(DESIGN)
        for values in [10, 100, 1000], np.linspace(20, 100, 5), [50.0, 60.0], range(100, 400, 100), np.geomspace(3, 300, 4):
            np.testing.assert_allclose(flexslip.design(case, over={"stiffness": values}).designs.stiffness, list(values), rtol=1e-12)  # of a rounding or a few
        for values in [10, 20, 100], [10.0], [], np.linspace(10, 100, 5), ["10 N/m", "20 N/m", "30 N/m"], np.ones((2, 2)):
            error = self.fault(lambda: flexslip.design(case, over={"stiffness": values}))
            self.assertTrue(error.field == "over['stiffness']" and "flexslip.sweep(case, axes={'stiffness': [...]})" in error.remedy, error)

    def test_outside_numbers_that_are_none_have_a_remedy(self):
        for value in "-1 mm", -1e-3, 0.0, math.nan, "nan mm":
            error = self.fault(lambda: flexslip.Case(**{**SPECIMEN, "diameter": value}))
            self.assertRegex(str(error), r'^diameter: .* as in "34.8 um"\.?$')
            self.assertIn("34.8 um", error.remedy)
        error = self.fault(lambda: flexslip.fit(CASE, false_alarms="0.1"))
        self.assertEqual(str(error), "false_alarms: This must be a positive number, not '0.1'. Pass it without quotes, as in false_alarms=0.1")
        self.assertRaisesRegex(TypeError, "did you mean 'false_alarms'", flexslip.fit, CASE, false_alarm=0.1)

    def test_outside_keywords_that_are_none(self):
        for call in (lambda: flexslip.fit(CASE, spam=3), lambda: flexslip.simulate(CASE, diametre="3 um"), lambda: flexslip.Case(span="1 mm", spam=3)):
            self.assertRaises(TypeError, call)

    @hypothesis.settings(max_examples=60)
    @hypothesis.given(some.sampled_from(["model", "false_alarms", "suspect_limit"]), anything)
    def test_outside_options_of_fit(self, name, value):
        hypothesis.assume(value is not None and not (name in ("false_alarms", "suspect_limit") and isinstance(value, (int, float)) and value > 0))
        try:
            flexslip.fit(CASE, **{name: value})
        except EXPECTED as error:
            self.assertTrue(str(error))

    def test_outside_options_that_are_wrong_name_themselves(self):
        for call, name in ((lambda: flexslip.fit(CASE, model="wave"), "model"), (lambda: flexslip.fit(CASE, false_alarms=-1), "false_alarms"),
                           (lambda: flexslip.fit(CASE, suspect_limit=math.nan), "suspect_limit"), (lambda: flexslip.simulate(CASE, points=1), "points"),
                           (lambda: flexslip.simulate(CASE, seed=-1), "seed"), (lambda: flexslip.simulate(CASE, noise="3 mm"), "noise"),
                           (lambda: flexslip.campaign("examples", jobs=0), "jobs"),
                           (lambda: flexslip.design(DESIGN, over={"mu0": 3}), "over"),
                           (lambda: flexslip.design(DESIGN, over={"mu0": (0, 1)}, decide=True), "decide"),
                           (lambda: flexslip.design(DESIGN, noise="1 uN"), "noise"),
                           (lambda: flexslip.design(DESIGN, decide=True, noise="-1 uN"), "noise"),
                           (lambda: flexslip.design(DESIGN, over={"spam": (1, 2)}), "spam"),
                           (lambda: flexslip.read("examples/simulated/test.csv", decimal=";"), "decimal"),
                           (lambda: flexslip.read("examples/simulated/test.csv", specimen=2), "specimen")):
            error = self.fault(call)
            self.assertIn(name, str(error))


OPTIONS = {  # of functions that compute for a moment at most, whatever they are given
    "equilibrium": (lambda given: flexslip.equilibrium(DESIGN, points=9, **given), ("longest",)),
    "equilibrium_region": (lambda given: flexslip.equilibrium_region(DESIGN, **{"points": 3, "levels": 3, **given}), ("longest", "span", "roller_radius")),
    "modulus": (lambda given: flexslip.modulus(CASE, **given), ("window", "friction_range", "span", "diameter", "set")),
    "surface": (lambda given: flexslip.surface(**{"heights": HEIGHTS, "step": "0.1 um", **given}), ("heights", "step", "level", "wavelength", "amplitude", "pixel",
                "noise", "shortest", "longest", "tapers")),
    "sweep": (lambda given: flexslip.sweep(DESIGN, **{"axes": {"mu0": [0.3]}, **given}), ("axes", "seed", "threads", "stiffness")),
}


class Options(unittest.TestCase):
    """Of the functions that take more than a case."""

    @hypothesis.settings(max_examples=400)
    @hypothesis.given(some.sampled_from([(name, option) for name, (_, options) in OPTIONS.items() for option in options]), anything)
    def test_outside_anything_for_any_option(self, chosen, value):
        name, option = chosen
        if option == "threads":
            hypothesis.assume(not isinstance(value, int) or value < 8)
        try:
            OPTIONS[name][0]({option: value})
        except EXPECTED as error:
            self.assertTrue(str(error))
            self.assertNotIn("--", str(error).replace("--- ", ""))

    @hypothesis.settings(max_examples=100)
    @hypothesis.given(some.one_of(some.lists(anything, max_size=3), some.tuples(anything, anything, some.integers(-1, 3)), some.tuples(anything, anything),
                                  some.dictionaries(some.sampled_from(["from", "to", "points", "spacing"]), some.one_of(anything, some.integers(2, 3)))))
    def test_outside_anything_for_an_axis_of_a_sweep(self, given):
        for name in "stiffness", "mu0", "step", "spam":
            try:
                flexslip.sweep(DESIGN, axes={name: given})
            except EXPECTED as error:
                self.assertTrue(str(error))

    def test_outside_options_that_are_wrong_name_themselves(self):
        for call, name in ((lambda: flexslip.equilibrium(DESIGN, points=1), "points"), (lambda: flexslip.equilibrium(DESIGN, longest="1 N"), "longest"),
                           (lambda: flexslip.equilibrium(DESIGN, longest="1 um"), "longest"), (lambda: flexslip.equilibrium_region(DESIGN, levels=1), "levels"),
                           (lambda: flexslip.modulus(CASE, window=(0.5, 0.1)), "window"), (lambda: flexslip.modulus(CASE, window=0.5), "window"), (lambda: flexslip.modulus(CASE, friction_range=(0.5, 0.1)), "friction"),
                           (lambda: flexslip.modulus(CASE, friction_range="spam"), "friction"), (lambda: flexslip.modulus(CASE, friction_range=(1, 2, 3)), "friction_range"),
                           (lambda: flexslip.surface(HEIGHTS, "0.1 um", level=10), "level"), (lambda: flexslip.surface(HEIGHTS, "0.1 um", amplitude="1 N"), "amplitude"),
                           (lambda: flexslip.surface(HEIGHTS, "0.1 um", tapers=1), "tapers"), (lambda: flexslip.surface(HEIGHTS, None), "step"),
                           (lambda: flexslip.surface(HEIGHTS, "0.1 um", wavelength=["1 um", None]), "wavelength"), (lambda: flexslip.surface(HEIGHTS[:9], "0.1 um"), "64 heights"),
                           (lambda: flexslip.surface(HEIGHTS, "0.1 um", shortest="0.1 um"), "shortest"), (lambda: flexslip.surface(HEIGHTS, "0.1 um", longest="1 m"), "longest"),
                           (lambda: flexslip.surface(1e-7 * np.arange(99), "0.1 um"), "a straight line"), (lambda: flexslip.surface([*HEIGHTS, math.nan], "0.1 um"), "nan at the index 128"),
                           (lambda: flexslip.surface(0 * HEIGHTS, "0.1 um"), "Check their unit"), (lambda: flexslip.surface(HEIGHTS, 1e9), "Check its unit"),
                           (lambda: flexslip.sweep(DESIGN), "sweep"), (lambda: flexslip.sweep(DESIGN, axes={"spam": [1]}), "spam"),
                           (lambda: flexslip.sweep(DESIGN, axes={"stiffness": ["1 mm"]}), "stiffness"), (lambda: flexslip.sweep(DESIGN, axes={"mu0": np.ones((2, 2))}), "mu0"),
                           (lambda: flexslip.sweep(DESIGN, axes={"mu0": (0.1, 0.2, 1)}), "points"), (lambda: flexslip.sweep(DESIGN, axes={"mu0": [0.3]}, seed=3), "seed"),
                           (lambda: flexslip.sweep(DESIGN, axes={"mu0": (0, 1, 10_000_001)}), "memory holds at most 10000000")):
            with self.assertRaises(flexslip.InputError) as raised:
                call()
            self.assertIn(name, str(raised.exception))


class Records(unittest.TestCase):
    """Arrays as a record."""

    @classmethod
    def setUpClass(cls):
        export = flexslip.read("examples/simulated/test.csv")
        cls.stage, cls.force = export.si("crosshead"), export.si("force")

    def test_outside_arrays_that_are_no_record(self):
        stage, force = self.stage, self.force
        holed = force.copy()
        holed[17] = math.nan
        for given, name, error in (({"stage": stage, "force": holed}, "force[17]", flexslip.InputError), ({"stage": stage, "force": force[:-1]}, "force", flexslip.InputError),
                                   ({"stage": [], "force": []}, "stage", flexslip.InputError), ({"stage": stage.reshape(2, -1), "force": force}, "stage", flexslip.InputError),
                                   ({"stage": stage, "force": force.astype(complex)}, "force", TypeError), ({"stage": stage.astype(str), "force": force}, "stage", TypeError),
                                   ({"stage": (stage, "N"), "force": force}, "N", flexslip.InputError), ({"stage": stage, "force": "F [N]"}, "force", flexslip.InputError),
                                   ({"stage": np.ma.array(stage, mask=stage > 1e-4), "force": force}, "stage", flexslip.InputError),
                                   ({"stage": stage[:5], "force": force[:5]}, "arrays", flexslip.InputError), ({"stage": stage}, "stage", flexslip.InputError)):
            with self.assertRaises(error) as raised:
                flexslip.fit(**given, **SPECIMEN)
            self.assertIn(name, str(raised.exception))

    def test_identity_strides_and_types_of_a_record_change_nothing(self):
        usual = flexslip.fit(stage=self.stage, force=self.force, **SPECIMEN).to_json()
        wide = np.zeros((len(self.stage), 2))
        wide[:, 0], wide[:, 1] = self.stage, self.force
        for stage, force in ((wide[:, 0], wide[:, 1]), (list(self.stage), tuple(self.force)), (self.stage.view(Masked), self.force.astype(">f8")),
                             (np.ma.array(self.stage), self.force)):
            self.assertEqual(flexslip.fit(stage=stage, force=force, **SPECIMEN).to_json(), usual)

    @hypothesis.settings(max_examples=60)
    @hypothesis.given(some.integers(0, 60), some.data())
    def test_outside_any_arrays_are_fitted_or_refused(self, count, data):
        small = arrays.arrays(np.float64, count, elements=some.floats(-1e-2, 1e-2))
        try:
            fit = flexslip.fit(stage=data.draw(small), force=data.draw(small), **SPECIMEN)
        except EXPECTED as error:
            self.assertTrue(str(error))
        else:
            self.assertTrue(fit.message)


if __name__ == "__main__":
    unittest.main()
