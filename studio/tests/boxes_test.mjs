// Boxes take what the program takes, by its own parser, kind included; what is wrong stands at the box, and goes when it is right.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, drop, fitted, missing, open, painted, program, RIG, root, say } from "./browser.mjs";

const skip = missing || false;
after(close);
const bytes = readFileSync(join(root, "examples/simulated/test.csv"));
const shown = (tab) => tab.waitForFunction(() => document.querySelector("#tests li[aria-selected=true] b")?.textContent === "mine");
const mine = { name: "mine.csv", bytes: Buffer.from(bytes.toString("utf8").replace("stage [um]", "crosshead [um]")) };
const wrongAt = (tab, box) => tab.locator(`#card [aria-label="${box}"] + .wrong`);

test("a quantity of another kind is refused at its box, which keeps it; mended, the message goes", { skip }, async () => {
  const tab = await open();
  await drop(tab, mine);
  await shown(tab);
  for (const [box, wrong, right] of [["span", "1278 N", "1278 um"], ["load train", "90.65 GPa", "90.65 N/m"], ["diameter", "34.8", "34.8 um"], ["modulus", "30 mm", "30 GPa"], ["span", "-3 mm", "1.278 mm"], ["span", "inf", "1278 um"]]) {
    const at = tab.locator(`#card [aria-label="${box}"]`);
    await at.fill(wrong);
    await at.press("Enter");
    await painted(tab);
    assert.equal(await at.inputValue(), wrong, "what was written stays to be mended");
    assert.ok((await wrongAt(tab, box).innerText()).length > 10, `${box}: ${wrong}`);
    assert.doesNotMatch(await wrongAt(tab, box).innerText(), /--[a-z]/);
    assert.doesNotMatch(await tab.locator("#command").innerText(), new RegExp(wrong.replace(/[-.]/g, "\\$&")), "it is not taken");
    await at.fill(right);
    await painted(tab);
    assert.equal(await wrongAt(tab, box).isVisible(), false, `${box}: the message goes as it is mended`);
    await at.press("Enter");
    await painted(tab);
    assert.equal(await wrongAt(tab, box).isVisible(), false, box);
  }
  assert.match(await tab.locator("#card [aria-label=modulus]").getAttribute("placeholder"), /^e\.g\. /, "an example reads as one");
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("every box takes what the program takes: units of all kinds, and what is none", { skip }, async () => {
  const tab = await open(), folder = mkdtempSync(join(tmpdir(), "studio-boxes-"));
  try {
    writeFileSync(join(folder, "few.csv"), "crosshead [um],force [mN]\n0,0\n1,1\n");
    await drop(tab, mine);
    await shown(tab);
    const values = ["12 um", "12 µm", "12 μm", "0.5 in", "3 mil", "12 micron", "12 N/m", "12 N/mm", "12 mN/um", "12 lbf/in", "12 kgf/mm", "12 GPa", "12 ksi", "12 Msi", "12 N/mm^2", "12 N/mm²", "12 N m^2", "12 s", "12 deg", "12", "1,5 mm", "1.5mm", "1e-3 m", ".5 mm", "+2 mm", "0 mm", "-1 mm", "inf", "Inf", "nan mm", "12 mmm", "12 KN", "12 mm mm", "mm", "", "12 furlongs", "1e99 m", "12 M", "12 %", "12 um ± 1 um", "12 N/m +- 2 %", "12 GPa ± 3 GPa", "12 um ± 1 N", "12 N/m ±", "12 N/m ± 1"];
    const boxes = { span: "span", diameter: "diameter", "load train": "stiffness", modulus: "modulus" };
    for (const [box, flag] of Object.entries(boxes))
      for (const words of values.filter((each) => each !== "")) {
        let natively = "";
        try {
          execFileSync(program, ["fit", "few.csv", "--span", "1278 um", "--stiffness", "90 N/m", "--diameter", "30 um"].map((word, i, all) => (all[i - 1] === `--${flag}` ? words : word)).concat(flag === "modulus" ? ["--modulus", words] : []), { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
        } catch (cause) {
          natively = cause.stderr;
        }
        const at = tab.locator(`#card [aria-label="${box}"]`);
        await at.fill("");
        await at.fill(words);
        await at.press("Enter");
        await painted(tab);
        assert.equal(await wrongAt(tab, box).isVisible(), new RegExp(`--${flag}|\\] ${flag}\\.`).test(natively) && !natively.includes("thinner than"), `${box}: ${words}: ${natively}`);
      }
    assert.deepEqual(tab.said, []);
  } finally {
    rmSync(folder, { recursive: true });
  }
  await tab.end();
});

test("several files: what one is told of the rig the others are told; Fit all, the table, away and back", { skip }, async () => {
  const tab = await open(), names = ["a.csv", "b.csv", "c.csv"];
  const shorter = { bytes: mine.bytes.subarray(0, mine.bytes.lastIndexOf("\n", mine.bytes.length - 2) + 1) };
  await drop(tab, ...names.map((name) => ({ ...mine, ...(name === "c.csv" ? shorter : {}), name })));
  await tab.waitForFunction(() => document.querySelectorAll("#tests li").length === 4);
  assert.match(await tab.locator("#error").innerText(), /^3 files do not say the support span and the stiffness of the load train\. Enter them in the boxes of one of them, once for all, then press Fit all\./);
  await say(tab, RIG);
  const at = (box) => tab.locator(`#card [aria-label="${box}"]`), show = async (name) => {
    await tab.locator("#tests li").nth(1 + names.indexOf(name)).click();
    await painted(tab);
  };
  await show("a.csv");
  assert.equal(await at("span").inputValue(), "1278 µm", "the rig is that of all");
  assert.equal(await at("diameter").inputValue(), "", "a specimen is that of its file");
  for (const [span, ofTheOthers] of [["1.3 mm", "1278 µm"], ["1278 um", "1278 µm"]]) {
    await show("a.csv");
    await at("span").fill(span);
    await at("span").press("Enter");
    for (const other of ["b.csv", "c.csv"]) {
      await show(other);
      assert.equal(await at("span").inputValue(), ofTheOthers, "what was said of one is not said over by another");
    }
  }
  await tab.locator("#fit-all").click();
  await tab.waitForFunction(() => [...document.querySelectorAll("#tests .badge")].every((badge) => /of 3\d/.test(badge.textContent)));
  await tab.locator("#table-of-tests").click();
  assert.equal(await tab.locator("[role=dialog] tbody tr").count(), 4);
  const saved = tab.waitForEvent("download");
  await tab.getByText("Save as CSV").click();
  const table = readFileSync(await (await saved).path(), "utf8").trim().split("\n");
  assert.deepEqual(table.slice(1).map((line) => line.split(",").slice(0, 3).join()), ["a,ok,SLIP", "c,ok,SLIP", "simulated,ok,SLIP"]);
  assert.match(await tab.locator("[role=dialog] [role=status]").innerText(), /'b' is omitted: its record is identical to the record of 'a'/);
  await tab.keyboard.press("Escape");
  await tab.locator("#tests li").nth(1).hover();
  await tab.locator("#tests li").nth(1).locator(".away").click();
  await painted(tab);
  assert.deepEqual(await tab.locator("#tests b").allInnerTexts(), ["simulated", "b", "c"]);
  await tab.keyboard.press("Control+z");
  await painted(tab);
  assert.deepEqual(await tab.locator("#tests b").allInnerTexts(), ["simulated", "a", "b", "c"]);
  await tab.keyboard.press("Control+Shift+z");
  await painted(tab);
  assert.deepEqual(await tab.locator("#tests b").allInnerTexts(), ["simulated", "b", "c"]);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("while one is fitted another is read and seen, waits, and a slider of a third cancels neither", { skip }, async () => {
  const tab = await open();
  await drop(tab, mine);
  await shown(tab);
  await say(tab, RIG);
  await tab.locator("#fit").click();
  await drop(tab, { ...mine, name: "later.csv" });
  await tab.waitForFunction(() => document.querySelectorAll("#tests li").length === 3);
  await tab.locator("#tests li").first().click();
  const slider = tab.locator(".parameter[data-parameter=mu0] input[type=range]");
  await slider.focus();
  await slider.press("ArrowRight");
  await tab.waitForFunction(() => /of 3\d/.test(document.querySelectorAll("#tests .badge")[1].textContent));
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("leaving with files that were not taken out asks", { skip }, async () => {
  const tab = await open(), asked = [];
  await drop(tab, mine);
  await shown(tab);
  await say(tab, RIG);
  tab.removeAllListeners("dialog");
  tab.on("dialog", (dialog) => asked.push(dialog.type()) && dialog.accept());
  await tab.close({ runBeforeUnload: true });
  await new Promise((done) => setTimeout(done, 1000));
  assert.deepEqual(asked, ["beforeunload"]);
  await tab.end();
});
