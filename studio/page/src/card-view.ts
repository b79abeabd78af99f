// How a file was read, and what is stated of rig and specimen: a line each, which may be decided otherwise. What the program asks for stands by itself,
// one question at a time; where it has no answer, all that may be wrong stands there.

import { isWithdrawn, tellsFriction } from "./answer";
import type { ReadColumn } from "./answers";
import { add, byId, el, fill } from "./dom";
import type { QuantityKind } from "./engine";
import { exactly, unitFor, type Kind } from "./quantity";
import { partsOf, type Settings } from "./settings";
import { messageOf, type Studio } from "./studio";
import type { Test } from "./test";
import { inPageWords, questionOf, withBoxes } from "./words";

interface Choice { words: string; change?: () => void; chosen?: boolean }
interface Pick { name: string; choices: Choice[]; yours: boolean }
/** A box: what it is called, what it holds now, an example, and what is done with what is written; throws the sentence why not. */
interface Box { name: string; value: string; example: string; yours: boolean; take: (words: string) => void }
type Control = Pick | Box;

const MARKS: Record<string, string> = { ",": "comma", ";": "semicolon", "\t": "tab", tab: "tab", " ": "blanks", space: "blanks", ".": "point" };
const MOVES = ["crosshead", "deflection", "displacement"];  // roles of a column of displacement
const ENCODINGS = ["utf-8", "utf-16le", "utf-16be", "cp1252", "shift-jis"];
const WHEN_ASKED = ["displacement unit", "force unit", "span", "load train", "speed"];  // empty, they wait until the program asks for them

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
    const hosts = [byId("request"), byId("card")], focused = hosts.find((host) => host.contains(document.activeElement)), active = document.activeElement as HTMLInputElement, name = focused ? active.getAttribute("aria-label") : null, typed = active.value;
    const open = (title: string): boolean => [...document.querySelectorAll<HTMLDetailsElement>("#request details, #card details")].some((each) => each.open && each.textContent.startsWith(title)), wasOpen = { format: open("Format"), record: open("The record") };
    for (const host of hosts) fill(host);
    if (!test) return;
    const question = questionOf(test), fit = test.fit?.answer, reading = this.reading(test), stating = this.stating(test), all = [...reading, ...stating];
    if (fit && isWithdrawn(fit)) add(byId("request"), this.list(all), this.folded(test, wasOpen.format), this.record(test, wasOpen.record));
    else {
      const asked = question && all.find((each) => each.name === question.box);
      if (asked) this.ask(byId("request"), asked);
      const hidden = (each: Control): boolean => each === asked || ("take" in each && each.value === "" && WHEN_ASKED.includes(each.name)) || (!!fit && tellsFriction(fit) && "take" in each && each.value !== "" && test.fit!.parameters.some((parameter) => parameter.name.startsWith(each.name)));
      const stated = stating.filter((each) => !hidden(each));
      const decided = Object.keys(test.settings.read).length > 0 || Object.keys(test.settings).length > 1;
      if (!test.isCase || fit) fill(byId("card"), el("div", { class: "head" }, el("h2", {}, `How ${test.data} was read`)), this.list(reading.filter((each) => !hidden(each))), this.folded(test, wasOpen.format), this.record(test, wasOpen.record),
        ...(stated.length ? [el("div", { class: "head" }, el("h2", {}, "Specimen and rig"), fit ? null : el("span", { class: "note" }, "if known")), this.list(stated)] : []),
        decided ? el("p", { class: "note" }, "Bold: decided by you.") : null);
    }
    const controls = hosts.flatMap((host) => [...host.querySelectorAll<HTMLElement>("input, select, button")]);
    const same = controls.find((each) => each.getAttribute("aria-label") === name), isAsked = same && byId("request").contains(same);
    // After the last answer, the verdict.
    const again = focused?.id !== "request" ? same : question ? controls[0] : isAsked ? same : byId("verdict");
    if (!focused || !again) return;
    again.focus();
    if (!(again instanceof HTMLInputElement)) return;
    if (again.getAttribute("aria-label") === name) again.value = typed;
    again.select();
  }

  // ---- controls
  private list(controls: Control[]): HTMLElement {
    return el("dl", {}, ...controls.flatMap((each) => [el("dt", {}, each.name), el("dd", {}, ..."take" in each ? this.box(each) : [this.pick(each)])]));
  }
  /** What the program asks for: buttons where there are few answers, else a box. */
  private ask(host: HTMLElement, control: Control): void {
    if ("take" in control) {
      const [box, wrong] = this.box(control);
      return fill(host, el("div", { class: "ask" }, box, el("button", { class: "button primary", click: () => box.dispatchEvent(new Event("change")) }, "Next")), wrong);
    }
    const choices = control.choices.filter(({ change }) => change);
    fill(host, el("div", { class: "ask" }, ...choices.map(({ words, change }) => el("button", { class: "button outlined", "aria-label": words, click: change }, words))));
  }
  private pick({ name, choices, yours }: Pick): HTMLElement {
    const select = el("select", { class: `pick${yours ? " yours" : ""}`, "aria-label": name, change: () => choices[select.selectedIndex]?.change?.() }, ...choices.map((c) => el("option", {}, c.words)));
    select.selectedIndex = Math.max(0, choices.findIndex((c) => c.chosen));
    select.title = choices[select.selectedIndex]?.words ?? "";
    return select;
  }
  /** What is wrong is said at the box, and no longer when it is right; what was written stays to be mended. */
  private box({ name, value, example, yours, take }: Box): [HTMLInputElement, HTMLElement] {
    const { studio, drafts } = this, draft = drafts.get(name), wrong = el("div", { class: "wrong", role: "alert" }, draft?.wrong ?? "");
    wrong.hidden = !draft;
    const box = el("input", {
      class: `entry${yours ? " yours" : ""}`, value: draft?.words ?? value, placeholder: `e.g. ${example}`, "aria-label": name, "aria-invalid": draft ? "true" : null, autocomplete: "off", spellcheck: "false",
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
    return [box, wrong];
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
  private decide(change: Partial<Settings>): void {
    if (this.trying) return;
    this.studio.remember();
    this.studio.decide(change);
    void this.studio.answer();
  }
  private decideReading(flag: keyof Settings["read"], value: string | undefined): void {
    const flags = { ...this.studio.test!.settings.read };
    if (value === undefined) delete flags[flag];
    else flags[flag] = value;
    this.decide({ read: flags });
  }

  // ---- the file
  private folded(test: Test, open: boolean): HTMLElement | null {
    const { read, settings } = test;
    if (test.isCase) return null;
    const { separator, decimal, encoding } = settings.read, { separator: _, decimal: __, ...rest } = settings.read;
    const format: Pick = { name: "format", yours: separator !== undefined || decimal !== undefined, choices: [
      { words: read ? `${read.format === "table" ? "" : `${read.format}: `}${MARKS[read.delimiter] ?? read.delimiter}, ${MARKS[read.decimal] ?? read.decimal}` : "not read", chosen: true },
      ...([[",", "."], [";", ","], ["tab", "."], ["tab", ","], [";", "."], ["space", "."]] as const).filter(([s, d]) => s !== separator || d !== decimal).map(([s, d]) => ({ words: `${MARKS[s]}, ${MARKS[d]}`, change: (): void => this.decide({ read: { ...settings.read, separator: s, decimal: d } }) })),
      ...(separator || decimal ? [{ words: "as found", change: (): void => this.decide({ read: rest }) }] : []),
    ] };
    const encodings: Pick = { name: "encoding", yours: encoding !== undefined, choices: [
      ...(encoding ? [] : [{ words: read?.encoding ?? "as found", chosen: true }]),
      ...ENCODINGS.filter((name) => name !== read?.encoding || encoding).map((name) => ({ words: name, change: (): void => this.decideReading("encoding", name), chosen: name === encoding })),
      ...(encoding ? [{ words: "as found", change: (): void => this.decideReading("encoding", undefined) }] : []),
    ] };
    return this.details("Format and encoding", open || !read, this.list([format, encodings]));
  }

  /** Sheet, specimen and the columns, in the roles that the program gives them. */
  private reading(test: Test): Control[] {
    const { read, settings } = test, controls: Control[] = [];
    if (test.isCase) return [];
    if (!read) return (["displacement", "force"] as const).map((name) => {
      const flag = name === "force" ? "force" : settings.displacement ?? "crosshead";
      return { name, example: "2, or its name", yours: settings.read[flag] !== undefined, value: settings.read[flag] ?? "", take: (words) => this.decideReading(flag, words === "" ? undefined : words) };
    });
    if (read.sheets && read.sheets.length > 1) controls.push({ name: "sheet", yours: settings.sheet !== undefined, choices: read.sheets.map((name) => ({ words: name, change: (): void => this.decide({ sheet: name }), chosen: name === read.sheet })) });
    if (read.specimens.length > 1) controls.push({ name: "specimen", yours: settings.specimen !== undefined, choices: read.specimens.map((s, i) => ({ words: `${i + 1}${s.name ? `: ${s.name}` : ""}, ${s.rows} rows`, change: (): void => this.decide({ specimen: String(i + 1) }), chosen: (settings.specimen ?? "1") === String(i + 1) })) });
    const words = (c: ReadColumn): string => `${c.name || `column ${c.number}`}${c.unit ? `, in ${c.unit}` : ""}`;
    const column = (name: string, flag: "crosshead" | "deflection" | "force", role: string): void => {
      const of = read.columns.filter((c) => c.role === role), told = settings.read[flag], at = of.length === 1 ? of[0] : undefined;
      controls.push({ name, yours: told !== undefined, choices: [
        { words: at ? words(at) : of.length ? `one of ${of.length}` : "not found", chosen: true }, ...read.columns.filter((c) => c !== at).map((c) => ({ words: words(c), change: (): void => this.decideReading(flag, String(c.number)) })),
        ...(told !== undefined ? [{ words: "as found", change: (): void => this.decideReading(flag, undefined) }] : []),
      ] });
    };
    const has = (role: string): boolean => read.columns.some((c) => c.role === role), both = has("crosshead") && has("deflection");
    if (both) for (const role of ["crosshead", "deflection"] as const) column(role, role, role);
    else column("displacement", settings.displacement ?? (has("deflection") ? "deflection" : "crosshead"), ["crosshead", "deflection"].find(has) ?? "displacement");
    column("force", "force", "force");
    if (has("displacement") || settings.displacement) {
      const move = (displacement: "crosshead" | "deflection") => (): void => {
        const { crosshead, deflection, ...rest } = settings.read, chosen = crosshead ?? deflection;
        this.decide({ displacement, ...(chosen ? { read: { ...rest, [displacement]: chosen } } : {}) });
      };
      controls.push({ name: "measures", yours: settings.displacement !== undefined && !test.taken.has("displacement"), choices: [
        ...(settings.displacement ? [] : [{ words: "not stated", chosen: true }]), ...(["crosshead", "deflection"] as const).map((each) => ({ words: each, change: move(each), chosen: settings.displacement === each })),
      ] });
    }
    const unit = (name: string, flag: keyof Settings["read"], example: string, kind: QuantityKind): void => void controls.push({ name, example, yours: settings.read[flag] !== undefined && !test.taken.has(flag), value: settings.read[flag] ?? "", take: (words) => {
      if (words !== "") this.studio.model.unit(words, kind);
      this.decideReading(flag, words === "" ? undefined : words);
    } });
    unit("displacement unit", "displacement-unit", "mm", "a length");
    if (!settings.calibration) unit("force unit", "force-unit", "N", "a force");
    return controls;
  }

  // ---- what a data file need not say: the rig, the specimen; of a case, what its measured rig is changed by
  private stating(test: Test): Control[] {
    const { settings, read } = test, { studio } = this, all: Control[] = [], text = test.isCase ? test.fit?.text : null;
    const quantity = (name: string, key: "span" | "diameter" | "wall" | "width" | "height" | "stiffness" | "modulus" | "tipRadius", kind: QuantityKind, family: Kind, example: string, stated: number | null): void => {
      const value = settings[key] ?? stated, u = value ? unitFor(value, family, 2000) : null, error = key === "tipRadius" ? null : (`${key}Off` as const), off = error && settings[error];
      all.push({ name, example, yours: settings[key] !== undefined && !test.taken.has(key), value: value && u ? `${exactly(value, { ...u, command: u.name })}${off ? ` ± ${off}` : ""}` : "", take: (words) => {
        if (key === "modulus" && words === "fit") words = "";  // of the record
        if (words === "" && (settings[key] !== undefined || stated === null)) return this.decide({ [key]: undefined, ...(error ? { [error]: undefined } : {}) });
        const told = error ? partsOf(words) : { value: words, off: null }, next = studio.model.quantity(told.value, kind);
        if (told.off !== null && !/^[\d.,]+\s*%$/.test(told.off)) studio.model.quantity(told.off, kind);
        this.decide({ [key]: next, ...(error ? { [error]: told.off ?? undefined } : {}) });
      } });
    };
    if (test.isCase) {
      if (!test.fit) return [];
      const section = text?.words("specimen.height") ? "height" : "diameter";
      quantity("span", "span", "a length", "length", "1278 um", text?.quantity("rig.span") ?? null);
      quantity(section, section, "a length", "length", "34.8 um", text?.quantity(`specimen.${section}`) ?? null);
      quantity("load train", "stiffness", "a stiffness", "stiffness", "90.65 N/m, or inf", text?.quantity("rig.stiffness") ?? null);
      quantity("radius", "tipRadius", "a length", "length", "5 mm", text?.quantity("rig.roller_radius") ?? null);
      return all;
    }
    if (settings.speed !== undefined || (read && !read.columns.some(({ role }) => MOVES.includes(role))))
      all.push({ name: "speed", example: "1 mm/min", yours: settings.speed !== undefined && !test.taken.has("speed"), value: settings.speed ?? "", take: (words) => {
        if (words !== "") this.studio.model.quantity(words, "a speed");
        this.decide({ speed: words === "" ? undefined : words });
      } });
    const { test: stated } = read ?? { test: { span: null, diameter: null, width: null, thickness: null } };
    const section = settings.section ?? (stated.width && !settings.diameter ? "rectangle" : "round");
    quantity("span", "span", "a length", "length", "1278 um", stated.span);
    quantity("load train", "stiffness", "a stiffness", "stiffness", "90.65 N/m ± 0.3 N/m, or inf", null);
    all.push({ name: "section", yours: settings.section !== undefined, choices: (["round", "tube", "rectangle"] as const).map((each) => ({ words: each, change: () => this.decide({ section: each }), chosen: each === section })) });
    if (section !== "rectangle") quantity("diameter", "diameter", "a length", "length", "34.8 um", stated.diameter);
    if (section === "tube") quantity("wall", "wall", "a length", "length", "0.5 mm", null);
    if (section === "rectangle") {
      quantity("width", "width", "a length", "length", "10 mm", stated.width);
      quantity("height", "height", "a length", "length", "2 mm", stated.thickness);
    }
    quantity("modulus", "modulus", "a modulus", "modulus", "29.6 GPa", null);
    const supports = settings.supports ?? (settings.tipRadius ? "rollers" : undefined);
    all.push({ name: "supports", yours: settings.supports !== undefined && !test.taken.has("supports"), choices: [
      ...(supports ? [] : [{ words: "not stated", chosen: true }]),
      { words: "edges", change: () => this.decide({ supports: "edges", tipRadius: undefined }), chosen: supports === "edges" }, { words: "rollers", change: () => this.decide({ supports: "rollers" }), chosen: supports === "rollers" },
    ] });
    if (supports === "rollers") quantity("radius", "tipRadius", "a length", "length", "5 mm", null);
    // Last, so that no box moves as it comes or goes.
    if (settings.calibration !== undefined || !read || (!settings.read["force-unit"] && /V/.test(read.columns.find((c) => c.role === "force")?.unit ?? "")))
      all.push({ name: "volts", example: "222 N/V", yours: settings.calibration !== undefined, value: settings.calibration ?? "", take: (words) => this.decide({ calibration: words === "" ? undefined : words }) });
    return all;
  }

  /** What the program did to the record before it fitted, in its words, and what may be decided otherwise. */
  private record(test: Test, open: boolean): HTMLElement | null {
    const { settings, fit } = test;
    if (!fit) return null;
    const pick = (name: string, key: "contact" | "zero" | "sign" | "failure", values: readonly string[]): Pick => ({ name, yours: settings[key] !== undefined, choices: [
      { words: "as found", chosen: settings[key] === undefined, change: () => this.decide({ [key]: undefined }) },
      ...values.map((value) => ({ words: value === "none" ? "keep all rows" : value, change: (): void => this.decide({ [key]: value }), chosen: settings[key] === value })),
    ] });
    return this.details("The record", open, el("ul", {}, ...fit.answer.preparation.map(({ done }) => el("li", {}, inPageWords(done, test)))),
      this.list([pick("contact", "contact", ["find", "first row"]), pick("zero", "zero", ["find", "keep"]), pick("sign", "sign", ["find", "keep", "reverse"]), pick("last row", "failure", ["none"])]));
  }
  private details(title: string, open: boolean, ...content: Node[]): HTMLElement {
    const details = el("details", {}, el("summary", {}, title), ...content);
    details.open = open;
    return details;
  }
}
