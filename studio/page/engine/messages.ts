// What the page and its Worker say to each other.
export type Asked = { module: WebAssembly.Module } | { id: number; args: string[]; files: Record<string, Uint8Array> };
export type Told =
  | { id: number; line: string }
  | { id: number; code: number; out: string; err: string; files: Record<string, Uint8Array> }
  | { id: number; failure: string };
