/** Elements in short. */

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: any) => void)>;

/** An element with attributes, listeners (`onclick`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((child): child is Node | string => child instanceof Node || !!child));
  return element;
}

/** A short line, or a cross, as it is drawn for a law: colour, dashes and style. */
export function swatch(law: number, dash: string, style = ""): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const set = (element: Element, attributes: Record<string, string | number | boolean>) =>
    Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, String(value)));
  set(svg, { width: 34, height: 10, "aria-hidden": true, class: `swatch ${style}` });
  const path = document.createElementNS(svg.namespaceURI, "path");
  const d = style === "crosses" ? "M13 1l8 8m0 -8l-8 8" : "M1 5h32";
  set(path, { d, class: `law-${law + 1}`, "stroke-dasharray": dash });
  svg.append(path);
  return svg;
}

/** Offers a file. */
export function save(name: string, content: Blob | string, type = "text/plain"): void {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  const link = h("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Announces a text to screen readers, once. */
export function say(text: string): void {
  const live = document.getElementById("live");
  if (live) live.textContent = text;
}
