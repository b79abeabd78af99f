// One answer through all doors: of each record of tests/outside/doors.json the page says what the same program's JSON says. python/tests/doors.py holds
// the screen, Python, the report and a campaign against that JSON.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { spawnSync } from "node:child_process";
import { after, test } from "node:test";
import { close, drop, exported, fitted, missing, native, open, painted, program, root, say } from "./browser.mjs";

const skip = missing || false;
after(close);
const records = JSON.parse(readFileSync(join(root, "tests/outside/doors.json"), "utf8"));
const TITLES = { crosshead: "crosshead [um]", time: "time [s]", force: "force [mN]" };  // the crosshead moves by 1 µm in each second
const BOX = { stiffness: "load train" };  // a flag by another name

/** The file of a record, as a user would have it. */
function fileOf({ name, simulated, readings, rows, columns, workbook }) {
  if (workbook) return { name: `${name}.xlsx`, bytes: readFileSync(join(root, workbook)) };
  if (simulated) return { name: `${name}.csv`, bytes: Buffer.from(native(["simulate", "truth.toml", "--noise", "10 uN"], { "truth.toml": simulated.join("\n") }).out) };
  const [, ...lines] = readFileSync(join(root, readings), "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
  return { name: `${name}.csv`, bytes: Buffer.from([columns.map((column) => TITLES[column]).join(","), ...lines.slice(0, rows), ""].join("\n")) };
}
function answerOf(file, stated) {
  const folder = mkdtempSync(join(tmpdir(), "studio-test-"));
  writeFileSync(join(folder, file.name), file.bytes);
  const { stdout } = spawnSync(program, ["fit", file.name, ...Object.entries(stated).flatMap(([flag, value]) => [`--${flag}`, value]), "--json", "--quiet"], { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  rmSync(folder, { recursive: true });
  return JSON.parse(stdout);
}
/** States the rig and specimen: the supports in the card, then what its other boxes hold, then what the program asks. */
async function state(tab, { supports, ...stated }) {
  await tab.locator("#request .ask input").waitFor();
  if (supports) await tab.locator('#card [aria-label="supports"]').selectOption(supports);
  await say(tab, Object.fromEntries(Object.entries(stated).map(([flag, value]) => [BOX[flag] ?? flag, value])));
  await fitted(tab);
  await painted(tab);
}
/** What is said in flags to who has a shell is said in boxes here. */
const withoutFlags = (sentence) => sentence.replace(/\b(pass|enter|add) /gi, "").replace(/“([a-z ]+)”/g, "…").replace(/--[a-z-]*[a-z]/g, "…").replace(/: (?=edges|rollers|find|fit|crosshead|deflection)/g, " ");
const inWords = ({ sentence, remedy }) => [sentence, remedy].filter(Boolean).join(" ");
const probability = (share) => (share < 0.01 ? "below 1 %" : share > 0.99 ? "above 99 %" : `${(100 * share).toFixed(0)} %`);
const texts = (locator) => locator.evaluateAll((all) => all.map((each) => each.textContent));

for (const record of records)
  test(`${record.name}: the page says what the JSON says`, { skip }, async () => {
    const { stiffness, ...others } = record.stated, stated = record.simulated ? others : record.stated;  // a simulated file has stage and deflection
    const file = fileOf(record), told = answerOf(file, stated), tab = await open();
    assert.equal(told.verdict.code, record.verdict, told.verdict.sentence);
    await drop(tab, file);
    await tab.waitForFunction((name) => document.querySelector("#tests .selected b")?.textContent === name, record.name);
    await tab.locator("#force-plot path[stroke='var(--data)']").first().waitFor({ state: "attached" });  // before it is fitted, too
    await state(tab, stated);
    assert.equal(await tab.locator("#verdict h1").innerText(), told.verdict.sentence);
    const word = told.verdict.sentence.split(". ")[0], friction = told.answer.find(({ label }) => label === "friction")?.words ?? "";
    assert.deepEqual(await texts(tab.locator("#tests .selected :is(.badge, .note)")), [word, friction]);
    const isWithdrawn = record.verdict === "check_input";
    const last = [...told.doubts.map((doubt) => [doubt.severity, inWords(doubt)]), ...(told.next ? [["next", told.next]] : [])];
    const list = tab.locator(`#verdict ${isWithdrawn ? "" : "details "}.lines`).first(), labels = await texts(list.locator("dt")), words = await texts(list.locator("dd"));
    assert.deepEqual(labels, isWithdrawn ? ["next"] : [...told.answer.map(({ label }) => label), ...last.map(([label]) => label)]);
    const said = isWithdrawn ? [told.next] : [...told.answer.map((row) => row.words), ...last.map(([, each]) => each)];
    said.forEach((sentence, i) => assert.equal(withoutFlags(words[i]), withoutFlags(sentence), labels[i]));
    if (!isWithdrawn) assert.ok((await tab.locator("#verdict details").textContent()).includes(`${told.checks} ± is one standard error.`.trim()));
    // What it depends on, to the digits of the page.
    const hangs = await texts(tab.locator("#hangs .hang")), signed = (value) => `${value < 0 ? "−" : "+"}${Math.abs(value).toFixed(3)}`;
    const depends = friction && !friction.startsWith("none") && !isWithdrawn ? told.sensitivities.filter((each) => Math.abs(each.friction_moves) >= 0.0005) : [];
    assert.deepEqual(hangs, depends.map((each) => `${each.title} ${signed(each.friction_moves)}`));
    // The passes.
    const { passes } = told, there = passes?.status === "ok" && !isWithdrawn;
    assert.equal(await tab.locator("#passes-section").isVisible(), there);
    if (there) {
      const { causes } = told.judgement, shown = await texts(tab.locator(".causes b"));
      assert.deepEqual(shown, causes.both === null ? [] : [causes.slips, causes.both, causes.cracks].map(probability));
      assert.equal(await tab.locator("#passes tbody tr").count(), passes.passes.length);
      for (const [i, pass] of passes.passes.entries()) {
        const cells = await texts(tab.locator("#passes tbody tr").nth(i).locator("td"));
        assert.equal(cells[0], pass.rows.join("–"));
        if (!pass.friction) continue;
        const [value, error] = cells[1].split(" ± ").map(Number);
        assert.ok(Math.abs(value - pass.friction.value) < 0.051 * pass.friction.standard_error && Math.abs(error / pass.friction.standard_error - 1) < 0.051, cells[1]);
      }
      assert.ok((await tab.locator("#boxes-plot path").count()) >= passes.passes.length);
    }
    // What is exported is what is shown.
    const json = JSON.parse(Object.values(await exported(tab, "All results"))[0]);
    for (const part of ["verdict", "parameters", "doubts", "checks", "sensitivities", "judgement"]) assert.deepEqual(json[part], told[part], part);
    assert.deepEqual(tab.said, []);
    await tab.end();
  });
