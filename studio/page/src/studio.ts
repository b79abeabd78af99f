// The state of the studio and what may be done to it. Knows no elements: views listen and draw.

import type { Loading, Mechanics, Program, Rig } from "./engine";
import { isWithdrawn, tellsFriction } from "./answer";
import type { Drop, Sensitivity } from "./answers";
import { History } from "./history";
import { forceAt, misfit, Model, type Curve } from "./model";
import { frictionOf, type Key, type Values } from "./parameters";
import type { Settings } from "./settings";
import type { Fit, Test } from "./test";
import { inPageWords } from "./words";

export type Topic = "tests" | "card" | "answer" | "moment" | "model" | "parameters" | "rows" | "programme" | "pins" | "fitting" | "progress" | "tour" | "error" | "axis" | "theme" | "view" | "doubted";
export interface Pin { name: string; on: boolean; curve: Curve }
interface State { test: Test | null; values: Values | null; wave: boolean; programme: number[] | null; removed: ReadonlySet<Test>; tests: { test: Test; settings: Settings; taken: [string, Test][]; fit: Fit | null }[] }

export interface Moment { row: number; stage: number; deflection: number; force: number; mu: number; muError: number; drawn: number; used: boolean; leftOut: string /* why it was not used */; drop: { drop: Drop; number: number } | null }

const SLIDERS: Readonly<Record<string, Key>> = { load_train: "kc", span: "L", support_radius: "R" };  // of what is measured of the rig
const NEAR = 0.05;  // [1] of a value, or of the span: as far as first order is told

/** What is said of one file and holds for others of the same rig; a specimen is that of its file. */
const OF_THE_RIG: ReadonlySet<keyof Settings> = new Set(["span", "spanOff", "stiffness", "stiffnessOff", "supports", "tipRadius", "displacement", "calibration", "speed"]);
const OF_ITS_COLUMNS = ["displacement-unit", "force-unit"] as const;  // likewise, for files with the same columns
export const ERROR_LINE = "The line of errors";  // which cannot say that it was not drawn
const SOON = 300;  // [ms] when the Worker has begun to compute, and its code is compiled
const REST = 250;  // [ms] after which a slider that is held still is taken to rest

export class Studio {
  private readonly all: Test[] = [];  // in the order they came
  private removed: ReadonlySet<Test> = new Set();  // of these: undo brings them back
  test: Test | null = null;
  values: Values | null = null;  // of the sliders
  wave = false;
  programme: number[] | null = null;  // [m] stage positions to try, where it is not that of the record
  row = 1;
  axis: "deflection" | "stage" = "deflection";
  pins: Pin[] = [];
  error = "";
  fitting: { test: Test; said: string } | null = null;  // and what the program last said of how far it is
  waiting: readonly Test[] = [];  // to be fitted, in this order
  reading = 0;  // files that are read
  step = -1;  // of the first visit; -1: none
  bandReady = false;  // the band of the draws is computed once the page is at rest
  doubted: Sensitivity | null = null;  // the input pointed at: shown as if it were larger by its uncertainty
  tried: number | null = null;  // a state of the programme that is marked instead of a row
  model!: Model;  // from `ready` on, and so with every fit
  readonly ready: Promise<void>;
  rig: Rig | null = null;            // at the values of the sliders
  loading: Loading | null = null;    // the model over the record
  programmed: Loading | null = null; // and over the programme, if there is one
  residual: Float64Array = new Float64Array(0);
  rms = NaN;
  private readonly history = new History<State>();
  private readonly listeners: { view: string; topics: readonly Topic[] | null; draw: (topics: ReadonlySet<Topic>) => void }[] = [];
  private dirty = new Set<Topic>();
  private frame = 0;
  private ahead = false;     // a model was computed before the frame that shows it
  private computed = false;  // and is that of the values as they stand

  private readonly reader: Program;  // what is dropped while a fit runs is read and seen
  private line: Promise<void> = Promise.resolve();  // of fits: one runs at a time

  /** A fit is under way while the mechanics are still opened. */
  constructor(readonly program: Program, mechanics: Promise<Mechanics>) {
    this.reader = program.another();
    this.ready = mechanics.then((opened) => void (this.model = new Model(opened)));
    this.ready.catch(() => undefined);  // said by each fit
  }

  // ---- telling the views, once a frame
  /** Draws this view where one of these topics is told; without topics at each. What one view cannot draw stops no other. */
  listen(view: string, topics: readonly Topic[] | null, draw: (topics: ReadonlySet<Topic>) => void): void {
    this.listeners.push({ view, topics, draw });
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
    for (const { view, topics: of, draw } of this.listeners)
      if (of === null || of.some((topic) => topics.has(topic)))
        try {
          draw(topics);
        } catch (cause) {
          if (view !== ERROR_LINE) this.report(`${view} could not be drawn: ${messageOf(cause)}`);
        }
  }
  private recompute(): void {
    const fit = this.fit, { values } = this;
    this.loading = this.programmed = this.rig = null;
    this.residual = new Float64Array(0);
    if (!fit || !values || isWithdrawn(fit.answer)) return;
    try {
      if (fit.answer.status !== "ok" || !tellsFriction(fit.answer)) return void (this.rig = this.model.frictionless(fit, values));
      const rig = this.model.rig(fit, values, this.wave);
      this.rig = rig;
      this.loading = this.model.monotone(fit, rig, this.live);
      ({ rms: this.rms, residual: this.residual } = misfit(fit, this.loading));
      if (this.programme) this.programmed = this.model.loading(rig, this.programme, this.live);
    } catch (cause) {
      if (this.changed) this.report(`The model has no curve at these values: ${messageOf(cause)}`);  // of what the fit found, its verdict says why
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
  get tests(): readonly Test[] {
    return this.all.filter((test) => !this.removed.has(test));
  }
  /** Reads these tests, so that they are seen, and fits them: of what a file does not say the program asks. */
  async open(...tests: Test[]): Promise<void> {
    const fits: Promise<void>[] = [], refused: string[] = [];
    this.reading += tests.length;
    this.tell("fitting");
    for (const test of tests) {
      await test.open(this.reader);
      --this.reading;
      if (!test.hasData || (test.refusal && !test.isCase && !test.canBeTold)) {
        refused.push(inPageWords(test.refusal, test));
        this.report(refused.join("\n"));
        continue;
      }
      await this.takeRig(test);
      this.all.push(test);
      this.select(test);
      fits.push(this.runFit(test));
    }
    this.tell("fitting");
    await Promise.all(fits);
  }
  /** That of a fitted test with the same columns: one machine in one afternoon. What the file itself says counts more. The card shows it. */
  private async takeRig(test: Test): Promise<void> {
    const like = test.isCase ? undefined : this.tests.find((other) => !other.isCase && other.fit && sameColumns(other, test));
    for (const key of like ? OF_THE_RIG : []) {
      if (like!.settings[key] === undefined || (/^span/.test(key) && test.read?.test.span)) continue;
      put(test.settings, key, like!.settings[key]);
      test.taken.set(key, like!);
    }
    if (test.isReadOtherwise) await test.open(this.reader);
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
    this.bandReady = false;
  }
  remove(test: Test): void {
    const at = this.tests.indexOf(test);
    if (at < 0) return;
    this.remember();
    this.cancelFit(test);
    this.removed = new Set([...this.removed, test]);
    if (this.test === test) this.select(this.tests[Math.min(at, this.tests.length - 1)] ?? null);
    this.tell("tests", "fitting");
  }
  next(by: 1 | -1): void {
    const at = this.test ? this.tests.indexOf(this.test) + by : -1;
    if (this.tests[at]) this.select(this.tests[at]!);
  }

  // ---- changes, each of which can be taken back
  private get state(): State {
    return {
      test: this.test, values: this.values && { ...this.values }, wave: this.wave, programme: this.programme && [...this.programme], removed: this.removed,
      tests: this.all.map((test) => ({ test, settings: structuredClone(test.settings), taken: [...test.taken], fit: test.fit })),
    };
  }
  private restore(state: State | null): void {
    if (!state) return;
    this.removed = state.removed;
    for (const { test, settings, taken, fit } of state.tests) {
      Object.assign(test, { settings: structuredClone(settings), fit });
      test.taken.clear();
      for (const [key, from] of taken) test.taken.set(key, from);
    }
    Object.assign(this, { test: state.test, values: state.values && { ...state.values }, wave: state.wave, programme: state.programme && [...state.programme] });
    this.tell("tests", "card", "answer", "moment", "model", "parameters", "rows", "programme", "fitting");
    void this.answer();
  }
  /** Call before a change; a drag calls it once. */
  remember(): void {
    this.history.push(this.state);
    this.tell("fitting");
  }
  undo(): void {
    this.restore(this.history.undo(this.state));
  }
  redo(): void {
    this.restore(this.history.redo(this.state));
  }
  get canUndo(): boolean {
    return this.history.canUndo;
  }
  get canRedo(): boolean {
    return this.history.canRedo;
  }
  set(key: Key, value: number, live = false): void {
    if (!this.values) return;
    if (this.isBusy(this.test)) this.cancelFit();
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
  /** Of the test that is shown; what is said of the rig also of the files that are asked the same, but those that were told it themselves. */
  decide(change: Partial<Settings>): void {
    const { test } = this;
    if (!test) return;
    const { read } = change, { greatestStage } = this, units = read ? OF_ITS_COLUMNS.filter((unit) => read[unit] !== test.settings.read[unit]) : [];
    for (const [name, value] of Object.entries(change)) {
      const key = name as keyof Settings;
      put(test.settings, key, value);
      test.taken.delete(key);
      if (OF_THE_RIG.has(key)) this.pass(test, key, value, (other) => other.settings);
    }
    for (const unit of units) {
      test.taken.delete(unit);
      this.pass(test, unit, read![unit], (other) => (sameColumns(test, other) ? other.settings.read : null));
    }
    if (this.programme?.[1] === greatestStage) this.setProgramme(this.programme.map((stage, i) => (i === 1 ? this.greatestStage : stage)));
    this.tell("tests", "card", "rows", "programme", "fitting", "parameters");
  }
  /** Hands on what this file was told to those that have nothing there, or what they have from it. */
  private pass(from: Test, key: string, value: unknown, settingsOf: (other: Test) => object | null): void {
    for (const other of this.alike(from)) {
      const settings = settingsOf(other) as Record<string, unknown> | null;
      if (!settings || (settings[key] !== undefined && other.taken.get(key) !== from)) continue;
      put(settings, key, value);
      other.taken.set(key, from);
      if (other.read) other.refusal = "";  // what it was asked may be answered now
    }
  }
  /** The other files that are open and not fitted yet, which are asked the same as this one. */
  alike(test: Test): Test[] {
    return test.isCase ? [] : this.tests.filter((other) => other !== test && !other.isCase && !other.fit);
  }
  /** Reads again what was decided to be read otherwise. */
  async reread(): Promise<void> {
    const tests = this.tests.filter((test) => test.isReadOtherwise);
    for (const test of tests) await test.open(this.reader);
    if (tests.length) this.tell("tests", "card", "answer", "rows", "view", "model");
  }
  /** The program is asked again what it still must be told of a file; where that is nothing, it fits. A later fit is asked for by hand. */
  async answer(): Promise<void> {
    const { test } = this;
    await this.reread();
    if (!test || test.fit) return;
    this.cancelFit(test);
    await this.runFit(test);
  }
  /** Settings were changed since the last fit. */
  get stale(): boolean {
    return !!this.test?.fit && isStale(this.test);
  }
  setProgramme(programme: number[] | null): void {
    this.programme = programme;
    this.tried = null;
    this.tell("model", "programme");
  }

  // ---- the fits, in the Worker, one after the other
  runFit(test: Test | null = this.test): Promise<void> {
    if (!test || this.isBusy(test) || (test.refusal && !test.read && !test.isCase)) return Promise.resolve();
    this.waiting = [...this.waiting, test];
    if (this.test === test) this.report("");
    this.tell("fitting");
    return (this.line = this.line.then(() => (this.waiting.includes(test) ? this.fitNow(test) : undefined)));
  }
  /** All that were not fitted, or not as they are told now. */
  async fitAll(): Promise<void> {
    await Promise.all(this.tests.filter((test) => isStale(test)).map((test) => this.runFit(test)));
  }
  isBusy(test: Test | null): boolean {
    return !!test && (this.fitting?.test === test || this.waiting.includes(test));
  }
  private async fitNow(test: Test): Promise<void> {
    this.waiting = this.waiting.filter((other) => other !== test);
    if (this.test === test && test.fit && this.values) this.holdMeasured(test, test.fit, this.values);
    const fitting = { test, said: "" };
    this.fitting = fitting;
    this.tell("fitting");
    const before = this.state;
    if (!this.fit) void this.ready.then(() => setTimeout(() => this.fitting === fitting && this.prepare(test), SOON), () => undefined);
    try {
      const fit = await test.analyse(this.program, (line) => {
        fitting.said = line;
        if (!test.fit && test.refusal) (test.refusal = ""), this.tell("card", "answer");  // the program asks no more
        this.tell("progress");
      });
      await this.ready;
      if (this.fitting !== fitting) return;
      this.fitting = null;
      const first = !test.fit;
      if (!first) this.history.push(before);
      test.fit = fit;
      test.refusal = "";
      if (this.test === test) {
        this.takeFit();
        this.tell("tests", "card", "answer", "moment", "model", "parameters", "rows", "programme");
        if (first) this.select(test);
      }
    } catch (cause) {
      if (this.fitting !== fitting) return;
      this.fitting = null;
      test.refusal = messageOf(cause);
    } finally {
      this.tell("tests", "card", "answer", "fitting");
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
    const set = { span: change("L"), [fit.text.words("specimen.height") === null ? "diameter" : "height"]: change("D"), stiffness: change("kc"), tipRadius: change("R") };
    for (const [name, value] of Object.entries(set)) if (value !== undefined) (test.settings as unknown as Record<string, unknown>)[name] = value;
    if (test.settings.heldStiffness !== undefined) test.settings.heldStiffness = values.EI;
  }
  /** Of this test alone: the others go on. */
  cancelFit(test: Test | null = this.test): void {
    this.waiting = this.waiting.filter((other) => other !== test);
    if (this.fitting && this.fitting.test === test) {
      this.fitting = null;
      this.program.cancel();
    }
    this.tell("fitting");
  }

  /** The rows used, first and last: as decided, else as the fit found. */
  get used(): [number, number] {
    const { test, fit } = this, measurement = fit?.answer.measurement;
    return [test?.settings.first ?? measurement?.first_row ?? 1, test?.settings.until ?? measurement?.last_row ?? test?.rows?.force.length ?? 1];
  }
  /** Of these rows [m], from the contact. */
  get greatestStage(): number {
    const { fit, test } = this, [first, last] = this.used, raw = test?.rows?.stage;
    if (!fit) return 0;
    const beyond = raw && last > fit.answer.measurement.last_row ? asUsed(raw, fit, "w_s", last) : 0;
    return fit.curves.column("w_s")!.reduce((most, stage, i) => (fit.rows[i]! >= first && fit.rows[i]! <= last ? Math.max(most, stage) : most), beyond);
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
      return { row: this.row, used: true, leftOut: "", stage: path.stage[at]!, deflection: path.deflection[at]!, force: path.force[at]!, mu: path.friction[at]!, muError: NaN, drawn: path.drawn[at]!, drop: null };
    }
    const i = this.indexOf(this.row), used = i >= 0 && fit.rows[i] === this.row, at = Math.max(0, i);
    const column = (name: string): number => fit.curves.column(name)?.[at] ?? NaN;
    const number = fit.answer.drops.findIndex((d) => this.row >= d.row_before && this.row <= d.row_after);
    const raw = this.test?.rows, [stage, force] = used || !raw ? [column("w_s"), column("F")] : [asUsed(raw.stage, fit, "w_s", this.row), asUsed(raw.force, fit, "F", this.row)];
    return {
      row: this.row, used, leftOut: used ? "" : this.leftOut(fit), stage, force, deflection: used ? column("w") : stage - force / fit.fitted.kc, mu: used ? column("mu") : NaN, muError: used ? column("mu_error") : NaN,
      drawn: Math.max(0, column("S") - fit.fitted.L), drop: number < 0 ? null : { drop: fit.answer.drops[number]!, number: number + 1 },
    };
  }
  private leftOut(fit: Fit): string {
    const { rows } = fit;
    if (!rows.length || this.row < rows[0]!) return "before the rows used";
    if (this.row > fit.answer.measurement.last_row) return "after the rows used";
    return fit.answer.preparation.find((step) => step.step === "thinning" && step.changed)?.done ?? "left out";
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

  /** Points at an input that friction depends on; null: at none. */
  doubt(quantity: Sensitivity | null): void {
    if (this.doubted === quantity) return;
    this.doubted = quantity;
    this.tell("doubted");
  }
  /** The change of friction if the input pointed at were larger by its uncertainty; or, to first order, if the rig were as its sliders state. Null: no change. */
  get restated(): { friction: number; words: string } | null {
    const { fit, values, doubted } = this;
    if (doubted) return { friction: doubted.friction_moves, words: `${doubted.title} larger by ${doubted.may_be_off}` };
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

/** What the file holds at a row, in the unit and from the zero in which the rows used are counted: by the first of these and the one farthest from it. */
function asUsed(raw: Float64Array, fit: Fit, name: string, row: number): number {
  const used = fit.curves.column(name), { rows } = fit;
  if (!used?.length) return NaN;
  const far = used.reduce((best, value, i) => (Math.abs(value - used[0]!) > Math.abs(used[best]! - used[0]!) ? i : best), 0), of = (i: number): number => raw[rows[i]! - 1] ?? NaN;
  return used[0]! + ((used[far]! - used[0]!) * ((raw[row - 1] ?? NaN) - of(0))) / (of(far) - of(0));
}

function put(settings: object, key: string, value: unknown): void {
  if (value === undefined) delete (settings as Record<string, unknown>)[key];
  else Object.assign(settings, { [key]: value });
}

const sameColumns = (one: Test, other: Test): boolean => !!one.read && JSON.stringify(one.read.columns.map((c) => c.name)) === JSON.stringify(other.read?.columns.map((c) => c.name));

export const messageOf = (cause: unknown): string => (cause instanceof Error ? cause.message : String(cause));
export const list = (words: string[]): string => (words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words[words.length - 1]}`);

export const isStale = (test: Test): boolean => test.fit === null || JSON.stringify(test.settings) !== test.fit.settings;
