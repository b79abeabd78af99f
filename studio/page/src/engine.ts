// The engine as the page sees it: two doors. The bundle takes them from the module "engine", which is the program compiled to WebAssembly.

export interface Answer { code: number; out: string; err: string; files: Record<string, Uint8Array> }

/** The command line of flexslip in a Worker, with files in memory. */
export interface Program {
  /** Runs `flexslip ...args` in a folder of its own that holds `files` (names may have folders); answers what it printed and the files that it wrote or
   *  changed. Runs wait for one another. `progress` is called with each line that the program shows of its progress. */
  run(args: string[], files: Record<string, Uint8Array>, progress?: (line: string) => void): Promise<Answer>;
  /** Ends what runs and what waits; their promises are rejected with a Cancelled. */
  cancel(): void;
  /** The same program in a Worker of its own, whose runs wait for none of this one. */
  another(): Program;
}
export class Cancelled extends Error {
  constructor() {
    super("cancelled");
    this.name = "Cancelled";
  }
}

/** Mechanics on the page's own thread, for what follows the pointer. In SI; arrays are copies. Each throws an Error with a sentence where it cannot compute. */
export interface Mechanics {
  /** A loading of the rig: what `flexslip simulate` answers, as columns; the same bits. A step of 0: continuously, 200 points on each stretch. */
  simulate(rig: Rig, programme: number[], step: number): Loading;
  /** One loading up to a stage position, at so many even steps: as simulate to a thousandth of the greatest force, and quickly; without motion and snaps. */
  sketch(rig: Rig, farthest: number, steps: number): Loading;
  /** The equilibrium curve of loading, whatever the rig: what `flexslip equilibrium --points` answers; up to a length between the supports, without one 1.5 spans. */
  equilibrium(rig: Rig, points: number, longest?: number): Loading;
  /** The fibre's axis at a state, `points` between the supports and one beyond each, where `beyond` [m] lie as it is straight (without it, 0.15 spans). */
  shape(rig: Rig, deflection: number, friction: number, points: number, beyond?: number): Shape;
  /** Euler-Bernoulli's force at a deflection. */
  linear(rig: Rig, deflection: number): number;
  /** What is written in a box, by the program's own parser: a quantity of this kind ("a length", "a stiffness", …), or what one of a unit of it is. */
  quantity(words: string, kind: QuantityKind): number;
  unit(words: string, kind: QuantityKind): number;
}
export type QuantityKind = "a length" | "a stiffness" | "a modulus" | "a bending stiffness" | "a force" | "a time" | "a speed" | "an angle" | "a plain number";
export interface Rig {
  span: number;              // [m]
  diameter: number;          // [m] depth of the section; 0: friction acts at the axis
  bendingStiffness: number;  // [N m²]
  stiffness: number;         // [N/m] of the load train, Infinity allowed
  tipRadius: number;         // [m] of the supports, 0: edges
  friction: { length: Float64Array; mu: Float64Array };  // as a case names it with model = "table": over lengths between the contacts [m], rising
}
export interface State { deflection: number; force: number; drawn: number; friction: number }
export interface Loading {
  status: "ok" | "slipped_through" | "contact_lost" | "branch_ended";  // otherwise the columns end early
  stage: Float64Array; deflection: Float64Array; force: Float64Array;  // [m], [m], [N]
  drawn: Float64Array;     // [m] over both supports
  friction: Float64Array;  // [1] mobilised
  motion: Uint8Array;      // by which it came here: 0 stick, 1 slip_in, 2 slip_out, 3 snap, 4 crack, 5 apart
  snaps: { stage: number; from: State; to: State }[];
}
export interface Shape {
  x: Float64Array; y: Float64Array;  // [m] from midway between the supports as first touched, upward
  contact: [number, number][];       // of the axis: left, right
  slope: number;                     // [rad] there
  normal: number; tangential: number;  // [N] at each support; friction on a fibre drawn in points outwards
  force: number;                     // [N] at midspan
  slid: number;                      // [m] in over both supports
}
