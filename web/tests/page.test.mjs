// The page in Chromium, and its library against the same one for this machine.
//
//     node --test tests/    with PAGE, LIBRARY, NATIVE, PYTHON and CHROMIUM: see the task `page` in tasks.py

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { open } from "./engine.mjs";

const { PAGE, LIBRARY, NATIVE, PYTHON, CHROMIUM } = process.env;
const AXE = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
const ADDRESS = pathToFileURL(resolve(PAGE)).href;
const RUNS = 500;
/** Laws that the solver halves steps for take long: they are run for a short time. */
const SHORT = 0.05;
let browser, folder;

before(async () => {
  browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox"] });
  folder = mkdtempSync(join(tmpdir(), "stribeck-page-"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** The page with a link; what goes wrong is noted. */
async function opened(hash = "", options = {}) {
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
  return { page, wrong };
}

/** Waits until nothing is computed. */
const computed = (page, least = 1) =>
  page.waitForFunction((least) => {
    const { drawn, running } = document.querySelector(".view")?.dataset ?? {};
    return Number(drawn ?? 0) >= least && running === "0";
  }, least);

const drawn = (page) => page.evaluate(() => Number(document.querySelector(".view").dataset.drawn));

/** Hashes of the answers of the native library. */
function hashes(questions) {
  return new Promise((resolve, reject) => {
    const child = spawn(PYTHON, [fileURLToPath(new URL("native.py", import.meta.url)), NATIVE], {
      stdio: ["pipe", "pipe", "inherit"],
    });
    let text = "";
    child.stdout.on("data", (data) => (text += data));
    child.on("error", reject);
    child.on("close", () => resolve(text.trim().split(/\s+/)));
    child.stdin.end(questions.map((question) => `${JSON.stringify(question)}\n`).join(""));
  });
}

/** Numbers below one, the same in every run (Park and Miller). */
function random(seed) {
  let state = seed;
  return () => (state = (48271 * state) % 2147483647) / 2147483647;
}

test("the library gives the same bits in a browser and on this machine", { timeout: 600_000 }, async () => {
  const ask = await open(LIBRARY);
  const { laws } = ask({ ask: "catalogue" }).answer;
  const draw = random(20241);
  const within = (low, high) => low + (high - low) * draw();
  const questions = [];
  for (let number = 0; number < RUNS; number++) {
    const law = laws[number % laws.length].name;
    const { parts } = ask({ ask: "system", run: { system: "belt", law: [law] } }).answer;
    const known = parts.find((part) => part.is_law).values;
    const set = { "rig.mass": within(0.5, 2), "rig.stiffness": within(1, 4), "rig.belt_velocity": within(0.05, 0.2) };
    if ("mu_k" in known) set["friction.mu_k"] = within(0.05, 0.15);
    if ("mu_s" in known) set["friction.mu_s"] = within(0.15, 0.3);
    const run = { system: "belt", law: [law], until: SHORT * (1 + Math.floor(3 * draw())), every: 0.005, set };
    questions.push({ ask: "solve", run, law });
  }
  // Whole runs of laws that are quick, through stick and slip; sines as inputs.
  for (const law of ["CoulombStiction", "LuGre", "Karnopp", "Andersson"]) {
    questions.push({ ask: "solve", run: { law: [law] }, law });
    questions.push({ ask: "solve", run: { system: "motion", law: [law] }, law });
  }
  const answers = questions.map(ask);
  const solved = answers.filter(({ answer }) => answer.reached);
  const values = solved.reduce((sum, { arrays }) => sum + arrays.reduce((all, array) => all + array.length, 0), 0);
  const native = await hashes(questions);
  questions.forEach((question, at) => assert.equal(answers[at].hash, native[at], JSON.stringify(question)));
  assert.equal(new Set(solved.map(({ answer }) => answer.law)).size, laws.length, "every law has run");
  assert.ok(solved.length > 0.95 * questions.length, `only ${solved.length} runs`);
  console.log(`figure: ${solved.length} runs over ${laws.length} laws: ${values} values with the same bits`);
});

test("it opens without a message, a request or a fault, light and dark, wide and narrow", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [360, 1300]) {
      const { page, wrong } = await opened("", { colorScheme, viewport: { width, height: 900 } });
      assert.equal(await page.locator("figure.plot:visible").count(), 6);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      await page.evaluate(`${AXE}; undefined`);
      const { violations } = await page.evaluate(() => globalThis.axe.run());
      const found = violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
      assert.deepEqual(found, []);
      assert.deepEqual(wrong, []);
      await page.context().close();
    }
  }
});

test("a slider changes the curves, the link and the number field; undo brings all back", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction");
  const force = () => page.locator("[data-kind=force-over-time] > .unseen").textContent();
  const events = () => page.locator(".costs tbody td").nth(5).textContent();
  const [before, count] = [await force(), await events()];
  // At rest the spring pulls with mu_s m g at most: 0.15 9.81 N.
  assert.match(before, /from −1\.47[12] to/);
  assert.equal(count, "9");
  await page.locator("[data-name='friction.mu_s'] input[type=range]").focus();
  const seen = await drawn(page);
  for (let press = 0; press < 5; press++) await page.keyboard.press("PageUp");
  await computed(page, seen + 1);
  const field = await page.locator("[data-name='friction.mu_s'] input[type=text]").inputValue();
  assert.ok(Number(field) > 0.2, field);
  assert.ok(page.url().endsWith(`#v=1&law=CoulombStiction&friction.mu_s=${field}`), page.url());
  const low = Number(/from −([\d.]+)/.exec(await force())[1]);
  assert.ok(Math.abs(low - 9.81 * Number(field)) < 0.01 * low, `${low} N for mu_s = ${field}`);
  for (let step = 0; step < 5; step++) await page.locator("#undo").click();
  await page.waitForFunction((text) => document.querySelector("[data-kind=force-over-time] > .unseen").textContent === text, before);
  assert.deepEqual(wrong, []);
});

test("a link brings its state back, and a wrong one says what is wrong", async () => {
  const hash = "#v=1&system=pulled-mass&tol=1e-6&law=Dahl,LuGre,Karnopp&friction.mu_k=0.07&mass.stiffness=3.5";
  const { page, wrong } = await opened(hash);
  assert.equal(await page.locator("[data-name='friction.mu_k'] input[type=text]").inputValue(), "0.07");
  assert.equal(await page.locator("[data-name='mass.stiffness'] input[type=text]").inputValue(), "3.5");
  assert.deepEqual(await page.locator(".legend strong").allTextContents(), ["Dahl", "LuGre", "Karnopp"]);
  await page.locator("#copy-command").click();
  await page.waitForFunction(() => document.querySelector("#copied").textContent !== "");
  assert.deepEqual(wrong, []);
  const faults = [
    ["#v=1&law=LuGer", /friction law 'LuGer' does not exist \(did you mean 'LuGre'\?\)/],
    ["#v=1&law=LuGre&friction.sigma0=1", /'sigma0' does not exist \(did you mean 'sigma_0'\?\)/],
    ["#v=1&rig.mass=-1", /mass = -1.*must be > 0/],
    ["#v=2&tol=1e-6", /version 2/],
    ["#v=1&colour=red", /'colour' is unknown/],
    ["#v=1&view=law", /'view' is unknown/],
    ["#v=1&until=soon", /until = 'soon': must be a number/],
  ];
  for (const [bad, expected] of faults) {
    await page.goto("about:blank");
    await page.goto(ADDRESS + bad);
    await page.locator("#fault").waitFor({ state: "visible" });
    assert.match(await page.locator("#fault").textContent(), expected);
  }
});

test("what is saved can be read again", async () => {
  const { page } = await opened("#v=1&law=CoulombStiction&until=15&rig.mass=1.5");
  const saved = async (press) => {
    const [download] = await Promise.all([page.waitForEvent("download"), press()]);
    const file = join(folder, download.suggestedFilename());
    await download.saveAs(file);
    return readFileSync(file);
  };
  const toml = (await saved(() => page.locator("#save-toml").click())).toString();
  assert.equal(toml, 'system = "belt"\nlaw = ["CoulombStiction"]\nuntil = 15.0\n\n[set]\n"rig.mass" = 1.5\n');
  const table = (await saved(() => page.locator("#save-csv").click())).toString().trim().split("\n");
  const heading = table[0].split(",");
  assert.equal(table.length, 1 + 1501);
  const column = (name) => table.slice(1).map((row) => Number(row.split(",")[heading.indexOf(name)]));
  const [time, force] = [column("time [s]"), column("friction.friction_force [N]")];
  // The block is carried by the belt until the spring breaks it away: k v_b t = mu_s m g.
  const breakaway = (0.15 * 1.5 * 9.81) / (2 * 0.1);
  time.forEach((t, at) => t < 0.99 * breakaway && assert.ok(Math.abs(force[at] + 2 * 0.1 * t) < 1e-6, `${t} s`));
  assert.ok(force.some((value) => Math.abs(value + 0.1 * 1.5 * 9.81) < 1e-9), "it slips");
  const svg = (await saved(() => page.getByLabel("force-over-time as SVG").click())).toString();
  const title = await page.evaluate((text) => {
    const picture = new DOMParser().parseFromString(text, "image/svg+xml");
    return picture.querySelector("parsererror")?.textContent ?? picture.querySelector("title").textContent;
  }, svg);
  assert.equal(title, "Friction force over time");
  const png = await saved(() => page.getByLabel("force-over-velocity as PNG").click());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
});

test("a slider redraws the belt", async () => {
  const laws = "CoulombStiction,LuGre,Dahl,Stribeck,Karnopp,Andersson,Specker,BrownMcPhee";
  for (const [names, count] of [["CoulombStiction", 1], [laws, 8]]) {
    const { page } = await opened(`#v=1&law=${names}`);
    const times = await page.evaluate(async () => {
      const slider = document.querySelector("[data-name='friction.mu_k'] input[type=range]");
      const view = document.querySelector(".view");
      const times = [];
      for (let move = 0; move < 20; move++) {
        const begin = performance.now();
        slider.value = String(100 + move);
        slider.dispatchEvent(new Event("input"));
        do await new Promise((next) => requestAnimationFrame(next));
        while (view.dataset.running !== "0" || performance.now() - begin < 1);
        times.push(performance.now() - begin);
      }
      return times.sort((a, b) => a - b);
    });
    assert.equal(times.length, 20);
    console.log(`figure: ${count} laws redrawn in ${times[10].toFixed(0)} ms (median of 20)`);
    await page.context().close();
  }
});
