// A case file as the program writes it back (`provenance.case`): one key a line, in sections. Only read here; the program alone decides what it means.

import { parseQuantity } from "./quantity";

export class CaseText {
  private readonly values = new Map<string, string>();

  constructor(readonly text: string) {
    let section = "";
    for (const line of text.split("\n")) {
      const header = /^\s*\[([\w.]+)\]\s*$/.exec(line);
      if (header) section = header[1]! + ".";
      const entry = /^\s*(\w+)\s*=\s*(.+?)\s*$/.exec(line);
      if (entry) this.values.set(section + entry[1]!, entry[2]!);
    }
  }
  raw(key: string): string | null {
    return this.values.get(key) ?? null;
  }
  /** The text of a key, without quotes or the uncertainty beside it. */
  words(key: string): string | null {
    const raw = this.values.get(key);
    if (raw === undefined) return null;
    return /value\s*=\s*"([^"]*)"/.exec(raw)?.[1] ?? /^"((?:[^"\\]|\\.)*)"/.exec(raw)?.[1]?.replace(/\\(.)/g, "$1") ?? /^[^#\s]+/.exec(raw)?.[0] ?? null;
  }
  /** The value of a quantity in SI; null if there is none. */
  quantity(key: string): number | null {
    const words = this.words(key);
    return words === null ? null : parseQuantity(words);
  }
  /** Whether the case is of a kind whose rig the page's mechanics has: a round section or EI alone, edges or fixed rollers. */
  get hasRoundSection(): boolean {
    return this.values.has("specimen.diameter") && !this.values.has("specimen.wall") && !this.values.has("specimen.inner_diameter");
  }
}
