// The mechanics behind the views: the model at the values of the sliders, the reference curves, the band of the draws.

import { bisectLeft } from "d3-array";
import type { Loading, Mechanics, QuantityKind, Rig, Shape, State } from "./engine";
import { frictionOf, type Values } from "./parameters";
import type { Fit } from "./test";

export interface Curve { stage: Float64Array; deflection: Float64Array; force: Float64Array }
export interface Band { rows: Float64Array; lowForce: Float64Array; highForce: Float64Array }

const STEPS = 800;  // of the stage over the record: finer than the pixels of any plot

/** Friction over S for these values. The fibre keeps its friction where it is past the supports, so a changed span shifts it. */
function tableOf(fit: Fit, values: Values, mu: Float64Array): Rig["friction"] {
  const shift = values.L - fit.fitted.L;
  return { length: shift === 0 ? fit.friction.length : fit.friction.length.map((S) => S + shift), mu };
}

export function rigOf(fit: Fit, values: Values, mu: Float64Array): Rig {
  return { span: values.L, diameter: values.D, bendingStiffness: values.EI, stiffness: values.kc, tipRadius: values.R, friction: tableOf(fit, values, mu) };
}

/** The length between the contacts where the fit last saw its friction: beyond, friction is continued as in a mirror. */
const lastSeen = (fit: Fit): number => fit.friction.length[fit.friction.seen - 1] ?? fit.fitted.L;

/** How far the fibre was drawn in there, over both supports [m]: on knife edges, as much longer as it became between the contacts. */
export function seenTo(fit: Fit): number {
  const end = fit.answer.profile.at(-1);
  return lastSeen(fit) + (end ? end.drawn_in - end.length : -fit.fitted.L);
}

const LIVE_KNOTS = 280;  // of friction while a slider moves: a curve costs by the knots that it passes

/** Every few of the knots, the last one among them. */
function thinned(friction: Rig["friction"]): Rig["friction"] {
  const { length, mu } = friction, n = length.length, every = Math.ceil(n / LIVE_KNOTS);
  if (n <= LIVE_KNOTS) return friction;
  const kept = Array.from({ length: Math.ceil(n / every) }, (_, i) => i * every);
  if (kept[kept.length - 1] !== n - 1) kept.push(n - 1);
  return { length: Float64Array.from(kept, (i) => length[i]!), mu: Float64Array.from(kept, (i) => mu[i]!) };
}

interface Off { stage: number; deflection: number; force: number }

/** What the fit found a rig to be off by, and what it reads of a loading therefore. */
class OffRig {
  private readonly stage: Float64Array; private readonly deflection: Float64Array; private readonly force: Float64Array;

  constructor({ curves }: Fit, private readonly rig: Rig) {
    [this.stage, this.deflection, this.force] = ["w_s", "deflection_off", "force_off"].map((name) => curves.column(name)!) as [Float64Array, Float64Array, Float64Array];
  }
  /** The stage position that is read as the farthest. */
  get farthest(): number {
    return this.stage.reduce((most, stage, i) => Math.max(most, stage + this.deflection[i]! + this.force[i]! / this.rig.stiffness), 0);
  }
  read(loading: Loading): Loading {
    const { stage, deflection, force, snaps } = loading, offs = Array.from(stage, (at) => this.at(at));
    const less = (state: State, off: Off): State => ({ ...state, deflection: state.deflection - off.deflection, force: state.force - off.force });
    return {
      ...loading, stage: stage.map((at, i) => at - offs[i]!.stage), deflection: deflection.map((w, i) => w - offs[i]!.deflection), force: force.map((F, i) => F - offs[i]!.force),
      snaps: snaps.map(({ stage: at, from, to }) => ({ stage: at - this.at(at).stage, from: less(from, this.at(at)), to: less(to, this.at(at)) })),
    };
  }
  /** By the row read there: it changes slowly. */
  private at(stage: number): Off {
    const row = bisectLeft(this.stage, stage, 0, this.stage.length - 1), deflection = this.deflection[row]!, force = this.force[row]!;
    return { stage: deflection + force / this.rig.stiffness, deflection, force };
  }
}

export class Model {
  private memory = new Map<string, unknown>();  // of what does not follow the sliders

  constructor(private readonly mechanics: Mechanics) {}

  /** What is written in a box, by the program's own parser; throws its sentence. */
  quantity(words: string, kind: QuantityKind): number {
    return this.mechanics.quantity(words, kind);
  }
  unit(words: string, kind: QuantityKind): number {
    return this.mechanics.unit(words, kind);
  }
  rig(fit: Fit, values: Values, wave: boolean): Rig {
    return rigOf(fit, values, fit.friction.at(frictionOf(values, wave)));
  }
  /** The rig of a record whose friction is not determined. */
  frictionless(fit: Fit, values: Values): Rig {
    return { ...rigOf(fit, values, new Float64Array(0)), friction: { length: Float64Array.of(values.L, 2 * values.L), mu: Float64Array.of(0, 0) } };
  }
  /** The step of the stage [m] with which a programme is run through. */
  private stepOf(programme: number[]): number {
    let way = 0;
    for (let i = 1; i < programme.length; ++i) way += Math.abs(programme[i]! - programme[i - 1]!);
    return way / (STEPS * Math.min(3, Math.max(1, programme.length - 1)));
  }
  /** While a slider moves (`live`) with fewer knots of friction and steps of the stage: what is shown at rest, and exported, has them all. */
  loading(rig: Rig, programme: number[], live = false): Loading {
    return live ? this.mechanics.simulate({ ...rig, friction: thinned(rig.friction) }, programme, 2 * this.stepOf(programme)) : this.mechanics.simulate(rig, programme, this.stepOf(programme));
  }
  /** The record's own loading, at the values given, as its rig reads it. While a slider moves it is a sketch, where one can be made. */
  monotone(fit: Fit, rig: Rig, live = false): Loading {
    const off = new OffRig(fit, rig);
    if (live)
      try {
        return off.read(this.mechanics.sketch(rig, off.farthest, STEPS));
      } catch { /* it slips through, or is bent too far for a sketch */ }
    return off.read(this.loading(rig, [0, off.farthest], live));
  }
  /** Makes the tables of states on these supports, and lets the browser compile what runs through them, while there is nothing else to do: of any specimen on them. */
  prepare({ span, diameter, stiffness, tipRadius }: { span: number; diameter: number; stiffness: number; tipRadius: number }): void {
    const length = Float64Array.from({ length: 60 }, (_, i) => span * (1 + i / 120)), mu = length.map((_, i) => 0.5 + 0.1 * Math.sin(i));
    const farthest = 0.4 * span, k = Number.isFinite(stiffness) && stiffness > 0 ? stiffness : 1;
    this.mechanics.simulate({ span, diameter, tipRadius, stiffness: k, bendingStiffness: (k * span ** 3) / 200, friction: { length, mu } }, [0, farthest], farthest / 300);
  }
  withoutFriction(rig: Rig): Loading {
    return this.mechanics.equilibrium({ ...rig, friction: { length: Float64Array.of(rig.span, 2 * rig.span), mu: Float64Array.of(0, 0) } }, 200);
  }
  linear(rig: Rig, deflection: number): number {
    return this.mechanics.linear(rig, deflection);
  }
  shape(rig: Rig, deflection: number, friction: number): Shape {
    return this.mechanics.shape(rig, deflection, friction, 81);
  }

  /** Least and greatest force of the draws of the fit at each row, along the load line of that row. Costs as many loadings as there are draws. */
  band(fit: Fit, draws: number): Band {
    const known = this.memory.get("band") as { fit: Fit; band: Band } | undefined;
    if (known?.fit === fit) return known.band;
    const stage = fit.curves.column("w_s")!, lowForce = new Float64Array(stage.length).fill(Infinity), highForce = new Float64Array(stage.length).fill(-Infinity);
    for (const [i, draw] of fit.friction.draws.slice(0, draws).entries()) {
      const mu = fit.friction.mean.map((mean, at) => draw[at] ?? mean);
      const EI = fit.answer.draws?.bending_stiffness[i] ?? fit.fitted.EI;
      const loading = this.monotone(fit, rigOf(fit, { ...fit.fitted, EI }, mu));
      const force = forceAt(loading, stage);
      force.forEach((f, at) => {
        if (f < lowForce[at]!) lowForce[at] = f;
        if (f > highForce[at]!) highForce[at] = f;
      });
    }
    const band = { rows: fit.rows, lowForce, highForce };
    this.memory.set("band", { fit, band });
    return band;
  }
}

/** The force of a loading at stage positions that grow; NaN beyond its end. Of a snap, the state after it. */
export function forceAt(loading: Curve, stage: Float64Array): Float64Array {
  const { stage: s, force: f } = loading, out = new Float64Array(stage.length).fill(NaN);
  let j = 0;
  for (let i = 0; i < stage.length; ++i) {
    const at = stage[i]!;
    while (j + 1 < s.length && s[j + 1]! <= at) ++j;
    if (j + 1 < s.length) out[i] = f[j]! + ((f[j + 1]! - f[j]!) * (at - s[j]!)) / (s[j + 1]! - s[j]! || 1);
    else if (s.length && Math.abs(s[j]! - at) <= 1e-9 * Math.abs(at)) out[i] = f[j]!;
  }
  return out;
}

/** Root mean square of data less model [N], over the rows that the model reaches and whose friction the fit has seen. */
export function misfit(fit: Fit, loading: Curve): { rms: number; residual: Float64Array } {
  const stage = fit.curves.column("w_s")!, force = fit.curves.column("F")!, S = fit.curves.column("S")!, model = forceAt(loading, stage), last = lastSeen(fit);
  const residual = force.map((f, i) => (S[i]! > last ? NaN : f - model[i]!));
  let sum = 0, count = 0;
  for (const r of residual)
    if (!Number.isNaN(r)) {
      sum += r * r;
      ++count;
    }
  return { rms: Math.sqrt(sum / Math.max(1, count)), residual };
}
