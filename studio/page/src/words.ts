// The program's sentences where it speaks of its flags, for who sees boxes.

import type { Test } from "./test";

/** The box, or the line of the card, that says what a flag of `read` and `fit` does. */
export const BOXES: Readonly<Record<string, string>> = {
  "encoding": "encoding", "separator": "format", "decimal": "format", "thousands": "format", "time": "time", "crosshead": "stage", "deflection": "stage", "stage": "stage", "displacement-column": "stage",
  "force": "force", "displacement": "moves", "displacement-unit": "stage unit", "force-unit": "force unit", "time-unit": "time", "calibration": "volts", "sheet": "sheet", "specimen": "specimen",
  "span": "span", "stiffness": "load train", "supports": "supports", "diameter": "diameter", "inner-diameter": "wall", "wall": "wall", "width": "width", "height": "height", "modulus": "modulus", "bending-stiffness": "modulus",
  "roller-radius": "radius", "sign": "zero, sign", "zero": "zero, sign", "contact": "contact", "failure": "last row", "first": "first row", "until": "last row",
};

/** Sentences of the program about a test, a line each: its file named once, and boxes where they say flags. */
export function inPageWords(sentences: string, test: Test): string {
  const name = test.isCase ? test.name : test.data;
  const words = sentences.split("\n").map((sentence) => {
    const file = [test.data, test.main, test.plainName].find((each) => sentence.startsWith(`${each}:`));
    const boxed = withBoxes(file === undefined ? sentence : sentence.slice(file.length + 1).replace(/^(\d+): /, "line $1: ").trim());
    return test.isCase ? boxed : boxesOfKeys(boxed);
  }).join("; ");
  return [name, test.data, test.main].some((each) => words.startsWith(each)) ? words : `${name}: ${words}`;
}

/** "[rig] roller_radius" is "“radius”": of a data file, which has no case to write it into. */
const boxesOfKeys = (sentence: string): string => sentence.replace(/\[\w+\] (\w+)/g, (key, name: string) => {
  const box = BOXES[name.replaceAll("_", "-")];
  return box === undefined ? key : `“${box}”`;
});

/** "pass --force 2" is "enter “force”: 2", "add --span LENGTH" is "enter “span”"; what has no box here is left out. */
export function withBoxes(sentence: string): string {
  return sentence.replaceAll(" (flexslip read FILE shows them)", "").replace(/ \(--([a-z-]+)\)/g, (flag, name: string) => (BOXES[name] === undefined ? "" : flag))
    .replace(/--(displacement-column|stage|force) "[^"]* \[([^\]]+)\]"/g, (_, name: string, unit: string) => `“${name === "force" ? "force" : "stage"} unit”: ${unit}`)
    .replace(/\b([wW])rite ([^;.]*?) into \[\w+\]/g, (_, w: string, what: string) => `${w === "W" ? "Enter" : "enter"} ${what}`).replaceAll("modulus or bending_stiffness", "modulus").replace(/\b(?:pass|add) (?=--[a-z])/g, "enter ").replace(/\b(?:Pass|Add) (?=--[a-z])/g, "Enter ").replace(/--([a-z][a-z-]*[a-z])(?:[ =]("[^"]*"|…|[A-Z]{2,}\b|[a-z]+(?:\|[a-z]+)+|\d+\b|(?:crosshead|deflection|none|keep|find|reverse)\b))?/g, (flag, name: string, value: string | undefined) => {
    const box = BOXES[name];
    if (box === undefined) return flag;
    const told = value === undefined || /^[A-Z]{2,}$|[…|]/.test(value) ? "" : `: ${value.replaceAll('"', "")}`;
    return `“${box}”${told}`;
  });
}
