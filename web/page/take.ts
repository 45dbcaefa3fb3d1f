/** Export: link, files, and the same run elsewhere. */

import { faultText } from "./controls";
import { h, say } from "./dom";
import { Lane } from "./engine";
import type { Job, Written } from "./types";

const WORDS = { command: "Command line", python: "Python" };

export interface Item {
  text: string;
  id: string;
  does: () => unknown;
  /** Whether there is something to export; always without it. */
  isReady?: () => boolean;
}

/** A row of buttons, with a field for text that cannot be copied. */
export class TakeAway {
  readonly root: HTMLElement;
  private readonly output: HTMLOutputElement;
  private readonly questions = new Lane();
  private readonly buttons: [HTMLButtonElement, Item][];

  constructor(
    view: string,
    items: (take: TakeAway) => Item[],
    private readonly fault: (text: string) => void,
  ) {
    this.output = h("output", { id: `copied-${view}`, class: "copied" });
    this.buttons = items(this).map((item) => [
      h("button", { type: "button", id: `${view}-${item.id}`, onclick: () => this.run(item.does) }, item.text),
      item,
    ]);
    this.root = h(
      "section",
      { class: "take", "aria-label": "Export" },
      h("h2", {}, "Export"),
      h("div", { class: "buttons" }, ...this.buttons.map(([button]) => button)),
      this.output,
    );
    this.heed();
  }

  /** Turns buttons off that have nothing to export. */
  heed(): void {
    for (const [button, { isReady }] of this.buttons) button.disabled = isReady !== undefined && !isReady();
  }

  private run(does: () => unknown): void {
    // An earlier copy must not be taken for this one.
    delete this.output.dataset.text;
    this.output.textContent = "";
    Promise.resolve().then(does).catch((fault) => this.fault(faultText(fault)));
  }

  /** Copies a text that does the same elsewhere. */
  async copyOf(ask: "command" | "python", job: Job): Promise<void> {
    const { answer } = await this.questions.ask<Written>({ ask, job });
    await this.copy(WORDS[ask], answer.text);
  }

  /** Copies a text; where the browser does not let it, shows it to be copied by hand. */
  async copy(what: string, text: string): Promise<void> {
    this.output.dataset.text = text;
    try {
      await navigator.clipboard.writeText(text);
      say(`${what} copied`);
      this.output.textContent = `${what} copied.`;
    } catch {
      this.output.textContent = text;
    }
  }
}
