// The page by itself: what it shows first, what follows the pointer and the keys, at three sizes, light and dark.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, errorOf, fitted, missing, open, page, painted } from "./browser.mjs";
import { pathToFileURL } from "node:url";

const skip = missing || false;
after(close);
const quiet = (tab) => {
  assert.deepEqual(tab.said, [], "the console says nothing");
  assert.deepEqual(tab.asked.map((url) => url.replace(/#.*/, "")), [pathToFileURL(page).href], "one request, the file itself");
};
const row = async (tab) => Number(await tab.locator("#moment .cell b").first().innerText());

for (const [width, height] of [[1280, 800], [1920, 1080], [820, 1180]])
  for (const theme of ["light", "dark"])
    test(`first picture, ${width} by ${height}, ${theme}: the example is open and analysed, nothing overflows`, { skip }, async () => {
      const tab = await open({ width, height, theme });
      assert.match(await tab.locator("#answer h1").innerText(), /Cracks alone do not explain it\./);
      assert.match(await tab.locator("#answer .lead").innerText(), /^35 drops of force\. Each could be a slip over the supports\./);
      assert.equal(await tab.locator(".numbers > div").count(), 5);
      assert.ok((await tab.locator(".checks li").count()) >= 6);
      assert.equal(await tab.evaluate(() => document.documentElement.dataset.theme), theme);
      const wide = await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `the page is ${wide} px wider than the window`);
      const clipped = await tab.evaluate(() => [...document.querySelectorAll(".numbers .value, #answer h1, .parameter .number")].filter((e) => e.scrollWidth > e.clientWidth + 12).map((e) => e.textContent));
      assert.deepEqual(clipped, []);
      for (const plot of ["force", "friction", "fibre"]) assert.ok((await tab.locator(`#${plot}-plot path`).count()) > 3, `${plot} is drawn`);
      quiet(tab);
      await tab.end();
    });

test("first visit: five steps, each with one thing to drag; they come once", { skip }, async () => {
  const tab = await open({ visited: false });
  assert.match(await tab.locator("#tour").innerText(), /Is this toughness\?/);
  for (let i = 0; i < 4; ++i) {
    await tab.locator("#tour [data-next]").click();
    await painted(tab);
  }
  assert.match(await tab.locator("#tour").innerText(), /The test that decides/);
  await tab.locator("#tour [data-next]").click();
  await painted(tab);
  assert.equal(await tab.locator("#tour").isVisible(), false);
  await tab.keyboard.press("?");
  assert.match(await tab.locator("[role=dialog]").innerText(), /previous, next drop/);
  await tab.getByText("Show the five steps").click();
  await painted(tab);
  assert.equal(await tab.locator("#tour").isVisible(), true);
  quiet(tab);
  await tab.end();
});

test("hover: a moment pointed at in one view is marked in all others", { skip }, async () => {
  const tab = await open();
  const marks = () => tab.evaluate(() => ["#force-plot .marker", "#friction-plot .marker", "#rows-plot line[stroke='var(--moment)']", "#programme-plot circle[fill='var(--moment)']", "#fibre-plot"].map((q) => document.querySelector(q).outerHTML));
  const pointAt = async (plot, x, y) => {
    const box = await tab.locator(plot).boundingBox();
    await tab.mouse.move(box.x + box.width * x, box.y + box.height * y);
    await painted(tab);
  };
  for (const plot of ["#force-plot", "#friction-plot"]) {
    await pointAt(plot, 0.3, 0.5);
    const [before, at] = [await marks(), await row(tab)];
    await pointAt(plot, 0.6, 0.5);
    assert.notEqual(await row(tab), at, plot);
    (await marks()).forEach((mark, i) => assert.notEqual(mark, before[i], `${plot} moves mark ${i}`));
  }
  const stays = await row(tab);
  await tab.mouse.move(5, 5);
  assert.equal(await row(tab), stays, "it stays when the pointer leaves");
  const box = await tab.locator("#fibre-plot").boundingBox();
  await tab.mouse.move(box.x + box.width / 2, box.y + 60);
  await tab.mouse.down();
  await tab.mouse.move(box.x + box.width / 2, box.y + 44);
  await tab.mouse.up();
  await painted(tab);
  assert.notEqual(await row(tab), stays, "dragging the fibre moves it");
  quiet(tab);
  await tab.end();
});

test("keyboard: rows, drops, play, pins, theme, table, undo", { skip }, async () => {
  const tab = await open();
  const start = await row(tab);
  await tab.keyboard.press("ArrowRight");
  await painted(tab);
  assert.equal(await row(tab), start + 1);
  await tab.keyboard.press("Shift+ArrowRight");
  await painted(tab);
  assert.match(await tab.locator("#moment .drop").innerText(), /Drop \d+ could be a slip/);
  await tab.waitForFunction(() => /Row \d+, force .*friction .*Drop \d+/.test(document.querySelector("#announcer").textContent));
  const before = await row(tab);
  await tab.keyboard.press("Space");
  await tab.waitForTimeout(400);
  await tab.keyboard.press("Space");
  assert.ok((await row(tab)) > before, "play moves the moment");
  await tab.keyboard.press("p");
  await painted(tab);
  assert.equal(await tab.locator("#pins li").count(), 1);
  await tab.keyboard.press("d");
  assert.equal(await tab.evaluate(() => document.documentElement.dataset.theme), "dark");
  await tab.keyboard.press("t");
  assert.equal(await tab.locator("[role=dialog] tbody tr").count(), 426);
  await tab.keyboard.press("Escape");
  assert.equal(await tab.locator("[role=dialog]").count(), 0);
  quiet(tab);
  await tab.end();
});

test("every slider: a drag redraws the model, turns the row blue, is one undo, and comes home by a double-click on its name", { skip }, async () => {
  const tab = await open();
  const keys = await tab.evaluate(() => [...document.querySelectorAll(".parameter")].map((e) => e.dataset.parameter));
  assert.deepEqual(keys, ["mu0", "rms", "len", "amp", "lam", "phi", "EI", "D", "kc", "L", "R"]);
  const model = () => tab.evaluate(() => [...document.querySelectorAll("#force-plot path[stroke='var(--model)']")].map((p) => p.getAttribute("d")).join());
  const home = await model();
  for (const key of keys) {
    const slider = tab.locator(`.parameter[data-parameter=${key}] input[type=range]`), box = await slider.boundingBox();
    const place = (await slider.evaluate((e) => Number(e.value))) / 1000, x = box.x + 10 + (box.width - 20) * place;
    await tab.mouse.move(x, box.y + box.height / 2);
    await tab.mouse.down();
    for (let i = 1; i <= 4; ++i) await tab.mouse.move(x + (place > 0.8 ? -1 : 1) * i * 3, box.y + box.height / 2);
    await tab.mouse.up();
    await painted(tab);
    assert.equal(await errorOf(tab).catch(() => ""), "", key);
    assert.notEqual(await model(), home, `${key} changes the model`);
    assert.ok(await tab.locator(`.parameter[data-parameter=${key}].changed`).count(), `${key} is marked as changed`);
    assert.match(await tab.locator("#fit-said").innerText(), /By hand: off by/);
    await tab.keyboard.press("Control+z");
    await painted(tab);
    assert.equal(await model(), home, `one undo takes ${key} back`);
    await tab.keyboard.press("Control+Shift+z");
    await tab.locator(`.parameter[data-parameter=${key}] .name`).dblclick();
    await painted(tab);
    assert.equal(await model(), home, `a double-click brings ${key} home`);
  }
  quiet(tab);
  await tab.end();
});

test("numbers: a wrong one gets a line and the old value, one with a unit is taken", { skip }, async () => {
  const tab = await open();
  const box = tab.locator(".parameter[data-parameter=L] input.number"), old = await box.inputValue();
  await box.fill("twelve");
  await box.press("Enter");
  await painted(tab);
  assert.match(await errorOf(tab), /“twelve” is no number between .* µm\. The old value stays\./);
  assert.equal(await box.inputValue(), old);
  await tab.keyboard.press("Escape");
  await box.fill("1.3 mm");
  await box.press("Enter");
  await painted(tab);
  assert.equal(await box.inputValue(), "1300");
  await tab.locator("#reset").click();
  await painted(tab);
  assert.equal(await box.inputValue(), old);
  quiet(tab);
  await tab.end();
});

test("rows: dragging a handle changes the command, and the fit uses those rows", { skip }, async () => {
  const tab = await open();
  const box = await tab.locator("[data-handle=last]").boundingBox(), y = box.y + box.height / 2;
  await tab.mouse.move(box.x + box.width / 2, y);
  await tab.mouse.down();
  await tab.mouse.move(box.x - 120, y, { steps: 5 });
  await tab.mouse.up();
  await painted(tab);
  const until = Number(/record\.until=(\d+)/.exec(await tab.locator("#command").innerText())[1]);
  assert.ok(until > 200 && until < 420, `${until}`);
  await tab.keyboard.press("f");
  await fitted(tab);
  assert.match(await tab.locator("#what").innerText(), new RegExp(`rows 1–${until} of 426`));
  assert.doesNotMatch(await tab.locator("#answer .lead").innerText(), /^35 drops/);
  await tab.keyboard.press("Control+z");
  await tab.keyboard.press("Control+z");
  await painted(tab);
  assert.match(await tab.locator("#what").innerText(), /rows 1–426 of 426/);
  quiet(tab);
  await tab.end();
});

test("cycle: unload and reload are added, drawn, dragged and played", { skip }, async () => {
  const tab = await open();
  await tab.locator("#add-cycle").click();
  await painted(tab);
  const tried = () => tab.evaluate(() => document.querySelector("#force-plot path[stroke-dasharray='5 3']")?.getAttribute("d") ?? "");
  const first = await tried();
  assert.ok(first.length > 500, "the programme is drawn");
  const knob = await tab.locator("[data-knob='2'] circle").last().boundingBox();
  await tab.mouse.move(knob.x + knob.width / 2, knob.y + knob.height / 2);
  await tab.mouse.down();
  await tab.mouse.move(knob.x + knob.width / 2, knob.y - 18, { steps: 3 });
  await tab.mouse.up();
  await painted(tab);
  assert.notEqual(await tried(), first);
  await tab.locator("[data-knob='2']").focus();
  await tab.keyboard.press("Delete");
  await tab.keyboard.press("Control+z");
  await painted(tab);
  assert.notEqual(await tried(), "");
  quiet(tab);
  await tab.end();
});

test("fit: it becomes Cancel in place, the views stay alive, cancelling leaves all as before", { skip }, async () => {
  const tab = await open();
  const answer = await tab.locator("#answer").innerText();
  await tab.locator("#fit").click();
  await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Cancel");
  await tab.locator("#fit").click();
  await tab.waitForFunction(() => document.querySelector("#fit").textContent === "Fit");
  assert.equal(await tab.locator("#answer").innerText(), answer);
  await tab.keyboard.press("f");
  await fitted(tab);
  assert.equal(await tab.locator("#answer").innerText(), answer, "the same fit again, by a new worker");
  quiet(tab);
  await tab.end();
});

test("zoom: the wheel enlarges about the pointer, a double-click shows all again", { skip }, async () => {
  const tab = await open();
  const axis = () => tab.evaluate(() => [...document.querySelectorAll("#force-plot .axes text")].map((e) => e.textContent).join());
  const all = await axis(), box = await tab.locator("#force-plot").boundingBox();
  await tab.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await tab.mouse.wheel(0, -600);
  await painted(tab);
  assert.notEqual(await axis(), all);
  await tab.mouse.dblclick(box.x + box.width / 2, box.y + box.height / 2);
  await painted(tab);
  assert.equal(await axis(), all);
  quiet(tab);
  await tab.end();
});

test("access: what can be operated has a name and can be focused; targets are 24 px, on a tablet 28", { skip }, async () => {
  for (const [width, height, least] of [[1280, 800, 24], [820, 1180, 28]]) {
    const tab = await open({ width, height });
    const faults = await tab.evaluate((size) => [...document.querySelectorAll("button, input, select, [tabindex='0']")].filter((e) => e.offsetParent !== null || e instanceof SVGElement).flatMap((e) => {
      const name = e.getAttribute("aria-label") ?? e.getAttribute("title") ?? e.textContent.trim(), box = e.getBoundingClientRect();
      const small = e.matches("button:not(.link), select") && Math.min(box.width, box.height) < size && !e.closest(".choice");
      return [...(name ? [] : [`no name: ${e.outerHTML.slice(0, 80)}`]), ...(small ? [`${name.slice(0, 20)}: ${box.width} × ${box.height}`] : [])];
    }), least);
    assert.deepEqual(faults, []);
    await tab.end();
  }
});
