// The page's words are the program's: fed every finding there is (tests/outside/golden/findings.json, which tests/finding/answer_test.cpp writes), the
// page shows its very strings. Needs no browser: what the page shows of a fit is made by answer.ts.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { program, root } from "./browser.mjs";

const modules = join(root, "studio/page/package.json");
const skip = !existsSync(join(root, "studio/page/node_modules")) ? "the page's modules are not there: npm install in studio/page" : !existsSync(program) ? `there is no program ${program}` : false;

async function pageWords(source = "answer.ts") {
  const { buildSync } = createRequire(modules)("esbuild");
  const bundle = buildSync({ entryPoints: [join(root, "studio/page/src", source)], bundle: true, write: false, format: "esm", charset: "utf8" });
  return import(`data:text/javascript;base64,${Buffer.from(bundle.outputFiles[0].text).toString("base64")}`);
}
const noCase = { secondMoment: null, quantity: () => null };
const fitOf = (name) => JSON.parse(execFileSync(program, ["fit", join(root, "examples", name, "case.toml"), "--json"], { maxBuffer: 1e8 }));

test("every finding: the verdict, the sentence, its remedy and the next step stand on the page as the program says them", { skip }, async () => {
  const { answerOf } = await pageWords();
  const fit = fitOf("simulated"), situations = JSON.parse(readFileSync(join(root, "tests/outside/golden/findings.json"), "utf8"));
  assert.ok(situations.length >= 28, "the program knows that many findings");
  for (const { found, verdict, answer: rows, findings, next } of situations) {
    const answer = answerOf({ ...fit, verdict, findings, next }, noCase);
    assert.equal([answer.verdict, answer.rest].filter(Boolean).join(". "), verdict.sentence, found);
    assert.equal(answer.next, next, found);
    const judged = findings.filter((finding) => finding.severity !== "note" && finding.severity !== "condition");
    assert.deepEqual(answer.checks.map((check) => check.words), judged.map((finding) => finding.short_form || finding.sentence), found);
    assert.deepEqual(answer.checks.map((check) => check.reason), judged.map((finding) => [finding.sentence, finding.remedy].filter(Boolean).join(" ")), found);
    const tells = !["check_input", "no_answer"].includes(verdict.code) && !rows.some(({ label, words }) => label === "friction" && words.startsWith("none: friction"));
    assert.equal(/\d/.test(answer.numbers[0].value), tells, `${found}: friction is told where the verdict tells it`);
  }
});

test("every drop says what the program reads from it", { skip }, async () => {
  const { dropInWords } = await pageWords();
  for (const name of ["simulated", "cracked", "cyclic"])
    fitOf(name).drops.forEach((drop, i) => assert.equal(dropInWords(drop, i + 1).claim, `Drop ${i + 1}: ${drop.reading}`));
});

test("of a case with three faults each is said, by its line, and the file once", { skip }, async () => {
  const { sentence } = await pageWords("answers.ts"), { inPageWords } = await pageWords("words.ts"), cwd = mkdtempSync(join(tmpdir(), "flexslip-"));
  writeFileSync(join(cwd, "case.toml"), '[specimen]\ndiameter = "34 kg"\n[rig]\nspan = "5 N"\nspam = 3\n');
  const { stderr } = spawnSync(program, ["fit", "case.toml"], { cwd, encoding: "utf8" });
  rmSync(cwd, { recursive: true });
  const words = inPageWords(sentence(stderr), { isCase: true, name: "bar", data: "test.csv", main: "case.toml", plainName: "" });
  for (const fault of ["line 2: [specimen] diameter", "line 4: [rig] span", "line 5: [rig] spam"]) assert.ok(words.includes(fault), `${words} says ${fault}`);
  assert.ok(words.startsWith("bar: ") && !words.includes("case.toml"), words);
});

test("what a data file does not say is asked for by boxes: units, a radius; no key of a case, no flag", { skip }, async () => {
  const { sentence } = await pageWords("answers.ts"), { inPageWords } = await pageWords("words.ts"), cwd = mkdtempSync(join(tmpdir(), "flexslip-"));
  const rows = Array.from({ length: 40 }, (_, i) => `${i},${0.02 * i}`).join("\n"), file = { isCase: false, name: "run", data: "run.csv", main: "run.csv", plainName: "run.plain" };
  const askedBy = (titles, ...flags) => {
    writeFileSync(join(cwd, "run.csv"), `${titles}\n${rows}\n`);
    return inPageWords(sentence(spawnSync(program, ["fit", "run.csv", ...flags], { cwd, encoding: "utf8" }).stderr), file);
  };
  const units = askedBy("Position,Load"), radius = askedBy("stage [um],force [mN]", "--span", "1278 um", "--stiffness", "90 N/m", "--supports", "rollers");
  rmSync(cwd, { recursive: true });
  assert.ok(units.includes("“stage unit”: mm") && units.includes("“force unit”: N") && units.includes("“moves”"), units);
  assert.match(radius, /“radius”/);
  for (const words of [units, radius]) assert.doesNotMatch(words, /--[a-z]|\[[a-z]+\] /, words);
});
