#!/usr/bin/python3
"""The numbers of the paper and of the model: folds of Fig. 8B, force peaks, frictionless limits. Writes folds.csv."""
from pathlib import Path

from mpmath import mp, mpf
from pendulum import Fibre

DIGITS = 30


def state(S, q):
    """w, F, and their derivatives by S and q."""
    fibre = Fibre(q)
    u = fibre.middle.phase(S)
    w, F = fibre.middle.state(u)[1:3]
    (w_S, w_q), (F_S, F_q) = fibre.derivatives(u, 1)[:2]
    return w, F, w_S, w_q, F_S, F_q


def friction(S):
    """mu and dmu/dS of Fig. 8B."""
    return mpf("0.6") * (1 + mpf("0.4") * mp.cos(50 * S)), -mpf("0.6") * mpf("0.4") * 50 * mp.sin(50 * S)


STIFFNESS = 30


def slope(S):
    """G'(S) along q = mu(S), G = k w + F."""
    mu, dmu = friction(S)
    w, F, w_S, w_q, F_S, F_q = state(S, mu)
    return STIFFNESS * (w_S + w_q * dmu) + F_S + F_q * dmu


def stage(S):
    w, F = state(S, friction(S)[0])[:2]
    return w + F / STIFFNESS, w, F


def root(f, lo, hi):
    return mp.findroot(f, (mpf(lo), mpf(hi)), solver="anderson", tol=mpf(10) ** -70, maxsteps=60)


def main():
    lines = ["# Made by folds.py: Taylor integration of the pendulum, roots to 40 digits.",
             "# Folds: mu = 0.6 (1 + 0.4 cos(S/0.02)), k = 30, w_s = w + F/k; peaks: dF/dS = 0 at constant q (decimals taken exactly).",
             "what,q,S,w_s,w,F"]

    def line(what, *values):
        lines.append(what + "," + ",".join("" if v is None else mp.nstr(v, DIGITS, strip_zeros=False) for v in values))
        print(lines[-1], flush=True)

    # every sign change of G' on a grid 60 times finer than a period of mu
    grid = [1 + mpf(i) / 500 for i in range(1, 251)]
    slopes = [slope(S) for S in grid]
    for a, b, ga, gb in zip(grid, grid[1:], slopes, slopes[1:]):
        if ga * gb < 0:
            S = root(slope, a, b)
            line("fold max" if ga > 0 else "fold min", friction(S)[0], S, *stage(S))
    for q, lo, hi in (("0", "1.1", "1.2"), ("0.3", "1.1", "1.4"), ("0.6", "1.1", "1.8"), ("1.0", "1.1", "2.5")):
        S = root(lambda s: state(s, mpf(q))[4], lo, hi)
        w, F = state(S, mpf(q))[:2]
        line("peak", mpf(q), S, None, w, F)
    fibre = Fibre(0).middle
    S, w, F = fibre.state(fibre.end())[:3]
    line("frictionless end", mpf(0), S, None, w, F)
    print("Gauss's constant", mp.nstr(1 / mp.agm(1, mp.sqrt(2)), DIGITS))
    (Path(__file__).parent / "folds.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
