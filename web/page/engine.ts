/** Workers with the library. */

import { canHear } from "./library";
import { unpacked } from "./texts";
import type { Question } from "./types";

declare const WORKER: string;

export interface Answer<T> {
  answer: T;
  arrays: Float64Array[];
  /** Time on the clock, in ms. */
  took: number;
}

/** A refusal of the library, with its reason. */
export class Refused extends Error {}

let compiled: Promise<WebAssembly.Module> | undefined;
let script: string | undefined;

/** The library that lies in this page, compiled once. */
function module(): Promise<WebAssembly.Module> {
  compiled ??= WebAssembly.compile(unpacked("library"));
  return compiled;
}

interface Waiting {
  question: Question;
  resolve(answer: Answer<unknown>): void;
  reject(reason: unknown): void;
  onProgress: ((rms: number) => void) | undefined;
}

/** A question that was given up because a newer one was put, or because it was stopped. */
export class Superseded extends Error {}

/** Time after which a run under way is given up for a newer one, in ms (chosen). */
const PATIENCE = 250;

/** A worker of which only the newest question counts. */
export class Lane {
  private worker: Worker | undefined;
  private asked: (Waiting & { since: number; number: number }) | undefined;
  private next: Waiting | undefined;
  private count = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Whether a question is under way, and since when. */
  get since(): number | undefined {
    return this.asked?.since;
  }

  /** Puts a question, whose progress may be heard of; an older one that waits is given up, one under way after some patience. */
  ask<T>(question: Question, onProgress?: (rms: number) => void): Promise<Answer<T>> {
    return new Promise((resolve, reject) => {
      this.next?.reject(new Superseded());
      this.next = { question, resolve: resolve as Waiting["resolve"], reject, onProgress };
      if (!this.asked) {
        this.send();
        return;
      }
      const left = PATIENCE - (performance.now() - this.asked.since);
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.restart(), Math.max(left, 0));
    });
  }

  /** Ends a search that is under way: its answer is the best so far. Returns whether it can be ended so. */
  end(): boolean {
    if (!canHear || !this.worker || !this.asked) return false;
    this.worker.postMessage({ end: this.asked.number });
    return true;
  }

  /** Gives up whatever is under way. */
  stop(): void {
    this.next?.reject(new Superseded());
    this.next = undefined;
    if (this.asked) this.restart();
  }

  private restart(): void {
    if (!this.asked) return;
    this.worker?.terminate();
    this.worker = undefined;
    const given = this.asked;
    this.asked = undefined;
    given.reject(new Superseded());
    this.send();
  }

  private async send(): Promise<void> {
    const next = this.next;
    if (!next) return;
    this.next = undefined;
    const number = ++this.count;
    this.asked = { ...next, since: performance.now(), number };
    const worker = (this.worker ??= await this.start());
    if (this.asked?.number === number) worker.postMessage({ number, question: next.question });
  }

  private async start(): Promise<Worker> {
    const library = await module();
    script ??= URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    const worker = new Worker(script);
    worker.onmessage = ({ data }) => this.receive(data);
    worker.postMessage({ module: library });
    return worker;
  }

  private receive(data: { number: number; trapped?: string; progress?: number } & Answer<{ refused?: string }>): void {
    const asked = this.asked;
    if (asked?.number !== data.number) return;
    if (data.progress !== undefined) {
      asked.onProgress?.(data.progress);
      return;
    }
    this.asked = undefined;
    clearTimeout(this.timer);
    if (data.trapped !== undefined) {
      this.worker?.terminate();
      this.worker = undefined;
      asked.reject(new Error(`the computation failed: ${data.trapped}`));
    } else if (data.answer.refused !== undefined) {
      asked.reject(new Refused(data.answer.refused));
    } else {
      asked.resolve(data);
    }
    void this.send();
  }
}
