/** Texts of the laws that lie in this page. */

import { decompress } from "fzstd";

export interface Text {
  html: string;
  /** A velocity that includes all features of the curve, m/s. */
  velocity: number;
  /** A stroke that shows how the contact begins to slide, m; null if the force does not depend on displacement. */
  stroke: number | null;
}

/** Content of an element that is packed with zstd. */
export function unpacked(id: string): Uint8Array<ArrayBuffer> {
  const packed = document.getElementById(id)?.textContent?.trim() ?? "";
  return decompress(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))) as Uint8Array<ArrayBuffer>;
}

let known: Record<string, Text> | undefined;

/** The text of a law. */
export function textOf(law: string): Text | undefined {
  known ??= JSON.parse(new TextDecoder().decode(unpacked("texts"))) as Record<string, Text>;
  return known[law];
}

const symbols = new Map<string, Map<string, Element>>();

/** The symbols of a law by the names of its variables, from the tables of its text; without those that share a row. */
export function symbolsOf(law: string): Map<string, Element> {
  let found = symbols.get(law);
  if (found) return found;
  found = new Map();
  const text = new DOMParser().parseFromString(textOf(law)?.html ?? "", "text/html");
  for (const row of text.querySelectorAll("tr")) {
    const symbol = row.cells[0]?.querySelector("math");
    const names = row.cells[1]?.querySelectorAll("code") ?? [];
    if (symbol && names.length === 1) found.set(names[0]!.textContent, symbol);
  }
  symbols.set(law, found);
  return found;
}
