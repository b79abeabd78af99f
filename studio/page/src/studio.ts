// The state of the studio and what may be done to it. Knows no elements: views listen and draw.

import type { Loading, Mechanics, Program, Rig } from "./engine";
import type { Drop, Sensitivity } from "./answers";
import { History } from "./history";
import { forceAt, misfit, Model, type Curve } from "./model";
import { frictionOf, type Key, type Values } from "./parameters";
import type { Settings } from "./settings";
import type { Fit, Test } from "./test";

export type Topic = "tests" | "card" | "answer" | "moment" | "model" | "parameters" | "rows" | "programme" | "pins" | "fitting" | "progress" | "tour" | "error" | "axis" | "theme" | "view" | "doubted";
export interface Pin { name: string; on: boolean; curve: Curve }
interface State { test: Test; values: Values | null; wave: boolean; settings: Settings; programme: number[] | null; fit: Fit | null }

export interface Moment { row: number; stage: number; deflection: number; force: number; mu: number; muError: number; drawn: number; used: boolean; drop: { drop: Drop; number: number } | null }

const SLIDERS: Readonly<Record<string, Key>> = { load_train: "kc", span: "L", support_radius: "R" };  // of what is measured of the rig
const NEAR = 0.05;  // [1] of a value, or of the span: as far as first order is told

const SOON = 300;  // [ms] when the Worker has begun to compute, and its code is compiled
const REST = 250;  // [ms] after which a slider that is held still is taken to rest

export class Studio {
  readonly tests: Test[] = [];
  test: Test | null = null;
  values: Values | null = null;  // of the sliders
  wave = false;
  programme: number[] | null = null;  // [m] stage positions to try, where it is not that of the record
  row = 1;
  axis: "deflection" | "stage" = "deflection";
  pins: Pin[] = [];
  error = "";
  fitting: { test: Test; line: string; since: number } | null = null;
  lastFit = 1000;  // [ms] that the last one took: what the next is measured by
  step = -1;  // of the first visit; -1: none
  bandReady = false;  // the band of the draws is computed once the page is at rest
  doubted: Sensitivity | null = null;  // what friction hangs on, pointed at: as if it were stated larger by what it may be off
  tried: number | null = null;  // a state of the programme that is marked instead of a row
  model!: Model;  // from `ready` on, and so with every fit
  readonly ready: Promise<void>;
  rig: Rig | null = null;            // at the values of the sliders
  loading: Loading | null = null;    // the model over the record
  programmed: Loading | null = null; // and over the programme, if there is one
  residual: Float64Array = new Float64Array(0);
  rms = NaN;
  private readonly history = new History<State>();
  private listeners: ((topics: ReadonlySet<Topic>) => void)[] = [];
  private dirty = new Set<Topic>();
  private frame = 0;
  private ahead = false;     // a model was computed before the frame that shows it
  private computed = false;  // and is that of the values as they stand

  /** A fit is under way while the mechanics are still opened. */
  constructor(readonly program: Program, mechanics: Promise<Mechanics>) {
    this.ready = mechanics.then((opened) => void (this.model = new Model(opened)));
    this.ready.catch(() => undefined);  // said by each fit
  }

  // ---- telling the views, once a frame
  listen(listener: (topics: ReadonlySet<Topic>) => void): void {
    this.listeners.push(listener);
  }
  tell(...topics: Topic[]): void {
    topics.forEach((topic) => this.dirty.add(topic));
    if (topics.includes("model")) this.computed = false;
    if (!this.frame) this.frame = requestAnimationFrame(() => this.flush());
  }
  flush(): void {
    if (this.frame) cancelAnimationFrame(this.frame);
    this.frame = 0;
    const topics = this.dirty;
    this.dirty = new Set();
    if (topics.has("model") && !this.computed) this.recompute();
    this.computed = false;
    this.ahead = false;
    for (const listener of this.listeners) listener(topics);
  }
  private recompute(): void {
    const fit = this.fit, { values } = this;
    this.loading = this.programmed = this.rig = null;
    this.residual = new Float64Array(0);
    if (!fit || !values || fit.answer.status !== "ok") return;
    try {
      const rig = this.model.rig(fit, values, this.wave);
      this.rig = rig;
      this.loading = this.model.monotone(fit, rig, this.live);
      ({ rms: this.rms, residual: this.residual } = misfit(fit, this.loading));
      if (this.programme) this.programmed = this.model.loading(rig, this.programme, this.live);
    } catch (cause) {
      this.report(`The model has no curve at these values: ${messageOf(cause)}`);
    }
  }

  // ---- errors: one line, the last good state stays
  report(words: string): void {
    this.error = words;
    this.tell("error");
  }

  // ---- tests
  get fit(): Fit | null {
    return this.test?.fit ?? null;
  }
  async open(test: Test): Promise<void> {
    if (test.isCase) {
      // A case says all that a fit needs: its answer first, then the rows as they stand in the file.
      this.tests.push(test);
      this.select(test);
      await this.runFit();
      await test.open(this.program).catch(() => undefined);  // what is wrong with the data the fit has said
      return this.tell("card", "rows", "tests");
    }
    try {
      await test.open(this.program);
    } catch (cause) {
      return this.report(`${test.data}: ${messageOf(cause)}`);
    }
    this.tests.push(test);
    this.select(test);
    const missing = missingOf(test);
    if (missing.length) {
      this.report(`${test.data} does not say ${list(missing)}. Enter ${missing.length === 1 ? "it" : "them"} under “How ${test.data} was read”, then press Fit.`);
      return;
    }
    await this.runFit();
  }
  select(test: Test | null): void {
    this.test = test;
    this.programme = null;
    this.tried = null;
    this.doubted = null;
    this.takeFit();
    const fit = this.fit;
    if (fit) this.row = fit.answer.drops.reduce((best, d) => (d.force_fall > best.fall ? { fall: d.force_fall, row: d.row_before } : best), { fall: 0, row: fit.answer.measurement.last_row }).row;
    else this.row = 1;
    this.tell("tests", "card", "answer", "moment", "model", "parameters", "rows", "programme", "error", "axis", "fitting");
  }
  /** Sliders to the values of the fit. */
  private takeFit(): void {
    const fit = this.fit;
    this.values = fit ? { ...fit.fitted } : null;
    this.wave = fit?.wave ?? false;
  }
  remove(test: Test): void {
    const at = this.tests.indexOf(test);
    if (at < 0) return;
    this.tests.splice(at, 1);
    if (this.test === test) this.select(this.tests[Math.min(at, this.tests.length - 1)] ?? null);
    this.tell("tests");
  }
  next(by: 1 | -1): void {
    const at = this.test ? this.tests.indexOf(this.test) + by : -1;
    if (this.tests[at]) this.select(this.tests[at]!);
  }

  // ---- changes, each of which can be taken back
  private get state(): State | null {
    const { test } = this;
    return test && { test, values: this.values && { ...this.values }, wave: this.wave, settings: structuredClone(test.settings), programme: this.programme && [...this.programme], fit: test.fit };
  }
  private restore(state: State | null): void {
    if (!state || !this.tests.includes(state.test)) return;
    this.test = state.test;
    Object.assign(this, { values: state.values && { ...state.values }, wave: state.wave, programme: state.programme && [...state.programme] });
    state.test.settings = structuredClone(state.settings);
    state.test.fit = state.fit;
    this.tell("tests", "card", "answer", "moment", "model", "parameters", "rows", "programme", "fitting");
  }
  /** Call before a change; a drag calls it once. */
  remember(): void {
    const state = this.state;
    if (state) this.history.push(state);
    this.tell("fitting");
  }
  undo(): void {
    const now = this.state;
    if (now) this.restore(this.history.undo(now));
  }
  redo(): void {
    const now = this.state;
    if (now) this.restore(this.history.redo(now));
  }
  get canUndo(): boolean {
    return this.history.canUndo;
  }
  get canRedo(): boolean {
    return this.history.canRedo;
  }
  set(key: Key, value: number, live = false): void {
    if (!this.values) return;
    this.cancelFit();
    this.values[key] = value;
    this.live = live;
    clearTimeout(this.resting);
    if (live) this.resting = window.setTimeout(() => this.settle(), REST);
    this.tell("model", "parameters", "moment");
    // At once, not when the frame begins: the time until then is used. Of several changes in one frame the last is computed with the frame.
    this.computed = !this.ahead;
    if (this.computed) this.recompute();
    this.ahead = true;
  }
  /** A slider was let go: the model in full. */
  settle(): void {
    clearTimeout(this.resting);
    if (!this.live) return;
    this.live = false;
    this.tell("model");
  }
  private live = false;
  private resting = 0;
  setWave(on: boolean): void {
    this.remember();
    this.wave = on;
    this.tell("model", "parameters", "moment");
  }
  reset(): void {
    if (!this.changed) return;
    this.remember();
    this.takeFit();
    this.tell("model", "parameters", "moment");
  }
  isChanged(key: Key): boolean {
    const fit = this.fit;
    return !!fit && !!this.values && this.values[key] !== fit.fitted[key] && (this.wave || !["amp", "lam", "phi"].includes(key));
  }
  get changed(): boolean {
    const fit = this.fit;
    return !!fit && !!this.values && (this.wave !== fit.wave || (Object.keys(this.values) as Key[]).some((key) => this.isChanged(key)));
  }
  decide(change: Partial<Settings>): void {
    if (!this.test) return;
    Object.assign(this.test.settings, change);
    for (const [key, value] of Object.entries(change)) if (value === undefined) delete this.test.settings[key as keyof Settings];
    this.tell("card", "rows", "fitting", "parameters");
  }
  /** Reads the file again, by the flags that were decided; a fit is asked for by hand. */
  async reread(): Promise<void> {
    const { test } = this;
    if (!test) return;
    try {
      await test.open(this.program);
    } catch (cause) {
      this.report(`${test.name}: ${messageOf(cause)}`);
    }
    this.tell("card", "rows", "view");
  }
  /** Settings were changed since the last fit. */
  get stale(): boolean {
    const { test } = this;
    return !!test?.fit && JSON.stringify(test.settings) !== test.fit.settings;
  }
  setProgramme(programme: number[] | null): void {
    this.programme = programme;
    this.tried = null;
    this.tell("model", "programme");
  }

  // ---- the fit, in the Worker
  async runFit(): Promise<void> {
    const { test, values } = this;
    if (!test || this.fitting) return;
    if (test.fit && values) this.holdMeasured(test, test.fit, values);
    const fitting = { test, line: "", since: performance.now() };
    this.fitting = fitting;
    const clock = setInterval(() => this.tell("progress"), 200);
    this.error = "";
    this.tell("fitting", "error");
    const before = this.state;
    if (!this.fit) void this.ready.then(() => setTimeout(() => this.fitting === fitting && this.prepare(test), SOON), () => undefined);
    try {
      const fit = await test.analyse(this.program, (line) => {
        fitting.line = line;
        this.tell("progress");
      });
      await this.ready;
      if (this.fitting !== fitting) return;
      this.fitting = null;
      this.lastFit = performance.now() - fitting.since;
      if (test.fit && before) this.history.push(before);
      test.fit = fit;
      if (this.test === test) {
        const { row } = this;
        const first = !before?.fit;
        this.takeFit();
        this.tell("tests", "card", "answer", "moment", "model", "parameters", "rows", "programme", "fitting");
        if (first) this.select(test);
        else this.row = row;
      }
      this.tell("tests", "fitting");
    } catch (cause) {
      if (this.fitting !== fitting) return;
      this.fitting = null;
      this.report(`${test.name}: ${messageOf(cause)}`);
      this.tell("fitting");
    } finally {
      clearInterval(clock);
    }
  }
  /** While the first fit runs there is nothing to see, nor to point at. */
  private prepare(test: Test): void {
    const { stated } = test;
    if (!stated || this.fit) return;
    try {
      this.model.prepare(stated);
    } catch {
      // what cannot be computed the fit will say
    }
  }
  /** What the fit does not find it holds at the sliders: span, diameter, load train, tip radius. */
  private holdMeasured(test: Test, fit: Fit, values: Values): void {
    const change = (key: Key): number | undefined => (values[key] !== fit.fitted[key] ? values[key] : undefined);
    const set = { span: change("L"), diameter: change("D"), stiffness: change("kc"), tipRadius: change("R") };
    for (const [name, value] of Object.entries(set)) if (value !== undefined) (test.settings as unknown as Record<string, unknown>)[name] = value;
    if (test.settings.heldStiffness !== undefined) test.settings.heldStiffness = values.EI;
  }
  cancelFit(): void {
    if (!this.fitting) return;
    this.fitting = null;
    this.program.cancel();
    this.tell("fitting");
  }

  // ---- the moment
  setRow(row: number): void {
    const last = this.test?.rows?.force.length ?? this.fit?.answer.measurement.rows ?? 1;
    const next = Math.max(1, Math.min(last, Math.round(row)));
    if (next === this.row) return;
    this.row = next;
    this.tell("moment");
  }
  /** Index into the rows used (curves) of a row of the file, or the nearest before it; -1 before the first. */
  indexOf(row: number): number {
    const rows = this.fit?.rows;
    if (!rows?.length) return -1;
    let low = 0, high = rows.length - 1;
    if (row < rows[0]!) return -1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (rows[middle]! <= row) low = middle;
      else high = middle - 1;
    }
    return low;
  }
  get moment(): Moment | null {
    const fit = this.fit, path = this.programmed;
    if (!fit) return null;
    if (this.tried !== null && path && this.tried < path.stage.length) {
      const at = this.tried;
      return { row: this.row, used: true, stage: path.stage[at]!, deflection: path.deflection[at]!, force: path.force[at]!, mu: path.friction[at]!, muError: NaN, drawn: path.drawn[at]!, drop: null };
    }
    const i = this.indexOf(this.row), used = i >= 0 && fit.rows[i] === this.row, at = Math.max(0, i);
    const column = (name: string): number => fit.curves.column(name)?.[at] ?? NaN;
    const number = fit.answer.drops.findIndex((d) => this.row >= d.row_before && this.row <= d.row_after);
    const rows = this.test?.rows;
    const stage = used ? column("w_s") : (rows?.stage[this.row - 1] ?? NaN), force = used ? column("F") : (rows?.force[this.row - 1] ?? NaN);
    return {
      row: this.row, used, stage, force, deflection: used ? column("w") : stage - force / fit.fitted.kc, mu: used ? column("mu") : NaN, muError: used ? column("mu_error") : NaN,
      drawn: Math.max(0, column("S") - fit.fitted.L), drop: number < 0 ? null : { drop: fit.answer.drops[number]!, number: number + 1 },
    };
  }
  /** To the next drop, or the one before. */
  toDrop(by: 1 | -1): void {
    const rows = (this.fit?.answer.drops ?? []).map((d) => d.row_before);
    const to = by > 0 ? rows.find((r) => r > this.row) : rows.filter((r) => r < this.row).pop();
    if (to !== undefined) this.setRow(to);
  }

  // ---- pins
  pin(): void {
    if (!this.loading || !this.test) return;
    const { stage, deflection, force } = this.loading;
    this.pins.push({ name: `${this.test.name}, ${this.changed ? "by hand" : "fit"}`, on: true, curve: { stage, deflection, force } });
    this.tell("pins");
  }

  /** Points at a quantity that friction hangs on; null: at none. */
  doubt(quantity: Sensitivity | null): void {
    if (this.doubted === quantity) return;
    this.doubted = quantity;
    this.tell("doubted");
  }
  /** By how much friction would be told larger, were the quantity pointed at stated larger by what it may be off; or, to first order, were the rig stated as its sliders are. Null: as told. */
  get restated(): { friction: number; words: string } | null {
    const { fit, values, doubted } = this;
    if (doubted) return { friction: doubted.friction_moves, words: `${doubted.title} ${doubted.may_be_off.replace(/^say |,.*$/g, "")} larger` };
    if (!fit || !values) return null;
    const moved = fit.answer.sensitivities.flatMap((each) => {
      const key = SLIDERS[each.quantity];
      if (!key || values[key] === fit.fitted[key] || !Number.isFinite(fit.fitted[key])) return [];
      const more = key === "R" ? values.R - fit.fitted.R : values[key] / fit.fitted[key] - 1, most = key === "R" ? NEAR * fit.fitted.L : NEAR;
      return [{ friction: each.friction * more, title: each.title, near: Math.abs(more) <= most }];
    });
    if (!moved.length || moved.some((each) => !each.near)) return null;
    return { friction: moved.reduce((sum, each) => sum + each.friction, 0), words: `${list(moved.map((each) => each.title))} stated so` };
  }

  /** Friction of the sliders at lengths S, for the view of friction. */
  frictionByHand(): { length: Float64Array; mu: Float64Array } | null {
    const { fit, values } = this;
    return fit && values ? { length: fit.friction.length, mu: fit.friction.at(frictionOf(values, this.wave)) } : null;
  }
  modelForceAt(stage: number): number {
    return this.loading ? forceAt(this.loading, Float64Array.of(stage))[0]! : NaN;
  }
}

export const messageOf = (cause: unknown): string => (cause instanceof Error ? cause.message : String(cause));
export const list = (words: string[]): string => (words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words[words.length - 1]}`);

/** What a data file must be told before it can be fitted. */
export function missingOf(test: Test): string[] {
  const { settings, read } = test;
  const stated = read?.test;
  const columns = read?.columns.map((c) => c.role) ?? [];
  const missing: string[] = [];
  if (!columns.includes("force") && !settings.forceColumn) missing.push("which column is the force");
  if (!settings.displacement && !settings.displacementColumn && !columns.some((r) => r === "crosshead" || r === "deflection")) missing.push("whether its displacement is that of the crosshead or the deflection");
  if (settings.span === undefined && !stated?.span) missing.push("the support span");
  if (settings.stiffness === undefined && (settings.displacement ?? (columns.includes("crosshead") ? "crosshead" : "deflection")) === "crosshead") missing.push("the stiffness of the load train");
  return missing;
}
