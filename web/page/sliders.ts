/** Groups of controls. */

import { control, type Setting } from "./controls";
import { h } from "./dom";
import { words } from "./format";
import type { State } from "./link";
import { symbolsOf } from "./texts";
import type { Model, Variable } from "./types";

/** Settings of a part, perhaps with presets for them. */
export interface Group {
  part: string;
  settings: Setting[];
  /** Models whose presets set variables of this part. */
  models?: Model[];
}

/** Number of settings of one kind above which they are shown on demand only (chosen). */
const MANY = 16;

const isStart = ({ role }: Variable) => role === "State" || role === "StateOutput";

/** Controls of the values in a state. */
export class Sliders {
  readonly root = h("div", { class: "sliders" });

  constructor(
    private readonly state: State,
    /** A value was changed; `isLast` is false while a slider moves. */
    private readonly changed: (isLast: boolean) => void,
    /** Shows all controls again, after a preset. */
    private readonly again: () => void,
  ) {}

  show(groups: Group[]): void {
    // Which lists are open is up to the user.
    const open = new Set([...this.root.querySelectorAll("details[open]")].map((one) => one.getAttribute("data-title")));
    this.root.replaceChildren(...groups.map((group) => this.group(group)));
    for (const list of this.root.querySelectorAll("details")) if (open.has(list.dataset.title ?? null)) list.open = true;
  }

  /** Start values and choices come last, and many parameters only on demand, by the first word of their names. */
  private group({ part, settings, models = [] }: Group): HTMLElement {
    const symbol = (name: string) => models.map((model) => symbolsOf(model.name).get(name)).find(Boolean);
    const row = (setting: Setting) => this.row({ ...setting, symbol: symbol(setting.variable.name) });
    const first = settings.filter(({ variable }) => !isStart(variable) && variable.kind === "real");
    const rest = settings.filter((setting) => !first.includes(setting));
    const isSet = ({ name }: Setting) => this.state.set[name] !== undefined;
    const more = (title: string, some: Setting[]) =>
      some.length > 0 &&
      h("details", { open: some.some(isSet), "data-title": `${part}: ${title}` }, h("summary", {}, title), ...some.map(row));
    const choices = rest.filter(({ variable }) => !isStart(variable));
    const listed =
      first.length <= MANY
        ? [...first.map(row), more("Choices", choices)]
        : byFirstWord([...first, ...choices]).map(([title, some]) => (title ? more(title, some) : h("div", {}, ...some.map(row))));
    return h(
      "fieldset",
      { "data-part": part },
      h("legend", {}, words(part)),
      ...models.map((model) => this.presets(part, model)),
      ...listed,
      more("Start values", rest.filter(({ variable }) => isStart(variable))),
    );
  }

  /** A list of the presets of a model. */
  private presets(part: string, model: Model): HTMLElement | false {
    if (model.presets.length === 0) return false;
    const id = `preset-${part}-${model.name}`;
    const holds = ({ values }: { values: Record<string, string> }) =>
      Object.entries(values).every(([name, value]) => this.state.set[`${part}.${name}`] === value);
    const now = model.presets.find((preset) => Object.keys(preset.values).length > 0 && holds(preset));
    const list = h(
      "select",
      { id },
      h("option", { value: "" }, now ? "Start values" : "Choose \u2026"),
      ...model.presets.map(({ name, source }) => h("option", { value: name, title: source }, `${name}: ${source}`)),
    );
    list.value = now?.name ?? "";
    list.addEventListener("change", () => {
      const named = (name: string) => model.variables.some((variable) => `${part}.${variable.name}` === name);
      for (const name of Object.keys(this.state.set)) if (named(name)) delete this.state.set[name];
      const chosen = model.presets.find(({ name }) => name === list.value);
      for (const [name, value] of Object.entries(chosen?.values ?? {})) this.state.set[`${part}.${name}`] = value;
      this.changed(true);
      this.again();
    });
    return h("div", { class: "choice" }, h("label", { for: id }, `Preset of ${model.name}`), list);
  }

  private row(setting: Setting): HTMLElement {
    const { set } = this.state;
    const row = control(setting, set[setting.name], (text, isLast) => {
      if (text === undefined) delete this.state.set[setting.name];
      else this.state.set[setting.name] = text;
      const undo = row.querySelector<HTMLButtonElement>(".undo");
      if (undo) undo.hidden = text === undefined;
      row.dataset.set = String(text !== undefined);
      if (text === undefined) this.replace(row, setting);
      this.changed(isLast);
    });
    return row;
  }

  /** A control at its start value again; the keyboard stays where it was. */
  private replace(row: HTMLElement, setting: Setting): void {
    if (document.activeElement instanceof HTMLInputElement && document.activeElement.type === "range") return;
    const hadFocus = row.contains(document.activeElement);
    const fresh = this.row(setting);
    row.replaceWith(fresh);
    if (hadFocus) fresh.querySelector<HTMLElement>("input, select")?.focus();
  }
}

/** Settings by the first word of their variable's name; those of one word come first. */
function byFirstWord(settings: Setting[]): [string, Setting[]][] {
  const groups = new Map<string, Setting[]>([["", []]]);
  for (const setting of settings) {
    const [word, ...others] = setting.variable.name.split(".");
    const title = others.length > 0 ? words(word!) : "";
    groups.set(title, [...(groups.get(title) ?? []), setting]);
  }
  return [...groups].filter(([, some]) => some.length > 0);
}
