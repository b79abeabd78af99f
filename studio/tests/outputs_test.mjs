// What can be taken out, held against the command line: the command of the menu, run natively on the same files, writes the same.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, commandOf, drop, exported, fitted, missing, native, open, painted, root } from "./browser.mjs";

const skip = missing || false;
after(close);
const example = Object.fromEntries([["simulated.toml", "case.toml"], ["test.csv", "test.csv"]].map(([name, file]) => [name, readFileSync(join(root, "examples/simulated", file))]));
const text = (files, name) => Buffer.from(files[name]).toString("utf8");

/** All that was computed, apart from where it came from. */
function sameFit(page, shell) {
  const computed = ({ provenance: _, ...rest }) => rest;
  assert.deepEqual(computed(page), computed(shell));
}

test("JSON and CSV have the bytes of the command line", { skip }, async () => {
  const tab = await open();
  const shell = native(["fit", "simulated.toml", "--json", "--profile", "profile.csv", "--curves", "curves.csv"], example);
  assert.equal(text(await exported(tab, "All results"), "simulated.json"), shell.out);
  for (const [title, part] of [["Curves", "curves"], ["Friction along the specimen", "profile"]]) assert.equal(text(await exported(tab, title), `simulated-${part}.csv`), shell[`${part}.csv`], title);
  const { "simulated.xlsx": book } = await exported(tab, "Workbook");
  assert.equal(String(book.subarray(0, 2)), "PK");
  assert.ok(book.length > 20_000, "a row for each reading");
  await tab.end();
});

test("the case file runs in a shell and gives the same fit", { skip }, async () => {
  const tab = await open();
  const toml = text(await exported(tab, "Case file"), "simulated.toml"), json = JSON.parse(text(await exported(tab, "All results"), "simulated.json"));
  sameFit(json, JSON.parse(native(["fit", "simulated.toml", "--json"], { "simulated.toml": toml, "test.csv": example["test.csv"] }).out));
  await tab.end();
});

test("the command of the menu, after rows and rig were changed, is what was run", { skip }, async () => {
  const tab = await open();
  const box = tab.locator(".parameter[data-parameter=kc] input.number");
  await box.fill("95");
  await box.press("Enter");
  await tab.locator("[data-handle=last]").focus();
  for (let i = 0; i < 4; ++i) await tab.keyboard.press("Shift+ArrowLeft"), await painted(tab);
  await tab.locator("#fit").click();
  await fitted(tab);
  const command = await commandOf(tab);
  assert.equal(command, `flexslip fit simulated.toml --set 'rig.stiffness="95 N/m"' --set record.until=386`);
  const json = JSON.parse(text(await exported(tab, "All results"), "simulated.json"));
  sameFit(json, JSON.parse(native(["fit", "simulated.toml", "--set", 'rig.stiffness="95 N/m"', "--set", "record.until=386", "--json"], example).out));
  await tab.end();
});

test("report: one HTML file with the answer, that asks for nothing", { skip }, async () => {
  const tab = await open();
  const html = text(await exported(tab, "Report"), "simulated-report.html");
  assert.match(html, /<html/i);
  assert.match(html, /cracks only/i);
  assert.equal(html.match(/<svg[^>]*aria-label="simulated: /g)?.length, 2, "force and friction are drawn");
  for (const [, target] of html.matchAll(/href="([^"]*)"/g)) assert.match(target, /^(#|https?:)/, "no link to a file that is not there");
  assert.doesNotMatch(html, /<(script|link|img|iframe)[^>]+(src|href)=["']https?:/i);
  await tab.end();
});

test("figures: SVG without colours of the page's own names, PNG of 170 mm at 300 dpi", { skip }, async () => {
  const tab = await open({ theme: "dark" });
  const drawn = await exported(tab, "Figures", "SVG");
  assert.deepEqual(Object.keys(drawn).sort(), ["simulated-force.svg", "simulated-friction.svg", "simulated-specimen.svg"]);
  for (const [name, bytes] of Object.entries(drawn)) {
    const svg = Buffer.from(bytes).toString("utf8");
    assert.match(svg, /^<svg[^>]+width="170mm"/, name);
    assert.doesNotMatch(svg, /var\(--/, `${name}: colours are resolved`);
    assert.doesNotMatch(svg, /#191c20/i, `${name}: exported light`);
    if (!name.includes("specimen")) assert.match(svg, /deflection at midspan|over each support/, `${name}: its axis is named`);
    if (name.includes("force")) assert.match(svg, />model</, `${name}: its legend`);
    const parsed = await tab.evaluate((words) => new DOMParser().parseFromString(words, "image/svg+xml").querySelectorAll("parsererror").length, svg);
    assert.equal(parsed, 0, name);
  }
  for (const [name, bytes] of Object.entries(await exported(tab, "Figures", "PNG"))) {
    assert.deepEqual([...bytes.subarray(1, 4)], [...Buffer.from("PNG")], name);
    assert.equal(bytes.readUInt32BE(16), Math.round((170 / 25.4) * 300), name);
  }
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("address: a link brings the state back, of the example and of a dropped file", { skip }, async () => {
  const stateOf = (tab) => tab.evaluate(() => ({ values: [...document.querySelectorAll(".parameter input.number")].map((e) => e.value), row: document.querySelector("#moment .cell b").textContent, axis: document.querySelector("#axis-stage").getAttribute("aria-pressed"), head: document.querySelector("#what").textContent, programme: document.querySelectorAll("[data-knob]").length }));
  for (const dropped of [false, true]) {
    const tab = await open();
    if (dropped) {
      await drop(tab, { name: "mine.toml", bytes: Buffer.from(example["simulated.toml"].toString("utf8").replace("test.csv", "mine.csv")) }, { name: "mine.csv", bytes: example["test.csv"] });
      await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "mine");
      await fitted(tab);
    }
    const box = tab.locator(".parameter[data-parameter=EI] input.number");
    await box.fill("2.3");
    await box.press("Enter");
    await tab.locator("#axis-stage").click();
    await tab.locator("#add-cycle").click();
    await tab.locator("#force-plot").focus();
    await tab.keyboard.press("Shift+ArrowRight");
    await painted(tab);
    const before = await stateOf(tab);
    await tab.click("#export");
    await tab.locator("#menu button", { hasText: "Link to this state" }).click();
    await tab.waitForFunction(() => location.hash.startsWith("#s="));
    const hash = await tab.evaluate(() => location.hash), again = await open({ hash });
    await painted(again);
    assert.deepEqual(await stateOf(again), before, dropped ? "a dropped file" : "the example");
    await again.reload();
    await again.waitForSelector("body[data-ready]");
    await painted(again);
    assert.deepEqual(await stateOf(again), before, "reloaded");
    assert.deepEqual(again.said, []);
    await again.end();
    await tab.end();
  }
});
