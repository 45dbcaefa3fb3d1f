/** The page: views, link, undo, theme. */

import { Bench, type Page } from "./bench";
import { FitView } from "./fit";
import { LawView } from "./law";
import { BENCH, STRUT } from "./layouts";
import { h, say } from "./dom";
import { Lane } from "./engine";
import { faultText } from "./controls";
import { defaults, fromHash, type State, toHash, type View, VIEWS } from "./link";
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

interface Shown {
  root: HTMLElement;
  show(): Promise<void>;
}

const NAMES: Record<View, string> = { bench: "Bench", law: "Law", strut: "Strut", fit: "Fit" };

/** Copies the address of the page. */
async function copyLink(event: Event): Promise<void> {
  const button = event.currentTarget as HTMLButtonElement;
  try {
    await navigator.clipboard.writeText(location.href);
    button.textContent = "Link copied";
    say("Link copied");
  } catch {
    button.textContent = "Copy the address";
  }
  setTimeout(() => (button.textContent = "Copy link"), 2500);
}

/** The views, of which one is shown; each keeps its state. */
class Views {
  now: View = "bench";
  readonly states = Object.fromEntries(VIEWS.map((view) => [view, defaults(view)])) as Record<View, State>;
  private readonly made = new Map<View, Shown>();
  private readonly buttons = new Map<View, HTMLButtonElement>();

  constructor(
    private readonly page: Page,
    nav: HTMLElement,
  ) {
    for (const view of VIEWS) {
      const button = h("button", { type: "button", id: `to-${view}`, onclick: () => this.open(view) }, NAMES[view]);
      this.buttons.set(view, button);
      nav.append(button);
    }
  }

  get hash(): string {
    return toHash({ view: this.now, state: this.states[this.now] });
  }

  private make(view: View): Shown {
    const state = this.states[view];
    if (view === "law") return new LawView(this.page, state);
    if (view === "fit") return new FitView(this.page, state);
    return new Bench(this.page, state, view === "strut" ? STRUT : BENCH);
  }

  /** Shows a view as it was left. */
  private async open(view: View): Promise<void> {
    this.now = view;
    this.page.changed(true);
    await this.show();
  }

  async show(): Promise<void> {
    for (const [view, button] of this.buttons) {
      if (view === this.now) button.setAttribute("aria-current", "page");
      else button.removeAttribute("aria-current");
    }
    const shown = this.made.get(this.now) ?? this.make(this.now);
    this.made.set(this.now, shown);
    this.page.fault("");
    document.querySelector("main")!.replaceChildren(fault, shown.root);
    document.title = `Stribeck: ${NAMES[this.now].toLowerCase()}`;
    await shown.show();
  }
}

function wrong(faults: string[]): void {
  if (faults.length > 0) show(`The link was not understood in full: ${faults.join("; ")}`);
}

/** The buttons of the heading, and the keys for undo and redo. */
function heedButtons(step: (to: "undo" | "redo") => void): void {
  document.getElementById("undo")?.addEventListener("click", () => step("undo"));
  document.getElementById("redo")?.addEventListener("click", () => step("redo"));
  document.getElementById("copy-link")?.addEventListener("click", copyLink);
  document.getElementById("theme")?.addEventListener("click", toggleTheme);
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (event.target instanceof HTMLInputElement && event.target.type === "text") return;
    event.preventDefault();
    step(event.shiftKey ? "redo" : "undo");
  });
}

/** Shows links in the address of the page. */
function addressWriter(): (hash: string, isLast: boolean) => void {
  let shownAt = 0;
  return (hash, isLast) => {
    // A browser refuses to do so too often while a slider moves; the last change is always shown.
    if (!isLast && performance.now() - shownAt <= 100) return;
    window.history.replaceState(null, "", hash || location.pathname + location.search);
    shownAt = performance.now();
  };
}

async function start(): Promise<void> {
  const { answer: catalogue } = await new Lane().ask<Catalogue>({ ask: "catalogue" });
  setPalette(catalogue.palette);
  const write = addressWriter();
  const page: Page = {
    catalogue,
    changed(isLast) {
      write(views.hash, isLast);
      if (isLast) history.keep(views.hash);
    },
    fault: show,
  };
  const views = new Views(page, document.getElementById("views")!);
  const open = async (hash: string) => {
    const { view, state, faults } = fromHash(hash);
    views.now = view;
    Object.assign(views.states[view], state);
    page.changed(false);
    await views.show();
    wrong(faults);
  };
  const first = fromHash(location.hash);
  const history = new History(toHash(first));
  const step = (to: "undo" | "redo") => {
    const hash = history.step(to);
    if (hash !== undefined) void open(hash);
    else say(`Nothing to ${to}`);
  };
  heedButtons(step);
  const keep = (hash: string) => {
    history.keep(hash);
    void open(hash);
  };
  const reset = () => keep(toHash({ view: views.now, state: defaults(views.now) }));
  document.getElementById("reset")?.addEventListener("click", reset);
  window.addEventListener("hashchange", () => keep(location.hash));
  document.getElementById("version")!.textContent = catalogue.version;
  await open(location.hash);
}

start().catch((reason) => {
  document.querySelector("main")!.replaceChildren(fault);
  show(`This page cannot start: ${faultText(reason)}`);
});
