// What the page and its Worker say to each other.
/** First the program, as the page's text or as the Worker before compiled it; then runs. */
export type Asked = { text: string } | { module: WebAssembly.Module } | { id: number; args: string[]; files: Record<string, Uint8Array> };
export type Told =
  | { module: WebAssembly.Module }
  | { id: number; line: string }
  | { id: number; code: number; out: string; err: string; files: Record<string, Uint8Array> }
  | { id: number; failure: string };
