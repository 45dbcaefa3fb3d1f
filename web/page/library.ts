/** The library as WebAssembly: questions in, answers out. Used in workers and in Node. */

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

/**
 * Opens a compiled library; the function that is returned answers questions. `progress` hears of a search that is under
 * way: what is not explained so far, in N.
 */
export async function open(
  module: WebAssembly.Module,
  progress: (rms: number) => void = () => undefined,
): Promise<(question: unknown) => Packed> {
  const instance = await WebAssembly.instantiate(module, { page: { progress } });
  const library = instance.exports as unknown as Exports;
  return (question) => {
    const text = new TextEncoder().encode(JSON.stringify(question));
    // The memory may grow, and its buffer change, with every call.
    const place = library.stribeck_alloc(text.length);
    new Uint8Array(library.memory.buffer).set(text, place);
    const length = library.stribeck_ask();
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
