// The WebAssembly of a text that pack.mjs made.

const DIGITS = Uint8Array.from({ length: 128 }, (_, code) => code - (code > 92 ? 42 : code > 60 ? 41 : 40));

export function unpacked(text: string): Uint8Array<ArrayBuffer> {
  const groups = Math.ceil(text.length / 5), lacking = 5 * groups - text.length;
  const bytes = new Uint8Array(4 * groups), view = new DataView(bytes.buffer);
  for (let group = 0, at = 0; group < groups; ++group) {
    let four = 0;
    for (let j = 0; j < 5; ++j, ++at) four = (Math.imul(four, 85) + (at < text.length ? DIGITS[text.charCodeAt(at)]! : 84)) | 0;  // 84 rounds up what the group lacks
    view.setInt32(4 * group, four);
  }
  return bytes.subarray(0, bytes.length - lacking);
}

/** Compiled while it is unpacked. */
export async function moduleOf(text: string): Promise<WebAssembly.Module> {
  const code = new Blob([unpacked(text)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(code, { headers: { "Content-Type": "application/wasm" } }));
}
