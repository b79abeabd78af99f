// How long from a slider's event to the painted frame, and from a pointer's, with 2,000 points; from opening to the example analysed. A benchmark: it prints,
// and with LIMITS=1 it fails beyond 33 ms, 16 ms (95th percentile) and 1.5 s.
//   node studio/tests/latency_bench.mjs
import assert from "node:assert/strict";
import { close, drop, fitted, longRecord, missing, open, RIG, say } from "./browser.mjs";

if (missing) {
  console.log(missing);
  process.exit(77);
}
await (await open()).end();  // the browser is there, and has read the file once
const tab = await open();
await fitted(tab);
const first = await tab.evaluate(() => performance.getEntriesByName("analysed")[0].startTime);  // [ms] from navigation
await drop(tab, { name: "long.csv", bytes: longRecord() });
await tab.waitForFunction(() => document.querySelector("#tests .selected b")?.textContent === "long");
await say(tab, RIG);
await tab.keyboard.press("Escape");
const began = performance.now();
await tab.locator("#fit").click();
await fitted(tab);
const fit = performance.now() - began;
await tab.waitForTimeout(2500);  // the band of the draws is made when the page is at rest
const points = await tab.locator("#what").innerText();

/** Milliseconds from an event to the frame that shows it: a task queued behind the next paint. */
const measured = (what) => tab.evaluate(async (kind) => {
  const times = [], slider = document.querySelector(".parameter[data-parameter=EI] .drag"), plot = document.querySelector("#force-plot"), box = plot.getBoundingClientRect();
  const drag = (type, clientX) => slider.dispatchEvent(new PointerEvent(type, { bubbles: true, clientX }));
  slider.setPointerCapture = () => {};  // there is no pointer to capture
  if (kind === "slider") drag("pointerdown", 500);
  for (let i = 0; i < 120; ++i) {
    await new Promise((done) => setTimeout(done, 20));
    const then = performance.now();
    if (kind === "slider") {
      drag("pointermove", 500 + 20 * Math.sin(i / 9));
    } else plot.dispatchEvent(new PointerEvent("pointermove", { bubbles: true, clientX: box.left + 60 + ((i * 37) % (box.width - 100)), clientY: box.top + 60 }));
    await new Promise((done) => requestAnimationFrame(() => {
      const channel = new MessageChannel();
      channel.port1.onmessage = () => done();
      channel.port2.postMessage(0);
    }));
    times.push(performance.now() - then);
  }
  if (kind === "slider") drag("pointerup", 500);
  return times.slice(20).sort((a, b) => a - b);
}, what);
const quantile = (times, share) => times[Math.min(times.length - 1, Math.floor(times.length * share))];
/** Likewise, the processor's time in the page's own thread for each event: what a machine with other work measures, too. */
const session = await tab.context().newCDPSession(tab);
await session.send("Performance.enable", { timeDomain: "threadTicks" });
const ticks = async () => (await session.send("Performance.getMetrics")).metrics.find((m) => m.name === "TaskDuration").value * 1000;
const events = 120;
async function both(what) {
  const before = await ticks(), times = await measured(what);
  return { times, processor: ((await ticks()) - before) / events };
}
const slider = await both("slider"), hover = await both("hover");
console.log(`points:                       ${points}`);
console.log(`opening to example analysed:  ${(first / 1000).toFixed(2)} s`);
console.log(`fit of these points:          ${(fit / 1000).toFixed(2)} s`);
console.log(`slider to frame, 50th, 95th:  ${quantile(slider.times, 0.5).toFixed(1)}, ${quantile(slider.times, 0.95).toFixed(1)} ms; processor ${slider.processor.toFixed(1)} ms`);
console.log(`hover to frame, 50th, 95th:   ${quantile(hover.times, 0.5).toFixed(1)}, ${quantile(hover.times, 0.95).toFixed(1)} ms; processor ${hover.processor.toFixed(1)} ms`);
await tab.end();
await close();
if (process.env.LIMITS) {
  assert.ok(quantile(slider.times, 0.95) <= 33, "slider to painted frame");
  assert.ok(quantile(hover.times, 0.95) <= 16.7 + 16, "pointer to painted frame: 16 ms, and the wait for a frame");
  assert.ok(first <= 1500, "opening to the example analysed");
}
