// What can be taken out: what the program wrote, byte by byte, and the figures as they are drawn, in the light theme.

import { sentence } from "./answers";
import { byId } from "./dom";
import { lightColours } from "./theme";
import type { Studio } from "./studio";
import { OUTPUTS, type Fit, type Test } from "./test";

export interface Output { title: string; note: string; save: () => Promise<void> | void; after?: boolean }

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

/** A drawing of the page by itself, its layers in one: colours resolved, without what marks the moment. */
export function standalone(host: Element, title: string): { text: string; width: number; height: number } {
  const [copy, ...layers] = [...host.querySelectorAll(":scope > svg")].map((layer) => layer.cloneNode(true) as SVGSVGElement) as [SVGSVGElement, ...SVGSVGElement[]];
  for (const layer of layers) copy.append(...layer.childNodes);
  copy.querySelectorAll(".marker").forEach((marker) => marker.remove());
  const width = host.clientWidth, height = host.clientHeight, head = 22;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("viewBox", `0 ${-head} ${width} ${height + head}`);
  copy.setAttribute("width", `${FIGURE_WIDTH}mm`);
  copy.setAttribute("height", `${((FIGURE_WIDTH * (height + head)) / width).toFixed(2)}mm`);
  copy.removeAttribute("aria-hidden");
  const text = document.createElementNS("http://www.w3.org/2000/svg", "text");
  text.setAttribute("x", "8");
  text.setAttribute("y", "-6");
  text.setAttribute("font-weight", "600");
  text.textContent = title;
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of Object.entries({ x: 0, y: -head, width, height: height + head, fill: "#ffffff" })) ground.setAttribute(name, String(value));
  const style = document.createElementNS("http://www.w3.org/2000/svg", "style");
  style.textContent = 'text{font:11px "Segoe UI","Helvetica Neue","Liberation Sans",Arial,sans-serif;fill:var(--ink2)}.quantity{font-family:"Liberation Serif",Georgia,serif;font-style:italic}';
  copy.prepend(style, ground, text);
  const colours = lightColours();
  const resolved = new XMLSerializer().serializeToString(copy).replace(/var\((--[\w-]+)\)/g, (_, name: string) => colours.get(name) ?? "#000");
  return { text: resolved, width, height: height + head };
}

async function pngOf(figure: { text: string; width: number; height: number }): Promise<Blob> {
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

const FIGURES = [["force", "force-plot", "Force"], ["friction", "friction-plot", "Friction along the fibre"], ["fibre", "fibre-plot", "The fibre"]] as const;

/** A case that simulates what the sliders say, to be run with the table of friction beside it: the page's curve, bit by bit. */
export function simulationOf(studio: Studio, test: Test, fit: Fit): { toml: string; friction: string; curve: string } {
  studio.settle();
  studio.flush();
  const values = studio.values!, rig = studio.model.rig(fit, values, studio.wave), loading = studio.loading!;
  const programme = [0, fit.greatestStage], step = studio.model.stepOf(programme);
  const toml = [
    `# What the sliders of the studio said of ${test.name.replace(/[\r\n]/g, " ")}: flexslip simulate ${test.name}-model.toml`,
    "[specimen]", ...(values.D > 0 ? [`diameter = "${values.D} m"`] : []), `bending_stiffness = "${values.EI} N m^2"`, "",
    "[rig]", `span = "${values.L} m"`, `stiffness = "${Number.isFinite(values.kc) ? `${values.kc} N/m` : "inf"}"`, ...(values.R > 0 ? [`roller_radius = "${values.R} m"`] : []), "",
    "[friction]", 'model = "table"', `file = ${JSON.stringify(`${test.name}-friction.csv`)}`, 'length = "length [m]"', "",
    "[stage]", `program = [${programme.map((s) => `"${s} m"`).join(", ")}]`, `step = "${step} m"`, "",
  ].join("\n");
  const friction = ["length [m],mu", ...Array.from(rig.friction.length, (S, i) => `${S},${rig.friction.mu[i]}`)].join("\n") + "\n";
  const curve = ["w_s [m],w [m],F [N]", ...Array.from(loading.stage, (s, i) => `${s},${loading.deflection[i]},${loading.force[i]}`)].join("\n") + "\n";
  return { toml, friction, curve };
}

export function outputsOf(studio: Studio, link: () => Promise<void>): (Output | null)[] {
  const { test, fit } = studio;
  if (!test || !fit) return [];
  const { name } = test, text = "text/plain;charset=utf-8", csv = "text/csv;charset=utf-8";
  const bytes = (file: string): BlobPart => (fit.files[file] ?? new Uint8Array()).slice();
  const figures = async (kind: "svg" | "png"): Promise<void> => {
    for (const [part, id, title] of FIGURES) {
      const unit = part === "force" ? `, ${byId("force-unit").textContent ?? ""}` : "";
      const figure = standalone(byId(id), `${name}: ${title}${unit}`);
      if (kind === "svg") download(`${name}-${part}.svg`, figure.text, "image/svg+xml");
      else download(`${name}-${part}.png`, await pngOf(figure), "image/png");
    }
  };
  return [
    { title: "Report", note: "HTML, one file", save: () => report(studio, test) },
    { title: "Figures", note: "SVG, 170 mm", save: () => figures("svg") },
    { title: "Figures", note: "PNG, 300 dpi, 170 mm", save: () => figures("png") },
    null,
    { title: "Curves", note: "CSV", save: () => download(`${name}-curves.csv`, bytes(OUTPUTS.curves), csv) },
    { title: "Profile of friction", note: "CSV, with errors", save: () => download(`${name}-profile.csv`, bytes(OUTPUTS.profile), csv) },
    { title: "Mean and draws", note: "CSV", save: () => download(`${name}-draws.csv`, bytes(OUTPUTS.draws), csv) },
    { title: "All results", note: "JSON", save: () => download(`${name}.json`, fit.json, "application/json") },
    { title: "Case file", note: "TOML, runs in a shell", save: () => download(`${name}.toml`, fit.answer.provenance.case, text) },
    { title: "Model as it stands", note: "TOML and CSV, to simulate", save: () => {
      const files = simulationOf(studio, test, fit);
      download(`${name}-model.toml`, files.toml, text);
      download(`${name}-friction.csv`, files.friction, csv);
      download(`${name}-model.csv`, files.curve, csv);
    } },
    null,
    { title: "Link to this state", note: "in the address", save: link },
  ];
}

async function report(studio: Studio, test: Test): Promise<void> {
  const commands = test.commands(), args = commands[commands.length - 1]!;
  let files = test.files;
  if (commands.length > 1) files = { ...files, ...(await studio.program.run(commands[0]!, files)).files };
  const answer = await studio.program.run([...args, "--report", "report", "--quiet"], files);
  const page = answer.files["report/report.html"];
  if (!page) return studio.report(`The report could not be written: ${sentence(answer.err)}`);
  download(`${test.name}-report.html`, page.slice(), "text/html");
}
