// Force by row, with two handles: the only place that shows rows before contact and after failure without ambiguity.

import { scaleLinear } from "d3-scale";
import { isWithdrawn, slipOf } from "./answer";
import { byId, svg } from "./dom";
import { dropColour, greatest, least, lineThrough, path, placeIn, sized, sizeOf, type Scale } from "./plot";
import type { Studio } from "./studio";
import type { Fit } from "./test";

const LEFT = 54, RIGHT = 24, TOP = 4, BOTTOM = 17;

export class RowsView {
  private readonly host = byId("rows-plot");
  private readonly drawing = svg("svg", { role: "group", "aria-label": "Rows of the file" });
  private readonly marker = svg("line", { stroke: "var(--moment)", "stroke-width": 1.5 });
  private x: Scale = scaleLinear();
  private last = 1;
  private grip: "first" | "last" | "row" | null = null;

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing);
    this.host.addEventListener("pointerdown", (event) => this.begin(event));
    this.host.addEventListener("pointermove", (event) => this.move(event));
    this.host.addEventListener("pointerup", () => (this.grip = null));
    this.host.addEventListener("pointercancel", () => (this.grip = null));
  }

  draw(): void {
    const { studio } = this, { test, fit } = studio;
    const force = test?.rows?.force ?? fit?.curves.column("F") ?? null;
    if (!force?.length) return sized(this.drawing, this.host, svg("g"));
    this.last = force.length;
    const { width, height } = sizeOf(this.host), bottom = height - BOTTOM;
    this.x = scaleLinear([1, this.last], [LEFT, Math.max(LEFT + 1, width - RIGHT)]);
    const f = fit && isReversed(force, fit) ? force.map((v) => -v) : force, most = greatest(f), low = Math.min(0, least(f));
    const y = scaleLinear([low, most > low ? most : low + 1], [bottom - 1, TOP + 3]), rows = Float64Array.from({ length: this.last }, (_, i) => i + 1);
    const [first, last] = studio.used, x1 = this.x(first), x2 = this.x(last);
    const children: SVGElement[] = [
      svg("rect", { x: x1, y: TOP, width: Math.max(0, x2 - x1), height: bottom - TOP, fill: "var(--band)" }),
      svg("line", { x1: LEFT, x2: width - RIGHT, y1: bottom, y2: bottom, stroke: "var(--line2)" }),
      path(lineThrough(rows, f, this.x, y), "var(--ink2)", 1),
    ];
    for (const drop of fit && !isWithdrawn(fit.answer) ? fit.answer.drops : []) children.push(svg("line", { x1: this.x(drop.row_before), x2: this.x(drop.row_before), y1: TOP, y2: TOP + 5, stroke: dropColour(slipOf(drop)), "stroke-width": 1.5 }));
    for (const [name, at, words] of [["first", first, "First row used"], ["last", last, "Last row used"]] as const) {
      const px = this.x(at);
      children.push(svg("g", {
        class: "handle", "data-handle": name, tabindex: 0, role: "slider", "aria-label": words, "aria-valuemin": 1, "aria-valuemax": this.last, "aria-valuenow": at,
        keydown: (event: KeyboardEvent) => this.key(event, name),
      }, svg("rect", { x: px - 12, y: 0, width: 24, height, fill: "transparent" }), svg("line", { x1: px, x2: px, y1: TOP - 2, y2: bottom + 2, stroke: "var(--model)", "stroke-width": 2 }),
        svg("rect", { x: px - 3, y: (TOP + bottom) / 2 - 7, width: 6, height: 14, rx: 2, fill: "var(--surface)", stroke: "var(--model)", "stroke-width": 1.5 })));
    }
    const note = (words: string, x: number, anchor: string): SVGElement => svg("text", { x, y: height - 3, "text-anchor": anchor }, words);
    const faint = (words: string, x: number): SVGElement => {
      const text = note(words, x, "middle");
      text.style.fill = "var(--ink3)";
      return text;
    };
    const ends = fit?.answer.measurement.ends_with, after = ends === "failure" ? "after failure" : ends === "turn" ? "after the turn" : "left out";
    children.push(note(String(first), x1, first === 1 ? "start" : "middle"), note(String(last), x2, last === this.last ? "end" : "middle"), svg("text", { x: LEFT - 7, y: (TOP + bottom) / 2 + 4, "text-anchor": "end" }, "rows"));
    if (x2 - x1 > 90) children.push(faint("used", (x1 + x2) / 2));
    if (last < this.last && width - RIGHT - x2 > 130) children.push(faint(after, (x2 + width - RIGHT) / 2));
    if (last < this.last && width - RIGHT - x2 > 40) children.push(note(String(this.last), width - RIGHT, "end"));
    if (first > 1 && x1 - LEFT > 110) children.push(faint(fit?.passes.length ? "before this loading" : "before contact", (x1 + LEFT) / 2));
    sized(this.drawing, this.host, ...children, ...(fit && !isWithdrawn(fit.answer) ? [this.marker] : []));
    this.mark();
  }

  mark(): void {
    const px = this.x(this.studio.row), height = sizeOf(this.host).height;
    for (const [name, value] of Object.entries({ x1: px, x2: px, y1: 1, y2: height - BOTTOM + 3 })) this.marker.setAttribute(name, String(value));
  }

  private rowAt(event: PointerEvent): number {
    return Math.max(1, Math.min(this.last, Math.round(this.x.invert(placeIn(event, this.host)[0]))));
  }
  private begin(event: PointerEvent): void {
    const [px] = placeIn(event, this.host), [first, last] = this.studio.used, a = Math.abs(px - this.x(first)), b = Math.abs(px - this.x(last));
    this.grip = Math.min(a, b) <= 12 ? (b <= a ? "last" : "first") : "row";
    if (this.grip !== "row") this.studio.remember();
    this.host.setPointerCapture(event.pointerId);
    this.move(event);
  }
  private move(event: PointerEvent): void {
    if (!this.grip) return;
    const row = this.rowAt(event);
    if (this.grip === "row") {
      this.studio.tried = null;
      this.studio.setRow(row);
    } else this.set(this.grip, row);
  }
  set(which: "first" | "last", row: number): void {
    const [first, last] = this.studio.used;
    if (which === "first") this.studio.decide({ first: Math.max(1, Math.min(row, last - 10)) });
    else this.studio.decide({ until: Math.min(this.last, Math.max(row, first + 10)) });
  }
  private key(event: KeyboardEvent, which: "first" | "last"): void {
    const by = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    this.studio.remember();
    this.set(which, this.studio.used[which === "first" ? 0 : 1] + by * (event.shiftKey ? 10 : 1));
    requestAnimationFrame(() => this.host.querySelector<SVGElement>(`[data-handle=${which}]`)?.focus());
  }
}

/** Whether the fit has taken the force of the file the other way round: by the row of its greatest force. */
function isReversed(force: Float64Array, fit: Fit): boolean {
  const used = fit.curves.column("F") ?? new Float64Array(0), at = used.indexOf(greatest(used)), raw = force[(fit.rows[at] ?? 0) - 1];
  return raw !== undefined && raw * (used[at] ?? 0) < 0;
}
