"""The model with SciPy: the paper's Algorithm 1 as printed, and the closed form of the model at its best."""
import math

import numpy as np
from scipy.integrate import quad
from scipy.special import ellipeinc, ellipj


def algorithm_1(S, q, start):
    """w, F, P_n of one state: a Newton iteration for P_n on (4.27), ellipj for the angle (4.14), quad for the integrals."""
    beta0 = math.atan2(1, -q)
    k = math.sin(beta0 / 2)

    def beta(s, omega):
        _, cn, dn, _ = ellipj(omega * s, k * k)
        return 2 * math.asin(k * cn / dn)

    def closing(Pn):
        omega = S * math.sqrt(Pn / math.sin(beta0))
        end = beta(0.5, omega)
        return 1 - 2 * S * quad(lambda s: math.cos(beta(s, omega) - end), 0, 0.5)[0]

    Pn = start
    for _ in range(50):
        h = 1e-6 * Pn
        value = closing(Pn)
        step = value / ((closing(Pn + h) - value) / h)
        Pn -= step
        if abs(step) < 1e-12 * Pn:
            break
    omega = S * math.sqrt(Pn / math.sin(beta0))
    end = beta(0.5, omega)
    w = S * quad(lambda s: math.sin(beta(s, omega) - end), 0, 0.5)[0]
    Ic = quad(lambda s: math.cos(beta(s, omega) - end), 0, 0.5)[0]
    return w, 8 * omega**2 * Ic**2 * math.sin(end), Pn


def small_deflection_force(S):
    """P_n of a nearly straight fibre: F = 48 w, S - 1 = 2.4 w^2."""
    return 24 * math.sqrt((S - 1) / 2.4)


def algorithm_1_states(S, q, start=None):
    """Along a curve: each state starts from the P_n of the one before."""
    w, F, Pn = [], [], start or small_deflection_force(S[0])
    for length, friction in zip(S, q):
        deflection, force, Pn = algorithm_1(length, friction, Pn)
        w.append(deflection)
        F.append(force)
    return np.array(w), np.array(F), Pn


def closed_form(S, q):
    """w, F of arrays of states: as bench/rival.h, all states in step."""
    beta0 = np.arctan2(1, -q)
    k, k1 = np.sin(beta0 / 2), np.cos(beta0 / 2)
    m = k * k

    def half_fibre(u):
        sn, cn, dn, phi = ellipj(u, m)
        E = ellipeinc(phi, m)
        cd = cn / dn
        sin_b = 2 * k * cd * k1 / dn
        cos_b = 1 - 2 * m * cd * cd
        C = 2 * E - u - 2 * m * sn * cd
        D = 2 * k * k1 * sn / dn
        z = cos_b * D - sin_b * C
        return cos_b * C + sin_b * D, z, 1 - D * z, sin_b

    target = np.sqrt(np.sqrt(1 - 1 / S))
    u = target * np.sqrt(np.sqrt(15 * (1 + q * q)))
    for _ in range(20):
        a, _, slope, _ = half_fibre(u)
        root = np.sqrt(np.sqrt(1 - a / u))
        step = 4 * root**3 * (root - target) * u / (a / u - slope)
        u = u - step
        if np.all(np.abs(step) < 1e-8 * u):
            break
    a, z, _, sin_b = half_fibre(u)
    return z / (2 * a), 8 * a * a * sin_b


def folds_of_samples(S, G):
    """Where sampled values of G turn: indices of the maxima and minima between the ends."""
    rising = np.sign(np.diff(G))
    return np.nonzero(rising[1:] != rising[:-1])[0] + 1


def closed_form_folds(friction, stiffness, longest, points):
    """(S, G) of the folds: samples, then each extremum enclosed ever closer by 16 samples, all at once."""
    def stage(S):
        w, F = closed_form(S, friction(S))
        return w + F / stiffness

    S = np.linspace(1, longest, points + 1)[1:]
    G = stage(S)
    at = folds_of_samples(S, G)
    sign = np.sign(G[at] - G[at - 1])
    middle, width = S[at], S[1] - S[0]
    while width > 1e-8:  # below, G is flat to rounding
        around = middle[:, None] + width * np.linspace(-1, 1, 17)
        values = sign[:, None] * stage(around.ravel()).reshape(around.shape)
        middle = around[np.arange(len(middle)), values.argmax(axis=1)]
        width /= 8
    return middle, stage(middle)
