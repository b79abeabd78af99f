// What a stranger may send: hostile names, HTML in headers, binaries, large files, malformed addresses. All inert, with a sentence, and the page goes on working.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";
import { close, commandOf, drop, errorOf, fitted, missing, open, page, painted, root } from "./browser.mjs";

const skip = missing || false;
after(close);
const rows = Array.from({ length: 60 }, (_, i) => `${i * 2},${(i * 0.1).toFixed(3)}`).join("\n");

/** Markup that would say so if it were read as such. */
const BAIT = '<img src=x onerror="window.__struck=1"><script>window.__struck=1</script><svg onload="window.__struck=1">';
async function works(tab, why) {
  assert.equal(await tab.evaluate(() => window.__struck), undefined, `${why}: nothing was run`);
  assert.equal(await tab.evaluate(() => document.querySelectorAll("#left img, #middle img, #right img, main script, #left svg[onload], #middle svg[onload]").length), 0, `${why}: no element was made`);
  await tab.keyboard.press("Escape");
  await tab.locator("#tests .test").first().click();
  await painted(tab);
  await tab.locator("#force-plot").focus();
  const row = () => tab.locator("#moment .cell b").first().innerText();
  const before = await row();
  await tab.keyboard.press(Number(before) > 400 ? "ArrowLeft" : "ArrowRight");
  await painted(tab);
  assert.notEqual(await row(), before, `${why}: the page goes on working`);
  assert.deepEqual(tab.said, [], `${why}: the console says nothing`);
}
const settled = (tab, before) => tab.waitForFunction((n) => (!document.querySelector("#error").hidden || document.querySelectorAll("#tests li").length > n) && document.querySelector("#fit").textContent === "Fit", before);

test("hostile names and headers are words, nothing else", { skip }, async () => {
  const tab = await open();
  const names = [`${BAIT}.csv`, "--help.csv", "-o.csv", "../../etc/passwd", "a\u0000b\n.csv", "$(touch x).csv", "'; rm -rf .csv", `${"long".repeat(400)}.csv`, "\u202Evsc.exe", "con.csv", ".csv", "__proto__.csv", "constructor"];
  for (const name of names) {
    const before = await tab.locator("#tests li").count();
    await drop(tab, { name, bytes: Buffer.from(`crosshead [um],force [mN]\n${rows}`) });
    await settled(tab, before);
    await works(tab, name.slice(0, 40));
  }
  const headers = [`${BAIT} [um],force [mN]`, `"crosshead [um]","force ${BAIT.replaceAll('"', '""')} [mN]"`, `${BAIT}\n${BAIT}\ncrosshead [um],force [mN]`, "crosshead [<b>um</b>],force [mN]"];
  for (const header of headers) {
    const before = await tab.locator("#tests li").count();
    await drop(tab, { name: "header.csv", bytes: Buffer.from(`${header}\n${rows}`) });
    await settled(tab, before);
    await works(tab, header.slice(0, 40));
  }
  const before = await tab.locator("#tests li").count();
  await drop(tab, { name: "bait.toml", bytes: Buffer.from(`# ${BAIT}\n[record]\nfile = "${BAIT.replaceAll('"', "'")}"\n`) });
  await settled(tab, before);
  await works(tab, "a case that names markup");
  await tab.end();
});

test("the command that is copied quotes what a name would do in it", { skip }, async () => {
  const tab = await open();
  await drop(tab, { name: "$(touch x) 'y'.csv", bytes: Buffer.from(`crosshead [um],force [mN]\n${rows}`) });
  await tab.waitForFunction(() => document.querySelectorAll("#tests li").length === 2);
  assert.equal(await commandOf(tab), `flexslip fit '$(touch x) '\\''y'\\''.csv'`);
  await tab.end();
});

test("binaries: each gets a sentence that names the file", { skip }, async () => {
  const tab = await open();
  let seed = 7;
  const random = (n) => Buffer.from(Array.from({ length: n }, () => (seed = (seed * 1103515245 + 12345) & 0x7fffffff) >> 16 & 255));
  const files = [["noise.csv", random(20_000)], ["empty.csv", Buffer.alloc(0)], ["zeros.txt", Buffer.alloc(5000)], ["not-a-book.xlsx", random(3000)], ["cut.xlsx", Buffer.concat([Buffer.from("PK\u0003\u0004"), random(500)])],
    ["picture.png", Buffer.concat([Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]), random(2000)])], ["page.html", Buffer.from(`<!doctype html>${BAIT}`)], ["case.toml", random(2000)], ["bomb.toml", Buffer.from("[".repeat(20_000))]];
  for (const [name, bytes] of files) {
    const before = await tab.locator("#tests li").count();
    await drop(tab, { name, bytes });
    await settled(tab, before);
    assert.match(await errorOf(tab), new RegExp(name.replace(/\..*/, "")), name);
    assert.equal(await tab.locator("#tests li").count(), before, `${name} is in no list`);
    await works(tab, name);
  }
  await tab.end();
});

test("a file of 300 MB is refused by a sentence before it is read, one of 20 MB is read", { skip }, async () => {
  const tab = await open();
  await tab.evaluate(() => {
    const part = new Uint8Array(1 << 20).fill(49), transfer = new DataTransfer();
    transfer.items.add(new File(Array.from({ length: 300 }, () => part), "huge.csv"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  });
  await tab.waitForFunction(() => !document.querySelector("#error").hidden);
  assert.match(await errorOf(tab), /huge\.csv has 315 MB; the studio reads files up to 64 MB\. The program itself reads it: flexslip fit\./);
  await works(tab, "300 MB");
  await tab.evaluate(() => {
    let words = "crosshead [um],force [mN]\n";
    for (let i = 0; i < 900_000; ++i) words += `${(i / 1000).toFixed(3)},${(i / 100000).toFixed(6)}\n`;
    const transfer = new DataTransfer();
    transfer.items.add(new File([words], "large.csv"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  });
  await tab.waitForFunction(() => [...document.querySelectorAll("#tests b")].some((b) => b.textContent === "large") || !document.querySelector("#error").hidden);
  assert.equal(await tab.evaluate(() => [...document.querySelectorAll("#tests b")].some((b) => b.textContent === "large")), true);
  await works(tab, "20 MB");
  await tab.end();
});

test("malformed addresses, 400 of them made at random: inert", { skip }, async () => {
  const tab = await open();
  await tab.click("#export");
  await tab.locator("#menu button", { hasText: "Link to this state" }).click();
  await tab.waitForFunction(() => location.hash.startsWith("#s="));
  const good = await tab.evaluate(() => location.hash);
  let seed = 11;
  const random = (n) => (seed = (seed * 1103515245 + 12345) & 0x7fffffff) % n;
  const fixed = [`#${BAIT}`, `#s=${BAIT}`, "#s=", "#s=AAAA", "#s=%00%ff", "#s==", "#javascript:alert(1)", `#${"x".repeat(100_000)}`, `#s=${"A".repeat(200_000)}`];
  const mutated = Array.from({ length: 400 - fixed.length }, () => {
    const text = [...good];
    for (let n = 1 + random(4); n > 0; --n) {
      const at = 3 + random(text.length - 3);
      if (random(3) === 0) text.splice(at, random(20));
      else text[at] = "ABCxyz019-_%<>\"' "[random(17)];
    }
    return text.join("");
  });
  for (const hash of [...fixed, ...mutated]) await tab.evaluate((h) => { location.hash = h; }, hash);
  await tab.waitForTimeout(1500);
  await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit");
  await works(tab, "mutated addresses");
  for (const hash of [fixed[0], fixed[1], mutated[0], mutated[1]]) {
    const fresh = await open({ hash: hash.replace(/[<>" ]/g, encodeURIComponent) });
    await fitted(fresh);
    await works(fresh, hash.slice(0, 30));
    await fresh.end();
  }
  await tab.end();
});

test("states of well-formed addresses with wild contents are refused or made harmless", { skip }, async () => {
  const packed = async (tab, state) => tab.evaluate(async (value) => {
    const stream = new Blob([JSON.stringify(value)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    return `#s=${btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
  }, state);
  const tab = await open(), base = { files: null, main: "simulated.toml", data: "test.csv", settings: { read: {} }, values: {}, wave: null, row: 1, axis: "deflection", programme: null };
  const wild = [
    [], 7, "x", null, {}, { ...base, files: [{ name: BAIT, base64: btoa(`crosshead [um],force [mN]\n${rows}`) }], main: BAIT, data: BAIT }, { ...base, files: [{ name: "a.csv", base64: "!!" }], main: "a.csv", data: "a.csv" },
    { ...base, values: { L: -1, EI: 1e300, kc: 0, mu0: "x", D: null, evil: 1 } }, { ...base, values: { L: 1e-300, R: 1e9 } }, { ...base, settings: { read: { separator: "--output", decimal: BAIT }, until: 1e99, span: "x", contact: "; rm" } },
    { ...base, row: 1e308 }, { ...base, row: -5 }, { ...base, programme: [0, 1e9, 0] }, { ...base, programme: ["a"] }, { ...base, settings: { __proto__: { polluted: 1 }, read: { constructor: "x" } } },
  ];
  for (const [i, state] of wild.entries()) {
    const fresh = await open({ hash: await packed(tab, state) });
    await fresh.waitForFunction(() => document.querySelector("#fit").textContent === "Fit");
    assert.equal(await fresh.evaluate(() => ({}).polluted), undefined);
    if (await fresh.locator("#tests li").count()) {
      await fresh.locator("#reset").click({ force: true, timeout: 2000 }).catch(() => {});
      assert.equal(await fresh.evaluate(() => window.__struck), undefined, `state ${i}`);
    }
    assert.deepEqual(fresh.said, [], `state ${i}`);
    await fresh.end();
  }
  await tab.end();
});

test("a page that was damaged says that its program does not start, at each attempt", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "studio-damaged-")), whole = readFileSync(page, "utf8");
  const packed = (bytes) => execFileSync("node", [join(root, "studio/page/engine/pack.mjs")], { input: gzipSync(bytes), encoding: "latin1" });
  const wants = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 2, 7, 1, 1, 0x51, 1, 0x52, 0, 0);  // WebAssembly that asks for what there is not
  const damages = { "what is no gzip": ["program", "((((((((((((("], "WebAssembly of something else": ["program", packed(wants)], "no WebAssembly": ["program", packed(Buffer.from("no"))], "a Worker that fails": ["worker", "throw new Error('damaged')"], "mechanics of something else": ["mechanics", packed(wants)] };
  try {
    for (const [what, [id, text]] of Object.entries(damages)) {
      const file = join(folder, "page.html");
      writeFileSync(file, whole.replace(new RegExp(`(<script type="text/plain" id="${id}">)[^]*?(</script>)`), (_, before, after) => before + text + after));
      const tab = await open({ file, wait: false });
      const said = id === "mechanics" ? "The studio could not start: " : "the program ended without an answer: ";
      await tab.waitForFunction((words) => document.querySelector("#error").textContent.includes(words) || document.querySelector("#verdict").textContent.includes(words), said);
      if (id !== "mechanics") {
        await tab.waitForSelector("body[data-ready]");
        assert.equal(await tab.locator("#fit").innerText(), "Fit", what);
        await tab.keyboard.press("Escape");
        await drop(tab, { name: "again.csv", bytes: Buffer.from(`crosshead [um],force [mN]\n${rows}`) });
        await tab.waitForFunction(() => !document.querySelector("#error").hidden);
        assert.match(await errorOf(tab), /again\.csv: the program ended without an answer: ./, what);
      }
      await tab.end();
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
