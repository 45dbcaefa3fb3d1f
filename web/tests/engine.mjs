// The library as WebAssembly in Node.

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";

/** Opens the library; the function that is returned answers questions, `told` hears of the progress of a search. */
export async function open(file, told = () => undefined) {
  const { instance } = await WebAssembly.instantiate(readFileSync(file), { page: { progress: told } });
  const { memory, stribeck_alloc, stribeck_ask, stribeck_answer } = instance.exports;
  return (question) => {
    const text = new TextEncoder().encode(JSON.stringify(question));
    // The memory may grow, and its buffer change, with every call.
    const place = stribeck_alloc(text.length);
    new Uint8Array(memory.buffer).set(text, place);
    const length = stribeck_ask();
    const begin = stribeck_answer();
    const bytes = memory.buffer.slice(begin, begin + length);
    const hash = createHash("sha256").update(new Uint8Array(bytes)).digest("hex");
    const [jsonLength] = new Uint32Array(bytes, 0, 2);
    const { answer, lengths } = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 8, jsonLength)));
    let at = 8 + jsonLength;
    const arrays = lengths.map((count) => {
      const array = new Float64Array(bytes, at, count);
      at += 8 * count;
      return array;
    });
    return { answer, arrays, hash };
  };
}
