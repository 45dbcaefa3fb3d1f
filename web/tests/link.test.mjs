// Links: states go into them and come back.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { ADDRESS, barriers, computed, copied, fault, opened, random, reopened } from "./browser.mjs";

const STATES = 1000;

/** The page's own functions for links, as a script that leaves them behind. */
async function functions() {
  const entry = fileURLToPath(new URL("../page/link.ts", import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: "iife", globalName: "link" });
  return `${outputFiles[0].text}; globalThis.link = link; undefined`;
}

/** A state of a view with whatever a user may type. */
function state(draw, view, { laws, systems, solvers }) {
  const pick = (list) => list[Math.floor(draw() * list.length)];
  const chosen = laws.filter(() => draw() < 0.15).slice(0, 8);
  const odd = ["1e-3", "\u22120,5", "a b&c=d", "100%", "#", "+1", "\u00e9", "true", "'; DROP", "", "1,2"];
  const set = {};
  for (let number = Math.floor(5 * draw()); number > 0; number--) {
    set[`${pick(["friction", "rig", "mass", "strut"])}.${pick(["mu_k", "sigma_0", "geom.d_i", "x=y", "mu s", "\u03c3"])}`] = draw() < 0.5 ? String(draw()) : pick(odd);
  }
  const text = () => (draw() < 0.5 ? "" : pick(odd));
  const state = { laws: chosen.length > 0 ? chosen : ["LuGre"], system: pick(systems), solver: pick(solvers), tol: text(), until: text(), every: text(), check: draw() < 0.5, set };
  return { view, state };
}

test("a thousand states come back from their links as they were", async () => {
  const { page } = await opened();
  const names = (list) => page.locator(list).evaluateAll((all) => all.map(({ value }) => value));
  const known = {
    laws: await page.locator("#bench [data-law] input").evaluateAll((all) => all.map(({ id }) => id.replace(/.*-/, ""))),
    systems: await names("#system-bench option"),
    solvers: await names("#solver-bench option"),
  };
  assert.ok(known.laws.length > 30 && known.systems.length > 5 && known.solvers.length > 3);
  const draw = random(7);
  const views = ["bench", "law", "strut", "fit"];
  const states = Array.from({ length: STATES }, (_, number) => state(draw, views[number % 4], known));
  await page.evaluate(await functions());
  const back = await page.evaluate(
    (states) => states.map((one) => globalThis.link.fromHash(new URL(`https://a.b/${globalThis.link.toHash(one)}`).hash)),
    states,
  );
  back.forEach((one, number) => assert.deepEqual(one, { ...states[number], faults: [] }));
});

test("links of every version open", async () => {
  const lines = readFileSync(new URL("links.txt", import.meta.url), "utf8").split("\n").filter((line) => line.startsWith("#v="));
  assert.ok(lines.length >= 12);
  const { page, wrong } = await opened();
  for (const line of lines) {
    const [hash, view] = line.split(/\s+/);
    await reopened(page, hash);
    assert.equal(await fault(page), "", hash);
    assert.equal(await page.locator(".view").getAttribute("id"), view, hash);
    // The page writes the same link, perhaps in another order.
    const entries = (text) => text.replace(/.*#/, "").split("&").sort();
    assert.deepEqual(entries(await copied(page, `#${view}-copy-link`)), entries(hash));
  }
  assert.deepEqual(wrong, []);
});

test("a wrong link says what is wrong, and the page is of use", async () => {
  const { page } = await opened();
  const faults = [
    ["#v=1&law=LuGer", /friction law 'LuGer' does not exist \(did you mean 'LuGre'\?\)/],
    ["#v=1&law=LuGre&friction.sigma0=1", /'sigma0' does not exist \(did you mean 'sigma_0'\?\)/],
    ["#v=1&rig.mass=-1", /mass = -1.*must be > 0/],
    ["#v=2&tol=1e-6", /version 2/],
    ["#v=1&colour=red", /'colour' is unknown/],
    ["#v=1&view=cellar", /the view 'cellar' does not exist; there are bench, law, strut, fit/],
    ["#v=1&check=perhaps", /'check' is unknown/],
    ["#v=1&until=soon", /until = 'soon': must be a number/],
    ["#v=1&system=bolt", /system 'bolt' does not exist \(did you mean 'belt'\?\)/],
    ["#v=1&law=", /0 laws: must be 1 to 8/],
    ["#v=1&law=Coulomb,Dahl,LuGre,Karnopp,Hollars,Specker,Bernard,Ambrosio,Stribeck", /9 laws: must be 1 to 8/],
    ["#v=1&law=Dahl,LuGre,Dahl", /the law Dahl is there twice/],
    ["#v=1&view=law&law=Dahl,LuGre", /2 laws: this view shows one/],
    ["#v=1&%E0%A4%A=1", /must be name=value/],
    ["#v=1&view=law&law=LuGer", /friction law 'LuGer' does not exist/],
    ["#v=1&view=law&motion.stroke=0", /stroke = 0: must be > 0/],
    ["#v=1&view=law&friction.sigma0=1", /'sigma0' does not exist \(did you mean 'sigma_0'\?\)/],
    ["#v=1&view=strut&strut.length.ampl=1", /'ampl' does not exist \(did you mean 'amplitude'\?\)/],
    ["#v=1&view=fit&rig.weight=1", /'rig.weight' is unknown/],
    ["#v=1&view=fit&law=Liang", /friction law 'Liang' does not exist, or cannot be fitted/],
    ["#v=1&view=fit&law=Capstan&held.voltage=1", /'held.voltage' is unknown/],
  ];
  for (const [bad, expected] of faults) {
    await page.goto("about:blank");
    await page.goto(`${ADDRESS}${bad}`);
    await page.locator("#fault").waitFor({ state: "visible" });
    assert.match(await fault(page), expected);
    await page.locator("#reset").click();
    await page.waitForFunction(() => document.querySelector("#fault").hidden);
    await computed(page);
  }
  assert.deepEqual(await barriers(page), []);
});
