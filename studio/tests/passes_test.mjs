// A record that was unloaded and loaded again: all its passes in the one figure of force, and the program's line of the reload.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, drop, exported, fitted, missing, native, open, painted, RIG, root, say } from "./browser.mjs";

const skip = missing || false;
after(close);
const files = Object.fromEntries(["cyclic.toml", "cyclic.csv"].map((name) => [name, readFileSync(join(root, "examples/cyclic", name === "cyclic.toml" ? "case.toml" : "test.csv"), "utf8").replace('"test.csv"', '"cyclic.csv"')]));
const drawn = (tab) => tab.evaluate(() => [...document.querySelectorAll("#force-plot .passes path")].map((line) => ({ dashed: line.hasAttribute("stroke-dasharray"), points: line.getAttribute("d").split(/[ML]/).length - 1 })));
const legend = (tab) => tab.locator("#force-marks span").allInnerTexts();
async function shown(tab) {
  await drop(tab, ...Object.entries(files).map(([name, text]) => ({ name, bytes: Buffer.from(text) })));
  await tab.waitForFunction(() => document.querySelector("#what b")?.textContent === "cyclic");
  await fitted(tab);
  await painted(tab);
}

test("several passes: the figure of force has each by its own line, the answer the program's line", { skip }, async () => {
  const tab = await open(), fit = JSON.parse(native(["fit", "cyclic.toml", "--json"], files).out), { passes } = fit.passes;
  await shown(tab);
  assert.deepEqual((await legend(tab)).slice(0, 3), ["pass 3: in again", "pass 1: in", "pass 2: out"]);
  assert.deepEqual(await drawn(tab), [{ dashed: false, points: passes[0].force.length }, { dashed: true, points: passes[1].force.length }], "the one that is evaluated is the data");
  await tab.locator("#verdict summary").click();
  const said = await tab.locator("#verdict details .lines").innerText();
  assert.ok(said.includes(fit.answer.find((row) => row.label === "reload").words), said);
  const before = await drawn(tab);
  await tab.locator("#axis-stage").click();
  await painted(tab);
  assert.deepEqual((await drawn(tab)).map(({ dashed }) => dashed), before.map(({ dashed }) => dashed), "over the stage too");
  assert.deepEqual(tab.said, []);
  await tab.end();
});

/** A record that loses stiffness between two loadings: SLIP AND DAMAGE, or CRACK where it does not slide. */
function damaged() {
  const { simulated } = JSON.parse(readFileSync(join(root, "tests/outside/doors.json"), "utf8")).find(({ name }) => name === "damaged");
  return Buffer.from(native(["simulate", "truth.toml", "--noise", "10 uN"], { "truth.toml": simulated.join("\n") }).out);
}

test("the passes: the friction of each with its error, the causes of the drops where the program tells them, and the figure of each pass", { skip }, async () => {
  const tab = await open(), { passes } = JSON.parse(native(["fit", "cyclic.toml", "--json"], files).out);
  await shown(tab);
  assert.equal(await tab.locator("#passes .causes").count(), 0, "no loading came after the drops");
  const cells = await tab.locator("#passes tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(cells.map(([pass, rows]) => [pass, rows]), passes.passes.map(({ rows }, i) => [["1: in", "2: out", "3: in again"][i], rows.join("–")]));
  for (const [i, [, , friction]] of cells.entries()) {
    const { value, standard_error: error } = passes.passes[i].friction, [shownValue, shownError] = friction.split(" ± ").map(Number);
    assert.ok(Math.abs(shownValue - value) <= 0.0005 + 1e-12 && Math.abs(shownError - error) <= 0.0005 + 1e-12, friction);
  }
  const points = await tab.locator("#boxes-plot path").evaluateAll((all) => all.map((path) => path.getAttribute("d")?.match(/M/g)?.length ?? 0).reduce((a, b) => a + b, 0));
  assert.ok(points > 0.9 * passes.passes.reduce((sum, { q }) => sum + q.length, 0), `${points} points are drawn`);
  const { "cyclic-boxes.svg": figure } = await exported(tab, "Figures", "SVG");
  assert.match(String(figure), /Friction of each pass/);
  const { "cyclic-report.html": report } = await exported(tab, "Report");
  assert.match(String(report), /Mobilised friction of each pass/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("a loss between two loadings: the causes of the drops with their probabilities, which add up", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "damaged.csv", bytes: damaged() });
  await say(tab, { ...RIG, modulus: "29.6 GPa" });
  await fitted(tab);
  await painted(tab);
  assert.match(await tab.locator("#verdict h1").innerText(), /^SLIP AND DAMAGE/);
  const words = await tab.locator("#passes .causes > div:not(.shares)").allInnerTexts();
  assert.deepEqual(words.map((line) => line.replace(/\s*(below|above)?\s*[\d.]+ %$/, "").trim()), ["slips only", "slips and cracks", "cracks only"]);
  const { causes } = JSON.parse(native(["fit", "damaged.csv", "--span", RIG.span, "--diameter", RIG.diameter, "--stiffness", RIG["load train"], "--modulus", "29.6 GPa", "--json"], { "damaged.csv": damaged() }).out).judgement;
  assert.ok(Math.abs(causes.slips + causes.both + causes.cracks - 1) < 1e-9);
  const shares = await tab.locator("#passes .shares span").evaluateAll((all) => all.map((each) => Number(each.style.flexGrow)));
  assert.ok([causes.slips, causes.both, causes.cracks].every((share, i) => Math.abs(shares[i] - share) < 1e-5), String(shares));
  await tab.end();
});

test("one loading: data, model and drops as ever, and nothing of passes", { skip }, async () => {
  const tab = await open();
  assert.equal(await tab.locator("#passes-section").isVisible(), false);
  assert.equal((await legend(tab))[0], "data");
  assert.deepEqual(await drawn(tab), []);
  await shown(tab);
  await tab.locator("#tests .test").first().click();
  await painted(tab);
  assert.deepEqual(await drawn(tab), []);
  await tab.end();
});

for (const [width, height] of [[390, 844], [820, 1180], [1280, 800]])
  for (const theme of ["light", "dark"])
    test(`passes, ${width} by ${height}, ${theme}: nothing is wider than the window or cut off`, { skip }, async () => {
      const tab = await open({ width, height, theme });
      await shown(tab);
      assert.ok((await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
      const cut = await tab.evaluate(() => [...document.querySelectorAll("#force-marks, #verdict, #moment, .parameter, #passes, #passes td")].filter((e) => e.scrollWidth > e.clientWidth + 1 || e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => e.id || e.textContent));
      assert.deepEqual(cut, []);
      await tab.end();
    });
