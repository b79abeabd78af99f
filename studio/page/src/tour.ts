// The first visit: five short steps, each with one thing to drag. They cover nothing, come once, and return under ?.

import { byId, el, fill, rich } from "./dom";
import type { Studio } from "./studio";

/** The steps of the test that is open; *italic*, and ^what to do^ in bold. */
function steps(studio: Studio): [string, string][] {
  const drops = studio.fit?.answer.drops.length ?? 0, times = drops === 1 ? "once" : `${drops} times`;
  const uneven = studio.fit?.wave ? "amplitude *A*" : "roughness";
  return [
    ["Is this toughness?", `The force drops ${times}. A crack could do that; so could a slip over the supports. ^Drag along the curve^ and watch the fibre.`],
    ["What a drop says", "In a drop the stage stands still, so every drop runs down the load line, whatever caused it. ^Drag load train^: stiffer, and drops get fewer and smaller."],
    ["Uneven friction is enough", `^Drag ${uneven} to 0.^ The teeth go, the curve stays. No crack was needed.`],
    ["What a crack would look like", "A crack leaves the fibre softer for good. ^Drag stiffness *EI* down^: the curve sinks. A crack does so from its drop on, and reloading shows it."],
    ["The test that decides", "^Add unload and reload^, and drag its points. If the slope comes back, no stiffness was lost."],
  ];
}

export function drawTour(studio: Studio): void {
  const host = byId("tour"), all = steps(studio), { step } = studio;
  const narrow = matchMedia("(max-width: 1100px)").matches, home = byId(narrow ? "left" : "right");
  if (host.parentElement !== home) home.append(host);
  host.hidden = step < 0 || !studio.fit;
  if (host.hidden) return;
  const [title, words] = all[step]!;
  if (step === all.length - 1) byId("programme").scrollIntoView({ block: "nearest" });
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
