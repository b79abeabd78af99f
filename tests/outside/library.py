#!/usr/bin/python3
"""outside: the installed package, as another project finds and uses it."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, SOURCE, InFolder


HEADERS = sorted((SOURCE / "include" / "flexslip").glob("*"))


class Library(InFolder):
    def test_each_header_needs_nothing_before_it_and_no_other_folder(self):
        for header in HEADERS:  # whose number and includes tools/check-layers holds
            alone = self.folder / "alone.cpp"
            alone.write_text(f'#include "flexslip/{header.name}"\n', encoding="utf-8")
            subprocess.run(["c++", "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I", SOURCE / "include", alone], check=True)

    def test_the_example_builds_against_the_installed_package_and_tells_the_truth(self):
        build = pathlib.Path(PROGRAM).resolve().parent
        installed = self.folder / "installed"
        subprocess.run(["cmake", "--install", build, "--prefix", installed], check=True, capture_output=True)
        self.assertTrue((installed / "bin" / "flexslip").is_file())
        self.assertEqual(sorted(path.name for path in (installed / "include" / "flexslip").iterdir()), [header.name for header in HEADERS])
        for generator in ["Ninja", *(["Unix Makefiles"] if shutil.which("make") else [])]:
            with self.subTest(generator):
                self.example_tells_the_truth(installed, generator)

    def example_tells_the_truth(self, installed, generator):
        folder = self.folder / generator
        shutil.copytree(SOURCE / "examples" / "library", folder)
        subprocess.run(["cmake", "-B", folder / "build", "-S", folder, f"-DCMAKE_PREFIX_PATH={installed}", "-DCMAKE_BUILD_TYPE=Release", "-G", generator],
                       check=True, capture_output=True)
        subprocess.run(["cmake", "--build", folder / "build"], check=True, capture_output=True)
        said = subprocess.run([folder / "build" / "bend"], check=True, capture_output=True, text=True).stdout
        mu0, error = map(float, re.search(r"mu0 = ([\d.]+) \+- ([\d.]+)", said).groups())
        self.assertLess(abs(mu0 - 0.5), 4 * error, said)
        self.assertAlmostEqual(float(re.search(r"every ([\d.]+) um", said).group(1)), 10.9, delta=0.1)
        self.assertGreater(int(re.search(r"snaps: (\d+)", said).group(1)), 10)


if __name__ == "__main__":
    if os.environ.get("FLEXSLIP_CONFIG") not in (None, "Release"):
        sys.exit(77)
    unittest.main()
