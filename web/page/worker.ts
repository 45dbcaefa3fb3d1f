/** A worker: gets the library once, then answers one question after the other. */

import { canHear, open, type Packed } from "./library";
import type { Question } from "./types";

/** Least time between two reports of progress, in ms (chosen). */
const REPORT = 50;

let library: Promise<(question: Question) => Promise<Packed>> | undefined;
let asked: number | undefined;
/** The question whose search is to end with the best so far. */
let ended: number | undefined;
let reported = 0;

/** Reports the RMS residual of a search so far, and checks whether it is cancelled. */
function progress(rms: number): number | Promise<number> {
  const now = performance.now();
  if (now - reported < REPORT) return 0;
  reported = now;
  self.postMessage({ number: asked, progress: rms });
  return canHear ? new Promise((listened) => setTimeout(() => listened(Number(ended === asked)))) : 0;
}

self.onmessage = async ({ data }: MessageEvent) => {
  if (data.module) {
    library = open(data.module, progress);
    return;
  }
  if (data.end !== undefined) {
    ended = data.end;
    return;
  }
  const begin = performance.now();
  asked = data.number;
  try {
    const ask = await library!;
    const { answer, arrays } = await ask(data.question);
    const took = performance.now() - begin;
    self.postMessage({ number: data.number, answer, arrays, took }, { transfer: arrays.map((array) => array.buffer) });
  } catch (fault) {
    // A library that has trapped cannot be used again: the page starts another worker.
    self.postMessage({ number: data.number, trapped: String(fault) });
  }
};
