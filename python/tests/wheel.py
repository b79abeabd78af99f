#!/usr/bin/python3
"""outside: the wheel installs with pip and is imported from where it lies; the source holds all that is needed, and configures."""
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import unittest
import zipfile

import flexslip
from package import SOURCE

BUILD = pathlib.Path(flexslip.__file__).parent.parent.parent


def run(*arguments, **options):
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, check=False, **options)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.folder = pathlib.Path(kept.name)
        made = run(sys.executable, SOURCE / "tools/build-wheel", cls.folder, "--build", BUILD)
        assert made.returncode == 0, made.stdout + made.stderr
        cls.source, cls.wheel = map(pathlib.Path, made.stdout.split())

    def test_outside_pip_installs_it_and_it_computes(self):
        if run(sys.executable, "-m", "pip", "--version").returncode:
            self.skipTest("there is no pip")
        place = self.folder / "place"
        installed = run(sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--target", place, self.wheel)
        self.assertEqual(installed.returncode, 0, installed.stdout + installed.stderr)
        program = 'import flexslip, importlib.metadata as m; print(flexslip.__file__, m.version("flexslip"), flexslip.fit("examples/simulated/case.toml").success)'
        told = run(sys.executable, "-c", program, env={**os.environ, "PYTHONPATH": str(place)}, cwd=SOURCE)
        self.assertEqual(told.stdout.split(), [str(place / "flexslip/__init__.py"), flexslip.__version__, "True"], told.stderr)

    def test_outside_it_has_every_module_its_types_and_what_pyproject_says(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            self.assertIsNone(wheel.testzip())
            names = set(wheel.namelist())
            for path in pathlib.Path(flexslip.__file__).parent.iterdir():
                if path.suffix in (".py", ".pyi", ".typed"):
                    self.assertIn(f"flexslip/{path.name}", names)
            told = wheel.read(f"flexslip-{flexslip.__version__}.dist-info/METADATA").decode()
        project = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        self.assertIn(f"Summary: {project['description']}\n", told)
        self.assertIn(f"\nVersion: {flexslip.__version__}\n", told)

    def test_outside_source_is_complete_and_configures(self):
        with tarfile.open(self.source) as tar:
            tar.extractall(self.folder / "source")
        (root,) = (self.folder / "source").iterdir()
        for folder in "src", "include", "python", "cmake", "examples", "tests", "tools", "docs":
            ours = {path.relative_to(SOURCE) for path in (SOURCE / folder).rglob("*") if path.is_file() and not path.suffix == ".pyc" and not any(part.startswith(".") for part in path.parts)}
            theirs = {path.relative_to(root) for path in (root / folder).rglob("*") if path.is_file()}
            self.assertEqual(ours - theirs, set())
        defined = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["scikit-build"]["cmake"]["define"]
        configured = run("cmake", "-S", root, "-B", root / "build", "-G", "Ninja", *(f"-D{name}={value}" for name, value in defined.items()))
        self.assertEqual(configured.returncode, 0, configured.stdout + configured.stderr)
        self.assertIn("python_package", run("ninja", "-C", root / "build", "-t", "targets", "all").stdout)

    def test_outside_same_source_gives_same_bytes(self):
        again = self.folder / "again"
        run(sys.executable, SOURCE / "tools/build-wheel", again, "--build", BUILD)
        for path in self.source, self.wheel:
            self.assertEqual((again / path.name).read_bytes(), path.read_bytes(), path.name)


if __name__ == "__main__":
    unittest.main()
