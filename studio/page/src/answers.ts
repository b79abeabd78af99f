// The JSON of `fit` and `read`, as far as the page reads it; docs/results.md has every key. Numbers are in SI.

export interface Estimate { value: number; standard_error: number; interval95: [number, number]; unit: string }
export type ParameterName = "mu0" | "amplitude" | "wavelength" | "phase" | "drift" | "reference" | "roughness" | "correlation_length" | "bending_stiffness" | "contact_offset";
export interface Line { label: string; words: string }
export interface Finding { code: string; severity: string; sentence: string; remedy: string }
export interface Drop {
  row_before: number; row_after: number; stage: number; deflection_before: number; force_before: number; force_fall: number; slip: string; reading: string; pulled_in: number | null; mu_before: number | null; mu_after: number | null;
}
export interface Step { step: string; changed: boolean; done: string; value: number | null; uncertainty: number | null; unit: string | null; rows: [number, number] | null; key: string | null }
export interface ProfilePoint { row: number; length: number; drawn_in: number; mu: number; mu_error: number; mu_error_force: number }
/** Deflection and force are those of its points, from the turn before it on; length, mobilised friction and whether it slides those of the rows that the fit takes. */
export interface Pass { direction: "in" | "out"; rows: [number, number]; friction: Estimate | null; deflection: number[]; force: number[]; drawn_in: number[]; q: number[]; slides: number[] }
export interface Causes { slips: number | null; cracks: number | null; both: number | null }
export interface Wave { claimed: boolean; amplitude: Estimate; wavelength: Estimate }

export interface Sensitivity { quantity: string; title: string; stated: string; may_be_off: string; friction: number; friction_moves: number; work_moves: number | null }

export interface FitAnswer {
  status: string; name: string; model: string;
  parameters: Partial<Record<ParameterName, Estimate>> & { mu0?: Estimate & { bound?: boolean } };
  residual_rms: number | null; wave: Wave | null;
  answer: Line[]; passes: { status: string; settled: Estimate | null; passes: Pass[] } | null; judgement: { causes: Causes | null } | null;
  verdict: { code: string; sentence: string }; doubts: Finding[]; checks: string; findings: Finding[]; next: string;
  drops: Drop[]; slips: { slips: { length_before: number; length_after: number }[] } | null;
  sensitivities: Sensitivity[];
  band: { length: number[]; mean: number[]; deviation: number[] } | null;
  measurement: { rows: number; first_row: number; last_row: number; ends_with: string };
  preparation: Step[];
  nominal_bending_stiffness: { nominal: number; relative_error: number; source: string } | null;
  draws: { bending_stiffness: number[] } | null;
  profile: ProfilePoint[];
  provenance: { case: string };
}

export interface ReadColumn { number: number; name: string; unit: string | null; role: string }
export interface ReadAnswer {
  format: string; encoding: string; delimiter: string; decimal: string; thousands: string | null; columns: ReadColumn[]; rows: number;
  sheet?: string | null; sheets?: string[] | null;  // of a workbook
  specimens: { name: string; rows: number }[]; test: { span: number | null; diameter: number | null; width: number | null; thickness: number | null };
}

/** What the program remarks on beside its answer. */
export const remarksOf = (err: string): string => err.split("\n").filter((line) => line.startsWith("flexslip: ")).map((line) => line.slice(10).trim()).join("; ");
/** What the program said, without its name: every fault of a case, a line each, or the last line; the page never shows a code. */
export function sentence(err: string): string {
  const lines = err.split(/\n(?! )/).map((line) => line.replace(/^flexslip: /, "").trim()).filter(Boolean);  // what is indented goes on
  const last = lines.at(-1) ?? "the program gave no answer", [place] = /^.*?:(?=\d+: )/.exec(last) ?? [];
  const begin = place ?? (last.startsWith("--") ? "--" : null);
  return begin ? lines.filter((line) => line.startsWith(begin)).join("\n") : last;
}
