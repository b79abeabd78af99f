#!/usr/bin/python3
"""outside: the types of the package are complete, and a user's own program is checked with them, by mypy."""
import ast
import graphlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import flexslip
from package import SOURCE

BUILT = pathlib.Path(flexslip.__file__).parent.parent
USER = """
import flexslip
import numpy as np

fit = flexslip.fit("test.csv", span="1278 um", stiffness=90.65, modulus=("29.6 GPa", "3 %"), rig={"roller_radius": 0})
mu: float = fit.params.mu0.value
low, high = fit.params.mu0.ci95
cracks: float | None = fit.judgement.cracks_alone
verdict: str = fit.verdict.sentence
mean: np.float64 = fit.profile.mu[0]
row: float = fit.profile[3].mu_error
w, F = flexslip.elastica([1.1, 1.2], 0.3)
try:
    test = flexslip.simulate(diameter="34.8 um", noise="10 uN", friction={"model": "constant", "mu0": 0.5})
    snaps: int = len(test.snaps)
    energy: float = test.energy.friction
except flexslip.InputError as error:
    print(error.key, error.limit)
over: flexslip.DesignMap = flexslip.design("case.toml", over={"mu0": (0, 1, 5)})
answer: str = flexslip.design("case.toml").answer
reload = flexslip.design("case.toml", decide=True, noise="10 uN").reload
suffices: bool = reload is not None and reload.least is not None
curve: flexslip.Equilibrium = flexslip.equilibrium("case.toml", longest="1 mm")
forces: np.float64 = curve.curve.force[0]
modulus = flexslip.modulus("test.csv", span="64 mm", window=(0.1, 0.3)).modulus
pascals: float = modulus.value
slope = flexslip.surface([0.0] * 100, "1 um", wavelength=["10 um"]).rms_slope
designs: int = len(flexslip.sweep("case.toml", axes={"mu0": [0.3, 0.5]}))
on_rollers = flexslip.elastica_on_rollers([0.1], 0.3, roller_radius=0.05)
for each in flexslip.campaign("tests").tests:
    print(each.name, each.category)
"""
WRONG = {  # and the code or words of what mypy says
    'flexslip.fit("test.csv", spam="1278 um")': "call-overload|call-arg",
    'flexslip.fit("test.csv").params.mu0.valeu': '"FitParametersMu0" has no attribute "valeu"',
    'flexslip.fit("test.csv", span=object())': "arg-type",
    'flexslip.elastica(1.1)': "call-arg",
    'flexslip.design("case.toml", over={"mu0": (0, 1)}).answer': "attr-defined",
}


def mypy(*arguments, folder):
    settings = pathlib.Path(folder) / "mypy.ini"
    settings.write_text("[mypy]\nstrict = True\nshow_error_codes = True\n[mypy-pandas.*,matplotlib.*,scipy.*,xlrd.*]\nignore_missing_imports = True\n")
    environment = {**os.environ, "MYPYPATH": str(BUILT)}
    environment.pop("PYTHONPATH", None)
    return subprocess.run([sys.executable, "-m", "mypy", "--config-file", settings, "--cache-dir", pathlib.Path(folder) / "cache", *arguments],
                          capture_output=True, text=True, check=False, env=environment, cwd=BUILT)


class Imports(unittest.TestCase):
    def test_identity_no_module_imports_one_that_imports_it(self):
        imports = {}
        for path in (SOURCE / "python/flexslip").glob("_[a-z]*.py"):
            parts = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.ImportFrom) and node.level]
            imports[path.stem] = {name for node in parts for name in ([node.module] if node.module else [each.name for each in node.names])}
        self.assertGreater(len(list(graphlib.TopologicalSorter(imports).static_order())), 15)  # which refuses a circle


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.folder = kept.name

    def test_outside_package_is_typed(self):
        checked = mypy("-p", "flexslip", folder=self.folder)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_outside_what_the_documentation_shows(self):
        program = pathlib.Path(self.folder) / "guide.py"
        blocks = re.findall(r"^```python\n(.*?)^```$", (SOURCE / "docs/scripting.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        told = {"fit.params.mu0": "FitParametersMu0", 'fit.params["wavelength"]': "Estimate", "fit.curves.force": "ndarray", "fit.draws.profiles": "ndarray",
                "fit.residual": "ndarray", "surface.density": "ndarray", "test.path.force": "ndarray", "standard.modulus": "Estimate"}
        program.write_text("\n".join([*blocks, *(f"reveal_type({each})" for each in told)]))
        checked = mypy(program, folder=self.folder)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        revealed = re.findall(r'Revealed type is "(.*)"', checked.stdout)
        self.assertEqual(len(revealed), len(told))
        for (expression, kind), found in zip(told.items(), revealed):
            self.assertRegex(found, rf"\b{kind}\b", expression)

    def test_outside_a_users_program(self):
        program = pathlib.Path(self.folder) / "user.py"
        program.write_text(USER)
        checked = mypy(program, folder=self.folder)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        program.write_text("import flexslip\n" + "\n".join(WRONG) + "\n")
        checked = mypy(program, folder=self.folder)
        for line, codes in enumerate(WRONG.values(), 2):
            found = [told for told in checked.stdout.splitlines() if f"user.py:{line}:" in told]
            self.assertTrue(any(code in told for told in found for code in codes.split("|")), (line, checked.stdout))


if __name__ == "__main__":
    unittest.main()
