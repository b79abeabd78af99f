// The JavaScript that Emscripten writes beside the WebAssembly.
interface Instantiation {
  instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void): object;
}
interface FileSystem {
  streams: { tty?: unknown }[];
  mkdirTree(path: string): void;
  chdir(path: string): void;
  writeFile(path: string, data: Uint8Array): void;
  readFile(path: string): Uint8Array;
  readdir(path: string): string[];
  stat(path: string): { mode: number };
  isFile(mode: number): boolean;
  isDir(mode: number): boolean;
}

declare module "program-glue" {
  interface Running { FS: FileSystem; callMain(args: string[]): number }
  export default function flexslipProgram(settings: Instantiation & {
    thisProgram: string; stdin(): null; stdout(byte: number): void; stderr(byte: number): void; quit(code: number, reason: unknown): never;
  }): Promise<Running>;
}
declare module "mechanics-glue" {
  export type Answered<T> = { result: T; error?: undefined } | { result?: undefined; error: string };
  interface Bound {
    simulate(rig: unknown, programme: number[], step: number, points: number): Answered<import("../src/engine").Loading>;
    sketch(rig: unknown, farthest: number, steps: number): Answered<import("../src/engine").Loading>;
    equilibrium(rig: unknown, longest: number, points: number): Answered<import("../src/engine").Loading>;
    shape(rig: unknown, drawn: number, friction: number, points: number, beyond: number): Answered<import("../src/engine").Shape>;
    linear(rig: unknown, deflection: number): Answered<number>;
    quantity(words: string, kind: string): Answered<number>;
    unit(words: string, kind: string): Answered<number>;
  }
  export default function flexslipMechanics(settings: Instantiation): Promise<Bound>;
}
