// Elements, made without markup: every word goes in as text, so that nothing of a file or an address is ever read as HTML.

export type Child = Node | string | number | null | undefined | false;
type Properties = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

const SVG = "http://www.w3.org/2000/svg";

function furnish(element: Element, properties: Properties, children: Child[]): void {
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  add(element, ...children);
}

export function add(parent: Element, ...children: Child[]): void {
  for (const child of children)
    if (child instanceof Node) parent.append(child);
    else if (child !== null && child !== undefined && child !== false) parent.append(document.createTextNode(String(child)));
}

/** An element of HTML; a property that is a function listens to the event of that name. */
export function el<K extends keyof HTMLElementTagNameMap>(tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  furnish(element, properties, children);
  return element;
}

/** Likewise of SVG. */
export function svg<K extends keyof SVGElementTagNameMap>(tag: K, properties: Properties = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag) as SVGElementTagNameMap[K];
  furnish(element, properties, children);
  return element;
}

export function fill(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  add(parent, ...children);
}

/** Our own words with *quantities* in italics and _indices_ below the line. Not for words of others: these are text. */
export function rich(words: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  for (const part of words.split(/(\*[^*]+\*|_[^_]+_)/)) {
    if (/^\*[^*]+\*$/.test(part)) fragment.append(el("i", {}, part.slice(1, -1)));
    else if (/^_[^_]+_$/.test(part)) fragment.append(el("sub", {}, part.slice(1, -1)));
    else if (part) fragment.append(part);
  }
  return fragment;
}

/** The same words without marks, for labels that are read aloud. */
export const plain = (words: string): string => words.replace(/[*_]/g, "");

/** Words of SVG with *quantities* in the italics of the page. */
export function label(words: string, properties: Properties = {}): SVGTextElement {
  const text = svg("text", properties);
  for (const part of words.split(/(\*[^*]+\*)/))
    if (/^\*[^*]+\*$/.test(part)) text.append(svg("tspan", { class: "quantity" }, part.slice(1, -1)));
    else if (part) text.append(part);
  return text;
}

/** The element with this id, which stands in the page. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element #${id}`);
  return found as T;
}
