// What can be turned: eleven numbers of friction, specimen and rig, each with the unit in which it reads best.

import { tellsFriction } from "./answer";
import type { FitAnswer, ParameterName } from "./answers";
import type { CaseText } from "./case-text";
import type { FrictionValues } from "./friction";
import { plainUnit, unitFor, type Unit } from "./quantity";

export const KEYS = ["mu0", "rms", "len", "amp", "lam", "phi", "EI", "D", "kc", "L", "R"] as const;
export type Key = (typeof KEYS)[number];
export type Values = Record<Key, number>;  // SI; the phase in radians, at the middle of the fibre seen

export interface Parameter {
  key: Key;
  group: "Friction" | "Wave" | "Specimen" | "Rig";
  name: string;   // with *quantity* and _index_
  unit: Unit;
  unitWords: string;
  low: number; high: number;  // of the slider, SI
  logarithmic: boolean;
  digits: number;  // after the point, in the unit
  lock: "found" | "measured" | "choice";  // by the fit always, never, or as the user says
  interval: [number, number] | null;  // 95 % of the fit, SI
}

const degrees: Unit = { name: "°", command: "deg", factor: Math.PI / 180 };
const FITTED: Partial<Record<Key, ParameterName>> = { mu0: "mu0", rms: "roughness", len: "correlation_length", amp: "amplitude", lam: "wavelength", phi: "phase", EI: "bending_stiffness" };

/** An angle between -π and π. */
export const wrapped = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/** The middle of the fibre seen [m]: there the phase of a wave does not run away with its length. */
export const middleOf = (fit: FitAnswer): number => ((fit.band?.length[0] ?? 0) + (fit.band?.length.at(-1) ?? 0)) / 2;

/** The values of a fit; what it does not have is taken from what it would be, were it there. */
export function valuesOf(fit: FitAnswer, text: CaseText): Values {
  const p = fit.parameters, wave = fit.wave, span = text.quantity("rig.span") ?? 1e-3;
  return {
    mu0: p.mu0?.value ?? 0, rms: p.roughness?.value ?? 0, len: p.correlation_length?.value ?? span / 200,
    amp: wave?.claimed ? wave.amplitude.value : 0.1, lam: wave?.wavelength.value ?? span / 100, phi: p.phase && p.wavelength ? wrapped(p.phase.value + Math.PI * middleOf(fit) / p.wavelength.value) : 0,
    EI: (tellsFriction(fit) ? p.bending_stiffness?.value : null) ?? fit.nominal_bending_stiffness?.nominal ?? 0,
    D: text.words("rig.friction_at") === "axis" ? 0 : text.quantity("specimen.diameter") ?? text.quantity("specimen.height") ?? 0, kc: text.quantity("rig.stiffness") ?? Infinity, L: span, R: text.quantity("rig.roller_radius") ?? 0,
  };
}

export const frictionOf = (values: Values, wave: boolean): FrictionValues => ({
  mu0: values.mu0, roughness: values.rms, correlationLength: values.len,
  wave: wave ? { amplitude: values.amp, wavelength: values.lam, phase: values.phi } : null,
});

/** Rows of parameters for a fit: ranges about its values, so that a spicule and a bar of steel both fill their sliders. */
export function parametersOf(fit: FitAnswer, fitted: Values, isRound: boolean): Parameter[] {
  const span = fitted.L;
  const interval = (key: Key): [number, number] | null => {
    const name = FITTED[key], estimate = name ? fit.parameters[name] : undefined;
    if (!estimate?.interval95) return null;
    const [low, high] = estimate.interval95;
    return key === "phi" ? [fitted.phi + low - estimate.value, fitted.phi + high - estimate.value] : [low, high];
  };
  const row = (key: Key, group: Parameter["group"], name: string, unit: Unit, low: number, high: number, digits: number, options: Partial<Parameter> = {}): Parameter =>
    ({ key, group, name, unit, unitWords: unit.name, low, high, logarithmic: false, digits, lock: "found", interval: interval(key), ...options });
  const lengthOf = (value: number): Unit => unitFor(Math.max(value, 1e-8) < 2e-7 ? value : Math.max(value, 2e-5), "length", 10000);
  const digitsOf = (value: number, unit: Unit, significant: number): number => Math.max(0, Math.min(6, significant - 1 - Math.floor(Math.log10(Math.abs(value / unit.factor) || 1))));
  const logarithmic = true, EI = unitFor(fitted.EI, "bending"), D = lengthOf(fitted.D), k = unitFor(Number.isFinite(fitted.kc) ? fitted.kc : 1, "stiffness");
  const len = lengthOf(fitted.len), lam = lengthOf(fitted.lam), L = lengthOf(span);
  const rows = [
    row("mu0", "Friction", "mean *μ*_0_", plainUnit, 0, Math.max(1, 1.5 * fitted.mu0), 3),
    row("rms", "Friction", "roughness", plainUnit, 0, Math.max(0.3, 2 * fitted.rms), 3, { unitWords: "in *μ*" }),
    row("len", "Friction", "correlation length", len, fitted.len / 30, fitted.len * 30, digitsOf(fitted.len, len, 2), { logarithmic }),
    row("amp", "Wave", "amplitude *A*", plainUnit, 0, 1, 3, { unitWords: "of *μ*_0_" }),
    row("lam", "Wave", "length *λ*", lam, fitted.lam / 5, fitted.lam * 5, digitsOf(fitted.lam, lam, 4), { logarithmic }),
    row("phi", "Wave", "phase *φ*", degrees, -Math.PI, Math.PI, 1),
    row("EI", "Specimen", "stiffness *EI*", EI, fitted.EI / 2, fitted.EI * 2, digitsOf(fitted.EI, EI, 4), { lock: "choice", logarithmic }),
    row("D", "Specimen", isRound ? "diameter" : "height", D, fitted.D / 3, fitted.D * 3, digitsOf(fitted.D, D, 3), { lock: "measured", logarithmic }),
    row("kc", "Rig", "load train *k*_c_", k, (Number.isFinite(fitted.kc) ? fitted.kc : 1) / 20, (Number.isFinite(fitted.kc) ? fitted.kc : 1) * 20, digitsOf(fitted.kc, k, 4), { lock: "measured", logarithmic }),
    row("L", "Rig", "span *L*", L, span / 2, span * 2, digitsOf(span, L, 4), { lock: "measured", logarithmic }),
    row("R", "Rig", "radius", L, 0, Math.max(span / 10, 2 * fitted.R), 1, { lock: "measured" }),
  ];
  return rows.filter((r) => r.key !== "D" || fitted.D > 0);
}

/** Whether a parameter can have this value: what is positive stays so, and within a hundred times its range. */
export function isAllowed(p: Parameter, value: number): boolean {
  if (p.key === "kc" && value === Infinity) return true;
  if (!Number.isFinite(value)) return false;
  if (p.key === "phi") return Math.abs(value) <= 1000 * Math.PI;
  if (p.logarithmic) return value > 0 && value >= p.low / 100 && value <= p.high * 100;
  return value >= 0 && value <= (p.key === "amp" ? 1 : p.key === "R" ? p.high * 10 : 3);
}

/** Where a value stands on its slider, 0 to 1, and back. */
export function placeOf(p: Parameter, value: number): number {
  const place = p.logarithmic ? Math.log(value / p.low) / Math.log(p.high / p.low) : (value - p.low) / (p.high - p.low);
  return Number.isNaN(place) ? 0 : Math.max(0, Math.min(1, place));
}
export const valueAt = (p: Parameter, place: number): number => (p.logarithmic ? p.low * (p.high / p.low) ** place : p.low + (p.high - p.low) * place);

/** The value as its box shows it. */
export function shown(p: Parameter, value: number): string {
  if (!Number.isFinite(value)) return "inf";
  if (value === 0) return "0";
  const inUnit = value / p.unit.factor;
  const whole = Math.max(0, Math.floor(Math.log10(Math.abs(inUnit) || 1)));
  return inUnit.toFixed(Math.max(0, Math.min(p.digits, 5 - whole)));
}
