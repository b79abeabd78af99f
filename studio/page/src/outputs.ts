// What can be taken out: what the program wrote, byte by byte, and the figures as they are drawn, in the light theme.

import { sentence } from "./answers";
import { byId, el, label, svg } from "./dom";
import { openDialog } from "./keys";
import { lightColours } from "./theme";
import type { Studio } from "./studio";
import { OUTPUTS, type Test } from "./test";

export interface Output { title: string; note: string; save: () => Promise<void> | void; command?: string }

export function download(name: string, data: BlobPart, type: string): void {
  const address = URL.createObjectURL(new Blob([data], { type })), link = document.createElement("a");
  link.href = address;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 30_000);
}

const FIGURE_WIDTH = 170;  // [mm] two columns of a journal
const DOTS = 300;          // [1/inch]

interface Drawn { text: string; width: number; height: number }

/** A drawing of the page by itself, its layers in one: colours resolved, without what marks the moment; with the title of its vertical axis, and its legend under its own. */
export function standalone(host: Element, title: string, legend: Element | null = null, yTitle = ""): Drawn {
  const [copy, ...layers] = [...host.querySelectorAll(":scope > svg")].map((layer) => layer.cloneNode(true) as SVGSVGElement) as [SVGSVGElement, ...SVGSVGElement[]];
  for (const layer of layers) copy.append(...layer.childNodes);
  copy.querySelectorAll(".marker").forEach((marker) => marker.remove());
  const entries = [...(legend?.children ?? [])].filter((entry) => entry.textContent), width = host.clientWidth, height = host.clientHeight, key = svg("g");
  let at = 8, line = 0;
  for (const entry of entries) {
    const mark = entry.querySelector("svg"), words = entry.textContent!, wide = (mark ? 26 : 0) + 6.2 * words.length;
    if (at > 8 && at + wide > width) (at = 8), ++line;
    key.append(svg("g", { transform: `translate(${at} ${18 * line - 8})` }, mark && svg("g", { transform: "translate(0 -10)" }, ...[...mark.cloneNode(true).childNodes] as SVGElement[]), svg("text", { x: mark ? 26 : 0 }, words)));
    at += wide + 18;
  }
  const above = yTitle ? 14 : 0, head = (entries.length ? 40 + 18 * line : 22) + above;
  key.setAttribute("transform", `translate(0 ${-18 * line - above})`);
  copy.append(key);
  if (yTitle) copy.append(label(yTitle, { x: 8, y: -4 }));
  for (const [name, value] of Object.entries({
    xmlns: "http://www.w3.org/2000/svg", viewBox: `0 ${-head} ${width} ${height + head}`, width: `${FIGURE_WIDTH}mm`, height: `${((FIGURE_WIDTH * (height + head)) / width).toFixed(2)}mm`, role: "img", "aria-label": title,
  })) copy.setAttribute(name, value);
  copy.removeAttribute("aria-hidden");
  const style = svg("style", {}, 'text{font:11px "Segoe UI","Helvetica Neue","Liberation Sans",Arial,sans-serif;fill:var(--ink2)}.quantity{font-family:"Liberation Serif",Georgia,serif;font-style:italic}');
  copy.prepend(style, svg("rect", { x: 0, y: -head, width, height: height + head, fill: "#ffffff" }), svg("text", { x: 8, y: 14 - head, "font-weight": 600 }, title));
  const colours = lightColours();
  const resolved = new XMLSerializer().serializeToString(copy).replace(/var\((--[\w-]+)\)/g, (_, name: string) => colours.get(name) ?? "#000");
  return { text: resolved, width, height: height + head };
}

async function pngOf(figure: Drawn): Promise<Blob> {
  const image = new Image(), address = URL.createObjectURL(new Blob([figure.text], { type: "image/svg+xml" }));
  image.src = address;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = Math.round((FIGURE_WIDTH / 25.4) * DOTS);
  canvas.height = Math.round((canvas.width * figure.height) / figure.width);
  canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(address);
  return await new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture is too large"))), "image/png"));
}

const YTITLES: Readonly<Record<string, string>> = { force: "*F*", friction: "friction *μ*" };
const FIGURES = [["force", "force-plot", "Force"], ["friction", "friction-plot", "Friction along the specimen"], ["specimen", "fibre-plot", "The specimen"], ["boxes", "boxes-plot", "Friction of each pass"]] as const;

async function copyCommand(command: string): Promise<void> {
  const copied = await navigator.clipboard?.writeText(command).then(() => true, () => false);
  openDialog(copied ? "Copied" : "Command", [el("p", {}, el("code", {}, command))]);
}

export function outputsOf(studio: Studio, link: () => Promise<void>): (Output | null)[] {
  const { test, fit } = studio;
  if (!test) return [];
  const command: Output = { title: "Copy as command", note: "for a shell", command: test.commandLine, save: () => copyCommand(test.commandLine) };
  if (!fit) return [command];
  const { name } = test, text = "text/plain;charset=utf-8", csv = "text/csv;charset=utf-8";
  const bytes = (file: string): BlobPart => (fit.files[file] ?? new Uint8Array()).slice();
  const drawings = (): [string, Drawn][] => FIGURES.filter(([, id]) => byId(id).clientHeight > 0).map(([part, id, title]) => [part, standalone(byId(id), `${name}: ${title}`, part === "force" ? byId("force-marks") : null, YTITLES[part] && `${YTITLES[part]} ${part === "force" ? byId("force-unit").textContent ?? "" : ""}`.trim())]);
  const figures = async (kind: "svg" | "png"): Promise<void> => {
    for (const [part, figure] of drawings())
      if (kind === "svg") download(`${name}-${part}.svg`, figure.text, "image/svg+xml");
      else download(`${name}-${part}.png`, await pngOf(figure), "image/png");
  };
  const saved = (output: Output): Output => ({ ...output, save: async () => {
    await output.save();
    test.saved = fit;
  } });
  const all: (Output | null)[] = [
    { title: "Report", note: "HTML, one file", save: async () => {
      const figures = Object.fromEntries(drawings().map(([part, { text }]) => [part, text])), html = await written(studio, test, ["--report", "report"], "report/report.html");
      download(`${name}-report.html`, withFigures(new TextDecoder().decode(html), figures), "text/html");
    } },
    { title: "Figures", note: "SVG, 170 mm", save: () => figures("svg") },
    { title: "Figures", note: "PNG, 300 dpi, 170 mm", save: () => figures("png") },
    null,
    { title: "Curves", note: "CSV", save: () => download(`${name}-curves.csv`, bytes(OUTPUTS.curves), csv) },
    { title: "Friction along the specimen", note: "CSV, with errors", save: () => download(`${name}-profile.csv`, bytes(OUTPUTS.profile), csv) },
    { title: "Workbook", note: "XLSX: answer, parameters, curves", save: async () => download(`${name}.xlsx`, (await written(studio, test, ["--xlsx", "fit.xlsx"], "fit.xlsx")).slice(), "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet") },
    { title: "All results", note: "JSON", save: () => download(`${name}.json`, fit.json, "application/json") },
    { title: "Case file", note: "TOML, runs in a shell", save: () => download(`${name}.toml`, fit.answer.provenance.case, text) },
    null,
    { title: "Link to this state", note: "in the address", save: link },
  ];
  return [...all.map((output) => output && saved(output)), command];
}

/** The report with the page's figures in it, and without links to files that are not beside it. */
export function withFigures(html: string, figures: Record<string, string>): string {
  const drawn = (block: string): string => {
    const name = /figures\/(\w+)\.gp/.exec(block)?.[1] ?? "", part = name === "profile" ? "friction" : name, figure = figures[part];
    if (!figure) return "";  // what the page does not draw
    const inPage = figure.replace(/^<svg([^>]*?) width="[^"]*"/, '<svg$1 width="100%"').replace(/^<svg([^>]*?) height="[^"]*"/, "<svg$1");
    return `<figure><div class="plate">${inPage}</div><figcaption>${CAPTIONS[part] ?? ""}</figcaption></figure>`;
  };
  return html.replace(/<figure[^>]*>[^]*?<\/figure>/g, drawn).replace(/<p class="files">[^]*?<\/p>/g, "").replace(/<a href="(?!#|https?:)[^"]*">([^]*?)<\/a>/g, "$1");
}
const CAPTIONS: Readonly<Record<string, string>> = {
  force: "Force as measured, and as the model has it. Dashed: Euler–Bernoulli; dotted: without friction. Marks: the drops, with their load lines.",
  friction: "Friction along the specimen: points inverted from the force, with the errors of its noise. Line and band: the fit, with its 95 % interval. Bars: the slips.",
  boxes: "Mobilised friction of each pass against the length slid over one support, at the bending stiffness of the fit. The specimen slides in along +μ, sticks while the stage turns back, and slides out along −μ. Grey: it sticks there, or only one pass came this far.",
};

/** A file that the program writes beside the answer, with these flags more. */
async function written(studio: Studio, test: Test, flags: string[], file: string): Promise<Uint8Array> {
  const commands = test.commands(), args = commands[commands.length - 1]!, lane = studio.program.another();
  try {
    let files = test.files;
    if (commands.length > 1) files = { ...files, ...(await lane.run(commands[0]!, files)).files };
    const answer = await lane.run([...args, ...flags, "--quiet"], files), bytes = answer.files[file];
    if (!bytes) throw new Error(sentence(answer.err));
    return bytes;
  } finally {
    lane.cancel();
  }
}
