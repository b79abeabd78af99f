// The bytes of a text that pack.mjs made.
export function unpacked(text: string): Uint8Array<ArrayBuffer> {
  const whole = Math.floor(text.length / 5), rest = text.length % 5;
  const bytes = new Uint8Array(4 * whole + Math.max(rest - 1, 0));
  const digit = (at: number): number => {
    if (at >= text.length) return 84;  // rounds up what the group lacks
    const code = text.charCodeAt(at);
    return code - (code > 92 ? 42 : code > 60 ? 41 : 40);
  };
  for (let group = 0; 5 * group < text.length; ++group) {
    let four = 0;
    for (let j = 0; j < 5; ++j) four = four * 85 + digit(5 * group + j);
    const at = 4 * group;
    for (let j = 0; j < 4 && at + j < bytes.length; ++j) bytes[at + j] = Math.floor(four / 2 ** (24 - 8 * j));
  }
  return bytes;
}
