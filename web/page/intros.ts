/** What each view shows, and what to try in it. */

import { h } from "./dom";
import type { View } from "./link";

const INTROS: Record<View, [shows: string, tries: string]> = {
  bench: ["What laws of friction make of one and the same machine.", "raise mu_k to mu_s, and stick-slip ends; add a law to compare."],
  law: ["One law: its force at constant velocities, its loops, its equations.", "move a parameter, and see what it changes."],
  strut: ["A telescopic strut on a test rig: side load makes it rub at rod guide and piston.", "set side_force_m to 0, then to 400 N."],
  fit: ["A law fitted to a record: what the record tells of its parameters.", "fit another law than that of the rig, or a record of your own."],
};

/** The line on a view. */
export function intro(view: View): HTMLElement {
  const [shows, tries] = INTROS[view];
  return h("p", { class: "intro" }, `${shows} `, h("strong", {}, "Try:"), ` ${tries}`);
}
