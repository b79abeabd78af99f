// Files that come in: dropped, picked, given in the page or in an address. What they are is for the program to say; here they are only paired and kept small.

import { bytesOf } from "./address";
import { Test, type Files } from "./test";

export interface Incoming { name: string; bytes: Uint8Array }
const MOST = 64e6;  // [bytes] of a file: more than any machine writes for one test, and what the page reads without stalling

/** A name that no shell, no flag and no folder can be made of; short enough to show. */
export function harmless(name: string): string {
  const base = name.replace(/^.*[/\\]/, "").replace(/[\u0000-\u001f\u007f]/g, "").trim().slice(-120);
  return base.replace(/^[-.]+/, "_").replace(/^__proto__$/, "proto") || "file";
}

export const megabytes = (bytes: number): string => `${Math.round(bytes / 1e6)} MB`;

/** Reads what was dropped; what is too large is named and left out. */
export async function readFiles(list: Iterable<File>, refuse: (sentence: string) => void): Promise<Incoming[]> {
  const found: Incoming[] = [];
  for (const file of list) {
    const name = harmless(file.name);
    if (file.size > MOST) {
      refuse(`${name} has ${megabytes(file.size)}; the studio reads files up to ${megabytes(MOST)}. The program itself reads it: flexslip fit.`);
      continue;
    }
    try {
      found.push({ name, bytes: new Uint8Array(await file.arrayBuffer()) });
    } catch {
      refuse(`${name} cannot be read; folders and links cannot be dropped, files can.`);
    }
  }
  return found;
}

/** The data file that a case names; null if it names none. */
export function dataOfCase(text: string): string | null {
  const record = /(?:^|\n)\s*\[record\]([\s\S]*?)(?=\n\s*\[|$)/.exec(text)?.[1] ?? "";
  return /(?:^|\n)\s*file\s*=\s*["']([^"']+)["']/.exec(record)?.[1] ?? null;
}

const stem = (name: string): string => name.replace(/\.[^.]+$/, "");

/** Tests of these files: a case with its data, or a data file alone. */
export function testsOf(incoming: Incoming[], named?: string): Test[] {
  const tests: Test[] = [], taken = new Set<string>(), byName = new Map<string, Incoming>();
  for (const file of incoming) byName.set(file.name, file);
  for (const file of byName.values()) {
    if (!/\.toml$/i.test(file.name)) continue;
    const text = new TextDecoder().decode(file.bytes), stated = dataOfCase(text);
    const wanted = stated === null ? "" : harmless(stated), data = byName.get(wanted);
    taken.add(file.name);
    if (!data) {
      tests.push(new Test(stem(file.name), { [file.name]: file.bytes }, file.name, wanted));  // the program says what it lacks
      continue;
    }
    taken.add(data.name);
    const files: Files = { [file.name]: stated === wanted ? file.bytes : new TextEncoder().encode(text.replace(stated!, wanted)), [data.name]: data.bytes };
    for (const other of byName.values()) if (other !== file && other !== data && text.includes(`"${other.name}"`)) {
      files[other.name] = other.bytes;  // a trace, a table of friction
      taken.add(other.name);
    }
    tests.push(new Test(named ?? (stem(file.name) === "case" ? stem(data.name) : stem(file.name)), files, file.name, data.name));
  }
  for (const file of byName.values()) if (!taken.has(file.name)) tests.push(new Test(stem(file.name), { [file.name]: file.bytes }, file.name, file.name));
  return tests;
}

/** Tests that `flexslip studio FILE...` put into the page: a case with all that it names, in their folders, or a data file. */
export function given(): Test[] {
  const list = JSON.parse(document.getElementById("given")?.textContent || "[]") as { open: string; files: { name: string; data: string }[] }[];
  return list.map(({ open, files }) => {
    const all: Files = Object.fromEntries(files.map(({ name, data }) => [name, bytesOf(data)])), folder = open.replace(/[^/]*$/, ""), base = open.slice(folder.length);
    if (!open.endsWith(".toml")) return new Test(stem(base), all, open, open);
    const named = dataOfCase(new TextDecoder().decode(all[open])) ?? "";
    const data = [folder + named, named].find((name) => name in all) ?? Object.keys(all).find((name) => name !== open && name.endsWith(named.replace(/^.*\//, ""))) ?? open;
    return new Test(base === "case.toml" && folder ? folder.replace(/\/$/, "").replace(/^.*\//, "") : stem(base), all, open, data);
  });
}

/** Files that stand in the page: the example. */
export function standing(id: string): Incoming[] {
  const text = document.getElementById(id)?.textContent;
  if (!text) return [];
  return (JSON.parse(text) as { name: string; text: string }[]).map(({ name, text: words }) => ({ name, bytes: new TextEncoder().encode(words) }));
}
