// Friction along the fibre as the sliders say it: the mean of the fit, taken apart into level, drift, wave and roughness, and put together again with other sizes.

import type { FitAnswer } from "./answers";
import { middleOf } from "./parameters";
import type { Table } from "./table";

export interface FrictionValues { mu0: number; roughness: number; correlationLength: number; wave: { amplitude: number; wavelength: number; phase: number } | null }

/** The phase is the one at the middle of the fibre seen, so that it does not run away with the wavelength. */
const waveAt = (S: number, reference: number, mu0: number, wave: NonNullable<FrictionValues["wave"]>): number =>
  mu0 * wave.amplitude * Math.cos((Math.PI * (S - reference)) / wave.wavelength + wave.phase);

const BEYOND = 0.4;  // of the fibre seen: a softer fibre is drawn in farther than the record got, and finds friction there

export class FittedFriction {
  readonly seen: number;          // lengths that the record got to; those after it continue the roughness as in a mirror
  readonly length: Float64Array;  // [m] S, between the contacts
  readonly mean: Float64Array;
  readonly deviation: Float64Array;
  readonly draws: Float64Array[];
  private readonly level: Float64Array;  // μ0 and drift
  private readonly rough: Float64Array;  // what is left of the mean beside level and wave
  private readonly reference: number;

  constructor(fit: FitAnswer, table: Table, readonly fitted: FrictionValues) {
    const length = table.at(0), mean = table.column("mu") ?? new Float64Array(0), n = length.length;
    this.seen = n;
    this.deviation = table.column("deviation") ?? new Float64Array(0);
    const first = length[0] ?? 0, last = length[n - 1] ?? 0, step = n > 1 ? (last - first) / (n - 1) : 0;
    const more = Math.floor(BEYOND * n);
    this.length = Float64Array.from({ length: n + more }, (_, i) => (i < n ? length[i]! : last + (i - n + 1) * step));
    this.draws = table.titles.flatMap((title, i) => (title.startsWith("draw_") ? [table.at(i)] : []));
    const drift = fit.parameters.drift?.value ?? 0;
    this.reference = fit.parameters.reference?.value ?? middleOf(fit);
    this.level = this.length.map((S) => fitted.mu0 + drift * (Math.min(S, last) - this.reference));
    const wave = (S: number): number => (fitted.wave ? waveAt(S, this.reference, fitted.mu0, fitted.wave) : 0);
    this.rough = mean.map((mu, i) => mu - this.level[i]! - wave(length[i]!));
    this.mean = this.length.map((S, i) => (i < n ? mean[i]! : Math.max(0, this.level[i]! + this.roughAt(S) + wave(S))));
  }

  /** Friction at the lengths S of the fit, of these values; at those of the fit it is the mean of the fit, bit by bit. */
  at(values: FrictionValues): Float64Array {
    const { fitted } = this;
    const sameWave = values.wave === fitted.wave || (values.wave && fitted.wave && values.wave.amplitude === fitted.wave.amplitude && values.wave.wavelength === fitted.wave.wavelength && values.wave.phase === fitted.wave.phase);
    if (values.mu0 === fitted.mu0 && values.roughness === fitted.roughness && values.correlationLength === fitted.correlationLength && sameWave) return this.mean;
    const size = fitted.roughness > 0 ? values.roughness / fitted.roughness : 0;
    const stretch = values.correlationLength > 0 && fitted.correlationLength > 0 ? fitted.correlationLength / values.correlationLength : 1;
    return this.level.map((level, i) => {
      const S = this.length[i]!;
      const mu = level + values.mu0 - fitted.mu0 + size * this.roughAt(this.reference + (S - this.reference) * stretch) + (values.wave ? waveAt(S, this.reference, values.mu0, values.wave) : 0);
      return Math.max(0, mu);
    });
  }

  /** The roughness that the fit found, continued beyond its ends as in a mirror. */
  private roughAt(S: number): number {
    const { length, rough } = this, n = rough.length;
    if (n < 2) return rough[0] ?? 0;
    const first = length[0]!, extent = length[n - 1]! - first;
    let t = ((S - first) / extent) % 2;
    if (t < 0) t += 2;
    if (t > 1) t = 2 - t;
    const place = first + t * extent;
    let low = 0, high = n - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (length[middle]! <= place) low = middle;
      else high = middle;
    }
    const share = (place - length[low]!) / (length[high]! - length[low]! || 1);
    return rough[low]! + (rough[high]! - rough[low]!) * share;
  }
}
