#!/usr/bin/env node
// Bundles the page into one HTML file: script and style inlined, nothing fetched.
//   node build.mjs --engine FILE.ts --version VERSION --out FILE.html [--inline ID=FILE]...
// --version is that of the program, which puts tests into no other's page. --inline puts a text (WebAssembly packed by pack.mjs) into <script type="text/plain" id="ID">.
import { readFileSync, writeFileSync, mkdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url)), root = resolve(here, "../..");
const options = { engine: "", version: "", out: join(root, "build/studio/flexslip-studio.html"), inline: [] };
for (let i = 2; i < process.argv.length; i += 2) {
  const name = process.argv[i].replace(/^--/, ""), value = process.argv[i + 1];
  if (!(name in options) || value === undefined) throw new Error(`usage: build.mjs --engine FILE.ts --version VERSION [--out FILE.html] [--inline ID=FILE]...`);
  if (name === "inline") options.inline.push(value);
  else options[name] = name === "version" ? value : resolve(value);
}

const bundle = await build({
  entryPoints: [join(here, "src/main.ts")], bundle: true, write: false, minify: true, format: "iife", target: "es2022", charset: "utf8", legalComments: "none",
  alias: { engine: options.engine }, nodePaths: [join(here, "node_modules")], loader: { ".wasm": "binary" },
});
const style = await build({ entryPoints: [join(here, "src/style.css")], write: false, minify: true, charset: "utf8" });
const inScript = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
// A case's name names the test, so that of the example is the folder that it has in the repository.
const example = [["simulated.toml", "case.toml"], ["test.csv", "test.csv"]].map(([name, file]) => ({ name, text: readFileSync(join(root, "examples/simulated", file), "utf8") }));
const texts = options.inline.map((entry) => {
  const [id, file] = entry.split("=");
  return `<script type="text/plain" id="${id}">${readFileSync(file, "utf8").trim()}</script>`;
});
const page = readFileSync(join(here, "src/page.html"), "utf8")
  .replace("/*version*/", () => options.version)
  .replace("/*style*/", () => style.outputFiles[0].text)
  .replace("<!--inlined-->", () => [`<script type="application/json" id="example">${JSON.stringify(example).replaceAll("<", "\\u003c")}</script>`, ...texts].join("\n"))
  .replace("/*script*/", () => inScript(bundle.outputFiles[0].text));
mkdirSync(dirname(options.out), { recursive: true });
writeFileSync(options.out, page);
console.log(`${options.out}: ${(page.length / 1e6).toFixed(2)} MB, of it script ${(bundle.outputFiles[0].text.length / 1e3).toFixed(0)} kB`);
