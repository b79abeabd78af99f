// The two doors, over WebAssembly that stands in the page as text: its gzip, as pack.mjs writes it, in the elements #program and #mechanics, and the script
// of the Worker in #worker. Nothing is fetched.
import flexslipMechanics, { type Answered } from "mechanics-glue";
import { type Answer, Cancelled, type Mechanics, type Program } from "../src/engine";
import type { Asked, Told } from "./messages";
import { unpacked } from "./unpack";

function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element?.textContent) throw new Error(`this page has no #${id}: it was not built whole`);
  return element.textContent;
}

async function compiled(id: string): Promise<WebAssembly.Module> {
  const code = new Blob([unpacked(textOf(id))]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(code).arrayBuffer());
}

interface Pending { resolve(answer: Answer): void; reject(error: Error): void; progress?: ((line: string) => void) | undefined }

class ProgramInWorker implements Program {
  private readonly module = compiled("program");
  private readonly script = URL.createObjectURL(new Blob([textOf("worker")], { type: "text/javascript" }));
  private worker = this.start();
  private readonly pending = new Map<number, Pending>();
  private next = 0;

  constructor() {
    this.module.catch(() => undefined);  // said by each run
  }

  private start(): Worker {
    const worker = new Worker(this.script);
    void this.module.then((module) => worker.postMessage({ module } satisfies Asked), () => undefined);
    worker.onmessage = ({ data }: MessageEvent<Told>) => {
      const run = this.pending.get(data.id);
      if (!run) return;
      if ("line" in data) {
        run.progress?.(data.line);
        return;
      }
      this.pending.delete(data.id);
      if ("failure" in data) run.reject(new Error(`the program ended without an answer: ${data.failure}`));
      else run.resolve({ code: data.code, out: data.out, err: data.err, files: data.files });
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.end(new Error(`the program ended without an answer: ${event.message || "its Worker did not start"}`));
    };
    return worker;
  }

  async run(args: string[], files: Record<string, Uint8Array>, progress?: (line: string) => void): Promise<Answer> {
    const id = this.next++;
    const answer = new Promise<Answer>((resolve, reject) => this.pending.set(id, { resolve, reject, progress }));
    answer.catch(() => undefined);  // cancelled while the program is still being unpacked
    await this.module;
    if (this.pending.has(id)) this.worker.postMessage({ id, args, files } satisfies Asked);
    return answer;
  }

  cancel(): void {
    if (this.pending.size > 0) this.end(new Cancelled());
  }

  private end(reason: Error): void {
    this.worker.terminate();
    const ended = [...this.pending.values()];
    this.pending.clear();
    this.worker = this.start();
    for (const run of ended) run.reject(reason);
  }
}

export function openProgram(): Program {
  return new ProgramInWorker();
}

function result<T>(answered: Answered<T>): T {
  if (answered.error !== undefined) throw new Error(answered.error);
  return answered.result as T;
}

export async function openMechanics(): Promise<Mechanics> {
  const module = await compiled("mechanics");
  const bound = await flexslipMechanics({
    instantiateWasm(imports, done) {
      void WebAssembly.instantiate(module, imports).then(done);
      return {};
    },
  });
  const pointsOfStretch = 200;  // as the program's, where nothing else is asked
  return {
    simulate: (rig, programme, step) => result(bound.simulate(rig, programme, step, pointsOfStretch)),
    equilibrium: (rig, points, longest = 1.5 * rig.span) => result(bound.equilibrium(rig, longest, points)),
    shape: (rig, drawn, friction, points, beyond = 0.15 * rig.span) => result(bound.shape(rig, drawn, friction, points, beyond)),
    friction: (rig, positions) => result(bound.friction(rig, positions)),
    tabulated: (rig, farthest) => result(bound.tabulated(rig, farthest)),
    linear: (rig, deflection) => result(bound.linear(rig, deflection)),
  };
}
