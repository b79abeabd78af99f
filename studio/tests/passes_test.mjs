// A record that was unloaded and loaded again: all its passes in the one figure of force, and the program's line of the reload.
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

test("one loading: data, model and drops as ever", { skip }, async () => {
  const tab = await open();
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
      const cut = await tab.evaluate(() => [...document.querySelectorAll("#force-marks, #verdict, #moment, .parameter")].filter((e) => e.scrollWidth > e.clientWidth + 1 || e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => e.id || e.textContent));
      assert.deepEqual(cut, []);
      await tab.end();
    });
