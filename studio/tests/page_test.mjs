// The page's own nouns, without a browser: quantities, words for a shell, friction by the sliders, the tables that the program writes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { root } from "./browser.mjs";

const page = join(root, "studio/page"), bundler = join(page, "node_modules/esbuild/lib/main.js");
const skip = !existsSync(bundler) && "studio/page has no packages: npm ci";
const folder = mkdtempSync(join(tmpdir(), "flexslip-page-"));
after(() => rmSync(folder, { recursive: true }));
async function source(name) {
  const { build } = await import(pathToFileURL(bundler).href), outfile = join(folder, `${name}.mjs`);
  await build({ entryPoints: [join(page, "src", `${name}.ts`)], bundle: true, format: "esm", platform: "neutral", outfile, logLevel: "error" });
  return import(pathToFileURL(outfile).href);
}

test("table: quantities in SI, as docs/case-files.md has their units; what is none is refused", { skip }, async () => {
  const { parseQuantity } = await source("quantity");
  for (const [words, unit, value] of [["34.8 um", "", 34.8e-6], ["34.8 µm", "", 34.8e-6], ["34,8 µm", "", 34.8e-6], ["1.278 mm", "", 1.278e-3], ["90.65 N/m", "", 90.65], ["88 mN/um", "", 88e3], ["0.5 kN/mm", "", 5e5],
    ["2.1e-9 N m^2", "", 2.1e-9], ["2.1 mN mm²", "", 2.1e-9], ["29.6 GPa", "", 29.6e9], ["90 deg", "", Math.PI / 2], ["12", "um", 12e-6], ["−3", "", -3], ["inf", "N/m", Infinity], ["5 %", "", 0.05], ["3 micron", "", 3e-6],
    ["2 min", "", 120], ["5 mil", "", 1.27e-4], ["2 ksi", "", 13789514.586336722], ["3 mg", "", 3e-6]]) {
    const read = parseQuantity(words, unit);
    assert.ok(read === value || Math.abs(read - value) <= 4e-16 * Math.abs(value), `${words}: ${read}`);  // one rounding of the number, one of the unit, one of their product
  }
  for (const words of ["", "um", "12 parsec", "twelve", "1e", "1.2.3 um", "12 um; rm", "0x10 m", "12 __proto__", "12 constructor", "2 PPa", "2 kin"]) assert.equal(parseQuantity(words), null, words);
});

test("oracle: a word of the command line is what a shell makes of it", { skip }, async () => {
  const { shellWord } = await source("settings");
  for (const word of ["plain.csv", "two words.csv", "it's", '"quoted"', "$(touch x)", "`x`", "a\\b", "rig.stiffness=\"95 N/m\"", "!history", "a;b|c&d", "*?[x]", "", "~", "#x", "ü µ.csv", "line\nbreak"])
    assert.equal(execFileSync("/bin/bash", ["-c", `printf %s ${shellWord(word)}`], { encoding: "utf8" }), word);
});

const fit = { parameters: { drift: { value: -300 }, reference: { value: 1.4e-3 } } };
const values = { mu0: 0.48, roughness: 0.07, correlationLength: 5e-6, wave: { amplitude: 0.1, wavelength: 11e-6, phase: 0.4 } };
const lengths = Array.from({ length: 300 }, (_, i) => 1.29e-3 + i * 1e-6);
const meanAt = (S, i) => 0.48 - 300 * (S - 1.4e-3) + 0.048 * Math.cos((Math.PI * (S - 1.4e-3)) / 11e-6 + 0.4) + 0.05 * Math.sin(i / 7);

test("identity: friction at the values of the fit is its mean, bit by bit; without roughness it is level, drift and wave", { skip }, async () => {
  const [{ FittedFriction }, { Table }] = [await source("friction"), await source("table")];
  const table = new Table(["length [m],mu,deviation,draw_1", ...lengths.map((S, i) => `${S},${meanAt(S, i)},0.01,${meanAt(S, i)}`)].join("\n"));
  const friction = new FittedFriction(fit, table, values);
  assert.equal(friction.seen, 300);
  friction.at({ ...values }).slice(0, 300).forEach((mu, i) => assert.equal(mu, meanAt(lengths[i], i)));
  friction.at({ ...values, roughness: 0 }).slice(0, 300).forEach((mu, i) => assert.ok(Math.abs(mu - (meanAt(lengths[i], i) - 0.05 * Math.sin(i / 7))) < 1e-12));  // a few ulp of numbers below 1
  friction.at({ ...values, mu0: 0.58, wave: null }).slice(0, 300).forEach((mu, i) => assert.ok(Math.abs(mu - (0.58 - 300 * (lengths[i] - 1.4e-3) + 0.05 * Math.sin(i / 7))) < 1e-12));
  const twice = friction.at({ ...values, roughness: 0.14, wave: null }), once = friction.at({ ...values, wave: null });
  twice.slice(0, 300).forEach((mu, i) => assert.ok(Math.abs(mu - once[i] - 0.05 * Math.sin(i / 7)) < 1e-12));
  assert.ok(friction.at({ ...values, mu0: 0, roughness: 0.5 }).every((mu) => mu >= 0), "no friction is negative");
  assert.ok(friction.length.every((S, i) => i === 0 || S > friction.length[i - 1]), "lengths rise, beyond the record too");
});

test("table: what the program writes is read to the last bit, nan and remarks with it", { skip }, async () => {
  const { Table } = await source("table");
  const table = new Table("# a remark\nw_s [m],w [m],mu\n0.1,2.2204460492503131e-16,nan\n1e-7,-3.3333333333333331,0.48\n");
  assert.deepEqual([...table.column("w")], [2 ** -52, -10 / 3 + 2 ** -51]);
  assert.ok(Number.isNaN(table.column("mu")[0]));
  assert.equal(table.column("F"), null);
  assert.equal(table.unitOf(0), "m");
});

test("limit: names of files come without folders, flags and control characters, and are never empty", { skip }, async () => {
  const { harmless } = await source("files");
  for (const name of ["../../etc/passwd", "--help", "-o", ".", "..", "", "\u0000", "a/b\\c.csv", "x".repeat(5000), "a\nb"]) {
    const made = harmless(name);
    assert.match(made, /^[^-./\\\u0000-\u001f][^/\\\u0000-\u001f]{0,120}$/u, JSON.stringify(name));
  }
  assert.equal(harmless("SS14.csv"), "SS14.csv");
});

test("the page makes no element of words: no source assigns markup", { skip }, async () => {
  const { readdirSync } = await import("node:fs");
  for (const name of readdirSync(join(page, "src")).filter((n) => n.endsWith(".ts"))) assert.doesNotMatch(readFileSync(join(page, "src", name), "utf8"), /innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function|javascript:/, name);
});

test("a file that is read otherwise is fitted with the columns that were chosen, the force as well; an error stays with its quantity", { skip }, async () => {
  const [{ Test }, { partsOf }] = [await source("test"), await source("settings")], femur = new Test("femur", {}, "femur.txt", "femur.txt");
  femur.read = { columns: [{ number: 1, name: "Ch 1 Displacement", unit: "mm", role: "crosshead" }, { number: 2, name: "Ch 1 Force", unit: "kN", role: "force" }, { number: 4, name: "Aux", unit: "V", role: "other" }] };
  femur.settings = { read: { force: "2" }, displacement: "crosshead", span: 0.01, stiffness: 90.65, stiffnessOff: "0.3 N/m" };
  const [read, fit] = femur.commands(), said = (args, flag) => args[args.indexOf(flag) + 1];
  assert.equal(said(read, "--force"), "2");
  assert.equal(said(fit, "--force"), "Ch 1 Force");
  assert.equal(said(fit, "--stiffness"), "90.65 N/m ± 0.3 N/m");
  assert.deepEqual([partsOf("90.65 N/m ± 0.3 %"), partsOf("90.65 N/m+-3 N/m"), partsOf("1e+3 mm")].map(({ value, off }) => [value, off]), [["90.65 N/m", "0.3 %"], ["90.65 N/m", "3 N/m"], ["1e+3 mm", null]]);
});
