// The list of tests with their verdicts, and the pinned curves.

import { doubtsOf } from "./answer";
import { remarksOf, sentence, type FitAnswer } from "./answers";
import { byId, el, fill, svg } from "./dom";
import { openDialog } from "./keys";
import { download } from "./outputs";
import { greatest } from "./plot";
import { isStale, messageOf, type Studio } from "./studio";
import type { Files, Test } from "./test";
import { inPageWords, questionOf, withBoxes } from "./words";

/** The curve from 60 to 100 % of its greatest force, in 84 by 24. */
function spark(test: Test): SVGElement {
  const drawing = svg("svg", { width: "100%", height: 22, viewBox: "0 0 84 24", preserveAspectRatio: "none", "aria-hidden": "true" });
  const fit = test.fit, w = fit?.curves.column("w") ?? test.rows?.stage;
  let force = fit?.curves.column("F") ?? test.rows?.force;
  if (!w?.length || !force) return drawing;
  if (greatest(force) < greatest(force.map((f) => -f))) force = force.map((f) => -f);  // compression counted as negative
  const most = greatest(force);
  if (!(most > 0)) return drawing;
  const from = force.findIndex((f) => f > 0.6 * most), end = w[w.length - 1]!, begin = w[from] ?? 0, step = Math.max(1, Math.floor((w.length - from) / 168));
  let d = "";
  for (let i = Math.max(0, from); i < w.length; i += step) if (Number.isFinite(w[i]!) && Number.isFinite(force[i]!)) d += `${d ? "L" : "M"}${(((w[i]! - begin) / (end - begin || 1)) * 83 + 0.5).toFixed(1)} ${Math.min(23.5, 23 - ((force[i]! / most - 0.6) / 0.4) * 22).toFixed(1)}`;
  drawing.append(svg("path", { d, fill: "none", stroke: "var(--ink2)", "stroke-width": 1, "vector-effect": "non-scaling-stroke" }));
  return drawing;
}

const KINDS: Readonly<Record<string, string>> = { slip: "ok", settled: "ok", no_drops: "none" };

/** The word of the verdict, or how far it is. */
function badgeOf(studio: Studio, test: Test): HTMLElement {
  const fit = test.fit?.answer, badge = (words: string, kind: string): HTMLElement => el("span", { class: `badge ${kind}` }, words);
  if (studio.fitting?.test === test) return badge("fitting", "none");
  if (studio.waiting.includes(test)) return badge("waits", "none");
  if (!fit) return badge(questionOf(test) ? "question" : "not fitted", "none");
  return badge(wordOf(fit), KINDS[fit.verdict.code] ?? "warn");
}
const wordOf = (fit: FitAnswer): string => /^[^.:]*/.exec(fit.verdict.sentence)![0];
const lineOf = (fit: FitAnswer, label: string): string => withBoxes(fit.answer.find((line) => line.label === label)?.words ?? "");

export function drawTests(studio: Studio): void {
  const focus = document.activeElement?.closest("#tests") !== null && document.activeElement?.closest("#tests") !== undefined;
  byId("all").hidden = studio.tests.length < 2;
  byId<HTMLButtonElement>("fit-all").disabled = !studio.tests.some((test) => isStale(test) && !studio.isBusy(test));
  fill(byId("tests"), ...studio.tests.map((test) => {
    const fit = test.fit?.answer, selected = test === studio.test;
    return el("li", { class: selected ? "selected" : null }, el("button", {
      class: "test", "aria-current": selected ? "true" : null, tabindex: selected ? 0 : -1, title: fit ? `${test.name}: ${fit.verdict.sentence}` : test.refusal ? inPageWords(test.refusal, test) : test.name,
      click: () => studio.select(test),
      keydown: (event: KeyboardEvent) => {
        if (event.key === "ArrowDown" || event.key === "ArrowUp") studio.next(event.key === "ArrowDown" ? 1 : -1);
        else if (event.key === "Delete") studio.remove(test);
        else return;
        event.preventDefault();
        event.stopPropagation();
      },
    }, el("b", {}, test.name), spark(test), badgeOf(studio, test), el("span", { class: "note" }, fit ? lineOf(fit, "friction") : "")),
      el("button", { class: "away", tabindex: selected ? 0 : -1, title: "Take away (Del); undo brings it back", "aria-label": `Take ${test.name} away`, click: () => studio.remove(test) }, "×"));
  }));
  if (focus) byId("tests").querySelector<HTMLElement>(".selected .test")?.focus();
}

/** All tests in a table; its rows as CSV are those of `flexslip campaign`, which evaluates them together. */
export function openTests(studio: Studio): void {
  const fitted = studio.tests.filter((test) => test.fit), titles = ["test", "verdict", "friction", "work", ...(fitted.some(({ fit }) => fit!.answer.doubts.length) ? ["doubts"] : [])];
  const row = ({ name, fit }: Test): HTMLElement => el("tr", {}, el("th", { scope: "row" }, name), ...[wordOf(fit!.answer), lineOf(fit!.answer, "friction"), lineOf(fit!.answer, "work"), doubtsOf(fit!.answer).map(({ words }) => withBoxes(words)).join(" ")].slice(0, titles.length - 1).map((words) => el("td", { class: "words" }, words)));
  const save = el("button", { class: "button outlined", disabled: fitted.length === 0, click: async () => {
    save.disabled = true;
    try {
      const { table, remarks } = await tableOf(studio, fitted, (line) => (save.textContent = line));
      download("tests.csv", table, "text/csv;charset=utf-8");
      if (remarks) note.textContent = remarks;
      for (const test of fitted) test.saved = test.fit;
    } catch (cause) {
      studio.report(`The table could not be written: ${messageOf(cause)}`);
    }
    save.disabled = false;
    save.textContent = "Save as CSV";
  } }, "Save as CSV");
  const note = el("span", { class: "note", role: "status" }, "every column of a campaign, evaluated once more together; its modulus is that of the slope, not of the fit"), left = studio.tests.length - fitted.length;
  openDialog("Tests", [
    el("table", { class: "tests-table" }, el("thead", {}, el("tr", {}, ...titles.map((words) => el("th", { scope: "col" }, words)))), el("tbody", {}, ...fitted.map(row))),
    ...(left ? [el("p", { class: "note" }, `${left} not fitted yet: press Fit all.`)] : []), el("p", {}, save, " ", note),
  ]);
}
/** The rows that `flexslip campaign` writes of these tests, and what it says of those that it leaves out. */
async function tableOf(studio: Studio, tests: Test[], progress: (line: string) => void): Promise<{ table: string; remarks: string }> {
  const files: Files = {}, names = new Set<string>();
  for (const { name, fit, files: of, main } of tests) {
    let folder = name;
    for (let i = 2; names.has(folder); ++i) folder = `${name} ${i}`;
    names.add(folder);
    for (const [file, bytes] of Object.entries({ ...of, ...fit!.given })) if (file !== main || !main.endsWith(".toml")) files[`tests/${folder}/${file}`] = bytes;
    files[`tests/${folder}/case.toml`] = new TextEncoder().encode(fit!.answer.provenance.case);
  }
  const lane = studio.program.another();
  try {
    const told = await lane.run(["campaign", "tests", "--report", "table", "--no-figures", "--jobs", "1"], files, progress), table = told.files["table/tests.csv"];
    if (!table) throw new Error(sentence(told.err));
    return { table: new TextDecoder().decode(table), remarks: remarksOf(told.err) };
  } finally {
    lane.cancel();
  }
}

export function drawPins(studio: Studio): void {
  byId("pins-section").hidden = studio.pins.length === 0;
  fill(byId("pins"), ...studio.pins.map((pin) => {
    const box = el("input", { type: "checkbox", change: () => {
      pin.on = box.checked;
      studio.tell("pins");
    } });
    box.checked = pin.on;
    return el("li", {}, el("label", {}, box, svg("svg", { width: 18, height: 4, "aria-hidden": "true" }, svg("path", { d: "M0 2h18", stroke: "var(--pin)", "stroke-width": 1.6 })), pin.name),
      el("button", { class: "away", "aria-label": `Take ${pin.name} away`, click: () => {
        studio.pins = studio.pins.filter((p) => p !== pin);
        studio.tell("pins");
      } }, "×"));
  }));
}
