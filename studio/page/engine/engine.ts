// The two doors, over WebAssembly that stands in the page as text: its gzip, as pack.mjs writes it, in the elements #program and #mechanics, and the script
// of the Worker in #worker. Nothing is fetched.
import flexslipMechanics, { type Answered } from "mechanics-glue";
import { type Answer, Cancelled, type Mechanics, type Program } from "../src/engine";
import { instantiated } from "./instance";
import type { Asked, Told } from "./messages";
import { moduleOf } from "./unpack";

function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element?.textContent) throw new Error(`this page has no #${id}: it was not built whole`);
  return element.textContent;
}

interface Pending { resolve(answer: Answer): void; reject(error: Error): void; progress?: ((line: string) => void) | undefined }

const without = (why: string): Error => new Error(`the program ended without an answer: ${why}`);

/** What the Workers of the page have in common: their script, and the module as the first of them compiled it, so that those after it need not. */
interface Common { module: WebAssembly.Module | null; readonly script: string }

class ProgramInWorker implements Program {
  private readonly pending = new Map<number, Pending>();
  private next = 0;
  private worker: Worker | null = null;

  constructor(private readonly common: Common) {}

  /** The program is unpacked and compiled in the Worker, while the page makes its views. */
  begin(): this {
    this.worker ??= this.start();
    return this;
  }
  another(): Program {
    return new ProgramInWorker(this.common);
  }
  private start(): Worker {
    const { common } = this, worker = new Worker(common.script);
    worker.onmessage = ({ data }: MessageEvent<Told>) => {
      if ("module" in data) {
        common.module = data.module;
        return;
      }
      const run = this.pending.get(data.id);
      if (!run) return;
      if ("line" in data) {
        run.progress?.(data.line);
        return;
      }
      this.pending.delete(data.id);
      if ("failure" in data) run.reject(without(data.failure));
      else run.resolve({ code: data.code, out: data.out, err: data.err, files: data.files });
    };
    // One that does not start is started again by the next run, not at once: it would fail again.
    worker.onerror = (event) => {
      event.preventDefault();
      this.end(without(event.message || "its Worker did not start"));
    };
    worker.onmessageerror = () => this.end(without("what its Worker said cannot be read"));
    worker.postMessage((common.module ? { module: common.module } : { text: textOf("program") }) satisfies Asked);
    return worker;
  }

  run(args: string[], files: Record<string, Uint8Array>, progress?: (line: string) => void): Promise<Answer> {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.pending.set(id, { resolve, reject, progress });
      (this.worker ??= this.start()).postMessage({ id, args, files } satisfies Asked);
    });
  }

  cancel(): void {
    if (this.pending.size > 0) this.end(new Cancelled());
  }

  private end(reason: Error): void {
    this.worker?.terminate();
    this.worker = null;
    const ended = [...this.pending.values()];
    this.pending.clear();
    for (const run of ended) run.reject(reason);
  }
}

export function openProgram(): Program {
  return new ProgramInWorker({ module: null, script: URL.createObjectURL(new Blob([textOf("worker")], { type: "text/javascript" })) }).begin();
}

function result<T>(answered: Answered<T>): T {
  if (answered.error !== undefined) throw new Error(answered.error);
  return answered.result as T;
}

export async function openMechanics(): Promise<Mechanics> {
  const bound = await instantiated(flexslipMechanics, await moduleOf(textOf("mechanics")), {});
  const pointsOfStretch = 200;  // as the program's, where nothing else is asked
  return {
    simulate: (rig, programme, step) => result(bound.simulate(rig, programme, step, pointsOfStretch)),
    sketch: (rig, farthest, steps) => result(bound.sketch(rig, farthest, steps)),
    equilibrium: (rig, points, longest = 1.5 * rig.span) => result(bound.equilibrium(rig, longest, points)),
    shape: (rig, drawn, friction, points, beyond = 0.15 * rig.span) => result(bound.shape(rig, drawn, friction, points, beyond)),
    linear: (rig, deflection) => result(bound.linear(rig, deflection)),
    quantity: (words, kind) => result(bound.quantity(words, kind)),
    unit: (words, kind) => result(bound.unit(words, kind)),
  };
}
