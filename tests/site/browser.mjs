// Pages of the documentation site in Chromium, wide and on a phone: barriers that axe finds, messages, requests that
// leave the site, and pages that are wider than the window; and a search.
//
//     node tests/site/browser.mjs SITE CHROMIUM

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(new URL("../../web/package.json", import.meta.url));
const { chromium } = require("playwright-core");
const AXE = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const [site, executablePath] = process.argv.slice(2);
const BASE = pathToFileURL(resolve(site)).href;
const PAGES = [
  "index", "laws", "python_api", "c_api", "models/LuGre", "models/ShockAbsorber", "models/Liang", "docs/start",
  "docs/models", "docs/fmu", "docs/python", "docs/benchmark", "docs/trust", "docs/thesis", "docs/shock_absorber",
  "CHANGELOG",
];
const WINDOWS = [
  { width: 1200, height: 900, colorScheme: "light" },
  { width: 390, height: 844, colorScheme: "dark" },
];

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const wrong = [];
for (const { width, height, colorScheme } of WINDOWS) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme });
  const page = await context.newPage();
  const note = (text) => wrong.push(`${width} px, ${page.url().replace(BASE, "")}: ${text}`);
  page.on("console", (message) => note(message.text()));
  page.on("pageerror", (error) => note(error.message));
  page.on("request", (request) => {
    if (!/^(blob:|data:)/.test(request.url()) && !request.url().startsWith(BASE)) note(`requests ${request.url()}`);
  });
  for (const name of PAGES) {
    await page.goto(`${BASE}/${name}.html`);
    await page.evaluate(`${AXE}; undefined`);
    const { violations } = await page.evaluate(() => globalThis.axe.run({ preload: false }));
    for (const { id, nodes } of violations) note(`${id}: ${nodes.length} times, as in ${nodes[0].html.slice(0, 200)}`);
    const widest = await page.evaluate(() => document.documentElement.scrollWidth);
    if (widest > width) note(`is ${widest} px wide`);
  }
  await page.goto(`${BASE}/search.html?q=bristle`);
  // Results appear one after the other.
  const found = page.locator("#search-results li a", { hasText: "LuGre" }).first();
  await found.waitFor().catch(() => note("the search does not find LuGre"));
  await context.close();
}
await browser.close();
for (const line of wrong) console.log(line);
console.log(`figure: ${PAGES.length} pages of the site in two windows: ${wrong.length} faults`);
process.exitCode = wrong.length > 0 ? 1 : 0;
