// Numbers with units: read as people write them, shown with as many digits as their error allows.

import type { Estimate } from "./answers";

// The program's units (src/io/quantity.cpp), to SI: tests/outside/units.py holds that none is missing, and none more.
const PREFIXES: Record<string, number> = { f: 1e-15, p: 1e-12, n: 1e-9, u: 1e-6, "µ": 1e-6, "μ": 1e-6, m: 1e-3, c: 1e-2, d: 1e-1, k: 1e3, M: 1e6, G: 1e9, T: 1e12 };
const WITH_PREFIX: Record<string, number> = { m: 1, g: 1e-3, s: 1, N: 1, Pa: 1, J: 1, rad: 1 };
const WITHOUT_PREFIX: Record<string, number> = {
  micron: 1e-6, microns: 1e-6, in: 0.0254, mil: 2.54e-5, sec: 1, min: 60, h: 3600, lbf: 4.4482216152605, psi: 6894.757293168361, ksi: 6894757.293168361,
  Msi: 6894757293.168361, kgf: 9.80665, gf: 9.80665e-3, ozf: 4.4482216152605 / 16, kip: 4448.2216152605, ft: 0.3048, deg: Math.PI / 180, "°": Math.PI / 180, "%": 0.01,
};
// Names in lower case, whatever the case they are written in.
const SPELLINGS: Record<string, string> = {
  secs: "s", second: "s", seconds: "s", sekunden: "s", sek: "s", "sec.": "s", sec: "s", "秒": "s", mins: "min", minutes: "min", millimeter: "mm",
  millimetre: "mm", meter: "m", metre: "m", inch: "in", inches: "in", "in.": "in", micrometer: "um", micrometre: "um", newton: "N", newtons: "N",
  lb: "lbf", lbs: "lbf", kgf: "kgf", kp: "kgf", gf: "gf",
};
const SUPERSCRIPTS: Record<string, string> = { "⁰": "0", "¹": "1", "²": "2", "³": "3", "⁴": "4", "⁻": "-" };

function factorOf(symbol: string): number | null {
  const known = <T>(list: Record<string, T>, name: string): T | undefined => (Object.hasOwn(list, name) ? list[name] : undefined);
  const whole = known(WITHOUT_PREFIX, symbol) ?? known(WITH_PREFIX, symbol);
  if (whole !== undefined) return whole;
  const base = known(WITH_PREFIX, symbol.slice(1)), prefix = known(PREFIXES, symbol[0] ?? "");
  if (base !== undefined && prefix !== undefined) return prefix * base;
  const spelled = known(SPELLINGS, symbol.toLowerCase());
  return spelled !== undefined && spelled !== symbol ? factorOf(spelled) : null;
}

/** The factor from a unit such as "mN mm²" or "N/m" to SI; null if it is none. */
export function unitFactor(unit: string): number | null {
  let factor = 1, sign = 1;
  const text = unit.replace(/[⁰¹²³⁴⁻]+/g, (s) => "^" + [...s].map((c) => SUPERSCRIPTS[c]).join("")).replace(/[·*]/g, " ").trim();
  for (const part of text.split(/(\/|\s+)/)) {
    if (!part.trim()) continue;
    if (part === "/") {
      sign = -1;
      continue;
    }
    const [, symbol = "", power = "1"] = /^([^\^]+?)(?:\^(-?\d+))?$/.exec(part) ?? [];
    const one = factorOf(symbol);
    if (one === null) return null;
    factor *= one ** (sign * Number(power));
  }
  return factor;
}

/** What "34.8 um" is in SI; a bare number counts in `unit`. Null if it is no quantity. */
export function parseQuantity(words: string, unit = ""): number | null {
  const text = words.trim().replace("−", "-");
  if (/^[+]?inf(inity)?$|^∞$/i.test(text)) return Infinity;
  const found = /^([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?)\s*(.*)$/i.exec(text);
  if (!found) return null;
  const value = Number(found[1]!.replace(",", "."));
  const factor = unitFactor(found[2]!.trim() || unit);
  return Number.isFinite(value) && factor !== null ? value * factor : null;
}

export interface Unit { name: string; factor: number /* SI per unit */; command: string /* as the command line has it */ }
const unit = (name: string, command = name.replace("µ", "u").replace("²", "^2")): Unit => ({ name, command, factor: unitFactor(name)! });
const FAMILIES = {
  length: ["nm", "µm", "mm", "m"], force: ["nN", "µN", "mN", "N", "kN"], stiffness: ["mN/m", "N/m", "N/mm", "kN/mm"],
  bending: ["nN mm²", "µN mm²", "mN mm²", "N mm²", "N m²", "kN m²"], modulus: ["kPa", "MPa", "GPa"], energy: ["pJ", "nJ", "µJ", "mJ", "J"],
} as const;
export type Kind = keyof typeof FAMILIES;

/** The unit in which a value of this kind reads best: between 1 and 1,000 or, of lengths of a specimen, up to `most`. */
export function unitFor(value: number, kind: Kind, most = 1000): Unit {
  const units = FAMILIES[kind].map((name) => unit(name));
  const size = Math.abs(value);
  return units.find((u) => size < most * u.factor) ?? units[units.length - 1]!;
}
export const plainUnit: Unit = { name: "", command: "", factor: 1 };

export const minus = (text: string): string => text.replace("-", "−");

/** With `digits` after the point, and a proper minus. */
export const fixed = (value: number, digits: number): string => minus(value.toFixed(Math.max(0, Math.min(12, digits))));
/** "+0.044", "−0.044". */
export const signed = (value: number, digits: number): string => `${value < 0 ? "" : "+"}${fixed(value, digits)}`;

/** "0.508 ± 0.024": with two digits of the error. */
export function withError({ value, standard_error: error }: Estimate, u: Unit = plainUnit): string {
  const digits = 1 - Math.floor(Math.log10(Number((error / u.factor).toPrecision(2))));
  return `${fixed(value / u.factor, digits)} ± ${fixed(error / u.factor, digits)} ${u.name}`.trim();
}

/** A probability as the program prints it: at its threshold with the digits that show on which side. */
export function probability(share: number): string {
  const percent = 100 * share, away = Math.abs(Math.abs(percent - 50) - 45);
  if (away >= 0.5 && (percent < 1 || percent > 99)) return percent < 1 ? "below 1 %" : "above 99 %";
  return `${fixed(percent, away < 0.05 ? 2 : away < 0.5 ? 1 : 0)} %`;
}

/** Three significant digits, without an exponent where that reads well. */
export function significant(value: number, digits = 3): string {
  if (value === 0 || !Number.isFinite(value)) return value === 0 ? "0" : Number.isNaN(value) ? "–" : "∞";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  return exponent < -4 || exponent > 6 ? minus(value.toPrecision(digits)) : fixed(value, digits - 1 - exponent);
}

/** A value with the unit that suits it, three digits: "90.7 N/m". */
export function written(value: number, kind: Kind): string {
  const u = unitFor(value, kind);
  return `${significant(value / u.factor)} ${u.name}`;
}

/** The shortest decimal that is this number, in a unit of the command line: "34.8 um". */
export function exactly(value: number, u: Unit): string {
  if (value === Infinity) return "inf";
  return `${Number((value / u.factor).toPrecision(12))} ${u.command}`.trim();
}
