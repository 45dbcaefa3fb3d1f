/** Runs of the chosen laws, each in a worker of its own. */

import { faultText } from "./controls";
import { h } from "./dom";
import { Lane, Superseded } from "./engine";
import type { Run, Solved } from "./types";

export interface Outcome {
  law: string;
  solved: Solved;
  arrays: Float64Array[];
  took: number;
}

export class Runs {
  readonly root = h("p", { class: "progress", role: "status" });
  readonly outcomes = new Map<string, Outcome>();
  private readonly lanes: Lane[] = [];
  private readonly running = new Set<string>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    /** An outcome has come, or the runs were stopped. */
    private readonly changed: () => void,
    private readonly fault: (text: string) => void,
  ) {}

  get count(): number {
    return this.running.size;
  }

  /** Runs every law; replaces runs in progress. */
  start(laws: string[], asked: Partial<Run>): void {
    for (const name of this.outcomes.keys()) if (!laws.includes(name)) this.outcomes.delete(name);
    this.lanes.slice(laws.length).forEach((lane) => lane.stop());
    this.running.clear();
    laws.forEach((law, number) => {
      this.running.add(law);
      const lane = (this.lanes[number] ??= new Lane());
      lane.ask<Solved>({ ask: "solve", run: asked, law }).then(
        ({ answer, arrays, took }) => this.done(law, { law, solved: answer, arrays, took }),
        (fault) => {
          if (fault instanceof Superseded) return;
          this.done(law, undefined);
          this.fault(faultText(fault));
        },
      );
    });
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.tell(), 400);
  }

  private done(law: string, outcome: Outcome | undefined): void {
    this.running.delete(law);
    if (outcome) this.outcomes.set(law, outcome);
    else this.outcomes.delete(law);
    if (this.running.size === 0) this.tell();
    this.changed();
  }

  private tell(): void {
    clearTimeout(this.timer);
    const names = [...this.running];
    if (names.length === 0) {
      if (this.root.hasChildNodes()) this.root.replaceChildren();
      return;
    }
    const since = Math.min(...this.lanes.map((lane) => lane.since ?? Infinity));
    const seconds = Number.isFinite(since) ? ` for ${((performance.now() - since) / 1000).toFixed(0)} s` : "";
    const stop = h("button", { type: "button", class: "small", onclick: () => this.giveUp() }, "Stop");
    this.root.replaceChildren(`Computing ${names.join(", ")}${seconds} \u2026 `, stop);
    this.timer = setTimeout(() => this.tell(), 1000);
  }

  /** Gives up whatever is under way. */
  stop(): void {
    this.lanes.forEach((lane) => lane.stop());
    this.running.clear();
    this.tell();
  }

  private giveUp(): void {
    const names = [...this.running].join(", ");
    this.stop();
    this.fault(`Stopped: ${names}`);
    this.changed();
  }
}
