/** Controls of variables: a slider with a number field, a choice or a switch, from the table. */

import { h } from "./dom";
import { parsed, short, unitText } from "./format";
import { Refused } from "./engine";
import type { Variable } from "./types";

const STEPS = 1000;

/** Conversion between positions of a slider and values. */
interface Scale {
  value(place: number): number;
  place(value: number): number;
}

function between(low: number, high: number, whole: boolean): Scale {
  const rounded = (value: number) => (whole ? Math.round(value) : Number(value.toPrecision(5)));
  return {
    value: (place) => rounded(low + (place / STEPS) * (high - low)),
    place: (value) => Math.round(((value - low) / (high - low)) * STEPS),
  };
}

/** A logarithmic scale around a positive value. */
function powers(middle: number, decades: number): Scale {
  const low = Math.log10(middle) - decades;
  return {
    value: (place) => Number((10 ** (low + (place / STEPS) * 2 * decades)).toPrecision(4)),
    place: (value) => (value > 0 ? Math.round(((Math.log10(value) - low) / (2 * decades)) * STEPS) : 0),
  };
}

/** The range of a slider is for the hand; the number field takes whatever the bound admits. */
function scaleOf(variable: Variable, start: number): Scale {
  const { minimum, maximum, kind, unit, nominal } = variable;
  if (minimum !== null && maximum !== null) return between(minimum > 1e-200 ? minimum : 0, maximum, kind === "integer");
  const size = Math.abs(start) || nominal || 1;
  if (minimum === null && maximum === null) return between(-5 * size, 5 * size, kind === "integer");
  if (minimum === null) return between(maximum! - 10 * size, maximum!, kind === "integer");
  if (kind === "integer") return between(minimum, minimum + 5 * Math.max(size, 2), true);
  if (unit === "1") return between(minimum > 1e-200 ? minimum : 0, Math.max(minimum, 0) + 5 * size, false);
  return start > 0 ? powers(start, 2) : between(minimum > 1e-200 ? minimum : 0, Math.max(minimum, 0) + 5 * size, false);
}

export interface Setting {
  /** Name with its part, as in a link. */
  name: string;
  variable: Variable;
  /** The value without a setting. */
  start: number;
  /** Laws that have the variable, if not all do. */
  laws?: string[];
  /** Its symbol in the equations. */
  symbol?: Element;
}

/** The text of a value: the name of a choice, true or false, or a number. */
export function spelled(variable: Variable, value: number): string {
  if (variable.kind === "choice") return variable.choices[value - 1]?.name ?? String(value);
  if (variable.kind === "boolean") return value === 0 ? "false" : "true";
  return String(value);
}

/** Why a number is refused by its bound; none if it is admitted. */
export function refusal(variable: Variable, text: string): string | undefined {
  const { kind, minimum, maximum, bound, name } = variable;
  if (kind === "choice" || kind === "boolean") return undefined;
  const number = parsed(text);
  if (number === undefined) return `${name} = '${text}': must be a number`;
  const isInside = (minimum === null || number >= minimum) && (maximum === null || number <= maximum);
  const isWhole = kind !== "integer" || Number.isInteger(number);
  return isInside && isWhole ? undefined : `${name} = ${text}: must be ${isWhole ? bound : "a whole number"}`;
}

/**
 * The control of a variable. `change` gets the text of a value, or none for the start value; `isLast` is false while a
 * slider moves.
 */
export function control(
  { name, variable, start, laws, symbol }: Setting,
  text: string | undefined,
  change: (text: string | undefined, isLast: boolean) => void,
): HTMLElement {
  const id = `set-${name.replace(/[^\w-]/g, "_")}`;
  const help = `${variable.help} ${variable.bound ? `Must be ${variable.bound}.` : ""}`;
  const label = h("label", { for: id, title: help }, variable.name.split(".").at(-1) ?? "");
  // The name of the field says it already.
  const sign = symbol && h("span", { class: "symbol", "aria-hidden": "true" }, symbol.cloneNode(true));
  const meaning = h("p", { class: "meaning", id: `${id}-meaning` }, variable.help.replace(/\.$/, ""));
  const of = laws && h("small", { class: "of" }, laws.join(", "));
  const give = (given: string, isLast: boolean) => change(given === spelled(variable, start) ? undefined : given, isLast);
  const now = text ?? spelled(variable, start);
  const row = h("div", { class: "control", "data-name": name, "data-set": text !== undefined });
  const undo = h("button", { type: "button", class: "small undo", onclick: () => change(undefined, true) }, "\u21ba");
  undo.setAttribute("aria-label", `${variable.name}: back to ${spelled(variable, start)}`);
  undo.hidden = text === undefined;
  row.append(h("div", { class: "name" }, label, sign, of, undo), meaning);
  if (variable.kind === "choice" || variable.kind === "boolean") {
    row.append(choice(id, variable, now, help, give));
  } else {
    row.append(number(id, variable, scaleOf(variable, start), now, help, give));
  }
  row.querySelector(`[id="${id}"]`)!.setAttribute("aria-describedby", meaning.id);
  return row;
}

/** A slider, and a field for values beyond its ends. */
function number(
  id: string,
  variable: Variable,
  scale: Scale,
  now: string,
  help: string,
  give: (text: string, isLast: boolean) => void,
): HTMLElement {
  const unit = unitText(variable.unit);
  const slider = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": variable.name });
  const field = h("input", { id, type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", title: help });
  const show = (text: string) => {
    const value = parsed(text);
    if (value !== undefined) slider.value = String(scale.place(value));
    slider.setAttribute("aria-valuetext", `${value === undefined ? text : short(value)} ${unit}`);
    field.value = text;
    if (refusal(variable, text)) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
  };
  show(now);
  const moved = (isLast: boolean) => {
    show(String(scale.value(Number(slider.value))));
    give(field.value, isLast);
  };
  slider.addEventListener("input", () => moved(false));
  slider.addEventListener("change", () => moved(true));
  field.addEventListener("change", () => {
    show(field.value);
    give(field.value.trim(), true);
  });
  return h("div", { class: "value" }, slider, field, h("span", { class: "unit" }, unit));
}

function choice(
  id: string,
  variable: Variable,
  now: string,
  help: string,
  give: (text: string, isLast: boolean) => void,
): HTMLElement {
  const options = variable.kind === "boolean" ? [{ name: "false" }, { name: "true" }] : variable.choices;
  const select = h("select", { id, title: help }, ...options.map(({ name }) => h("option", { value: name }, name)));
  select.value = now;
  select.addEventListener("change", () => give(select.value, true));
  return select;
}

/** The text of a fault, for the line of messages. */
export function faultText(fault: unknown): string {
  if (fault instanceof Refused || fault instanceof RangeError) return fault.message;
  return fault instanceof Error ? `${fault.name}: ${fault.message}` : String(fault);
}
