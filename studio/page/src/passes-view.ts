// A record that was unloaded, as the fit of all its passes has it: the causes of the drops, what settled, and the friction of each pass.

import { byId, el, fill, rich, svg } from "./dom";
import type { DrawnPass } from "./passes";
import { axes, dots, dotted, frameOf, greatest, haloed, sized } from "./plot";
import { probability, unitFor, withError } from "./quantity";
import type { Studio } from "./studio";
import type { Fit } from "./test";

const MARGINS = { left: 38, right: 8, top: 16, bottom: 32 };
const CERTAIN = 2;  // [standard errors] from which on something settled
const SHOWN = 0.98;  // [1] of the points: beyond them noise alone would set the axis

const CAUSES = [["slips", "slips only", "var(--ok)"], ["both", "slips and cracks", "var(--warn)"], ["cracks", "cracks only", "var(--bad)"]] as const;

export class PassesView {
  private readonly host = byId("boxes-plot");
  private readonly drawing = svg("svg", { role: "img" });

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing);
  }

  draw(): void {
    const { fit } = this.studio, isThere = fit?.answer.passes?.status === "ok";
    byId("passes-section").hidden = !isThere;
    if (!fit || !isThere) return fill(byId("passes"));
    fill(byId("passes"), this.causes(fit), this.settled(fit), this.table(fit));
    this.drawBoxes(fit);
  }

  /** The program tells slips with cracks from slips only where the specimen was loaded again. */
  private causes({ answer: { judgement } }: Fit): HTMLElement | null {
    const { causes } = judgement ?? {};
    if (causes?.both == null) return null;
    const shares = CAUSES.map(([cause, words, colour]) => ({ words, colour, share: causes[cause]! }));
    return el("div", { class: "causes" }, el("div", { class: "shares", "aria-hidden": "true" }, ...shares.map(({ share, colour }) => el("span", { style: `flex-grow:${share};background:${colour}` }))),
      ...shares.map(({ words, colour, share }) => el("div", {}, el("span", { class: "key", style: `background:${colour}` }), el("span", {}, words), el("b", {}, probability(share)))));
  }

  private settled({ answer: { passes, verdict } }: Fit): HTMLElement | null {
    const { settled } = passes!;
    if (!settled || verdict.code === "settled" || settled.value < CERTAIN * settled.standard_error) return null;
    return el("p", {}, `Settled by ${withError(settled, unitFor(settled.value, "length"))}.`);
  }

  private table({ passes }: Fit): HTMLElement {
    const row = ({ number, words, isEvaluated, pass }: DrawnPass): HTMLElement =>
      el("tr", { class: isEvaluated ? "evaluated" : null }, el("th", { scope: "row" }, `${number}: ${words}`), el("td", {}, pass.rows.join("–")), el("td", {}, pass.friction ? withError(pass.friction) : "–"));
    return el("table", { class: "pass-table" }, el("thead", {}, el("tr", {}, ...["pass", "rows", "friction *μ*"].map((title) => el("th", { scope: "col" }, rich(title))))), el("tbody", {}, ...passes.map(row)));
  }

  /** Mobilised friction against the length slid: up while the specimen slides in, across while it sticks, below while it slides out. */
  private drawBoxes(fit: Fit): void {
    const points = fit.passes.map(({ pass }) => ({ x: Float64Array.from(pass.drawn_in, (length) => length / 2), q: Float64Array.from(pass.q), slides: pass.slides }));
    const farthest = greatest(points.map(({ x }) => greatest(x))), unit = unitFor(farthest, "length");
    const sizes = points.flatMap(({ q }) => [...q].map(Math.abs)).sort((a, b) => a - b), most = 1.25 * (sizes[Math.floor(SHOWN * (sizes.length - 1))] ?? 1);
    const frame = frameOf(this.host, MARGINS, [0, (1.02 * farthest) / unit.factor], [-most, most]), { y } = frame, x = frame.x.copy().domain([0, 1.02 * farthest]);
    const inside = svg("g", { "clip-path": "url(#boxes-clip)" }, svg("line", { x1: MARGINS.left, x2: frame.width - MARGINS.right, y1: y(0), y2: y(0), stroke: "var(--line)" }));
    points.forEach(({ x: lengths, q, slides }, i) => {
      const only = (moves: number): Float64Array => q.map((value, j) => (slides[j] === moves ? value : NaN));
      inside.append(dotted(dots(lengths, only(0), x, y), "var(--mute)", 1.8), dotted(dots(lengths, only(1), x, y), fit.passes[i]!.isEvaluated ? "var(--data)" : "var(--pass)", 2.6));
    });
    const clip = svg("clipPath", { id: "boxes-clip" }, svg("rect", { x: MARGINS.left, y: MARGINS.top, width: Math.max(0, frame.width - MARGINS.left - MARGINS.right), height: Math.max(0, frame.height - MARGINS.top - MARGINS.bottom) }));
    sized(this.drawing, this.host, svg("defs", {}, clip), axes(frame, `slid over each support (${unit.name})`, { x: 4, y: 4 }), inside, haloed("mobilised *q*", MARGINS.left, 10, "start"));
    this.drawing.setAttribute("aria-label", `Mobilised friction of ${fit.passes.length} passes against the length slid over each support`);
  }
}
