/** A worker: gets the library once, then answers one question after the other. */

import { open, type Packed } from "./library";

let library: Promise<(question: unknown) => Packed> | undefined;

self.onmessage = async ({ data }: MessageEvent) => {
  if (data.module) {
    library = open(data.module);
    return;
  }
  const begin = performance.now();
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
