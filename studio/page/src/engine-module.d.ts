declare module "engine" {
  import type { Mechanics, Program } from "./engine";
  export function openProgram(): Program;
  export function openMechanics(): Promise<Mechanics>;
}
