#!/usr/bin/python3
"""oracle: the elastica in Python against 40 digits by Taylor series (tests/fibre/reference), and as NumPy's own functions behave."""
import csv
import os
import threading
import unittest
from fractions import Fraction

import numpy as np

import flexslip
from package import SOURCE

os.chdir(SOURCE)
EPSILON = 2.0**-52


def reference():
    with open("tests/fibre/reference/states.csv", encoding="utf-8", newline="") as file:
        return [row for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def relative(found, exact):
    """Of a double to a decimal of 40 digits, without rounding the latter."""
    truth = Fraction(exact)
    return abs(float((Fraction(float(found)) - truth) / truth)) if truth else abs(float(found))


class Values(unittest.TestCase):
    def test_oracle_every_state_of_the_reference_is_as_near_as_the_header_promises(self):
        rows = [row for row in reference() if float(row["S"]) > 1]
        S, q = (np.array([float.fromhex(row[name]) for row in rows]) for name in ("S_hex", "q_hex"))
        w, F = flexslip.elastica(S, q)
        details = flexslip.elastica_details(S, q)
        self.assertGreater(len(rows), 600)
        for i, row in enumerate(rows):
            force = float(row["F"])
            condition = 1 + abs((S[i] - 1) * float(row["dF_dS"]) / force) + abs(q[i] * float(row["dF_dq"]) / force)
            self.assertLessEqual(relative(w[i], row["w"]), 3e-15, row)  # elastica.h
            self.assertLessEqual(relative(F[i], row["F"]), 8e-15 * condition, row)
            self.assertLessEqual(relative(details.theta0[i], row["theta0"]), 4e-15, row)
            self.assertLessEqual(relative(details.Pn[i], row["Pn"]), 3e-15, row)
            self.assertLessEqual(relative(details.U[i], row["U"]), 8e-15, row)

    def test_oracle_inverse_gives_the_state_back(self):
        S, q = np.meshgrid(np.linspace(1.05, 1.9, 40), np.linspace(-0.5, 0.9, 40))
        w, F = flexslip.elastica(S, q)
        there = np.isfinite(F) & (F > 0.1)
        back = flexslip.elastica_inverse(w[there], F[there])
        again = flexslip.elastica(back.S, back.q)
        np.testing.assert_allclose(again.w, w[there], rtol=64 * EPSILON)  # as batch_inverse.h promises: 32 S ulp
        np.testing.assert_allclose(again.F, F[there], rtol=1e-12)         # times its condition number, below 100 here

    def test_identity_slopes_are_central_differences(self):
        S, q, h = np.linspace(1.1, 1.8, 15), 0.3, 1e-6
        slopes = flexslip.elastica_slopes(S, q)
        # Truncation of order h², rounding of order EPSILON/h: 1e-9 of values of order 1 to 100.
        for name, (up, down) in {"S": (flexslip.elastica(S + h, q), flexslip.elastica(S - h, q)),
                                 "q": (flexslip.elastica(S, q + h), flexslip.elastica(S, q - h))}.items():
            for of in "wF":
                np.testing.assert_allclose(getattr(slopes, f"{of}_{name}"), (getattr(up, of) - getattr(down, of)) / (2 * h), rtol=1e-7)


class Universal(unittest.TestCase):
    """As NumPy's functions: broadcasting, strides, out, types, subclasses. The oracle is the loop over single states."""

    def setUp(self):
        random = np.random.default_rng(20211829)
        self.S, self.q = random.uniform(1, 2, 5000), random.uniform(-0.5, 1, 5000)
        self.w, self.F = flexslip.elastica(self.S, self.q)

    def test_identity_arrays_have_the_bits_of_single_states(self):
        for i in range(0, 5000, 41):
            w, F = flexslip.elastica(self.S[i], self.q[i])
            self.assertTrue(np.array_equal([w, F], [self.w[i], self.F[i]], equal_nan=True))

    def test_identity_strides_order_and_bytes_change_nothing(self):
        swapped = self.S.astype(self.S.dtype.newbyteorder())
        wide = np.zeros((5000, 3))
        wide[:, 1] = self.S
        for S, q, w in ((self.S[::-1], self.q[::-1], self.w[::-1]), (self.S[::7], self.q[::7], self.w[::7]), (swapped, self.q, self.w),
                        (wide[:, 1], self.q, self.w), (self.S.reshape(50, 100, order="F"), self.q.reshape(50, 100, order="F"), self.w.reshape(50, 100, order="F"))):
            np.testing.assert_array_equal(flexslip.elastica(S, q).w, w)
        unaligned = np.frombuffer(b"x" + self.S.tobytes(), dtype=np.uint8)[1:].view(np.float64)
        np.testing.assert_array_equal(flexslip.elastica(unaligned, self.q).w, self.w)

    def test_identity_broadcasts(self):
        w, F = flexslip.elastica(self.S[:30, None], self.q[:20])
        self.assertEqual(w.shape, (30, 20))
        for i, j in ((0, 0), (29, 19), (7, 3)):
            np.testing.assert_array_equal((w[i, j], F[i, j]), flexslip.elastica(self.S[i], self.q[j]))
        self.assertEqual(flexslip.elastica(np.ones((0, 3)), 0.5).w.shape, (0, 3))
        self.assertEqual(np.shape(flexslip.elastica(1.2, 0.3).w), ())
        with self.assertRaises(ValueError):
            flexslip.elastica(np.ones(3), np.zeros(4))

    def test_identity_out_is_written_in_place(self):
        w, F = np.empty(5000), np.empty((5000, 2))
        given = flexslip.elastica(self.S, self.q, out=(w, F[:, 1]))
        self.assertIs(given.w, w)
        np.testing.assert_array_equal(w, self.w)
        np.testing.assert_array_equal(F[:, 1], self.F)
        both = self.S.copy()
        flexslip.elastica(both, self.q, out=(both, None))
        np.testing.assert_array_equal(both, self.w)
        for wrong in (w, (w,), (np.empty(3), w), (np.empty(5000, dtype=int), w)):
            with self.assertRaises((ValueError, TypeError)):
                flexslip.elastica(self.S, self.q, out=wrong)

    def test_identity_types_and_subclasses(self):
        single = self.S.astype(np.float32)
        np.testing.assert_array_equal(flexslip.elastica(single, 0.25).w, flexslip.elastica(single.astype(float), 0.25).w)
        self.assertEqual(flexslip.elastica(2, 1).w, flexslip.elastica(2.0, 1.0).w)
        import pandas
        index = pandas.Index(range(100, 110))
        series = flexslip.elastica(pandas.Series(self.S[:10], index), self.q[:10]).w
        self.assertTrue(series.index.equals(index))
        masked = flexslip.elastica(np.ma.array([1.2, np.nan], mask=[False, True]), 0.3).w
        self.assertTrue(masked.mask[1] and masked[0] == flexslip.elastica(1.2, 0.3).w)
        self.assertIsInstance(flexslip.elastica(np.matrix([1.1, 1.2]), 0.3).w, np.matrix)

    def test_identity_nan_gives_nan_and_changes_no_other_state(self):
        S, q = self.S[:40].copy(), self.q[:40].copy()
        S[3], q[17] = np.nan, np.nan
        unknown = np.isnan(S) | np.isnan(q)
        on_rollers = flexslip.elastica_on_rollers([0.1, np.nan, 0.1], 0.3, roller_radius=[0.05, 0.05, np.nan])
        self.assertEqual([np.isnan(each).tolist() for each in on_rollers], [[False, True, True]] * 9)
        with np.errstate(all="raise"):
            for function, inputs in ((flexslip.elastica, (self.S, self.q)), (flexslip.elastica_slopes, (self.S, self.q)), (flexslip.elastica_details, (self.S, self.q)),
                                     (flexslip.elastica_inverse, (self.w, self.F))):
                whole = function(*(np.where(np.isnan(each), 1, each)[:40] for each in inputs))
                holed = function(*(np.where(unknown, np.nan, np.where(np.isnan(each), 1, each)[:40]) for each in inputs))
                for one, other in zip(whole, holed):
                    np.testing.assert_array_equal(np.where(unknown, np.nan, one), other)
        out = np.empty(40), None
        self.assertIs(flexslip.elastica(S, q, out=out).w, out[0])
        np.testing.assert_array_equal(np.isnan(out[0]), unknown | np.isnan(self.w[:40]))
        self.assertTrue(np.isnan(flexslip.elastica(np.nan, 0.3).F))

    def test_identity_threads_share_the_work(self):
        answers = [None] * 4

        def work(k):
            answers[k] = flexslip.elastica(self.S, self.q).w

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for answer in answers:
            np.testing.assert_array_equal(answer, self.w)

    def test_identity_nothing_is_warned_of(self):
        with np.errstate(all="raise"):
            flexslip.elastica(self.S, self.q)
            flexslip.elastica_slopes(1.0, 0.0)
            flexslip.elastica_inverse(self.w[np.isfinite(self.w)], 1.0)


if __name__ == "__main__":
    unittest.main()
