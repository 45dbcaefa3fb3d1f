/** The page: views, link, undo, theme. */

import { Bench, type Page } from "./bench";
import { h, say } from "./dom";
import { Lane } from "./engine";
import { faultText } from "./controls";
import { fromHash, toHash } from "./link";
import { setPalette, toggleTheme } from "./theme";
import type { Catalogue } from "./types";

const fault = h("p", { id: "fault", role: "alert", hidden: true });

function show(text: string): void {
  fault.textContent = text;
  fault.hidden = text === "";
}

/** States that were left, to go back to. */
class History {
  private readonly past: string[] = [];
  private future: string[] = [];

  constructor(private now: string) {}

  /** A state that the user may want to come back to. */
  keep(hash: string): void {
    if (hash === this.now) return;
    this.past.push(this.now);
    this.now = hash;
    this.future = [];
  }

  step(to: "undo" | "redo"): string | undefined {
    const [from, other] = to === "undo" ? [this.past, this.future] : [this.future, this.past];
    const hash = from.pop();
    if (hash === undefined) return undefined;
    other.push(this.now);
    return (this.now = hash);
  }
}

async function start(): Promise<void> {
  const { answer: catalogue } = await new Lane().ask<Catalogue>({ ask: "catalogue" });
  setPalette(catalogue.palette);
  const { state, faults } = fromHash(location.hash);
  const history = new History(toHash(state));
  const page: Page = {
    catalogue,
    state,
    changed(isLast) {
      const hash = toHash(state);
      window.history.replaceState(null, "", hash || location.pathname + location.search);
      if (isLast) history.keep(hash);
    },
    fault: show,
  };
  const bench = new Bench(page);
  const open = async (hash: string) => {
    const { state: next, faults } = fromHash(hash);
    Object.assign(state, next);
    page.changed(false);
    await bench.show();
    if (faults.length > 0) show(`The link was not understood in full: ${faults.join("; ")}`);
  };
  const step = (to: "undo" | "redo") => {
    const hash = history.step(to);
    if (hash === undefined) say(`Nothing to ${to}`);
    else void open(hash);
  };
  document.getElementById("undo")?.addEventListener("click", () => step("undo"));
  document.getElementById("redo")?.addEventListener("click", () => step("redo"));
  document.getElementById("reset")?.addEventListener("click", () => {
    history.keep("");
    void open("");
  });
  document.getElementById("theme")?.addEventListener("click", toggleTheme);
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (event.target instanceof HTMLInputElement && event.target.type === "text") return;
    event.preventDefault();
    step(event.shiftKey ? "redo" : "undo");
  });
  window.addEventListener("hashchange", () => {
    history.keep(location.hash);
    void open(location.hash);
  });
  document.getElementById("version")!.textContent = catalogue.version;
  document.querySelector("main")!.replaceChildren(fault, bench.root);
  await bench.show();
  if (faults.length > 0) show(`The link was not understood in full: ${faults.join("; ")}`);
}

start().catch((reason) => {
  document.querySelector("main")!.replaceChildren(fault);
  show(`This page cannot start: ${faultText(reason)}`);
});
