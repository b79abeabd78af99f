// The program in WebAssembly answers what the program of this computer answers, byte by byte (oracle: FLEXSLIP); and the mechanics of the page what
// `flexslip simulate` and `equilibrium` answer, to the last bit.
//   FLEXSLIP=PROGRAM node --test studio/tests/engine_test.mjs      after tools/build-studio
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const program = resolve(process.env.FLEXSLIP ?? join(root, "build/release/flexslip"));
const wasm = join(root, "build/studio/wasm");
const skip = !existsSync(join(wasm, "program.wasm")) ? "the studio is not built: tools/build-studio" : !existsSync(program) ? `there is no program ${program}` : false;
const folder = mkdtempSync(join(tmpdir(), "flexslip-engine-"));
after(() => rmSync(folder, { recursive: true }));

const { build } = await import(pathToFileURL(join(root, "studio/page/node_modules/esbuild/lib/main.js")).href);
async function bundled(entry) {
  const out = join(folder, `${entry}.mjs`);
  await build({
    entryPoints: [join(root, "studio/page/engine", `${entry}.ts`)], bundle: true, format: "esm", platform: "neutral", outfile: out, logLevel: "error",
    alias: { "program-glue": join(wasm, "program.js"), "mechanics-glue": join(wasm, "mechanics.js") },
  });
  return import(pathToFileURL(out).href);
}
const opened = skip ? {} : { ...(await bundled("run")), module: await WebAssembly.compile(readFileSync(join(wasm, "program.wasm"))) };

const filesOf = (place) => Object.fromEntries(readdirSync(place, { recursive: true }).filter((name) => statSync(join(place, name)).isFile()).map((name) => [name, new Uint8Array(readFileSync(join(place, name)))]));
const inPage = (args, files) => opened.runProgram(opened.module, args, files, () => undefined);

/** Runs both in folders with the same files and compares all that they say and write. */
async function same(t, args, files, within = ".") {
  const here = mkdtempSync(join(folder, "native-"));
  for (const [name, data] of Object.entries(files)) {
    mkdirSync(dirname(join(here, within, name)), { recursive: true });
    writeFileSync(join(here, within, name), data);
  }
  const native = spawnSync(program, args, { cwd: join(here, within), encoding: "utf8", maxBuffer: 1e9 });
  const page = await inPage(args, files);
  const call = args.join(" ");
  assert.equal(page.code, native.status, `${call}: ${page.err}`);
  assert.equal(page.err, native.stderr, call);
  assert.equal(page.out, native.stdout, call);
  const written = Object.fromEntries(Object.entries(filesOf(join(here, within))).filter(([name, data]) => !(name in files && Buffer.compare(data, files[name]) === 0)));
  assert.deepEqual(Object.keys(page.files).sort(), Object.keys(written).sort(), call);
  for (const [name, data] of Object.entries(written)) assert.equal(Buffer.compare(Buffer.from(page.files[name]), Buffer.from(data)), 0, `${call}: ${name}`);
  t.diagnostic(`${call}: ${page.out.length + Object.values(page.files).reduce((sum, data) => sum + data.length, 0)} bytes`);
}

const text = (words) => new TextEncoder().encode(words);
const caseOf = (friction, rig = "", stage = 'program = ["0 um", "500 um", "100 um", "600 um"]\nstep = "1 um"\n') => text(`[specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
${rig}[friction]
${friction}[stage]
${stage}`);
const WAVE = 'model = "sinusoid"\nmu0 = 0.5\namplitude = 0.02\nwavelength = "11 um"\nphase = "0.7 rad"\n';
const CASES = {
  wave: caseOf(WAVE.replace("0.02", "0.15"), 'friction_at = "axis"\n'),
  thick: caseOf(WAVE),
  rollers: caseOf(WAVE, 'roller_radius = "60 um"\n'),
  rough: caseOf('model = "rough"\nmu0 = 0.4\nrms = 0.15\ncorrelation_length = "9 um"\nseed = 4\n', 'friction_at = "axis"\n'),
  drift: caseOf('model = "drift"\nmu0 = 0.4\ndrift = "0.3 1/mm"\n'),
  "static excess": caseOf(`${WAVE}static_excess = 0.03\n`, 'friction_at = "axis"\n'),
  "two supports": caseOf(`${WAVE}[friction.other]\nmodel = "constant"\nmu0 = 0.35\n`, 'friction_at = "axis"\n'),
  continuous: caseOf(WAVE, "", 'program = ["0 um", "500 um", "100 um"]\nstep = "continuous"\n'),
};

test("simulate and equilibrium have the same bytes", { skip }, async (t) => {
  for (const [name, data] of Object.entries(CASES)) {
    t.diagnostic(name);
    await same(t, ["simulate", "case.toml", "--json"], { "case.toml": data });
    await same(t, ["simulate", "case.toml", "--output", "test.csv"], { "case.toml": data });
    if (name !== "two supports") await same(t, ["equilibrium", "case.toml", "--points", "300"], { "case.toml": data });
  }
  await same(t, ["simulate", "case.toml", "--noise", "10 uN", "--seed", "3"], { "case.toml": CASES.thick });
});

test("fits of the examples have the same bytes", { skip }, async (t) => {
  for (const example of ["simulated", "cracked", "cyclic"]) {
    const files = filesOf(join(root, "examples", example));
    await same(t, ["fit", "case.toml", "--json", "--quiet", "--profile", "p.csv", "--curves", "c.csv", "--draws", "d.csv"], files, "test");
  }
});

test("fits of three measured specimens have the same bytes", { skip }, async (t) => {
  const data = join(root, "../shared/data/spicules");
  if (!existsSync(data)) return t.skip("the measured data are not here");
  const [titles, ...rows] = readFileSync(join(data, "specimens.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  for (const record of ["SS04.csv", "SS23.csv", "SS28.csv"]) {
    const name = `SS${Number(record.slice(2, -4))}`, cells = rows.find((row) => row[0] === name), of = (title) => cells[titles.indexOf(title)];
    const described = `[specimen]\ndiameter = "${of("diameter_m")} m"\nmodulus = "fit"\n[rig]\nspan = "${of("span_m")} m"\nstiffness = "${of("cantilever_stiffness_N_per_m")} N/m"\n[record]\nfile = "${record}"\nstage = "w_s_m [m]"\nforce = "F_N [N]"\nuntil = ${Math.round(Number(of("index_of_failure")))}\n`;
    await same(t, ["fit", `${name}.toml`, "--json", "--quiet"], { [`${name}.toml`]: text(described), [record]: new Uint8Array(readFileSync(join(data, "ss", record))) });
  }
});

test("read, modulus, invert and keys have the same bytes", { skip }, async (t) => {
  const files = filesOf(join(root, "examples/simulated"));
  await same(t, ["read", "test.csv", "--json"], files);
  await same(t, ["modulus", "case.toml"], files, "test");
  await same(t, ["invert", "case.toml"], files, "test");
  await same(t, ["keys"], {});
});

test("a campaign has the same bytes, its workbook too", { skip }, async (t) => {
  const files = Object.fromEntries(["simulated", "cyclic"].flatMap((example) => Object.entries(filesOf(join(root, "examples", example))).map(([name, bytes]) => [`${example}/${name}`, bytes])));
  await same(t, ["campaign", ".", "--json"], files, "test");
  await same(t, ["campaign", ".", "--report", "out", "--no-figures", "--quiet"], files, "test");
});

test("a program that does not start is a fault, and no answer that never comes", { skip }, async () => {
  const imports = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 2, 7, 1, 1, 0x51, 1, 0x52, 0, 0);  // a function "R" of a module "Q", which there is none of
  await assert.rejects(opened.runProgram(await WebAssembly.compile(imports), ["--version"], {}, () => undefined), /Import|instantiate/);
});

test("faults are the program's own sentences and codes; what a page cannot do, it says", { skip }, async (t) => {
  await same(t, ["fit", "nothing.toml"], { "nothin.toml": text("[rig]\nspan = 3\n") });
  await same(t, ["simulate", "case.toml"], { "case.toml": text("[rig]\nspan = 3\n") });
  await same(t, ["flt"], {});
  const sweep = await inPage(["sweep", "sweep.toml"], { "sweep.toml": new Uint8Array(readFileSync(join(root, "examples/sweep.toml"))) });
  assert.equal(sweep.code, 2);
  assert.match(sweep.err, /Run the same command with the program flexslip, outside the studio/);
  const report = await inPage(["fit", "case.toml", "--report", "report", "--quiet"], filesOf(join(root, "examples/simulated")));
  assert.equal(report.code, 0, report.err);
  assert.ok("report/report.html" in report.files);
});

test("the text of a module has the bytes that were packed, of every length (identity)", { skip }, async () => {
  const { unpacked } = await bundled("unpack");
  for (let length = 0; length < 70; ++length) {
    const bytes = Uint8Array.from({ length }, (_, i) => (length * 37 + i * i * 101 + (i % 5 ? 0 : 255)) % 256);
    const packed = execFileSync("node", [join(root, "studio/page/engine/pack.mjs")], { input: bytes, encoding: "latin1" });
    assert.match(packed, /^[(-~]*$/);
    assert.doesNotMatch(packed, /[<\\]/);
    assert.deepEqual(unpacked(packed), bytes, String(length));
  }
  const greatest = new Uint8Array(9).fill(255);
  assert.deepEqual(unpacked(execFileSync("node", [join(root, "studio/page/engine/pack.mjs")], { input: greatest, encoding: "latin1" })), greatest);
});

test("files stay within the folder of a run, whatever their names", { skip }, async () => {
  const ran = await inPage(["read", "passwd", "--json"], { "../../etc/passwd": text("crosshead [um],force [mN]\n0,0\n1,1\n2,2\n") });
  assert.notEqual(ran.code, 1, ran.err);
  assert.deepEqual(Object.keys(ran.files).filter((name) => name.includes("..")), []);
});

test("the page's mechanics have the bits of simulate and equilibrium", { skip }, async () => {
  const glue = (await bundled("mechanics")).default;
  const module = await WebAssembly.compile(readFileSync(join(wasm, "mechanics.wasm")));
  const mechanics = await glue({ instantiateWasm: (imports, done) => (void WebAssembly.instantiate(module, imports).then(done), {}) });
  const lengths = Float64Array.from({ length: 1000 }, (_, i) => 1.1e-3 + i * 1.4e-6), wavy = (amplitude) => ({ length: lengths, mu: lengths.map((S) => 0.5 * (1 + amplitude * Math.cos((Math.PI * S) / 1.1e-5 + 0.7))) });
  const rigs = {
    wave: { stiffness: 90.65, tipRadius: 0, diameter: 0, friction: wavy(0.15) },
    rollers: { stiffness: 400, tipRadius: 6e-5, diameter: 3.48e-5, friction: wavy(0.02) },
  };
  for (const [name, rig] of Object.entries(rigs)) {
    const full = { span: 1.278e-3, bendingStiffness: 2.13e-9, ...rig };
    const { length, mu } = rig.friction;
    const file = join(folder, `${name}.toml`);
    writeFileSync(join(folder, `${name}.csv`), ["S [m],mu", ...Array.from(length, (S, i) => `${S},${mu[i]}`), ""].join("\n"));
    writeFileSync(file, `[specimen]\nbending_stiffness = "2.13e-9 N m^2"\n${full.diameter ? `diameter = "${full.diameter} m"\n` : ""}[rig]\nspan = "1.278e-3 m"\nstiffness = "${full.stiffness} N/m"\n${full.tipRadius ? `roller_radius = "${full.tipRadius} m"\n` : ""}[friction]\nmodel = "table"\nfile = "${name}.csv"\nlength = "S [m]"\n[stage]\nprogram = ["0 m", "5e-4 m", "1e-4 m", "6e-4 m"]\nstep = "1e-6 m"\n`);
    const told = JSON.parse(execFileSync(program, ["simulate", file, "--json", "--quiet"], { encoding: "utf8", maxBuffer: 1e9 }));
    const { result: loading, error } = mechanics.simulate(full, [0, 5e-4, 1e-4, 6e-4], 1e-6, 200);
    assert.equal(error, undefined, name);
    assert.equal(loading.status, told.status);
    for (const column of ["stage", "deflection", "force"]) assert.deepEqual(Array.from(loading[column]), told.path.map((point) => point[column]), `${name}: ${column}`);
    assert.deepEqual(Array.from(loading.friction), told.path.map((point) => point.q), `${name}: friction`);
    assert.equal(loading.snaps.length, told.snaps.length);
    const lines = execFileSync(program, ["equilibrium", file, "--points", "200", "--longest", "1.5336e-3 m", "--json", "--quiet"], { encoding: "utf8", maxBuffer: 1e9 });
    const curve = mechanics.equilibrium(full, 1.5336e-3, 200).result;
    const points = Object.values(JSON.parse(lines)).find((value) => Array.isArray(value));
    assert.deepEqual(Array.from(curve.force), points.map((point) => point.F ?? point.force), `${name}: equilibrium`);
  }
  assert.match(mechanics.simulate({ span: 1e-3, diameter: 0, bendingStiffness: -1, stiffness: 1, tipRadius: 0, friction: rigs.wave.friction }, [0, 1e-4], 1e-6, 2).error, /bending stiffness = -1/);
});
