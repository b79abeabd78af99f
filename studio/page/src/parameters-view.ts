// Rows of parameters: lock, name, a handle to drag, number, unit and the 95 % interval of the fit; the fit button and what it says.

import { isWithdrawn } from "./answer";
import { byId, el, fill, plain, rich, svg } from "./dom";
import { isAllowed, placeOf, shown, valueAt, type Key, type Parameter } from "./parameters";
import { parseQuantity, significant, unitFor } from "./quantity";
import { partsOf } from "./settings";
import type { Studio } from "./studio";

const REACH = 240;  // [px] that a handle is dragged from one end of its range to the other
const OFF = { L: "spanOff", kc: "stiffnessOff", D: "diameterOff" } as const;  // what is measured may be stated with its uncertainty

interface Row { parameter: Parameter; root: HTMLElement; handle: HTMLElement; number: HTMLInputElement }

const padlock = (held: boolean): SVGElement => held
  ? svg("svg", { width: 12, height: 13, viewBox: "0 0 12 13", "aria-hidden": "true" }, svg("rect", { x: 1.5, y: 6, width: 9, height: 6.5, rx: 1, fill: "currentColor" }), svg("path", { d: "M3.500 6V4a2.500 2.500 0 0 1 5 0v2", fill: "none", stroke: "currentColor", "stroke-width": 1.4 }))
  : svg("svg", { width: 12, height: 13, viewBox: "0 0 12 13", "aria-hidden": "true" }, svg("rect", { x: 2, y: 6.5, width: 8, height: 5.5, rx: 1, fill: "none", stroke: "currentColor", "stroke-width": 1.2 }), svg("path", { d: "M3.500 6V3.600a2.500 2.500 0 0 1 4.900-.7", fill: "none", stroke: "currentColor", "stroke-width": 1.2 }));

export class ParametersView {
  private rows: Row[] = [];
  private built: unknown[] = [];
  private grip: { x: number; place: number; moved: boolean } | null = null;

  constructor(private readonly studio: Studio) {
    byId("fit").addEventListener("click", () => this.pressFit());
    byId("reset").addEventListener("click", () => studio.reset());
  }
  pressFit(): void {
    if (this.studio.isBusy(this.studio.test)) this.studio.cancelFit();
    else void this.studio.runFit();
  }

  draw(): void {
    const { studio } = this, { fit, values, test } = studio, host = byId("parameters");
    if (!fit || !values) {
      this.built = [];
      this.rows = [];
      return fill(host);
    }
    const needed = [fit, studio.wave, test?.settings.heldStiffness !== undefined];
    if (needed.some((value, i) => value !== this.built[i])) this.build(host, needed);
    for (const row of this.rows) this.show(row);
  }

  private build(host: HTMLElement, needed: unknown[]): void {
    const { studio } = this, fit = studio.fit!;
    const focused = (document.activeElement as HTMLElement | null)?.dataset?.["focus"];
    this.built = needed;
    this.rows = [];
    const children: Node[] = [];
    let group = "";
    for (const parameter of fit.parameters) {
      if (parameter.group !== group) {
        group = parameter.group;
        children.push(this.head(parameter.group));
      }
      if (parameter.group === "Wave" && !studio.wave) continue;
      const row = this.row(parameter);
      this.rows.push(row);
      children.push(row.root);
    }
    fill(host, ...children);
    if (focused) host.querySelector<HTMLElement>(`[data-focus="${CSS.escape(focused)}"]`)?.focus();
  }

  private head(group: Parameter["group"]): HTMLElement {
    const { studio } = this, fit = studio.fit!;
    const note = el("span", { class: "note" });
    const head = el("div", { class: "group" }, group);
    if (group === "Friction") note.textContent = "95 % interval of the fit";
    if (group === "Wave") {
      head.append(el("button", { class: "switch", role: "switch", "aria-checked": String(studio.wave), "aria-label": "Wave", "data-focus": "wave", click: () => studio.setWave(!studio.wave) }));
      note.textContent = studio.wave ? (fit.wave ? "detected" : "added by hand") : fit.wave ? "off: it was detected" : "off: none detected";
    }
    if (group === "Rig") note.textContent = "stated";
    head.append(note);
    return head;
  }

  private row(p: Parameter): Row {
    const { studio } = this, fit = studio.fit!, name = plain(p.name), held = p.lock === "measured" || (p.lock === "choice" && studio.test?.settings.heldStiffness !== undefined);
    const lock = p.lock === "choice"
      ? el("button", { class: "lock", "data-focus": `lock-${p.key}`, "aria-pressed": String(held), "aria-label": `Hold ${name} in the fit`, title: held ? "Held in the fit" : "Found by the fit", click: () => this.hold(p) }, padlock(held))
      : el("span", { class: "lock", role: "img", "aria-label": held ? "held in the fit" : "found by the fit", title: held ? "Measured: the fit holds it" : "Found by the fit" }, padlock(held));
    const handle = el("span", { class: "drag", role: "slider", tabindex: 0, "data-key": p.key, "data-focus": `drag-${p.key}`, "aria-label": name, "aria-valuemin": 0, "aria-valuemax": 100, title: "Drag to change",
      pointerdown: (event: PointerEvent) => {
        event.preventDefault();
        handle.focus();
        handle.setPointerCapture(event.pointerId);
        this.grip = { x: event.clientX, place: placeOf(p, studio.values![p.key]), moved: false };
      },
      pointermove: (event: PointerEvent) => {
        if (!this.grip || event.clientX === this.grip.x) return;
        if (!this.grip.moved) studio.remember();
        this.grip.moved = true;
        this.toPlace(p, this.grip.place + (event.clientX - this.grip.x) / REACH, true);
      },
      pointerup: () => this.letGo(), pointercancel: () => this.letGo(),
      keydown: (event: KeyboardEvent) => {
        const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (!by) return;
        event.preventDefault();
        event.stopPropagation();
        studio.remember();
        this.toPlace(p, placeOf(p, studio.values![p.key]) + (by * (event.shiftKey ? 10 : 1)) / 100, false);
      },
    }, svg("svg", { width: 14, height: 10, viewBox: "0 0 14 10", "aria-hidden": "true" }, svg("path", { d: "M4 1 1 5l3 4M10 1l3 4-3 4M5.500 2v6M8.500 2v6", fill: "none", stroke: "currentColor", "stroke-width": 1.3 })));
    const number = el("input", { class: "number", inputmode: "decimal", "data-key": p.key, "data-focus": `number-${p.key}`, "aria-label": p.unitWords ? `${name} in ${plain(p.unitWords)}` : name, autocomplete: "off", spellcheck: "false",
      change: () => this.enter(p, number),
      keydown: (event: KeyboardEvent) => {
        if (event.key === "Enter") this.enter(p, number);
        if (event.key === "Escape") this.show(row);
      },
    });
    const title = el("span", { class: "name", title: "double-click: back to the fit", dblclick: () => {
      if (!studio.isChanged(p.key)) return;
      studio.remember();
      studio.set(p.key, fit.fitted[p.key]);
    } }, rich(p.name));
    const interval = !p.interval ? "" : p.key === "phi" && p.interval[1] - p.interval[0] >= 2 * Math.PI ? "any" : p.interval.map((value) => shown(p, value).replace("-", "−")).join(p.interval[0] < 0 ? " to " : "–");
    const root = el("div", { class: `parameter${held ? " held" : ""}`, "data-parameter": p.key }, lock, title, handle, number, el("span", { class: "unit" }, rich(p.unitWords)), el("span", { class: "note interval" }, interval));
    const row: Row = { parameter: p, root, handle, number };
    return row;
  }
  private toPlace(p: Parameter, place: number, live: boolean): void {
    this.studio.set(p.key, this.rounded(p, valueAt(p, Math.max(0, Math.min(1, place)))), live);
  }
  private letGo(): void {
    this.grip = null;
    this.studio.settle();
  }

  private show(row: Row): void {
    const { studio } = this, p = row.parameter, value = studio.values![p.key], words = shown(p, value);
    row.handle.setAttribute("aria-valuenow", String(Math.round(100 * placeOf(p, value))));
    row.handle.setAttribute("aria-valuetext", `${words} ${plain(p.unitWords)}`.trim());
    if (document.activeElement !== row.number || row.number.value === "" || parseQuantity(row.number.value, p.unit.command) !== value) row.number.value = words;
    row.root.classList.toggle("changed", studio.isChanged(p.key));
  }

  /** To the digits that are shown; the value of the fit where it reads the same, so that it comes home exactly. */
  private rounded(p: Parameter, value: number): number {
    const fitted = this.studio.fit!.fitted[p.key], words = shown(p, value);
    return words === shown(p, fitted) ? fitted : Number(words) * p.unit.factor;
  }

  private enter(p: Parameter, number: HTMLInputElement): void {
    const { studio } = this, old = studio.values![p.key], { value: words, off } = partsOf(number.value), value = parseQuantity(words, p.unit.command);
    if (number.value === shown(p, old)) return;
    if (value === null || !isAllowed(p, value)) {
      const range = p.logarithmic ? `between ${significant(p.low / 100 / p.unit.factor, 2)} and ${significant((p.high * 100) / p.unit.factor, 2)}` : p.key === "phi" ? "that is an angle" : `from 0 to ${p.key === "amp" ? 1 : p.key === "R" ? significant((p.high * 10) / p.unit.factor, 2) : 3}`;
      studio.report(`${plain(p.name)}: “${number.value.slice(0, 40)}” is no number ${range}${p.unit.name ? ` ${p.unit.name}` : ""}. The old value stays.`);
      number.value = shown(p, old);
      return;
    }
    studio.remember();
    const stated = OFF[p.key as keyof typeof OFF];
    if (off !== null && stated !== undefined) studio.decide({ [stated]: off });
    studio.set(p.key, p.key === "kc" ? value : this.rounded(p, value));
  }

  private hold(p: Parameter): void {
    const { studio } = this, { test, values } = studio;
    if (!test || !values) return;
    studio.remember();
    studio.decide({ heldStiffness: test.settings.heldStiffness === undefined ? values[p.key as Key] : undefined });
  }

  /** Fit or Cancel in place, and what the last fit missed by. */
  drawFit(): void {
    const { studio } = this, { fitting, fit } = studio, button = byId<HTMLButtonElement>("fit"), said = byId("fit-said"), bar = document.querySelector<HTMLElement>("#fit-bar span")!;
    const busy = fitting !== null && fitting.test === studio.test, waits = studio.test !== null && studio.waiting.includes(studio.test);
    button.textContent = busy || waits ? "Cancel" : "Fit";
    button.disabled = !studio.test;
    byId<HTMLButtonElement>("reset").disabled = !studio.changed;
    const others = studio.waiting.length > (waits ? 1 : 0) ? `; ${studio.waiting.length - (waits ? 1 : 0)} more wait` : "";
    bar.style.width = `${busy ? (/\d+(?= %)/.exec(fitting.said)?.[0] ?? 0) : 0}%`;
    const off = (newtons: number): string => {
      const u = unitFor(newtons, "force");
      return `${significant(newtons / u.factor, 2)} ${u.name}`;
    };
    said.textContent = busy ? `${fitting.said || "Fitting…"}${others}` : waits ? `Waits for ${fitting?.test.name ?? "the next"}` : fitting ? `Fitting ${fitting.test.name}${others}` : studio.reading ? "Reading…"
      : !fit ? "" : studio.stale ? "Settings changed: press Fit" : isWithdrawn(fit.answer) ? "" : studio.changed ? `By hand: residual ${off(studio.rms)}; fit: ${off(fit.answer.residual_rms ?? NaN)}` : "Fitted";
  }
}
