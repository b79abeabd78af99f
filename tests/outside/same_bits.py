#!/usr/bin/python3
"""A fit, and a test on the friction of a surface, has the same bytes whichever variants of its functions the C library chooses for the processor."""
import os
import pathlib
import platform
import subprocess
import sys
import unittest

PROGRAM = os.environ["FLEXSLIP"]
SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
# glibc takes the variants without fused products where the processor lacks these, or seems to.
PLAIN = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F"


def output(tunables, *arguments):
    return subprocess.run([PROGRAM, *arguments], env={**os.environ, "GLIBC_TUNABLES": tunables}, check=True, capture_output=True).stdout


class SameBits(unittest.TestCase):
    def test_identity_a_fit_on_a_lesser_processor(self):
        for example in "simulated", "cracked", "cyclic":
            with self.subTest(example):
                case = str(SOURCE / "examples" / example / "case.toml")
                self.assertEqual(output("", "fit", case, "--json", "--quiet"), output(PLAIN, "fit", case, "--json", "--quiet"))

    def test_identity_a_surface_on_a_lesser_processor(self):
        call = ["simulate", str(SOURCE / "examples/surface/truth.toml"), "--json", "--quiet"]
        self.assertEqual(output("", *call), output(PLAIN, *call))


if __name__ == "__main__":
    if platform.machine() != "x86_64":
        print("skipped: the C library of this processor has one variant of its functions")
        sys.exit(77)
    unittest.main()
