// The answer above the views: the verdict and the lines of the program, which unfold; and the strip of the marked moment.

import { doubtsOf, dropInWords, forceInWords, inWords, isWithdrawn, nextOf, slipOf, tellsFriction } from "./answer";
import type { Drop, Line } from "./answers";
import { byId, el, fill, rich } from "./dom";
import { fixed, unitFor } from "./quantity";
import type { Studio } from "./studio";
import { inPageWords, OF_ALL_FILES, questionOf, withBoxes } from "./words";

const FIRST = 3;  // lines that stand folded

const linesOf = (lines: Line[]): HTMLElement => el("dl", { class: "lines" }, ...lines.flatMap(({ label, words }) => [el("dt", {}, label), el("dd", {}, withBoxes(words))]));

export function drawAnswer(studio: Studio): void {
  const { fit, test } = studio, host = byId("verdict"), refusal = test?.refusal ? inPageWords(test.refusal, test) : "";
  if (!test) return fill(host);
  if (!fit) {
    const question = questionOf(test), busy = studio.fitting?.test === test && question === null ? "Fitting…" : studio.waiting.includes(test) && question === null ? "Waits to be fitted…" : "";
    const rows = test.read ? `${test.data}, ${test.read.rows} rows` : test.data;
    const more = question ? `${question.of > 1 ? `; ${question.of} questions are open` : ""}${studio.alike(test).length && OF_ALL_FILES.has(question.box) ? `. The answer holds for all ${studio.alike(test).length + 1} files` : ""}` : "";
    return fill(host, el("p", { class: "note" }, rows, more), el("h1", {}, question?.words ?? (busy || (refusal ? "Not fitted." : "Not fitted yet."))), question || busy ? null : el("p", { class: "say" }, refusal || "Press Fit."));
  }
  const { answer, doubts, checks, findings, verdict: { sentence } } = fit.answer, word = /^[^.:]*/.exec(sentence)![0], next = nextOf(fit.answer), last = [...doubtsOf(fit.answer), ...next], others = findings.filter(({ code }) => !doubts.some((doubt) => doubt.code === code));
  const open = host.querySelector("details")?.open ?? false, folded = linesOf([...answer.slice(0, FIRST), ...last]);
  const unfolded = el("details", { class: "all", toggle: () => (folded.hidden = unfolded.open) }, el("summary", {}, "All lines"), linesOf([...answer, ...last]), el("p", { class: "note" }, `${checks} ± is one standard error.`.trim()),
    el("ul", { class: "note" }, ...others.map((finding) => el("li", {}, withBoxes(inWords(finding.remedy === fit.answer.next ? { ...finding, remedy: "" } : finding))))));
  unfolded.open = open;
  fill(host, refusal && el("p", { class: "say" }, refusal, " Below stands the answer before that."), el("h1", {}, el("b", {}, word), withBoxes(sentence.slice(word.length))),
    isWithdrawn(fit.answer) ? linesOf(next) : folded, isWithdrawn(fit.answer) ? null : unfolded);
}

/** One line: the row, its numbers, and what can be said of the drop. */
export function drawMoment(studio: Studio): void {
  const host = byId("moment"), moment = studio.moment, fit = studio.fit;
  if (!moment || !fit) return fill(host);
  const length = unitFor(fit.greatestStage, "length"), [force, forceUnit] = forceInWords(moment.force, fit.answer).split(" ");
  const cell = (name: string, value: string, width: number, unit: string): HTMLElement => {
    const b = el("b", {}, value);
    b.style.minWidth = `${width}px`;
    return el("span", { class: "cell" }, el("span", {}, rich(name)), b, unit ? el("span", {}, unit) : null);
  };
  const number = (value: number, factor: number, digits = 1): string => (Number.isFinite(value) ? fixed(value / factor, digits) : "–");
  const said = (words: ReturnType<typeof dropInWords> | null, drop?: Drop): HTMLElement =>
    el("span", { class: "drop" }, words && drop ? el("b", { class: slipOf(drop) }, words.claim) : null, words ? rich(words.rest) : null, words?.more ? el("span", { class: "wider" }, rich(words.more)) : null, words ? null : moment.leftOut || null);
  const { drops } = fit.answer, last = drops[drops.length - 1];  // where there is no drop, its room: the curve stays where it is
  const told = tellsFriction(fit.answer), words = moment.drop ? dropInWords(moment.drop.drop, moment.drop.number, told) : null;
  const mu = Number.isFinite(moment.mu) ? `${fixed(moment.mu, 3)}${Number.isFinite(moment.muError) ? ` ± ${fixed(moment.muError, 3)}` : ""}` : "not determined yet";
  fill(host, el("span", { class: "dot" }),
    studio.tried !== null ? el("span", { class: "cell" }, el("span", {}, "tried")) : cell("row", String(moment.row), 23, ""),
    cell("stage", number(moment.stage, length.factor), 37, length.name), cell("deflection", number(moment.deflection, length.factor), 37, length.name),
    cell(studio.tried !== null ? "force, calculated" : "force, measured", force!, 34, forceUnit ?? ""), moment.used && told ? cell("*μ*", mu, 78, "") : null,
    words || moment.leftOut || !last ? said(words, moment.drop?.drop) : el("span", { class: "room", "aria-hidden": "true" }, said(dropInWords(last, drops.length, told), last)));
}

/** For a screen reader, when the moment was moved by a key. */
export function momentInWords(studio: Studio): string {
  const moment = studio.moment, fit = studio.fit;
  if (!moment || !fit) return "";
  const drop = moment.drop ? `, ${dropInWords(moment.drop.drop, moment.drop.number).claim}` : "";
  return `Row ${moment.row}, force ${forceInWords(moment.force, fit.answer)}${Number.isFinite(moment.mu) && tellsFriction(fit.answer) ? `, friction ${fixed(moment.mu, 2)}` : ""}${drop}`;
}
