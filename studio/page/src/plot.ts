// What the plots share: a frame with two axes, points and lines as paths, and where the pointer is.

import { scaleLinear, type ScaleLinear } from "d3-scale";
import { label, svg, type Child } from "./dom";

export type Scale = ScaleLinear<number, number>;
export interface Margins { left: number; right: number; top: number; bottom: number }
export interface Frame { width: number; height: number; margins: Margins; x: Scale; y: Scale }

const sizes = new WeakMap<Element, { width: number; height: number }>();
const watcher = new ResizeObserver((entries) => {
  for (const { target, contentRect } of entries) sizes.set(target, { width: Math.round(contentRect.width), height: Math.round(contentRect.height) });
});
/** The size of a drawing's host [px], without asking the page to be laid out anew for it. */
export function sizeOf(host: Element): { width: number; height: number } {
  const known = sizes.get(host);
  if (known) return known;
  watcher.observe(host);
  const size = { width: host.clientWidth, height: host.clientHeight };
  sizes.set(host, size);
  return size;
}

export const frameOf = (host: Element, margins: Margins, x: [number, number], y: [number, number]): Frame => {
  const { width, height } = sizeOf(host);
  return {
    width, height, margins,
    x: scaleLinear(x, [margins.left, Math.max(margins.left + 1, width - margins.right)]),
    y: scaleLinear(y, [Math.max(margins.top + 1, height - margins.bottom), margins.top]),
  };
};

const tickWords = (scale: Scale, count: number): ((value: number) => string) => {
  const format = scale.tickFormat(count);
  return (value) => format(value).replace("-", "−");
};

/** Left and bottom axes with ticks; `xTitle` stands under the right end. */
export function axes(frame: Frame, xTitle: string, ticks: { x: number; y: number }): SVGGElement {
  const { x, y, width, height, margins } = frame, bottom = height - margins.bottom;
  const g = svg("g", { class: "axes" });
  const line = (x1: number, y1: number, x2: number, y2: number): SVGElement => svg("line", { x1, y1, x2, y2, stroke: "var(--line2)" });
  g.append(line(margins.left, margins.top, margins.left, bottom), line(margins.left, bottom, width - margins.right, bottom));
  const xWords = tickWords(x, ticks.x), yWords = tickWords(y, ticks.y);
  for (const tick of x.ticks(ticks.x)) g.append(line(x(tick), bottom, x(tick), bottom + 4), svg("text", { x: x(tick), y: bottom + 15, "text-anchor": "middle" }, xWords(tick)));
  for (const tick of y.ticks(ticks.y)) g.append(line(margins.left - 4, y(tick), margins.left, y(tick)), svg("text", { x: margins.left - 7, y: y(tick) + 4, "text-anchor": "end" }, yWords(tick)));
  if (xTitle) g.append(label(xTitle, { x: width - margins.right, y: height - 3, "text-anchor": "end" }));
  return g;
}

const MANY = 6000;  // points, from which on only those are drawn that show

const r1 = (value: number): number => Math.round(value * 10) / 10;

/** The same line with as many points as there are pixels: of those of one column the first, the least, the greatest and the last. */
function manyThrough(xs: ArrayLike<number>, ys: ArrayLike<number>, x: Scale, y: Scale, from: number, to: number): string {
  const parts: string[] = [];
  let column = NaN, low = 0, high = 0, first = 0, last = 0;
  const close = (): void => {
    if (!Number.isNaN(column)) parts.push(`${parts.length ? "L" : "M"}${column} ${r1(first)}L${column} ${r1(low)}L${column} ${r1(high)}L${column} ${r1(last)}`);
  };
  for (let i = from; i < to; ++i) {
    const a = Math.round(x(xs[i]!) * 2) / 2, b = y(ys[i]!);
    if (!Number.isFinite(a) || !Number.isFinite(b)) continue;
    if (a !== column) {
      close();
      column = a;
      low = high = first = b;
    }
    low = Math.min(low, b);
    high = Math.max(high, b);
    last = b;
  }
  close();
  return parts.join("");
}

/** A line through the points; broken where one is not a number. */
export function lineThrough(xs: ArrayLike<number>, ys: ArrayLike<number>, x: Scale, y: Scale, from = 0, to = xs.length): string {
  if (to - from > MANY) return manyThrough(xs, ys, x, y, from, to);
  const parts: string[] = [];
  let pen = false;
  for (let i = from; i < to; ++i) {
    const a = x(xs[i]!), b = y(ys[i]!);
    if (!Number.isFinite(a) || !Number.isFinite(b)) {
      pen = false;
      continue;
    }
    parts.push(pen ? "L" : "M", String(r1(a)), " ", String(r1(b)));
    pen = true;
  }
  return parts.join("");
}

/** A dot at each point, as one path with round ends. */
export function dots(xs: ArrayLike<number>, ys: ArrayLike<number>, x: Scale, y: Scale, from = 0, to = xs.length): string {
  const parts: string[] = [], taken = to - from > MANY ? new Set<number>() : null;
  for (let i = from; i < to; ++i) {
    const a = x(xs[i]!), b = y(ys[i]!);
    if (!Number.isFinite(a) || !Number.isFinite(b)) continue;
    if (taken) {
      const pixel = Math.round(a) * 100_000 + Math.round(b);
      if (taken.has(pixel)) continue;
      taken.add(pixel);
    }
    parts.push("M", String(r1(a)), " ", String(r1(b)), "h0");
  }
  return parts.join("");
}

/** The area between two lines over the same points. */
export function area(xs: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number>, x: Scale, y: Scale): string {
  const up: string[] = [], back: string[] = [];
  for (let i = 0; i < xs.length; ++i) {
    const a = r1(x(xs[i]!)), l = r1(y(low[i]!)), h = r1(y(high[i]!));
    if (Number.isNaN(a) || Number.isNaN(l) || Number.isNaN(h)) continue;
    up.push(`${a} ${h}`);
    back.push(`${a} ${l}`);
  }
  return up.length ? `M${up.join("L")}L${back.reverse().join("L")}Z` : "";
}

export const path = (d: string, stroke: string, width: number, more: Record<string, string | number> = {}): SVGPathElement =>
  svg("path", { d, fill: "none", stroke, "stroke-width": width, "stroke-linejoin": "round", ...more });
export const dotted = (d: string, stroke: string, size: number): SVGPathElement => path(d, stroke, size, { "stroke-linecap": "round" });

/** A label with a halo of the ground, legible over lines. */
export const haloed = (words: string, x: number, y: number, anchor: "start" | "middle" | "end", colour = "var(--ink2)"): SVGTextElement => {
  const text = label(words, { x, y, "text-anchor": anchor, "paint-order": "stroke", stroke: "var(--surface)", "stroke-width": 4, "stroke-linejoin": "round" });
  text.style.fill = colour;
  return text;
};

/** The mark of a drop: ring, half-filled diamond or filled triangle. */
export function dropMark(slip: "could" | "undecided" | "no", x: number, y: number, size = 3.5): SVGElement {
  if (slip === "could") return svg("circle", { cx: x, cy: y, r: size, fill: "var(--surface)", stroke: "var(--ok)", "stroke-width": 1.6 });
  if (slip === "no") return svg("path", { d: `M${x} ${y - size - 1}L${x + size + 1} ${y + size}H${x - size - 1}Z`, fill: "var(--bad)" });
  const s = size + 1;
  return svg("g", {}, svg("path", { d: `M${x} ${y - s}L${x + s} ${y}L${x} ${y + s}L${x - s} ${y}Z`, fill: "var(--surface)", stroke: "var(--warn)", "stroke-width": 1.4 }), svg("path", { d: `M${x} ${y - s}V${y + s}L${x - s} ${y}Z`, fill: "var(--warn)" }));
}
export const dropColour = (slip: "could" | "undecided" | "no"): string => (slip === "could" ? "var(--ok)" : slip === "no" ? "var(--bad)" : "var(--warn)");

/** Where an event is in an element, in its pixels. */
export function placeIn(event: PointerEvent | MouseEvent, element: Element): [number, number] {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** Clears a drawing and gives it the size of its host. */
export function sized(drawing: SVGSVGElement, host: Element, ...children: Child[]): void {
  const { width, height } = sizeOf(host);
  if (drawing.getAttribute("width") !== String(width)) drawing.setAttribute("width", String(width));
  if (drawing.getAttribute("height") !== String(height)) drawing.setAttribute("height", String(height));
  drawing.replaceChildren(...(children.filter((c) => c instanceof Node) as Node[]));
}

/** From the first of these values within a scale's domain to behind the last, with a neighbour of each. */
export function rangeIn(values: ArrayLike<number>, x: Scale, begin = 0, end = values.length): [number, number] {
  const [low, high] = x.domain() as [number, number];
  let from = begin, to = end;
  const outside = (i: number): boolean => !(values[i]! >= low && values[i]! <= high);
  while (from < to && outside(from)) ++from;
  while (to > from && outside(to - 1)) --to;
  return [Math.max(begin, from - 1), Math.min(end, to + 1)];
}

/** Index of the value nearest to `at` among ascending values. */
export function nearest(values: ArrayLike<number>, at: number): number {
  let low = 0, high = values.length - 1;
  if (high < 0) return -1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle]! <= at) low = middle;
    else high = middle;
  }
  return Math.abs(values[low]! - at) <= Math.abs(values[high]! - at) ? low : high;
}
export const greatest = (values: ArrayLike<number>): number => {
  let most = -Infinity;
  for (let i = 0; i < values.length; ++i) if (values[i]! > most) most = values[i]!;
  return most;
};
export const least = (values: ArrayLike<number>): number => {
  let low = Infinity;
  for (let i = 0; i < values.length; ++i) if (values[i]! < low) low = values[i]!;
  return low;
};
