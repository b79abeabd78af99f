// No answer is an answer: of each status and each verdict the page shows the program's own sentence and the data, and goes on working.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, drop, errorOf, exported, fitted, missing, native, open, painted, RIG, root, say } from "./browser.mjs";

const skip = missing || false;
after(close);
const sample = readFileSync(join(root, "examples/simulated/test.csv"), "utf8").trim().split("\n").filter((line) => !line.startsWith("#")).slice(1).map((line) => line.split(",").map(Number));
const csv = (rows, head = "crosshead [um],force [mN]") => Buffer.from(`${head}\n${rows.map((row) => row.join(",")).join("\n")}\n`);
const soft = { ...RIG, modulus: "29.6 GPa" };

/** [what, data, rig, status, verdict]: of the program, which each row asks natively too; a status of null is a sentence in place of an answer. */
const ANSWERS = [
  ["drops that slips explain", csv(sample), RIG, "ok", "slip"],
  ["a span in the wrong unit", csv(sample), { ...RIG, span: "1278 mm" }, "too_few_points", "check_input"],
  ["a load train that was not that stiff", csv(sample), { ...RIG, "load train": "5 kN/m" }, "ok", "slip"],
  ["a load train that is stated rigid", csv(sample), { ...RIG, "load train": "inf" }, "ok", "slip"],
  ["a load train that would have given way", csv(sample), { ...RIG, "load train": "0.001 N/m" }, null, ""],
  ["no initial slope", csv(sample.map(([w]) => [w, 3])), RIG, null, ""],
  ["few rows", csv(sample.slice(0, 8)), RIG, null, ""],
  ["a force of zero", csv(sample.map(([w]) => [w, 0])), soft, "too_few_points", "check_input"],
  ["a force that friction does not explain", csv(sample.map(([w, F]) => [1.9 * w, F])), RIG, "not_explained", "undecided"],
  ["an untrusted fit", csv(sample.map(([w]) => [w, 3])), soft, "ok", "check_input"],
  ["a suspect fit", csv(sample.map(([w]) => [w, 12 * (w / 800) ** 3])), RIG, "ok", "no_drops"],
  ["too little bent, without drops", csv(sample.slice(0, 60)), RIG, "too_few_points", "no_drops"],
  ["two drops, too few to decide", csv(sample.slice(0, 200)), RIG, "ok", "undecided"],
  ["smooth", csv(sample.slice(0, 140)), RIG, "ok", "no_drops"],
];

/** Whether data are drawn in the plot of the force. */
const drawn = (tab) => tab.evaluate(() => [...document.querySelectorAll("#force-plot path")].some((path) => path.getAttribute("stroke") === "var(--data)" && path.getAttribute("d").length > 40));

test("each status and each verdict: its sentence, its data, and Fit ready; the test before stands as it was", { skip }, async () => {
  const tab = await open();
  const before = await tab.locator("#answer h1").innerText();
  for (const [i, [what, bytes, rig, status, verdict]] of ANSWERS.entries()) {
    const name = `record ${i}`;
    await drop(tab, { name: `${name}.csv`, bytes });
    await tab.waitForFunction((n) => document.querySelector("#tests li[aria-selected=true] b")?.textContent === n, name);
    assert.ok(await drawn(tab), `${what}: its data are drawn before the fit`);
    await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit");
    await tab.keyboard.press("Escape");
    await say(tab, rig);
    await tab.locator("#fit").click();
    await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit" && !/Fitting|Waits/.test(document.querySelector("#answer h1").textContent));
    await painted(tab);
    const args = ["fit", `${name}.csv`, "--span", rig.span, "--diameter", rig.diameter, "--stiffness", rig["load train"], ...(rig.modulus ? ["--modulus", rig.modulus] : []), "--json"];
    let told;
    try {
      told = JSON.parse(native(args, { [`${name}.csv`]: bytes }).out);
    } catch (cause) {
      told = cause.stdout?.startsWith("{") ? JSON.parse(cause.stdout) : cause.stderr;
    }
    assert.ok(await drawn(tab), `${what}: its data are drawn`);
    if (status === null) {
      assert.equal(typeof told, "string", what);
      const words = await tab.locator("#answer").innerText(), sentence = told.trim().split("\n").pop().replace(/^flexslip: /, "").replace(`${name}.csv: `, "").replace(/^--[a-z]+: /, "");
      assert.ok(words.includes(sentence.slice(0, 60)), `${what}: ${words} says ${sentence}`);
      assert.doesNotMatch(words, /--[a-z]/, what);
    } else {
      assert.equal(told.status, status, what);
      assert.equal(told.verdict.code, verdict, what);
      // On a fast machine the answer before still stands when the click returns.
      await tab.waitForFunction((sentence) => document.querySelector("#answer h1").innerText === sentence, told.verdict.sentence, { timeout: 10000 }).catch(() => {});
      assert.equal(await tab.locator("#answer h1").innerText(), told.verdict.sentence, what);
      const friction = await tab.locator(".numbers .value").first().innerText();
      assert.equal(/\d/.test(friction), told.parameters.mu0 !== undefined && !["crack", "check_input", "no_answer"].includes(verdict), `${what}: ${friction}`);
      assert.equal(/\d/.test(await tab.locator(".numbers .value").nth(1).innerText()), told.answer.some((line) => line.label === "work"), `${what}: the work`);
    }
    assert.deepEqual(tab.said, [], what);
    assert.equal(await tab.locator("#error").isVisible(), status === null, `${what}: ${await tab.locator("#error").textContent()}`);
    // What the test before showed it shows again.
    await tab.keyboard.press("Escape");
    await tab.locator("#tests li").first().click();
    await painted(tab);
    assert.equal(await tab.locator("#answer h1").innerText(), before, `after ${what}`);
  }
  await tab.end();
});

test("a title without a unit: the file is in the list, the boxes that are asked for read it, and its report has its name", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "none.csv", bytes: csv(sample, "crosshead,force") });
  await tab.waitForFunction(() => document.querySelector("#tests li[aria-selected=true] b")?.textContent === "none");
  assert.match(await errorOf(tab), /does not say the unit of its displacement, the unit of its force, the support span/);
  for (const [box, words] of Object.entries({ "stage unit": "um", "force unit": "mN" })) {
    await tab.locator(`#card [aria-label="${box}"]`).fill(words);
    await tab.locator(`#card [aria-label="${box}"]`).press("Enter");
    await tab.waitForFunction((name) => document.querySelector(`#card [aria-label="${name}"]`)?.classList.contains("yours"), box);
  }
  await tab.waitForFunction(() => document.querySelector("#what").textContent.includes("426 rows"));
  await painted(tab);
  assert.ok(await drawn(tab));
  await say(tab, RIG);
  await tab.locator("#fit").click();
  await fitted(tab);
  assert.match(await tab.locator("#answer h1").innerText(), /^SLIP/);
  const { "none-report.html": report } = await exported(tab, "Report");
  assert.match(String(report), /<title>none\b(?!\.)[^]*<h1[^>]*>none\b(?!\.)/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("a unit that is wrong in a title: the file is in the list, it is said what is wrong, and nothing of a shell", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "wrong.csv", bytes: csv(sample, "crosshead [um],force [mm]") });
  await tab.waitForFunction(() => document.querySelector("#tests li[aria-selected=true] b")?.textContent === "wrong");
  assert.match(await errorOf(tab), /does not say which column is the force/);
  await tab.locator("#card select[aria-label=force]").selectOption({ label: "force, in mm" });
  await tab.waitForFunction(() => document.querySelector("#answer").innerText.includes("The column"));
  const words = await tab.locator("#answer").innerText();
  assert.match(words, /The column 'force' is in 'mm', not in a unit of force/);
  assert.doesNotMatch(words, /--[a-z]/);
  assert.equal(await tab.locator("#fit").innerText(), "Fit");
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("the cracked example: CRACK, three drops marked as none, and no friction, spacing or share of the work", { skip }, async () => {
  const tab = await open(), folder = join(root, "examples/cracked");
  await drop(tab, join(folder, "case.toml"), join(folder, "test.csv"));
  await tab.waitForFunction(() => document.querySelectorAll("#tests li").length === 2);
  await fitted(tab);
  await painted(tab);
  assert.match(await tab.locator("#answer h1").innerText(), /^CRACK\. The specimen cracked or settled; its 8 force drops/);
  assert.equal((await tab.locator("#tests li[aria-selected=true]").innerText()).replace(/\s+/g, " ").trim().replace(/ ×$/, ""), "test crack");
  for (const i of [0, 1, 2]) assert.doesNotMatch(await tab.locator(".numbers .value").nth(i).innerText(), /\d/, `number ${i}`);
  assert.doesNotMatch(await tab.locator("#friction-plot").innerText(), /slips|mean/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});
