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
