/** Texts of the laws that lie in this page. */

export interface Text {
  html: string;
  /** A velocity that includes all features of the curve, m/s. */
  velocity: number;
  /** A stroke that shows how the contact begins to slide, m; null if the force does not depend on displacement. */
  stroke: number | null;
}

/** What was packed with gzip into an element. */
export function unpacked(id: string): Response {
  const packed = document.getElementById(id)?.textContent?.trim() ?? "";
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}

let known: Promise<Record<string, Text>> | undefined;

/** The text of a law. */
export async function textOf(law: string): Promise<Text | undefined> {
  known ??= unpacked("texts").json();
  return (await known)[law];
}
