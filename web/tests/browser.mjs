// The page in Chromium, with everything noted that goes wrong.

import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const { PAGE, CHROMIUM } = process.env;
export const ADDRESS = pathToFileURL(resolve(PAGE)).href;
const AXE = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
let browser;
/** A folder for files of the tests. */
export let folder;

before(async () => {
  browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox"] });
  folder = mkdtempSync(join(tmpdir(), "stribeck-page-"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** The page with a link; `wrong` has its messages, faults and requests. */
export async function opened(hash = "", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1300, height: 900 }, ...options });
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => wrong.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => wrong.push(`error: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(blob:|data:)/.test(request.url()) && !request.url().startsWith(ADDRESS)) wrong.push(request.url());
  });
  await page.goto(ADDRESS + hash);
  await computed(page);
  return { page, wrong, close: () => context.close() };
}

/** Opens a link in the same window, as from an address. */
export async function reopened(page, hash) {
  await page.goto("about:blank");
  await page.goto(ADDRESS + hash);
  await computed(page);
}

/** Waits until nothing is computed, which a fit may take a while for, and something has been drawn so many times. */
export const computed = (page, least = 0) =>
  page.waitForFunction((least) => {
    const { drawn, running } = document.querySelector(".view")?.dataset ?? {};
    return Number(drawn ?? -1) >= least && running === "0";
  }, least, { timeout: 240_000 });

export const drawn = (page) => page.evaluate(() => Number(document.querySelector(".view").dataset.drawn));

/** The message for the user; empty if there is none. */
export const fault = (page) => page.evaluate(() => document.querySelector("#fault").textContent);

/** What axe finds. */
export async function barriers(page) {
  await page.evaluate(`${AXE}; undefined`);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  return violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
}

/** A number for the pixels of a canvas. */
export async function pixels(page, canvas) {
  const picture = await page.locator(canvas).first().evaluate((canvas) => canvas.toDataURL());
  return createHash("sha256").update(picture).digest("hex");
}

/** A file that a button offers. */
export async function saved(page, press) {
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  const file = join(folder, download.suggestedFilename());
  await download.saveAs(file);
  return readFileSync(file);
}

/** A text that a button copies. */
export async function copied(page, button) {
  await page.locator(button).click();
  const view = button.replace(/^#(\w+)-.*/, "$1");
  await page.waitForFunction((id) => document.getElementById(id).textContent !== "", `copied-${view}`);
  return page.locator(`#copied-${view}`).getAttribute("data-text");
}

/** Numbers below one, the same in every run (Park and Miller). */
export function random(seed) {
  let state = seed;
  return () => (state = (48271 * state) % 2147483647) / 2147483647;
}
