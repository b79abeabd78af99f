// The answer above the views: the verdict, five numbers, the checks, what to do next; and the strip of the marked moment.

import { answerOf, dropInWords, slipOf, tellsFriction, type CheckLine } from "./answer";
import { byId, el, fill, rich, svg } from "./dom";
import { fixed, significant, unitFor } from "./quantity";
import type { Studio } from "./studio";
import { inPageWords, withBoxes } from "./words";

const glyph = (mark: CheckLine["mark"]): SVGElement =>
  svg("svg", { class: "glyph", viewBox: "0 0 14 14", role: "img", "aria-label": { passed: "passed", warning: "look at this", cannot: "cannot tell" }[mark] },
    ...(mark === "passed" ? [svg("path", { d: "M2 7.500 5.500 11 12 3.500", fill: "none", stroke: "currentColor", "stroke-width": 2 })]
      : mark === "warning" ? [svg("path", { d: "M7 1.200 13.200 12.500H.8z", fill: "none", stroke: "currentColor", "stroke-width": 1.4 }), svg("path", { d: "M7 5v4M7 10.200v1.300", stroke: "currentColor", "stroke-width": 1.4 })]
      : [svg("path", { d: "M3 7h8", stroke: "currentColor", "stroke-width": 1.6 })]));

export function drawAnswer(studio: Studio): void {
  const { fit, test } = studio, host = byId("answer");
  if (!fit) {
    const busy = studio.isBusy(test), words = !test ? "" : test.refusal ? inPageWords(test.refusal, test) : busy ? "" : `Say what is asked under “How ${test.data} was read”, then press Fit.`;
    fill(host, el("p", { class: "lead" }, test?.read ? `${test.name}: ${test.read.rows} rows read.` : ""), el("h1", {}, studio.fitting?.test === test && test ? "Fitting…" : busy ? "Waits to be fitted…" : !test ? "" : test.read ? "Not fitted yet." : "Not read yet."),
      el("p", { class: "say" }, words));
    return;
  }
  const answer = answerOf(fit.answer, fit.text), passed = answer.checks.filter((c) => c.mark === "passed");
  fill(host, test?.refusal ? el("p", { class: "say" }, inPageWords(test.refusal, test), " Below stands the answer before that.") : null,
    el("h1", {}, answer.verdict, el("span", {}, answer.rest && `. ${withBoxes(answer.rest)}`)),
    el("div", { class: "numbers" }, ...answer.numbers.map((n) => el("div", {}, el("div", { class: "label" }, rich(n.label)), el("div", { class: "value" }, n.value, " ", el("em", {}, rich(n.rest))), el("span", { class: "condition", title: n.condition.replace(/[*_]/g, "") }, rich(n.condition))))),
    el("ul", { class: "checks", "aria-label": "Checks of the fit" }, 
      ...answer.checks.filter((c) => c.mark !== "passed").map((c) => el("li", { class: c.mark, tabindex: 0 }, glyph(c.mark), el("span", {}, rich(c.words)), el("div", { class: "reason" }, withBoxes(c.reason)))),
      passed.length ? el("li", { class: "passed", tabindex: 0 }, glyph("passed"), el("span", {}, `${passed.length} ${passed.length === 1 ? "check" : "checks"} passed`), el("ul", { class: "reason" }, ...passed.map((c) => el("li", {}, glyph("passed"), el("span", {}, withBoxes(c.reason)))))) : null),
    el("p", { class: "lead" }, answer.next ? withBoxes(`Next: ${answer.next[0]!.toLowerCase()}${answer.next.slice(1)}`) : ""));
}

/** One line: the row, its numbers, and what can be said of the drop. */
export function drawMoment(studio: Studio): void {
  const host = byId("moment"), moment = studio.moment, fit = studio.fit;
  if (!moment || !fit) return fill(host);
  const length = unitFor(fit.greatestStage, "length"), force = unitFor(fit.answer.drops[0]?.force_before ?? moment.force, "force");
  const cell = (name: string, value: string, width: number, unit: string, extra = ""): HTMLElement => {
    const b = el("b", {}, value);
    b.style.minWidth = `${width}px`;
    return el("span", { class: `cell ${extra}` }, el("span", {}, rich(name)), b, unit ? el("span", {}, unit) : null);
  };
  const number = (value: number, factor: number, digits = 1): string => (Number.isFinite(value) ? fixed(value / factor, digits) : "–");
  const mu = Number.isFinite(moment.mu) ? `${fixed(moment.mu, 3)}${Number.isFinite(moment.muError) ? ` ± ${fixed(moment.muError, 3)}` : ""}` : "not told yet";
  const told = tellsFriction(fit.answer), words = moment.drop ? dropInWords(moment.drop.drop, moment.drop.number, told) : null;
  fill(host, el("span", { class: "dot" }),
    studio.tried !== null ? el("span", { class: "cell" }, el("span", {}, "tried")) : cell("row", String(moment.row), 23, ""),
    cell("stage", number(moment.stage, length.factor), 37, length.name), cell("deflection", number(moment.deflection, length.factor), 37, length.name, "narrow-keep"),
    cell("force", number(moment.force, force.factor, 2), 34, force.name), cell("*μ*", moment.used && told ? mu : "–", 78, ""),
    cell("drawn in, each side", number(moment.drawn / 2, length.factor), 34, length.name, "wider"),
    el("span", { class: "drop" }, words ? el("b", { class: slipOf(moment.drop!.drop) }, words.claim) : null, words ? rich(words.rest) : null, words?.more ? el("span", { class: "wider" }, rich(words.more)) : null, words ? null : moment.leftOut || null));
}

/** For a screen reader, when the moment was moved by a key. */
export function momentInWords(studio: Studio): string {
  const moment = studio.moment, fit = studio.fit;
  if (!moment || !fit) return "";
  const drop = moment.drop ? `, ${dropInWords(moment.drop.drop, moment.drop.number).claim}` : "";
  const force = unitFor(moment.force, "force");
  return `Row ${moment.row}, force ${significant(moment.force / force.factor)} ${force.name}${Number.isFinite(moment.mu) && tellsFriction(fit.answer) ? `, friction ${fixed(moment.mu, 2)}` : ""}${drop}`;
}
