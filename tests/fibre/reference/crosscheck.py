#!/usr/bin/python3
"""Compares the tables with the closed forms in elliptic functions (mpmath's, at 90 digits) and with plain quadrature.

Prints the largest relative difference of each column. About a minute.
"""
import csv
from pathlib import Path

from initialisers import initialisers
from mpmath import mp, mpf

mp.dps = 90
FOLDER = Path(__file__).parent


def read(name):
    with open(FOLDER / (name + ".csv")) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def double(row, name):
    return mpf(float.fromhex(row[name + "_hex"]))


def angle(q):
    return mp.atan2(1, -q)   # cot beta0 = -q


def closed(u, q):
    """Deflection and all else at phase u, by the closed forms of the theory."""
    beta0 = angle(q)
    k, k1 = mp.sin(beta0 / 2), mp.cos(beta0 / 2)
    m = k * k
    sn, cn, dn = (mp.ellipfun(f, u, m=m) for f in ("sn", "cn", "dn"))
    E = mp.ellipe(mp.atan2(sn, cn), m)
    b = 2 * mp.asin(k * cn / dn)
    C = (2 * E - u - 2 * m * sn * cn / dn) / (2 * u)
    D = 2 * k * k1 * sn / dn / (2 * u)
    Ic, Is = mp.cos(b) * C + mp.sin(b) * D, mp.cos(b) * D - mp.sin(b) * C
    S = 1 / (2 * Ic)
    return {"S": S, "w": S * Is, "F": 32 * u**2 * Ic**2 * mp.sin(b), "theta0": beta0 - b,
            "Pn": 4 * u**2 * mp.sin(beta0) / S**2, "U": 8 * u**2 / S * (C - mp.cos(beta0) / 2), "Ic": Ic}


def solve(S, q, near):
    return mp.findroot(lambda u: 2 * S * closed(u, q)["Ic"] - 1, (near, near * (1 + mpf(10) ** -20)),
                       tol=mpf(10) ** -170, verify=False)


def by_quadrature(b, q):
    """u, S, w, F at the midspan angle b of the table, by integrals over the angle: no elliptic function, no series."""
    beta0 = angle(q)
    k = mp.sin(beta0 / 2)
    top = mp.asin(mp.sin(b / 2) / k)              # sin(beta/2) = k sin(phi)
    dtau = lambda phi: 1 / mp.sqrt(1 - (k * mp.sin(phi)) ** 2)
    beta = lambda phi: 2 * mp.asin(k * mp.sin(phi))
    half = mp.pi / 2
    u = mp.quad(dtau, [top, half])
    X = mp.quad(lambda phi: mp.cos(beta(phi) - b) * dtau(phi), [top, half])
    Y = mp.quad(lambda phi: mp.sin(beta(phi) - b) * dtau(phi), [top, half])
    return {"u": u, "S": u / X, "w": Y / (2 * X), "F": 8 * X * X * mp.sin(b)}


class Worst(dict):
    def add(self, name, got, table):
        error = abs(got / table - 1) if table else abs(got)
        self[name] = max(self.get(name, mpf(0)), error)

    def report(self, title):
        print(title, {n: mp.nstr(e, 2) for n, e in self.items()}, flush=True)


def check_states():
    rows = [r for r in read("states") if not r["group"].startswith("limit")]
    closed_worst, quad_worst, diff_worst = Worst(), Worst(), Worst()
    for i, row in enumerate(rows):
        S, q, table_u = double(row, "S"), double(row, "q"), mpf(row["u"])
        u = solve(S, q, table_u)
        values = closed(u, q)
        closed_worst.add("S", values["S"], S)
        closed_worst.add("u", u, table_u)
        for name in ("w", "F", "theta0", "Pn", "U"):
            closed_worst.add(name, values[name], mpf(row[name]))
        if i % 40 == 0:
            for name, v in by_quadrature(angle(q) - values["theta0"], q).items():
                quad_worst.add(name, v, S if name == "S" else mpf(row[name]))
        if i % 30 == 0:   # the definition: re-solve at S +- h and q +- h, differences improved by Richardson
            h = mpf(10) ** -16
            for by, scale in (("S", S - 1), ("q", mpf(1) / 4)):
                def shifted(e):
                    s, f = (S + e * scale, q) if by == "S" else (S, q + e * scale)
                    return closed(solve(s, f, u), f)
                at = {e: shifted(e * h) for e in (-2, -1, 1, 2)}
                for name in ("w", "F", "theta0", "Pn", "U"):
                    slope = (8 * (at[1][name] - at[-1][name]) - at[2][name] + at[-2][name]) / (12 * h * scale)
                    diff_worst.add("d%s_d%s" % (name, by), slope, mpf(row["d%s_d%s" % (name, by)]))
    closed_worst.report("%d states, closed forms:" % len(rows))
    quad_worst.report("%d states, quadrature:" % ((len(rows) + 39) // 40))
    diff_worst.report("%d states, differences of closed forms:" % ((len(rows) + 29) // 30))


def check_pairs():
    """hi + lo of each initialiser is the value of the table."""
    for name in ("states", "ends", "poles", "shapes", "elliptic"):
        worst = Worst()
        rows = read(name)
        lines = list(initialisers(FOLDER / (name + ".csv")))
        assert len(rows) == len(lines)
        for row, line in zip(rows, lines):
            outputs = list(row)[1 + 2 * sum(c.endswith("_hex") for c in row):]
            pairs = [p.split("}")[0].split(", ") for p in line[1:].split("{")[1:]]
            assert len(pairs) == len(outputs)
            for column, (hi, lo) in zip(outputs, pairs):
                if hi != "inf" and abs(float.fromhex(hi)) > 1e-280:   # below, lo is subnormal
                    worst.add("hi + lo", mpf(float.fromhex(hi)) + mpf(float.fromhex(lo)), mpf(row[column]))
        worst.report(name + ", initialisers:")


def check_ends():
    worst = Worst()
    for row in read("ends"):
        q = double(row, "q")
        m = mp.sin(angle(q) / 2) ** 2
        K, E = mp.ellipk(m), mp.ellipe(m)
        S = K / (2 * E - K)
        worst.add("u_end", K, mpf(row["u_end"]))
        worst.add("S_end", S, mpf(row["S_end"]))
        worst.add("w_end", S * mp.sin(angle(q) / 2) / K, mpf(row["w_end"]))
    worst.report("ends:")
    q = mpf(read("critical_friction")[0]["q"])
    m = mp.sin(angle(q) / 2) ** 2
    print("2E/K - 1 at the critical q:", mp.nstr(2 * mp.ellipe(m) / mp.ellipk(m) - 1, 3))
    poles = Worst()
    for row in read("poles"):
        poles.add("I_c (absolute)", closed(mpf(row["u_pole"]), double(row, "q"))["Ic"], 0)
    poles.report("poles:")


def check_shapes():
    worst = Worst()
    states = {(r["S_hex"], r["q_hex"]): None for r in read("shapes")}
    for row in read("shapes"):
        S, q, f = (double(row, n) for n in "Sqf")
        key = row["S_hex"], row["q_hex"]
        if not states[key]:   # the first root, by scanning
            step, u = mpf(1) / 64, mpf(1) / 64
            while closed(u, q)["Ic"] * 2 * S > 1:
                u += step
            lo, hi = (u - step if u > step else mpf(10) ** -6), u
            for _ in range(60):
                mid = (lo + hi) / 2
                lo, hi = (mid, hi) if closed(mid, q)["Ic"] * 2 * S > 1 else (lo, mid)
            states[key] = solve(S, q, (lo + hi) / 2)
        u, beta0 = states[key], angle(q)
        b = beta0 - closed(u, q)["theta0"]
        part = min(f, 1 - f)
        v = 2 * u * part
        if v:   # closed forms at the partial argument v, then turned by b
            at = closed(v, q)
            bv = beta0 - at["theta0"]
            turn = bv - b
            x0, y0 = at["Ic"] * v / u, at["w"] / at["S"] * v / u     # per S, in the frame of the angle at v
            x, y = S * (mp.cos(turn) * x0 - mp.sin(turn) * y0), S * (mp.sin(turn) * x0 + mp.cos(turn) * y0)
        else:
            x, y, turn = mpf(0), mpf(0), beta0 - b
        if f > mpf(1) / 2:
            x, turn = 1 - x, -turn
        for name, got in (("x", x), ("y", y), ("theta", turn)):
            table = mpf(row[name])
            worst.add(name, got, table if table else mpf(0))
    worst.report("shapes:")


def check_elliptic():
    worst = Worst()
    for i, row in enumerate(read("elliptic")):
        u, m, m1 = (double(row, n) for n in ("u", "m", "m1"))
        assert m + m1 == 1
        sn, cn, dn = (mp.ellipfun(f, u, m=m) for f in ("sn", "cn", "dn"))
        for name, v in (("sn", sn), ("cn", cn), ("dn", dn)):
            worst.add(name, v, mpf(row[name]))
        phi = mp.atan2(sn, cn)                     # u below 2K
        worst.add("E", mp.ellipe(phi, m), mpf(row["E"]))
        worst.add("u", mp.ellipf(phi, m), u)
        if i % 8 == 0:    # over the amplitude: dv = dphi/dn
            n = lambda a: mp.sqrt(1 - m * mp.sin(a) ** 2)
            c = mp.cos
            points = mp.linspace(0, phi, 9)
            worst.add("V", mp.quad(lambda a: mp.sin(a) ** 2 / n(a) ** 3, points), mpf(row["V"]))
            worst.add("P", mp.quad(lambda a: 2 * mp.sin(a / 2) ** 2 * (m1 + m * c(a)) / n(a) ** 3, points), mpf(row["P"]))
            worst.add("R", mp.quad(lambda a: 4 * mp.sin(a / 2) ** 4 / n(a) ** 3, points), mpf(row["R"]))
    worst.report("elliptic:")


if __name__ == "__main__":
    check_pairs()
    check_ends()
    check_elliptic()
    check_shapes()
    check_states()
