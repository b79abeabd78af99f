// The specimen itself, to scale: bent over its supports at the marked moment, with the forces on it.

import { forceInWords } from "./answer";
import { byId, label, svg } from "./dom";
import type { Shape } from "./engine";
import { greatest, haloed, nearest, path, placeIn, sized, sizeOf } from "./plot";
import { unitFor, written } from "./quantity";
import type { Moment, Studio } from "./studio";

export class FibreView {
  private readonly host = byId("fibre-plot");
  private readonly drawing = svg("svg", { role: "img", "aria-hidden": "true" });
  private scale = 1;  // [px/m]
  private top = 40;   // [px] of the supports' tips
  private last: Shape | null = null;

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing);
    const drag = (event: PointerEvent): void => {
      if (event.buttons || event.pointerType === "touch") this.pick(event);
    };
    this.host.addEventListener("pointerdown", (event) => {
      this.host.setPointerCapture(event.pointerId);
      this.pick(event);
    });
    this.host.addEventListener("pointermove", drag);
  }

  draw(): void {
    const { studio } = this, fit = studio.fit, { values } = studio, moment = studio.moment;
    const { width, height } = sizeOf(this.host);
    if (!fit || !values || !moment || width < 40) return sized(this.drawing, this.host, svg("g"));
    const { rig } = studio;
    if (!rig) return sized(this.drawing, this.host, svg("g"));
    const friction = Number.isFinite(moment.mu) ? moment.mu : 0;
    const deflection = Number.isFinite(moment.deflection) ? Math.max(0, moment.deflection) : 0;
    let shape: Shape;
    try {
      shape = this.studio.model.shape(rig, Math.max(deflection, 1e-4 * values.L), friction);
      this.last = shape;
    } catch {
      if (!this.last) return sized(this.drawing, this.host, svg("g"));
      shape = this.last;
    }
    const after = !moment.used && studio.indexOf(studio.row) >= 0;  // failed: the last shape, pale
    const deepest = Math.max(greatest(fit.curves.column("w")!), studio.programmed ? greatest(studio.programmed.deflection) : 0);
    const reach = (values.L / 2) * 1.22;
    this.top = Math.min(64, height * 0.24);
    this.scale = Math.min((width - 80) / (2 * reach), (width - 170) / values.L, (height - this.top - Math.min(64, height * 0.3)) / Math.max(deepest, values.L * 0.08));
    const X = (x: number): number => width / 2 + x * this.scale, Y = (y: number): number => this.top - y * this.scale;
    const line = (from = 0, to = shape.x.length): string => {
      let d = "";
      for (let i = from; i < to; ++i) d += `${i > from ? "L" : "M"}${X(shape.x[i]!).toFixed(1)} ${Y(shape.y[i]!).toFixed(1)}`;
      return d;
    };
    const g = svg("g"), thick = Math.max(2.5, values.D * this.scale);
    // Supports: an edge, or a roller of the tip radius, to scale.
    const contacts = shape.contact.length === 2 ? shape.contact : ([[-values.L / 2, 0], [values.L / 2, 0]] as [number, number][]);
    for (const side of [-1, 1]) {
      const sx = X((side * values.L) / 2), r = values.R * this.scale, sy = Y(0) + Math.min(thick, values.D * this.scale) / 2;
      g.append(svg("path", { d: `M${sx} ${sy + r}L${sx - 9} ${sy + 34}H${sx + 9}Z`, fill: "var(--metal)", stroke: "var(--metal2)", "stroke-width": 1 }));
      if (r > 0.5) g.append(svg("circle", { cx: sx, cy: sy + r, r, fill: "var(--metal)", stroke: "var(--metal2)" }));
    }
    g.append(svg("line", { x1: X(-values.L / 2), x2: X(values.L / 2), y1: Y(0), y2: Y(0), stroke: "var(--line2)", "stroke-dasharray": "2 3" }));
    const body = svg("g", after ? { opacity: 0.35 } : {}, path(line(), "var(--metal2)", thick + 1.6, { "stroke-linejoin": "round" }), path(line(), "var(--metal)", thick));
    // The stretch that slid in, from each support inwards.
    const slid = Math.max(0, shape.slid);
    const lengths = new Float64Array(shape.x.length);
    for (let i = 1; i < lengths.length; ++i) lengths[i] = lengths[i - 1]! + Math.hypot(shape.x[i]! - shape.x[i - 1]!, shape.y[i]! - shape.y[i - 1]!);
    const at = (px: number): number => {
      let best = 0, far = Infinity;
      shape.x.forEach((x, i) => {
        if (Math.abs(x - px) < far) {
          far = Math.abs(x - px);
          best = i;
        }
      });
      return best;
    };
    const middle = at(0);
    for (const [i, contact] of contacts.entries()) {
      const from = at(contact[0]), inward = i === 0 ? 1 : -1;
      let to = from;
      const place = lengths[from]! + inward * (slid / 2);
      to = nearest(lengths, place);
      if (i === 0 ? to > middle : to < middle) to = middle;
      const d = i === 0 ? line(from, to + 1) : line(to, from + 1);
      const [mx, my] = pointAt(shape, lengths, place);
      if (slid > 0) body.append(path(`${i === 0 ? d : `M${X(mx).toFixed(1)} ${Y(my).toFixed(1)}L${d.slice(1)}`}${i === 0 ? `L${X(mx).toFixed(1)} ${Y(my).toFixed(1)}` : ""}`, "var(--model)", thick, { "stroke-opacity": 0.95 }));
      body.append(svg("circle", { cx: X(mx), cy: Y(my), r: Math.max(3, thick / 2 + 0.5), fill: "var(--surface)", stroke: "var(--model)", "stroke-width": 1.6 }));
    }
    g.append(body);
    // The nose, above the fibre at midspan.
    const tip = Y(shape.y[middle] ?? 0) - thick / 2 - 0.8;
    g.append(svg("path", { d: `M${X(0)} ${tip}l-8 -38h16Z`, fill: "var(--metal)", stroke: "var(--metal2)" }));
    if (!after && moment.used) this.drawForces(g, shape, moment, X, Y, thick, height, width, contacts);
    const bar = barOf(values.L), u = unitFor(bar, "length");
    const foot = height - 12;
    g.append(svg("path", { d: `M20 ${foot - 5}v5h${(bar * this.scale).toFixed(1)}v-5`, fill: "none", stroke: "var(--line2)" }), svg("text", { x: 26 + bar * this.scale, y: foot }, `${Number((bar / u.factor).toPrecision(3))} ${u.name}`));
    const legend = 26 + bar * this.scale + 58;
    if (width - legend > 150) g.append(svg("circle", { cx: legend, cy: foot - 4, r: 3.2, fill: "var(--surface)", stroke: "var(--model)", "stroke-width": 1.5 }), label("met the support at the start", { x: legend + 7, y: foot }));
    sized(this.drawing, this.host, g);
    this.host.setAttribute("aria-label", `The specimen at row ${studio.row}: deflection ${written(deflection, "length")}, force ${forceInWords(moment.force, fit.answer)}, ${written(slid / 2, "length")} slid in over each support.`);
  }

  /** The force is that of the moment; those at the supports belong to it where friction is known there and the model is that of the fit. */
  private drawForces(g: SVGGElement, shape: Shape, { force, mu }: Moment, X: (x: number) => number, Y: (y: number) => number, thick: number, height: number, width: number, contacts: [number, number][]): void {
    const most = greatest(this.studio.fit!.curves.column("F")!);
    const middle = nearest(shape.x, 0), foot = Y(shape.y[middle] ?? 0) + thick / 2;
    const length = (force: number): number => (Math.max(0, force) / Math.max(1e-30, most)) * Math.min(46, Math.max(18, height - 34 - foot));
    const arrow = (x: number, y: number, dx: number, dy: number, colour: string): void => {
      const size = Math.hypot(dx, dy);
      if (size < 2) return;
      const ux = dx / size, uy = dy / size, head = Math.min(6, size);
      const ex = x + dx, ey = y + dy, bx = ex - ux * head, by = ey - uy * head;
      g.append(svg("line", { x1: x, y1: y, x2: bx, y2: by, stroke: colour, "stroke-width": 1.8 }), svg("path", { d: `M${ex} ${ey}L${bx - uy * 3} ${by + ux * 3}L${bx + uy * 3} ${by - ux * 3}Z`, fill: colour }));
    };
    const known = Number.isFinite(mu) && (!this.studio.changed || this.studio.tried !== null);
    for (const [i, contact] of known ? contacts.entries() : []) {
      const side = i === 0 ? -1 : 1, at = nearest(shape.x, contact[0]), a = Math.max(0, at - 1), b = Math.min(shape.x.length - 1, at + 1);
      const tx = shape.x[b]! - shape.x[a]!, ty = shape.y[b]! - shape.y[a]!, t = Math.hypot(tx, ty) || 1;
      const ox = (tx / t) * side, oy = (ty / t) * side;  // along the specimen, outwards and up
      const nx = -side * oy, ny = side * ox;             // of the support on the specimen: up and inwards
      const x = X(contact[0]), y = Y(contact[1]);
      arrow(x + nx * thick * 0.5, y - ny * thick * 0.5, nx * length(shape.normal), -ny * length(shape.normal), "var(--ink)");
      arrow(x + ox * 4, y - oy * 4, ox * length(Math.abs(shape.tangential)) * Math.sign(shape.tangential || 1), -oy * length(Math.abs(shape.tangential)) * Math.sign(shape.tangential || 1), "var(--model)");
      if (side < 0) {
        const tip = x + nx * length(shape.normal), narrow = X(0) - tip < 60;  // then the words stand over both tips
        g.append(haloed(`normal ${written(shape.normal, "force")}`, narrow ? X(0) : tip + 8, y - ny * length(shape.normal) + (narrow ? -5 : 2), narrow ? "middle" : "start"));
        const fx = Math.max(62, x - 16 - Math.max(6, 2 * this.studio.values!.R * this.scale));
        g.append(haloed("friction", fx, y + 26, "end", "var(--model)"), haloed(written(Math.abs(shape.tangential), "force"), fx, y + 39, "end", "var(--model)"));
      }
    }
    const cx = X(0);
    arrow(cx, foot + 2, 0, length(force), "var(--moment)");
    const words = haloed(`*F* ${forceInWords(force, this.studio.fit!.answer)}, ${this.studio.tried === null ? "measured" : "calculated"}`, Math.min(cx + 8, width - 130), Math.min(height - 30, foot + 2 + length(force)), "start", "var(--moment)");
    words.setAttribute("font-weight", "600");
    g.append(words);
  }

  private pick(event: PointerEvent): void {
    const { studio } = this, fit = studio.fit;
    if (!fit) return;
    const target = (placeIn(event, this.host)[1] - this.top) / this.scale, w = fit.curves.column("w")!;
    let best = 0, far = Infinity;
    for (let i = 0; i < w.length; ++i) {
      const d = Math.abs(w[i]! - target);
      if (d < far) {
        far = d;
        best = i;
      }
    }
    studio.tried = null;
    studio.setRow(fit.rows[best]!);
  }
}

/** A round length of a sixth to a third of the span. */
function barOf(span: number): number {
  const size = 10 ** Math.floor(Math.log10(span / 4));
  return span / 4 / size >= 5 ? 5 * size : span / 4 / size >= 2 ? 2 * size : size;
}

function pointAt(shape: Shape, lengths: Float64Array, place: number): [number, number] {
  const n = lengths.length;
  let i = 0;
  while (i < n - 2 && lengths[i + 1]! < place) ++i;
  const t = (place - lengths[i]!) / (lengths[i + 1]! - lengths[i]! || 1);
  return [shape.x[i]! + (shape.x[i + 1]! - shape.x[i]!) * t, shape.y[i]! + (shape.y[i + 1]! - shape.y[i]!) * t];
}
