// How large the page is.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

/** Limits in bytes: of the file, and of what a server sends. */
const LARGEST = 3_000_000;
const LARGEST_SENT = 1_400_000;

test("the page is small enough to be sent by mail", () => {
  const file = readFileSync(process.env.PAGE);
  const sent = gzipSync(file, { level: 9 });
  console.log(`figure: the page has ${file.length} bytes, ${sent.length} compressed; at most ${LARGEST} and ${LARGEST_SENT}`);
  assert.ok(file.length <= LARGEST && sent.length <= LARGEST_SENT);
});
