// The loading programme: what was measured, and what may be tried after it, edited with the mouse or the keys; play.

import { scaleLinear } from "d3-scale";
import { byId, fill, svg } from "./dom";
import { path, placeIn, sized, sizeOf, type Scale } from "./plot";
import { unitFor, type Unit } from "./quantity";
import type { Studio } from "./studio";

const LEFT = 34, RIGHT = 6, TOP = 14, BOTTOM = 20;
const ROWS_A_SECOND = 60;

export class ProgrammeView {
  private readonly host = byId("programme-plot");
  private readonly drawing = svg("svg", { role: "group", "aria-label": "Loading programme: stage position over time" });
  private readonly dot = svg("circle", { r: 5, fill: "var(--moment)" });
  private x: Scale = scaleLinear();
  private y: Scale = scaleLinear();
  private unit: Unit = unitFor(1e-4, "length");
  private gripped = -1;
  private timer = 0;

  constructor(private readonly studio: Studio) {
    this.host.append(this.drawing);
    this.host.addEventListener("pointerdown", (event) => {
      const at = this.knobAt(event);
      if (at === null) return;
      this.gripped = at;
      studio.remember();
      this.host.setPointerCapture(event.pointerId);
    });
    this.host.addEventListener("pointermove", (event) => {
      if (this.gripped > 0) this.set(this.gripped, this.stageAt(event));
    });
    this.host.addEventListener("pointerup", () => (this.gripped = -1));
    this.host.addEventListener("dblclick", (event) => this.twice(event));
    byId("add-cycle").addEventListener("click", () => {
      studio.remember();
      const points = this.points, last = points[points.length - 1]!, top = Math.max(...points);
      studio.setProgramme([...points, Math.min(last, top) * 0.35, top]);
    });
    byId("play").addEventListener("click", () => this.play());
  }

  /** Stage positions [m]: that of the contact, the greatest of the rows used, then what is tried. */
  private get points(): number[] {
    return this.studio.programme ?? [0, this.studio.greatestStage];
  }
  private stageAt(event: PointerEvent | MouseEvent): number {
    return Math.max(0, Math.min(this.y.domain()[1]!, this.y.invert(placeIn(event, this.host)[1]))) * this.unit.factor;
  }
  /** The point under the pointer; by its place, since while one is gripped all events are those of the host. */
  private knobAt(event: PointerEvent | MouseEvent): number | null {
    const [px, py] = placeIn(event, this.host), { points } = this;
    for (let i = points.length - 1; i > 0; --i) if (Math.hypot(px - this.x(i), py - this.y(points[i]! / this.unit.factor)) <= 12) return i;
    return null;
  }
  private set(index: number, stage: number): void {
    const points = [...this.points];
    points[index] = stage;
    this.studio.setProgramme(points);
  }
  private twice(event: MouseEvent): void {
    const { studio } = this, points = [...this.points], at = this.knobAt(event);
    if (!studio.fit) return;
    studio.remember();
    if (at !== null) {
      if (at < 2 && points.length <= 2) return;
      points.splice(at, 1);
      if (points.length < 2) points.push(studio.greatestStage);
    } else points.splice(Math.max(1, Math.min(points.length, Math.ceil(this.x.invert(placeIn(event, this.host)[0])))), 0, this.stageAt(event));
    studio.setProgramme(points.length === 2 && points[1] === studio.greatestStage ? null : points);
  }

  draw(): void {
    const { studio } = this, fit = studio.fit, points = this.points;
    this.label();
    const { width, height } = sizeOf(this.host);
    if (!fit || width < 40) return sized(this.drawing, this.host, svg("g"));
    const most = Math.max(fit.greatestStage, ...points) * 1.15;
    this.unit = unitFor(most, "length");
    this.x = scaleLinear([0, Math.max(2, points.length) - 1], [LEFT, width - RIGHT - 4]);
    this.y = scaleLinear([0, most / this.unit.factor], [height - BOTTOM, TOP]);
    const { x, y, unit } = this, at = (i: number): string => `${x(i).toFixed(1)} ${y(points[i]! / unit.factor).toFixed(1)}`;
    const g = svg("g"), bottom = height - BOTTOM;
    g.append(svg("line", { x1: LEFT, x2: LEFT, y1: TOP - 4, y2: bottom, stroke: "var(--line2)" }), svg("line", { x1: LEFT, x2: width - RIGHT, y1: bottom, y2: bottom, stroke: "var(--line2)" }));
    for (const tick of y.ticks(4)) g.append(svg("line", { x1: LEFT - 4, x2: LEFT, y1: y(tick), y2: y(tick), stroke: "var(--line2)" }), svg("text", { x: LEFT - 6, y: y(tick) + 4, "text-anchor": "end" }, String(tick)));
    g.append(svg("text", { x: LEFT + 6, y: 10 }, `stage (${unit.name})`));
    g.append(path(`M${at(0)}L${at(1)}`, "var(--ink)", 1.6));
    if (points.length > 2) g.append(path(`M${points.slice(1).map((_, i) => at(i + 1)).join("L")}`, "var(--model)", 1.5, { "stroke-dasharray": "5 3" }));
    const say = (words: string, from: number, to: number): void => {
      if (x(to) - x(from) < words.length * 5) return;
      const text = svg("text", { x: (x(from) + x(to)) / 2, y: height - 5, "text-anchor": "middle" }, words);
      text.style.fill = "var(--ink3)";
      g.append(text);
    };
    say(points[1] === studio.greatestStage ? "measured" : "to try", 0, 1);
    if (points.length > 2) say(points.length === 4 ? "to try: unload, reload" : "to try", 1, points.length - 1);
    points.forEach((stage, i) => {
      const px = x(i), py = y(stage / unit.factor), colour = i < 2 ? "var(--ink)" : "var(--model)";
      const words = `${i === 0 ? "Start" : i % 2 ? "Load to" : "Unload to"}`;
      const value = Number((stage / unit.factor).toPrecision(4));
      g.append(i === 0 ? svg("circle", { cx: px, cy: py, r: 4.5, fill: "var(--surface)", stroke: colour, "stroke-width": 1.5 })
        : svg("g", { tabindex: 0, role: "slider", class: "knob", "data-knob": i, "aria-label": words, "aria-valuemin": 0, "aria-valuemax": Number((most / unit.factor).toPrecision(4)), "aria-valuenow": value, "aria-valuetext": `${value} ${unit.name}`, "aria-orientation": "vertical", keydown: (event: KeyboardEvent) => this.key(event, i) },
          svg("circle", { cx: px, cy: py, r: 12, fill: "transparent" }), svg("circle", { cx: px, cy: py, r: 4.5, fill: "var(--surface)", stroke: colour, "stroke-width": 1.5 })));
    });
    sized(this.drawing, this.host, g, this.dot);
    this.dot.style.pointerEvents = "none";
    this.mark();
  }

  private key(event: KeyboardEvent, index: number): void {
    const { studio } = this, by = { ArrowUp: 1, ArrowDown: -1 }[event.key], step = (this.y.domain()[1]! * this.unit.factor) / 100;
    if (event.key === "Delete" && this.points.length > 2) {
      studio.remember();
      const points = [...this.points];
      points.splice(index, 1);
      studio.setProgramme(points.length > 2 ? points : null);
    } else if (by) {
      studio.remember();
      this.set(index, Math.max(0, this.points[index]! + by * step * (event.shiftKey ? 10 : 1)));
    } else return;
    event.preventDefault();
    event.stopPropagation();
    requestAnimationFrame(() => this.host.querySelector<SVGElement>(`[data-knob="${index}"]`)?.focus());
  }

  mark(): void {
    const { studio } = this, moment = studio.moment, points = this.points;
    if (!moment) return;
    let place = 0;
    if (studio.tried !== null && studio.programmed) {
      // Which leg the state lies on: legs are passed one after the other.
      let leg = 0;
      const { stage } = studio.programmed;
      for (let i = 1; i <= studio.tried; ++i) {
        const way = Math.sign((points[leg + 1] ?? 0) - (points[leg] ?? 0));
        if (leg + 2 < points.length && way * (stage[i]! - stage[i - 1]!) < 0) ++leg;
      }
      place = leg + share(points[leg]!, points[leg + 1]!, moment.stage);
    } else place = share(0, points[1]!, moment.stage);
    this.dot.setAttribute("cx", String(this.x(Math.max(0, Math.min(points.length - 1, place)))));
    this.dot.setAttribute("cy", String(this.y(Math.max(0, moment.stage) / this.unit.factor)));
  }

  private label(): void {
    fill(byId("play"), svg("svg", { width: 9, height: 10, "aria-hidden": "true" }, svg("path", { d: this.timer ? "M0 0h3v10H0zM6 0h3v10H6z" : "M0 0l9 5-9 5z", fill: "currentColor" })), this.timer ? "Pause" : "Play");
    (byId("play") as HTMLButtonElement).disabled = !this.studio.fit;
  }

  /** Runs through the record and then through what is tried; with reduced motion from drop to drop. */
  play(): void {
    const { studio } = this, fit = studio.fit;
    if (this.timer) {
      clearInterval(this.timer);
      cancelAnimationFrame(this.timer);
      this.timer = 0;
      return this.label();
    }
    if (!fit) return;
    const [first, last] = studio.used, path = studio.programmed;
    if (studio.tried !== null || (studio.row >= last && !path)) studio.row = first;
    studio.tried = null;
    const stop = (): void => {
      clearInterval(this.timer);
      this.timer = 0;
      this.label();
    };
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.timer = window.setInterval(() => {
        const row = studio.row;
        studio.toDrop(1);
        if (studio.row === row) stop();
      }, 900);
    } else {
      let at = studio.row, then = performance.now(), state = path ? path.stage.findIndex((s) => s >= studio.greatestStage * 0.999) : -1;
      const step = (now: number): void => {
        const passed = ((now - then) * ROWS_A_SECOND) / 1000;
        then = now;
        if (at < last) {
          at = Math.min(last, at + passed);
          studio.setRow(Math.floor(at));
        } else if (path && state >= 0 && studio.programmed === path && state < path.stage.length - 1) {
          state = Math.min(path.stage.length - 1, state + passed * 2);
          studio.tried = Math.floor(state);
          studio.tell("moment");
        } else return stop();
        this.timer = requestAnimationFrame(step);
      };
      this.timer = requestAnimationFrame(step);
    }
    this.label();
  }
  get playing(): boolean {
    return this.timer !== 0;
  }
}

const share = (from: number, to: number, at: number): number => (to === from ? 0 : Math.max(0, Math.min(1, (at - from) / (to - from))));
