// The program's Worker. Its own script, as a text in the page: a page that comes from a file can start none from another file.
import type { Asked, Told } from "./messages";
import { runProgram } from "./run";

const scope = self as unknown as { onmessage: ((event: MessageEvent<Asked>) => void) | null; postMessage(told: Told, transfer?: Transferable[]): void };

let module: WebAssembly.Module | undefined;
let before: Promise<void> = Promise.resolve();

scope.onmessage = ({ data }) => {
  if ("module" in data) {
    module = data.module;
    return;
  }
  const { id, args, files } = data;
  before = before.then(async () => {
    try {
      if (!module) throw new Error("the program has not come");
      const ran = await runProgram(module, args, files, (line) => scope.postMessage({ id, line }));
      scope.postMessage({ id, ...ran }, Object.values(ran.files).map((file) => file.buffer as ArrayBuffer));
    } catch (error) {
      scope.postMessage({ id, failure: error instanceof Error ? error.message : String(error) });
    }
  });
};
