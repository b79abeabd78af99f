// A module's JavaScript with its WebAssembly.

/** Rejects where the WebAssembly does not start, of which Emscripten's own promise says nothing: it would never be settled. */
export function instantiated<Settings extends Instantiation, Running>(glue: (settings: Settings) => Promise<Running>, module: WebAssembly.Module, settings: Omit<Settings, keyof Instantiation>): Promise<Running> {
  return new Promise((resolve, reject) => {
    const instantiateWasm: Instantiation["instantiateWasm"] = (imports, done) => {
      WebAssembly.instantiate(module, imports).then(done).catch(reject);
      return {};
    };
    glue({ ...settings, instantiateWasm } as Settings).then(resolve, reject);
  });
}
