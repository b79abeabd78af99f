// Sheets of an Excel workbook (.xlsx: XML in a ZIP) as CSV, by what the browser has: DecompressionStream and DOMParser. Values only; formulas keep their last result.

const MOST_UNPACKED = 200e6;  // [bytes] of one part: what is packed tighter than any sheet is refused

interface Part { offset: number; packed: number; unpacked: number; method: number }

function directory(bytes: Uint8Array): Map<string, Part> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), parts = new Map<string, Part>();
  let end = bytes.length - 22;
  while (end >= 0 && end > bytes.length - 66000 && view.getUint32(end, true) !== 0x06054b50) --end;
  if (end < 0 || view.getUint32(end, true) !== 0x06054b50) throw new Error("it is no Excel workbook");
  let at = view.getUint32(end + 16, true);
  for (let n = view.getUint16(end + 10, true); n > 0; --n) {
    if (at + 46 > bytes.length || view.getUint32(at, true) !== 0x02014b50) throw new Error("the workbook is damaged");
    const name = view.getUint16(at + 28, true), extra = view.getUint16(at + 30, true), comment = view.getUint16(at + 32, true);
    parts.set(new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + name)), { method: view.getUint16(at + 10, true), packed: view.getUint32(at + 20, true), unpacked: view.getUint32(at + 24, true), offset: view.getUint32(at + 42, true) });
    at += 46 + name + extra + comment;
  }
  return parts;
}

async function textOf(bytes: Uint8Array, part: Part): Promise<string> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (part.unpacked > MOST_UNPACKED) throw new Error("a sheet of the workbook is too large");
  const begin = part.offset + 30 + view.getUint16(part.offset + 26, true) + view.getUint16(part.offset + 28, true), data = bytes.subarray(begin, begin + part.packed);
  if (part.method === 0) return new TextDecoder().decode(data);
  if (part.method !== 8) throw new Error("the workbook is packed in an unknown way");
  const stream = new Blob([data.slice()]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const reader = stream.getReader(), decoder = new TextDecoder();
  let text = "";
  for (let size = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    size += value.length;
    if (size > MOST_UNPACKED) throw new Error("a sheet of the workbook is too large");
    text += decoder.decode(value, { stream: true });
  }
}

const parsed = (text: string): Document => {
  const document = new DOMParser().parseFromString(text, "application/xml");
  if (document.getElementsByTagName("parsererror").length) throw new Error("a sheet of the workbook is damaged");
  return document;
};
const columnOf = (reference: string): number => [.../^[A-Z]*/.exec(reference)![0]].reduce((n, c) => 26 * n + c.charCodeAt(0) - 64, 0) - 1;
const cell = (words: string): string => (/[",\n\r]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words);

export async function sheetsToCsv(bytes: Uint8Array): Promise<{ name: string; csv: string }[]> {
  const parts = directory(bytes), shared: string[] = [];
  const strings = parts.get("xl/sharedStrings.xml");
  if (strings) for (const item of parsed(await textOf(bytes, strings)).getElementsByTagName("si")) shared.push([...item.getElementsByTagName("t")].map((t) => t.textContent ?? "").join(""));
  const book = parts.get("xl/workbook.xml"), names = book ? [...parsed(await textOf(bytes, book)).getElementsByTagName("sheet")].map((s) => s.getAttribute("name") ?? "") : [];
  const sheets: { name: string; csv: string }[] = [];
  const order = [...parts.keys()].filter((n) => /^xl\/worksheets\/sheet\d+\.xml$/.test(n)).sort((a, b) => Number(/\d+/.exec(a)![0]) - Number(/\d+/.exec(b)![0]));
  for (const [i, name] of order.entries()) {
    const lines: string[] = [];
    for (const row of parsed(await textOf(bytes, parts.get(name)!)).getElementsByTagName("row")) {
      const cells: string[] = [];
      for (const c of row.getElementsByTagName("c")) {
        const at = c.hasAttribute("r") ? columnOf(c.getAttribute("r")!) : cells.length, value = c.getElementsByTagName("v")[0]?.textContent ?? "", type = c.getAttribute("t");
        if (at > 500) continue;
        while (cells.length < at) cells.push("");
        cells[at] = cell(type === "s" ? (shared[Number(value)] ?? "") : type === "inlineStr" ? (c.textContent ?? "") : value);
      }
      lines.push(cells.join(","));
    }
    if (lines.length > 1) sheets.push({ name: order.length > 1 ? (names[i] ?? `sheet ${i + 1}`) : "", csv: `${lines.join("\n")}\n` });
  }
  if (!sheets.length) throw new Error("no sheet of the workbook has rows");
  return sheets;
}
