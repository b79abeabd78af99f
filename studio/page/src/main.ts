// Puts the page together: engine, state, views, and what comes in and goes out.

import { openMechanics, openProgram } from "engine";
import { addressOf, base64Of, bytesOf, linkOf, type Link } from "./address";
import { isWithdrawn, tellsFriction } from "./answer";
import { drawAnswer, drawMoment, momentInWords } from "./answer-view";
import { CardView } from "./card-view";
import { byId, el, fill, svg } from "./dom";
import { FibreView } from "./fibre-view";
import { given, harmless, readFiles, standing, testsOf, type Incoming } from "./files";
import { ForceView } from "./force-view";
import { FrictionView } from "./friction-view";
import { closeDialog, listenToKeys, openKeys } from "./keys";
import { outputsOf } from "./outputs";
import { PassesView } from "./passes-view";
import { ParametersView } from "./parameters-view";
import { isAllowed, type Key } from "./parameters";
import { ProgrammeView } from "./programme-view";
import { RowsView } from "./rows-view";
import { ERROR_LINE, messageOf, Studio, type Topic } from "./studio";
import type { Test } from "./test";
import { drawPins, drawTests, openTests } from "./tests-view";
import { startTheme, turnTheme } from "./theme";
import { drawTour } from "./tour";
import { questionOf } from "./words";

const remembered = (name: string): string | null => {
  try {
    return localStorage.getItem(`flexslip-studio-${name}`);
  } catch {
    return null;  // from file:// or in private a browser may keep nothing
  }
};
const remember = (name: string, value: string): void => {
  try {
    localStorage.setItem(`flexslip-studio-${name}`, value);
  } catch {
    // likewise
  }
};

async function start(): Promise<void> {
  startTheme(remembered("theme"));
  const program = openProgram(), studio = new Studio(program, openMechanics());
  const force = new ForceView(studio), rows = new RowsView(studio), friction = new FrictionView(studio), fibre = new FibreView(studio);
  const programme = new ProgrammeView(studio), parameters = new ParametersView(studio), passes = new PassesView(studio), card = new CardView(studio);

  // ---- views
  const has = (topics: ReadonlySet<Topic>, ...of: Topic[]): boolean => of.some((topic) => topics.has(topic));
  let analysed = false;
  studio.listen(ERROR_LINE, ["error"], () => drawError(studio));
  studio.listen("The list of tests", ["tests", "fitting"], () => drawTests(studio));
  studio.listen("The line at the top", ["tests", "card", "view"], () => drawHead(studio));
  studio.listen("How the file was read", ["tests", "card", "fitting"], () => card.draw());
  studio.listen("The answer", ["answer", "tests", "fitting", "card"], (topics) => {
    if (has(topics, "answer", "tests") || !studio.fit) drawAnswer(studio);
    if (studio.fit && !analysed) {
      analysed = true;
      requestAnimationFrame(() => performance.mark("analysed"));  // for the benchmark
    }
  });
  studio.listen("Force", ["model", "axis", "pins", "theme", "view", "rows", "moment"], (topics) => {
    if (!has(topics, "model", "axis", "pins", "theme", "view", "rows")) return force.mark();
    force.draw();
    force.drawResiduals();
  });
  studio.listen("The rows", ["rows", "view", "moment"], (topics) => (has(topics, "rows", "view") ? rows.draw() : rows.mark()));
  studio.listen("Friction along the specimen", ["model", "view", "moment", "doubted"], (topics) => (has(topics, "model", "view") ? friction.draw() : friction.mark()));
  studio.listen("The line of the moment", ["moment", "model", "view"], () => drawMoment(studio));
  studio.listen("The specimen", ["moment", "model", "view"], () => fibre.draw());
  studio.listen("The programme", ["answer", "programme", "view", "card", "moment"], (topics) => (has(topics, "answer", "programme", "view", "card") ? programme.draw() : programme.mark()));
  studio.listen("The parameters", ["model", "parameters"], () => parameters.draw());
  studio.listen("The passes", ["answer", "tests", "view"], () => passes.draw());
  studio.listen("The line of the fit", ["model", "fitting", "progress", "parameters"], () => parameters.drawFit());
  studio.listen("The pinned curves", ["pins"], () => drawPins(studio));
  studio.listen("The first steps", ["tour", "view", "answer"], () => drawTour(studio));
  studio.listen("The buttons", null, () => {
    byId<HTMLButtonElement>("undo").disabled = !studio.canUndo;
    byId<HTMLButtonElement>("redo").disabled = !studio.canRedo;
    byId<HTMLButtonElement>("pin").disabled = !studio.loading;
    byId<HTMLButtonElement>("export").disabled = !studio.test;
  });
  studio.listen("The band of the draws", ["answer", "tests"], () => bandWhenAtRest(studio));
  let sized = 0;
  const watcher = new ResizeObserver(() => {
    cancelAnimationFrame(sized);
    sized = requestAnimationFrame(() => studio.tell("view"));
  });
  for (const id of ["force-plot", "friction-plot", "programme-plot", "boxes-plot"]) watcher.observe(byId(id));

  // ---- what comes in
  const refuse = (sentence: string): void => studio.report(sentence);
  const take = async (incoming: Incoming[], named?: string): Promise<void> => {
    await studio.open(...testsOf(incoming, named));
  };
  const showExample = async (): Promise<void> => take(standing("example"), EXAMPLE);
  const picker = byId<HTMLInputElement>("picker");
  picker.addEventListener("change", async () => {
    const list = [...(picker.files ?? [])];
    picker.value = "";
    await take(await readFiles(list, refuse));
  });
  byId("add").addEventListener("click", () => picker.click());
  const zone = byId("drop-here");
  let depth = 0;
  const isFile = (event: DragEvent): boolean => [...(event.dataTransfer?.types ?? [])].includes("Files");
  addEventListener("dragenter", (event) => {
    event.preventDefault();
    if (isFile(event)) ++depth, (zone.hidden = false);
  });
  addEventListener("dragleave", () => {
    if (--depth <= 0) (depth = 0), (zone.hidden = true);
  });
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", async (event) => {
    event.preventDefault();
    depth = 0;
    zone.hidden = true;
    await take(await readFiles([...(event.dataTransfer?.files ?? [])], refuse));
  });
  fill(byId("empty"), el("div", {}, el("h1", {}, "Drop a test anywhere"), el("p", { class: "say" }, "A CSV, text or Excel file with force and displacement, as the machine wrote it. Nothing leaves this computer."),
    el("p", {}, el("button", { class: "button outlined", click: () => picker.click() }, "Open a file…"), "  ", el("button", { class: "button", click: () => void showExample() }, "Show the example"))));

  // ---- what goes out
  const linkNow = async (): Promise<string | null> => {
    const { test, fit, values } = studio;
    if (!test) return null;
    const changed: Link["values"] = {};
    if (fit && values) for (const key of Object.keys(values) as Key[]) if (values[key] !== fit.fitted[key] && Number.isFinite(values[key])) changed[key] = values[key];
    const files = isExample(test.files) ? null : Object.entries(test.files).map(([name, bytes]) => ({ name, base64: base64Of(bytes) }));
    return addressOf({ files, main: test.main, data: test.data, settings: test.settings, values: changed, wave: fit && studio.wave !== fit.wave ? studio.wave : null, row: studio.row, axis: studio.axis, programme: studio.programme });
  };
  const menu = byId("menu"), opener = byId("export");
  const closeMenu = (): boolean => {
    if (menu.hidden) return false;
    menu.hidden = true;
    opener.setAttribute("aria-expanded", "false");
    return true;
  };
  opener.addEventListener("click", () => {
    if (closeMenu()) return;
    const link = async (): Promise<void> => {
      const address = await linkNow();
      if (!address) return studio.report(`The files of ${studio.test?.name ?? "this test"} are too large for an address; send them with the case file.`);
      history.replaceState(null, "", address);
      const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
      announce(copied ? "The link is in the address and on the clipboard." : "The link is in the address.");
      byId("fit-said").textContent = copied ? "Link copied" : "Link is in the address";
    };
    fill(menu, ...outputsOf(studio, link).map((output) => output === null ? el("hr") : el("button", { role: "menuitem", tabindex: -1, "data-command": output.command ?? null, click: async () => {
      closeMenu();
      opener.focus();
      try {
        await output.save();
      } catch (cause) {
        studio.report(`${output.title}: ${messageOf(cause)}`);
      }
    } }, output.title, el("small", {}, output.note))), el("p", { class: "note" }, "Everything is made here. Nothing is sent."));
    menu.hidden = false;
    opener.setAttribute("aria-expanded", "true");
    menu.querySelector("button")?.focus();
  });
  menu.addEventListener("keydown", (event) => {
    const items = [...menu.querySelectorAll("button")], at = items.indexOf(document.activeElement as HTMLButtonElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: items.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    items[(to + items.length) % items.length]?.focus();
  });
  addEventListener("click", (event) => {
    if (!(event.target as Element).closest(".holder")) closeMenu();
  });

  // ---- keys and buttons
  let said = 0;
  const announce = (words: string): void => {
    clearTimeout(said);
    said = window.setTimeout(() => (byId("announcer").textContent = words), 500);  // at most twice a second
  };
  const edge = (which: "first" | "last"): void => {
    studio.remember();
    rows.set(which, studio.row);
  };
  const theme = (): void => {
    turnTheme();
    remember("theme", document.documentElement.dataset["theme"]!);
    studio.tell("theme");
  };
  const tour = (): void => {
    studio.step = 0;
    studio.tell("tour");
  };
  listenToKeys({
    row: (by) => (studio.tried = null, studio.setRow(studio.row + by), studio.tell("moment"), announce(momentInWords(studio))),
    drop: (by) => (studio.tried = null, studio.toDrop(by), announce(momentInWords(studio))),
    play: () => programme.play(), fit: () => void studio.runFit(),
    escape: () => {
      if (closeDialog() || closeMenu()) return;
      if (studio.fitting) return studio.cancelFit(studio.isBusy(studio.test) ? studio.test : studio.fitting.test);
      if (studio.error) return studio.report("");
      if (studio.step >= 0) (studio.step = -1), studio.tell("tour");
    },
    reset: () => studio.reset(), pin: () => studio.pin(), first: () => edge("first"), last: () => edge("last"), test: (by) => studio.next(by), undo: () => studio.undo(), redo: () => studio.redo(),
    theme, help: () => openKeys(tour),
  });
  byId("fit-all").addEventListener("click", () => void studio.fitAll());
  byId("table-of-tests").addEventListener("click", () => openTests(studio));
  addEventListener("beforeunload", (event) => {
    const linked = location.hash.startsWith("#s=");  // the address brings its state back
    if (!linked && studio.tests.some((test) => isUnsaved(test))) event.preventDefault();
  });
  byId("undo").addEventListener("click", () => studio.undo());
  byId("redo").addEventListener("click", () => studio.redo());
  byId("pin").addEventListener("click", () => studio.pin());
  byId("theme").addEventListener("click", theme);
  byId("help").addEventListener("click", () => openKeys(tour));

  // ---- the first picture
  const openLink = async (): Promise<boolean> => {
    const link = await linkOf(location.hash);
    if (link === null) return false;
    if (link === "wrong") {
      studio.report("The address holds no state that this studio can read; it is left alone.");
      return false;
    }
    const incoming = link.files ? link.files.map((f) => ({ name: harmless(f.name), bytes: bytesOf(f.base64) })) : standing("example");
    const [test] = testsOf(incoming, link.files ? undefined : EXAMPLE);
    if (!test) return false;
    test.settings = link.settings;
    await studio.open(test);
    if (test.fit && studio.values && studio.test === test) {
      for (const p of test.fit.parameters) {
        const value = link.values[p.key];
        if (value !== undefined && isAllowed(p, value)) studio.values[p.key] = value;
      }
      if (link.wave !== null) studio.wave = link.wave;
      studio.axis = link.axis;
      const most = 3 * test.fit.greatestStage;
      studio.programme = link.programme?.every((stage) => stage <= most) ? link.programme : null;
      studio.tell("model", "parameters", "programme", "axis", "moment");
      if (link.row !== null) studio.setRow(link.row);
    }
    return true;
  };
  const tests = given();
  if (!(await openLink())) {
    const error = studio.error;
    if (tests.length) await studio.open(...tests);
    else {
      if (remembered("visited") === null) studio.step = 0;
      await showExample();
      remember("visited", "yes");
    }
    if (error && !studio.error) studio.report(error);
  }
  await studio.ready;
  addEventListener("hashchange", () => void openLink());
  document.body.dataset["ready"] = "yes";
}

const EXAMPLE = "simulated";  // the name that the example has in the repository
const isExample = (files: Record<string, Uint8Array>): boolean => {
  const example = standing("example");
  return example.length === Object.keys(files).length && example.every((f) => files[f.name]?.length === f.bytes.length && f.bytes.every((b, i) => files[f.name]![i] === b));
};

/** What would be lost with the page: files that were dropped and not taken out as they were fitted, and what was decided of the example. */
const isUnsaved = (test: Test): boolean => (isExample(test.files) ? Object.keys(test.settings).length > 1 || Object.keys(test.settings.read).length > 0 : test.fit === null || test.saved !== test.fit);

function drawError(studio: Studio): void {
  const host = byId("error");
  host.hidden = studio.error === "";
  if (host.hidden) return fill(host);
  fill(host, svg("svg", { width: 14, height: 14, "aria-hidden": "true" }, svg("path", { d: "M7 1.200 13.200 12.500H.8z", fill: "none", stroke: "currentColor", "stroke-width": 1.4 }), svg("path", { d: "M7 5v4M7 10.200v1.300", stroke: "currentColor", "stroke-width": 1.4 })),
    el("span", { title: studio.error }, studio.error), el("button", { class: "link", click: () => studio.report("") }, "Close"));
}

function drawHead(studio: Studio): void {
  const { test, fit } = studio;
  byId("empty").hidden = test !== null || studio.fitting !== null;
  // What stands beside the answer: nothing where there is none, the force where there is no friction, all where there is.
  const { classList } = document.body;
  classList.toggle("none", test === null);
  classList.toggle("asked", test !== null && questionOf(test) !== null);
  classList.toggle("answered", fit !== null && !isWithdrawn(fit.answer));
  classList.toggle("told", fit !== null && tellsFriction(fit.answer));
  classList.toggle("passed", fit !== null && !isWithdrawn(fit.answer) && fit.answer.passes?.status === "ok");
  document.title = test ? `${test.name} – FlexSlip studio` : "FlexSlip studio";
  if (!test) return fill(byId("what"));
  const m = fit?.answer.measurement;
  fill(byId("what"), el("b", {}, test.name), el("span", {}, m ? ` · rows ${m.first_row}–${m.last_row} of ${m.rows}` : ""));
}

/** The draws are run forward when nothing else is asked of the page. */
let waiting = 0;
function bandWhenAtRest(studio: Studio): void {
  clearTimeout(waiting);
  const fit = studio.fit;
  studio.bandReady = false;
  if (!fit || fit.answer.status !== "ok" || !tellsFriction(fit.answer) || !fit.friction.draws.length) return;
  waiting = window.setTimeout(() => {
    const later = window.requestIdleCallback ?? ((run: () => void) => window.setTimeout(run, 0));
    later(() => {
      if (studio.fit !== fit) return;
      try {
        studio.model.band(fit, 20);
        studio.bandReady = true;
        studio.tell("axis");
      } catch {
        // a draw that slips through has no band; the curve stands without it
      }
    });
  }, 250);
}

void start().catch((cause: unknown) => {
  // In the next frame: what was said before of the test that was to be opened is drawn by then.
  requestAnimationFrame(() => {
    const host = byId("error");
    host.hidden = false;
    host.textContent = `The studio could not start: ${messageOf(cause)}`;
  });
});
