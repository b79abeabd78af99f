// The studio as a user has it: one file, opened from file:// in Debian's chromium with the network off.
//   STUDIO    the page (build/studio/flexslip-studio.html)      FLEXSLIP  the program that its answers are held against
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const page = resolve(process.env.STUDIO ?? join(root, "build/studio/flexslip-studio.html"));
export const program = resolve(process.env.FLEXSLIP ?? join(root, "build/release/flexslip"));
export const data = resolve(root, "../shared/data");
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
export const missing = !existsSync(page) ? `there is no page ${page}: tools/build-studio makes it` : !existsSync(program) ? `there is no program ${program}` : !chromium ? "there is no chromium: apt-get install --no-install-recommends chromium" : "";

let browser = null;
async function launched() {
  if (browser) return browser;
  const { chromium: engine } = createRequire(join(root, "studio/page/package.json"))("playwright-core");
  browser = await engine.launch({ executablePath: chromium, args: ["--no-sandbox", ...(process.env.STUDIO_ARGS?.split(" ") ?? [])] });
  return browser;
}
export const close = async () => browser?.close();

/** A page that has shown its first picture; `said` is what the console said, `asked` what was requested. */
export async function open({ width = 1280, height = 800, theme = "light", hash = "", visited = true, wait = true, file = page, reducedMotion = "no-preference" } = {}) {
  const context = await (await launched()).newContext({ viewport: { width, height }, colorScheme: theme, acceptDownloads: true, offline: true, reducedMotion });
  context.setDefaultTimeout(Number(process.env.HANG ?? 600_000));  // that of a hang: a loaded machine is no fault
  const tab = await context.newPage(), said = [], asked = [];
  tab.on("console", (message) => said.push(`${message.type()}: ${message.text()}`));
  tab.on("pageerror", (error) => said.push(`error: ${error.message}`));
  tab.on("request", (request) => /^(blob|data):/.test(request.url()) || asked.push(request.url()));
  tab.on("dialog", (dialog) => said.push(`dialog: ${dialog.message()}`) && dialog.dismiss());
  if (visited) await tab.addInitScript(() => { try { localStorage.setItem("flexslip-studio-visited", "yes"); } catch {} });
  await tab.goto(pathToFileURL(file).href + hash);
  if (wait) {
    await tab.waitForSelector("body[data-ready]");
    await painted(tab);  // its views are drawn once more at the size that they have with the answer
  }
  return Object.assign(tab, { said, asked, end: () => context.close() });
}

/** Drops files, which are paths or { name, bytes }, anywhere on the page. */
export async function drop(tab, ...files) {
  const list = files.map((file) => (typeof file === "string" ? { name: basename(file), bytes: readFileSync(file) } : file)).map(({ name, bytes }) => ({ name, text: Buffer.from(bytes).toString("base64") }));
  const transfer = await tab.evaluateHandle((given) => {
    const all = new DataTransfer();
    for (const { name, text } of given) all.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
    return all;
  }, list);
  await tab.dispatchEvent("body", "drop", { dataTransfer: transfer });
}
/** Nothing is read or fitted, and the program asks nothing; what was asked for a moment ago has begun. */
export const fitted = async (tab) => (await painted(tab), tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit" && document.querySelector("#request .ask") === null && !/^(Reading|Fitting|Waits)/.test(document.querySelector("#fit-said").textContent) && !/^(Fitting|Waits)/.test(document.querySelector("#verdict h1").textContent)));
/** The command that the menu offers to copy. */
export async function commandOf(tab) {
  await tab.click("#export");
  const command = await tab.locator("#menu [data-command]").getAttribute("data-command");
  await tab.keyboard.press("Escape");
  return command;
}
export const errorOf = (tab) => tab.locator("#error").innerText();
export const painted = (tab) => tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** States what a data file does not: what the card has a box for, then what the program asks, one question after the other; at the last answer it fits. */
export async function say(tab, rig) {
  const left = { ...rig }, enter = async (box, name) => {
    await box.fill(left[name]);
    await box.press("Enter");
    delete left[name];
  };
  const request = tab.locator("#request .ask input");
  await request.waitFor();
  for (const name of Object.keys(left)) {
    const box = tab.locator(`#card [aria-label="${name}"]`);
    if (await box.count()) await enter(box, name), await tab.waitForTimeout(300);  // asked once more, the program asks the same
  }
  while (await request.count()) {
    const name = await request.getAttribute("aria-label");
    if (!(name in left)) return;
    const asked = await tab.locator("#verdict h1").innerText();
    await enter(request, name);
    await tab.waitForFunction((words) => document.querySelector("#verdict h1").innerText !== words && document.querySelector("#fit").textContent === "Fit", asked);
  }
}
export const RIG = { span: "1278 um", diameter: "34.8 um", "load train": "90.65 N/m" };

/** What one item of the export menu saves: file names with bytes. */
export async function exported(tab, title, note = "") {
  const downloads = [], keep = (download) => downloads.push(download);
  tab.on("download", keep);
  await tab.click("#export");
  await tab.locator("#menu button", { hasText: title }).filter({ hasText: note }).first().click();
  for (let quiet = 0, count = 0; quiet < 6 || downloads.length === 0; ++quiet) {
    await tab.waitForTimeout(150);
    if (downloads.length !== count) (count = downloads.length), (quiet = 0);
    if (quiet > 200) throw new Error(`nothing was saved by ${title}`);
  }
  tab.off("download", keep);
  const files = {};
  for (const download of downloads) files[download.suggestedFilename()] = readFileSync(await download.path());
  return files;
}

/** Runs the program natively in a folder that holds `files`; answers its output and that folder's new files. */
export function native(args, files) {
  const folder = mkdtempSync(join(tmpdir(), "studio-test-"));
  try {
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    const out = execFileSync(program, args, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] });
    return { out, file: (name) => readFileSync(join(folder, name), "utf8"), ...Object.fromEntries(args.filter((a) => /\.csv$/.test(a) && existsSync(join(folder, a))).map((a) => [a, readFileSync(join(folder, a), "utf8")])) };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
export const numbersOf = (csv) => csv.trim().split("\n").filter((line) => !line.startsWith("#")).slice(1).map((line) => line.split(",").map(Number));

/** A record of 1,000 points, whose fit takes about a second, of which the page shows what comes after the first half: its columns are "stage [m]", "unused [m]" and "force [N]". */
export function longRecord() {
  const simulated = native(["simulate", "long.toml", "--noise", "30 uN", "--seed", "3"], { "long.toml": '[specimen]\ndiameter = "34.8 um"\nmodulus = "29.6 GPa"\n[rig]\nspan = "1278 um"\nstiffness = "90.65 N/m"\n[friction]\nmodel = "sinusoid"\nmu0 = 0.8\namplitude = 0.12\nwavelength = "6 um"\nphase = 1.0\n[stage]\nprogram = ["0 um", "900 um"]\nstep = "0.9 um"\n' }).out;
  const lines = simulated.trim().split("\n").filter((line) => !line.startsWith("#")).map((line) => line.split(",").slice(0, 3));
  const titles = lines[0].join(",");
  return Buffer.from([titles.replace(/w_s( \[m\])?/, "stage [m]").replace(/(^|,)w( \[m\])?(?=,)/, "$1unused [m]").replace(/F( \[N\])?$/, "force [N]"), ...lines.slice(1).map((line) => line.join(","))].join("\n"));
}
