// How a file was read: a line a decision, and each may be decided otherwise.

import type { ReadColumn } from "./answers";
import { byId, el, fill } from "./dom";
import type { QuantityKind } from "./engine";
import { exactly, significant, unitFor, type Kind } from "./quantity";
import { partsOf, type Settings } from "./settings";
import { messageOf, type Studio } from "./studio";
import type { Test } from "./test";
import { withBoxes } from "./words";

interface Choice { words: string; change: () => void; chosen?: boolean; wanted?: boolean /* that this is chosen yet */ }
/** A box: what it is called, what it holds now, an example, and what is done with what is written; throws the sentence why not. */
interface Entry { name: string; value: string; example: string; wanted: boolean; yours: boolean; take: (words: string) => void }

const MARKS: Record<string, string> = { ",": "comma", ";": "semicolon", "\t": "tab", tab: "tab", " ": "blanks", space: "blanks", ".": "point" };

const ENCODINGS = ["utf-8", "utf-16le", "utf-16be", "cp1252", "shift-jis"];

export class CardView {
  private shown: unknown[] = [];
  private readonly drafts = new Map<string, { words: string; wrong: string }>();  // what stands in a box and is not what it takes

  constructor(private readonly studio: Studio) {}

  draw(): void {
    const { test, stale, tests } = this.studio;
    const now = [test, test?.read, test?.fit, test?.refusal, stale, tests.length, JSON.stringify([test?.settings, [...this.drafts]])];
    if (now.every((each, i) => each === this.shown[i])) return;  // what is being typed stays
    if (test !== this.shown[0]) this.drafts.clear();
    this.shown = now;
    for (const id of ["card", "card-below"]) this.drawInto(byId(id));
  }

  private drawInto(host: HTMLElement): void {
    const { studio } = this, { test } = studio;
    if (!test) return fill(host);
    const list = el("dl");
    for (const [name, choices, yours] of this.lines(test)) this.line(list, name, choices, yours);
    if (!test.isCase) for (const each of this.entries(test)) "take" in each ? this.entry(list, each) : this.line(list, ...each.line);
    for (const [name, choices, yours] of this.preparation(test)) this.line(list, name, choices, yours);
    const decided = Object.keys(test.settings.read).length > 0 || Object.keys(test.settings).length > 1, many = studio.alike(test).length + 1;
    const words = studio.stale ? "Bold: decided by you. Press F to fit again." : decided ? "Bold: decided by you." : "Found by the program. Click a line to decide otherwise, then fit.";
    const focused = host.contains(document.activeElement) ? document.activeElement!.getAttribute("aria-label") : null;
    fill(host, el("div", { class: "head" }, el("h2", {}, `How ${test.data} was read`)), list, el("p", { class: "said" }, words, many > 1 ? ` What is said of the rig is said of all ${many} files, but those that were told otherwise.` : ""));
    if (focused === null) return;
    const again = [...host.querySelectorAll<HTMLElement>("input, select")].find((e) => e.getAttribute("aria-label") === focused);
    again?.focus();
    if (again instanceof HTMLInputElement) again.select();
  }

  private line(list: HTMLElement, name: string, choices: Choice[], yours: boolean): void {
    const select = el("select", { class: `pick${yours ? " yours" : ""}`, "aria-label": name, change: () => choices[select.selectedIndex]?.change() }, ...choices.map((c) => el("option", {}, c.words)));
    select.selectedIndex = Math.max(0, choices.findIndex((c) => c.chosen));
    select.title = choices[select.selectedIndex]?.words ?? "";
    if (choices[select.selectedIndex]?.wanted) select.classList.add("wanted");
    list.append(el("dt", {}, name), el("dd", {}, select));
  }

  /** What is wrong is said at the box, and no longer when it is right; what was written stays to be mended. */
  private entry(list: HTMLElement, { name, value, example, wanted, yours, take }: Entry): void {
    const { studio, drafts } = this, draft = drafts.get(name), wrong = el("div", { class: "wrong", role: "alert" }, draft?.wrong ?? "");
    wrong.hidden = !draft;
    const box = el("input", {
      class: `entry${wanted && value === "" ? " wanted" : ""}${yours ? " yours" : ""}`, value: draft?.words ?? value, placeholder: `e.g. ${example}`, "aria-label": name, "aria-invalid": draft ? "true" : null, autocomplete: "off", spellcheck: "false",
      input: () => {
        if (wrong.hidden) return;
        const still = this.faultOf(() => take(box.value), false);
        wrong.textContent = still;
        wrong.hidden = still === "";
      },
      change: async () => {
        await studio.ready;
        const words = box.value.trim(), fault = words === value ? "" : this.faultOf(() => take(words), true);
        if (fault) drafts.set(name, { words: box.value, wrong: fault });
        else drafts.delete(name);
        studio.tell("card");
      },
    });
    list.append(el("dt", {}, name), el("dd", {}, box, wrong));
  }
  private trying = false;
  /** Why it cannot be taken; only tried, or taken as well. */
  private faultOf(take: () => void, forGood: boolean): string {
    this.trying = !forGood;
    try {
      take();
      return "";
    } catch (cause) {
      return withBoxes(messageOf(cause));
    } finally {
      this.trying = false;
    }
  }
  private decide(change: Partial<Settings>, read = false): void {
    if (this.trying) return;
    this.studio.remember();
    this.studio.decide(change);
    if (read) void this.studio.reread();
  }
  private decideReading(flag: keyof Settings["read"], value: string | undefined): void {
    const flags = { ...this.studio.test!.settings.read };
    if (value === undefined) delete flags[flag];
    else flags[flag] = value;
    this.decide({ read: flags }, true);
  }

  /** What a data file need not say: units of columns, the rig, the specimen. */
  private entries(test: Test): (Entry | { line: [string, Choice[], boolean] })[] {
    const { settings, read } = test, { studio } = this, all: (Entry | { line: [string, Choice[], boolean] })[] = [];
    const quantity = (name: string, key: "span" | "diameter" | "wall" | "width" | "height" | "stiffness" | "modulus" | "tipRadius", kind: QuantityKind, family: Kind, example: string, stated: number | null, wanted: boolean): void => {
      const value = settings[key] ?? stated, u = value ? unitFor(value, family, 2000) : null, error = key === "tipRadius" ? null : (`${key}Off` as const), off = error && settings[error];
      all.push({ name, example, wanted, yours: settings[key] !== undefined && !test.taken.has(key), value: value && u ? `${exactly(value, { ...u, command: u.name })}${off ? ` ± ${off}` : ""}` : "", take: (words) => {
        if (words === "" && (settings[key] !== undefined || stated === null)) return this.decide({ [key]: undefined, ...(error ? { [error]: undefined } : {}) });
        const told = error ? partsOf(words) : { value: words, off: null }, next = studio.model.quantity(told.value, kind);
        if (told.off !== null && !/^[\d.,]+\s*%$/.test(told.off)) studio.model.quantity(told.off, kind);
        this.decide({ [key]: next, ...(error ? { [error]: told.off ?? undefined } : {}) });
      } });
    };
    const reading = (name: string, flag: keyof Settings["read"], example: string, kind: QuantityKind | null): void => void all.push({ name, example, wanted: true, yours: settings.read[flag] !== undefined && !test.taken.has(flag), value: settings.read[flag] ?? "", take: (words) => {
      if (words !== "" && kind) studio.model.unit(words, kind);
      this.decideReading(flag, words === "" ? undefined : words);
    } });
    const column = (roles: string[]): ReadColumn | undefined => read?.columns.find((c) => roles.includes(c.role));
    const stage = column(["crosshead", "displacement", "deflection"]), force = column(["force"]);
    if (!read) {
      reading("stage", test.settings.displacement === "deflection" ? "deflection" : "crosshead", "2, or its name", null);
      reading("force", "force", "3, or its name", null);
    }
    if (!stage?.unit || settings.read["displacement-unit"] !== undefined) reading("stage unit", "displacement-unit", "mm", "a length");
    if (!settings.calibration && (!force?.unit || settings.read["force-unit"] !== undefined)) reading("force unit", "force-unit", "N", "a force");
    const { test: stated } = read ?? { test: { span: null, diameter: null, width: null, thickness: null } };
    const section = settings.section ?? (stated.width && !settings.diameter ? "rectangle" : "round");
    all.push({ line: ["section", (["round", "tube", "rectangle"] as const).map((each) => ({ words: each, change: () => this.decide({ section: each }), chosen: each === section })), settings.section !== undefined] });
    quantity("span", "span", "a length", "length", "1278 um", stated.span, true);
    if (section !== "rectangle") quantity("diameter", "diameter", "a length", "length", "34.8 um", stated.diameter, false);
    if (section === "tube") quantity("wall", "wall", "a length", "length", "0.5 mm", null, true);
    if (section === "rectangle") {
      quantity("width", "width", "a length", "length", "10 mm", stated.width, true);
      quantity("height", "height", "a length", "length", "2 mm", stated.thickness, true);
    }
    quantity("load train", "stiffness", "a stiffness", "stiffness", "90.65 N/m ± 0.3 N/m, or inf", null, true);
    quantity("modulus", "modulus", "a modulus", "modulus", "29.6 GPa", null, false);
    const supports = settings.supports ?? (settings.tipRadius ? "rollers" : undefined);
    all.push({ line: ["supports", [
      ...(supports ? [] : [{ words: "not said: edges", change: (): void => undefined, chosen: true }]),
      { words: "edges", change: () => this.decide({ supports: "edges", tipRadius: undefined }), chosen: supports === "edges" }, { words: "rollers", change: () => this.decide({ supports: "rollers" }), chosen: supports === "rollers" },
    ], settings.supports !== undefined && !test.taken.has("supports")] });
    if (supports === "rollers") quantity("radius", "tipRadius", "a length", "length", "5 mm", null, true);
    // Last, so that no box moves as it comes or goes.
    if (settings.calibration !== undefined || !read || (!settings.read["force-unit"] && /V/.test(force?.unit ?? "V")))
      all.push({ name: "volts", example: "222 N/V", wanted: false, yours: settings.calibration !== undefined, value: settings.calibration ?? "", take: (words) => this.decide({ calibration: words === "" ? undefined : words }, true) });
    return all;
  }

  private lines(test: Test): [string, Choice[], boolean][] {
    const { read, settings, fit } = test, lines: [string, Choice[], boolean][] = [], nothing = (): void => undefined;
    const again = (flag: keyof Settings["read"], value: string | undefined) => (): void => this.decideReading(flag, value);
    const step = (name: string): string => fit?.answer.preparation.find((s) => s.step === name)?.done ?? "";
    if (!test.isCase) {
      const { separator, decimal, encoding } = settings.read;
      lines.push(["format", [
        { words: !read ? "not read: choose" : `${read.format === "table" ? "" : `${read.format}: `}${MARKS[read.delimiter] ?? read.delimiter}, ${MARKS[read.decimal] ?? read.decimal}`, change: nothing, chosen: true },
        ...([[",", "."], [";", ","], ["tab", "."], ["tab", ","], [";", "."], ["space", "."]] as const).filter(([s, d]) => s !== separator || d !== decimal).map(([s, d]) => ({ words: `${MARKS[s]}, ${MARKS[d]}`, change: (): void => this.decide({ read: { ...settings.read, separator: s, decimal: d } }, true) })),
        ...(separator || decimal ? [{ words: "as found", change: (): void => {
          const { separator: _, decimal: __, ...rest } = settings.read;
          this.decide({ read: rest }, true);
        } }] : []),
      ], separator !== undefined || decimal !== undefined]);
      lines.push(["encoding", [
        ...(encoding ? [] : [{ words: read?.encoding ?? "as found", change: nothing, chosen: true }]),
        ...ENCODINGS.filter((name) => name !== read?.encoding || encoding).map((name) => ({ words: name, change: again("encoding", name), chosen: name === encoding })),
        ...(encoding ? [{ words: "as found", change: again("encoding", undefined) }] : []),
      ], encoding !== undefined]);
    }
    if (read && !test.isCase) {
      if (read.sheets && read.sheets.length > 1) lines.push(["sheet", read.sheets.map((name) => ({ words: name, change: (): void => this.decide({ sheet: name }, true), chosen: name === read.sheet })), settings.sheet !== undefined]);
      if (read.specimens.length > 1) lines.push(["specimen", read.specimens.map((s, i) => ({ words: `${i + 1}${s.name ? `: ${s.name}` : ""}, ${s.rows} rows`, change: (): void => this.decide({ specimen: String(i + 1) }, true), chosen: (settings.specimen ?? "1") === String(i + 1) })), settings.specimen !== undefined]);
      const moves = settings.displacement ?? (read.columns.some((c) => c.role === "crosshead") ? "crosshead" : read.columns.some((c) => c.role === "deflection") ? "deflection" : undefined);
      const column = (flag: "crosshead" | "deflection" | "force", title: string, roles: string[]): void => {
        const of = read.columns.filter((c) => roles.includes(c.role)), at = of.find((c) => c.role === flag) ?? of[0], open = flag === "crosshead" && !settings.read.crosshead && of.filter((c) => c.role === flag).length > 1;
        const words = (c: ReadColumn): string => `${c.name || `column ${c.number}`}${c.unit ? `, in ${c.unit}` : ""}`, told = settings.read[flag] !== undefined;
        lines.push([title, [
          { words: open ? `one of ${of.length}: choose` : at ? words(at) : "not found: choose", change: nothing, chosen: true, wanted: open || !at },
          ...read.columns.filter((c) => open || c !== at).map((c) => ({ words: words(c), change: again(flag, String(c.number)) })),
          ...(told ? [{ words: "as found", change: again(flag, undefined) }] : []),
        ], told]);
      };
      column(moves ?? "crosshead", "stage", ["crosshead", "displacement", "deflection"]);
      column("force", "force", ["force"]);
      const move = (displacement: "crosshead" | "deflection") => (): void => {
        const { crosshead, deflection, ...rest } = settings.read, chosen = crosshead ?? deflection;
        this.decide({ displacement, ...(chosen ? { read: { ...rest, [displacement]: chosen } } : {}) }, chosen !== undefined);
      };
      lines.push(["moves", [
        ...(moves ? [] : [{ words: "not said: choose", change: nothing, chosen: true, wanted: true }]),
        { words: "crosshead, less F/k", change: move("crosshead"), chosen: moves === "crosshead" },
        { words: "deflection", change: move("deflection"), chosen: moves === "deflection" },
      ], settings.displacement !== undefined && !test.taken.has("displacement")]);
    } else if (read) {
      lines.push(["case", [{ words: test.main, change: nothing, chosen: true }], false]);
      lines.push(["format", [{ words: `${MARKS[read.delimiter] ?? read.delimiter}, ${MARKS[read.decimal] ?? read.decimal}; ${read.rows} rows`, change: nothing, chosen: true }], false]);
      const columns = step("columns");
      if (columns) lines.push(["columns", [{ words: read.columns.map((c) => `${c.name}${c.unit ? ` in ${c.unit}` : ""}`).join(", "), change: nothing, chosen: true }], false]);
    }
    return lines;
  }

  /** What the program did to the record before it fitted. */
  private preparation(test: Test): [string, Choice[], boolean][] {
    const { settings, fit } = test, lines: [string, Choice[], boolean][] = [], decide = (change: Partial<Settings>) => (): void => this.decide(change);
    const contact = fit?.answer.contact;
    if (contact) {
      const then = JSON.parse(fit!.settings) as Settings;  // what was decided when it was fitted: what is found is that of then
      const taken = fit!.answer.parameters.contact_offset, u = unitFor(Math.abs(taken?.value ?? 0), "length");
      lines.push(["contact", [
        { words: contact.source === "first_point" ? "zero of the file" : `${contact.source}${taken ? `: ${significant(taken.value / u.factor, 3)} ${u.name}` : ""}`, change: () => undefined, chosen: then.contact === settings.contact },
        { words: "find", change: decide({ contact: "find" }), chosen: settings.contact === "find" }, { words: "first row", change: decide({ contact: "first row" }), chosen: settings.contact === "first row" },
        ...(settings.contact ? [{ words: "as found", change: decide({ contact: undefined }) }] : []),
      ], settings.contact !== undefined]);
      const zero = fit!.answer.preparation.find((s) => s.step === "zero"), sign = fit!.answer.preparation.find((s) => s.step === "sign");
      lines.push(["zero, sign", [
        { words: `${zero?.changed ? "found" : "kept"}, ${sign?.changed ? "reversed" : "kept"}`, change: () => undefined, chosen: then.zero === settings.zero && then.sign === settings.sign },
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
