// The state in the address: a link brings it back. What comes in is read as data of known shape or not at all.

import { KEYS, type Key } from "./parameters";
import { READ_FLAGS, type Settings } from "./settings";

export interface Link {
  files: { name: string; base64: string }[] | null;  // null: the example
  main: string; data: string;
  settings: Settings; values: Partial<Record<Key, number>>; wave: boolean | null; row: number | null; axis: "deflection" | "stage"; programme: number[] | null;
}
const PREFIX = "#s=";
const MOST_WRITTEN = 300_000;   // [characters] of an address: browsers take more, mail does not
const MOST_READ = 8_000_000;    // [bytes] unpacked

const toBase64 = (bytes: Uint8Array): string => {
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
};
const fromBase64 = (text: string): Uint8Array => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
export const base64Of = toBase64;
export const bytesOf = fromBase64;

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array> {
  const reader = new Blob([bytes.slice()]).stream().pipeThrough(stream).getReader(), parts: Uint8Array[] = [];
  for (let size = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) {
      const all = new Uint8Array(size);
      let at = 0;
      for (const part of parts) {
        all.set(part, at);
        at += part.length;
      }
      return all;
    }
    size += value.length;
    if (size > most) throw new Error("too long");
    parts.push(value);
  }
}

/** The address of a state; null if its files are too large for one. */
export async function addressOf(link: Link): Promise<string | null> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(link)), new CompressionStream("deflate-raw"), Infinity);
  const text = PREFIX + toBase64(packed).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return text.length > MOST_WRITTEN ? null : text;
}

/** The state of an address; null if there is none, "wrong" if it is none of ours. */
export async function linkOf(hash: string): Promise<Link | null | "wrong"> {
  if (!hash || hash === "#") return null;
  if (!hash.startsWith(PREFIX)) return "wrong";
  try {
    const bytes = await through(fromBase64(hash.slice(PREFIX.length).replaceAll("-", "+").replaceAll("_", "/")), new DecompressionStream("deflate-raw"), MOST_READ);
    return checked(JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)));
  } catch {
    return "wrong";
  }
}

type Unknown = Record<string, unknown>;
const isObject = (value: unknown): value is Unknown => typeof value === "object" && value !== null && !Array.isArray(value);
const text = (value: unknown, most = 200): string | null => (typeof value === "string" && value.length <= most && !/[\u0000-\u001f]/.test(value) ? value : null);
const finite = (value: unknown): number | null => (typeof value === "number" && Number.isFinite(value) ? value : null);

/** Known keys with values of their kind; all else is left. */
function checked(value: unknown): Link {
  if (!isObject(value)) throw new Error("no state");
  const files = value["files"] === null ? null : Array.isArray(value["files"]) && value["files"].length <= 8
    ? value["files"].map((file: unknown) => {
      if (!isObject(file)) throw new Error("no file");
      const name = text(file["name"]), base64 = file["base64"];
      if (name === null || !name || typeof base64 !== "string" || !/^[A-Za-z0-9+/]*=*$/.test(base64)) throw new Error("no file");
      return { name, base64 };
    }) : (() => { throw new Error("no files"); })();
  const main = text(value["main"]) ?? "", data = text(value["data"]) ?? "";
  if (files && (!files.some((f) => f.name === main) || !files.some((f) => f.name === data))) throw new Error("its files are missing");
  const settings: Settings = { read: {} }, given = isObject(value["settings"]) ? value["settings"] : {}, read = isObject(given["read"]) ? given["read"] : {};
  for (const flag of READ_FLAGS) {
    const words = text(read[flag], 80);
    if (words !== null) settings.read[flag] = words;
  }
  for (const name of ["specimen", "sheet", "calibration", "sign", "zero", "contact", "failure"] as const) {
    const words = text(given[name], 80);
    if (words !== null) settings[name] = words;
  }
  if (given["displacement"] === "crosshead" || given["displacement"] === "deflection") settings.displacement = given["displacement"];
  const { section, supports } = given;
  if (section === "round" || section === "tube" || section === "rectangle") settings.section = section;
  if (supports === "edges" || supports === "rollers") settings.supports = supports;
  for (const name of ["first", "until", "span", "diameter", "wall", "width", "height", "modulus", "stiffness", "tipRadius", "heldStiffness"] as const) {
    const number = finite(given[name]);
    if (number !== null && number >= 0) settings[name] = number;
  }
  const values: Link["values"] = {}, some = isObject(value["values"]) ? value["values"] : {};
  for (const key of KEYS) {
    const number = finite(some[key]);
    if (number !== null) values[key] = number;
  }
  const programme = Array.isArray(value["programme"]) && value["programme"].length >= 2 && value["programme"].length <= 40 && value["programme"].every((s) => finite(s) !== null && (s as number) >= 0) ? (value["programme"] as number[]) : null;
  return { files, main, data, settings, values, wave: typeof value["wave"] === "boolean" ? value["wave"] : null, row: finite(value["row"]), axis: value["axis"] === "stage" ? "stage" : "deflection", programme };
}
