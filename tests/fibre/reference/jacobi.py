"""Jacobi's functions and the integrals of the kernel, by Taylor series of their differential equations (pendulum.py)."""
from mpmath import mp, mpf
from pendulum import BITS, ONE, STEP, grow, primitive, product, to_fixed, to_mpf, value


class Jacobi:
    """All u at one m; m is a double."""

    def __init__(self, m):
        self.m, self.m1 = to_fixed(mpf(m)), to_fixed(1 - mpf(m))
        self.steps = []
        self.front = [0, ONE, ONE, 0, ONE, ONE, 0, 0, 0, 0]   # sn cn dn sd cd nd, E V P R

    def extend(self):
        m, m1 = self.m, self.m1
        sn, cn, dn, sd, cd, nd = fields = [[a] for a in self.front[:6]]
        times = lambda a, b: a * b >> BITS
        grow(fields, lambda n: (product(cn, dn, n), -product(sn, dn, n), -times(m, product(sn, cn, n)),
                                product(cd, nd, n), -times(m1, product(sd, nd, n)), times(m, product(sd, cd, n))))
        gap = [a - b for a, b in zip(nd, cd)]                      # (1 - cn)/dn
        mix = [times(m1, a) + times(m, b) for a, b in zip(nd, cd)]   # (m1 + m cn)/dn
        rates = [(dn, dn), (sd, sd), (gap, mix), (gap, gap)]
        integrals = [primitive([product(a, b, n) for n in range(len(a))], start)
                     for (a, b), start in zip(rates, self.front[6:])]
        self.steps.append(fields + integrals)
        self.front = [sum(a) for a in self.steps[-1]]

    def at(self, u):
        i = int(mp.floor(u / STEP))
        while len(self.steps) <= i:
            self.extend()
        t = to_fixed(u / STEP - i)
        return [to_mpf(value(a, t)) for a in self.steps[i]]

    def values(self, u):
        """sn, cn, dn, E, V, P, R at u."""
        sn, cn, dn, _, _, _, E, V, P, R = self.at(u)
        return [sn, cn, dn, E, V, P, R]

    def quarter_period(self):
        """K(m): the first zero of cn."""
        i = 1
        while self.at(i * STEP)[1] > 0:
            i += 1
        u = (i - mpf(1) / 2) * STEP
        for _ in range(14):
            sn, cn, dn = self.at(u)[:3]
            u += cn / (sn * dn)
        assert abs(cn) < mpf(10) ** -120
        return u
