/** The library as WebAssembly: questions in, answers out. */

import type { Question } from "./types";

/** Gets the RMS residual of a search so far, in N; an answer other than 0 ends it with the best so far. */
type Progress = (rms: number) => number | Promise<number>;

/** Parts of WebAssembly with which a library waits for a promise (JSPI); not every browser has them. */
interface Waits {
  Suspending?: new (does: Progress) => WebAssembly.ImportValue;
  promising?: (does: () => number) => () => Promise<number>;
}

const { Suspending, promising } = WebAssembly as Waits;

/** Whether a search that is under way can hear of its end. */
export const canHear = Suspending !== undefined && promising !== undefined;

interface Exports {
  memory: WebAssembly.Memory;
  stribeck_alloc(length: number): number;
  stribeck_ask(): number;
  stribeck_answer(): number;
}

export interface Packed {
  answer: unknown;
  arrays: Float64Array<ArrayBuffer>[];
}

/** Opens a compiled library; the function that is returned answers questions. */
export async function open(module: WebAssembly.Module, progress: Progress): Promise<(question: Question) => Promise<Packed>> {
  const instance = await WebAssembly.instantiate(module, { page: { progress: Suspending ? new Suspending(progress) : progress } });
  const library = instance.exports as unknown as Exports;
  const search = promising?.(library.stribeck_ask) ?? library.stribeck_ask;
  return async (question) => {
    const text = new TextEncoder().encode(JSON.stringify(question));
    // The memory may grow, and its buffer change, with every call.
    const place = library.stribeck_alloc(text.length);
    new Uint8Array(library.memory.buffer).set(text, place);
    const length = question.ask === "fit" ? await search() : library.stribeck_ask();
    const begin = library.stribeck_answer();
    return unpacked(library.memory.buffer.slice(begin, begin + length) as ArrayBuffer);
  };
}

/** Length of the JSON and count of the numbers; the JSON; the numbers. */
function unpacked(bytes: ArrayBuffer): Packed {
  const [jsonLength = 0] = new Uint32Array(bytes, 0, 2);
  const json = new TextDecoder().decode(new Uint8Array(bytes, 8, jsonLength));
  const { answer, lengths } = JSON.parse(json) as { answer: unknown; lengths: number[] };
  let at = 8 + jsonLength;
  const arrays = lengths.map((count) => {
    const array = new Float64Array(bytes.slice(at, at + 8 * count));
    at += 8 * count;
    return array;
  });
  return { answer, arrays };
}
