/** Choice of laws, system and solver. */

import { h, swatch } from "./dom";
import type { State } from "./link";
import { dashes } from "./theme";
import type { Catalogue, Model, SystemEntry } from "./types";

/** The model of this name. */
export function modelOf({ laws, hosts, shock_absorber, components }: Catalogue, name: string): Model | undefined {
  return [...laws, ...hosts, ...shock_absorber, ...components].find((model) => model.name === name);
}

/** A list with a label. */
export function select(
  label: string,
  id: string,
  now: string,
  options: { name: string; text: string }[],
  change: (name: string) => void,
): HTMLElement {
  const known = options.some(({ name }) => name === now) ? options : [{ name: now, text: now }, ...options];
  const list = h("select", { id }, ...known.map(({ name, text }) => h("option", { value: name }, text)));
  list.value = now;
  list.addEventListener("change", () => change(list.value));
  return h("div", { class: "choice" }, h("label", { for: id }, label), list);
}

/** A field for a number with a label; `usual` stands in it while it is empty. */
export function field(
  label: string,
  id: string,
  now: string,
  unit: string,
  usual: number | string | undefined,
  change: (text: string) => void,
): HTMLElement {
  const input = h("input", { id, type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false" });
  input.value = now;
  input.placeholder = usual === undefined ? "" : String(usual);
  input.addEventListener("change", () => change(input.value.trim()));
  return h("div", { class: "choice" }, h("label", { for: id }, label), input, h("span", { class: "unit" }, unit));
}

const has = (model: Model, meaning: string) => model.variables.some((variable) => variable.meaning === meaning);
/** Whether no normal force presses a model together. */
const isComponent = (model: Model) => !has(model, "NormalForce");

/** Laws by their inputs: without memory they need the external force at rest, in the plane a second velocity. */
export function families(laws: Model[]): [string, Model[]][] {
  const components = laws.filter(isComponent);
  const flat = laws.filter((model) => has(model, "VelocityY"));
  const instant = laws.filter((model) => has(model, "ExternalForce"));
  const others = laws.filter((model) => ![...components, ...flat, ...instant].includes(model));
  return [
    ["Static: force from the velocity", instant],
    ["Dynamic: with memory", others],
    ["In the plane and in space", flat],
    ["Components: without a normal force", components],
  ];
}

/** The chosen laws, each with a cross, and a list by families to choose from, which can be searched. */
export class LawPicker {
  readonly root: HTMLElement;
  private readonly chips = h("ul", { class: "chips" });
  private readonly boxes = new Map<string, HTMLInputElement>();

  constructor(
    private readonly view: string,
    laws: Model[],
    private readonly state: State,
    private readonly changed: () => void,
  ) {
    const search = h("input", { type: "text", id: `find-law-${view}`, autocomplete: "off", spellcheck: "false" });
    const lists = families(laws).filter(([, some]) => some.length > 0).map(([title, some]) => this.family(title, some));
    search.addEventListener("input", () => this.filter(search.value, lists));
    this.root = h(
      "div",
      { class: "laws" },
      h("strong", {}, laws.some(isComponent) ? "Friction laws and components" : "Friction laws"),
      this.chips,
      h(
        "details",
        { class: "picker" },
        h("summary", { id: `add-law-${view}` }, `Choose laws, at most ${dashes().length}`),
        h("label", { for: search.id }, "Search"),
        search,
        h("div", { class: "families", tabindex: 0, role: "region", "aria-label": "All laws" }, ...lists),
      ),
    );
  }

  private family(title: string, laws: Model[]): HTMLElement {
    const rows = laws.map(({ name, summary }) => {
      const box = h("input", { type: "checkbox", id: `law-${this.view}-${name}` });
      box.addEventListener("change", () => this.toggle(name, box.checked));
      this.boxes.set(name, box);
      return h("div", { class: "law", "data-law": `${name} ${summary}` }, box, h("label", { for: box.id }, h("b", {}, name), ` ${summary}`));
    });
    return h("fieldset", {}, h("legend", {}, title), ...rows);
  }

  private filter(text: string, lists: HTMLElement[]): void {
    const wanted = text.trim().toLowerCase();
    for (const list of lists) {
      const rows = [...list.querySelectorAll<HTMLElement>(".law")];
      for (const row of rows) row.hidden = !row.dataset.law!.toLowerCase().includes(wanted);
      list.hidden = rows.every((row) => row.hidden);
    }
  }

  private toggle(name: string, isOn: boolean): void {
    const others = this.state.laws.filter((law) => law !== name);
    this.state.laws = isOn ? [...others, name] : others;
    this.changed();
  }

  /** Shows which laws are chosen. */
  show(): void {
    const { laws } = this.state;
    const chips = laws.map((name, law) => {
      const remove = () => this.toggle(name, false);
      const cross = h("button", { type: "button", class: "small", "aria-label": `Remove ${name}`, onclick: remove }, "\u00d7");
      cross.disabled = laws.length === 1;
      return h("li", { class: "chip" }, swatch(law, dashes()[law] ?? ""), h("span", {}, name), cross);
    });
    this.chips.replaceChildren(...chips);
    for (const [name, box] of this.boxes) {
      box.checked = laws.includes(name);
      box.disabled = box.checked ? laws.length === 1 : laws.length >= dashes().length;
    }
  }
}

/** System and solver. */
export class RunChoices {
  readonly root = h("div", { class: "choices" });

  constructor(
    private readonly catalogue: Catalogue,
    private readonly systems: SystemEntry[],
    private readonly state: State,
    private readonly view: string,
    /** Another system was chosen. */
    private readonly moved: () => void,
    /** The system is solved in another way. */
    private readonly changed: () => void,
  ) {}

  show(): void {
    const { state, view } = this;
    const system = this.systems.find(({ name }) => name === state.system);
    const systems = this.systems.map(({ name, title }) => ({ name, text: title }));
    const solvers = this.catalogue.solvers.map(({ name, help }) => ({ name, text: `${name}: ${help}` }));
    const number = (label: string, name: "tol" | "until" | "every", unit: string, usual: number | undefined) =>
      field(label, `${name}-${view}`, state[name], unit, usual, (text) => {
        state[name] = text;
        this.changed();
      });
    this.root.replaceChildren(
      select("System", `system-${view}`, state.system, systems, (name) => {
        state.system = name;
        state.set = {};
        this.moved();
      }),
      h("p", { class: "note" }, system?.source ?? ""),
      h(
        "details",
        { class: "solver", open: Boolean(state.tol || state.until || state.every || state.check || state.solver !== "auto") },
        h("summary", {}, "Solver"),
        select("Solver", `solver-${view}`, state.solver, solvers, (name) => {
          state.solver = name;
          this.changed();
        }),
        number("Tolerance", "tol", "", 1e-8),
        number("End", "until", "s", system?.until),
        number("Interval", "every", "s", system?.every),
        this.check(),
      ),
    );
  }

  /** Whether each run is repeated at a tenth of the tolerance, or of the step. */
  private check(): HTMLElement {
    const { state, view } = this;
    const box = h("input", { type: "checkbox", id: `check-${view}`, checked: state.check });
    box.addEventListener("change", () => {
      state.check = box.checked;
      this.changed();
    });
    return h("div", { class: "check" }, box, h("label", { for: box.id }, "Check by a run at a tenth of the tolerance"));
  }
}
