// The list of tests with their verdicts, and the pinned curves.

import { estimate, slipOf } from "./answer";
import { byId, el, fill, rich, svg } from "./dom";
import { greatest } from "./plot";
import { fixed, plainUnit } from "./quantity";
import type { Studio } from "./studio";
import type { Test } from "./test";

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

export function drawTests(studio: Studio): void {
  const focus = document.activeElement?.closest("#tests") !== null && document.activeElement?.closest("#tests") !== undefined;
  fill(byId("tests"), ...studio.tests.map((test) => {
    const fit = test.fit?.answer, drops = fit?.drops.length ?? 0, slips = fit?.drops.filter((d) => slipOf(d) === "could").length ?? 0, mu = fit?.parameters.mu0;
    const doubtful = fit?.status !== "ok" || fit?.suspect || slips < drops;
    const badge = !fit ? el("span", { class: "badge none" }, studio.fitting?.test === test ? "fitting" : "not fitted")
      : drops === 0 ? el("span", { class: `badge ${doubtful ? "warn" : "none"}` }, doubtful ? "! no answer" : "no drops")
      : el("span", { class: `badge ${doubtful ? "warn" : "ok"}` }, `${doubtful ? "! " : ""}${slips} of ${drops}`);
    const selected = test === studio.test;
    return el("li", {
      role: "option", "aria-selected": String(selected), tabindex: selected ? 0 : -1, title: fit ? `${test.name}: ${slips} of ${drops} drops could be slips${fit.suspect ? "; the test is suspect" : ""}` : test.name,
      click: () => studio.select(test),
      keydown: (event: KeyboardEvent) => {
        if (event.key === "Enter" || event.key === " ") studio.select(test);
        else if (event.key === "ArrowDown" || event.key === "ArrowUp") studio.next(event.key === "ArrowDown" ? 1 : -1);
        else if (event.key === "Delete") studio.remove(test);
        else return;
        event.preventDefault();
        event.stopPropagation();
      },
    }, el("div", {}, el("b", {}, test.name), el("span", { class: "note" }, mu && !mu.bound ? rich(`*μ* ${estimate(mu.value, mu.standard_error, plainUnit, 3).join(" ")}`) : mu ? rich(`*μ* ≤ ${fixed(mu.interval95[1], 2)}`) : " ")), spark(test), badge);
  }));
  if (focus) byId("tests").querySelector<HTMLElement>("[aria-selected=true]")?.focus();
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
