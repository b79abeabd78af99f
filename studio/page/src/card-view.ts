// How a file was read: a line a decision, and each may be decided otherwise.

import { byId, el, fill } from "./dom";
import { exactly, parseQuantity, significant, unitFor } from "./quantity";
import type { Settings } from "./settings";
import type { Studio } from "./studio";
import type { Test } from "./test";

interface Choice { words: string; change: () => void; chosen?: boolean }

const MARKS: Record<string, string> = { ",": "comma", ";": "semicolon", "\t": "tab", tab: "tab", " ": "blanks", space: "blanks", ".": "point" };

export class CardView {
  constructor(private readonly studio: Studio) {}

  draw(): void {
    for (const id of ["card", "card-below"]) this.drawInto(byId(id));
  }

  private drawInto(host: HTMLElement): void {
    const { test } = this.studio;
    if (!test) return fill(host);
    const list = el("dl");
    for (const [name, choices, yours] of this.lines(test)) this.line(list, name, choices, yours);
    if (!test.isCase) for (const entry of this.entries(test)) list.append(...entry);
    const decided = Object.keys(test.settings.read).length > 0 || Object.keys(test.settings).length > 1;
    const words = this.studio.stale ? "Bold: decided by you. Press F to fit again." : decided ? "Bold: decided by you." : "Found by the program. Click a line to decide otherwise, then fit.";
    const focused = host.contains(document.activeElement) ? document.activeElement!.getAttribute("aria-label") : null;
    fill(host, el("div", { class: "head" }, el("h2", {}, `How ${test.data} was read`)), list, el("p", { class: "said" }, words));
    if (focused === null) return;
    const again = [...host.querySelectorAll<HTMLElement>("input, select")].find((e) => e.getAttribute("aria-label") === focused);
    again?.focus();
    if (again instanceof HTMLInputElement) again.select();
  }

  private line(list: HTMLElement, name: string, choices: Choice[], yours: boolean): void {
    const select = el("select", { class: `pick${yours ? " yours" : ""}`, "aria-label": name, change: () => choices[select.selectedIndex]?.change() }, ...choices.map((c) => el("option", {}, c.words)));
    select.selectedIndex = Math.max(0, choices.findIndex((c) => c.chosen));
    select.title = choices[select.selectedIndex]?.words ?? "";
    list.append(el("dt", {}, name), el("dd", {}, select));
  }

  /** Numbers of the rig that a data file need not say. */
  private entries(test: Test): HTMLElement[][] {
    const { settings, read } = test, { studio } = this;
    const entry = (name: string, key: "span" | "diameter" | "stiffness", unit: string, stated: number | null, needed: boolean): HTMLElement[] => {
      const value = settings[key] ?? stated, u = value ? unitFor(value, key === "stiffness" ? "stiffness" : "length", 10000) : null;
      const box = el("input", { class: `entry${value === null && needed ? " wanted" : ""}`, value: value && u ? exactly(value, { ...u, command: u.name }) : "", placeholder: unit, "aria-label": name, autocomplete: "off", spellcheck: "false", change: () => {
        const next = parseQuantity(box.value, "");
        const bare = /^[\d.,\s]+$/.test(box.value);
        if (next === null || !(next > 0) || bare || (next === Infinity && key !== "stiffness")) {
          studio.report(`${name}: “${box.value.slice(0, 40)}” is no quantity; write it with its unit, such as “${unit}”. The old value stays.`);
          box.value = value && u ? exactly(value, { ...u, command: u.name }) : "";
          return;
        }
        studio.remember();
        studio.decide({ [key]: next });
      } });
      if (settings[key] !== undefined) box.classList.add("yours");
      return [el("dt", {}, name), el("dd", {}, box)];
    };
    const deflection = (settings.displacement ?? "") === "deflection";
    return [entry("span", "span", "1278 um", read?.test.span ?? null, true), entry("diameter", "diameter", "34.8 um", read?.test.diameter ?? null, false), ...(deflection ? [] : [entry("load train", "stiffness", "90.65 N/m", null, true)])];
  }

  private lines(test: Test): [string, Choice[], boolean][] {
    const { studio } = this, { read, settings, fit } = test, lines: [string, Choice[], boolean][] = [];
    const decide = (change: Partial<Settings>) => (): void => {
      studio.remember();
      studio.decide(change);
    };
    const again = (flag: keyof Settings["read"], value: string | undefined) => (): void => {
      studio.remember();
      const flags = { ...settings.read };
      if (value === undefined) delete flags[flag];
      else flags[flag] = value;
      studio.decide({ read: flags });
      void studio.reread();
    };
    const step = (name: string): string => fit?.answer.preparation.find((s) => s.step === name)?.done ?? "";
    if (read && !test.isCase) {
      const separator = settings.read.separator, decimal = settings.read.decimal;
      lines.push(["format", [
        { words: `${read.format === "table" ? "" : `${read.format}: `}${MARKS[read.delimiter] ?? read.delimiter}, ${MARKS[read.decimal] ?? read.decimal}`, change: () => undefined, chosen: true },
        ...([[",", "."], [";", ","], ["tab", "."], ["tab", ","], [";", "."]] as const).filter(([s, d]) => s !== separator || d !== decimal).map(([s, d]) => ({ words: `${MARKS[s]}, ${MARKS[d]}`, change: (): void => {
          studio.remember();
          studio.decide({ read: { ...settings.read, separator: s, decimal: d } });
          void studio.reread();
        } })),
        ...(separator || decimal ? [{ words: "as found", change: (): void => {
          const { separator: _, decimal: __, ...rest } = settings.read;
          studio.remember();
          studio.decide({ read: rest });
          void studio.reread();
        } }] : []),
      ], separator !== undefined || decimal !== undefined]);
      if (read.sheets && read.sheets.length > 1) lines.push(["sheet", read.sheets.map((name) => ({ words: name, change: (): void => {
        studio.remember();
        studio.decide({ sheet: name });
        void studio.reread();
      }, chosen: name === read.sheet })), settings.sheet !== undefined]);
      if (read.specimens.length > 1) lines.push(["specimen", read.specimens.map((s, i) => ({ words: `${i + 1}${s.name ? `: ${s.name}` : ""}, ${s.rows} rows`, change: (): void => {
        studio.remember();
        studio.decide({ specimen: String(i + 1) });
        void studio.reread();
      }, chosen: (settings.specimen ?? "1") === String(i + 1) })), settings.specimen !== undefined]);
      const column = (role: "crosshead" | "force", title: string, roles: string[]): void => {
        const at = read.columns.find((c) => roles.includes(c.role));
        lines.push([title, [
          { words: at ? `${at.name}${at.unit ? `, in ${at.unit}` : ""}` : "not found: choose", change: () => undefined, chosen: true },
          ...read.columns.filter((c) => c !== at).map((c) => ({ words: `${c.name || `column ${c.number}`}${c.unit ? `, in ${c.unit}` : ""}`, change: again(role, String(c.number)) })),
          ...(settings.read[role] ? [{ words: "as found", change: again(role, undefined) }] : []),
        ], settings.read[role] !== undefined]);
      };
      column("crosshead", "stage", ["crosshead", "displacement", "deflection"]);
      column("force", "force", ["force"]);
      const moves = settings.displacement ?? (read.columns.some((c) => c.role === "crosshead") ? "crosshead" : read.columns.some((c) => c.role === "deflection") ? "deflection" : undefined);
      lines.push(["moves", [
        ...(moves ? [] : [{ words: "not said: choose", change: () => undefined, chosen: true }]),
        { words: "crosshead, less F/k", change: decide({ displacement: "crosshead" }), chosen: moves === "crosshead" },
        { words: "deflection", change: decide({ displacement: "deflection" }), chosen: moves === "deflection" },
      ], settings.displacement !== undefined]);
    } else if (read) {
      lines.push(["case", [{ words: test.main, change: () => undefined, chosen: true }], false]);
      lines.push(["format", [{ words: `${MARKS[read.delimiter] ?? read.delimiter}, ${MARKS[read.decimal] ?? read.decimal}; ${read.rows} rows`, change: () => undefined, chosen: true }], false]);
      const columns = step("columns");
      if (columns) lines.push(["columns", [{ words: read.columns.map((c) => `${c.name}${c.unit ? ` in ${c.unit}` : ""}`).join(", "), change: () => undefined, chosen: true }], false]);
    }
    const contact = fit?.answer.contact;
    if (contact) {
      const offset = contact.line_offset, u = unitFor(Math.max(Math.abs(offset.value), offset.standard_error), "length");
      const taken = `${significant(fit!.answer.parameters.contact_offset!.value / u.factor, 3)} ${u.name}`;
      const where = `${significant(offset.value / u.factor, 2)} ± ${significant(offset.standard_error / u.factor, 2)} ${u.name}`;
      lines.push(["contact", [
        { words: contact.source === "first_point" ? "zero of the file" : `${contact.source}: ${taken}`, change: () => undefined, chosen: true },
        { words: `find (${where})`, change: decide({ contact: "find" }), chosen: settings.contact === "find" }, { words: "first row", change: decide({ contact: "first row" }), chosen: settings.contact === "first row" },
        ...(settings.contact ? [{ words: "as found", change: decide({ contact: undefined }) }] : []),
      ], settings.contact !== undefined]);
      const zero = fit!.answer.preparation.find((s) => s.step === "zero"), sign = fit!.answer.preparation.find((s) => s.step === "sign");
      lines.push(["zero, sign", [
        { words: `${zero?.changed ? "found" : "kept"}, ${sign?.changed ? "reversed" : "kept"}`, change: () => undefined, chosen: true },
        { words: "find both", change: decide({ zero: "find", sign: "find" }), chosen: settings.zero === "find" && settings.sign === "find" }, { words: "keep both", change: decide({ zero: "keep", sign: "keep" }), chosen: settings.zero === "keep" && settings.sign === "keep" },
        { words: "reverse the sign", change: decide({ sign: "reverse" }), chosen: settings.sign === "reverse" },
        ...(settings.zero || settings.sign ? [{ words: "as found", change: decide({ zero: undefined, sign: undefined }) }] : []),
      ], settings.zero !== undefined || settings.sign !== undefined]);
      const m = fit!.answer.measurement, why: Record<string, string> = { failure: "fails after it", turn: "turns after it", last_row: "end of file", until: "as said" };
      lines.push(["last row", [
        { words: settings.until !== undefined ? `${settings.until}: by hand` : `${m.last_row}: ${why[m.ends_with] ?? m.ends_with}`, change: () => undefined, chosen: true },
        ...(m.last_row < m.rows && settings.failure !== "none" ? [{ words: `${m.rows}: end of file`, change: decide({ failure: "none", until: undefined }) }] : []),
        ...(settings.until !== undefined || settings.failure !== undefined ? [{ words: "as found", change: decide({ until: undefined, failure: undefined }) }] : []),
      ], settings.until !== undefined || settings.failure !== undefined]);
    }
    return lines;
  }
}
