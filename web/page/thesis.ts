/** Tables of the thesis, computed here and now. */

import type { Page } from "./bench";
import { faultText } from "./controls";
import { h } from "./dom";
import { Lane } from "./engine";
import { defaults, toHash } from "./link";
import type { Solved } from "./types";

const HEADING = "Table 6.5 of the thesis, computed here";

/** A run on the belt, and the median of its times in ms: the first run of a worker also prepares the library. */
async function timed(lane: Lane, law: string, solver: string): Promise<{ took: number; solved: Solved }> {
  const runs = [];
  for (let number = 0; number < 3; number++) {
    runs.push(await lane.ask<Solved>({ ask: "solve", run: { system: "belt", law: [law], solver }, law }));
  }
  return { took: runs.map((run) => run.took).sort((a, b) => a - b)[1]!, solved: runs[0]!.answer };
}

/** A row of the table: the law, its times with the solvers of this page, its events, and its times in the thesis. */
async function rowOf(lane: Lane, law: string, solvers: string[], printed: (number | null)[]): Promise<HTMLElement> {
  const cells = [];
  let events = "";
  for (const solver of solvers) {
    const { took, solved } = await timed(lane, law, solver);
    cells.push(solved.reached ? took.toFixed(1) : solved.end);
    events = String(solved.events.length);
  }
  const theirs = printed.map((time) => (time === null ? "DNC" : time.toFixed(4)));
  return h("tr", {}, h("th", { scope: "row" }, law), ...[...cells, events, ...theirs].map((cell) => h("td", {}, cell)));
}

/** Times of the laws of Table 6.5 with the solvers of this page, beside those of the thesis. */
export function thesisTables({ catalogue, fault }: Page): HTMLElement {
  const { classes, times } = catalogue.thesis;
  const solvers = catalogue.solvers.map(({ name }) => name).filter((name) => name.startsWith("ro"));
  const head = ["Law", ...solvers.map((name) => `${name}, ms`), "Events", ...classes.map((name) => `Thesis, ${name}, s`)];
  const body = h("tbody", {});
  const caption = h("caption", {}, "The belt of Table 6.1 over 40 s; DNC: did not converge");
  const headings = h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text))));
  const table = h("table", {}, caption, headings, body);
  const lane = new Lane();
  const compute = h("button", { type: "button", id: "compute-thesis" }, "Compute");
  compute.addEventListener("click", async () => {
    compute.disabled = true;
    body.replaceChildren();
    try {
      for (const [law, printed] of times) body.append(await rowOf(lane, law, solvers, printed));
    } catch (reason) {
      fault(faultText(reason));
    }
    compute.disabled = false;
  });
  const laws = times.map(([law]) => law);
  const show = () => (location.hash = toHash({ view: "bench", state: { ...defaults("bench"), laws } }));
  const open = h("button", { type: "button", id: "open-thesis", onclick: show }, "Show these laws on the bench");
  return h(
    "details",
    { class: "thesis" },
    h("summary", {}, HEADING),
    h("div", { class: "buttons" }, compute, open),
    h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": HEADING }, table),
  );
}
