#!/usr/bin/python3
"""Writes the reference tables of this folder (README.md). About two minutes."""
import random
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from itertools import product
from pathlib import Path

from jacobi import Jacobi
from mpmath import mp, mpf
from pendulum import Fibre, Pendulum

FOLDER = Path(__file__).parent
INF = mpf("inf")


def decimal(v):
    return "inf" if v == INF else mp.nstr(v, 40, strip_zeros=False) if v else "0"


def hexadecimal(x):
    return float(x).hex() if x else "0"


def write(name, made, inputs, outputs, rows):
    """A row is (label, doubles, values)."""
    header = [made, "Values: 40 digits. Inputs are doubles: 17 digits here, hexadecimal beside."]
    csv = ["# " + line for line in header]
    csv.append(",".join(["group"] + inputs + [i + "_hex" for i in inputs] + outputs))
    for label, doubles, values in rows:
        csv.append(",".join([label] + ["%.17g" % x for x in doubles] + [hexadecimal(x) for x in doubles]
                            + [decimal(v) for v in values]))
    (FOLDER / (name + ".csv")).write_text("\n".join(csv) + "\n")
    print(name, len(rows), {g: [r[0] for r in rows].count(g) for g in dict.fromkeys(r[0] for r in rows)}, flush=True)


# --- states: (S, q) -> (w, F) and all the rest -------------------------------------------------------------------

STATE = ["u", "w", "F", "theta0", "Pn", "U", "dw_dS", "dw_dq", "dF_dS", "dF_dq", "dU_dS", "dU_dq", "dPn_dS", "dPn_dq",
         "condition_F_S", "condition_F_q", "dtheta0_dS", "dtheta0_dq"]
MADE_STATES = "The elastica in (S, q): Taylor integration of the pendulum at 150 digits, no elliptic functions."


def end_length(q):
    """Length at the end of the branch; infinite when S has its pole first."""
    p = Pendulum(q=q)
    S = p.state(p.end())[0]
    return S if S > 0 else INF


def critical_friction():
    """The q at which the pole of S and the end of the branch coincide: 2E(m) = K(m)."""
    def mean_cosine(q):
        p = Pendulum(q=q)
        return p.at(p.end())[3]
    return mp.findroot(mean_cosine, (mpf("0.86"), mpf("0.8604")), tol=mpf(10) ** -240)


def requested(critical):
    """(group, S, q) of every row; those beyond the branch fall out."""
    rnd = random.Random(20211)
    end = cache(end_length)
    qs = [-20.0, -7.0, -2.5, -1.0, -0.3, 0.0, 0.25, 0.6, 1.0, 2.0, 6.5, 20.0]
    rows = [("tiny", float(1 + mpf(e)), q) for e in ("1e-12", "1e-11", "1e-10", "1e-9", "1e-8") for q in qs]
    rows += [("small", float(1 + mpf(e)), q)
             for e in ("3e-8", "1e-7", "1e-6", "1e-5", "1e-4", "4e-4", "1e-3") for q in qs]
    for S, q in product((1.001, 1.01, 1.03, 1.1, 1.25, 1.4, 1.6), (-1.0, -0.5, 0.0, 0.3, 0.6, 1.0, 1.5, 2.0)):
        rows.append(("working", S, q))
    for _ in range(90):
        rows.append(("working", round(rnd.uniform(1.001, 1.6), 6), round(rnd.uniform(-1, 2), 6)))
    for q in (-20.0, -17.3, -13.0, -9.0, -6.0, -4.0, -3.0, -2.0, -1.4, -1.0):
        rows += [("large negative q", float(1 + (end(q) - 1) * mpf(f)), q)
                 for f in ("1e-6", "1e-3", "0.03", "0.2", "0.5", "0.8", "0.95")]
    for q in (2.0, 2.5, 3.7, 5.0, 8.0, 12.0, 16.0, 20.0):
        rows += [("large positive q", S, q) for S in (1.0001, 1.01, 1.1, 1.35, 1.6, 2.5, 5.0, 12.0, 30.0)]
    for q in (0.861, 0.9, 1.0, 1.3, 1.8, 3.0, 7.0, 20.0):
        rows += [("beyond the working range", S, q) for S in (1.65, 2.0, 3.3, 8.0, 25.0, 100.0)]
    rows += [("beyond the working range", S, q) for q in (-0.5, 0.0, 0.3, 0.6, 0.8, 0.85, 0.86)
             for S in (1.65, 2.0, 3.3, 8.0, 25.0, 100.0)]
    for q in (-20.0, -10.0, -4.0, -2.0, -1.0, -0.5, 0.0, 0.3, 0.6, 0.75, 0.82, 0.85, 0.859):
        rows += [("near the end", float(end(q) - (end(q) - 1) * mpf(f)), q)
                 for f in ("1e-1", "1e-2", "1e-3", "1e-5", "1e-7", "1e-9", "1e-10")]
    for q in (0.0, 1e-300, -1e-300, 1e-16, -1e-16, 1e-8, -1e-8, 1e-4, -1e-4):
        rows += [("tiny q", S, q) for S in (float(1 + mpf("1e-10")), 1.001, 1.05, 1.3, 2.1)]
    at = float(critical)
    for q in (at, at - 1e-12, at + 1e-12, at - 1e-8, at + 1e-8, at - 1e-4, at + 1e-4, at - 0.01, at + 0.01):
        rows += [("near 2E = K", S, q) for S in (1.2, 1.7, 6.0, 60.0)]
    rows = list(dict.fromkeys(rows))
    return [r for r in rows if r[1] < end(r[2])]


def states_at(q, lengths):
    """The values of STATE for each length, at one q; and the worst disagreement of the two step sizes."""
    fibre, out, worst = Fibre(q), [], mpf(0)
    for S in lengths:
        u = fibre.middle.phase(mpf(S))
        reached, w, F, theta0, Pn, U = fibre.middle.state(u)
        assert abs(reached / mpf(S) - 1) < mpf(10) ** -120 and F > 0
        fine, coarse = fibre.derivatives(u, 1), fibre.derivatives(u, 0)
        for a, b in zip(fine, coarse):
            for x, y in zip(a, b):
                worst = max(worst, abs(x / y - 1))
        (w_S, w_q), (F_S, F_q), (t_S, t_q), (P_S, P_q), (U_S, U_q) = fine
        identity = max(abs(U_q / (F * w_q) - 1), abs((U_S - F * w_S + mpf(q) * Pn) / U_S))
        assert identity < mpf(10) ** -45, (S, q, identity)     # dU = F dw - q Pn dS
        out.append([u, w, F, theta0, Pn, U, w_S, w_q, F_S, F_q, U_S, U_q, P_S, P_q,
                    abs(mpf(S) / F * F_S), abs(mpf(q) / F * F_q), t_S, t_q])
    assert worst < mpf(10) ** -45, (q, worst)
    return out, worst


def write_states(pool, critical):
    wanted = requested(critical)
    by_q = {}
    for _, S, q in wanted:
        by_q.setdefault(q, []).append(S)
    values, worst = {}, mpf(0)
    for (q, lengths), (out, disagreement) in zip(by_q.items(), pool.map(states_at, by_q.keys(), by_q.values())):
        worst = max(worst, disagreement)
        values.update(zip(((S, q) for S in lengths), out))
    rows = [(g, (S, q), values[S, q]) for g, S, q in wanted]
    zero, ten = mpf(0), mpf(10)      # S -> 1: U -> 24 w^2 and S - 1 -> 2.4 w^2, so dU/dS -> 10
    for q in (-20.0, -1.0, 0.0, 0.6, 2.0, 20.0):
        rows.append(("limit S = 1", (1.0, q),
                     [zero] * 6 + [INF, zero, INF, zero, ten, zero, INF, zero, INF, zero, INF, zero]))
    write("states", MADE_STATES, ["S", "q"], STATE, rows)
    print("derivatives with steps 1e-40 and 1e-42 agree to", mp.nstr(worst, 3))


# --- the end of the branch -----------------------------------------------------------------------------------------

def write_ends(critical):
    qs = [-20.0, -18.5, -16.0, -14.0, -12.0, -10.0, -9.0, -8.0, -7.0, -6.0, -5.0, -4.5, -4.0, -3.5, -3.0, -2.5, -2.0,
          -1.75, -1.5, -1.25, -1.0, -0.8, -0.6, -0.4, -0.3, -0.2, -0.1, -1e-16, 0.0, 1e-8, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6,
          0.7, 0.75, 0.8, 0.83, 0.85, 0.859, float(critical) - 1e-6]
    rows = []
    for q in qs:
        p = Pendulum(q=q)
        u = p.end()
        S, w, _, theta0, Pn, U = p.state(u)
        rows.append(("end", (q,), [S, w, u, theta0, Pn, U]))
    write("ends", "End of the branch, F = 0 (u = K(m)), for q below the root of 2E(m) = K(m): made as states.",
          ["q"], ["S_end", "w_end", "u_end", "theta0_end", "Pn_end", "U_end"], rows)
    poles = []
    for q in (float(critical) + 1e-6, 0.861, 0.87, 0.9, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0):
        p = Pendulum(q=q)
        lo, hi = mpf(0), p.end()
        for _ in range(40):
            lo, hi = ((lo + hi) / 2, hi) if p.half_span((lo + hi) / 2)[0] > 0 else (lo, (lo + hi) / 2)
        u = (lo + hi) / 2
        for _ in range(12):
            X, dX = p.half_span(u)
            u -= X / dX
        assert abs(X) < mpf(10) ** -120
        poles.append(("pole", (q,), [u]))
    write("poles", "Phase u at the pole of S, where I_c = 0, for q above the root of 2E(m) = K(m): made as states.",
          ["q"], ["u_pole"], poles)
    (FOLDER / "critical_friction.csv").write_text(
        "# q at which 2E(m) = K(m): below, the branch ends with F = 0; above, at the pole of S.\nq\n%s\n" % decimal(critical))


# --- the deformed shape --------------------------------------------------------------------------------------------

def write_shapes():
    fractions = (0.0, 0.0625, 0.125, 0.25, 0.3, 0.375, 0.4375, 0.5, 0.625, 0.8, 0.9375, 1.0)
    states = [(float(1 + mpf("1e-12")), 0.6), (float(1 + mpf("1e-6")), -3.0), (1.001, 0.0), (1.01, -1.0), (1.05, 0.3), (1.1, 0.6),
              (1.1, -1.0), (1.2, 0.0), (1.25, 1.0), (1.3, -0.4), (1.4, 0.6), (1.5, 2.0), (1.6, 0.8), (2.0, 0.5), (2.18, 0.0),
              (3.0, 0.9), (10.0, 1.5), (1.1, 20.0), (30.0, 20.0), (1.0006, -20.0), (1.3, 1e-16)]
    rows = []
    for S, q in states:
        p = Pendulum(q=q)
        u = p.phase(mpf(S))
        c, s, slope, C, turn, _ = p.at(u)
        span = 2 * (c * C - s * slope)                         # L in units of phase
        for f in fractions:
            half = mpf(min(f, 1 - f))
            _, _, pt, Ct, turn_t, _ = p.at(2 * u * half)
            x, y, theta = (c * Ct - s * pt) / span, (-c * pt - s * Ct) / span, turn - turn_t
            rows.append(("shape", (S, q, f), [x, y, theta] if f <= 0.5 else [1 - x, y, -theta]))
    write("shapes", "Shape at the fraction f of the arc length S, from one support (f = 0) to the other (f = 1), in units of L: made as states.",
          ["S", "q", "f"], ["x", "y", "theta"], rows)


# --- elliptic functions --------------------------------------------------------------------------------------------

def write_elliptic():
    moduli = [6e-4, 1e-3, 0.01, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 0.97, 0.99, 0.999, 1 - 6e-4]
    rows = []
    for m in moduli:
        m = round(m * 2 ** 53) / 2 ** 53      # so that 1 - m is a double too
        quarter = Jacobi(m).quarter_period()
        us = [1e-4, 1e-3, 0.01, 0.1, 0.3, 0.7, 1.2] + [float(quarter * mpf(f)) for f in ("0.9", "0.999", "1", "1.3", "1.99")]
        for u in us:
            rows.append(("elliptic", (u, m, 1 - m), Jacobi(m).values(mpf(u))))
    write("elliptic", "Jacobi's functions by Taylor integration of their differential equations at 150 digits; V = int sd^2, "
          "P = int (1-cn)(m1+m cn)/dn^2, R = int ((1-cn)/dn)^2, all from 0 to u; m1 = 1 - m exactly.",
          ["u", "m", "m1"], ["sn", "cn", "dn", "E", "V", "P", "R"], rows)


if __name__ == "__main__":
    critical = critical_friction()
    print("2E = K at q =", decimal(critical))
    with ProcessPoolExecutor(2) as pool:
        write_states(pool, critical)
    write_ends(critical)
    write_shapes()
    write_elliptic()
