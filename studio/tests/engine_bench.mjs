// How long a fit takes in Chromium and in the program of this computer, and how large each part of the page is. It prints; with LIMITS=1 it fails where a fit takes
// more than 2.5 times as long.
//   FLEXSLIP=PROGRAM node studio/tests/engine_bench.mjs [FOLDER of a case.toml]...       after tools/build-studio
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { program, root } from "./browser.mjs";

const out = join(root, "build/studio"), rounds = 5;
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
if (!existsSync(join(out, "engine.js")) || !existsSync(program) || !chromium) {
  console.log("the studio, the program or Chromium is missing: tools/build-studio, ./run, apt-get install chromium");
  process.exit(77);
}
const given = process.argv.slice(2), cases = given.length > 0 ? given : ["simulated", "cracked", "cyclic"].map((name) => join(root, "examples", name));
const folder = mkdtempSync(join(tmpdir(), "flexslip-bench-"));

// The engine alone in a page.
const element = (id) => `<script type="text/plain" id="${id}">${readFileSync(join(out, id === "worker" ? "worker.js" : `${id}.txt`), "utf8")}</script>`;
const opener = 'globalThis.began = performance.now(); globalThis.program = openProgram(); globalThis.mechanics = openMechanics();';
writeFileSync(join(folder, "page.html"), `<!DOCTYPE html><meta charset="utf-8">${["program", "mechanics", "worker"].map(element).join("")}<script type="module">${readFileSync(join(out, "engine.js"), "utf8")
  .replace(/export\s*\{([^}]*)\};?\s*$/, (_, names) => names.split(",").map((name) => name.trim().split(/\s+as\s+/)).map(([local, name]) => `const ${name ?? local}_=${local};globalThis.${name ?? local}=${name ?? local}_;`).join(""))};${opener.replace("openProgram()", "globalThis.openProgram()").replace("openMechanics()", "globalThis.openMechanics()")}</script>`);
const { chromium: engine } = createRequire(join(root, "studio/page/package.json"))("playwright-core");
const browser = await engine.launch({ executablePath: chromium, args: ["--no-sandbox"] });
const tab = await (await browser.newContext({ offline: true })).newPage();
tab.on("pageerror", (error) => console.log(error.message));
await tab.goto(pathToFileURL(join(folder, "page.html")).href);
await tab.waitForFunction(() => globalThis.program);
const ready = await tab.evaluate(async () => (await globalThis.mechanics, performance.now() - globalThis.began));
console.log(`mechanics ready after ${ready.toFixed(0)} ms`);

const middle = (times) => [...times].sort((a, b) => a - b)[Math.floor(times.length / 2)];
let slowest = 0;
for (const place of cases) {
  const files = Object.fromEntries(readdirSync(place).filter((name) => statSync(join(place, name)).isFile()).map((name) => [name, readFileSync(join(place, name)).toString("base64")]));
  const args = ["fit", "case.toml", "--json", "--quiet"], native = [], page = [];
  for (let i = 0; i < rounds; ++i) {
    const began = performance.now();
    const { status } = spawnSync(program, args, { cwd: place });
    native.push(performance.now() - began);
    assert.equal(status, 0);
    const { took, code, err } = await tab.evaluate(async ({ args, files }) => {
      const bytes = Object.fromEntries(Object.entries(files).map(([name, text]) => [name, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));
      const from = performance.now(), { code, err } = await globalThis.program.run(args, bytes);
      return { took: performance.now() - from, code, err };
    }, { args, files });
    assert.equal(code, 0, err);
    page.push(took);
  }
  const ratio = middle(page) / middle(native);
  slowest = Math.max(slowest, ratio);
  console.log(`${basename(place)}: program ${middle(native).toFixed(0)} ms, page ${middle(page).toFixed(0)} ms (the first ${page[0].toFixed(0)} ms): ${ratio.toFixed(2)} times`);
}
for (const file of ["program.txt", "mechanics.txt", "worker.js", "engine.js", "flexslip-studio.html"]) if (existsSync(join(out, file))) console.log(`${file}: ${statSync(join(out, file)).size} bytes`);
await browser.close();
rmSync(folder, { recursive: true });
if (process.env.LIMITS) assert.ok(slowest <= 2.5, `a fit takes ${slowest.toFixed(2)} times as long`);
