// What a fit comes to, in the words of the page. Every sentence is of codes and numbers in the program's JSON: the page judges nothing itself.

import type { Check, Drop, FitAnswer } from "./answers";
import type { CaseText } from "./case-text";
import { decimalsFor, fixed, minus, significant, unitFor, written, type Unit } from "./quantity";
import { inertia } from "./settings";

export interface KeyNumber { label: string; value: string; rest: string; condition: string }
export interface CheckLine { mark: "passed" | "warning" | "cannot"; words: string; reason: string }
export interface Answer { lead: string; verdict: string; reservation: string; numbers: KeyNumber[]; checks: CheckLine[] }

export type Slip = "could" | "undecided" | "no";
export const slipOf = (drop: Drop): Slip => (drop.slip === "possible" ? "could" : drop.slip === "too_short to judge" || drop.slip === "too_short" ? "undecided" : "no");
const WHY_NOT: Record<string, string> = {
  "unexplained by any friction": "no friction explains it", "implausible friction before": "it would need implausible friction before it",
  "negative friction after": "friction after it would be negative", moves_out: "the fibre would have to move outwards",
};

/** A drop in words: "Drop 9 could be a slip". */
export function dropInWords(drop: Drop, number: number): { claim: string; rest: string; more: string } {
  const fall = `${written(drop.force_fall, "force")} down`;
  const slip = slipOf(drop);
  if (slip === "could") {
    const mu = drop.mu_before !== null && drop.mu_after !== null ? `, *μ* ${fixed(drop.mu_before, 2)} to ${fixed(drop.mu_after, 2)}` : "";
    const drawn = drop.pulled_in ? `, ${written(drop.pulled_in.value / 2, "length")} drawn in at each side` : "";
    return { claim: `Drop ${number} could be a slip`, rest: `: ${fall}`, more: `${mu}${drawn}` };
  }
  if (slip === "undecided") return { claim: `Drop ${number}: cannot tell`, rest: `: ${fall}, too few rows to judge`, more: "" };
  return { claim: `Drop ${number}: a slip could be excluded`, rest: `: ${fall}, ${WHY_NOT[drop.slip] ?? drop.slip}`, more: "" };
}

const NOTHING = "–";

/** A value with its error in a unit: digits follow the error. */
export function estimate(value: number, error: number, unit: Unit, most = 4): [string, string] {
  const digits = Math.min(most, decimalsFor(error / unit.factor));
  return [fixed(value / unit.factor, digits), `± ${fixed(error / unit.factor, digits)}`];
}

function verdict(fit: FitAnswer): Pick<Answer, "lead" | "verdict" | "reservation"> {
  const drops = fit.drops.length, slips = fit.drops.filter((d) => slipOf(d) === "could").length;
  if (fit.status !== "ok" || !fit.judgement) {
    const why: Record<string, string> = {
      too_few_points: "Too few points lie where friction shows. Bend the fibre farther, or check span and units.",
      not_explained: "No sliding with a friction of 0 to 2 gives this record. Check columns, units, span and section.",
      no_initial_slope: "The force does not rise where the record begins, so the stiffness cannot be told. Check the rows used.",
    };
    return { lead: "", verdict: "No answer.", reservation: why[fit.status] ?? "" };
  }
  const { judgement } = fit;
  const lead = drops === 0 ? "The force never drops." : `${drops === 1 ? "1 drop" : `${drops} drops`} of force. ${
    slips === drops ? (drops === 1 ? "It could be a slip over the supports." : "Each could be a slip over the supports.")
    : slips === 0 ? "None could be a slip over the supports." : `${slips} of them could be ${slips === 1 ? "a slip" : "slips"} over the supports.`}`;
  if (judgement.standing === "untrusted" || judgement.standing === "suspect") {
    const doubt = judgement.doubts.map((d) => doubtInWords(d, fit)).find(Boolean) ?? "";
    return { lead, verdict: judgement.standing === "untrusted" ? "This record cannot tell." : "The test is suspect.", reservation: doubt + nextStep(fit) };
  }
  if (drops === 0) return { lead, verdict: "There is nothing to explain.", reservation: "" };
  if (judgement.drops === "cracks") return { lead, verdict: "Slips alone do not explain it.", reservation: `The rises between the drops are those of a specimen that cracks.${nextStep(fit)}` };
  if (judgement.drops === "not_by_cracks_alone") {
    const lost = judgement.stiffness_lost;
    return {
      lead, verdict: "Cracks alone do not explain it.",
      reservation: lost === null ? "Some loss of stiffness besides cannot be excluded: unload and reload once."
        : `A reload bounds the stiffness lost: ${fixed(100 * lost, 0)} ± ${fixed(100 * (judgement.stiffness_lost_error ?? 0), 0)} %.`,
    };
  }
  return { lead, verdict: "Slips or cracks: this record cannot tell.", reservation: judgement.next_step === "none" ? "Unload and reload once: cracks leave the fibre softer, slips do not." : nextStep(fit).trim() };
}

function nextStep(fit: FitAnswer): string {
  const rig = fit.judgement?.stiffness_for_no_snap;
  const steps: Record<string, string> = {
    check_case: " Check modulus, section, span, columns and units.", reload: " Unload and reload once: cracks leave the fibre softer, slips do not.",
    finer_steps: " Record more rows: most rises between drops have fewer than five.", image_length: " Image the supports: the length drawn in shows whether the fibre slides.",
    state_radius: " State the radius of the supports, if they are not edges.", find_contact: " Look at the contact: find it on the curve.",
    finer_force: " Record the force more finely.", see_checks: " See what the checks advise.", measure_stiffness: " Check modulus, section, span and contact.",
    stiffer_rig: rig ? ` A load train of ${written(rig, "stiffness")} or more would show no drops by slipping.` : "",
  };
  return steps[fit.judgement?.next_step ?? "none"] ?? "";
}

function doubtInWords(doubt: string, fit: FitAnswer): string {
  const impossible = fit.drops.filter((d) => slipOf(d) === "no").length, { suspect_criteria: points } = fit;
  const below = 1 - (fit.force_over_frictionless?.median ?? 1);
  const words: Record<string, string> = {
    wrong_stiffness: "The bending stiffness stated is not that of the initial slope: check modulus, section, span and units.",
    no_sliding: `No sliding with a friction of 0 to 2 gives this record${below > 0.01 ? `: its force lies ${fixed(100 * below, 0)} % below that without friction` : ""}.`,
    softer_reload: `Loaded again, the fibre is softer by ${fixed(100 * (fit.judgement?.stiffness_lost ?? 0), 0)} %.`,
    cracks: "The drops are those of a specimen that cracks.",
    impossible_drops: `${impossible} of the ${fit.drops.length} drops cannot be slips.`,
    implausible_friction: `It needs implausible friction, above ${points.limit} in ${fit.suspects.length} of ${points.points_judged} points.`,
    failed_check: "A check of the fit failed.", falling_friction: "Friction falls away along the record; lost stiffness would look the same.",
    changed_reload: "Loaded again, the fibre is not as stiff as at first.", coarse_force: "The force is coarse: small drops cannot be seen.",
    below_frictionless: "The force lies below that without friction: the bending stiffness stated is too large, or the contact lies farther.",
    few_rows: "Most rises between drops have fewer than five rows.", settling_contact: "The curve bends where it begins: look at the contact.",
    unexpected_stiffness: "The fitted bending stiffness is not that stated.",
  };
  return words[doubt] ?? "";
}

function numbers(fit: FitAnswer, text: CaseText): KeyNumber[] {
  const mu0 = fit.parameters.mu0, EI = fit.parameters.bending_stiffness, read = fit.friction_read, { slips, energy } = fit;
  const D = text.hasRoundSection ? text.quantity("specimen.diameter") : null;
  const signed = (share: number): string => `${fixed(Math.abs(100 * share), 0)} % ${share < 0 ? "less" : "more"}`;
  const friction: KeyNumber = { label: "Friction at the supports *μ*", value: NOTHING, rest: "", condition: read ? `80 % of points ${fixed(read.low80, 2)} to ${fixed(read.high80, 2)}` : "" };
  if (mu0?.bound) Object.assign(friction, { value: `≤ ${significant(mu0.interval95[1], 2)}`, rest: "(95 %)" });
  else if (mu0) [friction.value, friction.rest] = estimate(mu0.value, mu0.standard_error, { name: "", command: "", factor: 1 });
  const work: KeyNumber = { label: "Friction in the work", value: NOTHING, rest: "", condition: "if the drops are slips" };
  if (energy) Object.assign(work, { value: `${fixed(100 * energy.friction_share, 0)} %`, rest: `of ${written(energy.work_of_fracture, "energy")}` });
  const spacing: KeyNumber = { label: "Fibre between slips", value: NOTHING, rest: "", condition: slips?.median_fall_of_mu != null ? `*μ* falls ${significant(slips.median_fall_of_mu, 2)} per slip` : "too few slips to tell" };
  if (slips?.median_spacing) {
    const u = unitFor(slips.median_spacing, "length");
    Object.assign(spacing, { value: significant(slips.median_spacing / u.factor, 2), rest: `${u.name}, median` });
  }
  const stiffness: KeyNumber = { label: "Bending stiffness *EI*", value: NOTHING, rest: "", condition: "" };
  const modulus: KeyNumber = { label: "Modulus *E*", value: NOTHING, rest: "", condition: D === null ? "no round section stated" : "" };
  if (EI) {
    const u = unitFor(EI.value, "bending"), [value, error] = estimate(EI.value, EI.standard_error, u);
    Object.assign(stiffness, { value, rest: `${error} ${u.name}` });
    const over = fit.small_deflection?.over_fit;
    if (over) stiffness.condition = `initial slope says ${signed(over - 1)}`;
    if (D) {
      const E = EI.value / inertia(D), e = unitFor(E, "modulus"), [ofE, errorOfE] = estimate(E, EI.standard_error / inertia(D), e);
      Object.assign(modulus, { value: ofE, rest: `${errorOfE} ${e.name}` });
      const given = text.quantity("specimen.modulus"), nominal = fit.nominal_bending_stiffness;
      modulus.condition = given === null ? "not stated" : `given: ${estimate(given, given * (nominal?.relative_error ?? 0.03), e).join(" ")}`;
    }
  }
  return [friction, work, spacing, stiffness, modulus];
}

const num = (check: Check, name: string): number => (typeof check[name] === "number" ? (check[name] as number) : NaN);

function checkInWords(check: Check, fit: FitAnswer): string {
  const possible = check.passed !== null;
  switch (check.name) {
    case "residuals": return `Fit misses the force by ${significant((100 * num(check, "residual_rms")) / num(check, "greatest_force"), 2)} %`;
    case "drops": {
      if (!possible) return "Drops of the fit? Cannot be counted";
      const low = num(check, "draws_low"), high = num(check, "draws_high");
      return `Fit drops ${low === high ? low : `${low} to ${high}`} times, record ${num(check, "record")}`;
    }
    case "whiteness": return !possible ? "What is left noise? Cannot tell" : `What is left is ${check.passed ? "" : "not "}noise, *p* ${num(check, "p_value") < 1e-3 ? "< 0.001" : `= ${significant(num(check, "p_value"), 2)}`}`;
    case "nesting": return check.passed === false ? "A simpler explanation fits better" : "No simpler explanation fits better";
    case "friction": return check.passed === false ? `*μ* not told from 0, at most ${significant(num(check, "mu0_high"), 2)}` : "Friction told from zero";
    case "stiffness": return !possible ? "*EI* as stated? Not fitted" : `*EI* ${minus((100 * (num(check, "fitted_over_nominal") - 1)).toFixed(0))} % from ${fit.nominal_bending_stiffness?.source === "initial_slope" ? "initial slope" : "stated"}, ${significant(num(check, "errors"), 2)} errors`;
    default: return check.name;
  }
}

function checks(fit: FitAnswer): CheckLine[] {
  const lines: CheckLine[] = [], { suspect_criteria: points, teeth } = fit, above = fit.suspects.length;
  const limit = points.limit;
  lines.push(above === 0 ? { mark: "passed", words: `*μ* below ${limit} at all ${points.points_judged} points`, reason: "" }
    : { mark: "warning", words: `*μ* above ${limit} at ${above} of ${points.points_judged} points`, reason: "So much friction is implausible. Rollers taken for edges, a wrong diameter or span would need it, too." });
  const pick = (name: string): void => {
    const check = fit.checks.find((c) => c.name === name);
    if (check) lines.push({ mark: check.passed === null ? "cannot" : check.passed ? "passed" : "warning", words: checkInWords(check, fit), reason: check.passed === false ? (check.remedy ?? "") : "" });
  };
  pick("drops");
  pick("stiffness");
  if (teeth) {
    const told = teeth.sliding + teeth.as_if_stuck + teeth.undecided;
    lines.push(teeth.as_if_stuck === 0 && teeth.sliding > 0 ? { mark: "passed", words: `${teeth.sliding} of ${told} rises slide, none sticks`, reason: "" }
      : { mark: "cannot", words: `${teeth.sliding} of ${told} rises slide, ${teeth.as_if_stuck} cannot be told from sticking`, reason: "Friction that grows with the place stiffens a rise as sticking does." });
  } else lines.push({ mark: "cannot", words: "Rises slide? Too few to tell", reason: "" });
  pick("whiteness");
  const lost = fit.judgement?.stiffness_lost;
  lines.push(lost == null ? { mark: "cannot", words: "Stiffness lost? No reload, cannot tell", reason: "Unload to almost no force and load once more." }
    : { mark: fit.judgement!.doubts.includes("softer_reload") ? "warning" : "passed", words: `Stiffness lost: ${fixed(100 * lost, 0)} ± ${fixed(100 * (fit.judgement!.stiffness_lost_error ?? 0), 0)} %`, reason: "" });
  for (const check of fit.checks)
    if (check.passed === false && ["residuals", "nesting", "friction", "stability"].includes(check.name)) pick(check.name);
  return lines;
}

export const answerOf = (fit: FitAnswer, text: CaseText): Answer => ({ ...verdict(fit), numbers: numbers(fit, text), checks: checks(fit) });
