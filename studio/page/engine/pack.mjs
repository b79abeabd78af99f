// Bytes as text for a page: five of 85 characters for four bytes, where base64 takes five and a third.   node pack.mjs < BYTES > TEXT
// The characters are ( to ~ without < and \, so that no text ends the element it stands in.
import { readFileSync, writeSync } from "node:fs";

const bytes = readFileSync(0), letters = [];
for (let code = 40; code <= 126; ++code) if (code !== 60 && code !== 92) letters.push(String.fromCharCode(code));
const text = [];
for (let i = 0; i < bytes.length; i += 4) {
  const there = Math.min(4, bytes.length - i);
  let four = 0;
  for (let j = 0; j < 4; ++j) four = four * 256 + (j < there ? bytes[i + j] : 0);
  const five = [];
  for (let j = 0; j < 5; ++j) {
    five.unshift(letters[four % 85]);
    four = Math.floor(four / 85);
  }
  text.push(...five.slice(0, there + 1));
}
const all = Buffer.from(text.join(""), "latin1");
for (let written = 0; written < all.length;) written += writeSync(1, all, written);
