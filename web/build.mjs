// Writes the page as one file: node build.mjs LIBRARY.wasm TEXTS.json VERSION PAGE.html

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { compress, init } from "@bokuweb/zstd-wasm";
import { build } from "esbuild";

const HERE = dirname(fileURLToPath(import.meta.url));
const source = (name) => join(HERE, "page", name);

/** A bundle of TypeScript or CSS as text. */
async function bundle(entry, define = {}) {
  const options = { bundle: true, write: false, minify: true, format: "esm", target: "es2022", logLevel: "warning" };
  const { outputFiles } = await build({ ...options, entryPoints: [entry], define });
  return outputFiles[0].text.trim();
}

/** What the policy of the page lets run: this text and nothing else. */
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** Packed with zstd: its window spans the whole library, in which the same code comes again for other laws. */
const packed = (file) => Buffer.from(compress(readFileSync(file), 22)).toString("base64");
/** The licence of a package that is in the page. */
const licence = (name) => `${name}\n\n${readFileSync(join(HERE, "node_modules", name, "LICENSE"), "utf8").trim()}\n`;

const [library, texts, version, page] = process.argv.slice(2);
if (!page) throw new Error("node build.mjs LIBRARY.wasm TEXTS.json VERSION PAGE.html");
await init();
const worker = await bundle(source("worker.ts"));
const main = await bundle(source("main.ts"), { WORKER: JSON.stringify(worker) });
const script = main.replaceAll("</script", "<\\/script");
const style = (await bundle(join(HERE, "node_modules/uplot/dist/uPlot.min.css"))) + (await bundle(source("style.css")));
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  "worker-src blob:",
  "img-src data:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");
const parts = {
  POLICY: policy,
  STYLE: style,
  SCRIPT: script,
  LIBRARY: packed(library),
  TEXTS: packed(texts),
  VERSION: version,
  LICENCES: ["uplot", "fzstd"].map(licence).join("\n").replaceAll("&", "&amp;").replaceAll("<", "&lt;"),
};
const html = readFileSync(source("index.html"), "utf8").replace(/%([A-Z]+)%/g, (_, name) => parts[name]);
mkdirSync(dirname(page), { recursive: true });
writeFileSync(page, html);
console.log(`${page}: ${Buffer.byteLength(html)} bytes, ${gzipSync(html, { level: 9 }).length} compressed`);
