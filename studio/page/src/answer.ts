// What a fit comes to: the program's own verdict, findings and readings of drops, and the numbers beside them. The page words and judges nothing itself.

import type { Drop, Finding, FitAnswer } from "./answers";
import type { CaseText } from "./case-text";
import { decimalsFor, fixed, significant, unitFor, written, type Unit } from "./quantity";

export interface KeyNumber { label: string; value: string; rest: string; condition: string }
export interface CheckLine { mark: "passed" | "warning" | "cannot"; words: string; reason: string }
export interface Answer { verdict: string; rest: string; next: string; numbers: KeyNumber[]; checks: CheckLine[] }

export type Slip = "could" | "undecided" | "no";
export const slipOf = (drop: Drop): Slip => (drop.slip === "possible" ? "could" : drop.slip === "too_short" ? "undecided" : "no");

/** A drop in words: "Drop 9: can be a slip". */
export function dropInWords(drop: Drop, number: number, told = true): { claim: string; rest: string; more: string } {
  const mu = drop.mu_before !== null && drop.mu_after !== null ? `, *μ* ${fixed(drop.mu_before, 2)} to ${fixed(drop.mu_after, 2)}` : "";
  const drawn = drop.pulled_in ? `, ${written(drop.pulled_in / 2, "length")} pulled in over each support` : "";
  return { claim: `Drop ${number}: ${drop.reading}`, rest: `; ${written(drop.force_fall, "force")} down`, more: told && slipOf(drop) === "could" ? `${mu}${drawn}` : "" };
}

const NOTHING = "–";

/** A value with its error in a unit: digits follow the error. */
export function estimate(value: number, error: number, unit: Unit, most = 4): [string, string] {
  const digits = Math.min(most, decimalsFor(error / unit.factor));
  return [fixed(value / unit.factor, digits), `± ${fixed(error / unit.factor, digits)}`];
}

/** Where the verdict tells no friction, nothing of it is shown: no share of the work, no spacing, no slips. Of a specimen that cracked, a second loading tells it. */
export const tellsFriction = (fit: FitAnswer): boolean => !["crack", "check_input", "no_answer"].includes(fit.verdict.code) || (fit.verdict.code === "crack" && fit.findings.some((each) => each.code === "changed_reload"));

function numbers(fit: FitAnswer, text: CaseText): KeyNumber[] {
  const mu0 = fit.parameters.mu0, EI = fit.parameters.bending_stiffness, { slips, energy } = fit;
  const I = text.secondMoment;
  const signed = (share: number): string => `${fixed(Math.abs(100 * share), 0)} % ${share < 0 ? "less" : "more"}`;
  const friction: KeyNumber = { label: "Friction at the supports *μ*", value: NOTHING, rest: "", condition: "" };
  const told = tellsFriction(fit);
  if (!told) friction.condition = "none can be read off";
  else if (mu0?.bound) Object.assign(friction, { value: `≤ ${significant(mu0.interval95[1], 2)}`, rest: "(95 %)" });
  else if (mu0) [friction.value, friction.rest] = estimate(mu0.value, mu0.standard_error, { name: "", command: "", factor: 1 });
  const work: KeyNumber = { label: "Friction in the work", value: NOTHING, rest: "", condition: "" };
  if (told && energy?.friction_share != null) {
    const onEdges = fit.findings.some((each) => each.code === "supports_not_stated" && each.severity === "doubt");
    const least = !onEdges && fit.findings.some((each) => each.code === "no_reload");
    const high = energy.friction_share_interval95[1], error = high === undefined ? null : (high - energy.friction_share) / 1.96;
    const share = 100 * energy.friction_share, atLeast = least && error !== null;
    Object.assign(work, { value: atLeast ? `≥ ${fixed(Math.max(share - 164.5 * error, 0), 0)} %` : `${fixed(share, 0)} %`, rest: `${atLeast || error === null ? "" : `± ${fixed(100 * error, 0)} % `}of ${written(energy.work_of_fracture, "energy")}` });
    work.condition = onEdges ? "if the supports are knife edges" : ["undecided", "crack"].includes(fit.verdict.code) ? "if the drops are slips" : least ? "more if stiffness was lost" : "";
  }
  const spacing: KeyNumber = { label: "Specimen between slips", value: NOTHING, rest: "", condition: !told ? "" : slips?.median_fall_of_mu != null ? `*μ* falls ${significant(slips.median_fall_of_mu, 2)} per slip` : "too few slips to tell" };
  if (slips?.median_spacing && told) {
    const u = unitFor(slips.median_spacing, "length");
    Object.assign(spacing, { value: significant(slips.median_spacing / u.factor, 2), rest: u.name });
  }
  const stiffness: KeyNumber = { label: "Bending stiffness *EI*", value: NOTHING, rest: "", condition: "" };
  const modulus: KeyNumber = { label: "Fitted modulus *E*", value: NOTHING, rest: "", condition: I === null ? "no section stated" : "" };
  if (EI) {
    const u = unitFor(EI.value, "bending"), [value, error] = estimate(EI.value, EI.standard_error, u);
    Object.assign(stiffness, { value, rest: `${error} ${u.name}` });
    const over = fit.small_deflection?.over_fit;
    if (over) stiffness.condition = `initial slope says ${signed(over - 1)}`;
    if (I) {
      const E = EI.value / I, e = unitFor(E, "modulus"), [ofE, errorOfE] = estimate(E, EI.standard_error / I, e);
      Object.assign(modulus, { value: ofE, rest: `${errorOfE} ${e.name}` });
      const given = text.quantity("specimen.modulus"), nominal = fit.nominal_bending_stiffness;
      modulus.condition = given === null ? "not stated" : `given: ${estimate(given, given * (nominal?.relative_error ?? 0.03), e).join(" ")}`;
    }
  }
  return [friction, work, spacing, stiffness, modulus];
}

const MARKS: Record<Finding["severity"], CheckLine["mark"] | null> = { refusal: "warning", suspicion: "warning", doubt: "warning", condition: null, note: null, passed: "passed", unjudged: "cannot" };

const checks = (fit: FitAnswer): CheckLine[] => fit.findings.flatMap((finding) => {
  const mark = MARKS[finding.severity];
  return mark ? [{ mark, words: finding.short_form || finding.sentence, reason: [finding.sentence, finding.remedy].filter(Boolean).join(" ") }] : [];
});

export function answerOf(fit: FitAnswer, text: CaseText): Answer {
  const [verdict, ...rest] = fit.verdict.sentence.split(". ");
  return { verdict: verdict!, rest: rest.join(". "), next: fit.next, numbers: numbers(fit, text), checks: checks(fit) };
}
