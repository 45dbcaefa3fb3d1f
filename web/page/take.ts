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
}

/** A row of buttons, with a field for text that cannot be copied. */
export class TakeAway {
  readonly root: HTMLElement;
  private readonly output: HTMLOutputElement;
  private readonly questions = new Lane();

  constructor(
    view: string,
    items: (take: TakeAway) => Item[],
    private readonly fault: (text: string) => void,
  ) {
    this.output = h("output", { id: `copied-${view}`, class: "copied" });
    const button = ({ text, id, does }: Item) =>
      h("button", { type: "button", id: `${view}-${id}`, onclick: () => this.run(does) }, text);
    this.root = h(
      "section",
      { class: "take", "aria-label": "Export" },
      h("h2", {}, "Export"),
      h("div", { class: "buttons" }, ...items(this).map(button)),
      this.output,
    );
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
