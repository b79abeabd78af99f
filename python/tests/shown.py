#!/usr/bin/python3
"""outside: figures, frames and words: what is drawn is what the answer holds, with the report's labels; nothing is warned of."""
import html
import html.parser
import inspect
import os
import pathlib
import pickle
import re
import subprocess
import tempfile
import unittest
import warnings

os.environ["MPLBACKEND"] = "Agg"
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402

import flexslip  # noqa: E402
from flexslip._errors import advice  # noqa: E402
from package import DESIGN, EXAMPLES, PROGRAM, SOURCE, campaign_of_examples, case, fitted  # noqa: E402

os.chdir(SOURCE)


def without_force():
    """The fit of a record that shows none."""
    return flexslip.fit(np.linspace(0, 5e-4, 60), np.zeros(60), diameter="34.8 um", modulus="29.6 GPa", span="1278 um", stiffness=90.65)


def drawn():
    """Every kind of figure: its name, and the axes."""
    for name in EXAMPLES:
        fit = fitted(name)
        for figure in fit._part("figures"):
            yield f"{name} {figure['name']}", fit.plot(figure["name"])
    for name in "simulated", "cyclic", "cracked":
        yield f"simulate {name}", flexslip.simulate(f"examples/{name}/truth.toml").plot()
    yield "design", flexslip.design(DESIGN).plot()
    yield "design over one", flexslip.design(DESIGN, over={"stiffness": ("10 N/m", "1000 N/m", 5)}).plot()
    yield "design over two", flexslip.design(DESIGN, over={"stiffness": ("10 N/m", "1000 N/m", 5), "mu0": (0.1, 0.9, 4)}).plot()
    campaign = campaign_of_examples()
    for figure in campaign._part("figures"):
        yield f"campaign {figure['name']}", campaign.plot(figure["name"])
    yield "equilibrium", flexslip.equilibrium(DESIGN).plot()
    yield "region", flexslip.equilibrium_region(DESIGN, points=50).plot()
    not_explained = flexslip.fit(case("simulated"), modulus="1 GPa")
    yield "no answer", not_explained.plot()
    yield "no force", without_force().plot()
    for name in EXAMPLES:
        yield f"modulus {name}", flexslip.modulus(case(name)).plot()
    yield "no modulus", flexslip.modulus(without_force().case).plot()


class Figures(unittest.TestCase):
    def tearDown(self):
        plt.close("all")

    def test_outside_every_figure_is_drawn_with_labels_and_without_a_warning(self):
        names = []
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for name, axes in drawn():
                with self.subTest(name):
                    each = np.atleast_1d(np.asarray(axes, dtype=object)).ravel()
                    with tempfile.TemporaryFile() as file:
                        each[0].figure.savefig(file, format="svg")
                    labels = [ax.get_xlabel() + ax.get_ylabel() + each[0].figure.get_supxlabel() if hasattr(each[0].figure, "get_supxlabel") else
                              ax.get_xlabel() + ax.get_ylabel() + "".join(text.get_text() for text in each[0].figure.texts) for ax in each]
                    self.assertTrue(all(labels), labels)
                    self.assertTrue(any(np.isfinite(line.get_xdata()).any() for ax in each for line in ax.lines))
                    plt.close(each[0].figure)
                    names.append(name)
        for name in ("cyclic passes", "cyclic boxes", "equilibrium", "region"):
            self.assertIn(name, names)

    def test_outside_matplotlib_finds_every_font(self):
        fit = fitted("simulated")
        with self.assertNoLogs("matplotlib", "WARNING"):
            for figure in fit._part("figures"):
                with tempfile.TemporaryFile() as file:
                    np.atleast_1d(np.asarray(fit.plot(figure["name"]), dtype=object)).ravel()[0].figure.savefig(file)

    def test_outside_a_fit_has_the_figures_of_its_report(self):
        for name in EXAMPLES:
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([PROGRAM, "fit", case(name), "--quiet", "--report", folder], check=True, capture_output=True)
                of_report = {path.stem for path in pathlib.Path(folder, "figures").glob("*.gp")}
            self.assertEqual({figure["name"] for figure in fitted(name)._part("figures")}, of_report, name)

    def test_identity_what_is_drawn_of_passes_is_the_data_of_the_report(self):
        fit = fitted("cyclic")
        figures = {figure["name"]: figure for figure in fit._part("figures")}
        data = {name: figure["data"] for name, figure in figures.items()}
        drawn = [line.get_xydata() for line in fit.plot("passes").lines]
        for which in "pass_1", "pass_2", "pass_3":
            wanted = np.column_stack(list(data["passes"][which].values()))
            self.assertTrue(any(each.shape == wanted.shape and np.array_equal(each, wanted, equal_nan=True) for each in drawn), which)
        self.assertEqual(len(fit.passes.passes), 3)

    def test_identity_ranges_titles_and_colours_are_those_of_the_report(self):
        fit = fitted("simulated")
        for figure in fit._part("figures"):
            axes = np.atleast_1d(np.asarray(fit.plot(figure["name"]), dtype=object)).ravel()
            titles = [mark["title"] for panel in figure["panels"] for mark in panel["marks"] if mark["title"]]
            self.assertEqual(len([text for legend in axes[0].figure.legends for text in legend.get_texts()]), len(titles))
            for panel, ax in zip(figure["panels"], axes):
                self.assertEqual((*ax.get_xlim(), *ax.get_ylim()), (panel["x"]["from"], panel["x"]["to"], panel["y"]["from"], panel["y"]["to"]))
                lines = [mark for mark in panel["marks"] if mark["kind"] in ("line", "points") and (mark["table"] or mark["at"])]
                self.assertEqual([line.get_color() for line in ax.lines], [mark["style"]["colour"] for mark in lines])
                self.assertEqual([line.get_linewidth() for line in ax.lines], [mark["style"]["width"] for mark in lines])

    def test_outside_units_on_the_axes_are_those_of_the_report(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "fit", case("simulated"), "--quiet", "--report", folder], check=True, capture_output=True)
            script = pathlib.Path(folder, "figures/force.gp").read_text(encoding="utf-8")
        units = re.findall(r"\(([^)']*)\)' at screen", script)
        axes = fitted("simulated").plot()
        self.assertEqual(sorted(re.findall(r"\(([^)]*)\)$", label)[0] for label in (axes[0].get_ylabel(), axes[1].get_xlabel(), axes[1].get_ylabel())), sorted(units))

    def test_identity_measured_points_are_those_of_the_curves(self):
        fit = fitted("simulated")
        line = fit.plot()[0].lines[-1]  # on top of all others
        np.testing.assert_allclose(line.get_xdata(), 1e6 * fit.curves.deflection, rtol=1e-12)  # µm; the products round
        np.testing.assert_allclose(line.get_ydata(), 1e3 * fit.curves.force, rtol=1e-12)

    def test_identity_a_test_without_a_fit_has_its_record(self):
        fit = without_force()
        line = fit.plot().lines[-1]
        np.testing.assert_allclose(line.get_xdata(), 1e6 * fit.curves.deflection, rtol=1e-12)
        self.assertEqual(len(pickle.loads(pickle.dumps(fit)).plot("record").lines), 2)
        self.assertRaises(ValueError, fit.plot, "force")
        self.assertEqual(len(fitted("simulated").plot()), 2)

    def test_identity_the_chord_and_the_linear_region_lie_on_the_record(self):
        found = flexslip.modulus(case("simulated"))
        lines = {line.get_label().split(":")[0]: line for line in found.plot().lines}
        measured, chord, region = (lines[name] for name in ("Measured", "Chord of ISO 178", "Linear region"))
        np.testing.assert_allclose(chord.get_xdata(), 1e6 * np.asarray(found.chord.deflection), rtol=1e-12)
        self.assertEqual(chord.get_label(), f"Chord of ISO 178: {found.chord.modulus}")
        of_line = np.diff(region.get_ydata())[0] / np.diff(region.get_xdata())[0] * 1e3  # N/m, of mN and µm
        self.assertAlmostEqual(of_line / found.stiffness.value, 1, delta=1e-9)
        noise = 2 * found.stiffness.stderr / found.stiffness.value * np.max(region.get_ydata())
        for line in chord, region:
            np.testing.assert_allclose(line.get_ydata(), np.interp(line.get_xdata(), measured.get_xdata(), measured.get_ydata()), atol=noise)
        figure, axes = plt.subplots()
        self.assertIs(found.plot(axes), axes)
        self.assertEqual(len(pickle.loads(pickle.dumps(found)).plot().lines), 4)

    def test_outside_a_campaign_and_a_map_are_one_table_and_one_figure(self):
        for thing in campaign_of_examples(), flexslip.design(DESIGN, over={"stiffness": (10, 40, 3), "mu0": (0.1, 0.9, 4)}):
            page = thing._repr_html_()
            self.assertEqual((page.count("<table"), page.count("<img")), (1, 1))
            self.assertEqual(plt.get_fignums(), [])
        page = campaign_of_examples()._repr_html_()
        self.assertIn(str(fitted("simulated").params.mu0), page)
        self.assertLess(len(re.findall("<th>", page.split("</thead>")[0])), 20)

    def test_outside_axes_of_ones_own(self):
        fit = fitted("simulated")
        figure, axes = plt.subplots(1, 2)
        self.assertIs(fit.plot("force", ax=axes[0]), axes[0])
        self.assertIs(fit.plot("profile", ax=axes[1]), axes[1])
        both = fit.plot(ax=axes)
        self.assertEqual(list(both), list(axes))
        before = plt.rcParams["font.size"]
        self.assertEqual(before, plt.rcParamsDefault["font.size"])  # a figure changes no settings of others
        self.assertRaises(flexslip.InputError, fit.plot, "spam")
        self.assertRaises(flexslip.InputError, fit.plot, "profile", ax=axes)
        self.assertRaises(TypeError, fit.plot, "profile", ax=3)
        again = pickle.loads(pickle.dumps(fit))
        self.assertEqual(len(again.plot()[0].lines), len(fit.plot()[0].lines))


    def test_outside_axes_of_ones_own_have_ones_own_letters(self):
        fit = fitted("simulated")
        with plt.rc_context({"font.size": 7, "legend.fontsize": 5}):
            figure, axes = plt.subplots(2, 1, sharex=True)
            upper, lower = fit.plot("force", ax=axes)
        self.assertEqual({text.get_size() for text in upper.get_legend().get_texts()}, {5})
        self.assertEqual(upper.xaxis.label.get_size(), 7)
        self.assertEqual((upper.get_xlabel(), lower.get_xlabel()[:10]), ("", "Deflection"))
        figure, axes = plt.subplots()
        self.assertEqual(fit.plot("force", ax=axes).get_xlabel()[:10], "Deflection")
        keys = [axes.get_legend() for axes in fit.plot("force", ax=plt.subplots(2, 1)[1])]
        beyond = [mark for mark in fit._part("figures")[0]["panels"][1]["marks"] if mark["style"]["symbol"] in ("down", "triangle")]
        self.assertEqual([text.get_text() for text in keys[1].get_texts()] if keys[1] else [], ["Beyond the axis"] * len(beyond))

    def test_identity_a_figure_in_other_units_is_the_same_figure(self):
        fit = fitted("cyclic")
        for figure, factors in (("force", (1e-3, 1)), ("profile", (1e-3, 1)), ("passes", (1e-3, 1e-3)), ("boxes", (1e-3, 1))):
            units = ("mm", "N") if figure == "passes" else "mm"
            usual, other = (np.atleast_1d(np.asarray(fit.plot(figure, unit=unit), dtype=object)) for unit in (None, units))
            for one, two in zip(usual, other):
                self.assertRegex(two.get_xlabel() or "(mm)", r"\(mm\)$")  # empty where another panel has it
                np.testing.assert_allclose(two.get_xlim(), factors[0] * np.array(one.get_xlim()), rtol=1e-12)
                np.testing.assert_allclose(two.get_ylim(), factors[1] * np.array(one.get_ylim()), rtol=1e-12)
                for first, second in zip(one.lines, two.lines):
                    np.testing.assert_allclose(second.get_xydata(), first.get_xydata() * factors, rtol=1e-12)
        self.assertRaisesRegex(flexslip.InputError, r'^unit: This must be a unit of length or force, "mm", .* not K', fit.plot, unit="K")

    def test_outside_the_record_alone_is_drawn_of_any_fit(self):
        line = fitted("simulated").plot("record").lines[-1]
        np.testing.assert_allclose(line.get_ydata(), 1e3 * fitted("simulated").curves.force, rtol=1e-12)

    def test_identity_a_map_of_designs_shows_drops_where_the_specimen_snaps(self):
        found = flexslip.design(DESIGN, over={"stiffness": ("10 N/m", "10000 N/m", 7)})
        drops, first = found.plot()
        snaps = found.designs.snaps > 0
        self.assertTrue(0 < snaps.sum() < 7)
        for line in drops.lines[:2]:
            np.testing.assert_array_equal(np.isfinite(line.get_ydata()), snaps)
        ends = found.designs.stiffness[snaps]
        self.assertEqual(first.get_title("left"), f"B   Snaps from {ends.min():.3g} to {ends.max():.3g} N/m, {snaps.sum()} of 7")
        never = flexslip.design(DESIGN, friction={"mu0": 0.01}, over={"stiffness": ("10 N/m", "20 N/m", 2)}).plot()
        self.assertEqual(never.get_title("left"), "A   No snaps")


class Parser(html.parser.HTMLParser):
    """Counts tags that are open."""

    def __init__(self, text):
        super().__init__()
        self.open = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag not in ("br", "hr", "img", "meta", "input"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


class Words(unittest.TestCase):
    def answers(self):
        fit = fitted("cyclic")
        yield from (fit, fit.params, fit.profile, fit.drops, fit.judgement, fit.params.mu0, fit.describe(), fit.draws, fit.curves, fit.case,
                    flexslip.fit(case("simulated"), modulus="1 GPa"), flexslip.simulate("examples/cyclic/truth.toml"), flexslip.design(DESIGN),
                    flexslip.design(DESIGN, over={"mu0": (0.1, 0.9, 3)}), flexslip.friction_profile(case("simulated")),
                    flexslip.read("examples/simulated/test.csv"), flexslip.equilibrium(DESIGN), flexslip.equilibrium_region(DESIGN, points=9),
                    flexslip.modulus(case("simulated")), campaign_of_examples(), campaign_of_examples().tests)

    def test_outside_everything_is_shown(self):
        for answer in self.answers():
            with self.subTest(type(answer).__name__):
                self.assertTrue(repr(answer))
                self.assertNotIn("object at 0x", repr(answer))
                if hasattr(answer, "_repr_html_"):
                    self.assertEqual(Parser(answer._repr_html_()).open, [])
                dir(answer)

    def test_outside_a_fit_of_every_kind_says_its_answer(self):
        rig, specimen = {"span": "1278 um", "stiffness": 90.65}, {"diameter": "34.8 um", "modulus": ("29.6 GPa", "3 %")}
        smooth = flexslip.simulate(rig=rig, specimen=specimen, friction={"model": "constant", "mu0": 0.0}, stage={"program": [0, "600 um"], "step": "2 um"},
                                   noise="10 uN", seed=3).path
        few = smooth.stage < 50e-6
        for code, status, fit in (("slip", "ok", fitted("simulated")), ("crack", "ok", fitted("cracked")),
                                  ("check_input", "ok", flexslip.fit(case("simulated"), stiffness="inf")),
                                  ("check_input", "not_explained", flexslip.fit(case("simulated"), modulus="1 GPa")),
                                  ("no_drops", "ok", flexslip.fit(smooth.stage, smooth.force, rig=rig, specimen=specimen)),
                                  ("no_drops", "too_few_points", flexslip.fit(np.linspace(0, 50e-6, 60), np.interp(np.linspace(0, 50e-6, 60), smooth.stage, smooth.force),
                                                                              rig=rig, specimen=specimen))):
            with self.subTest(code, status=status):
                self.assertEqual((fit.verdict.code, fit.status, few.sum() > 10), (code, status, True))
                self.assertTrue(fit.message.startswith(fit.verdict.sentence))
                words = " ".join(repr(fit).split())
                self.assertTrue(words.startswith(f"{fit.name}: {fit.verdict.sentence}"), words)
                page = fit._repr_html_()
                self.assertEqual(Parser(page).open, [])
                for told in (*(advice(f"{doubt.sentence} {doubt.remedy}".strip()) for doubt in fit.doubts), fit.next):
                    self.assertIn(told, words)
                    self.assertIn(html.escape(told), page)
                has_parameters = code in ("slip", "no_drops") and fit.success
                self.assertEqual("bending_stiffness" in words, has_parameters)
                self.assertEqual("bending_stiffness" in page, has_parameters)
                for shown in (words, page, fit.message, *map(repr, (fit[name] for name in fit if fit[name] is not None and not isinstance(fit[name], float)))):
                    self.assertNotRegex(shown, r"\b(None|nan|NaN)\b")
                for figure in fit._part("figures"):
                    self.assertTrue(len(np.atleast_1d(np.asarray(fit.plot(figure["name"]), dtype=object))))
                    plt.close("all")
                fit.summary(), fit.summary(full=True), fit.to_frame(), fit.describe()
                self.assertEqual(pickle.loads(pickle.dumps(fit)), fit)

    def test_outside_a_campaign_says_its_answer(self):
        campaign = campaign_of_examples()
        self.assertTrue(repr(campaign).startswith("4 tests: 3 SLIP, 1 CRACK."), repr(campaign))
        self.assertTrue(campaign.summary().startswith(repr(campaign)))
        self.assertEqual(Parser(campaign._repr_html_()).open, [])
        labels = [text.get_text() for text in campaign.plot()[-1].get_xticklabels()]  # which the panel above shares
        self.assertEqual(sorted(labels), ["cyclic", "simulated", "surface"])  # the cracked one determines no friction
        told = [text.get_text() for legend in campaign.plot()[0].figure.legends for text in legend.get_texts()]
        self.assertNotIn("Suspect", told)  # whose friction cannot be told

    def test_outside_tables_are_shown_in_units_that_suit_them(self):
        fit = fitted("simulated")
        def shown(thing):
            return " ".join(re.sub("<[^>]*>", " ", html.unescape(thing._repr_html_())).split())

        self.assertRegex(shown(fit.drops), r"row_before row_after stage \[µm\] .* force_fall \[(µ|m)N\] .* pulled_in \[µm\] ")
        self.assertRegex(shown(flexslip.design(DESIGN, over={"stiffness": (10, 40, 3)})), r"stiffness \[N/m\] .* largest_drop \[[µm]N\]")
        self.assertIn("work_of_fracture [µJ]", [*campaign_of_examples()._table()._shown()])
        for table in fit.drops, fit.curves, fit.sensitivities:
            cells = [float(cell) for column in table._shown() for cell in table._shown()[column] if re.fullmatch(r"-?[\d.]+(e-?\d+)?", cell)]
            self.assertGreater(len(cells), 10)
        forces = fit.curves._shown()["force [mN]"]
        np.testing.assert_allclose(forces.astype(float), 1e3 * fit.curves.force, atol=0.005)  # four digits of 10 mN
        self.assertIn("<caption>Fitted parameters of the friction model</caption>", fit.params._repr_html_())
        for part in fit.params, fit.energy, fit.judgement, fit.measurement, flexslip.design(DESIGN), fit.drops[0]:
            self.assertRegex(part._repr_html_(), "<caption>([A-Z][a-z-]*) ")  # a sentence, no name of a class

    def test_identity_an_estimate_rounds_and_compares_as_its_value(self):
        fit = fitted("simulated")
        mu0, wavelength = fit.params.mu0, fit.params.wavelength
        self.assertEqual((round(mu0, 2), round(mu0), float(mu0)), (round(mu0.value, 2), 1, mu0.value))
        self.assertTrue(mu0 > 0.3 and 0.3 < mu0 and mu0 >= mu0 and mu0 <= mu0.value and mu0 == mu0.value and mu0 < fitted("surface").params.mu0)
        self.assertEqual((hash(mu0), max(mu0, 0.7), sorted([mu0, 0.1])[0]), (hash(mu0.value), 0.7, 0.1))
        self.assertEqual((np.array([0.1, 0.9]) > mu0).tolist(), [False, True])
        self.assertTrue(mu0 != wavelength and mu0 != "mu0" and np.float64(0.3) < mu0 and mu0 < flexslip.Quantity(0.9, "1"))
        with self.assertRaisesRegex(TypeError, "a number in 1 cannot be compared with one in m"):
            mu0 < wavelength
        self.assertRaises(TypeError, lambda: mu0 < "0.3")
        unknown = flexslip.fit(case("simulated"), model="constant").params.wavelength
        self.assertFalse(unknown < 1 or unknown >= 1 or unknown == unknown)

    def test_identity_a_plain_number_scales_and_shifts_an_estimate(self):
        params = fitted("simulated").params
        for estimate in params.mu0, params.wavelength, -params.wavelength:
            low, high = estimate.ci95
            for made, factor, by in ((2 * estimate, 2, 0), (estimate * np.float64(2), 2, 0), (np.float64(2) * estimate, 2, 0), (estimate / 1e-6, 1e6, 0), (-estimate, -1, 0),
                                     (estimate + 1, 1, 1), (1 - estimate, -1, 1), (estimate - np.float64(1), 1, -1), (abs(estimate), np.sign(estimate.value), 0),
                                     (sum([estimate]), 1, 0), (estimate * flexslip.Quantity(2.0, "1"), 2, 0)):
                np.testing.assert_allclose((made.value, made.stderr, *made.ci95), (factor * estimate.value + by, abs(factor) * estimate.stderr,
                                           *sorted((factor * low + by, factor * high + by))), rtol=1e-15)
                self.assertEqual((made.unit, made.name), (estimate.unit, estimate.name))
        mu0 = params.mu0
        for call, told in ((lambda: mu0 + mu0, "how their errors go together is unknown. Take their values"), (lambda: sum([mu0, mu0]), "errors go together"),
                           (lambda: mu0 * params.wavelength, "errors go together"), (lambda: 1 / mu0, "as in 1 / estimate.value"),
                           (lambda: mu0 * flexslip.Quantity(1.0, "m"), "not with one in m"), (lambda: mu0 * "2", "")):
            with self.assertRaisesRegex(TypeError, told):
                call()
        self.assertEqual(pickle.loads(pickle.dumps(2 * mu0)), 2 * mu0)

    def test_outside_an_estimate_is_formatted_as_its_value(self):
        mu0 = fitted("simulated").params.mu0
        self.assertEqual((f"{mu0:.3f}", f"{mu0:>8.1e}", f"{mu0}"), (f"{mu0.value:.3f}", f"{mu0.value:>8.1e}", str(mu0)))

    def test_outside_numbers_are_rounded_by_their_errors_in_units_that_read_well(self):
        fit = fitted("simulated")
        self.assertRegex(str(fit.params.wavelength), r"^10\.9\d\d ± 0\.0\d\d µm$")
        self.assertRegex(repr(fit.params.bending_stiffness), r"^<bending_stiffness: 2\.1\d\d ± 0\.0\d\d mN mm²>$")
        self.assertRegex(repr(fit), r"\n  mu0 +0\.50\d ± 0\.016\n")
        self.assertRegex(repr(fit.energy), r"work_of_fracture +7\.02\d µJ")
        self.assertRegex(repr(fit.drops), r"^<\d+ rows: row_before, .*force_before \[N\]")
        self.assertRegex(repr(flexslip.simulate("examples/cyclic/truth.toml").energy), "µJ")
        self.assertEqual(str(flexslip.fit(case("simulated"), model="constant").params.wavelength), "unknown")  # of what a model has not

    def test_outside_docstrings_list_the_keys_that_a_function_can_use(self):
        for function, can, cannot in ((flexslip.fit, ("span", "force", "zero"), ("cracks",)), (flexslip.design, ("span", "cracks"), ("force", "zero", "sign")),
                                      (flexslip.modulus, ("force",), ("cracks",)), (flexslip.simulate, ("cracks",), ("until",))):
            lines = function.__doc__.split("Other Parameters")[1].splitlines()
            named = [line.split(" : ")[0].strip() for line in lines if " : " in line]
            for name in can:
                self.assertIn(name, named, function)
            for name in cannot:
                self.assertNotIn(name, named, function)
                self.assertNotIn(name, inspect.signature(function).parameters)
            for below in lines[lines.index(next(line for line in lines if " : " in line)) + 1::2]:
                self.assertRegex(below, r"^        [A-Z].*\.$|^    $")

    def test_outside_words_are_those_of_the_program(self):
        fit = fitted("simulated")
        printed = subprocess.run([PROGRAM, "fit", case("simulated"), "--quiet"], capture_output=True, text=True, check=True).stdout
        full = subprocess.run([PROGRAM, "fit", case("simulated"), "--quiet", "--full"], capture_output=True, text=True, check=True).stdout
        self.assertEqual((fit.summary(), fit.summary(full=True)), (advice(printed), advice(full)))
        self.assertIn("More: summary(full=True)", fit.summary())
        printed = subprocess.run([PROGRAM, "design", DESIGN, "--quiet"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(flexslip.design(DESIGN).summary(), printed)

    def test_outside_no_answer_speaks_of_flags_or_of_sections_of_a_file(self):
        of_shell = re.compile(r"--[a-z]|\[(?:specimen|rig|record|friction|stage)\]|\bflexslip (?:read|fit|modulus|design)\b")

        def all_words(value):
            if isinstance(value, str):
                yield value
            elif isinstance(value, flexslip.types.Answer):
                yield from (words for name in value if name != "case" for words in all_words(value[name]))
            elif isinstance(value, (list, tuple, flexslip.types.Table)):
                yield from (words for each in value for words in all_words(each))

        export = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()), "export.csv")
        export.write_text("Weg (mm);Kraft (N)\n" + "".join(f"{i / 10};{i / 7:.4f}\n" for i in range(40)), encoding="utf-8")
        modulus = flexslip.modulus(case("cyclic"))
        answers = [*map(fitted, EXAMPLES), flexslip.fit(case("simulated"), modulus="1 GPa"), flexslip.design(DESIGN, decide=True), flexslip.read(export), modulus]
        for answer in answers:
            for words in (*all_words(answer), *(answer.summary() for _ in range(hasattr(answer, "summary"))), *(answer.summary(full=True) for _ in range(isinstance(answer, flexslip.Fit)))):
                self.assertNotRegex(words, of_shell)
        self.assertIn('displacement="crosshead', flexslip.read(export).asks[0])
        self.assertIn('pass modulus="fit"', flexslip.fit(case("simulated"), modulus="1 MPa").findings[0].remedy)

    def test_outside_the_arguments_that_repeat_a_reading_do(self):
        export = flexslip.read("examples/simulated/test.csv")
        again = eval(f"dict({export.repeat_with})")
        self.assertEqual(again["separator"], ",")
        self.assertEqual(flexslip.read("examples/simulated/test.csv", **again), export)

    def test_outside_parts_of_an_answer_show_their_values(self):
        fit = fitted("cyclic")
        self.assertRegex(repr(fit.judgement), r"causes +slips 0\.\d+; cracks \S+")
        self.assertRegex(repr(fit.energy), r"friction_share_interval95 +0\.\d+, 0\.\d+")
        self.assertRegex(repr(flexslip.modulus(case("cyclic"))), r"window +from 0\.\d+; .*of_force [\d.]+ mN")
        self.assertRegex(repr(flexslip.design(DESIGN, decide=True).reload), r"least +travel \d+ µm; unload_to")
        self.assertRegex(repr(fit.passes.passes).splitlines()[1], r"^in +400.822|^in ")
        export = flexslip.read("examples/simulated/test.csv")
        cells = re.findall("<td>([^<]*)</td>", export._repr_html_())[:12]
        self.assertEqual((cells[1:4], cells[7:10]), (["stage", "um", "crosshead"], ["force", "mN", "force"]))
        self.assertEqual(repr(export.columns).splitlines()[0].split(), ["number", "name", "unit", "role", "first", "last"])

    def test_outside_every_number_has_its_meaning(self):
        fit = fitted("simulated")
        told = {line[0] for line in fit.describe()}
        page = (SOURCE / "docs/results.md").read_text(encoding="utf-8")
        for name in "parameters.mu0", "profile[].mu_error", "energy.friction_share":
            self.assertIn(name, told)
            self.assertIn(f"`{name}`", page)
        self.assertIn("mean friction", type(fit.params).mu0.__doc__)


class Frames(unittest.TestCase):
    def test_identity_frames_hold_the_columns(self):
        fit = fitted("simulated")
        for table in fit.profile, fit.curves, fit.drops:
            frame = table.to_frame()
            self.assertIsInstance(frame, pandas.DataFrame)
            self.assertEqual(len(frame), len(table))
            for name in table.keys():
                values = table[name]
                if values.dtype == object and isinstance(values[0], flexslip.Estimate):
                    values = [each.value for each in values]
                np.testing.assert_array_equal(frame[name].to_numpy(), values)
        frame = fit.draws.to_frame()
        self.assertEqual([frame.attrs["units"][name] for name in ("length", "mu", "draw_20")], ["m", "1", "1"])
        self.assertEqual({*frame.attrs["units"]}, {*frame.columns})
        frame = fit.to_frame()
        self.assertEqual(frame.attrs["units"], {name: value.unit for name, value in fit.params.items() if name in frame.index})
        self.assertEqual(frame.loc["mu0", "value"], fit.params.mu0.value)
        self.assertEqual((frame.loc["wavelength", "low95"], frame.loc["wavelength", "high95"]), fit.params.wavelength.ci95)

    def test_identity_rows_hold_the_columns(self):
        fit = fitted("simulated")
        self.assertEqual([row.mu for row in fit.profile], fit.profile.mu.tolist())
        self.assertEqual(fit.profile[-1].mu, fit.profile.mu[-1])
        self.assertEqual([row.mu for row in fit.profile[2:9:3]], fit.profile.mu[2:9:3].tolist())
        self.assertRaises(IndexError, lambda: fit.profile[len(fit.profile)])
        self.assertRaises(AttributeError, lambda: fit.profile.spam)
        self.assertRaises(AttributeError, lambda: fit.spam)
        self.assertRaises(KeyError, lambda: fit["spam"])


if __name__ == "__main__":
    unittest.main()
