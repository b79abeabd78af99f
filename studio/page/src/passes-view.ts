// The passes of a record that was unloaded: their lines among the data, and the friction of each.

import { estimate } from "./answer";
import { byId, el, fill, svg } from "./dom";
import type { DrawnPass } from "./passes";
import { dotted, path } from "./plot";
import { plainUnit } from "./quantity";
import type { Fit } from "./test";

/** The line of a pass that is not evaluated: wide and pale beneath the data where it loads, dashed where it unloads. */
export const passLine = ({ words }: DrawnPass, d: string): SVGElement =>
  words === "out" ? path(d, "var(--pass)", 1.6, { "stroke-dasharray": "6 3" }) : path(d, "var(--pass)", 5, { "stroke-opacity": 0.6, "stroke-linecap": "round" });

/** Friction of each pass, and what the program says of them together; nothing where it says nothing. */
export function drawPasses(fit: Fit | null): void {
  const host = byId("passes-section"), said = fit?.answer.answer.find((row) => row.label === "reload")?.words ?? "";
  host.hidden = !fit?.passes.length || !said;
  if (host.hidden || !fit) return fill(byId("passes"));
  const cell = (...children: (Node | string)[]): HTMLElement => el("td", {}, ...children);
  fill(byId("passes"), el("thead", {}, el("tr", {}, ...["pass", "", "rows", "sliding", "friction ±"].map((words) => el("th", { scope: "col" }, words)))),
    el("tbody", {}, ...fit.passes.map((drawn) => {
      const { friction, rows, sliding_rows } = drawn.pass, mark = svg("svg", { width: 18, height: 12, "aria-hidden": "true" }, drawn.isEvaluated ? dotted("M2 6h0M9 6h0M16 6h0", "var(--data)", 3) : passLine(drawn, "M2 6h14"));
      return el("tr", {}, cell(mark, String(drawn.number)), cell(drawn.words), cell(`${rows[0]}–${rows[1]}`), cell(String(sliding_rows)), cell(friction ? estimate(friction.value, friction.standard_error, plainUnit).join(" ") : "–"));
    })));
  fill(byId("passes-said"), said);
}
