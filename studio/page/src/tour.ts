// The first visit: short steps that follow the verdict. They cover nothing, come once, and return under ?.

import { isWithdrawn, slipOf, tellsFriction } from "./answer";
import { byId, el, fill, rich } from "./dom";
import type { Studio } from "./studio";

/** The steps of the test that is open; *italic*, and ^what to do^ in bold. */
function steps(studio: Studio): [string, string][] {
  const fit = studio.fit?.answer;
  if (!fit || isWithdrawn(fit)) return [];
  const { drops, verdict } = fit, first: [string, string] = ["The answer", "Above the curve: the verdict, the numbers behind it, and what to do next. ^Drag along the curve^ to read each row."];
  const impossible = drops.filter((drop) => slipOf(drop) === "no").length;
  if (!tellsFriction(fit)) return [first, ...(impossible ? [["Drops that cannot be slips", `A triangle marks a drop that no slip explains: here ${impossible} of ${drops.length}.`] as [string, string]] : [])];
  const uneven = studio.fit?.wave ? "amplitude *A*" : "roughness", cautious = verdict.code === "slip" ? "In this model no crack is needed." : "Uneven friction can make drops; that does not exclude cracks.";
  return [
    first,
    ...(drops.length ? [["What a drop shows", "In a drop the stage stands still, so every drop follows the load line, whatever caused it. ^Drag the handle of load train^: on a stiffer one, drops become fewer and smaller."], ["Uneven friction", `^Drag the handle of ${uneven} to 0.^ The drops disappear, the curve stays. ${cautious}`]] as [string, string][] : []),
    ["Lost stiffness", "A crack leaves the specimen softer. ^Drag the handle of stiffness *EI* down^: the curve sinks."],
    ["The test that decides", "A reload measures the lost stiffness. ^Add unload and reload^, and drag its points."],
  ];
}

export function drawTour(studio: Studio): void {
  const host = byId("tour"), all = steps(studio), { step } = studio;
  host.hidden = step < 0 || !all[step];
  if (host.hidden) return;
  const [title, words] = all[step]!;
  const go = (to: number): void => {
    studio.step = to >= all.length ? -1 : to;
    studio.tell("tour");
    if (studio.step >= 0) requestAnimationFrame(() => host.querySelector<HTMLElement>("[data-next]")?.focus());
  };
  fill(host, el("b", {}, title), el("p", {}, ...words.split("^").map((part, i) => (i % 2 ? el("b", {}, rich(part)) : rich(part)))),
    el("div", { class: "turn" }, ...all.map((_, i) => el("span", { class: `bead${i === step ? " on" : ""}` })), el("span", { class: "note" }, `${step + 1} of ${all.length}`), el("span", { class: "space" }),
      el("button", { class: "link", click: () => go(-1) }, "Close"), step > 0 ? el("button", { class: "link", click: () => go(step - 1) }, "Back") : null,
      el("button", { class: "link", "data-next": "", click: () => go(step + 1) }, step < all.length - 1 ? "Next" : "Done")));
}
