#!/usr/bin/python3
"""outside: Ctrl-C ends each long call where it is, not when it is done. Counted in the processor's time, which nobody else's work changes."""
import os
import signal
import time
import unittest

import flexslip
from package import SOURCE

os.chdir(SOURCE)
DESIGN = "examples/design.toml"
CALLS = {
    "fit": lambda: flexslip.fit("examples/simulated/case.toml"),
    "fit of loops": lambda: flexslip.fit("examples/cyclic/case.toml"),
    "campaign": lambda: flexslip.campaign("examples", jobs=1),
    "design": lambda: flexslip.design(DESIGN),
    "designs over a parameter": lambda: flexslip.design(DESIGN, over={"stiffness": ("10 N/m", "1000 N/m", 2000)}, threads=1),
    "sweep": lambda: flexslip.sweep(DESIGN, axes={"mu0": (0.1, 0.9, 4000)}, threads=1),
    "simulate": lambda: flexslip.simulate(DESIGN, set={"stage.step": "0.004 um"}),
    "equilibrium": lambda: flexslip.equilibrium(DESIGN, points=1_000_000),
    "region": lambda: flexslip.equilibrium_region(DESIGN, points=3000, levels=500),
}


class Interrupted(unittest.TestCase):
    def setUp(self):
        before = signal.signal(signal.SIGPROF, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGPROF, before)

    def test_outside_each_long_call_ends_where_it_is(self):
        for name, call in CALLS.items():
            with self.subTest(name):
                call()  # fills the tables that later calls find
                begun = time.process_time()
                call()
                whole = time.process_time() - begun
                self.assertGreater(whole, 0.1, "too short to be interrupted: make it longer")  # the timer counts in steps of 4 ms
                signal.setitimer(signal.ITIMER_PROF, whole / 4)
                begun = time.process_time()
                with self.assertRaises(KeyboardInterrupt):
                    call()
                taken = time.process_time() - begun
                self.assertLess(taken, 0.75 * whole, f"of {whole:.2f} s")

    def test_outside_what_was_interrupted_is_computed_as_ever_afterwards(self):
        usual = flexslip.fit("examples/simulated/case.toml")
        signal.setitimer(signal.ITIMER_PROF, 0.1)
        self.assertRaises(KeyboardInterrupt, CALLS["fit"])
        self.assertEqual(flexslip.fit("examples/simulated/case.toml"), usual)


if __name__ == "__main__":
    unittest.main()
