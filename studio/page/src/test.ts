// One test: its files, what the program read in them, what was decided, and its last fit.

import { sentence, type FitAnswer, type ReadAnswer } from "./answers";
import { CaseText } from "./case-text";
import type { Program } from "./engine";
import { FittedFriction } from "./friction";
import { frictionOf, parametersOf, valuesOf, type Parameter, type Values } from "./parameters";
import { passesOf, type DrawnPass } from "./passes";
import { changesOfCase, flagsOfData, shellWord, type Settings } from "./settings";
import { Table } from "./table";

export type Files = Record<string, Uint8Array>;

/** A fit, with all that the program wrote: what is shown and what is exported are the same bytes. */
export interface Fit {
  json: string; settings: string; answer: FitAnswer; files: Files;  // profile.csv, curves.csv, draws.csv
  given: Files;  // what it was made of beside the test's files: the plain table, where the file was read otherwise than found
  curves: Table; rows: Float64Array; text: CaseText;
  friction: FittedFriction; fitted: Values; wave: boolean; parameters: Parameter[]; greatestStage: number;
  passes: readonly DrawnPass[];  // of a record that was unloaded
}

/** All rows of the file, also those before contact and after failure, as they stand in it, under their titles. */
export interface Rows { stage: Float64Array; force: Float64Array; titles: { stage: string; force: string } }

export const OUTPUTS = { profile: "profile.csv", curves: "curves.csv", draws: "draws.csv" } as const;

export class Test {
  settings: Settings = { read: {} };
  /** What was not told this file but another that was asked the same, and which. */
  readonly taken = new Map<string, Test>();
  read: ReadAnswer | null = null;
  rows: Rows | null = null;
  fit: Fit | null = null;
  refusal = "";  // the program's sentence, where the file was not read, or not fitted
  saved: Fit | null = null;  // what was taken out last

  /** `main` is the file that `fit` is given: a case, or a data file; `data` the one with the rows. */
  constructor(readonly name: string, readonly files: Files, readonly main: string, readonly data: string) {}

  get isCase(): boolean {
    return this.main.endsWith(".toml");
  }
  /** Whether `read` was told otherwise than it found, so that `fit` takes the plain table. */
  get isPlain(): boolean {
    return !this.isCase && Object.keys(this.settings.read).length > 0;
  }
  /** The file was not read, and the sentence says what must be told. */
  get canBeTold(): boolean {
    return /--[a-z]/.test(this.refusal);
  }
  private readAs = "";
  /** Decided otherwise since it was read. */
  get isReadOtherwise(): boolean {
    return JSON.stringify(this.readFlags()) !== this.readAs;
  }
  private readFlags(): string[] {
    const { read, specimen, sheet, calibration } = this.settings;
    return [...Object.entries(read).flatMap(([flag, value]) => [`--${flag}`, value]), ...(sheet ? ["--sheet", sheet] : []), ...(specimen ? ["--specimen", specimen] : []), ...(calibration ? ["--calibration", calibration] : [])];
  }
  /** The diameter [m] of a case that states a round section and its modulus, else null. */
  private get roundDiameter(): number | null {
    const text = this.fit?.text;
    return text?.hasRoundSection && text.raw("specimen.modulus") !== null ? (this.settings.diameter ?? text.quantity("specimen.diameter")) : null;
  }
  /** The rig, as far as it is said before there is a fit [SI]. */
  get stated(): { span: number; diameter: number; stiffness: number; tipRadius: number } | null {
    const text = this.isCase ? new CaseText(decode(this.files[this.main])) : null, { settings, read } = this;
    const span = settings.span ?? text?.quantity("rig.span") ?? read?.test.span, stiffness = settings.stiffness ?? text?.quantity("rig.stiffness") ?? Infinity;
    if (!span) return null;
    return { span, diameter: settings.diameter ?? settings.height ?? text?.quantity("specimen.diameter") ?? text?.quantity("specimen.height") ?? read?.test.diameter ?? 0, stiffness, tipRadius: settings.tipRadius ?? text?.quantity("rig.roller_radius") ?? 0 };
  }
  /** The table that `read` writes of a file that is read otherwise than found: the program calls a test by its file's name without the last ending. */
  get plainName(): string {
    return this.data.replace(/\.[^.]*$/, "") + ".plain";
  }
  /** The commands that come to this answer, without what the page adds to see the numbers behind it. */
  commands(): string[][] {
    const { settings } = this;
    if (this.isCase) return [["fit", this.main, ...changesOfCase(settings, this.roundDiameter)]];
    if (!this.isPlain) return [["fit", this.main, ...flagsOfData(settings)]];
    const { specimen: _, sheet: __, calibration: ___, ...rest } = settings, { crosshead, deflection } = settings.read, told = crosshead ?? deflection;
    // The plain table has all columns of the file: which of them was chosen is said again, by its name.
    const nameOf = (said: string | undefined): string | undefined => (said === undefined ? undefined : this.read?.columns.find((c) => c.name === said || String(c.number) === said)?.name);
    const column = nameOf(told), force = nameOf(settings.read.force);
    if (column) rest.displacement ??= crosshead ? "crosshead" : "deflection";
    return [["read", this.main, ...this.readFlags(), "--output", this.plainName],
      ["fit", this.plainName, ...flagsOfData(rest), ...(column ? ["--displacement-column", column] : []), ...(force ? ["--force", force] : [])]];
  }
  get commandLine(): string {
    return this.commands().map((args) => ["flexslip", ...args].map(shellWord).join(" ")).join(" && ");
  }

  get hasData(): boolean {
    return this.data in this.files;
  }
  /** Reads the rows of the data file; `refusal` is why it cannot. */
  async open(program: Program): Promise<void> {
    const given = { [this.data]: this.files[this.data]! };
    this.readAs = JSON.stringify(this.readFlags());
    const fail = (refusal: string): void => {
      this.read = this.rows = null;
      this.refusal = refusal;
    };
    try {
      if (!this.hasData) return fail(`${sentence((await program.run(["fit", this.main], this.files)).err)}${this.data ? ` Drop ${this.main} and ${this.data} together.` : ""}`);
      const told = await program.run(["read", this.data, ...this.readFlags(), "--json"], given);
      if (told.code !== 0) return fail(sentence(told.err));
      const read = JSON.parse(told.out) as ReadAnswer, plain = await program.run(["read", this.data, ...this.readFlags(), "--output", "-", "--quiet"], given);
      if (!this.read) this.refusal = "";
      this.read = read;
      this.rows = plain.code === 0 ? rowsOf(new Table(plain.out), read) : null;
    } catch (cause) {
      fail(`${this.data}: ${cause instanceof Error ? cause.message : String(cause)}`);
    }
  }

  /** Fits, by the command of `commands`. Throws the program's sentence; the last fit stays. */
  async analyse(program: Program, progress?: (line: string) => void): Promise<Fit> {
    let files = this.files, given: Files = {};
    const settings = JSON.stringify(this.settings);
    const commands = this.commands();
    if (commands.length > 1) {
      const plain = await program.run(commands[0]!, files);
      if (plain.code !== 0) throw new Error(sentence(plain.err));
      given = plain.files;
      files = { ...files, ...given };
    }
    const args = commands[commands.length - 1]!;
    const outputs = Object.entries(OUTPUTS).flatMap(([flag, name]) => [`--${flag}`, name]);
    const answer = await program.run([...args, "--json", ...outputs], files, progress);
    if (!answer.out.trimStart().startsWith("{")) throw new Error(sentence(answer.err));
    return fitOf(answer.out, answer.files, settings, given);
  }
}

const decode = (bytes: Uint8Array | undefined): string => (bytes ? new TextDecoder().decode(bytes) : "");

function fitOf(json: string, files: Files, settings: string, given: Files = {}): Fit {
  const answer = JSON.parse(json) as FitAnswer;
  const text = new CaseText(answer.provenance.case), fitted = valuesOf(answer, text);
  const wave = !!answer.wave?.claimed && answer.model === "roughness";
  const curves = new Table(decode(files[OUTPUTS.curves]));
  const stage = curves.column("w_s") ?? new Float64Array(0);
  return {
    json, settings, answer, files, given, curves, rows: curves.column("row") ?? new Float64Array(0), text, fitted, wave,
    friction: new FittedFriction(answer, new Table(decode(files[OUTPUTS.draws])), frictionOf(fitted, wave)),
    passes: passesOf(answer, fitted.kc),
    parameters: parametersOf(answer, fitted, text.words("specimen.height") === null), greatestStage: stage.reduce((a, b) => Math.max(a, b), 0),
  };
}

function rowsOf(table: Table, read: ReadAnswer): Rows | null {
  const column = (roles: string[]): { title: string; values: Float64Array } | null => {
    for (const role of roles) {
      const name = read.columns.find((c) => c.role === role)?.name, at = name === undefined ? -1 : table.titles.findIndex((title) => title.replace(/ \[[^\]]*\]$/, "") === name);
      if (at >= 0) return { title: table.titles[at]!, values: table.at(at) };
    }
    return null;
  };
  const stage = column(["crosshead", "displacement", "deflection", "time"]), force = column(["force"]);
  return stage && force ? { stage: stage.values, force: force.values, titles: { stage: stage.title, force: force.title } } : null;
}
