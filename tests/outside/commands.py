#!/usr/bin/python3
"""outside: the commands' answers against the paper, closed forms and each other."""
import csv
import json
import math
import re
import subprocess
import unittest

from program import PROGRAM, SOURCE, WAVY, InFolder, against, numbers, run, table

# the paper, Fig. 8B: mu = 0.6 (1 + 0.4 cos(S/0.02)), k = 30; so wavelength = 0.02 pi.
FIG_8B = f"""reduced = true
[rig]
stiffness = 30
[friction]
model = "sinusoid"
mu0 = 0.6
amplitude = 0.4
wavelength = {0.02 * math.pi!r}
[stage]
program = [0, 0.76]
step = "continuous"
"""
# The folds at which it snaps in loading, (S, w_s), to the six digits that are known.
FOLDS_8B = [(1.14852, 0.588456), (1.26252, 0.698273), (1.38547, 0.754599)]
DRIFTING = """[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "drift"
mu0 = {mu0}
drift = "0.8 1/mm"
{more}[stage]
program = ["0 um", "700 um"]
step = "2 um"
"""
FRICTIONLESS = 'reduced = true\n[friction]\nmodel = "constant"\nmu0 = 0\n'
PEAK = (0.238188798912727, 6.67180843438173)  # w and F of the frictionless maximum of the force
GAUSS = 0.834626841674073  # w where the force of the frictionless fibre vanishes: Gauss's constant
SIX_DIGITS = 5e-7
FIFTEEN_DIGITS = 1e-14  # the reference's own digits


class State(InFolder):
    def test_limit_straight_fibre(self):
        self.assertEqual(self.succeeds("state", "--S", "1", "--q", "0.5").splitlines()[1].split(",")[:4], ["1", "0.5", "0", "0"])

    def test_on_rollers_a_bar_without_friction_is_stiffer_than_on_edges(self):
        """ISO 178: a span of 64 mm, 4 mm thick, rollers of 5 mm. 40-digit values."""
        bar = self.json("state", "--w", "0.16730968618594", "--q", "0.4", "--roller-radius", "0.078125", "--thickness", "0.0625")["states"][0]
        self.assertAlmostEqual(bar["F"], 8.6724978532042, delta=1e-11)
        self.assertAlmostEqual(bar["length"], 0.95699049187845, delta=1e-12)
        self.assertAlmostEqual(bar["slid"], 0.0351829323475, delta=1e-12)
        free = numbers(self.succeeds("state", "--w", "0.1", "--q", "0", "--roller-radius", "0.078125", "--thickness", "0.0625"), "F")[0]
        self.assertGreater(free, 1.04 * 48 * 0.1)
        edges = numbers(self.succeeds("state", "--w", "0.1", "--q", "0", "--roller-radius", "0"), "F")[0]
        self.assertLess(edges, 48 * 0.1)

    ON_ROLLERS = "--roller-radius", "0.078125", "--thickness", "0.0625"

    def test_friction_of_a_thick_bar_on_rollers_is_read_back_and_edges_see_far_more(self):
        """ISO 178: a span of 64 mm, 4 mm thick, rollers of 5 mm; beyond twice its thickness."""
        deflections = [0.126 + 0.002 * i for i in range(13)]
        for mu in 0, 0.15, 0.3:
            bar = "w,q\n" + "".join(f"{w},{mu}\n" for w in deflections)
            force = numbers(self.succeeds("state", self.file("bar.csv", bar), *self.ON_ROLLERS), "F")
            record = self.file("record.csv", "w,F\n" + "".join(f"{w},{F!r}\n" for w, F in zip(deflections, force)))
            for q in numbers(self.succeeds("invert", record, *self.ON_ROLLERS), "q"):
                self.assertAlmostEqual(q, mu, delta=1e-9)
            on_edges = numbers(self.succeeds("invert", record), "q")
            self.assertGreater(min(on_edges) - mu, 0.3)

    ISO_BAR = '''[specimen]
width = "10 mm"
height = "4 mm"
modulus = "3 GPa"
[rig]
span = "64 mm"
stiffness = "50 N/mm"
roller_radius = "5 mm"
[stage]
program = ["0 mm", "20 mm", "2 mm"]
step = "0.1 mm"
[friction]
model = "sinusoid"
mu0 = 0.3
amplitude = 0.2
'''

    def test_friction_that_a_roller_cannot_follow_is_refused_and_what_it_can_is_simulated(self):
        """An ISO bar: the point that touches moves with friction, and would jump on the shorter wave."""
        self.succeeds("simulate", "--quiet", self.file("longer.toml", self.ISO_BAR + 'wavelength = "0.1 mm"'))
        shorter = self.file("shorter.toml", self.ISO_BAR + 'wavelength = "0.02 mm"')
        for command in "simulate", "design":
            self.refused(command, shorter, says=["wavelength: Friction changes with the length between the"])
        remedy = run("simulate", shorter).stderr
        for key, told in ("friction.wavelength", "a wavelength of at least "), ("rig.roller_radius", "a roller_radius of at most "):
            value = remedy[remedy.index(told) + len(told):].split(",")[0].strip(" .\n")
            self.succeeds("simulate", "--quiet", shorter, "--set", f'{key}="{value}"')
        steep = self.ISO_BAR.replace('"sinusoid"', '"rough"').replace("amplitude = 0.2", "rms = 0.3\nseed = 1") + 'correlation_length = "5 um"'
        told, remedy = "Write at least ", run("simulate", self.file("steep.toml", steep)).stderr
        value = remedy[remedy.index(told) + len(told):].split(",")[0].strip(" .\n")
        self.succeeds("simulate", "--quiet", self.folder / "steep.toml", "--set", f'friction.correlation_length="{value}"')

    def test_unlike_supports_on_rollers_are_refused_by_each_command(self):
        case = self.file("unlike.toml", self.ISO_BAR + 'wavelength = "0.3 mm"\n[friction.other]\nmodel = "constant"\nmu0 = 0.2')
        for command in "simulate", "design", "equilibrium":
            self.refused(command, case, says=["unlike.toml:8", "roller_radius: [friction.other] gives", "[friction.other]"])
        self.succeeds("simulate", "--quiet", self.file("edges.toml", self.ISO_BAR.replace('roller_radius = "5 mm"', "") + 'wavelength = "0.02 mm"'))

    def test_what_is_left_out_of_a_bar_is_said(self):
        """Shear of an ISO bar, and that it breaks."""
        case = self.ISO_BAR + 'wavelength = "0.3 mm"'
        breaking = case.replace('modulus = "3 GPa"', 'modulus = "3 GPa"\nstrain_at_break = "3 %"')
        path = self.json("simulate", "--quiet", self.file("quiet.toml", breaking))["path"]
        reaches = next(point["stage"] for point in path if point["strain"] >= 0.03)
        says = run("simulate", self.file("breaks.toml", breaking)).stderr
        self.assertIn("shear, which is neglected, would add 1.2 %", says)
        self.assertIn(f"would break at the stage position {1e3 * reaches:.4g} mm", says)
        self.refused("simulate", self.file("percent.toml", breaking.replace('"3 %"', "3")), says=["strain_at_break", '"2 %"'])
        depthless = case.replace('width = "10 mm"\nheight = "4 mm"\nmodulus = "3 GPa"', 'bending_stiffness = "0.16 N m^2"')
        self.refused("simulate", self.file("depth.toml", depthless.replace("[stage]", 'friction_at = "surface"\n[stage]')), says=["friction_at", "Add diameter"])

    def test_a_case_on_rollers_is_read_with_the_thickness_of_its_section(self):
        deflections = [0.126 + 0.001 * i for i in range(40)]
        bar = "w,q\n" + "".join(f"{w},0.2\n" for w in deflections)
        force = numbers(self.succeeds("state", self.file("bar.csv", bar), *self.ON_ROLLERS), "F")
        # 64 mm, 4 mm by 10 mm, 3 GPa: EI = 0.16 N m², forces in units of EI/L² = 39.0625 N.
        rows = [(0.064 * w, 39.0625 * F) for w, F in [(0.001 * i, 48 * 0.001 * i) for i in range(30)] + list(zip(deflections, force))]
        self.file("bar_record.csv", "w [m],F [N]\n" + "".join(f"{w!r},{F!r}\n" for w, F in rows))
        case = self.file("bar.toml", '''[specimen]
height = "4 mm"
width = "10 mm"
modulus = { value = "3 GPa", uncertainty = "1 %" }
[rig]
span = "64 mm"
stiffness = "1e9 N/m"
[record]
file = "bar_record.csv"
deflection = "w [m]"
force = "F [N]"
contact = "0 m"
''')
        for flags in (["--roller-radius", "5 mm"], ["--roller-radius", "5 mm", "--thickness", "4 mm"]):
            profile = self.json("invert", case, *flags)["profile"]
            self.assertGreater(len(profile), 35)
            for point in profile:
                self.assertGreaterEqual(point["deflection"], 0.008 * (1 - 1e-12))  # twice the thickness
                self.assertAlmostEqual(point["mu"], 0.2, delta=1e-6)
                self.assertGreater(point["drawn_in"], point["length"] - 0.064)
                self.assertGreater(point["mu_error"], 0)

    BAR = '''[specimen]
height = "4 mm"
width = "10 mm"
modulus = {{ value = "3 GPa", uncertainty = "1 %" }}
[rig]
span = "64 mm"
stiffness = "{stiffness}"
{rig}
[friction]
model = "constant"
{rest}
'''

    def bar(self, name, rest, rig='roller_radius = "5 mm"', stiffness="2 kN/mm"):
        return self.file(name, self.BAR.format(rest=rest, rig=rig, stiffness=stiffness))

    def test_oracle_a_simulated_bar_on_rollers_is_fitted_back_within_0_01_and_edges_are_far_off(self):
        for mu in 0, 0.15, 0.3:
            case = self.bar("truth.toml", f'mu0 = {mu}\n[stage]\nprogram = ["0 mm", "13 mm"]\nstep = "0.05 mm"')
            self.succeeds("simulate", "--quiet", case, "--noise", "0.02 N", "--seed", "3", "--output", self.folder / "bar_test.csv")
            for rig, most in ('roller_radius = "5 mm"', 0.01), ("", None):
                record = self.bar("read.toml", '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 m"\nfailure = "none"', rig=rig)
                mean = self.json("fit", record, "--quiet")["parameters"]["mu0"]["value"]
                if most:
                    self.assertAlmostEqual(mean, mu, delta=most)
                else:
                    self.assertGreater(mean - mu, 0.3)

    def test_identity_design_and_simulation_on_rollers_agree(self):
        case = self.bar("planned.toml", 'mu0 = 0.3\n[stage]\nprogram = ["0 mm", "13 mm"]', stiffness="100 N/mm")
        design = self.json("design", case, "--quiet")
        last = self.json("simulate", "--quiet", case, "--quiet")
        path = last["path"]
        self.assertAlmostEqual(design["greatest_force"], max(point["force"] for point in path), delta=1e-6 * design["greatest_force"])
        work = last["energy"]["stage_work"] - last["energy"]["load_train"]
        self.assertAlmostEqual(design["work"], work, delta=1e-6 * work)
        curve = self.json("equilibrium", case, "--longest", "70 mm", "--quiet")["curve"]
        self.assertAlmostEqual(curve[0]["drawn_in"], 0)
        self.assertLess(curve[0]["length"], 0.064)  # some of it lies on the rollers
        self.assertGreater(curve[0]["deflection"], 0.002)  # 2.5 half depths and more

    THIN = """[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "60 N/m"
roller_radius = "50 um"
rollers = "pinned"
pin_radius = "40 um"
pin_friction = 0.1
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.4
wavelength = "60 um"
[stage]
program = ["0 um", "900 um"]
"""

    def test_identity_heat_of_snaps_on_rollers_is_that_of_a_simulation(self):
        case = self.file("fixed.toml", "\n".join(line for line in self.THIN.splitlines() if not line.startswith(("pin_", "rollers"))).replace("60 um", "16 um").replace("0.4", "0.2"))
        design = self.json("design", case, "--quiet", "--over", "mu0=0.5:0.51:2")["designs"][0]
        energy = self.json("simulate", case, "--quiet")["energy"]
        self.assertGreater(design["snaps"], 10)
        for told, simulated in ("friction_heat", "friction"), ("released", "snaps"):
            self.assertAlmostEqual(design[told], energy[simulated], delta=1e-5 * design["work"])

    PINNED = 'roller_radius = "5 mm"\nrollers = "pinned"\npin_radius = "1 mm"\npin_friction = 0.1'

    def test_on_pins_a_bar_shows_the_friction_of_the_pins_and_it_is_fitted_back(self):
        case = self.bar("pins.toml", 'mu0 = 0.3\n[stage]\nprogram = ["0 mm", "13 mm"]\nstep = "0.05 mm"', rig=self.PINNED)
        self.succeeds("simulate", "--quiet", case, "--noise", "0.02 N", "--output", self.folder / "bar_test.csv")
        record = self.bar("read.toml", '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 m"\nfailure = "none"', rig=self.PINNED)
        self.assertAlmostEqual(self.json("fit", record, "--quiet")["parameters"]["mu0"]["value"], 0.02, delta=0.01)

    def test_a_case_in_inches_is_answered_in_inches_and_pounds(self):
        bar = self.BAR.format(rest='mu0 = 0.3\n[stage]\nprogram = ["0 in", "0.5 in"]\nstep = "0.002 in"', rig='roller_radius = "0.2 in"', stiffness="11000 lbf/in")
        bar = bar.replace("64 mm", "2.5 in").replace("4 mm", "0.16 in").replace("10 mm", "0.4 in").replace("3 GPa", "435 ksi")
        case = self.file("inches.toml", bar)
        self.succeeds("simulate", "--quiet", case, "--noise", "0.005 lbf", "--output", self.folder / "bar_test.csv")
        record = self.file("read.toml", bar[:bar.index("[friction]")] + '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 in"\nfailure = "none"\n')
        for words in self.succeeds("fit", record, "--quiet", "--full"), self.succeeds("modulus", record), self.succeeds("modulus", record, "--full"), self.succeeds("design", case, "--quiet"):
            self.assertIn(" in", words)
            self.assertIn("lbf", words)
            for unit in "mm", "µm", "kN", "MPa", "GPa", "mJ":
                self.assertNotIn(f" {unit}", words)
        self.assertEqual(self.json("fit", record, "--quiet")["parameters"]["bending_stiffness"]["unit"], "N m^2")

    def test_friction_beyond_what_pins_let_act_is_implausible(self):
        stage = '\n[stage]\nprogram = ["0 mm", "13 mm"]\nstep = "0.05 mm"'
        self.succeeds("simulate", "--quiet", self.bar("stuck.toml", "mu0 = 0.3" + stage), "--noise", "0.02 N", "--output", self.folder / "bar_test.csv")
        record = self.bar("read.toml", '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 m"\nfailure = "none"', rig=self.PINNED)
        answer = self.json("fit", record, "--quiet")
        self.assertIn("turn on their pins at a friction of 0.02", " ".join(self.succeeds("fit", record, "--full", "--quiet").split()))
        self.assertIn("implausible_friction", against(answer))
        self.assertIn("check whether they are stuck", " ".join(self.succeeds("fit", record, "--full", "--quiet").split()))

    def test_design_says_what_pins_decide_and_how_hard_they_would_have_to_turn(self):
        case = self.file("wavy.toml", self.THIN)
        answer = self.json("design", case, "--quiet")
        self.assertAlmostEqual(answer["pin_limit"], 0.08 / math.sqrt(1 - 0.08**2), delta=1e-12)
        self.assertEqual(answer["snaps"], 0)
        self.assertIn("turn on their pins at a friction of 0.08", self.succeeds("design", case, "--quiet"))
        change = next(change for change in answer["changes"] if change["parameter"] == "pin_friction")
        designs = self.json("design", case, "--quiet", "--over", f"pin_friction={0.99 * change['to']}:{1.01 * change['to']}:3")["designs"]
        self.assertEqual([design["snaps"] > 0 for design in designs], [False, True, True])
        designs = self.json("design", case, "--quiet", "--over", "pin_friction=0.1:1.3:3")["designs"]
        self.assertEqual([design["status"] for design in designs], ["ok", "ok", "impossible"])

    def test_oracle_modulus_less_what_supports_add_is_that_of_the_specimen_simulated(self):
        for rig in 'roller_radius = "5 mm"', "":
            case = self.bar("truth.toml", 'mu0 = 0\n[stage]\nprogram = ["0 mm", "8 mm"]\nstep = "0.02 mm"', rig=rig)
            self.succeeds("simulate", "--quiet", case, "--output", self.folder / "bar_test.csv")
            record = self.bar("read.toml", '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 m"\nfailure = "none"', rig=rig)
            answer = self.json("modulus", record)
            self.assertAlmostEqual(answer["modulus_less_supports"]["value"], 3e9, delta=1e-4 * 3e9)
            share = answer["supports_share"]
            self.assertAlmostEqual(answer["chord"]["modulus"]["value"], (1 + share) * answer["modulus_less_supports"]["value"], delta=10)
            self.assertEqual("which adds" in self.succeeds("modulus", record, "--full"), share > 0.001)
            self.assertEqual("contacts that move inwards add" in self.succeeds("modulus", record), share > 0.001)

    def test_oracle_what_friction_is_said_to_do_is_what_a_simulated_friction_does(self):
        stage = '[stage]\nprogram = ["0 mm", "3 mm"]\nstep = "0.01 mm"'
        record = '[record]\nfile = "bar_test.csv"\nstage = "w_s [m]"\nforce = "F [N]"\ncontact = "0 m"\nfailure = "none"'
        beginning = ["--window", "0", "0.1"]  # an elastic bar becomes steeper and has no toe
        chords = {}
        for mu in 0, 0.2, 0.5:
            self.succeeds("simulate", "--quiet", self.bar("truth.toml", f"mu0 = {mu}\n{stage}"), "--output", self.folder / "bar_test.csv")
            chords[mu] = self.json("modulus", self.bar("read.toml", record), *beginning)["chord"]["modulus"]["value"]
        usual = self.json("modulus", self.bar("read.toml", record))["friction"]
        self.assertEqual((usual["mu"], usual["stated"], usual["turns"]), ([0.1, 0.5], False, False))
        for flags, least, most in ((["0.2", "0.5"], 0.2, 0.5), (["0.5"], 0.5, 0.5)):
            told = self.json("modulus", self.bar("read.toml", record), *beginning, "--friction", *flags)["friction"]
            self.assertEqual((told["mu"], told["stated"]), ([least, most], True))
            for share, mu in zip(told["modulus_share"], (least, most)):
                self.assertAlmostEqual(share, chords[mu] / chords[0] - 1, delta=1e-4)  # of a chord between readings
        by_case = self.json("modulus", self.bar("read.toml", "mu0 = 0.2\n" + record))["friction"]
        self.assertEqual((by_case["mu"], by_case["stated"]), ([0.2, 0.2], True))
        words = " ".join(self.succeeds("modulus", self.bar("read.toml", record), *beginning, "--full").split())
        self.assertRegex(words, r"Friction of 0.1 to 0.5 at these supports adds 0.7\d to 3.9 % to the modulus and .* to the strength, and takes .* of the work")
        turning = 'roller_radius = "5 mm"\nrollers = "pinned"\npin_radius = "1 mm"\npin_friction = 0.2'
        pinned = self.json("modulus", self.bar("read.toml", record, rig=turning), *beginning)["friction"]
        self.assertTrue(pinned["turns"])
        self.assertLess(pinned["modulus_share"][1], 0.1 * told["modulus_share"][1])
        for wrong in ["0.5", "0.1"], ["3"], ["-0.1"], ["spam"]:
            self.refused("modulus", self.bar("read.toml", record), "--friction", *wrong, says=["--friction"])

    def test_loose_rollers_of_earlier_versions_are_refused_by_a_sentence_that_says_so(self):
        case = self.bar("loose.toml", 'mu0 = 0.3\n[stage]\nprogram = ["0 mm", "12 mm"]', rig='roller_radius = "5 mm"\nrollers = "loose"')
        for command in "simulate", "design", "equilibrium":
            self.refused(command, case, says=["loose.toml:", '[rig] rollers: \'loose\' is not "fixed" or "pinned"', "a feature of earlier versions"])

    def test_supports_of_a_case_that_are_none_are_refused(self):
        for rig, said in (('rollers = "pinned"', "State the radius, [rig] roller_radius, or delete it"), (self.PINNED.replace("pinned", "held"), '"fixed" or "pinned"'),
                          (self.PINNED.replace('"pinned"', '"fixed"'), "This needs rollers on pins, and the rollers are 'fixed'"), (self.PINNED.replace("1 mm", "6 mm"), "The radius of the pin is 1.2 times the radius of the roller"),
                          (self.PINNED.replace("pin_friction = 0.1", ""), "such as pin_friction = 0.1"), (self.PINNED.replace("pin_friction = 0.1", ""), 'This value is missing for rollers = "pinned"'),
                          (self.PINNED.replace('pin_radius = "1 mm"', ""), "such as pin_radius = '1 mm'"), (self.PINNED.replace("0.1", "7"), "ratio of the radii of roller and pin")):
            self.refused("simulate", self.bar("p.toml", 'mu0 = 0.3\n[stage]\nprogram = ["0 mm", "13 mm"]', rig=rig), says=[said])
        ends = 'mu0 = 0.3\n[stage]\nprogram = ["0 mm", "13 mm"]'
        self.refused("simulate", self.bar("a.toml", ends, rig='roller_radius = "30 mm"'), says=["roller_radius", "add up to 0.45 spans or more"])
        self.refused("simulate", self.bar("b.toml", ends, rig='roller_radius = "-1 mm"'), says=["roller_radius"])
        self.refused("simulate", self.bar("c.toml", ends, rig='roller_radius = 5'), says=["roller_radius", "unit"])
        self.refused("simulate", self.bar("d.toml", ends, rig='friction_at = "skin"'), says=["friction_at", '"surface" or "axis"'])
        self.refused("simulate", self.bar("e.toml", "static_excess = 0.1\n" + ends), says=["static_excess", "rollers"])

    def test_a_reading_that_no_roller_explains_is_left_out_and_a_case_needs_no_specimen(self):
        rows = [(0.002 * i, 48 * 0.002 * i * (1 + 0.002 * i)) for i in range(150)] + [(2.5, 30.0)]
        self.file("far.csv", "w,F\n" + "".join(f"{w!r},{F!r}\n" for w, F in rows))
        case = self.file("far.toml", 'reduced = true\n[rig]\nstiffness = 1e9\n[record]\nfile = "far.csv"\ndeflection = "w"\nforce = "F"\ncontact = 0\nfailure = "none"\n')
        result = run("invert", case, "--roller-radius", "0.01", "--json")
        answer = json.loads(result.stdout)
        self.assertTrue(all(point["deflection"] < 2 for point in answer["profile"]))
        self.assertIn(151, answer["unexplained"])
        self.file("short.csv", "w [mm],F [N]\n" + "".join(f"{0.064 * 1e3 * w!r},{F!r}\n" for w, F in rows[:150]))
        bare = self.file("bare.toml", '[rig]\nspan = "64 mm"\nstiffness = "1e9 N/m"\n[record]\nfile = "short.csv"\ndeflection = "w [mm]"\nforce = "F [N]"\ncontact = "0 m"\n')
        self.assertGreater(len(self.json("invert", bare, "--roller-radius", "1 mm", "--quiet")["profile"]), 3)

    def test_supports_of_invert_that_are_none_are_refused(self):
        points = self.file("points.csv", "w,F\n0.2,9\n")
        self.refused("invert", points, "--roller-radius", "0.5", says=["--roller-radius", "less than 0.45 spans", "Check the units of both"])
        self.refused("invert", points, "--roller-radius", "-1", says=["--roller-radius"])
        for thickness in "1", "0.2":
            self.refused("invert", points, "--thickness", thickness, says=["--thickness", "is not between 0 and 0.2 spans"])
            self.refused("state", "--w", "0.1", "--q", "0", "--thickness", thickness, says=["--thickness", "is not between 0 and 0.2 spans", "beam theory"])
        self.refused("invert", points, "--roller-radius", "5 mm", says=["--roller-radius"])
        self.refused("state", "--w", "0.1", "--q", "0", "--roller-radius", "5 mm", says=["--roller-radius = 5 mm is not a number"])
        result = run("invert", points, "--thickness", "0.12")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no friction between -2 and 2", result.stderr)

    def test_rollers_that_leave_no_span_and_states_by_the_wrong_number_are_refused(self):
        self.refused("state", "--w", "0.1", "--q", "0", "--roller-radius", "0.4", "--thickness", "0.15", says=["--roller-radius", "less than 0.45 spans"])
        self.refused("state", "--w", "0.1", "--q", "0", "--roller-radius", "-0.1", says=["--roller-radius"])
        self.refused("state", "--w", "0.1", "--q", "0", says=["--w", "Write --S"])
        self.refused("state", "--S", "1.1", "--q", "0", "--thickness", "0.1", says=["--S", "Write --w"])
        self.refused("state", "--w", "0", "--q", "0", "--thickness", "0.1", says=["--w", "a deflection of 0 to 2 spans"])
        self.refused("state", "--w", "0.1", "--q", "0", "--thickness", "0.1", "--slopes", says=["--slopes", "edges"])
        result = run("state", "--w", "1.9", "--q", "0", "--thickness", "0.1")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no state with a force exists at w = 1.9", result.stderr)

    def test_identity_slopes_balance_energy(self):
        # dU = F dw - q P_n dS
        for S, q in ((1.01, 0.4), (1.2, -0.3), (1.6, 1.0)):
            at = self.json("state", "--S", S, "--q", q, "--slopes")["states"][0]
            # 1e-13: the slopes are good to 1e-14 of terms of this size
            self.assertLess(abs(at["U_S"] - (at["F"] * at["w_S"] - q * at["Pn"])), 1e-13 * abs(at["F"] * at["w_S"]))
            self.assertLess(abs(at["U_q"] - at["F"] * at["w_q"]), 1e-13)

    def test_identity_invert_undoes_state(self):
        states = self.succeeds("state", "-", stdin="S,q\n1.05,0.2\n1.3,0.6\n1.5,-0.1\n")
        inverted = self.succeeds("invert", "-", stdin=states)
        for name in ("S", "q"):
            for before, after in zip(numbers(states, name), numbers(inverted, name)):
                self.assertAlmostEqual(before, after, delta=1e-12)  # 1e-14 times the condition of q, below 100 here

    def test_paper_frictionless_peak(self):
        w, F = PEAK
        self.assertAlmostEqual(numbers(self.succeeds("invert", "-", stdin=f"w,F\n{w},{F}\n"), "q")[0], 0, delta=FIFTEEN_DIGITS * 10)


class Equilibrium(InFolder):
    def test_paper_frictionless_curve(self):
        case = self.file("case.toml", FRICTIONLESS)
        curve = self.succeeds("equilibrium", case, "--points", "20001", "--longest", "2")
        F = numbers(curve, "F")
        self.assertAlmostEqual(max(F), PEAK[1], delta=1e-6)  # at a maximum, half the distance of points, 1e-4, squared times F''
        result = run("equilibrium", case, "--longest", "2.5")
        self.assertEqual(result.returncode, 0)
        self.assertIn("the force has fallen to zero", result.stderr)
        self.assertAlmostEqual(numbers(result.stdout, "w")[-1], GAUSS, delta=FIFTEEN_DIGITS * 10)

    def test_identity_region_holds_the_curve(self):
        case = self.file("case.toml", FIG_8B)
        region = self.succeeds("equilibrium", case, "--region", "--points", "20", "--levels", "5", "--longest", "1.2")
        curve = self.succeeds("equilibrium", case, "--points", "20", "--longest", "1.2")
        self.assertEqual(numbers(region, "F")[4::5], numbers(curve, "F"))
        self.assertEqual(numbers(region, "q")[4::5], numbers(curve, "mu"))
        self.assertEqual(list(table(region)), ["S", "q", "w", "F"])

    def test_no_default_misses_the_roughness(self):
        # Forty thousand periods: the extremes of mu are known.
        case = self.file("case.toml", FIG_8B.replace(repr(0.02 * math.pi), "6e-6"))
        mu = numbers(self.succeeds("equilibrium", case), "mu")
        # A cosine sampled 16 times a period misses its extremes by at most 1 - cos(pi/16) = 2 %.
        self.assertGreater(max(mu), 0.6 * (1 + 0.4 * 0.98))
        self.assertLess(min(mu), 0.6 * (1 - 0.4 * 0.98))


class Simulate(InFolder):
    def test_paper_fig_8b(self):
        answer = self.json("simulate", self.file("case.toml", FIG_8B))
        self.assertEqual(answer["status"], "ok")
        self.assertEqual(len(answer["snaps"]), len(FOLDS_8B))
        for snap, (S, stage) in zip(answer["snaps"], FOLDS_8B):
            self.assertAlmostEqual(snap["stage"], stage, delta=SIX_DIGITS)
            self.assertAlmostEqual(snap["length_before"], S, delta=10 * SIX_DIGITS)
            slope = (snap["force_after"] - snap["force_before"]) / (snap["deflection_after"] - snap["deflection_before"])
            self.assertAlmostEqual(slope, -30, delta=1e-9)  # rounding of the differences

    def test_identity_energy_closes(self):
        energy = self.json("simulate", SOURCE / "examples/simulated/truth.toml")["energy"]
        parts = sum(energy[name] for name in ("bending", "load_train", "friction", "snaps"))
        self.assertAlmostEqual(energy["stage_work"], parts, delta=1e-10 * energy["stage_work"])  # history.h

    def test_identity_physical_is_reduced_scaled(self):
        # A bending stiffness and a span that make the units 1 mm and 1 mN.
        physical = """[specimen]
bending_stiffness = "1 mN mm^2"
[rig]
span = "1 mm"
stiffness = "30 mN/mm"
[friction]
model = "sinusoid"
mu0 = 0.6
amplitude = 0.4
wavelength = "0.0628 mm"
drift = "-0.1 1/mm"
[stage]
program = ["0.1 mm", "0.7 mm"]
step = "0.01 mm"
"""
        reduced = "reduced = true\n" + physical.replace('"1 mN mm^2"', "1")
        for text in (" mN/mm", " 1/mm", " mm"):
            reduced = reduced.replace(text + '"', "")
        reduced = "\n".join(line.replace('"', "") if "model" not in line else line for line in reduced.splitlines())
        a = self.succeeds("simulate", self.file("physical.toml", physical))
        b = self.succeeds("simulate", self.file("reduced.toml", reduced))
        for title, unit in (("w_s [m]", 1e-3), ("w [m]", 1e-3), ("F [N]", 1e-3), ("S [m]", 1e-3)):
            for x, y in zip(numbers(a, title), numbers(b, title.split()[0])):
                self.assertAlmostEqual(x / unit, y, delta=1e-12)  # rounding of the scales, times the condition of a step
        self.assertEqual(table(a)["motion"], table(b)["motion"])

    def test_every_step_is_a_row(self):
        case = self.file("case.toml", FIG_8B.replace('"continuous"', "0.02"))
        self.assertEqual(numbers(self.succeeds("simulate", case), "w_s"),
                         [0.02 * n for n in range(38)] + [0.76])

    def test_noise_has_its_deviation_and_its_seed(self):
        truth = SOURCE / "examples/simulated/truth.toml"
        plain = numbers(self.succeeds("simulate", truth), "F [N]")
        noisy = self.succeeds("simulate", truth, "--noise", "10 uN", "--seed", "5")
        errors = [a - b for a, b in zip(numbers(noisy, "F [N]"), plain)]
        deviation = math.sqrt(sum(e * e for e in errors) / len(errors))
        self.assertAlmostEqual(deviation, 10e-6, delta=4 * 10e-6 / math.sqrt(2 * len(errors)))  # four standard errors
        self.assertEqual(noisy, self.succeeds("simulate", truth, "--noise", "10 uN", "--seed", "5"))
        self.assertNotEqual(noisy, self.succeeds("simulate", truth, "--noise", "10 uN", "--seed", "6"))
        for w_s, w, F in zip(*(numbers(noisy, title) for title in ("w_s [m]", "w [m]", "F [N]"))):
            self.assertAlmostEqual(w_s - w, F / 90.65, delta=1e-15)  # rounding of the state at w_s = 1e-3 m

    def test_a_path_too_long_for_memory_is_refused_in_advance(self):
        fine = """[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.3
wavelength = "1 nm"
[stage]
program = ["0 um", "0.7 mm"]
"""
        fine = fine.replace('stiffness = "90.65 N/m"', 'stiffness = "90.65 N/m"\nfriction_at = "axis"')
        self.refused("simulate", self.file("fine.toml", fine), says=["stage", "step", "--points"])
        far = fine.replace("sinusoid", "constant").replace('amplitude = 0.3\nwavelength = "1 nm"\n', "").replace("0.7 mm", "20 mm")
        result = run("simulate", self.file("far.toml", far))
        self.assertEqual(result.returncode, 1)
        self.assertIn("slips through the supports", result.stderr)

    def test_slipping_through_is_exit_code_1(self):
        case = self.file("case.toml", FRICTIONLESS + "[rig]\nstiffness = 30\n[stage]\nprogram = [0, 1]\nstep = 0.1\n")
        result = run("simulate", case)
        self.assertEqual(result.returncode, 1)
        self.assertIn("slips through the supports", result.stderr)
        self.assertLess(numbers(result.stdout, "w_s")[-1], 1)
        self.assertEqual(json.loads(run("simulate", case, "--json").stdout)["status"], "slipped_through")


class Reference(InFolder):
    """A fitted mu0 is that at a length in the middle of the data: pasted back with that length it is the same friction."""
    STATED = DRIFTING.format(mu0=0.3, more='reference = "1.4 mm"\n')
    AT_SPAN = DRIFTING.format(mu0=0.3 - 0.8 * (1.4 - 1.278), more="")

    def test_identity_every_command_that_takes_a_case(self):
        stated, at_span = self.file("stated.toml", self.STATED), self.file("at_span.toml", self.AT_SPAN)
        for command, titles in (("simulate", ("F [N]", "S [m]", "q")), ("equilibrium", ("F [N]", "mu"))):
            a, b = (self.succeeds(command, case) for case in (stated, at_span))
            for title in titles:
                for x, y in zip(numbers(a, title), numbers(b, title), strict=True):
                    self.assertAlmostEqual(x, y, delta=1e-11 * max(1e-3, abs(y)))  # rounding of mu0, no folds nearby
        a, b = (self.json("design", case) for case in (stated, at_span))
        self.assertAlmostEqual(a["work"] / b["work"], 1, delta=1e-11)
        # It matters: the same mu0 at the span is another friction.
        other = self.succeeds("simulate", self.file("other.toml", DRIFTING.format(mu0=0.3, more="")))
        self.assertGreater(numbers(other, "F [N]")[-1] / numbers(self.succeeds("simulate", stated), "F [N]")[-1], 1.05)

    def test_it_is_an_axis(self):
        rows = self.succeeds("design", self.file("case.toml", self.STATED), "--over", "reference=1.278 mm:1.4 mm:3")
        self.assertEqual(numbers(rows, "reference [m]")[-1], 1.4e-3)
        work = numbers(rows, "work [J]")
        self.assertEqual(work, sorted(work, reverse=True))
        self.assertAlmostEqual(work[-1] / self.json("design", self.folder / "case.toml")["work"], 1, delta=1e-14)

    def test_reduced_it_is_a_number_of_spans(self):
        text = 'reduced = true\n[friction]\nmodel = "constant"\nmu0 = {}\ndrift = 0.5\n{}'
        a = self.succeeds("equilibrium", self.file("a.toml", text.format(0.3, "reference = 1.2\n")))
        b = self.succeeds("equilibrium", self.file("b.toml", text.format(0.2, "")))
        for x, y in zip(numbers(a, "mu"), numbers(b, "mu"), strict=True):
            self.assertAlmostEqual(x, y, delta=4e-16)  # rounding of mu0


class Invert(InFolder):
    def test_oracle_the_simulated_friction_comes_back(self):
        truth = (SOURCE / "examples/simulated/truth.toml").read_text(encoding="utf-8")
        case = self.file("case.toml", truth + '[record]\nfile = "path.csv"\nstage = "w_s"\nforce = "F"\n')
        path = self.succeeds("simulate", case)
        self.file("path.csv", path)
        result = run("invert", case)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("uncertain by 3 %", result.stderr)
        self.assertEqual(run("invert", case, "--quiet").stderr, "")
        q = numbers(path, "q")
        S = numbers(path, "S [m]")
        mu = numbers(result.stdout, "mu")
        rows = [int(row) for row in numbers(result.stdout, "row")]
        self.assertGreater(len(rows), 350)
        for row, friction, length, drawn_in in zip(rows, mu, numbers(result.stdout, "S [m]"), numbers(result.stdout, "drawn_in [m]")):
            self.assertAlmostEqual(friction, q[row - 1], delta=1e-9)  # rounding of w_s - F/k, times up to 1e5 at w = 0.02
            self.assertAlmostEqual(length, S[row - 1], delta=1e-12)
            self.assertAlmostEqual(drawn_in, length - 1278e-6, delta=1e-15)

    def test_errors_have_their_parts(self):
        profile = self.json("invert", SOURCE / "examples/simulated/case.toml")
        self.assertEqual(profile["units"]["length"], "m")
        self.assertEqual(profile["bending_stiffness"]["source"], "stated")
        self.assertAlmostEqual(profile["bending_stiffness"]["relative_error"], math.hypot(0.03, 4 * 0.001), delta=1e-9)
        self.assertAlmostEqual(profile["force_noise"], 10e-6, delta=5e-6)  # where a dense sawtooth leaves no tenth quiet, too much
        for point in profile["profile"]:
            self.assertLess(point["mu_error_force"], point["mu_error"])

    def test_contact_is_found_where_the_record_begins_before_it(self):
        source = (SOURCE / "examples/simulated/test.csv").read_text(encoding="utf-8").splitlines()
        rows = [tuple(map(float, line.split(","))) for line in source[3:]]
        free = [f"{2 * n},{0.01 * (-1) ** n}" for n in range(20)]  # 40 um of travel without contact
        later = [f"{stage + 40:.3f},{force:.4f}" for stage, force in rows[1:]]
        self.file("test.csv", "\n".join([source[2], *free, *later]) + "\n")
        case = self.file("case.toml", (SOURCE / "examples/simulated/case.toml").read_text(encoding="utf-8"))
        answer = self.json("invert", case)
        # The curve bends: the straight line through its beginning meets zero a few micrometres beside it (record.h).
        self.assertAlmostEqual(answer["contact_offset"], 40e-6, delta=6e-6)
        case.write_text(case.read_text(encoding="utf-8") + 'contact = "40 um"\n', encoding="utf-8")
        self.assertEqual(self.json("invert", case)["contact_offset"], 40e-6)

    def test_two_columns_of_three_will_do(self):
        truth = (SOURCE / "examples/simulated/truth.toml").read_text(encoding="utf-8")
        self.file("path.csv", self.succeeds("simulate", SOURCE / "examples/simulated/truth.toml"))
        answers = []
        for a, b in (("stage", "force"), ("stage", "deflection"), ("deflection", "force")):
            columns = {"stage": "w_s", "deflection": "w", "force": "F"}
            case = self.file("case.toml", truth + f'[record]\nfile = "path.csv"\n{a} = "{columns[a]}"\n{b} = "{columns[b]}"\n')
            answers.append(numbers(run("invert", case).stdout, "mu"))
        for other in answers[1:]:
            for x, y in zip(answers[0], other):
                self.assertAlmostEqual(x, y, delta=1e-9)  # as above


class Program(InFolder):
    def test_output_goes_to_a_file(self):
        path = self.folder / "out.csv"
        self.assertEqual(self.succeeds("state", "--S", "1.2", "--q", "0.3", "--output", path), "")
        self.assertEqual(path.read_text(encoding="utf-8"), self.succeeds("state", "--S", "1.2", "--q", "0.3"))

    def test_case_on_standard_input(self):
        self.assertIn("snaps", json.loads(self.succeeds("simulate", "-", "--json", stdin=FIG_8B)))

    def test_version_and_help(self):
        version = re.search(r"project\(FlexSlip\s+VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
        self.assertRegex(self.succeeds("--version"), rf"^flexslip {re.escape(version)}( \([0-9a-f]+ of [0-9]{{4}}-[0-9]{{2}}-[0-9]{{2}}\))?\n$")
        self.assertIn(f"\nversion: {version}\n", (SOURCE / "CITATION.cff").read_text(encoding="utf-8"))
        text = self.succeeds("--help")
        for command in ("fit", "campaign", "read", "modulus", "invert", "simulate", "equilibrium", "state", "completions"):
            self.assertIn(f"\n  {command} ", text)
            self.assertIn("Examples:\n  ", self.succeeds(command, "--help"))
            self.assertEqual(self.succeeds("help", command), self.succeeds(command, "--help"))
        self.assertEqual(self.succeeds("help"), text)
        self.refused("help", "fot", says=["Did you mean 'fit'?"])

    def test_short_help_shows_the_options_that_people_use(self):
        for command, few in ("fit", 12), ("modulus", 12):
            short, whole = self.succeeds(command, "-h"), self.succeeds(command, "--help")
            options = [re.findall(r"^  (?:-\w,)?(--?[\w-]+)", text, re.MULTILINE) for text in (short, whole)]
            self.assertLessEqual(len(options[0]), few, options[0])
            self.assertLess(set(options[0]) - {"-h"}, set(options[1]))
            self.assertIn("Examples:\n  ", short)
            self.assertIn(f"flexslip {command} --help explains all options", short)
        for command in ("", "keys", "help"):
            self.assertIn("--help explains more", self.succeeds(*filter(None, [command]), "-h"))

    def test_a_reader_that_has_seen_enough_is_no_error(self):
        command = f"'{PROGRAM}' equilibrium '{SOURCE}/examples/simulated/truth.toml' --points 100000 | head -n 1"
        result = subprocess.run(["bash", "-c", f"set -o pipefail; {command}"], capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "S [m],mu,w [m],F [N],drawn_in [m]\n", ""))

    def test_the_same_input_gives_the_same_bytes(self):
        truth = SOURCE / "examples/simulated/truth.toml"
        self.assertEqual(self.succeeds("simulate", truth, "--json"), self.succeeds("simulate", truth, "--json"))


class DecimalComma(InFolder):
    """Written CSV has the same cells with a decimal comma and semicolons, of every command."""

    def same(self, plain, comma):
        with_points = [[cell.replace(",", ".") for cell in row] for row in csv.reader(comma.splitlines(), delimiter=";") if not row[0].startswith("#")]
        rows = [[cell.replace(",", ".") for cell in row] for row in csv.reader(plain.splitlines()) if not row[0].startswith("#")]
        self.assertEqual(with_points, rows)
        self.assertGreater(len(rows), 1)
        self.assertRegex(comma, r"(?m)[\d,]+;")

    def test_of_every_command_that_writes_one(self):
        wavy, case = self.file("wavy.toml", WAVY), SOURCE / "examples/simulated/case.toml"
        for call in (["simulate", wavy], ["equilibrium", wavy], ["invert", case], ["state", "--S", "1.01", "--q", "0.5"], ["read", SOURCE / "examples/simulated/test.csv", "-o", "-"],
                     ["design", wavy, "--over", "mu0=0:1:3", "--over", "stiffness=10 N/m:1000 N/m:3"], ["sweep", wavy, "--set", 'sweep.method="grid"', "--set", "sweep.axes.mu0=[0.3,0.5]"]):
            with self.subTest(call[0]):
                self.same(run(*call, "--quiet").stdout, run(*call, "--quiet", "--csv-decimal", ",").stdout)
        files = {name: [self.folder / f"{name}-{mark}.csv" for mark in ("point", "comma")] for name in ("profile", "curves", "draws")}
        for i, mark in enumerate(".,"):
            run("fit", case, "--csv-decimal", mark, *(words for name, paths in files.items() for words in (f"--{name}", paths[i])))
            run("campaign", SOURCE / "examples", "--no-figures", "--report", self.folder / f"report-{i}", "--csv-decimal", mark)
        for name in ("tests", "categories", "tests/simulated/curves", "tests/simulated/profile"):
            files[name] = [self.folder / f"report-{i}/{name}.csv" for i in (0, 1)]
        for name, paths in files.items():
            with self.subTest(name):
                self.same(*(path.read_text(encoding="utf-8") for path in paths))
        self.refused("simulate", wavy, "--csv-decimal", ";", says=["--csv-decimal"])

    def test_it_is_read_again_as_it_was_written(self):
        for mark in ".,":
            plain = self.succeeds("read", SOURCE / "examples/simulated/test.csv", "-o", "-", "--quiet", "--csv-decimal", mark)
            again = self.succeeds("read", self.file("again.csv", plain), "-o", "-", "--quiet")
            self.assertEqual(again, self.succeeds("read", SOURCE / "examples/simulated/test.csv", "-o", "-", "--quiet"))


class Changes(InFolder):
    """--set in each command that takes a case: as the case would say it."""

    def test_identity_a_change_says_what_the_file_would(self):
        case, other = self.file("case.toml", WAVY), self.file("other.toml", WAVY.replace('"90 N/m"', '"200 N/m"').replace("mu0 = 0.4", "mu0 = 0.3"))
        changes = "--set", "rig.stiffness=200 N/m", "--set", "friction.mu0=0.3"
        for command in "simulate", "equilibrium", "design":
            with self.subTest(command):
                self.assertEqual(self.succeeds(command, case, *changes), self.succeeds(command, other))
        example = SOURCE / "examples" / "simulated" / "case.toml"
        for command in "fit", "modulus", "invert":
            with self.subTest(command):
                self.assertNotEqual(self.succeeds(command, example, "--set", "specimen.diameter=36 um", "--quiet"), self.succeeds(command, example, "--quiet"))
        sweep = '[sweep]\nmethod = "grid"\n[sweep.axes]\nmu0 = [0.3, 0.4]\n'
        for file in case, other:
            self.file(file.name, file.read_text(encoding="utf-8") + sweep)
        self.assertEqual(self.succeeds("sweep", case, *changes, "--quiet"), self.succeeds("sweep", other, "--quiet"))
        tests = self.json("campaign", SOURCE / "examples", "--set", "specimen.diameter=35 um", "--quiet")["tests"]
        self.assertEqual(len(tests), 4)

    def test_bad_changes(self):
        case = self.file("case.toml", WAVY)
        self.refused("simulate", case, "--set", "rig.stifness=90 N/m", says=["--set", "Did you mean 'rig.stiffness'?"])
        self.refused("simulate", case, "--set", "rig.stiffness=90 mm", says=["--set: rig.stiffness", "'90 mm' is a length, not a stiffness"])

    def test_the_pages_tell_keys_and_results_as_the_program_does(self):
        subprocess.run([SOURCE / "tools" / "write-reference", PROGRAM, "--check"], check=True)


if __name__ == "__main__":
    unittest.main()
