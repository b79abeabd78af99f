#!/usr/bin/python3
"""outside: how a file becomes a record, and the numbers of the bending standards: identities, truth, and exports of real machines
against regressions in numpy."""
import csv
import itertools
import json
import math
import random
import re
import unittest

from program import SOURCE, InFolder, against, run, words_of

EXAMPLE = SOURCE / "examples/simulated"
CASE = EXAMPLE / "case.toml"
DATA = EXAMPLE / "test.csv"
FLAGS = ["--diameter", "34.8 um", "--span", "1278 um", "--stiffness", "90.65 N/m", "--supports", "edges", "--stage", "stage", "--force", "force"]
INSTRUMENTS = (SOURCE / "../shared/data/instruments").resolve()
STEPS = {"columns", "missing", "metadata", "sign", "thinning", "holds", "way_back", "spikes", "zero", "compliance", "loading", "overload", "end", "stage", "contact"}
KEYS = {"step", "changed", "done", "value", "uncertainty", "unit", "rows", "key"}
# A bar of ISO 178: E = 2.7 GPa, 10 mm x 4 mm, span 64 mm.
MODULUS = 2.7e9
STIFFNESS = 48 * MODULUS * (10e-3 * 4e-3**3 / 12) / 64e-3**3  # N/m
LOAD_TRAIN = 2e6  # N/m
BAR = ["--span", "64 mm", "--width", "10 mm", "--height", "4 mm"]


def bar_test(sign=1, tare=0.0, noise=0.02, rows=300):
    """(crosshead [mm], deflection [mm], force [N]): 0.2 mm before the contact, then a straight rise."""
    draw = random.Random(5)
    columns = []
    for i in range(rows):
        crosshead = 0.01e-3 * i
        deflection = max(0.0, crosshead - 0.2e-3) / (1 + STIFFNESS / LOAD_TRAIN)
        force = STIFFNESS * deflection + tare + draw.gauss(0, noise)
        columns.append((sign * 1e3 * crosshead, sign * 1e3 * (deflection + min(0.0, crosshead - 0.2e-3)), sign * force))
    return columns


def bluehill(columns, which=0, preamble=()):
    lines = [*preamble, "", "Extension,Load", "(mm),(N)", *(f'"{row[which]:.6f}","{row[2]:.5f}"' for row in columns)]
    return "\r\n".join(lines) + "\r\n"


def step(answer, name):
    return next(each for each in answer["preparation"] if each["step"] == name)


def without_provenance(answer):
    return {key: value for key, value in answer.items() if key not in {"provenance", "name", "preparation"}}


class Steps(InFolder):
    def test_limit_rows_are_those_of_the_file_after_thinning(self):
        """8501 rows, of which one in five is used: the last of them stands for itself alone."""
        rows = 8501
        rig = '[specimen]\nbending_stiffness = "1e-9 N m^2"\n[rig]\nspan = "1 mm"\nstiffness = "90 N/m"\n'
        made = self.file("made.toml", f'{rig}[friction]\nmodel = "constant"\nmu0 = 0.3\n[stage]\nprogram = ["0 um", "425 um"]\nstep = "0.05 um"\n')
        data = self.folder / "test.csv"
        self.succeeds("simulate", made, "--noise", "10 uN", "-o", data)
        self.assertEqual(len(data.read_text(encoding="utf-8").splitlines()), rows + 1)
        case = self.file("case.toml", f'{rig}[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\nfailure = "none"\n')
        fit = self.json("fit", case, "--model", "constant")
        self.assertTrue(next(step["done"] for step in fit["preparation"] if step["step"] == "thinning").startswith("one row in 5 is used"))
        self.assertEqual(fit["measurement"]["last_row"], rows)
        self.assertEqual(self.json("invert", case, "--quiet")["last_row"], rows)
        self.assertLessEqual(self.json("modulus", case, "--window", 0.9, 1)["window"]["rows"][1], rows)
        self.assertIn(f"record rows 1–{rows}", " ".join(self.succeeds("fit", case, "--model", "constant", "--full").split()))

    def test_outside_schema(self):
        for command in ("fit", "modulus"):
            answer = self.json(command, CASE)
            self.assertLessEqual({each["step"] for each in answer["preparation"]}, STEPS)
            for each in answer["preparation"]:
                self.assertEqual(set(each), KEYS)

    def test_outside_steps_stand_in_text_and_report(self):
        text = " ".join(self.succeeds("fit", CASE, "--full").split())
        run("fit", CASE, "--report", self.folder / "report")
        page = (self.folder / "report/report.html").read_text(encoding="utf-8")
        self.assertIn("From the file to the record", page)
        for each in self.json("fit", CASE)["preparation"]:
            self.assertIn(each["done"], text)
            self.assertIn(each["done"], page.replace("&#39;", "'"))

    def test_identity_reversed_columns_give_the_same_fit(self):
        lines = DATA.read_text(encoding="utf-8").splitlines()
        turn = lambda cell: cell[1:] if cell.startswith("-") else "-" + cell
        reversed_lines = [",".join(map(turn, line.split(","))) if line[:1] in "-0123456789" else line for line in lines]
        path = self.file("reversed.csv", "\n".join(reversed_lines) + "\n")
        straight = self.json("fit", DATA, *FLAGS)
        turned = self.json("fit", path, *FLAGS)
        self.assertTrue(step(turned, "sign")["changed"])
        self.assertFalse(step(straight, "sign")["changed"])
        self.assertEqual(without_provenance(turned), without_provenance(straight))

    def test_identity_keys_say_what_flags_say(self):
        extra = {"sign": "keep", "zero": "0.05 mN", "contact": "first row", "failure": "none"}
        flags = [word for key, value in extra.items() for word in (f"--{key}", value)]
        case = CASE.read_text(encoding="utf-8").replace('"test.csv"', f'"{DATA}"')
        case += "".join(f'{key} = "{value}"\n' for key, value in extra.items())
        self.assertIn("[record]", case)
        by_case = self.json("fit", self.file("case.toml", case), "--model", "constant")
        modulus = re.search(r"bending_stiffness|modulus", case).group()
        self.assertTrue(modulus)
        by_flags = self.json("fit", DATA, *FLAGS, *flags, "--model", "constant")
        for name in ("sign", "zero", "end", "contact"):
            self.assertEqual(step(by_case, name), step(by_flags, name))
        self.assertEqual(step(by_flags, "zero")["value"], 0.05e-3)

    def test_limit_what_cannot_be_is_refused(self):
        self.refused("fit", DATA, *FLAGS, "--sign", "flip", says=["--sign", '"reverse"'])
        self.refused("fit", DATA, *FLAGS, "--zero", "3 um", says=["--zero", "a force"])
        self.refused("fit", DATA, *FLAGS, "--displacement", "crosshead", says=["--displacement", "both stage and displacement"])
        self.refused("fit", DATA, *FLAGS, "--inner-diameter", "40 um", says=["--inner-diameter", "below the outer"])
        self.refused("fit", DATA, *FLAGS, "--until", "x", says=["--until"])


class Loading(InFolder):
    """A fibre with a friction of 0.5 that nothing but the record itself disturbs."""

    RIG = '[specimen]\nbending_stiffness = "2.13e-9 N m^2"\n[rig]\nspan = "1278 um"\nstiffness = "90.65 N/m"\nsupports = "edges"\n'

    def simulated(self, program='["0 um", "600 um"]', seed=3):
        made = self.file("made.toml", self.RIG + f'[friction]\nmodel = "constant"\nmu0 = 0.5\n[stage]\nprogram = {program}\nstep = "2 um"\n')
        self.succeeds("simulate", made, "--noise", "10 uN", "--seed", seed, "-o", self.folder / "made.csv")
        with open(self.folder / "made.csv", encoding="utf-8") as file:
            return [(float(row["w_s [m]"]), float(row["F [N]"])) for row in csv.DictReader(file)]

    def fitted(self, rows, *flags):
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{stage:.9e},{force:.9e}\n" for stage, force in rows))
        return self.json("fit", self.file("case.toml", self.RIG + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n'), *flags)

    def friction_is_half(self, fit):
        self.assertEqual(fit["verdict"]["code"], "no_drops", fit["verdict"])
        mu0 = fit["parameters"]["mu0"]
        self.assertLess(abs(mu0["value"] - 0.5), mu0["standard_error"])

    def test_truth_a_stage_reading_that_none_can_be_is_left_out(self):
        rows = self.simulated()
        for place in (99e-3, 0.0):
            stray = [(place, force) if at == 150 else (stage, force) for at, (stage, force) in enumerate(rows)]
            fit = self.fitted(stray)
            self.friction_is_half(fit)
            self.assertIn("row 151", step(fit, "stray")["done"])
            self.assertEqual(fit["measurement"]["last_row"], len(rows))

    def test_truth_the_end_of_a_load_cell_with_noise_is_seen(self):
        rows = self.simulated()
        end = 0.6 * max(force for _, force in rows)
        first = next(at for at, (_, force) in enumerate(rows) if force > end)
        clipped = [(stage, min(force, end) + (5e-7 * math.sin(at * at) if force > end else 0)) for at, (stage, force) in enumerate(rows)]
        fit = self.fitted(clipped)
        self.friction_is_half(fit)
        self.assertEqual(fit["measurement"]["ends_with"], "overload")
        self.assertLess(abs(fit["measurement"]["last_row"] - first), 6)

    def test_limit_rows_that_run_backwards_are_refused(self):
        for program in ('["0 um", "600 um"]', '["0 um", "1000 um"]'):  # the force of the second has fallen to below half
            rows = self.simulated(program)
            self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{stage:.9e},{force:.9e}\n" for stage, force in rows[::-1]))
            case = self.file("case.toml", self.RIG + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n')
            self.refused("fit", case, says=["test.csv", "the force", "write them in the reverse order"])

    def test_identity_rows_without_a_number_shift_no_others(self):
        """Rows are those of the file: said, listed and stated."""
        rows = self.simulated()
        gone = range(10, 18)
        lines = [f"{stage:.9e},{'NaN' if at in gone else f'{force:.9e}'}\n" for at, (stage, force) in enumerate(rows)]
        case = self.RIG + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\nuntil = 200\n'
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(lines))
        fit = self.json("fit", self.file("case.toml", case))
        self.assertEqual((fit["measurement"]["rows"], fit["measurement"]["last_row"]), (len(rows), 200))
        lines[250] = lines[250].split(",")[0] + ",OVER\n"  # the sensor is at its end in row 251
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(lines))
        case = self.RIG + '[record]\nfile = "test.csv"\ndisplacement = "crosshead"\ndisplacement_column = "w_s"\nforce = "F"\nuntil = 250\n'
        fit = self.json("fit", self.file("case.toml", case))
        self.assertIn(fit["measurement"]["last_row"], (250, 251))  # up to the row before the next reading
        self.refused("fit", self.file("case.toml", case.replace("250", "260")), says=["test.csv:252", "OVER"])

    def test_truth_slips_beyond_the_greatest_force_are_no_break(self):
        """Bent to two thirds of the span on a stiff rig: the force falls below its half by a slip like others."""
        made = self.file("made.toml", self.RIG.replace("90.65", "400") + '[friction]\nmodel = "sinusoid"\nmu0 = 0.5\namplitude = 0.3\nwavelength = "25 um"\n'
                         '[stage]\nprogram = ["0 um", "900 um"]\nstep = "2 um"\n')
        self.succeeds("simulate", made, "--noise", "10 uN", "-o", self.folder / "made.csv")
        fit = self.json("fit", self.file("case.toml", self.RIG.replace("90.65", "400") + '[record]\nfile = "made.csv"\nstage = "w_s"\nforce = "F"\n'))
        self.assertEqual(fit["measurement"]["ends_with"], "last_row")
        self.assertGreater(len(fit["drops"]), 15)
        mu0 = fit["parameters"]["mu0"]
        self.assertLess(abs(mu0["value"] - 0.5), 2 * mu0["standard_error"])

    def test_truth_a_force_that_yields_is_no_end_of_the_load_cell(self):
        rows = self.simulated()
        end = 0.6 * max(force for _, force in rows)
        first = next(at for at, (_, force) in enumerate(rows) if force > end)
        draw = random.Random(4)
        yielding = [(stage, force if at < first else end - 2e-6 * (at - first) + draw.gauss(0, 1e-5)) for at, (stage, force) in enumerate(rows)]
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{stage:.9e},{force:.9e}\n" for stage, force in yielding))
        case = self.file("case.toml", self.RIG + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n')
        fit = json.loads(run("fit", case, "--json").stdout)
        self.assertEqual(fit["verdict"]["code"], "crack")
        self.assertIn("yielded", next(each["sentence"] for each in fit["findings"] if each["code"] == "cracks"))
        self.assertNotEqual(fit["measurement"]["ends_with"], "overload")

    def test_truth_a_logger_that_runs_on_while_the_stage_halts_costs_no_rows(self):
        rows = self.simulated()
        draw = random.Random(5)
        at_rest = [(rows[-1][0], rows[-1][1] + draw.gauss(0, 1e-5)) for _ in range(20000)]
        fit = self.fitted(rows + at_rest)
        self.friction_is_half(fit)
        self.assertNotIn("thinning", {each["step"] for each in fit["preparation"]})
        self.assertRegex(words_of(fit, "record"), r"\b20000 with the stage at rest left out")

    def test_truth_a_zero_of_the_force_that_is_too_low_is_named(self):
        rows = [(stage, force - 3e-4) for stage, force in self.simulated()]
        fit = self.fitted(rows)
        below = next(each for each in fit["findings"] if each["code"] == "begins_under_force")
        self.assertEqual(below["severity"], "doubt")
        self.assertRegex(below["remedy"], r'zero = "-2\d\d(\.\d)? µN"')

    def test_bad_input_rows_out_of_the_order_of_their_times(self):
        rows = self.simulated()
        lines = [f"{0.1 * at:.2f},{stage:.9e},{force:.9e}\n" for at, (stage, force) in enumerate(rows)]
        case = '[record]\nfile = "test.csv"\ndisplacement = "crosshead"\ndisplacement_column = "w_s"\nforce = "F"\n'
        for wrong in (lines[:150] + lines[150:170][::-1] + lines[170:], lines[:200] + lines[150:]):
            self.file("test.csv", "time [s],w_s [m],F [N]\n" + "".join(wrong))
            self.refused("fit", self.file("case.toml", self.RIG + case), says=["test.csv", "'time'", "the order of their times"])
        anew = [f"{0.1 * (at % 200):.2f},{line.split(',', 1)[1]}" for at, line in enumerate(lines)]  # the clock begins anew
        self.file("test.csv", "time [s],w_s [m],F [N]\n" + "".join(anew))
        self.friction_is_half(self.json("fit", self.file("case.toml", self.RIG + case)))

    def test_truth_single_readings_that_none_can_be_are_left_out(self):
        rows = self.simulated()
        for change in (lambda force: force - 0.4e-3, lambda force: force + 2e-3, lambda force: 0.0):
            for length in (1, 3):
                spiked = list(rows)
                for at in (110, 170, 240):
                    for k in range(at, at + length):
                        spiked[k] = (rows[k][0], change(rows[k][1]))
                fit = self.fitted(spiked)
                self.friction_is_half(fit)
                self.assertIn(f"{3 * length} readings", step(fit, "spikes")["done"])
                self.assertIn(f"{3 * length} spikes left out", words_of(fit, "record"))
        self.assertNotIn("spikes", {each["step"] for each in self.fitted(rows)["preparation"]})

    def test_truth_one_reading_turns_no_sign(self):
        rows = self.simulated()
        for at, force in itertools.product((30, 200, len(rows) - 3), (-20e-3, -999.0, 50e-3)):
            self.friction_is_half(self.fitted([(stage, force if i == at else each) for i, (stage, each) in enumerate(rows)]))

    def test_truth_rows_that_are_not_of_the_test_cost_none_of_it(self):
        """A long approach, a logger that runs on, a way back of the stage: before and after the load, stated or not."""
        rows = self.simulated()
        draw = random.Random(2)
        free = lambda stages: [(stage, draw.gauss(0, 1e-5)) for stage in stages]
        approach = free(-2e-6 * i for i in range(3000, 0, -1))
        runs_on = free(rows[-1][0] + 2e-6 * i for i in range(1, 6001))
        way_back = free(1e-3 - 5e-6 * i for i in range(200))
        for before, behind in (([], runs_on), (approach, []), (approach, runs_on), (way_back, [])):
            fit = self.fitted(before + rows + behind)
            self.friction_is_half(fit)
            self.assertLess(fit["parameters"]["mu0"]["standard_error"], 1.2 * self.fitted(rows)["parameters"]["mu0"]["standard_error"])
        first, last = len(approach) + 1, len(approach) + len(rows)
        wrong = [(stage, -20e-3) for stage, _ in runs_on]
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{stage:.9e},{force:.9e}\n" for stage, force in [*approach, *rows, *wrong]))
        stated = self.file("case.toml", self.RIG + f'[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\nfirst = {first}\nuntil = {last}\n')
        self.friction_is_half(self.json("fit", stated))

    def test_bad_input_the_end_before_the_beginning(self):
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{stage:.9e},{force:.9e}\n" for stage, force in self.simulated()))
        record = '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n'
        for first, until in (("200", "100"), ('"500 um"', '"200 um"'), ("2", '"-5 mm"')):
            case = self.file("case.toml", self.RIG + record + f"first = {first}\nuntil = {until}\n")
            for command in ("fit", "modulus", "invert"):
                self.refused(command, case, says=["first", "after its end"])

    def test_bad_input_rows_backwards_and_a_second_record(self):
        rows = self.simulated()
        titles = "Time [s],Displacement [mm],Force [N]\n"
        line = lambda i, row: f"{i * 0.5},{1e3 * row[0]:.6f},{row[1]:.9e}\n"
        lines = [line(i, row) for i, row in enumerate(rows)]
        flags = ["--span", "1278 um", "--bending-stiffness", "2.13e-9 N m^2", "--stiffness", "90.65 N/m", "--displacement", "crosshead"]
        self.friction_is_half(self.json("fit", self.file("once.csv", titles + "".join(lines)), *flags))
        self.refused("fit", self.file("back.csv", titles + "".join(reversed(lines))), *flags, says=["Time falls from row to row", "reverse order"])
        twice = self.file("twice.csv", titles + "".join(lines) + "".join(lines))
        self.refused("fit", twice, *flags, says=[f"--until {len(rows)}", f"--first {len(rows) + 1}"])
        for part in (["--until", len(rows)], ["--first", len(rows) + 1]):
            self.friction_is_half(self.json("fit", twice, *flags, *part))

    def test_truth_small_cycles_before_the_test_do_not_hide_it(self):
        for cycles, far in itertools.product((1, 3), ("40 um", "8 um")):
            program = '["0 um"' + f', "{far}", "2 um"' * cycles + ', "600 um"]'
            rows = self.simulated(program)
            fit = self.fitted(rows)
            self.friction_is_half(fit)
            self.assertEqual(fit["measurement"]["last_row"], len(rows))
            self.assertIn(f"loading {cycles + 1} of {cycles + 1}", words_of(fit, "record"))

    def test_limit_a_first_loading_that_goes_about_as_far_is_the_test(self):
        fit = self.fitted(self.simulated('["0 um", "590 um", "4 um", "600 um"]'))
        self.assertIn("loading 1 of 2", words_of(fit, "record"))
        self.assertTrue(fit["judgement"]["stiffness_lost_error"])

    def test_truth_the_loading_before_the_damage_is_the_test(self):
        rows = self.simulated('["0 um", "400 um", "4 um", "520 um"]')
        turn = max(range(len(rows)), key=lambda row: rows[row][0] * (rows[row][0] < 401e-6))
        fit = self.fitted(rows[:turn + 1] + [(stage, 0.5 * force) for stage, force in rows[turn + 1:]])
        self.assertIn("loading 1 of 2", words_of(fit, "record"))
        self.assertIn("no later one reaches its force again", step(fit, "loading")["done"])
        self.assertEqual(fit["verdict"]["code"], "crack")
        whole = self.fitted(rows)
        self.assertIn("loading 2 of 2", words_of(whole, "record"))

    def test_bad_input_a_stage_in_a_wrong_unit_is_beyond_the_span(self):
        rows = self.simulated()
        self.file("test.csv", "w_s [m],F [N]\n" + "".join(f"{1000 * stage:.9e},{force:.9e}\n" for stage, force in rows))
        for supports in 'supports = "edges"', 'roller_radius = "10 um"':
            rig = self.RIG.replace('supports = "edges"', supports)
            refused = run("fit", self.file("case.toml", rig + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n'))
            self.assertEqual(refused.returncode, 1, refused.stderr)
            self.assertIn("which is impossible", " ".join(refused.stdout.split()))

    def test_truth_a_break_is_found_at_any_rate_of_reading(self):
        rows = self.simulated('["0 um", "520 um"]')
        stage, force = rows[-1]
        for readings in (1, 15, 25, 100):
            falls = [(stage + 0.5e-6 * (k + 1) / readings, force * (1 - 0.93 * (k + 1) / readings) + 1e-5 * (-1) ** k) for k in range(readings)]
            after = [(stage + 2e-6 * (k + 1), 0.07 * force + 1e-5 * (-1) ** k) for k in range(30)]
            fit = self.fitted(rows + falls + after)
            self.friction_is_half(fit)
            self.assertEqual(fit["measurement"]["ends_with"], "failure")
            self.assertLessEqual(abs(fit["measurement"]["last_row"] - len(rows)), max(2, readings / 20))

    def test_truth_the_end_of_the_load_cell_is_named(self):
        rows = self.simulated()
        end = 0.85 * max(force for _, force in rows)
        fit = self.fitted([(stage, min(force, end)) for stage, force in rows])
        self.friction_is_half(fit)
        self.assertEqual(fit["measurement"]["ends_with"], "overload")
        self.assertIn("the load cell was overloaded", words_of(fit, "record"))

    def test_limit_a_hold_is_no_drop(self):
        """The stage halts while the force relaxes by a fiftieth, and goes on."""
        rows = self.simulated()
        for length in (10, 80):
            hold = [(rows[150][0], rows[150][1] * (0.98 + 0.02 * math.exp(-5 * k / length)) + 1e-5 * (-1) ** k) for k in range(length)]
            fit = self.fitted(rows[:151] + hold + rows[151:])
            self.friction_is_half(fit)
            self.assertIn(f"{length} with the stage at rest", words_of(fit, "record"))

    def test_truth_relaxation_at_rest_is_told_and_widens_the_error_unless_it_is_stated(self):
        """The stage halts for 60 rows while the force falls to 97 % of itself, and stays there."""
        rows = self.simulated()
        hold = [(rows[150][0], rows[150][1] * (1 - 0.03 * k / 60)) for k in range(1, 61)]
        relaxed = rows[:151] + hold + [(stage, 0.97 * force) for stage, force in rows[151:]]
        fit, still = self.fitted(relaxed), self.fitted(rows)
        told = fit["measurement"]["relaxation"]
        self.assertAlmostEqual(told["value"], 0.03 * 53 / 60, delta=3 * told["standard_error"] + 1e-6)
        self.assertIsNone(still["measurement"]["relaxation"])
        self.assertIn("relaxes", [finding["code"] for finding in fit["findings"]])
        model = lambda of: words_of(of, "model")
        self.assertIn("no relaxation during the test", model(still))
        self.assertNotIn("relax", model(fit))
        error = lambda of: of["parameters"]["mu0"]["standard_error"]
        self.assertGreater(error(fit), 1.5 * error(still))
        stated = self.fitted(relaxed, "--set", "record.slow_force_error=0.65 %")
        self.assertLess(error(stated), 1.2 * error(still))
        self.refused("fit", self.folder / "case.toml", "--set", "record.slow_force_error=31 %", says=["record.slow_force_error", "above the limit of 0.3"])

    def test_limit_what_relaxes_during_a_hold_and_stays_relaxed_is_no_drop(self):
        draw = random.Random(9)
        rows = [(0.01 * i, 0.01 * i, STIFFNESS * 1e-3 * 0.01 * i * (0.85 if i > 250 else 1) + draw.gauss(0, 0.02)) for i in range(400)]
        held = [(2.5, 2.5, rows[250][2] * (0.85 + 0.15 * math.exp(-k)) + draw.gauss(0, 0.02)) for k in range(1, 9)]
        fit = self.json("fit", self.file("bar.csv", bluehill(rows[:251] + held + rows[251:], 1)), *BAR, "--displacement", "deflection", "--modulus", "3 GPa",
                        "--supports", "edges", "--stiffness", "inf")
        self.assertEqual(fit["verdict"]["code"], "no_drops", fit["verdict"])

    def reloaded(self, stiffness_left, first=3.0, second=3.0):
        """fit of a bar that is bent to a deflection [mm], unloaded, and bent again, so many times as stiff."""
        draw = random.Random(4)
        ways = [(0.01 * i, 1) for i in range(int(100 * first))] + [(first - 0.01 * i, 1) for i in range(1, int(100 * first))]
        ways += [(0.01 * i, stiffness_left) for i in range(int(100 * second))]
        rows = [(w, w, STIFFNESS * 1e-3 * w * left + draw.gauss(0, 0.02)) for w, left in ways]
        return self.json("fit", self.file("bar.csv", bluehill(rows, 1)), *BAR, "--displacement", "deflection", "--modulus", "2.7 GPa",
                         "--supports", "edges", "--stiffness", "inf")

    def test_truth_a_bar_that_is_softer_when_it_is_loaded_again_lost_stiffness(self):
        for second in 3.0, 4.4:
            fit = self.reloaded(0.7, second=second)
            self.assertEqual(fit["verdict"]["code"], "crack", fit["verdict"])
            self.assertIn("CRACK. The specimen lost 29.5 ± 6.9 % of its stiffness", fit["verdict"]["sentence"])
            self.assertIn("too small to determine friction", words_of(fit, "friction"))
            self.assertIn("29.5 ± 6.9 %", words_of(fit, "reload"))
        as_stiff = self.reloaded(1)
        self.assertEqual(as_stiff["verdict"]["code"], "no_drops", as_stiff["verdict"])
        self.assertNotIn("changed_reload", against(as_stiff))

    def test_limit_what_relaxes_during_a_hold_is_no_drop_of_another_loading(self):
        draw = random.Random(9)
        way = lambda most, left: [(0.01 * i, left if i > 150 else 1) for i in range(most)]
        held = [(1.5, 0.85 + 0.15 * math.exp(-k)) for k in range(1, 9)]
        up = way(151, 1) + held + way(300, 0.85)[151:]
        down = [(3 - 0.01 * i, 0.85) for i in range(1, 300)]
        flags = (*BAR, "--displacement", "deflection", "--modulus", "2.7 GPa", "--supports", "edges", "--stiffness", "inf")
        readings = lambda ways: [(w, w, STIFFNESS * 1e-3 * w * left + draw.gauss(0, 0.02)) for w, left in ways]
        twice = self.json("fit", self.file("bar.csv", bluehill(readings(up + down + [(0.01 * i, 0.85) for i in range(400)]), 1)), *flags)
        self.assertIn("loading 2 of 2", words_of(twice, "record"))
        self.assertNotIn("drops_elsewhere", [finding["code"] for finding in twice["findings"]])

    def test_truth_drops_behind_the_break_are_counted(self):
        draw = random.Random(4)
        rows = [(0.01 * i, 0.01 * i, STIFFNESS * 1e-3 * 0.01 * i * (1 if i <= 280 else 0.45 if i <= 295 else 0.3) + draw.gauss(0, 0.02)) for i in range(310)]
        path = self.file("bar.csv", bluehill(rows, 1))
        flags = (*BAR, "--displacement", "deflection", "--supports", "edges", "--stiffness", "inf")
        broken = self.json("fit", path, *flags)
        self.assertEqual((broken["measurement"]["ends_with"], broken["measurement"]["last_row"]), ("failure", 281))
        self.assertIn("; 1 more drop after the break", words_of(broken, "record"))
        stated = self.json("fit", path, *flags, "--until", "250")
        self.assertIn("; 2 more drops after that row", words_of(stated, "record"))
        self.assertNotIn("after", words_of(self.json("fit", path, *flags, "--failure", "none"), "record"))

    def test_truth_drops_of_a_bar_that_stay_are_cracks(self):
        """64 by 4 mm, bent by 3 mm."""
        for loss, verdict in ((0.25, "crack"), (0.03, "crack"), (0, "no_drops")):
            draw = random.Random(8)
            rows = [(0.01 * i, 0.01 * i, STIFFNESS * 1e-3 * 0.01 * i * (1 - loss if i > 250 else 1) + draw.gauss(0, 0.02)) for i in range(400)]
            path = self.file("bar.csv", bluehill(rows, 1))
            flags = (*BAR, "--displacement", "deflection", "--modulus", "3 GPa", "--supports", "edges", "--stiffness", "inf")
            fit = self.json("fit", path, *flags)
            self.assertEqual(fit["verdict"]["code"], verdict, fit["verdict"])
            self.assertEqual(run("fit", path, *flags).returncode, 0)
            self.assertIn("too small to determine friction", words_of(fit, "friction"))


class Bar(InFolder):
    def modulus(self, columns, *arguments, which=0, preamble=()):
        return self.json("modulus", self.file("bar.csv", bluehill(columns, which, preamble)), *arguments)

    def test_truth_of_a_crosshead_corrected(self):
        found = self.modulus(bar_test(), *BAR, "--displacement", "crosshead", "--stiffness", f"{LOAD_TRAIN} N/m")
        for name, truth in (("stiffness", STIFFNESS), ("modulus", MODULUS)):
            self.assertLess(abs(found[name]["value"] - truth), 5 * found[name]["standard_error"], name)
        self.assertLess(abs(found["chord"]["modulus"]["value"] - MODULUS), 5 * found["chord"]["modulus"]["standard_error"])
        uncorrected = self.modulus(bar_test(), *BAR, "--displacement", "crosshead", "--stiffness", "inf")
        # The springs in series, as ISO 178 warns.
        series = 1 / (1 / STIFFNESS + 1 / LOAD_TRAIN)
        self.assertLess(abs(uncorrected["stiffness"]["value"] - series), 5 * uncorrected["stiffness"]["standard_error"])

    def test_truth_of_a_deflectometer(self):
        found = self.modulus(bar_test(), *BAR, "--displacement", "deflection", which=1)
        self.assertLess(abs(found["modulus"]["value"] - MODULUS), 5 * found["modulus"]["standard_error"])
        self.assertIn("no load-train stiffness is stated", step(found, "compliance")["done"])

    def test_identity_sign_and_tare(self):
        flags = [*BAR, "--displacement", "crosshead", "--stiffness", f"{LOAD_TRAIN} N/m"]
        plain = self.modulus(bar_test(noise=0), *flags)
        turned = self.modulus(bar_test(sign=-1, noise=0), *flags)
        self.assertEqual(plain["stiffness"], turned["stiffness"])
        tared = self.modulus(bar_test(tare=3.25), *flags)
        offset = step(tared, "zero")
        self.assertTrue(offset["changed"])
        self.assertLess(abs(offset["value"] - 3.25), 5 * offset["uncertainty"])
        self.assertEqual(offset["unit"], "N")
        kept = self.modulus(bar_test(tare=3.25), *flags, "--zero", "keep")
        self.assertAlmostEqual(kept["greatest_force"]["value"] - tared["greatest_force"]["value"], offset["value"], places=9)

    def test_limit_a_displacement_of_unknown_kind_is_asked_for(self):
        path = self.file("bar.csv", bluehill(bar_test()))
        self.refused("modulus", path, *BAR, says=["2 more inputs are needed", "'Extension'", "--displacement crosshead|deflection", "--stiffness"])
        self.refused("modulus", path, *BAR, "--stiffness", "inf", says=["'Extension'", "--displacement crosshead", '"deflection"', "ISO 178"])
        self.refused("modulus", path, *BAR, "--displacement", "crosshead", says=["--stiffness", '"inf"'])

    def test_identity_titles_of_a_file_with_a_preamble(self):
        flags = [*BAR, "--stiffness", f"{LOAD_TRAIN} N/m"]
        path = self.file("bar.csv", bluehill(bar_test(), preamble=["Operator,somebody"]))
        titled = self.json("modulus", path, "--stage", "Extension [mm]", "--force", "Load [N]", *flags)
        self.assertEqual(titled["modulus"], self.modulus(bar_test(), "--displacement", "crosshead", *flags)["modulus"])

    def test_identity_span_and_section_of_the_file(self):
        preamble = ["Support span : Support span,64,mm", "Width : Width,10,mm", "Thickness : Thickness,4,mm"]
        flags = ["--displacement", "crosshead", "--stiffness", f"{LOAD_TRAIN} N/m"]
        told = self.modulus(bar_test(), *flags, preamble=preamble)
        stated = self.modulus(bar_test(), *BAR, *flags)
        self.assertEqual(told["modulus"], stated["modulus"])
        self.assertEqual([each["value"] for each in told["preparation"] if each["step"] == "metadata"], [0.064, 0.01, 0.004])
        self.assertEqual([each for each in stated["preparation"] if each["step"] == "metadata"], [])

    def test_limit_no_section_of_a_file_that_states_two(self):
        """The form of a machine lists diameter, width and thickness, whatever the specimen is."""
        preamble = ["Span,64,mm", "Diameter,15,mm", "Width,10,mm", "Thickness,4,mm"]
        flags = ["--displacement", "crosshead", "--stiffness", f"{LOAD_TRAIN} N/m"]
        told = self.modulus(bar_test(), *flags, preamble=preamble)
        self.assertIsNone(told["modulus"])
        said = [each for each in told["preparation"] if "no section is taken from the file" in each["done"]]
        self.assertEqual([(each["value"], each["key"]) for each in said], [(None, '[specimen] diameter = "…"')])
        self.assertEqual(self.modulus(bar_test(), *BAR, *flags, preamble=preamble)["modulus"], self.modulus(bar_test(), *BAR, *flags)["modulus"])

    def test_outside_three_significant_digits(self):
        path = self.file("bar.csv", bluehill(bar_test()))
        text = self.succeeds("modulus", path, *BAR, "--displacement", "crosshead", "--stiffness", f"{LOAD_TRAIN} N/m")
        self.assertRegex(text, r"flexural modulus 2\.\d\d (± 0\.\d\d GPa|GPa ± 0\.\d+ %) ")
        self.assertRegex(text, r"\n  maximum  .*: (\d\d\d|\d\d\.\d|\d\.\d\d) MPa, strain ")

    def test_outside_a_tube_against_the_formula(self):
        flags = ["--displacement", "deflection", "--span", "64 mm", "--diameter", "6 mm"]
        moment = math.pi * (6e-3**4 - 5e-3**4) / 64
        for hollow in (["--inner-diameter", "5 mm"], ["--wall", "0.5 mm"]):
            found = self.modulus(bar_test(), *flags, *hollow, which=1)
            self.assertAlmostEqual(found["linear_modulus"]["value"] * moment / (found["stiffness"]["value"] * 64e-3**3 / 48), 1, places=12)

    def test_outside_fit_shows_the_same_number(self):
        fit, modulus = self.json("fit", CASE), self.json("modulus", CASE)
        self.assertAlmostEqual(fit["small_deflection"]["over_fit"],
                               modulus["bending_stiffness"]["value"] / fit["parameters"]["bending_stiffness"]["value"], delta=1e-14)  # roundings
        self.assertIs(modulus["deflection_large"], True)

    def yielding(self, step, rows, noise=0.4):
        """A steel bar, 10 x 2 mm on 60 mm, that yields at 400 N: 296 N/mm, then 20 N/mm."""
        draw = random.Random(7)
        deflections = [step * i for i in range(rows)]
        return [(w, w, 296 * min(w, 400 / 296) + 20 * max(w - 400 / 296, 0) + draw.gauss(0, noise)) for w in deflections]

    def test_truth_few_rows_cost_error_and_not_the_answer(self):
        bar = ["--displacement", "deflection", "--span", "60 mm", "--width", "10 mm", "--height", "2 mm"]
        truth = 296e3 * 60e-3**3 / (48 * 10e-3 * 2e-3**3 / 12)
        for step_of, rows in ((0.02, 400), (0.15, 60), (0.3, 28), (0.42, 20)):
            with self.subTest(step=step_of):
                found = self.modulus(self.yielding(step_of, rows), *bar)
                self.assertLess(abs(found["linear_modulus"]["value"] / truth - 1), 0.01)
                self.assertGreaterEqual(found["origin"]["value"], 0)
                self.assertLess(found["origin"]["value"], 0.01e-3)

    def test_limit_a_record_that_is_the_load_train(self):
        """A bar of 2.7 GPa is read as the load train, or the load train as the bar: 99 % of the displacement is that of 10 kN/mm."""
        draw = random.Random(3)
        rows = [(0.0002 * i,) * 2 + (0.0002 * i * 9.9e3 + draw.gauss(0, 0.5),) for i in range(150)]
        path = self.file("bar.csv", bluehill(rows))
        flags = [*BAR, "--displacement", "crosshead"]
        result = run("modulus", path, *flags, "--stiffness", "10 kN/mm")
        self.assertEqual(result.returncode, 1)
        for words in result.stdout, result.stderr:
            self.assertIn("The load train takes 99 % of the displacement", " ".join(words.split()))
            self.assertIn("Check the units of force and displacement", " ".join(words.split()))
        self.assertNotIn("GPa", result.stdout)
        answer = json.loads(run("modulus", path, *flags, "--stiffness", "10 kN/mm", "--json").stdout)
        self.assertEqual(answer["status"], "uncertain")
        self.assertIsNone(answer["modulus"])
        self.assertAlmostEqual(answer["load_train_share"], 0.99, delta=0.005)
        # Known to a part in ten thousand, the load train leaves something to tell.
        exact = run("modulus", path, *flags, "--stiffness", "10 kN/mm +- 0.01 %", "--json")
        self.assertNotEqual(json.loads(exact.stdout)["status"], "no_straight_part")

    def test_identity_a_reload_changes_no_modulus_of_the_first_loading(self):
        """Friction makes a reload stiffer until it meets the first curve again; there the specimen goes on as if it had not been unloaded."""
        curve = lambda w: (w, 120 * w - 6 * w**2)  # noqa: E731  [mm], [N]
        first, beyond = [curve(0.01 * i) for i in range(101)], [curve(0.01 * i) for i in range(101, 300)]
        back = [(1 - 0.01 * i, 114 - 1.4 * i) for i in range(1, 61)]
        again = [(0.4 + 0.01 * i, 30 + 1.4 * i) for i in range(1, 61)]
        answers = []
        for name, rows in (("once", [*first, *beyond]), ("twice", [*first, *back, *again, *beyond])):
            path = self.file(f"{name}.csv", "w [mm],F [N]\n" + "".join(f"{w!r},{force!r}\n" for w, force in rows))
            answers.append(self.json("modulus", path, *BAR, "--deflection", "w", "--force", "F"))
        once, twice = answers
        for key in "window", "stiffness", "linear_modulus", "chord", "origin", "greatest_force", "stress", "ends_rising":
            self.assertEqual(twice[key], once[key], key)
        self.assertIn("loading 2 of 2 is evaluated", step(twice, "loading")["done"])

    def test_limit_a_modulus_of_no_material(self):
        rows = [(each[0], each[1], 1000 * each[2]) for each in bar_test()]  # kgf for gf
        path = self.file("bar.csv", bluehill(rows))
        result = run("modulus", path, *BAR, "--displacement", "crosshead", "--stiffness", "inf", "--json")
        self.assertEqual(result.returncode, 1)
        answer = json.loads(result.stdout)
        self.assertEqual((answer["status"], answer["modulus"]), ("too_stiff", None))
        self.assertIn("no material exceeds 1200 GPa", result.stderr)
        self.assertIn("units", result.stderr)

    def test_truth_what_a_testing_machine_lists(self):
        """Softens from 3 mm on, and breaks at 3.5 mm."""
        draw = random.Random(4)
        rows = []
        for i in range(420):
            w = 0.01 * i
            force = 1e-3 * STIFFNESS * (min(w, 3) - 0.5 * max(w - 3, 0)) if w <= 3.5 else 0
            rows.append((w, w, force + draw.gauss(0, 0.02)))
        found = self.modulus(rows, *BAR, "--displacement", "deflection", which=1)
        for place, w, force in ((found, 3e-3, 3e-3 * STIFFNESS), (found["at_break"], 3.5e-3, 2.75e-3 * STIFFNESS)):
            numbers = {name: place[name]["value"] for name in ("deflection", "stress", "strain")}
            self.assertAlmostEqual(numbers["deflection"], w, delta=0.03e-3)
            self.assertAlmostEqual(numbers["strain"], 6 * w * 4e-3 / 64e-3**2, delta=2e-4)
            self.assertAlmostEqual(numbers["stress"], 3 * force * 64e-3 / (2 * 10e-3 * 4e-3**2), delta=0.01 * numbers["stress"])
        call = ["modulus", self.file("bar.csv", bluehill(rows, 1)), *BAR, "--displacement", "deflection"]
        screen = self.succeeds(*call)
        self.assertRegex(screen, r"\n  maximum .*\(strength\)\n  break  .* MPa, strain ")
        self.assertLessEqual(len(screen.splitlines()), 12)
        self.assertLessEqual(max(map(len, screen.splitlines())), 100)
        text = self.succeeds(*call, "--full")
        for name in ("maximum force", "flexural strength σ_fM", "flexural strain at the maximum force", "force at break", "flexural stress at break σ_fB", "flexural strain at break"):
            self.assertIn(name, text)
        whole = self.modulus(rows[:300], *BAR, "--displacement", "deflection", which=1)
        self.assertIsNone(whole["at_break"])
        unbroken = self.succeeds("modulus", self.file("bar.csv", bluehill(rows[:300], 1)), *BAR, "--displacement", "deflection", "--full")
        self.assertIn("still rising: not a strength", unbroken)
        self.assertNotIn("flexural strength", unbroken)

    def test_limit_a_chord_in_the_toe_is_not_the_modulus_to_report(self):
        draw = random.Random(6)
        settle = lambda w: w * w / 2 if w < 1 else w - 0.5
        rows = [(0.01 * i, 0.01 * i, 1e-3 * STIFFNESS * settle(0.01 * i) + draw.gauss(0, 0.02)) for i in range(400)]
        found = self.modulus(rows, *BAR, "--displacement", "deflection", which=1)
        self.assertTrue(found["chord_in_toe"])
        self.assertLess(found["chord"]["modulus"]["value"], 0.9 * MODULUS)
        self.assertAlmostEqual(found["modulus"]["value"] / MODULUS, 1, delta=0.01)
        self.assertEqual(found["modulus"], found["linear_modulus"])
        call = ["modulus", self.file("bar.csv", bluehill(rows, 1)), *BAR, "--displacement", "deflection"]
        self.assertRegex(self.succeeds(*call), r"flexural modulus .* \(steepest linear part, .*\n  .* from the chord of ISO 178 .*, which lies in a toe")
        text = " ".join(self.succeeds(*call, "--full").split())
        self.assertIn("lies in the toe", text)
        self.assertNotIn("Use the chord", text)

    def test_truth_a_chord_in_a_toe_is_not_explained_by_a_friction_that_its_supports_do_not_have(self):
        """A simulated bar of 2.5 GPa on rollers, whose contacts settle by 0.4 mm under 20 N."""
        made = self.file("made.toml", """[specimen]
width = "10 mm"
height = "4 mm"
modulus = "2.5 GPa"
[rig]
span = "64 mm"
stiffness = "inf"
roller_radius = "5 mm"
[friction]
model = "constant"
mu0 = 0.2
[stage]
program = ["0 mm", "6 mm"]
step = "0.02 mm"
""")
        for settles in (0, 0.4e-3):
            draw = random.Random(2)
            curve = csv.DictReader(self.succeeds("simulate", made, "--quiet").splitlines())
            readings = [(float(row["w_s [m]"]), float(row["F [N]"])) for row in curve]
            readings = [(1e3 * (w + settles * (1 - math.exp(-F / 20))), F + draw.gauss(0, 0.02)) for w, F in readings]
            path = self.file("bar.csv", "w [mm],F [N]\n" + "".join(f"{w:.6f},{F:.5f}\n" for w, F in readings))
            flags = (*BAR, "--deflection", "w", "--force", "F", "--set", "rig.roller_radius=5 mm", "--stiffness", "inf")
            found = self.json("modulus", path, *flags)
            self.assertEqual(found["chord_in_toe"], settles > 0)
            self.assertAlmostEqual(found["modulus_less_supports"]["value"] / 2.5e9, 1, delta=0.06)
            screen, full = (self.succeeds("modulus", path, *flags, *more) for more in ([], ["--full"]))
            which, of = ("steepest linear part", "linear region") if settles else ("ISO 178 chord", "chord")
            self.assertRegex(screen.splitlines()[0], rf"flexural modulus .* \({which}, ")
            self.assertIn("contacts that move inwards add", screen)
            self.assertIn(f"E_f of the {of} without the effect of the supports", full)

    def test_limit_no_straight_part(self):
        path = self.file("flat.csv", "w [mm],F [N]\n" + "".join(f"{i},{(i + 1) % 2}\n" for i in range(40)))
        result = run("modulus", path, "--deflection", "w", "--force", "F", "--sign", "keep", "--json")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(json.loads(result.stdout)["status"], "no_straight_part")


@unittest.skipUnless(INSTRUMENTS.is_dir(), "skipped: no campaign data")
class RealMachines(InFolder):
    """The stiffness of each export against a regression in numpy over the rows that the program names."""

    def numbers_in(self, path, rows):
        """The first three numbers of each line that has that many and nothing else."""
        import numpy
        table = []
        for line in path.read_text(encoding="latin-1").splitlines():
            cells = [cell for cell in re.split(r"[,\s]+", line.replace('"', "").strip()) if cell]
            try:
                table.append([float(cell) for cell in cells[-3:]])
            except ValueError:
                continue
        table = [row for row in table if len(row) == 3]
        self.assertEqual(len(table), rows)
        return numpy.array(table)

    def check(self, name, columns, *arguments, rows, stiffness, units=(1e-3, 1)):
        """`stiffness` in N/mm, to 1 %: what is shown here does not move unnoticed. Units: of displacement and force, in SI."""
        import numpy
        path = INSTRUMENTS / name
        found = self.json("modulus", path, "--displacement", "crosshead", "--stiffness", "inf", *arguments)
        table = self.numbers_in(path, rows)
        w, F = (table[:, column] * unit for column, unit in zip(columns, units))
        first, last = found["window"]["rows"]
        thinning = [each for each in found["preparation"] if each["step"] == "thinning"]
        every = int(re.search(r"one row in (\d+)", thinning[0]["done"]).group(1)) if thinning else 1
        part = slice(first - 1, last, every)
        slope = numpy.polyfit(w[part], F[part], 1)[0]
        with self.subTest(name):
            # Where the stage trembles it is held, which moves a slope by less than its error.
            self.assertLess(abs(found["stiffness"]["value"] - slope), 0.1 * found["stiffness"]["standard_error"])
            self.assertAlmostEqual(found["stiffness"]["value"] / 1e3, stiffness, delta=0.01 * stiffness)
        return found

    def test_outside_maize(self):
        # Bluehill 3, span 17 mm; the diameters are not in the file.
        found = self.check("bluehill3_maize/1267_Specimen_RawData_1.csv", (1, 2), "--span", "17 mm", rows=1133, stiffness=5.81)
        self.assertAlmostEqual(found["greatest_force"]["value"], 6.95912)  # as the file's own metadata says
        self.check("bluehill3_maize/1267_Specimen_RawData_2.csv", (1, 2), "--span", "17 mm", rows=1882, stiffness=5.55)

    def test_outside_pla(self):
        # MTS 793, span 40.28 mm, compression negative; the section is not in the file. Force in kN.
        for name, rows, stiffness in (("1_3D850_s1", 6305, 39.3), ("4_3Devo_s1", 7267, 49.95), ("7_CR10_s1", 12050, 34.84)):
            found = self.check(f"mts793_pla/{name}.dat", (0, 1), "--span", "40.28 mm", rows=rows, stiffness=stiffness,
                               units=(-1e-3, -1e3))
            self.assertTrue(step(found, "sign")["changed"])
            bending = found["stiffness"]["value"] * 40.28e-3**3 / 48
            self.assertAlmostEqual(found["bending_stiffness"]["value"] / bending, 1, places=12)

    def test_outside_femur(self):
        found = self.check("cellscale_femur/A023Data.csv", (1, 2), rows=38, stiffness=71.7)
        tube = self.json("modulus", INSTRUMENTS / "cellscale_femur/A023Data.csv", "--displacement", "crosshead", "--stiffness", "inf", "--span", "8 mm", "--diameter", "1.5 mm", "--wall", "0.2 mm")
        self.assertIsNone(tube["chord"])
        self.assertAlmostEqual(tube["modulus"]["value"], 4.39e9, delta=0.05 * 4.39e9)
        self.assertAlmostEqual(tube["origin"]["value"], step(tube, "contact")["value"], places=12)  # one toe, one number
        self.assertEqual(step(found, "end")["rows"], [36, 38])  # 15.4 N, then 9.7 N, then nothing

    def test_outside_blades(self):
        self.check("bluehill_blades/WSR8001_july25_lateral.csv", (1, 2), rows=3004, stiffness=141.2)
        found = self.check("bluehill_blades/cyclic_Specimen_RawData_1.csv", (1, 2), rows=222, stiffness=1.476)
        self.assertIn("turns back after row 114", step(found, "loading")["done"])
        self.assertIsNone(found["at_break"])  # it slips as it turns, and bears 70 N on the way back

    def test_outside_fit_and_modulus_have_one_initial_slope(self):
        """Where a record tells no friction; a toe, a preload, a few rows that begin under load."""
        flags = ("--displacement", "crosshead", "--stiffness", "inf", "--diameter")
        for name, diameter, *more in (("cellscale_femur/A023Data.csv", "1.5 mm", "--span", "12 mm"),
                                      ("bluehill3_maize/1267_Specimen_RawData_1.csv", "3 mm", "--span", "17 mm"),
                                      ("bluehill3_maize/1267_Specimen_RawData_2.csv", "3 mm", "--span", "17 mm"),
                                      ("mts_testsuite_femur/C18-L-M-RF.txt", "1.5 mm", "--span", "8 mm", "--force", "2")):
            with self.subTest(name):
                modulus = self.json("modulus", INSTRUMENTS / name, *flags, diameter, *more)["bending_stiffness"]["value"]
                fit = self.json("fit", INSTRUMENTS / name, *flags, diameter, *more)
                self.assertEqual(fit["nominal_bending_stiffness"]["source"], "initial_slope")
                self.assertAlmostEqual(fit["nominal_bending_stiffness"]["nominal"] / modulus, 1, places=9)

    def test_outside_a_force_in_volts_is_refused(self):
        result = run("modulus", INSTRUMENTS / "mts_testsuite_femur/C18-L-M-RF.txt", "--displacement", "crosshead", "--stiffness", "inf")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--calibration", result.stderr)
        calibrated = self.json("modulus", INSTRUMENTS / "mts_testsuite_femur/C18-L-M-RF.txt", "--displacement", "crosshead",
                               "--stiffness", "inf", "--force", "4", "--calibration", "222 N/V")
        self.assertEqual(calibrated["status"], "ok")


if __name__ == "__main__":
    unittest.main()
