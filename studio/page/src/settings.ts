// What the user decided about a test, beside what its file says, as the flags of the command line.

import { exactly, unitFor, type Unit } from "./quantity";

const bending: Unit = { name: "N m²", command: "N m^2", factor: 1 };
const giga: Unit = { name: "GPa", command: "GPa", factor: 1e9 };

/** How a file is read where `read` is told otherwise than it found; `fit` then takes the plain table that `read` writes. */
export const READ_FLAGS = ["encoding", "separator", "decimal", "thousands", "time", "crosshead", "deflection", "force", "displacement-unit", "force-unit", "time-unit"] as const;

/** What is measured of rig and specimen, and may be stated with how far it may be off: what stands behind "±". */
type Measured = "span" | "diameter" | "wall" | "width" | "height" | "modulus" | "stiffness";

export interface Settings extends Partial<Record<`${Measured}Off`, string>> {
  read: Partial<Record<(typeof READ_FLAGS)[number], string>>;
  specimen?: string; sheet?: string; calibration?: string; speed?: string;
  displacement?: "crosshead" | "deflection";
  sign?: string; zero?: string; contact?: string; failure?: string; first?: number; until?: number;
  section?: "round" | "tube" | "rectangle"; supports?: "edges" | "rollers";
  span?: number; diameter?: number; wall?: number; width?: number; height?: number; modulus?: number; stiffness?: number; tipRadius?: number;  // SI
  heldStiffness?: number;  // [N m²] EI that the fit holds
}

/** What the fit is told of EI when it is held: so sure that the record cannot move it. */
const HELD = "0.001 %";

const quoted = (value: string): string => `"${value}"`;

/** The flags of `fit` on a case file: every change is a --set. A held EI is said as the modulus of a round section, where the case has one. */
export function changesOfCase(settings: Settings, roundDiameter: number | null): string[] {
  const set = (key: string, value: string | undefined): string[] => (value === undefined ? [] : ["--set", `${key}=${value}`]);
  const text = (key: string, value: string | undefined): string[] => set(key, value === undefined ? undefined : quoted(value));
  const EI = settings.heldStiffness, held = EI !== undefined && roundDiameter !== null;
  return [
    ...text("rig.span", stated(settings, "span")), ...text("specimen.height", stated(settings, "height")), ...(held ? set("specimen.diameter", `{ value = ${quoted(length(roundDiameter)!)}, uncertainty = "0 %" }`) : text("specimen.diameter", stated(settings, "diameter"))),
    ...text("rig.stiffness", stated(settings, "stiffness")),
    ...set("rig.supports", settings.tipRadius ? "rollers" : undefined), ...text("rig.roller_radius", length(settings.tipRadius || undefined)),
    ...(EI === undefined ? [] : roundDiameter !== null
      ? set("specimen.modulus", `{ value = ${quoted(exactly(EI / inertia(roundDiameter), giga))}, uncertainty = "${HELD}" }`)
      : set("specimen.bending_stiffness", `{ value = ${quoted(exactly(EI, bending))}, uncertainty = "${HELD}" }`)),
    ...text("record.displacement", settings.displacement), ...text("record.sign", settings.sign), ...text("record.zero", settings.zero),
    ...text("record.contact", settings.contact), ...text("record.failure", settings.failure),
    ...set("record.first", settings.first?.toString()), ...set("record.until", settings.until?.toString()),
  ];
}

/** The flags of `fit` on a data file. */
export function flagsOfData(settings: Settings): string[] {
  const flag = (name: string, value: string | undefined): string[] => (value === undefined ? [] : [`--${name}`, value]);
  const EI = settings.heldStiffness;
  return [
    ...flag("displacement", settings.displacement),
    ...flag("sheet", settings.sheet), ...flag("specimen", settings.specimen), ...flag("calibration", settings.calibration), ...flag("speed", settings.speed),
    ...flag("span", stated(settings, "span")), ...SECTIONS[settings.section ?? "round"].flatMap((name) => flag(name, stated(settings, name))),
    ...flag("modulus", stated(settings, "modulus")), ...flag("stiffness", stated(settings, "stiffness")),
    ...flag("supports", settings.supports ?? (settings.tipRadius ? "rollers" : undefined)),
    ...(settings.tipRadius ? ["--set", `rig.roller_radius=${quoted(length(settings.tipRadius)!)}`] : []),
    ...(EI === undefined ? [] : ["--set", `specimen.bending_stiffness={ value = ${quoted(exactly(EI, bending))}, uncertainty = "${HELD}" }`]),
    ...flag("sign", settings.sign), ...flag("zero", settings.zero), ...flag("contact", settings.contact), ...flag("failure", settings.failure),
    ...flag("first", settings.first?.toString()), ...flag("until", settings.until?.toString()),
  ];
}

/** A measured quantity with its error, as the command line takes it. */
function stated(settings: Settings, name: Measured): string | undefined {
  const value = settings[name], off = settings[`${name}Off`];
  if (value === undefined) return undefined;
  const unit = name === "modulus" ? giga : unitFor(value, name === "stiffness" ? "stiffness" : "length", 2000);
  return `${exactly(value, unit)}${off === undefined ? "" : ` ± ${off}`}`;
}

/** "90.65 N/m ± 0.3 %" as what stands before and behind the sign. */
export function partsOf(words: string): { value: string; off: string | null } {
  const [value, off] = words.split(/\s*(?:±|\+-)\s*/, 2) as [string, string?];
  return { value, off: off && /^[\d.,]+$/.test(off) ? `${off} ${/[^-+\d.,\s].*$/.exec(value.replace(/e[-+]?\d+/i, ""))?.[0] ?? ""}`.trim() : off ?? null };  // a bare number has the unit of its value
}

/** What each section is said by. */
export const SECTIONS = { round: ["diameter"], tube: ["diameter", "wall"], rectangle: ["width", "height"] } as const;

/** The second moment of area of a round section [m⁴]. */
export const inertia = (diameter: number): number => (Math.PI * diameter ** 4) / 64;

const length = (value: number | undefined): string | undefined => (value === undefined ? undefined : exactly(value, unitFor(value, "length", 2000)));

/** An argument as a shell takes it. */
export const shellWord = (word: string): string => (/^[\w./:=@%+,-]+$/.test(word) ? word : /["'$`\\!\n]/.test(word) ? `'${word.replaceAll("'", "'\\''")}'` : `"${word}"`);
