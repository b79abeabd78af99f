#!/usr/bin/python3
"""outside: wrong input and wrong calls get exit code 2 and a line that names the place and the remedy."""
import os
import unittest

from program import SOURCE, InFolder, run

RECORD = (SOURCE / "examples/simulated/test.csv").read_text(encoding="utf-8")
CASE = (SOURCE / "examples/simulated/case.toml").read_text(encoding="utf-8")
TRUTH = (SOURCE / "examples/simulated/truth.toml").read_text(encoding="utf-8")
HEADER = "stage [um],force [mN]\n"
COMMANDS = ("invert", "fit")


class BadRecord(InFolder):
    def refuses_record(self, content, *says):
        case = self.file("case.toml", CASE)
        self.file("test.csv", content)
        for command in COMMANDS:
            with self.subTest(command=command):
                self.refused(command, case, says=["test.csv", *says])

    def changed(self, line, text):
        """The example's record with another text on a line, counted from 1."""
        lines = RECORD.splitlines(keepends=True)
        lines[line - 1] = text + "\n"
        return "".join(lines)

    def test_empty_file(self):
        self.refuses_record("", "The file is empty")

    def test_header_only(self):
        self.refuses_record(HEADER, "holds numbers")

    def test_one_point(self):
        self.refuses_record(HEADER + "2,0.05\n", "Only 1 of 1 rows lie before failure")

    def test_a_missing_reading_is_left_out_and_said(self):
        case = self.file("case.toml", CASE)
        for line in ("192.000,nan", "192.000,---", "192.000,", "192.000,broken"):
            with self.subTest(line):
                self.file("test.csv", self.changed(100, line))
                self.assertIn("(1 without a number left out)", self.succeeds("fit", case))
                steps = {each["step"]: each["done"] for each in self.json("fit", case)["preparation"]}
                self.assertIn("one row without a number in 'force' is left out: line 100 holds", steps["missing"])

    def test_a_sensor_at_its_end(self):
        for cell in ("inf", "OVER", ">>>"):
            self.refuses_record(self.changed(100, f"192.000,{cell}"), ":100:", "force", "The sensor was overloaded", f"'{cell}'")

    def test_numbers_too_large_for_a_test(self):
        self.refuses_record(self.changed(100, "192.000,1e308").replace("mN", "kN"), ":100:", "too large", "Check the units")

    def test_missing_unit(self):
        self.refuses_record(RECORD.replace("force [mN]", "force"), "force", 'force = "force [N]"')

    def test_wrong_unit(self):
        self.refuses_record(RECORD.replace("force [mN]", "force [mm]"), "force", "'mm'")

    def test_unknown_unit(self):
        self.refuses_record(RECORD.replace("force [mN]", "force [mX]"), "force", "mX")

    def test_decimal_commas_are_read(self):
        case = self.file("case.toml", CASE)
        self.file("test.csv", RECORD)
        right = self.succeeds("invert", case)
        for separator in ";", ",":
            with self.subTest(separator):
                self.file("test.csv", RECORD.replace(",", ";").replace(".", ",").replace(";", separator))
                self.assertEqual(self.succeeds("invert", case), right)

    def test_a_row_of_other_cells_is_left_out_and_said(self):
        case = self.file("case.toml", CASE)
        for line in "192,000,7,5", "192.000":
            with self.subTest(line):
                self.file("test.csv", self.changed(100, line))
                (columns,) = [each["done"] for each in self.json("fit", case)["preparation"] if each["step"] == "columns"]
                self.assertIn("left out, because they do not have 2 cells: line 100", columns)

    def test_column_that_is_not_there(self):
        self.refuses_record(RECORD.replace("force [mN]", "forze [mN]"), "force", "Did you mean 'forze'?")

    def test_time_running_backwards(self):
        # Line 3 is the header, and the stage stands at 400 um on line 204.
        force = RECORD.splitlines()[203].split(",")[1]
        self.refuses_record(self.changed(204, f"390.000,{force}"), ":204:", "stage", "The stage moves back from 398", "until = 200")

    def test_binary_file(self):
        self.refuses_record(bytes(range(256)) * 16, "binary data")

    def test_directory(self):
        case = self.file("case.toml", CASE)
        (self.folder / "test.csv").mkdir()
        self.refused("invert", case, says=["test.csv", "a directory"])

    def test_file_that_is_not_there(self):
        self.refused("invert", self.file("case.toml", CASE), says=["test.csv", "No such file"])

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_file_that_must_not_be_read(self):
        case = self.file("case.toml", CASE)
        self.file("test.csv", RECORD).chmod(0)
        self.refused("invert", case, says=["test.csv", "Permission denied"])

    def test_until_beyond_the_record(self):
        self.file("test.csv", RECORD)
        case = self.file("case.toml", CASE + "until = 5000\n")
        self.refused("invert", case, says=["case.toml:20", "until", "426"])


class BadLoadTrain(InFolder):
    FLAGS = ("--diameter", "34.8 um", "--span", "1278 um", "--stage", "stage", "--force", "force")

    def test_missing_it_is_asked_for_without_the_number_of_another_rig(self):
        data = self.file("test.csv", RECORD)
        case = self.file("case.toml", "".join(line for line in CASE.splitlines(True) if "stiffness" not in line))
        for call in ((data, *self.FLAGS), (case,)):
            result = run("fit", *call)
            self.assertEqual(result.returncode, 2)
            self.assertIn("the stiffness of the load train", result.stderr)
            self.assertNotIn("90.65", result.stderr)

    def test_record_steeper_than_it(self):
        data = self.file("test.csv", RECORD)
        for command in ("fit", "modulus"):
            self.refused(command, data, *self.FLAGS, "--stiffness", "10 N/m",
                         says=["--stiffness", "The load train of 10 N/m yields by", "but the stage moved", "Check it and the units"])


class BadCase(InFolder):
    def refuses_case(self, content, *says, command="simulate"):
        self.refused(command, self.file("case.toml", content), says=["case.toml", *says])

    def test_empty_file(self):
        self.refuses_case("", "[specimen]", "Add diameter")

    def test_no_toml(self):
        self.refuses_case("this is a note\n", ":1:", "key = value")

    def test_directory(self):
        self.refused("simulate", self.folder, says=["a directory"])

    def test_binary_file(self):
        self.refuses_case(bytes(range(256)) * 16, "case file (TOML)")

    def test_negative_stiffness(self):
        self.refuses_case(TRUTH.replace("90.65", "-90.65"), ":9:", "[rig] stiffness", "-90.65 N/m")

    def test_missing_unit(self):
        self.refuses_case(TRUTH.replace("1278 um", "1278"), ":8:", "[rig] span", "1278 um")

    def test_bare_number(self):
        self.refuses_case(TRUTH.replace('"1278 um"', "1278"), ":8:", "[rig] span", "1278 um")

    def test_wrong_unit(self):
        self.refuses_case(TRUTH.replace("1278 um", "1278 mN"), ":8:", "[rig] span", "a length")

    def test_unknown_key(self):
        self.refuses_case(TRUTH.replace("span ", "spam "), ":8:", "Did you mean 'span'?")

    def test_unknown_model(self):
        self.refuses_case(TRUTH.replace('"sinusoid"', '"sinusoit"'), "[friction] model", 'Did you mean "sinusoid"?')

    def test_specimen_as_thick_as_the_span(self):
        self.refuses_case(TRUTH.replace("34.8 um", "1278 um"), ":4:", "[specimen] diameter", "Check the units")

    def test_specimen_too_thick_for_a_beam(self):
        self.refuses_case(TRUTH.replace("34.8 um", "300 um"), ":4:", "[specimen] diameter", "fifth of the span", "beam theory")

    def test_stiffness_left_to_the_fit(self):
        self.refuses_case(TRUTH.replace("30.192 GPa", "fit"), "[specimen] modulus", "modulus = ")

    def test_programme_that_goes_nowhere(self):
        self.refuses_case(TRUTH.replace('"850 um"', '"0 um"'), ":19:", "program[2]", "less than 1e-06 spans")

    def test_programme_in_the_wrong_unit(self):
        self.refuses_case(TRUTH.replace('"850 um"', '"850 mm"').replace('"2 um"', '"2 mm"'), ":19:", "Check its unit")

    def test_wavelength_in_the_wrong_unit(self):
        self.refuses_case(TRUTH.replace("10.9 um", "10.9 pm"), ":15:", "[friction] wavelength", "Check its unit")

    def test_friction_that_becomes_negative(self):
        self.refuses_case(TRUTH.replace("amplitude  = 0.15", "amplitude  = 1.5"), ":14:", "amplitude", "negative")

    def test_friction_beyond_what_is_computed(self):
        steep = TRUTH.replace("mu0        = 0.5", 'mu0 = 1.6\ndrift = "40 1/mm"')
        limit = ("[friction] drift", "The drift of 40 1/mm takes friction from 1.84", "the limit at the surface is 2", "Check its unit")
        for command in ("simulate", "equilibrium", "design"):
            self.refuses_case(steep, ":14:", *limit, command=command)
        sweep = steep + '[sweep]\nmethod = "grid"\naxes = { mu0 = [0.1, 0.2] }\n'
        self.refused("sweep", self.file("case.toml", sweep), says=["case.toml:14", *limit])
        self.refuses_case(TRUTH.replace("mu0        = 0.5", "mu0 = 19"), ":13:", "[friction] mu0", "its waves and drift included, and the limit at the surface is 2")
        table = TRUTH.split("[friction]")[0] + '[friction]\nmodel = "table"\nfile = "t.csv"\nlength = "S [um]"\n'
        self.file("t.csv", "S [um],mu\n1278,0.5\n1300,25\n")
        for command in ("simulate", "design"):
            self.refuses_case(table + "[stage]" + TRUTH.split("[stage]")[1], "[friction] file", "the limit at the surface is 2", "25",
                              command=command)

    def test_equilibria_marked_farther_than_the_programme_goes(self):
        drifting = TRUTH.replace("mu0        = 0.5", 'mu0 = 0.5\ndrift = "3 1/mm"')
        case = self.file("case.toml", drifting)
        self.refused("simulate", case, "--figure", self.folder / "a.svg", "--equilibria-at", "5 mm", says=["[friction] drift"])

    def test_reference_that_is_no_length_of_the_specimen(self):
        drifting = TRUTH.replace("mu0        = 0.5", 'mu0 = 0.5\ndrift = "0.8 1/mm"\nreference = "1.4 mm"')
        self.refuses_case(drifting.replace("1.4 mm", "1.4 m"), ":15:", "[friction] reference", "Check its unit")
        self.refuses_case(drifting.replace("1.4 mm", "1.4"), ":15:", "[friction] reference", "has no unit")
        self.refuses_case(drifting.replace('drift = "0.8 1/mm"\n', ""), ":14:", "[friction] reference", "needs a drift")

    def test_section_that_is_not_there(self):
        self.refuses_case(CASE, "[stage]", "Add program")
        self.refuses_case(TRUTH, "[record]", "Add file", command="invert")


class BadFrictionTable(InFolder):
    def refuses_table(self, content, *says):
        self.file("trace.csv", content)
        case = self.file("case.toml", 'reduced = true\n[rig]\nstiffness = 30\n[friction]\nmodel = "table"\nfile = "trace.csv"\n'
                         'length = "S"\n[stage]\nprogram = [0, 0.5]\nstep = 0.01\n')
        self.refused("simulate", case, says=["trace.csv", *says])

    def test_lengths_that_fall(self):
        self.refuses_table("S,mu\n1,0.5\n1.2,0.6\n1.1,0.5\n", ":4:", "'S'", "greater")

    def test_negative_friction(self):
        self.refuses_table("S,mu\n1,0.5\n1.2,-0.6\n", ":3:", "'mu'", "Friction is -0.6, less than 0")

    def test_lengths_below_the_span(self):
        self.refuses_table("S,mu\n0,0.5\n0.4,0.6\n", ":3:", "'S'", "the span")


class BadStates(InFolder):
    def test_state_outside_the_domain(self):
        self.refused("state", "-", stdin="S,q\n1.2,0.3\n0.9,0.3\n", says=["standard input:3", "'S'", "at least 1"])
        self.refused("state", "-", stdin="S,q\n1.2,25\n", says=["standard input:2", "'q'", "-20 to 20"])
        self.refused("state", "--S", "0.5", "--q", "0", says=["--S", "at least 1"])

    def test_negative_force(self):
        self.refused("invert", "-", stdin="w,F\n0.2,-1\n", says=["standard input:2", "'F'", "at least 0"])

    def test_states_that_do_not_exist_are_nan_and_exit_code_1(self):
        result = run("state", "-", stdin="S,q\n1.2,0.3\n3,0\n")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout.splitlines()[2], "3,0,nan,nan,nan,nan,nan,nan")
        self.assertIn("standard input:3: no state", result.stderr)
        result = run("invert", "-", stdin="w,F\n0.2,5\n0.2,1000\n")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout.splitlines()[2], "0.2,1000,nan,nan")
        self.assertIn("standard input:3: no friction", result.stderr)


class WrongCall(InFolder):
    def test_no_command(self):
        self.refused(says=["the commands are", "'simulate'"])

    def test_unknown_command(self):
        self.refused("simulat", "case.toml", says=["unknown command 'simulat'", "did you mean 'simulate'?"])

    def test_unknown_option(self):
        self.refused("simulate", "case.toml", "--nois", "1", says=["'--nois'", "did you mean '--noise'?"])

    def test_argument_that_is_missing(self):
        for command in ("simulate", "equilibrium", "invert", "completions"):
            self.refused(command, says=["required", f"flexslip {command} --help"])
        self.refused("state", says=["Either a file or --S and --q are needed"])
        self.refused("state", "--S", "1.1", says=["both --S and --q"])

    def test_argument_that_is_too_much(self):
        self.refused("equilibrium", "case.toml", "more", says=["was given 'more'"])

    def test_option_without_its_unit(self):
        truth = SOURCE / "examples/simulated/truth.toml"
        self.refused("simulate", truth, "--noise", "10", says=["--noise", "has no unit, but a force needs one"])
        self.refused("equilibrium", truth, "--longest", "1500", says=["--longest", "has no unit, but a length needs one"])
        self.refused("equilibrium", truth, "--longest", "100 um", says=["--longest", "greater than the span"])

    def test_a_modulus_of_another_world(self):
        for modulus, told in (("1e50 Pa", "initial slope"), ("1e60 Pa", "initial slope"), ("1e-40 Pa", "softer than any specimen"), ("70 Pa", 'such as "29.6 GPa"')):
            self.refused("fit", SOURCE / "examples" / "simulated" / "case.toml", "--set", f"specimen.modulus={modulus}", says=["specimen.modulus", told])
        for key, value in (("specimen.modulus", "1e200 Pa"), ("rig.span", "1e200 m"), ("record.zero", "1e300 N")):
            self.refused("fit", SOURCE / "examples" / "simulated" / "case.toml", "--set", f"{key}={value}", says=[key, "a possible", "look at its exponent"])

    def test_output_that_cannot_be_written(self):
        self.refused("state", "--S", "1.2", "--q", "0.3", "-o", self.folder / "none" / "x.csv", says=["x.csv", "There is no folder"])
        self.refused("state", "--S", "1.2", "--q", "0.3", "--json", "-o", self.folder, says=["Is a directory"])
        self.refused("state", "--S", "1.2", "--q", "0.3", "-o", self.folder / (300 * "x"), says=["File name too long"])


if __name__ == "__main__":
    unittest.main()
