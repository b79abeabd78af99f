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
const fitOf = (name) => JSON.parse(execFileSync(program, ["fit", join(root, "examples", name, "case.toml"), "--json"], { maxBuffer: 1e8 }));

test("every answer: friction is shown where the program's own line has it, and of no answer only what to correct", { skip }, async () => {
  const { isWithdrawn, tellsFriction } = await pageWords();
  const situations = JSON.parse(readFileSync(join(root, "tests/outside/golden/findings.json"), "utf8"));
  assert.ok(situations.length >= 28, "the program knows that many findings");
  for (const { found, verdict, answer } of situations) {
    const withdrawn = ["check_input", "no_answer"].includes(verdict.code), friction = answer.find(({ label }) => label === "friction")?.words ?? "none";
    assert.equal(isWithdrawn({ verdict }), withdrawn, found);
    assert.equal(tellsFriction({ verdict, answer }), !withdrawn && /\d/.test(friction), `${found}: ${friction}`);
  }
});

test("every drop says what the program reads from it", { skip }, async () => {
  const { dropInWords } = await pageWords();
  for (const name of ["simulated", "cracked", "cyclic"])
    fitOf(name).drops.forEach((drop, i) => assert.equal(dropInWords(drop, i + 1).claim, `Drop ${i + 1}: ${drop.reading}`));
});

test("of a case with three faults each is said, word for word", { skip }, async () => {
  const { sentence } = await pageWords("answers.ts"), { inPageWords } = await pageWords("words.ts"), cwd = mkdtempSync(join(tmpdir(), "flexslip-"));
  writeFileSync(join(cwd, "case.toml"), '[specimen]\ndiameter = "34 kg"\n[rig]\nspan = "5 N"\nspam = 3\n');
  const { stderr } = spawnSync(program, ["fit", "case.toml"], { cwd, encoding: "utf8" });
  rmSync(cwd, { recursive: true });
  const words = inPageWords(sentence(stderr), { isCase: true, isPlain: false });
  assert.equal(words, stderr.trim().replaceAll("flexslip: ", ""));
  assert.equal(words.split("\n").filter((line) => /^case\.toml:[245]: /.test(line)).length, 3, words);
});

test("what a data file does not say is asked one question at a time, each with its box; no key of a case, no flag", { skip }, async () => {
  const { sentence } = await pageWords("answers.ts"), { questionOf } = await pageWords("words.ts"), cwd = mkdtempSync(join(tmpdir(), "flexslip-"));
  const rows = Array.from({ length: 40 }, (_, i) => `${i},${0.02 * i}`).join("\n");
  const askedBy = (titles, ...flags) => {
    writeFileSync(join(cwd, "run.csv"), `${titles}\n${rows}\n`);
    return questionOf({ isCase: false, isPlain: false, fit: null, refusal: sentence(spawnSync(program, ["fit", "run.csv", ...flags], { cwd, encoding: "utf8" }).stderr) });
  };
  const load = ["--stiffness", "90 N/m"], span = ["--span", "1278 um"];
  const asked = {
    measures: askedBy("Position [um],Load [mN]"), "displacement unit": askedBy("crosshead,Load [mN]"), "force unit": askedBy("crosshead [um],Load"), "load train": askedBy("crosshead [um],force [mN]"), span: askedBy("crosshead [um],force [mN]", ...load),
    radius: askedBy("crosshead [um],force [mN]", ...load, ...span, "--supports", "rollers"), width: askedBy("crosshead [um],force [mN]", ...load, ...span, "--height", "1 mm"), force: askedBy("crosshead [um],second [um]"),
  };
  rmSync(cwd, { recursive: true });
  for (const [box, question] of Object.entries(asked)) {
    assert.equal(question?.box, box, JSON.stringify(question));
    assert.doesNotMatch(question.words, /--[a-z]|\[[a-z]+\] |\(2\)/, box);
  }
  assert.equal(asked["load train"].of, 2);
});
