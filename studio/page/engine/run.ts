// One run of the program: an instance of its own, with memory and files of its own.
import flexslipProgram from "program-glue";
import { instantiated } from "./instance";

export interface Ran { code: number; out: string; err: string; files: Record<string, Uint8Array> }

const FOLDER = "/test/";

/** Bytes as they come, one by one. */
class Bytes {
  private held = new Uint8Array(1024);
  private length = 0;
  push(byte: number): void {
    if (this.length === this.held.length) {
      const more = new Uint8Array(2 * this.length);
      more.set(this.held);
      this.held = more;
    }
    this.held[this.length++] = byte;
  }
  text(from = 0): string { return new TextDecoder().decode(this.held.subarray(from, this.length)); }
  get end(): number { return this.length; }
}

const same = (a: Uint8Array, b: Uint8Array): boolean => a.length === b.length && a.every((byte, i) => byte === b[i]);

function writtenIn(fs: FileSystem, folder: string, given: Record<string, Uint8Array>, found: Record<string, Uint8Array>): void {
  for (const name of fs.readdir(folder)) {
    if (name === "." || name === "..") continue;
    const path = `${folder}${name}`, { mode } = fs.stat(path);
    if (fs.isDir(mode)) writtenIn(fs, `${path}/`, given, found);
    if (!fs.isFile(mode)) continue;
    const shown = path.slice(FOLDER.length), data = fs.readFile(path), before = given[shown];
    if (!before || !same(before, data)) found[shown] = data;
  }
}

/** A file's place within the folder: names that lead out of it stay in it. */
const inside = (name: string): string => FOLDER + name.split(/[/\\]/).filter((part) => part && part !== "." && part !== "..").join("/");

export async function runProgram(module: WebAssembly.Module, args: string[], files: Record<string, Uint8Array>, progress: (line: string) => void): Promise<Ran> {
  const out = new Bytes(), err = new Bytes();
  let shown = 0;
  const carriageReturn = 13, newline = 10, erased = /\x1b\[K/g;
  const running = await instantiated(flexslipProgram, module, {
    thisProgram: "flexslip",
    stdin: () => null,
    stdout: (byte) => out.push(byte),
    stderr(byte) {
      err.push(byte);
      if (byte !== carriageReturn && byte !== newline) return;
      if (byte === carriageReturn) progress(err.text(shown).replace(erased, "").trim());
      shown = err.end;
    },
    quit(_code, reason) { throw reason; },
  });
  const fs = running.FS, standardError = 2;
  fs.streams[standardError]!.tty = true;  // what is said there is shown as it comes
  fs.mkdirTree(FOLDER.slice(0, -1));
  fs.chdir(FOLDER);
  for (const [name, data] of Object.entries(files)) {
    const path = inside(name);
    fs.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    fs.writeFile(path, data);
  }
  const code = running.callMain(args);
  const written: Record<string, Uint8Array> = {};
  writtenIn(fs, FOLDER, files, written);
  // A line that shows progress is written over and over, and erased.
  const remarks = err.text().replace(/\x1b\[K[^\r\n]*\r/g, "").replace(erased, "");
  return { code, out: out.text(), err: remarks, files: written };
}
