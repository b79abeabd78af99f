// Friction along the fibre: points read off the curve with their errors, the mean of the fit and its band, friction by the sliders.

import { tellsFriction } from "./answer";
import { byId, el, fill, label, svg } from "./dom";
import { seenTo } from "./model";
import { area, axes, dots, dotted, frameOf, greatest, haloed, lineThrough, path, placeIn, sized, sizeOf, type Frame } from "./plot";
import { signed, unitFor, type Unit } from "./quantity";
import type { Studio } from "./studio";
import type { Fit } from "./test";

const MARGINS = { left: 54, right: 76, top: 12, bottom: 34 };
const WORTH_SAYING = 0.0005;  // of friction
const UNTOLD = 0.5;  // points with a larger error than this would only fill the plot

export class FrictionView {
  private readonly host = byId("friction-plot");
  private readonly drawing = svg("svg", { role: "img", "aria-hidden": "true" });
  private readonly marker = svg("g", { class: "marker" });
  private readonly restated = svg("g");  // the band as it would be told
  private readonly hangs = byId("hangs");
  private listed: Fit | null = null;
  private frame: Frame | null = null;
  private still: { fit: Fit; key: string } | null = null;
  private unit: Unit = unitFor(1e-4, "length");

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing);
    const pick = (event: PointerEvent): void => this.pick(event);
    this.host.addEventListener("pointermove", pick);
    this.host.addEventListener("pointerdown", pick);
  }

  /** Past each support, in metres. */
  private past(fit: Fit, S: Float64Array): Float64Array {
    return S.map((length) => (length - fit.fitted.L) / 2);
  }

  draw(): void {
    const { studio } = this, fit = studio.fit, reach = this.reach();
    this.listHangs(fit);
    const v = studio.values, key = JSON.stringify([sizeOf(this.host), reach, studio.wave, v && [v.mu0, v.rms, v.len, v.amp, v.lam, v.phi]]);
    if (this.frame && this.still?.fit === fit && this.still?.key === key) return this.mark();
    this.still = fit ? { fit, key } : null;
    this.frame = null;
    if (!fit || !fit.friction.length.length || !tellsFriction(fit.answer)) {
      this.host.setAttribute("aria-label", "Friction along the specimen: nothing to show yet");
      return sized(this.drawing, this.host, svg("g"));
    }
    const points = fit.answer.profile.filter((p) => p.mu_error < UNTOLD);
    const px = Float64Array.from(points, (p) => (p.length - fit.fitted.L) / 2), mu = Float64Array.from(points, (p) => p.mu);
    const seen = fit.friction.seen, bandX = this.past(fit, fit.friction.length.subarray(0, seen)), mean = fit.friction.mean.subarray(0, seen), { deviation } = fit.friction;
    const hand = studio.frictionByHand(), farthest = Math.max(greatest(px), greatest(bandX)), least = Math.min(0, ...bandX);
    const changedReach = farthest * reach;
    const unit = (this.unit = unitFor(farthest, "length")), sorted = [...mu].sort((a, b) => a - b);
    const most = Math.max(1, (sorted[Math.floor(sorted.length * 0.98)] ?? 1) * 1.15, hand ? greatest(hand.mu.subarray(0, seen)) * 1.1 : 0);
    const frame = (this.frame = frameOf(this.host, MARGINS, [least / unit.factor, (changedReach * 1.01) / unit.factor], [0, Math.min(3, most)]));
    const x = frame.x.copy().domain([least, changedReach * 1.01]), { y } = frame;
    const bottom = frame.height - MARGINS.bottom, right = frame.width - MARGINS.right;
    const clip = svg("clipPath", { id: "friction-clip" }, svg("rect", { x: MARGINS.left, y: MARGINS.top - 4, width: Math.max(0, right - MARGINS.left), height: Math.max(0, bottom - MARGINS.top + 4) }));
    const inside = svg("g", { "clip-path": "url(#friction-clip)" });
    inside.append(svg("path", { d: area(bandX, mean.map((m, i) => m - 1.96 * deviation[i]!), mean.map((m, i) => m + 1.96 * deviation[i]!), x, y), fill: "var(--band)" }));
    inside.append(path(points.map((p, i) => `M${x(px[i]!).toFixed(1)} ${y(p.mu - p.mu_error_force).toFixed(1)}V${y(p.mu + p.mu_error_force).toFixed(1)}`).join(""), "var(--mute)", 1));
    for (const slip of this.slips(fit)) {
      const a = x((slip[0] - fit.fitted.L) / 2), b = x((slip[1] - fit.fitted.L) / 2);
      inside.append(svg("rect", { x: a, y: bottom - 6, width: Math.max(1.5, b - a), height: 5, fill: "var(--ok)" }));
    }
    if (hand) for (const [from, to, opacity] of [[0, seen, 1], [seen - 1, hand.length.length, 0.4]] as const) inside.append(path(lineThrough(this.past(fit, hand.length), hand.mu, x, y, from, to), "var(--model)", 1.4, { "stroke-opacity": opacity }));
    inside.append(dotted(dots(px, mu, x, y), "var(--data)", px.length > 600 ? 1.8 : 2.4));
    const side = svg("g"), mu0 = fit.answer.parameters.mu0;
    if (mu0 && !mu0.bound) {
      const cx = right + 12, at = y(studio.values?.mu0 ?? mu0.value);
      side.append(svg("line", { x1: cx, x2: cx, y1: y(mu0.interval95[0]), y2: y(mu0.interval95[1]), stroke: "var(--model)", "stroke-width": 3 }),
        svg("circle", { cx, cy: at, r: 3.5, fill: "var(--surface)", stroke: "var(--model)", "stroke-width": 1.6 }), label("mean *μ*₀", { x: cx + 8, y: at + 4 }));
    }
    if (this.slips(fit).length) side.append(svg("text", { x: right + 2, y: bottom - 1, fill: "var(--ink3)" }, "slips"));
    sized(this.drawing, this.host, svg("defs", {}, clip), axes(frame, `${least < 0 ? "place of the contact, inwards" : "sliding length over each support"} (${unit.name})`, { x: Math.max(3, Math.round(frame.width / 90)), y: 5 }), inside, this.restated, side, this.marker);
    this.host.setAttribute("aria-label", `Friction along the specimen of ${fit.answer.name}: ${points.length} points${mu0 ? `, mean ${mu0.value.toFixed(2)}` : ""}. Arrow keys move row by row.`);
    this.mark();
  }

  /** How much farther than the record the fibre is drawn in by the sliders, in steps of an eighth. */
  private reach(): number {
    const { loading, fit, changed } = this.studio;
    if (!changed || !loading || !fit || !fit.friction.seen) return 1;
    return Math.max(1, Math.min(1.375, Math.ceil((8 * greatest(loading.drawn)) / seenTo(fit) - 0.4) / 8));
  }
  private slips(fit: Fit): [number, number][] {
    return (fit.answer.slips?.slips ?? []).map((s) => [s.length_before, s.length_after]);
  }

  /** What friction depends on, a button each; pointed at, it moves the band. */
  private listHangs(fit: Fit | null): void {
    if (this.listed === fit) return;
    this.listed = fit;
    const all = (fit && tellsFriction(fit.answer) ? fit.answer.sensitivities : []).filter((each) => Math.abs(each.friction_moves) >= WORTH_SAYING);
    this.hangs.hidden = all.length === 0;
    fill(this.hangs, el("span", { class: "note" }, "sensitivity"), ...all.map((each) => {
      const work = each.work_moves === null ? "" : `, its share of the work by ${signed(100 * each.work_moves, 1)} points`;
      const words = `${each.title}: ${each.stated}. If it is larger by ${each.may_be_off}, friction changes by ${signed(each.friction_moves, 3)}${work}`;
      return el("button", { class: "hang", title: words, "aria-label": words, pointerenter: () => this.studio.doubt(each), pointerleave: () => this.studio.doubt(null), focus: () => this.studio.doubt(each), blur: () => this.studio.doubt(null) },
        each.title, " ", el("b", {}, signed(each.friction_moves, 3)));
    }));
  }

  /** The band of the fit, moved by the change of friction. */
  markRestated(): void {
    const { studio } = this, fit = studio.fit, restated = studio.restated;
    this.restated.replaceChildren();
    if (!fit || !restated || !this.frame || !fit.friction.seen) return;
    const { seen } = fit.friction, S = this.past(fit, fit.friction.length.subarray(0, seen)), x = this.frame.x.copy().domain(this.frame.x.domain().map((d) => d * this.unit.factor)), { y } = this.frame;
    const edge = (errors: number): Float64Array => fit.friction.mean.subarray(0, seen).map((m, i) => m + restated.friction + errors * fit.friction.deviation[i]!);
    this.restated.append(svg("path", { class: "restated", d: area(S, edge(-1.96), edge(1.96), x, y), fill: "var(--band)", "clip-path": "url(#friction-clip)" }),
      ...[-1.96, 1.96].map((errors) => svg("path", { d: lineThrough(S, edge(errors), x, y), fill: "none", stroke: "var(--model)", "stroke-width": 1, "stroke-dasharray": "3 3", "clip-path": "url(#friction-clip)" })),
      haloed(`${signed(restated.friction, 3)} with ${restated.words}`, MARGINS.left + 8, MARGINS.top + 8, "start", "var(--model)"));
  }

  mark(): void {
    this.markRestated();
    const { studio } = this, fit = studio.fit, moment = studio.moment;
    this.marker.replaceChildren();
    if (!fit || !moment || !this.frame || !Number.isFinite(moment.drawn)) return;
    const px = this.frame.x((moment.drawn / 2) / this.unit.factor), bottom = this.frame.height - MARGINS.bottom;
    if (px > this.frame.x.range()[1]! + 1) return;
    const py = Number.isFinite(moment.mu) ? this.frame.y(Math.abs(moment.mu)) : NaN;
    this.marker.append(svg("line", { x1: px, x2: px, y1: Number.isFinite(py) ? Math.max(MARGINS.top, py + 5) : MARGINS.top, y2: bottom, stroke: "var(--moment)", "stroke-width": 1 }));
    if (Number.isFinite(py) && py >= 0) this.marker.append(svg("circle", { cx: px, cy: py, r: 4.5, fill: "var(--surface)", "fill-opacity": .6, stroke: "var(--moment)", "stroke-width": 1.8 }));
    if (studio.tried !== null && Number.isFinite(moment.mu)) this.marker.append(haloed(moment.mu < 0 ? "sliding out" : "", px + 8, (Number.isFinite(py) ? py : 20) - 6, "start", "var(--moment)"));
  }
  private pick(event: PointerEvent): void {
    const { studio } = this, fit = studio.fit;
    if (!fit || !this.frame) return;
    const place = this.frame.x.invert(placeIn(event, this.host)[0]) * this.unit.factor, S = fit.fitted.L + 2 * place;
    const lengths = fit.curves.column("S")!;
    // S grows with the rows but for noise, and has no value before friction shows.
    let best = -1, far = Infinity;
    for (let i = 0; i < lengths.length; ++i) {
      const d = Math.abs(lengths[i]! - S);
      if (d < far) {
        far = d;
        best = i;
      }
    }
    studio.tried = null;
    if (best >= 0) studio.setRow(fit.rows[best]!);
  }
}
