// The program's Worker. Its own script, as a text in the page: a page that comes from a file can start none from another file.
import type { Asked, Told } from "./messages";
import { runProgram } from "./run";
import { moduleOf } from "./unpack";

const scope = self as unknown as { onmessage: ((event: MessageEvent<Asked>) => void) | null; postMessage(told: Told, transfer?: Transferable[]): void };

let program: Promise<WebAssembly.Module> = Promise.reject(new Error("the program has not come"));
program.catch(() => undefined);
let before: Promise<void> = Promise.resolve();

scope.onmessage = ({ data }) => {
  if ("module" in data) {
    program = Promise.resolve(data.module);
    return;
  }
  if ("text" in data) {
    program = moduleOf(data.text);
    program.then((module) => scope.postMessage({ module }), () => undefined);  // a fault is said by each run
    return;
  }
  const { id, args, files } = data;
  before = before.then(async () => {
    try {
      const ran = await runProgram(await program, args, files, (line) => scope.postMessage({ id, line }));
      scope.postMessage({ id, ...ran }, Object.values(ran.files).map((file) => file.buffer as ArrayBuffer));
    } catch (error) {
      scope.postMessage({ id, failure: error instanceof Error ? error.message : String(error) });
    }
  });
};
