// What a fit comes to, in the program's own lines: its screen, its verdict, its readings of drops. The page words and judges nothing itself.

import type { Drop, FitAnswer } from "./answers";
import { fixed, unitFor, written } from "./quantity";

export interface Line { label: string; words: string }
/** What `flexslip fit` prints below the verdict: its rows, and what it says of the checks. */
export interface Screen { lines: Line[]; foot: string }

export function screenOf(text: string): Screen {
  const all = text.trimEnd().split("\n"), begin = all.indexOf("") + 1, lines: Line[] = [];
  for (const line of all.slice(begin)) {
    const row = /^ {2}(\S.*?) {2,}(\S.*)$/.exec(line), more = /^ {4,}(\S.*)$/.exec(line);
    if (row) lines.push({ label: row[1]!, words: row[2]! });
    else if (more && lines.length) lines[lines.length - 1]!.words += ` ${more[1]}`;
  }
  const foot = all.slice(begin).filter((line) => !line.startsWith(" ")).join(" ");
  return { lines, foot: foot.replace(/ ?More: --full$/, "") };
}

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
