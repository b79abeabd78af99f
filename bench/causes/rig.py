"""A real rig: what the laboratory states of it, and what it reads of a path. What is not in SI is reduced: span 1, EI 1."""

import dataclasses

import numpy as np

from friction import logarithmic

COARSEST = 0.01  # step of a load cell, over the greatest force
RIGID = 1e6  # load train in EI/L^3 that a laboratory takes for rigid


@dataclasses.dataclass
class Rig:
    """A real rig: its true numbers in SI units, and what the laboratory states and reads."""

    span: float
    stiffness: float
    bending_stiffness: float
    contact: float  # reduced; positive where the record begins before the contact
    span_error: float = 0.0
    stiffness_error: float = 0.0
    bending_error: float = 0.0
    gain: float = 0.0
    drift: float = 0.0
    lag: float = 0.0
    noise: float = 0.0
    memory: float = 0.0
    steps: float = 0.0  # of the force, over the noise
    states_bending: bool = True
    states_rig: bool = False
    toe: float = 0.0  # reduced
    roller_radius: float = 0.0  # reduced
    roller_error: float = 0.0
    height: float = 0.0  # of a bar, reduced
    height_error: float = 0.0

    @property
    def k(self):
        return self.stiffness * self.span**3 / self.bending_stiffness


def draw_rig(random, k):
    bench = random.uniform() < 0.3
    span = random.uniform(20e-3, 60e-3) if bench else logarithmic(random, 0.6e-3, 3e-3)
    stiffness = logarithmic(random, 500, 5000) if bench else logarithmic(random, 10, 150)
    return Rig(
        span=span,
        stiffness=stiffness,
        bending_stiffness=stiffness * span**3 / k,
        contact=random.choice([-1, 1]) * random.uniform(0.0005, 0.002),
        span_error=0.005 * random.normal(),
        stiffness_error=0.01 * random.normal(),
        bending_error=0.03 * random.normal(),
        gain=0.007 * random.normal(),
        drift=0.003 * random.normal(),
        lag=random.uniform() if random.uniform() < 0.5 else 0.0,
        noise=random.uniform(0.001, 0.004),
        memory=random.uniform(0.3, 0.8) if random.uniform() < 0.5 else 0.0,
        steps=random.uniform(0.5, 2) if random.uniform() < 1 / 3 else 0.0,
        states_bending=random.uniform() >= 0.2,
        states_rig=random.uniform() < 0.5,
    )


def smaller_errors(rig):
    """The rig of a rod: half of the errors, and a record that begins under a small force."""
    halves = {name: getattr(rig, name) / 2 for name in ("span_error", "stiffness_error", "gain", "drift", "noise")}
    return dataclasses.replace(rig, contact=-abs(rig.contact), **halves)


def any_reading(random, rig, top):
    """The rig with a noise from fine to coarse, steps of the force likewise, and a record that begins before the contact, by up to a
    tenth of its stage travel (top), or behind it."""
    early = random.uniform() < 0.5
    rig = dataclasses.replace(
        rig,
        contact=top * logarithmic(random, 0.002, 0.1) if early else -top * logarithmic(random, 0.0005, 0.008),
        noise=logarithmic(random, 0.0005, 0.01),
        steps=logarithmic(random, 0.3, 8) if random.uniform() < 0.5 else 0.0,
    )
    return dataclasses.replace(rig, steps=min(rig.steps, COARSEST / rig.noise))


# ---- what is read


def autoregressive(random, number, memory):
    values = random.normal(size=number)
    for i in range(1, number):
        values[i] = memory * values[i - 1] + np.sqrt(1 - memory**2) * values[i]
    return values


def read(random, rig, path):
    """Stage and force as the rig records them, in reduced units."""
    F = path.F.copy()
    stage = path.stage.copy()
    if rig.toe:
        stage = stage + rig.toe * (1 - np.exp(-F / (0.05 * F.max())))
    if rig.lag:
        F = (1 - rig.lag) * F + rig.lag * np.r_[F[0], F[:-1]]
    time = np.linspace(0, 1, len(F))
    wander = rig.drift * (time + 0.4 * np.sin(2 * np.pi * (1.3 * time + random.uniform())))
    F = F * (1 + rig.gain) + F.max() * (wander - wander[0])
    noise = rig.noise * path.F.max()
    F = F + noise * autoregressive(random, len(F), rig.memory)
    if rig.steps:
        F = np.round(F / (rig.steps * noise)) * rig.steps * noise
    return stage - stage[0] if rig.contact < 0 else stage + rig.contact, F


# ---- what is written


def specimen_lines(rig):
    """EI as the laboratory states it: on its own, or as the modulus of a bar as wide as three times its height."""
    EI = rig.bending_stiffness * (1 + rig.bending_error)
    if not rig.height:
        return [f'bending_stiffness = "{f"{EI:.5g} N m^2 ± 3 %" if rig.states_bending else "fit"}"']
    height = rig.height * rig.span * (1 + rig.height_error)
    modulus = f"{EI * 12 / (3 * height**4):.5g} Pa ± 3 %" if rig.states_bending else "fit"
    return [f'width = "{3e6 * height:.3f} um"', f'height = "{1e6 * height:.3f} um"', f'modulus = "{modulus}"']


def rig_lines(rig):
    stiffness = "inf" if rig.k >= 0.999 * RIGID else f"{rig.stiffness * (1 + rig.stiffness_error):.5g} N/m ± 1 %"
    lines = [f'span = "{rig.span * (1 + rig.span_error) * 1e6:.2f} um ± 0.5 %"', f'stiffness = "{stiffness}"']
    radius = rig.roller_radius * rig.span * (1 + rig.roller_error) * 1e6
    return lines + [f'roller_radius = "{radius:.3f} um"' if rig.roller_radius else 'supports = "edges"']


def case_text(name, rig):
    lines = [f"# Simulated: {name}. Made by bench/causes/records.py."]
    lines += ["[specimen]", *specimen_lines(rig), "", "[rig]", *rig_lines(rig)]
    lines += ["", "[record]", 'file = "test.csv"', 'stage = "stage [um]"', 'force = "force [mN]"']
    if rig.states_rig:
        lines += ['gain_error = "0.7 %"', f'preload_error = "{0.0013 * rig.span * 1e6:.2f} um"']
    return "\n".join(lines) + "\n"


def write_record(folder, name, rig, stage, F):
    target = folder / name
    target.mkdir(parents=True, exist_ok=True)
    (target / "case.toml").write_text(case_text(name, rig), encoding="utf-8")
    force = F * rig.bending_stiffness / rig.span**2 * 1e3
    with open(target / "test.csv", "w", encoding="utf-8") as file:
        file.write("stage [um],force [mN]\n")
        for x, f in zip(stage * rig.span * 1e6, force):
            file.write(f"{x:.4f},{f:.7g}\n")
