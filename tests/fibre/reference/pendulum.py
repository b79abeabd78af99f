"""The elastica as a pendulum, integrated by Taylor series in fixed-point integers.

No elliptic function is used: this is the independent route behind the tables of this folder.
In phase tau the angle beta between fibre and force line obeys beta'' = -sin beta,
beta(0) = beta0, beta'(0) = 0 at the support; midspan lies at tau = u.
"""
from operator import mul

from mpmath import mp, mpf

BITS = 512            # fixed point: absolute error about 1e-150
mp.prec = BITS + 32
ONE = 1 << BITS
STEP_SHIFT = 2        # steps of 1/4; the nearest singularity is at least pi/2 away, so 2.6 bits a term
STEP = mpf(1) / (1 << STEP_SHIFT)


def to_fixed(x):
    return int(mp.floor(mp.ldexp(x, BITS)))


def to_mpf(i):
    return mp.ldexp(mpf(i), -BITS)


def product(a, b, n):
    """Coefficient n of the product of two series."""
    return sum(map(mul, a[:n + 1], b[n::-1])) >> BITS


def primitive(series, start):
    """Integral over a step of a series in t = (tau - tau_i)/STEP."""
    return [start] + [(c >> STEP_SHIFT) // (n + 1) for n, c in enumerate(series)]


def value(series, t):
    total = 0
    for c in reversed(series):
        total = c + (total * t >> BITS)
    return total


def grow(fields, rates):
    """Taylor series over one step. `fields` are one-term series; rates(n) are the coefficients n of the derivatives."""
    quiet, n = 0, 0
    while quiet < 4:   # parity makes every other term vanish on the first step
        terms = [(r >> STEP_SHIFT) // (n + 1) for r in rates(n)]
        for f, t in zip(fields, terms):
            f.append(t)
        quiet = quiet + 1 if max(map(abs, terms)) < 4 else 0
        n += 1


class Pendulum:
    """All the solutions with one beta0, extended step by step as far as they are asked for."""

    def __init__(self, beta0=None, q=None):
        if q is not None:   # cot beta0 = -q
            r = mp.sqrt(1 + mpf(q) ** 2)
            self.cos0, self.sin0 = -mpf(q) / r, 1 / r
        else:
            self.cos0, self.sin0 = mp.cos(beta0), mp.sin(beta0)
        self.steps = []
        self.front = [to_fixed(self.cos0), to_fixed(self.sin0), 0, 0, 0, 0]

    def extend(self):
        c0, s0, p0, x0, turn0, v0 = self.front
        c, s, p = [c0], [s0], [p0]
        grow([c, s, p], lambda n: (-product(s, p, n), product(c, p, n), -s[n]))
        pp = [product(p, p, n) for n in range(len(p))]
        series = [c, s, p, primitive(c, x0), primitive([-a for a in p], turn0), primitive(pp, v0)]
        self.steps.append(series)
        self.front = [sum(a) for a in series]   # t = 1

    def at(self, u):
        """cos beta, sin beta, beta', int cos beta, beta0 - beta, int beta'^2 at tau = u."""
        i = int(mp.floor(u / STEP))
        while len(self.steps) <= i:
            self.extend()
        t = to_fixed(u / STEP - i)
        return [to_mpf(value(a, t)) for a in self.steps[i]]

    def state(self, u):
        """(S, w, F, theta0, Pn, U) with midspan at tau = u > 0; S is negative beyond its pole."""
        c, s, p, C, turn, V = self.at(u)
        D = -p                       # int sin beta = -beta'
        X = c * C + s * D            # int cos(beta - b) = half span, in units of phase
        Y = c * D - s * C            # int sin(beta - b) = deflection
        # lengths in units of L = 2X; force along the line = phase^2; energy = 1/2 int kappa^2 over both halves
        return u / X, Y / (2 * X), 8 * X * X * s, turn, 4 * X * X * self.sin0, 2 * X * V

    def phase(self, S):
        """u at which the length is S: the first crossing, S(u) rising from 1."""
        excess = lambda u: self.half_span(u)[0] * S - u    # positive below the root
        i = 1
        while excess(i * STEP) > 0:
            i += 1
        lo, hi = (i - 1) * STEP, i * STEP
        for _ in range(30):
            mid = (lo + hi) / 2
            lo, hi = (mid, hi) if excess(mid) > 0 else (lo, mid)
        u = (lo + hi) / 2
        for _ in range(60):
            X, dX = self.half_span(u)
            du = (X * S - u) / (1 - dX * S)
            u += du
            if abs(du) < abs(u) * mpf(10) ** -125:
                return u
        raise ArithmeticError("no convergence at S = " + mp.nstr(S, 20))

    def half_span(self, u):
        c, s, p, C, _, _ = self.at(u)
        return c * C - s * p, 1 + p * (-c * p - s * C)

    def end(self):
        """u at which beta = 0 at midspan, so F = 0: the end of the branch."""
        i = 1
        while self.at(i * STEP)[1] > 0:
            i += 1
        u = (i - mpf(1) / 2) * STEP
        for _ in range(60):
            c, s, p = self.at(u)[:3]
            du = -s / (c * p)
            u += du
            if abs(du) < mpf(10) ** -125:
                return u
        raise ArithmeticError("no end found")


NUDGE = [mpf(10) ** -40, mpf(10) ** -42]   # step sizes of the central differences: truncation below 1e-60 throughout


class Fibre:
    """States at one q, with derivatives by S and q."""

    def __init__(self, q):
        self.q = mpf(q)
        self.beta0 = mp.acot(-self.q) if self.q < 0 else mp.pi - mp.acot(self.q) if self.q > 0 else mp.pi / 2
        self.middle = Pendulum(q=q)
        self.sides = [(Pendulum(beta0=self.beta0 - h), Pendulum(beta0=self.beta0 + h)) for h in NUDGE]

    def derivatives(self, u, which):
        """Rows (d/dS, d/dq) of (w, F, theta0, Pn, U), by central differences with step size `which`."""
        h = NUDGE[which]
        below, above = self.sides[which]
        by_u = [(a - b) / (2 * h * u) for a, b in zip(self.middle.state(u * (1 + h)), self.middle.state(u * (1 - h)))]
        by_beta = [(a - b) / (2 * h) for a, b in zip(above.state(u), below.state(u))]
        sin2 = self.middle.sin0 ** 2      # d beta0 / dq
        return [(fu / by_u[0], sin2 * (fb - fu * by_beta[0] / by_u[0])) for fu, fb in zip(by_u[1:], by_beta[1:])]
