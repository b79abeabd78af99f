// The program's sentences where it speaks of its flags, for who sees boxes; and the question that it asks of a file.

import type { Test } from "./test";

/** The box, or the line of the card, that says what a flag of `read` and `fit` does. */
export const BOXES: Readonly<Record<string, string>> = {
  "encoding": "encoding", "separator": "format", "decimal": "format", "thousands": "format", "time": "time", "speed": "speed", "crosshead": "displacement", "deflection": "displacement", "stage": "displacement", "displacement-column": "displacement",
  "force": "force", "displacement": "measures", "displacement-unit": "displacement unit", "force-unit": "force unit", "time-unit": "time", "calibration": "volts", "sheet": "sheet", "specimen": "specimen",
  "span": "span", "stiffness": "load train", "supports": "supports", "diameter": "diameter", "inner-diameter": "wall", "wall": "wall", "width": "width", "height": "height", "modulus": "modulus", "bending-stiffness": "modulus",
  "roller-radius": "radius", "sign": "sign", "zero": "zero", "contact": "contact", "failure": "last row", "first": "first row", "until": "last row",
};

/** Boxes that hold for all files of one rig; a specimen is that of its file. */
export const OF_ALL_FILES: ReadonlySet<string> = new Set(["span", "load train", "speed", "supports", "radius", "measures", "displacement unit", "force unit", "volts"]);

const UNIT_OF_A_COLUMN = /--(displacement-column|stage|deflection|force) "[^"]*\[([^\]]+)\]"/;
const unitBox = (flag: string): string => `${flag === "force" ? "force" : "displacement"} unit`;

/** What the program asks of a file: the first of its open questions, and the box that answers it. */
export interface Question { words: string; box: string; of: number }
const heard = new Map<string, string>();  // questions by their flags: of the last one open, the program says only that its value is missing
export function questionOf(test: Test): Question | null {
  if (test.isCase || test.fit) return null;
  const [line = ""] = test.refusal.split("\n"), list = [...test.refusal.matchAll(/^ +(--.*?)  +(.*)/gm)], [asked, , words] = list[0] ?? [line];
  for (const [, flags, each] of list) heard.set(flags!.split(" ")[0]!, each!);
  const unit = UNIT_OF_A_COLUMN.exec(asked!), flags = [...asked!.matchAll(/--([a-z][a-z-]*[a-z])/g)].map(([, flag]) => flag!);
  const flag = flags.includes("displacement-column") ? "displacement-column" : flags.find((each) => BOXES[each] !== undefined);
  if (flag === undefined) return null;
  return { words: words ?? heard.get(/^(--\S+): This value is missing/.exec(line)?.[1] ?? "") ?? inPageWords(line.replace(/^--[a-z-]+: /, ""), test), box: unit ? unitBox(unit[1]!) : BOXES[flag]!, of: Math.max(1, list.length) };
}

/** Sentences of the program about a test, a line each, with boxes where they say flags. */
export const inPageWords = (sentences: string, test: Test): string => sentences.split("\n").map((sentence) => {
  const boxed = withBoxes(test.isPlain ? sentence.replaceAll(test.plainName, test.data) : sentence);
  return test.isCase ? boxed : boxesOfKeys(boxed);
}).join("\n");

/** "[rig] roller_radius" is "“radius”": of a data file, which has no case to write it into. */
const boxesOfKeys = (sentence: string): string => sentence.replace(/\[\w+\] (\w+)/g, (key, name: string) => {
  const box = BOXES[name.replaceAll("_", "-")];
  return box === undefined ? key : `“${box}”`;
}).replace(", or describe the test in a case file (.toml)", "");

/** "pass --force 2" is "enter “force”: 2", "add --span LENGTH" is "enter “span”"; what has no box here is left out. */
export function withBoxes(sentence: string): string {
  return sentence.replaceAll(" (flexslip read FILE shows them)", "").replace(/ \(--([a-z-]+)\)/g, (flag, name: string) => (BOXES[name] === undefined ? "" : flag))
    .replace(new RegExp(UNIT_OF_A_COLUMN, "g"), (_, name: string, unit: string) => `“${unitBox(name)}”: ${unit}`)
    .replace(/\bwrite ([^;]*?) into \[\w+\]/g, "enter $1").replace(/\bWrite ([^;]*?) into \[\w+\]/g, "Enter $1").replaceAll("modulus or bending_stiffness", "modulus").replace(/\b(pass|add) (?=--[a-z])/g, "enter ").replace(/\b(Pass|Add) (?=--[a-z])/g, "Enter ").replace(/--([a-z][a-z-]*[a-z])(?:[ =]("[^"]*"|…|[A-Z]{2,}\b|[a-z]+(?:\|[a-z]+)+|\d+\b|(?:crosshead|deflection|edges|rollers|none|keep|find|fit|reverse)\b))?/g, (flag, name: string, value: string | undefined) => {
    const box = BOXES[name];
    if (box === undefined) return flag;
    const told = value === undefined || /^[A-Z]{2,}$|[…|]/.test(value) ? "" : `: ${value.replaceAll('"', "")}`;
    return `“${box}”${told}`;
  });
}
