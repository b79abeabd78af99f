// What a fit comes to, in the program's own words: its verdict, its rows and doubts, its readings of drops. The page words and judges nothing itself.

import type { Drop, Finding, FitAnswer, Line } from "./answers";
import { fixed, unitFor, written } from "./quantity";

export const inWords = ({ sentence, remedy }: Finding): string => [sentence, remedy].filter(Boolean).join(" ");
/** What casts doubt on the answer, and what to do next: below its rows. */
export const doubtsOf = (fit: FitAnswer): Line[] => fit.doubts.map((doubt) => ({ label: doubt.severity, words: inWords(doubt) }));
export const nextOf = ({ next }: FitAnswer): Line[] => (next ? [{ label: "next", words: next }] : []);

export type Slip = "could" | "undecided" | "no";
export const slipOf = (drop: Drop): Slip => (drop.slip === "possible" ? "could" : drop.slip === "too_short" ? "undecided" : "no");

/** A drop in words: "Drop 9: slip". */
export function dropInWords(drop: Drop, number: number, told = true): { claim: string; rest: string; more: string } {
  const mu = drop.mu_before !== null && drop.mu_after !== null ? `, *μ* ${fixed(drop.mu_before, 2)} to ${fixed(drop.mu_after, 2)}` : "";
  const drawn = drop.pulled_in ? `, ${written(drop.pulled_in / 2, "length")} slid in over each support` : "";
  return { claim: `Drop ${number}: ${drop.reading}`, rest: `; ${written(drop.force_fall, "force")} down`, more: told && slipOf(drop) === "could" ? `${mu}${drawn}` : "" };
}

/** A force of the record, in the unit of its drops: the same words wherever it stands. */
export function forceInWords(force: number, fit: FitAnswer): string {
  const unit = unitFor(fit.drops[0]?.force_before ?? force, "force");
  return Number.isFinite(force) ? `${fixed(force / unit.factor, 2)} ${unit.name}` : "–";
}

/** The program gives no answer but what to correct. */
export const isWithdrawn = (fit: FitAnswer): boolean => fit.verdict.code === "check_input" || fit.verdict.code === "no_answer";

/** Where the program's answer has no friction, nothing is shown that presumes one: no model, no profile, no parameters. */
export const tellsFriction = (fit: FitAnswer): boolean => !isWithdrawn(fit) && fit.answer.some(({ label, words }) => label === "friction" && !words.startsWith("none"));
