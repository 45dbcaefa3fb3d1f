/** A worker: gets the library once, then answers one question after the other. */

import { open, type Packed } from "./library";

/** Least time between two reports of progress, in ms (chosen). */
const REPORT = 50;

let library: Promise<(question: unknown) => Packed> | undefined;
let asked: number | undefined;
let reported = 0;

function progress(rms: number): void {
  const now = performance.now();
  if (now - reported < REPORT) return;
  reported = now;
  self.postMessage({ number: asked, progress: rms });
}

self.onmessage = async ({ data }: MessageEvent) => {
  if (data.module) {
    library = open(data.module, progress);
    return;
  }
  const begin = performance.now();
  asked = data.number;
  try {
    const ask = await library!;
    const { answer, arrays } = ask(data.question);
    const took = performance.now() - begin;
    self.postMessage({ number: data.number, answer, arrays, took }, { transfer: arrays.map((array) => array.buffer) });
  } catch (fault) {
    // A library that has trapped cannot be used again: the page starts another worker.
    self.postMessage({ number: data.number, trapped: String(fault) });
  }
};
