// No answer is an answer: of each status and each verdict the page shows the program's own sentence and the data, and goes on working.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, drop, exported, fitted, missing, native, open, painted, RIG, root, say } from "./browser.mjs";

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

test("each status and each verdict: the program's lines and no others, its data, and Fit ready; the test before stands as it was", { skip }, async () => {
  for (const [i, [what, bytes, rig, status, verdict]] of ANSWERS.entries()) {
    const tab = await open(), name = `record ${i}`, before = await tab.locator("#verdict h1").innerText();  // a second file would take the rig of the first
    await drop(tab, { name: `${name}.csv`, bytes });
    await tab.waitForFunction((n) => document.querySelector("#tests .selected b")?.textContent === n, name);
    assert.ok(await drawn(tab), `${what}: its data are drawn before the fit`);
    await say(tab, rig);
    await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit" && !/^(Fitting|Waits)/.test(document.querySelector("#verdict h1").textContent));
    await painted(tab);
    const args = ["fit", `${name}.csv`, "--span", rig.span, "--diameter", rig.diameter, "--stiffness", rig["load train"], ...(rig.modulus ? ["--modulus", rig.modulus] : []), "--json"];
    let told;
    try {
      told = JSON.parse(native(args, { [`${name}.csv`]: bytes }).out);
    } catch (cause) {
      told = cause.stdout?.startsWith("{") ? JSON.parse(cause.stdout) : cause.stderr;
    }
    assert.ok(await drawn(tab), `${what}: its data are drawn`);
    const words = await tab.locator("#verdict").innerText();
    assert.doesNotMatch(words, /--[a-z]/, what);
    if (status === null) {
      assert.equal(typeof told, "string", what);
      const sentence = told.trim().split("\n").pop().replace(/^flexslip: /, "").replace(/^--[a-z]+: /, "");
      assert.ok(words.includes(sentence.slice(0, 60)), `${what}: ${words} says ${sentence}`);
    } else {
      assert.equal(told.status, status, what);
      assert.equal(told.verdict.code, verdict, what);
      assert.equal(await tab.locator("#verdict h1").innerText(), told.verdict.sentence, what);
      const lines = Object.fromEntries(told.answer.map((line) => [line.label, line.words])), withdrawn = verdict === "check_input" || verdict === "no_answer", friction = !withdrawn && /^[^n]/.test(lines.friction ?? "none");
      const labels = await tab.locator("#verdict .lines:not([hidden])").first().locator("dt").allInnerTexts();
      if (withdrawn) assert.deepEqual(labels, ["next"], `${what}: what to correct and nothing else`);
      else assert.deepEqual(labels.slice(0, 2), told.answer.slice(0, 2).map(({ label }) => label), what);
      assert.equal(await tab.locator("#request dd").count() > 0, withdrawn, `${what}: its inputs stand below`);
      for (const part of ["#right", "#friction-view", "#fibre-view"]) assert.equal(await tab.locator(part).isVisible(), friction, `${what}: ${part}`);
      assert.equal(await tab.locator("#moment").isVisible(), !withdrawn, `${what}: the moment`);
    }
    assert.deepEqual(tab.said, [], what);
    assert.equal(await tab.locator("#error").isVisible(), false, `${what}: ${await tab.locator("#error").textContent()}`);
    // What the test before showed it shows again.
    await tab.locator("#tests .test").first().click();
    await painted(tab);
    assert.equal(await tab.locator("#verdict h1").innerText(), before, `after ${what}`);
    await tab.end();
  }
});

test("all lines unfold: those of the program's full answer, in its order, the checks and the findings", { skip }, async () => {
  const tab = await open(), told = JSON.parse(native(["fit", "simulated.toml", "--json"], { "simulated.toml": readFileSync(join(root, "examples/simulated/case.toml")), "test.csv": readFileSync(join(root, "examples/simulated/test.csv")) }).out);
  await tab.locator("#verdict summary").click();
  const lines = tab.locator("#verdict details .lines"), labels = await lines.locator("dt").allInnerTexts(), words = await lines.locator("dd").allInnerTexts();
  assert.deepEqual(labels, [...told.answer.map(({ label }) => label), "next"]);
  assert.deepEqual(words, [...told.answer.map((line) => line.words), told.next]);
  assert.match(await tab.locator("#verdict details").innerText(), /All \d checks .*passed\. ± is one standard error\.\s/);
  assert.deepEqual(await tab.locator("#verdict details li").allInnerTexts(), told.findings.map(({ sentence, remedy }) => [sentence, remedy === told.next ? "" : remedy].filter(Boolean).join(" ")), "what to do next is said once");
  assert.equal(await tab.locator("#verdict .lines").first().isVisible(), false, "each line once");
  await tab.end();
});

test("a file with a stage and a deflection: the columns are what the program says it took", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "both.csv", bytes: csv(sample.map(([w, F]) => [w, (w - 11.03 * F).toFixed(6), F]), "crosshead [um],deflection [um],force [mN]") });
  await say(tab, RIG);
  await fitted(tab);
  await painted(tab);
  const card = await tab.locator("#card").evaluate((e) => [...e.querySelectorAll("dt")].map((dt) => dt.textContent));
  assert.deepEqual(card.slice(0, 3), ["crosshead", "deflection", "force"]);
  assert.doesNotMatch(await tab.locator("#card").textContent(), /less F\/k/);
  assert.match(await tab.locator("#card details").last().textContent(), /the column 'deflection', of the specimen's midpoint, as the file says/);
  await tab.end();
});

test("a title without a unit: the file is in the list, the questions are asked one by one, and its report has its name", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "none.csv", bytes: csv(sample, "crosshead,force") });
  await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "none");
  await tab.locator("#request .ask input").waitFor();
  assert.match(await tab.locator("#verdict").innerText(), /4 questions are open\s+What is the unit of 'crosshead'\?/);
  assert.equal(await tab.locator("#force-unit").textContent(), "", "no unit where the file has none");
  assert.doesNotMatch(await tab.locator("#force-plot").textContent(), /[µm]m|mN/);
  await say(tab, { "displacement unit": "um", "force unit": "mN", ...RIG });
  await fitted(tab);
  await tab.waitForFunction(() => document.querySelector("#what").textContent.includes("of 426"));
  assert.ok(await drawn(tab));
  assert.match(await tab.locator("#verdict h1").innerText(), /^SLIP/);
  const { "none-report.html": report } = await exported(tab, "Report");
  assert.match(String(report), /<title>none\b(?!\.)[^]*<h1[^>]*>none\b(?!\.)/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("a unit that is wrong in a title: the file is in the list, it is said what is wrong, and nothing of a shell", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "wrong.csv", bytes: csv(sample, "crosshead [um],force [mm]") });
  await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "wrong");
  await tab.locator("#request .ask button").first().waitFor();
  assert.match(await tab.locator("#verdict h1").innerText(), /^Which column is the force\?/);
  await tab.locator("#request").getByText("force, in mm").click();
  await tab.waitForFunction(() => /'force' .*'?mm'?/.test(document.querySelector("#verdict").innerText));
  assert.doesNotMatch(await tab.locator("#verdict").innerText(), /--[a-z]/);
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
  const told = JSON.parse(native(["fit", "case.toml", "--json"], { "case.toml": readFileSync(join(folder, "case.toml")), "test.csv": readFileSync(join(folder, "test.csv")) }).out);
  assert.match(await tab.locator("#verdict h1").innerText(), /^CRACK\. The specimen cracked or settled; its 8 force drops/);
  assert.equal((await tab.locator("#tests .selected .test").innerText()).replace(/\s+/g, " ").trim(), `test CRACK ${told.answer.find((line) => line.label === "friction").words}`);
  assert.match(await tab.locator("#verdict .lines").first().innerText(), /EI 2\.131 ± 0\.064 mN mm² \(stated\)/);
  for (const part of ["#right", "#friction-view", "#fibre-view"]) assert.equal(await tab.locator(part).isVisible(), false, part);
  assert.equal(await tab.locator("#force-plot path[stroke='var(--model)']").count(), 0, "no model");
  assert.equal(await tab.locator("#force-plot path[fill='var(--bad)'], #force-plot [fill='var(--bad)']").count() > 0, true, "drops that no slip explains are marked");
  await tab.keyboard.press("?");
  await tab.getByText("Show the first steps").click();
  await painted(tab);
  await tab.locator("#tour [data-next]").click();
  await painted(tab);
  assert.match(await tab.locator("#tour").innerText(), /no slip explains: here 3 of 8/, "the steps follow the verdict");
  assert.deepEqual(tab.said, []);
  await tab.end();
});
