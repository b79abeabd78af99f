#!/usr/bin/python3
"""outside: stage programmes of every kind, static friction, energies of legs, and the programmes that are refused."""
import csv
import json
import math
import shutil
import subprocess
import unittest

from program import SOURCE, InFolder, numbers, run, table, words_of

CASES = SOURCE / "../shared/cases"
PROTOTYPES = SOURCE / "../shared/prototypes"

RIG = "reduced = true\n[rig]\nstiffness = 30\n"
WAVY = RIG + '[friction]\nmodel = "sinusoid"\nmu0 = 0.5\namplitude = 0.3\nwavelength = 0.02\n'
CONSTANT = RIG + '[friction]\nmodel = "constant"\nmu0 = 0.4\n'
STATIC = CONSTANT + "static_excess = 0.1\n"
LOOP = "[stage]\nprogram = [0, 0.5, 0.1, 0.6, 0.6, 0]\n"
RUN = '[stage]\nfile = "run.csv"\nstage = "w_s"\n'
TIMED = RUN + 'time = "t"\n'
ENERGIES = ("stage_work", "bending", "load_train", "friction", "snaps", "cracks")
CRACKS = "[specimen]\ncracks = [{ deflection = 0.1, loss = \"5 %\" }, { deflection = 0.2, loss = 0.2 }]\n"


class Programmes(InFolder):
    def simulated(self, case, *options):
        return self.json("simulate", self.file("case.toml", case), *options)

    def test_identity_continuous_and_in_steps_agree(self):
        exact = self.simulated(WAVY + LOOP)
        stepped = self.simulated(WAVY + LOOP + "step = 0.01\n")
        # Two ways to the same states: rounding of the stage position times the condition of S there, below 1e4.
        self.assertEqual(len(exact["snaps"]), len(stepped["snaps"]))
        self.assertGreater(len(exact["snaps"]), 3)
        for a, b in zip(exact["snaps"], stepped["snaps"]):
            self.assertEqual(a.keys(), b.keys())
            for name, value in a.items():
                self.assertAlmostEqual(value, b[name], delta=1e-9)
        for name in ENERGIES:
            self.assertAlmostEqual(exact["energy"][name], stepped["energy"][name], delta=1e-9)

    def test_identity_a_closed_cycle_returns(self):
        path = self.simulated(CONSTANT + "[stage]\nprogram = [0, 0.5, 0.1]\ncycles = 3\nstep = 0.05\n")["path"]
        turns = [point for point in path if point["stage"] == 0.1]
        self.assertEqual(len(turns), 4)  # on the first loading, and where each of three cycles ends
        ends = [point for point, before in zip(path[1:], path) if point["stage"] == 0.1 < before["stage"]]
        self.assertEqual(len(ends), 3)
        for end in ends[1:]:
            self.assertAlmostEqual(end["force"], ends[0]["force"], delta=1e-12)  # the bound

    def test_motions_of_a_loop(self):
        motions = [point["motion"] for point in self.simulated(CONSTANT + "[stage]\nprogram = [0, 0.5, 0]\n")["path"]]
        kinds = [a for a, b in zip(motions, [None, *motions]) if a != b]
        self.assertEqual(kinds, ["stick", "slip_in", "stick", "slip_out"])

    def test_a_halt_is_a_row_in_which_nothing_moves(self):
        path = self.simulated(CONSTANT + "[stage]\nprogram = [0, 0.2, 0.2, 0.3]\nstep = 0.1\n")["path"]
        self.assertEqual([point["stage"] for point in path], [0, 0.1, 0.2, 0.2, 0.3])
        self.assertEqual(path[3]["motion"], "stick")
        self.assertEqual({**path[3], "motion": ""}, {**path[2], "motion": ""})

    def test_identity_a_physical_programme_is_the_reduced_one_scaled(self):
        # A span and a bending stiffness that make the units 1 mm and 1 mN.
        reduced = self.simulated(WAVY + LOOP)
        physical = self.simulated(
            '[specimen]\nbending_stiffness = "1 mN mm^2"\n[rig]\nspan = "1 mm"\nstiffness = "30 mN/mm"\n'
            + WAVY.split("stiffness = 30\n")[1].replace("0.02", '"0.02 mm"')
            + '[stage]\nprogram = ["0 um", "500 um", "100 um", "600 um", "600 um", "0 um"]\n')
        self.assertEqual(len(physical["path"]), len(reduced["path"]))
        for a, b in zip(physical["path"], reduced["path"]):
            self.assertAlmostEqual(a["force"] / 1e-3, b["force"], delta=1e-9)  # rounding, times the condition of a fold

    def test_a_measured_programme_is_followed_row_by_row(self):
        stages = [0, 0.1, 0.2, 0.35, 0.35, 0.2, 0.05, 0.3]
        self.file("run.csv", "t,w_s\n" + "".join(f"{row / 2},{stage}\n" for row, stage in enumerate(stages)))
        measured = self.simulated(WAVY + TIMED)
        self.assertEqual([point["stage"] for point in measured["path"]], stages)
        self.assertEqual([leg["to"] for leg in measured["legs"]], [0.35, 0.05, 0.3])
        program = self.simulated(WAVY + f"[stage]\nprogram = {stages}\nstep = 10\n")
        self.assertEqual(measured["path"], program["path"])
        self.assertEqual(measured["energy"], program["energy"])

    def test_a_measured_programme_in_its_own_units(self):
        self.file("run.csv", "t;stage [um]\n0;0,5\n0;100,5\n1;40\n")
        physical = ('[specimen]\nbending_stiffness = "2.1e-12 N m^2"\n[rig]\nspan = "1278 um"\nstiffness = "inf"\n'
                    '[friction]\nmodel = "constant"\nmu0 = 0.4\n[stage]\nfile = "run.csv"\nstage = "stage"\n'
                    'time = "t [s]"\ndecimal = ","\n')
        path = self.simulated(physical)["path"]
        for point, stage in zip(path, (0.5e-6, 100.5e-6, 40e-6), strict=True):
            self.assertAlmostEqual(point["stage"], stage, delta=1e-20)
            self.assertAlmostEqual(point["deflection"], stage, delta=1e-16)  # displacement control; rounding of S = 1 + 2.4 w^2


class StaticFriction(InFolder):
    def simulated(self, case):
        return self.json("simulate", self.file("case.toml", case))

    def test_it_makes_a_sawtooth_without_roughness(self):
        stage = "[stage]\nprogram = [0, 0.5]\nstep = 0.5\n"
        self.assertEqual(self.simulated(CONSTANT + stage)["snaps"], [])
        snaps = self.simulated(STATIC + stage)["snaps"]
        self.assertGreater(len(snaps), 20)
        for snap in snaps:
            self.assertLess(snap["force_after"], snap["force_before"])
            self.assertGreater(snap["friction"], 0)
            self.assertGreater(snap["released"], 0)

    def check_overshoot(self, case):
        stage = "[stage]\nprogram = [0, 0.6, 0.2]\nstep = 0.1\n"
        nearest = self.simulated(case + stage)["energy"]
        over = self.simulated(case + stage + 'snaps = "overshoot"\n')["energy"]
        self.assertEqual(self.simulated(case + stage + 'snaps = "nearest"\n')["energy"], nearest)
        self.assertGreater(nearest["snaps"], 0)
        # What snaps set free friction consumes; short slips of a static friction run on into others, and keep theirs.
        self.assertLess(over["snaps"], 1e-3 * nearest["snaps"])
        for energy in (nearest, over):
            self.assertLess(abs(energy["stage_work"] - sum(energy[name] for name in ENERGIES[1:])), 1e-10 * energy["stage_work"])  # history.h

    def test_an_overshoot_loses_all_it_sets_free_to_friction(self):
        self.check_overshoot(WAVY)

    def test_an_overshoot_of_static_on_constant_friction(self):
        self.check_overshoot(STATIC)

    def test_more_than_the_mechanics_covers_is_refused(self):
        case = self.file("case.toml", STATIC.replace("0.1", "25") + LOOP)
        self.refused("simulate", case, says=["case.toml:7", "[friction] static_excess", "the limit is 20"])


class Wear(InFolder):
    WORN = CONSTANT.replace("mu0 = 0.4", "mu0 = 0.5\nwear = 0.6")
    STAGE = "[stage]\nprogram = [0, 0.45, 0.1, 0.45]\n"

    def simulated(self, case, *options):
        return self.json("simulate", self.file("case.toml", case), *options)

    def test_each_pass_slides_at_its_own_friction_and_the_energies_close(self):
        for step in "", "step = 0.01\n":
            answer = self.simulated(self.WORN + self.STAGE + step)
            levels = {(point["motion"], round(point["q"], 12)) for point in answer["path"] if point["motion"].startswith("slip")}
            self.assertEqual(levels, {("slip_in", 0.5), ("slip_out", -0.3), ("slip_in", 0.18)})
            self.assertEqual([snap["stage"] for snap in answer["snaps"]], [0.45, 0.1])
            energy = answer["energy"]
            self.assertAlmostEqual(energy["stage_work"], sum(energy[name] for name in ENERGIES[1:]), delta=1e-10)

    def test_identity_a_wear_of_1_is_none(self):
        self.assertEqual(self.simulated(WAVY + LOOP), self.simulated(WAVY + "wear = 1\n" + LOOP))

    def test_limit_a_test_that_only_loads_does_not_wear(self):
        once = "[stage]\nprogram = [0, 0.5]\nstep = 0.01\n"
        self.assertEqual(self.simulated(WAVY + once), self.simulated(WAVY + "wear = 0.5\n" + once))

    def test_with_cracks_the_energies_close(self):
        answer = self.simulated(WAVY + "wear = 0.7\n" + CRACKS + LOOP)
        self.assertEqual(len(answer["cracks"]), 2)
        energy = answer["energy"]
        self.assertAlmostEqual(energy["stage_work"], sum(energy[name] for name in ENERGIES[1:]), delta=1e-10)

    def test_refused(self):
        for wear in "0", "-0.5", "1.5", '"60 %"':
            case = self.file("case.toml", CONSTANT + f"wear = {wear}\n" + self.STAGE)
            self.refused("simulate", case, says=["case.toml:7", "[friction] wear"])
        self.file("run.csv", "w_s\n0\n0.3\n0.1\n")
        self.refused("simulate", self.file("case.toml", self.WORN + RUN), says=["[friction] wear", "a program of the stage"])
        self.refused("simulate", self.file("case.toml", WAVY + OTHER + "wear = 0.5\n" + self.STAGE), says=["[friction.other]", "wear"])
        for command in "design", "sweep":
            case = self.file("case.toml", self.WORN + "[stage]\nprogram = [0, 0.5]\n[sweep]\nmethod = 'grid'\n[sweep.axes]\nstiffness = [10, 30]\n")
            self.refused(command, case, says=["[friction] wear", "flexslip simulate"])


class Energies(InFolder):
    def test_identity_legs_add_up(self):
        answer = self.json("simulate", self.file("case.toml", WAVY + LOOP))
        legs = answer["legs"]
        self.assertEqual([(leg["direction"], leg["from"], leg["to"]) for leg in legs],
                         [("loading", 0, 0.5), ("unloading", 0.5, 0.1), ("loading", 0.1, 0.6), ("unloading", 0.6, 0)])
        for name in (*ENERGIES, "work_of_fracture"):
            self.assertAlmostEqual(sum(leg[name] for leg in legs), answer["energy"][name], delta=1e-12)  # rounding of sums of 1
        for leg in legs:
            parts = sum(leg[name] for name in ENERGIES[1:])
            self.assertAlmostEqual(leg["stage_work"], parts, delta=1e-10)  # history.h

    def test_identity_legs_add_up_where_a_specimen_slips_through(self):
        through = self.file("through.toml", 'reduced = true\n[rig]\nstiffness = 60\n[friction]\nmodel = "sinusoid"\nmu0 = 0.05\namplitude = 0.9\nwavelength = 0.02\n'
                                            '[stage]\nprogram = [0, 0.5, 0.2, 2]')
        result = run("simulate", through, "--json", "--quiet")
        self.assertEqual(result.returncode, 1)
        answer = json.loads(result.stdout)
        legs = answer["legs"]
        self.assertEqual([leg["direction"] for leg in legs], ["loading", "unloading", "loading"])
        for name in (*ENERGIES, "work_of_fracture"):
            self.assertAlmostEqual(sum(leg[name] for leg in legs), answer["energy"][name], delta=1e-12)  # rounding of sums of 1

    def test_the_account_of_a_test(self):
        answer = self.json("simulate", self.file("case.toml", WAVY + LOOP.replace(", 0]", ", 0.3]")))
        energy = answer["energy"]
        self.assertEqual(list(energy), [*ENERGIES, "work_of_fracture", "friction_share"])
        self.assertAlmostEqual(energy["work_of_fracture"], energy["stage_work"] - energy["load_train"], delta=1e-15)
        self.assertAlmostEqual(energy["friction_share"],
                               (energy["friction"] + energy["snaps"]) / energy["work_of_fracture"], delta=1e-15)
        self.assertAlmostEqual(energy["work_of_fracture"] * (1 - energy["friction_share"]), energy["bending"], delta=1e-10)  # the account closes
        self.assertAlmostEqual(sum(snap["released"] for snap in answer["snaps"]), energy["snaps"], delta=1e-12)

    def test_columns_on_request(self):
        case = self.file("case.toml", WAVY + LOOP + "step = 0.01\n")
        plain = self.succeeds("simulate", case)
        self.assertEqual(list(table(plain)), ["w_s", "w", "F", "S", "q", "motion"])
        more = self.succeeds("simulate", case, "--energies")
        self.assertEqual(list(table(more)), ["w_s", "w", "F", "S", "q", "motion", *ENERGIES])
        self.assertEqual(table(plain)["F"], table(more)["F"])
        answer = self.json("simulate", case, "--energies")
        for name in ENERGIES:
            self.assertEqual(numbers(more, name)[-1], answer["energy"][name])
            self.assertEqual(answer["path"][-1][name], answer["energy"][name])


class Cracks(InFolder):
    def test_a_crack_runs_down_the_load_line_and_its_energy_is_in_the_account(self):
        answer = self.json("simulate", self.file("case.toml", CONSTANT + CRACKS + "[stage]\nprogram = [0, 0.5]\n"))
        self.assertEqual([round(crack["left"], 12) for crack in answer["cracks"]], [0.95, 0.76])
        for crack, deflection in zip(answer["cracks"], (0.1, 0.2)):
            self.assertAlmostEqual(crack["deflection_before"], deflection, delta=1e-14)
            fall = crack["force_before"] - crack["force_after"]
            self.assertAlmostEqual(fall, 30 * (crack["deflection_after"] - crack["deflection_before"]), delta=1e-12)
        energy = answer["energy"]
        self.assertAlmostEqual(sum(crack["released"] for crack in answer["cracks"]), energy["cracks"], delta=1e-14)
        self.assertGreater(energy["cracks"], 0.01 * energy["stage_work"])
        self.assertAlmostEqual(energy["work_of_fracture"] * (1 - energy["friction_share"]), energy["bending"] + energy["cracks"], delta=1e-10)
        self.assertEqual([point["motion"] for point in answer["path"]].count("crack"), 2)

    def test_a_crack_that_is_no_crack_is_refused(self):
        for crack, says in {'{ deflection = 0.1, loss = "100 %" }': "less than 100 %", "{ deflection = 0.1, loss = 0 }": "positive",
                            '{ deflection = 0, loss = 0.1 }': "positive", '{ deflection = 0.1, loss = 0.1, at = 3 }': "at",
                            '3': '[{ deflection = 0.12, loss = "3 %" }]', "": "an array of cracks",
                            '{ deflection = "0.1 mm", loss = 0.1 }': "without quotes and unit"}.items():
            case = self.file("case.toml", CONSTANT + f"[specimen]\ncracks = [{crack}]\n" + LOOP)
            self.refused("simulate", case, says=["case.toml:8", "[specimen] cracks", says])

    def test_a_design_has_no_cracks(self):
        case = self.file("case.toml", WAVY + CRACKS + "[stage]\nprogram = [0, 0.5]\n")
        self.refused("design", case, says=["[specimen] cracks", "2 of them", "flexslip simulate"])


class Ends(InFolder):
    def test_identity_contact_is_regained_where_it_was_lost(self):
        # Displacement control far out: let go, the smooth fibre is shorter than the way back of the stage.
        for step in "step = 0.01\n", "":
            case = self.file("case.toml", CONSTANT + "[stage]\nprogram = [0, 1.15, 0.2, 1.15, 1.2]\n" + step)
            result = run("simulate", case, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("the nose lifts off at the stage position", result.stderr)
            answer = json.loads(result.stdout)
            path = answer["path"]
            apart = [i for i, point in enumerate(path) if point["motion"] == "apart"]
            self.assertGreater(len(apart), 20)
            for i in apart:
                self.assertEqual(path[i]["force"], 0)
                self.assertEqual(path[i]["deflection"], path[apart[0]]["deflection"])
                self.assertLessEqual(path[i]["stage"], path[i]["deflection"])
            turned, back = [point for point in path if point["stage"] == 1.15][::len([p for p in path if p["stage"] == 1.15]) - 1]
            for name in "force", "length", "q":
                self.assertAlmostEqual(turned[name], back[name], delta=1e-11)
            energy = answer["energy"]
            parts = sum(energy[name] for name in ("bending", "load_train", "friction", "snaps", "cracks"))
            self.assertAlmostEqual(energy["stage_work"], parts, delta=1e-10)


@unittest.skipIf(shutil.which("gnuplot") is None, "no gnuplot")
class Figures(InFolder):
    def drawn(self, case):
        self.succeeds("simulate", self.file("case.toml", case), "--figure", self.folder / "loop.svg")
        return (self.folder / "loop.svg").read_text(encoding="utf-8")

    def test_a_test_that_is_unloaded_is_drawn_as_loops_with_arrows(self):
        for stage in (LOOP, LOOP + "step = 0.02\n", "[stage]\nprogram = [0, 0.5, 0.1]\ncycles = 10\n"):
            for case in (WAVY, STATIC):
                picture = self.drawn(case + stage)
                for word in ("Loading", "Unloading", "Sticking", "(A) Force against deflection"):
                    self.assertIn(word, picture)
                for arrows in ("arrows_in_force", "arrows_out_force", "arrows_in_friction", "arrows_out_friction"):
                    text = (self.folder / f"loop-{arrows}.csv").read_text(encoding="utf-8")
                    self.assertNotIn("nan", text)
                    self.assertLessEqual(text.count("\n"), 12)  # few enough to see the curve

    def test_a_test_that_only_loads_is_drawn_as_in_the_paper(self):
        picture = self.drawn(WAVY + "[stage]\nprogram = [0, 0.6]\n")
        self.assertIn("Equilibrium curve", picture)
        self.assertNotIn("Unloading", picture)


class BadProgrammes(InFolder):
    def refuses(self, stage, *says):
        self.refused("simulate", self.file("case.toml", CONSTANT + stage), says=says)

    def refuses_run(self, content, *says, stage=TIMED):
        self.file("run.csv", content)
        self.refuses(stage, "run.csv", *says)

    def test_empty(self):
        self.refuses("[stage]\n", "case.toml:7", "Add program")
        self.refuses("[stage]\nprogram = []\n", "case.toml:8", "at least two stage positions", "has 0")
        self.refuses_run("", "The file is empty")
        self.refuses_run("t,w_s\n", "row")

    def test_nothing_above_zero(self):
        self.refuses("[stage]\nprogram = [0, 0, 0]\n", "case.toml:8", "program[3]", "less than 1e-06 spans")
        self.refuses_run("t,w_s\n0,0\n1,0\n", "run.csv:2", "'w_s'", "less than 1e-06 spans")

    def test_negative(self):
        self.refuses("[stage]\nprogram = [0, 0.5, -0.1]\n", "case.toml:8", "program[3]", "non-negative")
        self.refuses_run("t,w_s\n0,0\n1,0.5\n2,-0.1\n", "run.csv:4", "'w_s'", "before the point of contact", "-0.1")

    def test_beyond_every_specimen(self):
        self.refuses("[stage]\nprogram = [0, 500, 0]\n", "case.toml:8", "program[2]", "beyond 100 spans", "Check its unit")
        self.refuses_run("t,w_s\n0,0\n1,500\n", "run.csv:3", "'w_s'", "beyond 100 spans", "Check its unit")

    def test_not_finite(self):
        self.refuses("[stage]\nprogram = [0, inf]\n", "case.toml:8", "program[2]", "finite")
        self.refuses("[stage]\nprogram = [0, nan]\n", "case.toml:8", "program[2]")
        self.refuses_run("t,w_s\n0,0\n1,nan\n", "run.csv:3", "w_s", "finite number")
        self.refuses_run("t,w_s\n0,0\ninf,1\n", "run.csv:3", "'t'", "finite number")

    def test_time_running_back(self):
        self.refuses_run("t,w_s\n0,0\n2,0.1\n1,0.2\n", "run.csv:4", "'t'", "is earlier than 2 in the previous row", "Sort the rows")

    def test_columns_and_files_that_are_not_there(self):
        self.refuses_run("t,ws\n0,0\n1,0.1\n", "w_s", "Did you mean 'ws'?")
        self.refuses_run("w_s\n0\n0.1\n", "'t'")
        self.refuses('[stage]\nfile = "none.csv"\nstage = "w_s"\n', "none.csv", "No such file")

    def test_contradictions(self):
        self.refuses(RUN + "step = 0.1\n", "case.toml:10", "[stage] step", "the rows of the file are the steps")
        self.refuses(RUN + "program = [0, 1]\n", "case.toml:10", "[stage] program", "either a program or a file")
        self.refuses('[stage]\nprogram = [0, 1]\nsnaps = "away"\n', "case.toml:9", "nearest", "overshoot", "'away'")

    def test_a_rig_too_soft_to_bend_the_specimen(self):
        case = self.file("case.toml", CONSTANT.replace("= 30", "= 1e-9") + LOOP)
        self.refused("simulate", case, says=["case.toml:3", "[rig] stiffness", "does not bend the specimen"])


OTHER = '[friction.other]\nmodel = "sinusoid"\nmu0 = 0.52\namplitude = 0.25\nwavelength = 0.0154\nphase = 2.5\n'


def crests(stage, force):
    """Stage positions at which the force begins to fall by more than 0.3 % of its maximum."""
    found, top, rising = [], 0, True
    for i, each in enumerate(force):
        if rising and each < force[top] - 0.003 * max(force):
            found.append(stage[top])
            rising, low = False, i
        elif rising and each >= force[top]:
            top = i
        elif not rising and each < force[low]:
            low = i
        elif not rising and each > force[low] + 0.003 * max(force):
            rising, top = True, i
    return found


class Nose(InFolder):
    RECORD = WAVY.replace("[rig]\n", "[rig]\nnose_radius = 0.5\n") + "[stage]\nprogram = [0, 0.5]\nstep = 0.01\n"

    def test_limit_it_is_wrapped_from_where_the_curvature_exceeds_its_own(self):
        path = self.file("case.toml", self.RECORD)
        result = run("simulate", path, "--json")
        self.assertIn("wraps around it", result.stderr)
        answer = json.loads(result.stdout)
        states = "S,q\n" + "".join(f"{point['length']!r},{point['q']!r}\n" for point in answer["path"])
        curvatures = numbers(self.succeeds("state", self.file("states.csv", states)), "curvature")
        first = next(point["stage"] for point, curvature in zip(answer["path"], curvatures) if curvature > 2)
        self.assertEqual(answer["wraps_nose_from"], first)
        self.assertIsNone(self.json("simulate", self.file("sharp.toml", self.RECORD.replace("nose_radius = 0.5", "nose_radius = 0.01")))["wraps_nose_from"])

    def test_a_design_and_a_fit_say_so(self):
        section = '[specimen]\ndiameter = "34.8 um"\nmodulus = "30 GPa"\n'
        rig = '[rig]\nspan = "1278 um"\nstiffness = "90 N/m"\nnose_radius = "RADIUS"\n'
        friction = '[friction]\nmodel = "sinusoid"\nmu0 = 0.5\namplitude = 0.2\nwavelength = "11 um"\n'
        stage = '[stage]\nprogram = ["0 um", "700 um"]\nstep = "2 um"\n'
        for radius, wraps in ("400 um", True), ("20 um", False):
            case = section + rig.replace("RADIUS", radius) + friction + stage
            self.assertEqual(self.json("design", self.file("design.toml", case))["wraps_nose"], wraps)
            self.assertEqual("wraps around it" in self.succeeds("design", self.file("design.toml", case)), wraps)
        run("simulate", self.file("truth.toml", case), "--output", self.folder / "test.csv", "--noise", "10 uN")
        for radius, wraps in ("400 um", True), ("20 um", False):
            case = section + rig.replace("RADIUS", radius) + '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\n'
            answer = self.json("fit", self.file("fit.toml", case), "--quiet")
            self.assertEqual(any("wrapped the nose" in row["words"] for row in answer["answer"]), wraps)

    @unittest.skipUnless((CASES / "nose").is_dir(), "no cases")
    def test_a_dynamic_rod_whose_nose_holds_drops_where_the_mean_of_its_sides_does(self):
        case = (CASES / "nose/d_two.toml").read_text(encoding="utf-8")
        record = [line.split(",") for line in (CASES / "nose/g1_held.csv").read_text(encoding="utf-8").splitlines()[1:]]
        measured = crests([float(stage) / 1278 for stage, _ in record], [float(force) for _, force in record])
        path = self.json("simulate", self.file("case.toml", case))["path"]
        simulated = crests([point["stage"] for point in path], [point["force"] for point in path])
        self.assertEqual(len(simulated), 6)
        for here, there in zip(simulated, measured, strict=True):
            self.assertAlmostEqual(here, there, delta=0.003)  # 0.002, a row of both
        free = self.json("simulate", self.file("case.toml", with_free_nose(case)))["path"]
        self.assertEqual(len(crests([point["stage"] for point in free], [point["force"] for point in free])), 14)

    @unittest.skipUnless((CASES / "nose").is_dir(), "no cases")
    def test_under_a_free_nose_lengths_along_the_specimen_are_twice_as_long(self):
        """The wave of both rods repeats every 25.56 µm."""
        answers = {}
        for name, nose in ("g1_held", "holds"), ("j2_mun0", "free"), ("j2_mun0", "holds"):
            answers[name, nose] = self.json("fit", CASES / f"nose/{name}.toml", "--set", f'rig.nose="{nose}"', "--quiet")
        held, free, wrong = answers.values()
        for answer in held, free:
            self.assertTrue(answer["wave"]["claimed"])
            self.assertAlmostEqual(answer["wave"]["wavelength"]["value"], 25.56e-6, delta=0.8e-6)
        for path in ("parameters", "wavelength", "value"), ("parameters", "correlation_length", "value"), ("slips", "median_spacing"):
            here, there = free, wrong
            for name in path:
                here, there = here[name], there[name]
            self.assertAlmostEqual(here, 2 * there, delta=1e-6 * here)
        self.assertAlmostEqual(free["parameters"]["mu0"]["value"], wrong["parameters"]["mu0"]["value"], delta=1e-6)

    def test_refused(self):
        self.refused("simulate", self.file("case.toml", self.RECORD.replace("nose_radius = 0.5", 'nose = "loose"')), says=["[rig] nose", '"holds" or "free"'])
        for radius in "0", "-1", '"sharp"':
            self.refused("simulate", self.file("case.toml", self.RECORD.replace("nose_radius = 0.5", f"nose_radius = {radius}")), says=["[rig] nose_radius"])


class SnapsThatOvershoot(InFolder):
    FIG_8C = RIG + '[friction]\nmodel = "sinusoid"\nmu0 = 0.6\namplitude = 0.4\nwavelength = 0.0628318530717959\n[stage]\nprogram = [0, 0.632]\nstep = 0.008\n'

    @unittest.skipUnless((PROTOTYPES / "rod/der.cpp").is_file(), "no ../shared/prototypes/rod")
    @unittest.skipUnless(shutil.which("c++"), "no C++ compiler for ../shared/prototypes/rod")
    def test_a_dynamic_rod_rests_where_a_simulated_snap_does(self):
        rod = self.folder / "rod"
        subprocess.run(["c++", "-O2", "-w", "-o", rod, PROTOTYPES / "rod/der.cpp"], check=True)
        simulated = {}
        for rest in "nearest", "overshoot":
            path = self.json("simulate", self.file("case.toml", self.FIG_8C), "--set", f'rig.snaps="{rest}"')["path"]
            simulated[rest] = {round(point["stage"], 3): point["length"] for point in path}
        for damping, rest in (0.05, "overshoot"), (0.3, "overshoot"), (1.5, "nearest"):
            out = subprocess.run([rod, "M=1", f"zn={damping}", "prog=0,.634", "mun=.5", "k=30", "vel=.006", "be=1.2e-4", "dt=5e-5", "al=.2", "N=80", "out=.008"],
                                 check=True, capture_output=True, text=True).stdout
            measured = {round(float(row["ws"]), 3): float(row["S"]) for row in csv.DictReader(out.splitlines())}
            with self.subTest(damping=damping):
                for stage in 0.616, 0.624, 0.632:
                    self.assertAlmostEqual(measured[stage], simulated[rest][stage], delta=0.007)  # of a snap of 0.06 or 0.08; the rod's nose moves on
                slid, expected = (of[0.632] - of[0.616] for of in (measured, simulated[rest]))
                self.assertAlmostEqual(slid, expected, delta=0.0008)  # 0 or 0.006

    @unittest.skipUnless((CASES / "snaps_that_overshoot").is_dir(), "no cases")
    def test_a_record_of_them_tells_its_friction(self):
        folder = CASES / "snaps_that_overshoot"
        for name in "overshoot.toml", "overshoot_fit.toml":
            shutil.copy(folder / name, self.folder / name)
        self.succeeds("simulate", self.folder / "overshoot.toml", "-o", self.folder / "overshoot.csv", "--noise", "10 uN")
        fit = self.json("fit", self.folder / "overshoot_fit.toml", "--quiet")
        low, high = fit["parameters"]["mu0"]["interval95"]
        self.assertTrue(fit["snaps_overshoot"])
        self.assertTrue(low < 0.6 < high, fit["parameters"]["mu0"])
        self.assertLess(abs(fit["parameters"]["mu0"]["value"] - 0.6), 0.06)
        self.assertIn("snaps overshoot, as the record shows", words_of(fit, "model"))
        nearest = self.json("fit", self.folder / "overshoot_fit.toml", "--quiet", "--set", 'rig.snaps="nearest"')
        self.assertFalse(nearest["snaps_overshoot"])
        self.assertLess(nearest["parameters"]["mu0"]["value"], low)

    @unittest.skipUnless((CASES / "snaps_that_overshoot").is_dir(), "no cases")
    def test_records_of_a_dynamic_rod(self):
        """Hardly damped and overdamped. The contacts of the rod give way, so that friction of 0.57 along it reads as 0.50."""
        for name, overshoots in ("h1_light", True), ("h3_over", False):
            fit = self.json("fit", CASES / f"snaps_that_overshoot/{name}.toml", "--quiet")
            low, high = fit["parameters"]["mu0"]["interval95"]
            self.assertEqual(fit["snaps_overshoot"], overshoots)
            self.assertTrue(low < 0.5 < high, (name, low, high))

    def test_the_stage_says_so_before_the_rig(self):
        once = WAVY + "[stage]\nprogram = [0, 0.5]\nstep = 0.002\n"

        def lengths(case):
            return [point["length"] for point in self.json("simulate", self.file("case.toml", case))["path"]]

        over = once.replace("[rig]\n", '[rig]\nsnaps = "overshoot"\n')
        self.assertEqual(lengths(over), lengths(once + 'snaps = "overshoot"\n'))
        self.assertEqual(lengths(over + 'snaps = "nearest"\n'), lengths(once))
        self.assertNotEqual(lengths(over), lengths(once))
        self.refused("design", self.file("case.toml", over), says=["[rig] snaps", "overshoot"])


class SupportsThatGiveWay(InFolder):
    """Each of 180 N/m, under a load train of 90: together 72 N/m."""

    SECTION = '[specimen]\ndiameter = "34.8 um"\nmodulus = { value = "30 GPa", uncertainty = "3 %" }\n'
    RIG = '[rig]\nspan = "1278 um"\nstiffness = "90 N/m"\nsupport_stiffness = "180 N/m"\n'
    TOGETHER = '[rig]\nspan = "1278 um"\nstiffness = "72 N/m"\n'
    WAVES = '[friction]\nmodel = "sinusoid"\nmu0 = 0.5\namplitude = 0.2\nwavelength = "11 um"\n'
    STAGE = '[stage]\nprogram = ["0 um", "700 um"]\nstep = "2 um"\n'

    def test_identity_simulated_and_designed_as_with_both_in_line(self):
        one = self.file("one.toml", self.SECTION + self.RIG + self.WAVES + self.STAGE)
        two = self.file("two.toml", self.SECTION + self.TOGETHER + self.WAVES + self.STAGE)
        for here, there in zip(self.json("simulate", one)["path"], self.json("simulate", two)["path"]):
            for name in "force", "deflection", "length":
                self.assertAlmostEqual(here[name], there[name], delta=1e-12)
        here, there = self.json("design", one), self.json("design", two)
        for name in "snaps", "first_snap_stage", "critical_stiffness":
            self.assertAlmostEqual(here[name], there[name], delta=1e-9 * there[name])
        self.assertIn("with the supports together", self.succeeds("design", one))
        train = [change["to"] for change in here["changes"] if change["parameter"] == "stiffness" and change["and_beyond"]]
        # no load train is so stiff that both together are stiffer than the supports: 360 N/m
        self.assertEqual(train != [], here["critical_stiffness"] < 360)
        said = " ".join(self.succeeds("design", one).split())
        self.assertEqual("on these supports no load train reaches that" in " ".join(said.split()), here["critical_stiffness"] > 360)
        thinner = [[change["to"] for change in of["changes"] if change["parameter"] == "diameter"] for of in (here, there)]
        self.assertEqual(len(thinner[0]) > 0, True)
        self.assertAlmostEqual(thinner[0][0], thinner[1][0], delta=1e-4 * thinner[1][0])  # what a search leaves, bending_test/design.h

    def test_identity_a_record_is_read_as_with_both_in_line_by_stage_and_by_deflection(self):
        self.succeeds("simulate", self.file("truth.toml", self.SECTION + self.RIG + self.WAVES + self.STAGE), "--noise", "5 uN", "--output", self.folder / "test.csv")
        by_stage = '[record]\nfile = "test.csv"\nstage = "w_s"\nforce = "F"\ncontact = "0 m"\n'
        by_deflection = '[record]\nfile = "test.csv"\ndeflection = "w"\nforce = "F"\ncontact = "0 m"\n'
        as_certain = self.TOGETHER.replace("72 N/m", "72 N/m ± 1.6 %")  # the usual 2 % is that of 90 N/m
        estimates = [self.json("fit", self.file(f"{name}.toml", self.SECTION + rig + record), "--quiet")["parameters"]["mu0"]
                     for name, rig, record in (("a", self.RIG, by_stage), ("b", as_certain, by_stage), ("c", self.RIG, by_deflection))]
        answers = [estimate["value"] for estimate in estimates]
        # The file rounds stage and deflection differently, and the search stops within this share of the error.
        rounding = 1e-3 * estimates[0]["standard_error"]
        self.assertAlmostEqual(answers[0], 0.5, delta=0.03)
        self.assertAlmostEqual(answers[1], answers[0], delta=rounding)
        self.assertAlmostEqual(answers[2], answers[0], delta=rounding)

    def test_refused(self):
        for stiffness in '"0 N/m"', '"-1 N/m"', "180", '"180 N"':
            case = self.file("case.toml", self.SECTION + self.RIG.replace('"180 N/m"', stiffness) + self.WAVES + self.STAGE)
            self.refused("simulate", case, says=["[rig] support_stiffness"])


def with_free_nose(case):
    return case.replace("[rig]\n", '[rig]\nnose = "free"\n')


class TwoSupports(InFolder):
    def simulated(self, friction, stage, *options):
        """Under a free nose."""
        return self.json("simulate", self.file("case.toml", with_free_nose(friction) + stage), *options)

    def test_limit_under_a_nose_that_holds_sides_that_are_alike_are_as_one(self):
        alike = "[friction.other]\n" + WAVY[WAVY.index("[friction]") + len("[friction]\n"):]
        once = "[stage]\nprogram = [0, 0.5]\nstep = 0.02\n"
        one, two = (self.json("simulate", self.file("case.toml", case + once)) for case in (WAVY, WAVY + alike))
        self.assertEqual(len(one["snaps"]), len(two["snaps"]))
        for a, b in zip(one["path"], two["path"]):
            self.assertAlmostEqual(a["force"], b["force"], delta=1e-11)

    def test_under_a_nose_that_holds_static_excess_and_overshoot_are_as_on_one_profile(self):
        self.json("simulate", self.file("case.toml", WAVY + "static_excess = 0.1\n" + OTHER + LOOP))
        self.json("simulate", self.file("case.toml", WAVY + OTHER + LOOP + 'snaps = "overshoot"\n'))

    def test_identity_what_is_drawn_in_over_both_is_the_length(self):
        path = self.simulated(WAVY + OTHER, LOOP)["path"]
        for point in path:
            self.assertAlmostEqual(1 + point["left"] + point["right"], point["length"], delta=1e-13)
        self.assertGreater(max(abs(point["left"] - point["right"]) for point in path), 0.01)

    def test_identity_the_energies_close(self):
        energy = self.simulated(WAVY + OTHER, LOOP)["energy"]
        parts = sum(energy[name] for name in ("bending", "load_train", "friction", "snaps", "cracks"))
        self.assertAlmostEqual(energy["stage_work"], parts, delta=1e-10)

    def test_limit_two_rising_supports_that_are_alike_are_as_one(self):
        rising = RIG + '[friction]\nmodel = "constant"\nmu0 = 0.3\ndrift = 0.5\n'
        other = '[friction.other]\nmodel = "constant"\nmu0 = 0.3\ndrift = 0.5\n'
        once = "[stage]\nprogram = [0, 0.4]\nstep = 0.02\n"
        one, two = self.simulated(rising, once)["path"], self.simulated(rising + other, once)["path"]
        for a, b in zip(one, two):
            self.assertAlmostEqual(a["force"], b["force"], delta=1e-11)
            self.assertAlmostEqual(b["left"], b["right"], delta=1e-10)

    def test_limit_a_support_that_never_lets_go_leaves_the_other_twice_as_steep(self):
        half = WAVY.replace("wavelength = 0.02", "wavelength = 0.01")
        never = '[friction.other]\nmodel = "constant"\nmu0 = 5\n'
        # phase: cos(π S/λ + φ) at S = 1 is that of half the wavelength with φ + π/λ less
        once = "[stage]\nprogram = [0, 0.4]\nstep = 0.02\n"
        one = self.simulated(half + "phase = 0\n", once)["path"]
        two = self.simulated(WAVY + f"phase = {numbers_of_turn()}\n" + never, once)["path"]
        for a, b in zip(one, two):
            self.assertAlmostEqual(a["force"], b["force"], delta=1e-9)
            self.assertEqual(b["right"], 0)

    def test_design_sweep_and_equilibrium_take_the_weaker_side(self):
        once = "[stage]\nprogram = [0, 0.5]\nstep = 0.005\n"
        case = self.file("two.toml", with_free_nose(WAVY + OTHER) + once)
        snaps = self.json("simulate", self.file("path.toml", with_free_nose(WAVY + OTHER) + "[stage]\nprogram = [0, 0.5]\n"))["snaps"]
        design = self.json("design", case)
        self.assertEqual(design["snaps"], len(snaps))
        path = self.json("simulate", case)["path"]
        curve = self.json("equilibrium", case, "--points", "4001")["curve"]
        for point in path[20:]:
            nearest = min(curve, key=lambda on_curve: abs(on_curve["length"] - point["length"]))
            self.assertAlmostEqual(nearest["mu"], point["q"], delta=0.02)

    def test_refused(self):
        for friction, stage, says in (
            (with_free_nose(WAVY + "static_excess = 0.1\n" + OTHER), LOOP, ["[friction] static_excess", "the two supports differ and the nose is free"]),
            (with_free_nose(WAVY + OTHER), LOOP + 'snaps = "overshoot"\n', ["[stage] snaps", "the two supports differ and the nose is free"]),
            (WAVY + OTHER.replace("0.52", "20"), LOOP, ["[friction.other] mu0", "the limit is 20"]),
            (WAVY + OTHER.replace("0.0154", "1e-9"), LOOP, ["[friction.other] wavelength", "periods"]),
            (WAVY + OTHER + "static_excess = 0.1\n", LOOP, ["[friction.other] static_excess", "Delete it"]),
            (WAVY + "other = 1\n", LOOP, ["[friction.other]", "the number 1"]),
            (WAVY + "[friction.other]\n", LOOP, ["[friction.other] model", "This value is missing", "Add model = "]),
            (WAVY + '[friction.other]\nmodel = "roughness"\n', LOOP, ["[friction.other] model", "can only be fitted"]),
            (WAVY + OTHER.replace("other", "othr"), LOOP, ["Did you mean 'other'?"]),
            (WAVY + '[friction.other]\nmodel = "constant"\n', LOOP, ["[friction.other] mu0", "Add mu0 = 0.5"]),
            (RIG + '[friction]\nmodel = "roughness"\n' + OTHER, LOOP, ["[friction.other]", "a model to fit", "Write a model to compute with"]),
        ):
            with self.subTest(says=says):
                self.refused("simulate", self.file("case.toml", friction + stage), says=says)


def numbers_of_turn():
    """The phase at which cos(π S/0.02 + φ), gone twice as fast from S = 1 on, is cos(π S/0.01)."""
    return math.pi / 0.01 - math.pi / 0.02


if __name__ == "__main__":
    unittest.main()
