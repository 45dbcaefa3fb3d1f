/** What drives the laws and components of a fit beside their motion: columns of the record, or values that hold them. */

import { field } from "./choices";
import { h } from "./dom";
import { parsed, short, unitText, words } from "./format";
import type { State } from "./link";
import type { Drive, Fittable } from "./types";

export class Drives {
  constructor(
    private readonly fitted: Fittable[],
    private readonly state: State,
  ) {}

  private get chosen(): Fittable[] {
    return this.fitted.filter(({ name }) => this.state.laws.includes(name));
  }

  /** Each once, of whatever is chosen. */
  private get all(): Drive[] {
    return [...new Map(this.chosen.flatMap(({ drives }) => drives).map((drive) => [drive.name, drive])).values()];
  }

  /** Whether a normal force presses this model together, as every law and no component. */
  isLaw(model: string): boolean {
    return this.fitted.some(({ name, has_load }) => name === model && has_load);
  }

  /** Whether nothing is chosen but laws. */
  get areLaws(): boolean {
    return this.chosen.every(({ has_load }) => has_load);
  }

  /** Whether a normal force is needed. */
  get hasLoad(): boolean {
    return this.areLaws || this.chosen.some(({ has_load }) => has_load);
  }

  /** Texts that differ where something else is read from a record. */
  get key(): string {
    return [this.hasLoad, ...this.all.map(({ name }) => name)].join();
  }

  /** Names of values in the state. */
  get names(): string[] {
    return this.all.map(({ name }) => `held.${name}`);
  }

  /** Drops values that were held for others. */
  forget(): void {
    for (const name of Object.keys(this.state.set)) {
      if (name.startsWith("held.") && !this.names.includes(name)) delete this.state.set[name];
    }
  }

  /** Values that are held, as entries of the option `fix`. */
  get fixed(): string[] {
    return this.all.flatMap(({ name }) => {
      const text = this.state.set[`held.${name}`];
      if (text === undefined) return [];
      const value = parsed(text);
      if (value === undefined) throw new RangeError(`${name} = '${text}': must be a number`);
      return [`${name}=${value}`];
    });
  }

  /** What a record of components has to have, in words. */
  get wanted(): string {
    const columns = this.all.map(({ name, units: [unit] }) => `, ${name} [${unitText(unit)}]`);
    const names = this.chosen.filter(({ has_load }) => !has_load).map(({ name }) => name);
    return `The virtual rig has friction laws only: drop a record of ${names.join(", ")}, with time, force, displacement or velocity${columns.join("")}.`;
  }

  /** A field for each, with what it is without a value there; those of a body that turns have other units. */
  fields(turns: boolean, changed: () => void): HTMLElement[] {
    const { all } = this;
    if (all.length === 0) return [];
    const unit = ({ units }: Drive) => unitText(units[turns ? 1 : 0]);
    const without = ({ usual }: Drive) => (usual === null ? "" : `, ${short(usual)} without it`);
    const columns = all.map((drive) => `${drive.name} [${unit(drive)}]${without(drive)}`).join("; ");
    return [
      ...all.map((drive) => this.field(drive, unit(drive), changed)),
      h("p", { class: "note" }, `Columns of the record: ${columns}. A value here is held instead of a column.`),
    ];
  }

  private field({ name, usual, help }: Drive, unit: string, changed: () => void): HTMLElement {
    const key = `held.${name}`;
    const change = (text: string) => {
      if (text === "") delete this.state.set[key];
      else this.state.set[key] = text;
      changed();
    };
    const row = field(words(name), `held-${name}`, this.state.set[key] ?? "", unit, usual ?? "column", change);
    row.title = help;
    return row;
  }
}
