// Force against deflection or stage: data, model, band of the draws, references, load lines and marks of the drops, a lens around the moment.

import { select } from "d3-selection";
import { zoom, zoomIdentity, type D3ZoomEvent, type ZoomTransform } from "d3-zoom";
import { isWithdrawn, slipOf, tellsFriction } from "./answer";
import type { Drop } from "./answers";
import { byId, el, fill, label, svg } from "./dom";
import type { Loading } from "./engine";
import { seenTo, type Curve } from "./model";
import { kindsOf, type DrawnPass } from "./passes";
import { area, axes, dots, dotted, dropColour, dropMark, frameOf, greatest, haloed, least, lineThrough, path, placeIn, rangeIn, sized, sizeOf, type Frame, type Scale } from "./plot";
import { fixed, unitFor, type Unit } from "./quantity";
import type { Studio } from "./studio";
import type { Fit } from "./test";

const MARGINS = { left: 54, right: 24, top: 12, bottom: 34 };
const DRAWS = 20;

/** The line of a pass that is not evaluated: wide and pale beneath the data where it loads, dashed where it unloads. */
const passLine = ({ words }: DrawnPass, d: string): SVGElement =>
  words === "out" ? path(d, "var(--pass)", 1.6, { "stroke-dasharray": "6 3" }) : path(d, "var(--pass)", 5, { "stroke-opacity": 0.6, "stroke-linecap": "round" });

export class ForceView {
  private readonly host = byId("force-plot");
  // Three drawings over one another, so that what follows a slider or the pointer is painted without the two thousand points beneath it.
  private readonly drawing = svg("svg", { role: "img", "aria-hidden": "true" });
  private readonly moving = svg("svg", { class: "layer", "aria-hidden": "true" });
  private readonly over = svg("svg", { class: "layer", "aria-hidden": "true" });
  private readonly marker = svg("g", { class: "marker" });
  private frame: Frame | null = null;
  private readonly references = svg("g");
  private readonly model = svg("g");
  private still: { fit: Fit; key: string } | null = null;  // what was drawn that does not follow the sliders
  private transform: ZoomTransform = zoomIdentity;
  private reference: { fit: Fit; key: string; plain: Curve } | null = null;
  units: { x: Unit; y: Unit } = { x: unitFor(1e-4, "length"), y: unitFor(1e-2, "force") };

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing, this.moving, this.over);
    const toRow = (event: PointerEvent): void => this.pick(event);
    this.host.addEventListener("pointermove", toRow);
    this.host.addEventListener("pointerdown", toRow);
    const narrow = matchMedia("(max-width: 1100px)");
    const behaviour = zoom<HTMLElement, unknown>().scaleExtent([1, 60])
      .filter((event: Event) => (event instanceof WheelEvent ? !narrow.matches || event.ctrlKey : event instanceof MouseEvent ? event.shiftKey && event.button === 0 : event.type.startsWith("touch") && (event as TouchEvent).touches.length > 1))
      .on("zoom", (event: D3ZoomEvent<HTMLElement, unknown>) => {
        this.transform = event.transform;
        this.draw();
      });
    const selection = select<HTMLElement, unknown>(this.host).call(behaviour).on("dblclick.zoom", null);
    this.host.addEventListener("dblclick", () => selection.call((s) => behaviour.transform(s, zoomIdentity)));
    this.resetZoom = () => selection.call((s) => behaviour.transform(s, zoomIdentity));
    for (const axis of ["deflection", "stage"] as const)
      byId(`axis-${axis}`).addEventListener("click", () => {
        studio.axis = axis;
        studio.tell("axis");
      });
  }
  readonly resetZoom: () => void;

  private abscissa(fit: Fit): Float64Array {
    return fit.curves.column(this.studio.axis === "stage" ? "w_s" : "w")!;
  }
  private of(curve: Curve): Float64Array {
    return this.studio.axis === "stage" ? curve.stage : curve.deflection;
  }

  /** The curve without friction, computed anew only where it changes. */
  private withoutFriction(fit: Fit): Curve | null {
    const { values, rig, model } = this.studio;
    if (!values || !rig) return null;
    const key = [values.L, values.EI, values.D, values.R, values.kc].join();
    if (this.reference?.fit !== fit || this.reference.key !== key) {
      try {
        this.reference = { fit, key, plain: model.withoutFriction(rig) };
      } catch {
        return null;
      }
    }
    return this.reference.plain;
  }

  draw(): void {
    const { studio } = this, fit = studio.fit;
    for (const axis of ["deflection", "stage"] as const) byId(`axis-${axis}`).setAttribute("aria-pressed", String(studio.axis === axis));
    if (!fit || !studio.values || fit.rows.length === 0 || isWithdrawn(fit.answer)) {
      for (const drawing of [this.drawing, this.moving, this.over]) sized(drawing, this.host);
      this.still = null;
      this.host.setAttribute("aria-label", "Force against deflection: nothing to show yet");
      return this.drawRaw();
    }
    const xs = this.abscissa(fit), force = fit.curves.column("F")!;
    const mostX = Math.max(greatest(xs), ...fit.passes.map(({ curve }) => greatest(this.of(curve)))), mostF = Math.max(greatest(force), ...fit.passes.map(({ curve }) => greatest(curve.force))), { programmed } = studio;
    // The frame is that of the data; where the model leaves it, it grows in steps, so that it holds still while a slider moves.
    const room = (data: number, model: number, most: number): number => !(data > 0) ? data : data * Math.max(1, Math.min(most, Math.ceil((8 * model) / data - 0.16) / 8));
    const farthest = room(mostX, Math.max(programmed ? greatest(this.of(programmed)) : 0, studio.loading ? greatest(this.of(studio.loading)) : 0), 2);
    const highest = room(mostF, studio.loading ? greatest(studio.loading.force) : 0, 3);
    this.units = { x: unitFor(mostX, "length"), y: unitFor(mostF, "force") };
    const base = frameOf(this.host, MARGINS, [0, 1], [0, 1]);
    const sx = base.x.copy().domain([0, (farthest * 1.06) / this.units.x.factor || 1]), sy = base.y.copy().domain([0, (highest * 1.16) / this.units.y.factor || 1]);
    const { transform: t } = this;
    const dx = t.rescaleX(sx).domain() as [number, number], dy = t.rescaleY(sy).domain() as [number, number];
    this.frame = { ...base, x: sx.domain(dx), y: sy.domain(dy) };
    const { x, y } = this.si();
    const key = JSON.stringify([studio.axis, base.width, base.height, dx, dy, studio.bandReady, studio.changed, farthest]);
    if (this.still?.fit !== fit || this.still.key !== key || !this.moving.contains(this.model)) {
      this.still = { fit, key };
      byId("force-unit").textContent = `(${this.units.y.name})`;
      const title = studio.axis === "stage" ? `stage displacement (${this.units.x.name})` : `deflection at midspan *δ* (${this.units.x.name})`;
      const box = { x: MARGINS.left, y: 0, width: Math.max(0, base.width - MARGINS.left - MARGINS.right + 1), height: Math.max(0, base.height - MARGINS.bottom) };
      const clipped = (id: string, ...parts: SVGElement[]): SVGElement[] => [svg("defs", {}, svg("clipPath", { id }, svg("rect", box))), svg("g", { "clip-path": `url(#${id})` }, ...parts)];
      const band = svg("g"), passes = svg("g", { class: "passes" }), data = svg("g"), drops = svg("g");
      this.drawBand(band, fit, x, y);
      for (const pass of fit.passes) if (!pass.isEvaluated) passes.append(passLine(pass, lineThrough(this.of(pass.curve), pass.curve.force, x, y)));
      data.append(dotted(dots(xs, force, x, y), "var(--data)", xs.length > 900 ? 2 : 2.6));
      this.drawDrops(drops, fit, x, y);
      sized(this.drawing, this.host, axes(this.frame, title, { x: Math.max(3, Math.round(base.width / 150)), y: Math.max(3, Math.round(base.height / 48)) }), ...clipped("force-clip", band, passes, data));
      sized(this.moving, this.host, ...clipped("model-clip", this.references, this.model, drops));
      sized(this.over, this.host, this.marker);
      this.host.setAttribute("aria-label", `Force against ${studio.axis} of ${fit.answer.name}, ${fit.rows.length} rows, ${fit.answer.drops.length} drops${fit.passes.length ? `, ${fit.passes.length} passes` : ""}. Arrow keys move row by row, with Shift from drop to drop.`);
      this.drawKeys(fit);
    }
    fill(this.references);
    this.drawReferences(this.references, fit, x, y);
    for (const pin of studio.pins)
      if (pin.on) {
        this.references.append(path(lineThrough(this.of(pin.curve), pin.curve.force, x, y), "var(--pin)", 1.3));
        const at = Math.floor(pin.curve.force.length * 0.86);
        this.references.append(haloed(pin.name, x(this.of(pin.curve)[at] ?? 0), y(pin.curve.force[at] ?? 0) + 30, "middle", "var(--pin)"));
      }
    fill(this.model);
    if (programmed) this.model.append(path(lineThrough(this.of(programmed), programmed.force, x, y), "var(--model)", 1.2, { "stroke-dasharray": "5 3" }));
    const ended = studio.loading;
    if (ended) {
      this.model.append(...this.modelOf(fit, ended, x, y, 1.6));
      const end = ended.force.length - 1, ex = x(this.of(ended)[end] ?? 0), unseen = ex - x(this.of(ended)[this.seenOf(fit, ended) - 1] ?? 0) > 40;
      const words = end < 0 ? "" : ended.status === "ok" ? (unseen ? "beyond the friction seen" : "") : { slipped_through: "slips through the supports", contact_lost: "contact is lost", branch_ended: "no state beyond" }[ended.status];
      if (words) this.model.append(haloed(words, Math.min(ex + 4, base.width - MARGINS.right - 4), y(ended.force[end]!) - 6, ex > base.width - 220 ? "end" : "start", "var(--model)"));
    }
    this.mark();
  }

  /** Of how many states of the model the fit has seen the friction. */
  private seenOf(fit: Fit, { drawn }: Loading): number {
    const to = seenTo(fit), first = drawn.findIndex((each) => each > to);
    return first < 0 ? drawn.length : first;
  }
  /** The model's curve, pale beyond. */
  private modelOf(fit: Fit, loading: Loading, x: Scale, y: Scale, width: number): SVGElement[] {
    const xs = this.of(loading), seen = this.seenOf(fit, loading), part = (from: number, to: number, more = {}): SVGElement => path(lineThrough(xs, loading.force, x, y, ...rangeIn(xs, x, from, to)), "var(--model)", width, more);
    return [part(0, seen), part(Math.max(0, seen - 1), xs.length, { "stroke-opacity": 0.4 })];
  }

  /** Scales from SI to pixels. */
  private si(): { x: Scale; y: Scale } {
    const { x, y } = this.frame!, [x0, x1] = x.domain() as [number, number], [y0, y1] = y.domain() as [number, number];
    return { x: x.copy().domain([x0 * this.units.x.factor, x1 * this.units.x.factor]), y: y.copy().domain([y0 * this.units.y.factor, y1 * this.units.y.factor]) };
  }

  /** Before there is a fit: what the file holds. */
  private drawRaw(): void {
    const rows = this.studio.test?.rows;
    fill(byId("force-marks"));
    if (!rows) return;
    const spanned = (values: Float64Array): [number, number] => {
      const low = Math.min(0, least(values)), high = Math.max(0, greatest(values));
      return Number.isFinite(low) && high > low ? [low, high + 0.06 * (high - low)] : [0, 1];
    };
    const dx = spanned(rows.stage), dy = spanned(rows.force);
    byId("force-unit").textContent = /\[[^\]]*\]$/.exec(rows.titles.force)?.[0] ?? "";
    const { x, y } = (this.frame = frameOf(this.host, MARGINS, dx, dy));
    sized(this.drawing, this.host, axes(this.frame, rows.titles.stage, { x: 5, y: 5 }), dotted(dots(rows.stage, rows.force, x, y), "var(--data)", 2.4));
  }

  private drawBand(inside: SVGGElement, fit: Fit, x: Scale, y: Scale): void {
    const { studio } = this;
    if (studio.changed || !studio.bandReady) return;
    const band = studio.model.band(fit, DRAWS), stage = fit.curves.column("w_s")!;
    const k = fit.fitted.kc;
    if (studio.axis === "stage") inside.append(svg("path", { d: area(stage, band.lowForce, band.highForce, x, y), fill: "var(--band)" }));
    else {
      // At a stage position the states of the draws lie on one load line: the band is bounded by two curves with deflections of their own.
      const deflection = (force: Float64Array): Float64Array => stage.map((s, i) => s - force[i]! / k);
      const up = lineThrough(deflection(band.highForce), band.highForce, x, y), back = lineThrough([...deflection(band.lowForce)].reverse(), [...band.lowForce].reverse(), x, y);
      if (up && back) inside.append(svg("path", { d: `${up}L${back.replaceAll("M", "L").slice(1)}Z`, fill: "var(--band)" }));
    }
  }

  private drawReferences(inside: SVGGElement, fit: Fit, x: Scale, y: Scale): void {
    const { studio } = this, { values, rig } = studio;
    if (!values || !rig) return;
    const { margins, width } = this.frame!, right = width - margins.right;
    const toX = (w: number, f: number): number => (studio.axis === "stage" ? w + f / values.kc : w);
    const end = x.domain()[1]!, force = studio.model.linear(rig, end);
    const slope = force / end;
    const top = y.domain()[1]! * 0.995, w1 = Math.min(end, top / slope);
    inside.append(path(`M${x(0)} ${y(0)}L${x(toX(w1, slope * w1))} ${y(slope * w1)}`, "var(--ref)", 1.1, { "stroke-dasharray": "7 4" }));
    // Its name stands at the left of the line, where it meets no mark of a drop.
    const marks = fit.answer.drops.map((d) => this.placeOf(d)).map(([w, f]) => [x(w), y(f)] as const);
    for (const share of [0.8, 0.9, 0.7, 0.97, 0.6, 0.5]) {
      const high = share * slope * w1, lx = Math.min(x(toX(high / slope, high)) - 12, right - 4), ly = y(high) + 2;
      if (lx < margins.left + 90 || marks.some(([px, py]) => px > lx - 96 && px < lx + 10 && py - 30 < ly + 4 && py > ly - 14)) continue;
      inside.append(haloed("Euler–Bernoulli", lx, ly, "end"));
      break;
    }
    const plain = this.withoutFriction(fit);
    if (!plain) return;
    const xs = studio.axis === "stage" ? plain.deflection.map((w, i) => w + plain.force[i]! / values.kc) : plain.deflection;
    let last = xs.length - 1;
    while (last > 0 && xs[last]! > end) --last;
    inside.append(path(lineThrough(xs, plain.force, x, y, 0, last + 1), "var(--ref)", 1.3, { "stroke-dasharray": "1.5 3", "stroke-linecap": "round" }));
    const at = Math.floor(last * 0.93);
    if (at > 0) inside.append(haloed("no friction", Math.min(x(xs[at]!), right - 4), y(plain.force[at]!) + 15, "end"));
  }

  private placeOf(drop: Drop): [number, number] {
    const w = drop.deflection_before, f = drop.force_before;
    const k = this.studio.fit!.fitted.kc;
    return [this.studio.axis === "stage" ? w + f / k : w, f];
  }

  private drawDrops(inside: SVGGElement, fit: Fit, x: Scale, y: Scale): void {
    let lastLabel = -Infinity;
    const space = fit.answer.drops.length > 20 ? 17 : 12;
    const lines: Record<string, string> = {}, { studio } = this, k = fit.fitted.kc;
    for (const [i, drop] of fit.answer.drops.entries()) {
      const [w0, f0] = this.placeOf(drop), slip = slipOf(drop);
      const px = x(w0), py = y(f0);
      // The load line of the drop, of slope -k, as long as one and a half times its fall and at least 22 px.
      const fall = Math.max(drop.force_fall, 1e-30), ex = studio.axis === "stage" ? 0 : x(w0 + fall / k) - px, ey = y(f0 - fall) - py, length = Math.hypot(ex, ey) || 1, scale = Math.max(1.5, 22 / length);
      lines[slip] = (lines[slip] ?? "") + `M${px.toFixed(1)} ${py.toFixed(1)}l${(ex * scale).toFixed(1)} ${(ey * scale).toFixed(1)}`;
      inside.append(dropMark(slip, px, py - 8));
      if (px - lastLabel >= space) {
        inside.append(haloed(String(i + 1), px, py - 15, "middle", dropColour(slip)));
        lastLabel = px;
      }
    }
    for (const [slip, d] of Object.entries(lines)) inside.prepend(path(d, dropColour(slip as "could"), 1, { "stroke-dasharray": "3 2.500" }));
  }

  private drawKeys(fit: Fit): void {
    const { studio } = this;
    const mark = (words: string, ...shapes: SVGElement[]): HTMLElement => el("span", {}, svg("svg", { width: 20, height: 12 }, ...shapes), words);
    const kinds = new Set(fit.answer.drops.map(slipOf));
    const drops: [("could" | "undecided" | "no"), string][] = [["could", "can be a slip"], ["undecided", "cannot be judged"], ["no", "cannot be a slip"]];
    const words = drops.filter(([kind]) => kinds.has(kind)).map(([kind, w], i) => mark(i === 0 ? `drop: ${w}` : w, path("M8 5l11 6", dropColour(kind), 1, { "stroke-dasharray": "3 2.500" }), dropMark(kind, 6, 5, 3)));
    const data = dotted("M3 6h0M10 6h0M17 6h0", "var(--data)", 3), passes = kindsOf(fit.passes).map(({ words, pass }) => mark(words, pass.isEvaluated ? data : passLine(pass, "M2 6h16")));
    const samples = tellsFriction(fit.answer) ? mark("posterior samples", svg("rect", { width: 20, height: 8, y: 2, fill: "var(--band)" })) : null;
    // Its room stays where they are not drawn, and so does the curve.
    if (samples && (studio.changed || !fit.friction.draws.length)) samples.style.visibility = "hidden";
    fill(byId("force-marks"), ...(passes.length ? passes : [mark("data", data)]), tellsFriction(fit.answer) ? mark("model", path("M0 6h20", "var(--model)", 1.6)) : null, samples, ...words);
  }

  /** The marked moment alone, for the pointer. */
  mark(): void {
    const { studio } = this, fit = studio.fit, moment = studio.moment;
    this.marker.replaceChildren();
    if (!fit || !moment || !this.frame || !Number.isFinite(moment.force) || isWithdrawn(fit.answer)) return;
    const { x, y } = this.si(), { height, margins, width } = this.frame;
    const at = studio.axis === "stage" ? moment.stage : moment.deflection, px = x(at), py = y(moment.force);
    const bottom = height - margins.bottom;
    if (px < margins.left - 1 || px > width - margins.right + 1 || !(py <= bottom + 1 && py >= 0)) return;
    if (moment.used && !studio.tried) this.drawLens(fit, px, py, at, moment.force, x, y);
    this.marker.append(svg("line", { x1: px, x2: px, y1: py + 6, y2: bottom, stroke: "var(--moment)", "stroke-width": 1, "stroke-opacity": .75 }));
    if (moment.drop) {
      const k = fit.fitted.kc, reach = moment.force * 0.1;
      const dw = studio.axis === "stage" ? 0 : reach / k;
      if (Number.isFinite(dw)) this.marker.append(path(`M${x(at - dw)} ${y(moment.force + reach)}L${x(at + dw)} ${y(moment.force - reach)}`, "var(--moment)", 1.4, { "stroke-dasharray": "4 3" }));
    }
    this.marker.append(svg("circle", { cx: px, cy: py, r: 4.5, fill: "none", stroke: "var(--moment)", "stroke-width": 1.8 }));
  }

  /** The lens stands at the lower right, where there is room under the curves; elsewhere it hides. */
  private drawLens(fit: Fit, px: number, py: number, at: number, force: number, x: Scale, y: Scale): void {
    const { width, height, margins } = this.frame!;
    const right = width - margins.right - 30, bottom = height - margins.bottom - 11;
    const w = Math.min(380, (width - margins.left - margins.right) * 0.42), left = right - w;
    const xs = this.abscissa(fit), f = fit.curves.column("F")!;
    let lowest = 0;  // [px] of data and model over the lens
    const see = (a: ArrayLike<number>, b: ArrayLike<number>): void => {
      for (let i = 0; i < a.length; ++i) {
        const p = x(a[i]!), q = y(b[i]!);
        if (p >= left - 6 && p <= right + 6 && q > lowest) lowest = q;
      }
    };
    see(xs, f);
    for (const { curve } of fit.passes) see(this.of(curve), curve.force);
    if (this.studio.loading) see(this.of(this.studio.loading), this.studio.loading.force);
    if (this.reference) see(this.of(this.reference.plain).length ? this.of(this.reference.plain) : this.reference.plain.deflection, this.reference.plain.force);
    if (this.studio.programmed) see(this.of(this.studio.programmed), this.studio.programmed.force);
    const h = Math.min(110, bottom - lowest - 22);
    if (h < 44 || w < 120) return;
    const top = bottom - h;
    // Enlarged as far as the readings around the moment still fit.
    let times = 8, middle = py;
    for (; times >= 2; --times) {
      let high = py, low = py;
      for (let i = 0; i < xs.length; ++i) if (Math.abs(x(xs[i]!) - px) <= w / 2 / times) {
        const q = y(f[i]!);
        if (q < high) high = q;
        if (q > low) low = q;
      }
      middle = (high + low) / 2;
      if ((low - high) * times <= 0.72 * h) break;
    }
    if (times < 2) return;
    const half = { x: w / 2 / times, y: h / 2 / times };
    const lx = x.copy().domain([x.invert(px - half.x), x.invert(px + half.x)]).range([left, right]), ly = y.copy().domain([y.invert(middle + half.y), y.invert(middle - half.y)]).range([bottom, top]);
    const clip = svg("clipPath", { id: "lens-clip" }, svg("rect", { x: left, y: top, width: w, height: h }));
    const inside = svg("g", { "clip-path": "url(#lens-clip)" });
    const k = fit.fitted.kc;
    for (const d of fit.answer.drops) {
      const [w0, f0] = this.placeOf(d), slip = slipOf(d), reach = d.force_fall * 1.4, dw = this.studio.axis === "stage" ? 0 : reach / k;
      const ax = lx(w0), ay = ly(f0);
      if (ax < left - w || ax > right + w) continue;
      inside.append(path(`M${ax} ${ay}L${lx(w0 + dw)} ${ly(f0 - reach)}`, dropColour(slip), 1.1, { "stroke-dasharray": "4 3" }), dropMark(slip, ax, ay - 8));
    }
    const { loading } = this.studio;
    if (loading) inside.append(...this.modelOf(fit, loading, lx, ly, 1.5));
    inside.append(dotted(dots(xs, f, lx, ly, ...rangeIn(xs, lx)), "var(--data)", 3.4), svg("circle", { cx: lx(at), cy: ly(force), r: 5.5, fill: "none", stroke: "var(--moment)", "stroke-width": 2 }));
    this.marker.append(
      svg("defs", {}, clip), svg("rect", { x: left, y: top, width: w, height: h, fill: "var(--surface)", stroke: "var(--line2)" }), inside,
      svg("rect", { x: px - half.x, y: middle - half.y, width: 2 * half.x, height: 2 * half.y, fill: "none", stroke: "var(--line2)" }),
      label(`around row ${this.studio.row},`, { x: left - 7, y: bottom - 16, "text-anchor": "end" }), label(`${times} times larger`, { x: left - 7, y: bottom - 2, "text-anchor": "end" }));
  }

  private pick(event: PointerEvent): void {
    const { studio } = this, fit = studio.fit;
    if (!fit || !this.frame || event.shiftKey || isWithdrawn(fit.answer)) return;
    const [a, b] = placeIn(event, this.host), { x, y } = this.si(), xs = this.abscissa(fit), f = fit.curves.column("F")!;
    let best = Infinity, row = studio.row;
    for (let i = 0; i < xs.length; ++i) {
      const far = (x(xs[i]!) - a) ** 2 + 0.15 * (y(f[i]!) - b) ** 2;
      if (far < best) {
        best = far;
        row = fit.rows[i]!;
      }
    }
    studio.tried = null;
    studio.setRow(row);
  }

  /** Data less model, where the page is wide and high. */
  drawResiduals(): void {
    const host = byId("residual-plot"), { studio } = this, fit = studio.fit;
    const shown = innerWidth >= 1600 && sizeOf(this.host).height > 270 && !!fit && studio.residual.length > 0;
    const was = host.classList.contains("shown");
    host.classList.toggle("shown", shown);
    if (was !== shown) requestAnimationFrame(() => this.draw());
    if (!shown || !this.frame || !fit) return;
    let drawing = host.querySelector("svg");
    if (!drawing) host.append((drawing = svg("svg")));
    const sorted = [...studio.residual].filter((r) => !Number.isNaN(r)).map(Math.abs).sort((a, b) => a - b);
    const most = Math.max(1e-12, (sorted[Math.floor(sorted.length * 0.97)] ?? 1e-6) * 1.8), unit = unitFor(most, "force");
    const frame: Frame = { ...frameOf(host, { left: MARGINS.left, right: MARGINS.right, top: 6, bottom: 6 }, [0, 1], [-most, most]), x: this.si().x };
    const { y, margins, width } = frame, clamped = studio.residual.map((r) => Math.max(-most, Math.min(most, r)));
    const tick = Number((most / unit.factor).toPrecision(1)) * unit.factor > most ? most * 0.8 : Number((most / unit.factor).toPrecision(1)) * unit.factor;
    const g = svg("g");
    for (const [value, words] of [[tick, `+${Number((tick / unit.factor).toPrecision(2))}`], [0, "0"], [-tick, fixed(-tick / unit.factor, 0) === "−0" ? `−${Number((tick / unit.factor).toPrecision(2))}` : `−${Number((tick / unit.factor).toPrecision(2))}`]] as [number, string][])
      g.append(svg("line", { x1: margins.left - 4, x2: value === 0 ? width - margins.right : margins.left, y1: y(value), y2: y(value), stroke: value === 0 ? "var(--line)" : "var(--line2)" }), svg("text", { x: margins.left - 7, y: y(value) + 4, "text-anchor": "end" }, words));
    g.append(svg("line", { x1: margins.left, x2: margins.left, y1: margins.top, y2: frame.height - margins.bottom, stroke: "var(--line2)" }));
    sized(drawing, host, g, dotted(dots(this.abscissa(fit), clamped, frame.x, y), "var(--data)", 2), haloed(`data − model (${unit.name})`, margins.left + 6, 14, "start"));
  }
}
