// The passes of a record that was unloaded, as curves: in, out, and in again.

import type { FitAnswer, Pass } from "./answers";
import type { Curve } from "./model";

export interface DrawnPass { number: number; words: "in" | "out" | "in again"; isEvaluated: boolean; pass: Pass; curve: Curve }

/** Empty of a record of one loading. */
export function passesOf(fit: FitAnswer, stiffness: number): DrawnPass[] {
  const all = fit.passes?.passes ?? [], first = all.findIndex((pass) => pass.direction === "in"), { first_row: row } = fit.measurement;
  return all.map((pass, i) => {
    const deflection = Float64Array.from(pass.deflection), force = Float64Array.from(pass.force);
    return {
      number: i + 1, pass, words: pass.direction === "out" ? "out" : i === first ? "in" : "in again", isEvaluated: pass.direction === "in" && row >= pass.rows[0] && row <= pass.rows[1],
      curve: { stage: deflection.map((w, j) => w + force[j]! / stiffness), deflection, force },
    };
  });
}

/** "pass 1: in", "passes 2, 4: out": of each kind that is drawn, with one of them. */
export function kindsOf(passes: readonly DrawnPass[]): { words: string; pass: DrawnPass }[] {
  return [true, false].flatMap((isEvaluated) => (["in", "out", "in again"] as const).flatMap((words) => {
    const alike = passes.filter((pass) => pass.isEvaluated === isEvaluated && pass.words === words);
    return alike.length ? [{ pass: alike[0]!, words: `${alike.length === 1 ? "pass" : "passes"} ${alike.map((pass) => pass.number).join(", ")}: ${words}` }] : [];
  }));
}
