// What comes in: each instrument's format, spicules as they were measured, cases, workbooks; the card, and what it changes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { after, test } from "node:test";
import { close, commandOf, data, drop, errorOf, fitted, missing, native, open, painted, program, RIG, root, say } from "./browser.mjs";

const skip = missing || false;
after(close);
const fixtures = join(root, "tests/instruments/fixtures");
const heights = /gwyddion|heights|profilometer/;  // of surfaces, not of tests

/** What the program itself makes of a file: its JSON, or its sentence. */
const readNatively = (folder, name) => {
  try {
    return JSON.parse(execFileSync(program, ["read", name, "--json"], { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] }));
  } catch (cause) {
    return cause.stderr.trim().split("\n").pop().replace(/^flexslip: /, "");
  }
};

/** Drops files one after the other; the card and the line say of each what the program says. */
async function readAs(folder, names) {
  const tab = await open();
  for (const name of names) {
    const told = readNatively(folder, name), before = await tab.locator("#tests li").count();
    await tab.keyboard.press("Escape");
    await painted(tab);
    await drop(tab, join(folder, name));
    await tab.waitForFunction((n) => !document.querySelector("#error").hidden || document.querySelectorAll("#tests li").length > n, before);
    await painted(tab);
    if (typeof told === "string") {
      const asks = /--[a-z]/.test(told), said = await tab.locator(asks ? "#verdict" : "#error span").innerText();
      assert.ok(said.includes(asks ? told.replace(/^[^:]*:(\d+:)?/, "").split(/;| --/)[0].trim() : told), `${name}: ${told}`);
      assert.doesNotMatch(said, /--[a-z]/, name);
      assert.equal(await tab.locator("#tests li").count(), before + (asks ? 1 : 0), `${name} is in the list where it can be told what is missing`);
      continue;
    }
    await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit" && document.querySelector("#card dl") !== null);
    const card = await tab.locator("main").evaluate((e) => [...e.querySelectorAll(".card dt")].map((dt) => [dt.textContent, dt.nextElementSibling.querySelector("select") ? dt.nextElementSibling.querySelector("select").selectedOptions[0]?.textContent : dt.nextElementSibling.querySelector("input").value]));
    const shown = Object.fromEntries(card), force = told.columns.find((c) => c.role === "force"), marks = { ",": "comma", ";": "semicolon", "\t": "tab", tab: "tab", " ": "blanks", space: "blanks" };
    assert.ok(shown.format.includes(marks[told.delimiter] ?? told.delimiter), `${name}: ${shown.format}`);
    const asked = await tab.locator("#request").innerText();
    assert.equal(shown.force ?? (asked ? "not found" : ""), force ? `${force.name}${force.unit ? `, in ${force.unit}` : ""}` : "not found", name);
    assert.match(`${await tab.locator("#what").innerText()} ${await tab.locator("#verdict").innerText()}`, new RegExp(`${told.rows} rows|of ${told.rows}`), name);
  }
  assert.deepEqual(tab.said, []);
  await tab.end();
}

test("each instrument's format, dropped: the card shows what `flexslip read` decides, or the line says its sentence", { skip }, async () => {
  const names = readdirSync(fixtures).filter((name) => !heights.test(name));
  assert.ok(names.length > 10);
  await readAs(fixtures, names);
});

const exports = join(data, "instruments");
test("exports as machines wrote them, each of them dropped: likewise", { skip: skip || (!existsSync(exports) && "no ../shared/data") }, async () => {
  const names = readdirSync(exports, { recursive: true }).filter((name) => statSync(join(exports, name)).isFile());
  assert.ok(names.length >= 10);
  for (const folder of new Set(names.map((name) => dirname(name)))) await readAs(join(exports, folder), names.filter((name) => dirname(name) === folder).map((name) => basename(name)));
});

for (const name of ["SS14", "SS36"])
  test(`a spicule as it was measured: ${name} is asked its rig, fitted, and has the verdict of the command line`, { skip: skip || (!existsSync(join(data, "spicules/ss")) && "no ../shared/data") }, async () => {
    const tab = await open(), file = join(data, `spicules/ss/${name}.csv`);
    await drop(tab, file);
    await tab.waitForFunction((n) => document.querySelector("#tests .selected b")?.textContent === n, name);
    await say(tab, RIG);
    await fitted(tab);
    await tab.locator("#fit").click();  // what was said after the last question
    await fitted(tab);
    // A file with stage and deflection may have shown its load train, which is then not asked.
    const command = await commandOf(tab), args = command.match(/"[^"]*"|\S+/g).slice(1).map((word) => word.replaceAll('"', ""));
    assert.match(command, new RegExp(`^flexslip fit ${name}\\.csv --span "1278 um" --diameter "34\\.8 um"( --stiffness "90\\.65 N/m")?$`));
    const { out } = native([...args, "--json"], { [`${name}.csv`]: readFileSync(file) }), told = JSON.parse(out);
    assert.equal(await tab.locator("#verdict h1").innerText(), told.verdict.sentence);
    assert.equal(await tab.locator("#tests .selected .badge").innerText(), told.verdict.sentence.split(".")[0]);
    assert.match(await tab.locator("#what").innerText(), new RegExp(`rows ${told.measurement.first_row}–${told.measurement.last_row} of ${told.measurement.rows}`));
    assert.deepEqual(tab.said, []);
    await tab.end();
  });

test("a case with its data, dropped together; alone it is asked for its data", { skip }, async () => {
  const tab = await open(), folder = join(root, "examples/cracked");
  await drop(tab, join(folder, "case.toml"));
  await tab.waitForFunction(() => !document.querySelector("#error").hidden);
  assert.match(await errorOf(tab), /test\.csv.*No such file or directory.* Drop case\.toml and test\.csv together\./);
  await tab.keyboard.press("Escape");
  await drop(tab, join(folder, "case.toml"), join(folder, "test.csv"));
  await tab.waitForFunction(() => document.querySelectorAll("#tests li").length === 2);
  await fitted(tab);
  const told = JSON.parse(native(["fit", "case.toml", "--json"], { "case.toml": readFileSync(join(folder, "case.toml")), "test.csv": readFileSync(join(folder, "test.csv")) }).out);
  assert.match(await tab.locator("#verdict h1").innerText(), /^CRACK\. The specimen cracked or settled; its 8 force drops/);
  assert.equal(told.verdict.code, "crack");
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("the card: a column chosen otherwise turns bold, and the command says it", { skip }, async () => {
  const tab = await open();
  const rows = Array.from({ length: 120 }, (_, i) => `${i * 2},${(i * 0.1).toFixed(3)},${(i * 0.2).toFixed(3)}`);
  await drop(tab, { name: "two forces.csv", bytes: Buffer.from(["crosshead [um],force [mN],second force [mN]", ...rows].join("\n")) });
  await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "two forces");
  await tab.locator("#request").getByText("second force, in mN").click();
  await tab.waitForFunction(() => document.querySelector("#card select[aria-label=force]")?.classList.contains("yours"));
  await painted(tab);
  assert.match(await commandOf(tab), /^flexslip read "two forces\.csv" --force 3 --output "two forces\.plain" && flexslip fit "two forces\.plain"/);
  await tab.keyboard.press("Control+z");
  await painted(tab);
  assert.match(await commandOf(tab), /^flexslip fit "two forces\.csv"/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("no drops: the page says that there is nothing to explain, or that there is no answer", { skip }, async () => {
  const tab = await open();
  const rows = Array.from({ length: 200 }, (_, i) => `${i * 2},${(50 * i * 2e-3).toFixed(4)}`);
  await drop(tab, { name: "smooth.csv", bytes: Buffer.from(["crosshead [um],force [mN]", ...rows].join("\n")) });
  await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "smooth");
  await say(tab, RIG);
  await fitted(tab);
  assert.match(`${await tab.locator("#answer").innerText()} ${await errorOf(tab).catch(() => "")}`, /NO DROPS|NO ANSWER|CHECK INPUT|UNDECIDED/);
  assert.deepEqual(tab.said, []);
  await tab.end();
});

test("an Excel workbook gives the same rows as its CSV", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "studio-book-"));
  const rows = readFileSync(join(root, "examples/simulated/test.csv"), "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
  const cell = (column, row, value) => (row === 1 ? `<c r="${column}${row}" t="inlineStr"><is><t>${value}</t></is></c>` : `<c r="${column}${row}"><v>${value}</v></c>`);
  const sheet = `<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>${rows.map((line, i) => `<row r="${i + 1}">${line.split(",").map((value, j) => cell("AB"[j], i + 1, value)).join("")}</row>`).join("")}</sheetData></worksheet>`;
  const script = `import sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as z:
    z.writestr("[Content_Types].xml", '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" ContentType="application/xml"/><Override PartName="/xl/workbook.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/><Override PartName="/xl/worksheets/sheet1.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/></Types>')
    z.writestr("_rels/.rels", '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>')
    z.writestr("xl/_rels/workbook.xml.rels", '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>')
    z.writestr("xl/workbook.xml", '<?xml version="1.0"?><workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="Specimen 1" sheetId="1" r:id="rId1"/></sheets></workbook>')
    z.writestr("xl/worksheets/sheet1.xml", sys.stdin.read())
`;
  try {
    execFileSync("/usr/bin/python3", ["-c", script, join(folder, "book.xlsx")], { input: `<?xml version="1.0"?>${sheet}` });
    const tab = await open();
    await drop(tab, join(folder, "book.xlsx"));
    await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "book");
    assert.match(await tab.locator("#verdict").innerText(), /426 rows/);
    await say(tab, RIG);
    await fitted(tab);
    assert.match(await tab.locator("#verdict .lines").first().innerText(), /next\s+State “supports”: edges, or “radius”/);
    assert.deepEqual(tab.said, []);
    await tab.end();
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
