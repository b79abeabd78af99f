// The engine as the page sees it: two doors. The bundle takes them from the module "engine", which is the program compiled to WebAssembly.

export interface Answer { code: number; out: string; err: string; files: Record<string, Uint8Array> }

/** The command line of flexslip in a Worker, with files in memory. */
export interface Program {
  /** Runs `flexslip ...args` in a folder of its own that holds `files`. */
  run(args: string[], files: Record<string, Uint8Array>, progress?: (line: string) => void): Promise<Answer>;
  /** Ends what runs; its promise is rejected. */
  cancel(): void;
}

/** Mechanics on the page's own thread, for what follows the pointer. In SI; arrays are copies. */
export interface Mechanics {
  simulate(rig: Rig, programme: number[], step: number): Loading;
  equilibrium(rig: Rig, points: number): Loading;
  shape(rig: Rig, drawnLength: number, friction: number, points: number): Shape;
  friction(rig: Rig, positions: Float64Array): Float64Array;
  linear(rig: Rig, deflection: number): number;
}
export interface Rig {
  span: number;              // [m]
  diameter: number;          // [m]
  bendingStiffness: number;  // [N m²]
  stiffness: number;         // [N/m] of the load train, Infinity allowed
  tipRadius: number;         // [m] of the supports, 0: edges
  friction: Friction;
}
export type Friction =
  | { model: "rough"; mu0: number; rms: number; correlationLength: number; seed: number; wave?: { amplitude: number; wavelength: number; phase: number } }
  | { model: "table"; position: Float64Array; mu: Float64Array };
export interface Loading {
  stage: Float64Array; deflection: Float64Array; force: Float64Array; drawn: Float64Array; friction: Float64Array;
  snaps: { from: number; to: number }[];
}
export interface Shape { x: Float64Array; y: Float64Array; contact: [number, number][]; normal: number; tangential: number; force: number }
