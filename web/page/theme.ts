/** Light or dark, and the colours of the laws. */

import type { Catalogue, Colours } from "./types";

const media = matchMedia("(prefers-color-scheme: dark)");
const listeners: (() => void)[] = [];
let chosen: "light" | "dark" | undefined;
let palette: Catalogue["palette"] | undefined;

const still = matchMedia("(prefers-reduced-motion: reduce)");

/** Whether the user wants nothing to move by itself. */
export function isMotionReduced(): boolean {
  return still.matches;
}

export function isDark(): boolean {
  return chosen === undefined ? media.matches : chosen === "dark";
}

/** The colours of the present theme. */
export function colours(): Colours {
  if (!palette) throw new Error("the palette comes with the catalogue");
  return isDark() ? palette.dark : palette.light;
}

export function dashes(): string[] {
  return palette?.dashes ?? [];
}

/** Calls when light has become dark or the reverse. */
export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

export function toggleTheme(): void {
  chosen = isDark() ? "light" : "dark";
  apply();
}

function apply(): void {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  const { paper, ink, grid, axis, laws } = colours();
  const style = document.documentElement.style;
  for (const [name, colour] of Object.entries({ paper, ink, grid, axis })) style.setProperty(`--${name}`, colour);
  laws.forEach((colour, law) => style.setProperty(`--law-${law + 1}`, colour));
  listeners.forEach((listener) => listener());
}

export function setPalette(given: Catalogue["palette"]): void {
  palette = given;
  apply();
}

media.addEventListener("change", () => palette && apply());
