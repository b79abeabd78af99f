// The keyboard, and the dialog that says what it does.

import { byId, el, fill } from "./dom";

export const KEYS_IN_WORDS: [string[], string][] = [
  [["←", "→"], "previous, next row"], [["Shift ←", "Shift →"], "previous, next drop"], [["Space"], "play, pause"], [["F"], "fit"], [["Esc"], "cancel the fit, or close"],
  [["R"], "parameters back to the last fit"], [["P"], "pin the curve"], [["[", "]"], "first, last row used: here"], [["J", "K"], "next, previous test"], [["Ctrl Z"], "undo; with Shift redo"],
  [["D"], "light or dark"], [["?"], "these keys"],
];

export interface Commands {
  row(by: number): void; drop(by: 1 | -1): void; play(): void; fit(): void; escape(): void; reset(): void; pin(): void;
  first(): void; last(): void; test(by: 1 | -1): void; undo(): void; redo(): void; theme(): void; help(): void;
}

export function listenToKeys(commands: Commands): void {
  addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement, typing = target.matches("input:not([type=range]):not([type=checkbox]), select, textarea");
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if ((event.ctrlKey || event.metaKey) && key === "z" && !typing) {
      event.preventDefault();
      if (event.shiftKey) commands.redo();
      else commands.undo();
      return;
    }
    if (event.key === "Escape") return commands.escape();
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const inMenu = target.closest("[role=menu], #tests") !== null;
    const act: Record<string, () => void> = {
      ArrowRight: () => (event.shiftKey ? commands.drop(1) : commands.row(1)), ArrowLeft: () => (event.shiftKey ? commands.drop(-1) : commands.row(-1)),
      f: commands.fit, r: commands.reset, p: commands.pin, "[": commands.first, "]": commands.last, j: () => commands.test(1), k: () => commands.test(-1), d: commands.theme, "?": commands.help,
    };
    if (key === " " && !target.matches("button, input, summary, [role=switch]")) act[" "] = commands.play;
    const run = inMenu && key.startsWith("Arrow") ? undefined : act[key];
    if (!run) return;
    event.preventDefault();
    run();
  });
}

let before: HTMLElement | null = null;

/** A dialog over the page, closed by Esc, by its button or beside it. */
export function openDialog(title: string, content: Node[], buttons: [string, () => void][] = []): void {
  const host = byId("dialog");
  before = document.activeElement as HTMLElement | null;
  const box = el("div", { role: "dialog", "aria-modal": "true", "aria-label": title, tabindex: -1 }, el("h2", {}, title), ...content);
  const foot = el("p", {}, ...buttons.flatMap(([words, run]) => [el("button", { class: "link", click: () => {
    closeDialog();
    run();
  } }, words), "   "]), el("button", { class: "link", click: closeDialog }, "Close"));
  box.append(foot);
  // Tab stays inside while it is open.
  box.addEventListener("keydown", (event) => {
    if (event.key !== "Tab") return;
    const stops = [...box.querySelectorAll<HTMLElement>("button")], at = stops.indexOf(document.activeElement as HTMLElement);
    event.preventDefault();
    stops[(at + (event.shiftKey ? stops.length - 1 : 1)) % stops.length]?.focus();
  });
  fill(host, box);
  host.hidden = false;
  host.onclick = (event) => {
    if (event.target === host) closeDialog();
  };
  box.focus();
}
export function closeDialog(): boolean {
  const host = byId("dialog");
  if (host.hidden) return false;
  host.hidden = true;
  fill(host);
  before?.focus();
  return true;
}
export function openKeys(tour: () => void): void {
  openDialog("Keys", [el("dl", {}, ...KEYS_IN_WORDS.flatMap(([keys, words]) => [el("dt", {}, ...keys.flatMap((k) => [el("kbd", {}, k), " "])), el("dd", {}, words)]))], [["Show the first steps", tour]]);
}
