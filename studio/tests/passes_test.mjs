// A record that was unloaded and loaded again: all its passes in the one figure of force, and the friction of each as the program says it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, drop, fitted, missing, native, open, painted, root } from "./browser.mjs";

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

test("several passes: the figure of force has each by its own line, the table its friction with the error, and the program's sentence", { skip }, async () => {
  const tab = await open(), fit = JSON.parse(native(["fit", "cyclic.toml", "--json"], files).out), { passes } = fit.passes;
  await shown(tab);
  assert.deepEqual((await legend(tab)).slice(0, 3), ["pass 3: in again", "pass 1: in", "pass 2: out"]);
  assert.deepEqual(await drawn(tab), [{ dashed: false, points: passes[0].force.length }, { dashed: true, points: passes[1].force.length }], "the one that is evaluated is the data");
  const rows = await tab.locator("#passes tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.deepEqual(rows, passes.map(({ rows: [first, last], sliding_rows, friction }, i) => [String(i + 1), ["in", "out", "in again"][i], `${first}–${last}`, String(sliding_rows), `${friction.value.toFixed(3)} ± ${friction.standard_error.toFixed(3)}`]));
  const said = await tab.locator("#passes-said").innerText();
  assert.equal(said, fit.answer.find((row) => row.label === "reload").words);
  assert.match(said, /\d % of the stiffness lost \(cracks only would cost .* %\)/);
  const before = await drawn(tab);
  await tab.locator("#axis-stage").click();
  await painted(tab);
  assert.deepEqual((await drawn(tab)).map(({ dashed }) => dashed), before.map(({ dashed }) => dashed), "over the stage too");
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("one loading: data, model and drops as ever, no table of passes", { skip }, async () => {
  const tab = await open();
  assert.equal((await legend(tab))[0], "data");
  assert.deepEqual(await drawn(tab), []);
  assert.equal(await tab.locator("#passes-section").isVisible(), false);
  await shown(tab);
  assert.equal(await tab.locator("#passes-section").isVisible(), true);
  await tab.locator("#tests li").first().click();
  await painted(tab);
  assert.equal(await tab.locator("#passes-section").isVisible(), false, "it goes with its record");
  assert.deepEqual(await drawn(tab), []);
  await tab.end();
});

for (const [width, height] of [[390, 844], [820, 1180], [1280, 800]])
  for (const theme of ["light", "dark"])
    test(`passes, ${width} by ${height}, ${theme}: nothing is wider than the window or cut off`, { skip }, async () => {
      const tab = await open({ width, height, theme });
      await shown(tab);
      assert.ok((await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
      const cut = await tab.evaluate(() => [...document.querySelectorAll("#passes-section, #passes, #passes-said, #force-marks, .numbers > div")].filter((e) => e.scrollWidth > e.clientWidth + 1 || e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => e.id || e.textContent));
      assert.deepEqual(cut, []);
      await tab.end();
    });
