// The bench: sliders, laws, plots, drawing, files.

import assert from "node:assert/strict";
import { test } from "node:test";
import { barriers, computed, copied, drawn, fault, opened, pixels, saved } from "./browser.mjs";

const text = (page, kind) => page.locator(`[data-kind=${kind}] > .unseen`).textContent();

test("a slider changes the curves, the link and the number field; undo brings all back", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction");
  const events = () => page.locator(".costs tbody td").nth(5).textContent();
  const [before, count] = [await text(page, "force-over-time"), await events()];
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
  const low = Number(/from −([\d.]+)/.exec(await text(page, "force-over-time"))[1]);
  assert.ok(Math.abs(low - 9.81 * Number(field)) < 0.01 * low, `${low} N for mu_s = ${field}`);
  for (let step = 0; step < 5; step++) await page.locator("#undo").click();
  await page.waitForFunction((text) => document.querySelector("[data-kind=force-over-time] > .unseen").textContent === text, before);
  assert.deepEqual(wrong, []);
});

test("a check by a finer run is told beside the cost", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction,LuGre&tol=1e-6");
  const cells = () => page.locator(".costs tbody tr td:last-child").allTextContents();
  assert.deepEqual(await cells(), ["reached", "reached"]);
  const seen = await drawn(page);
  await page.locator("#check-bench").check();
  await computed(page, seen + 1);
  assert.ok(page.url().endsWith("&check=true"), page.url());
  for (const text of await cells()) assert.match(text, /^tolerance 6.3e-9: .*rig\.position \S+, .* of the range$/);
  assert.deepEqual(wrong, []);
});

test("a slider that is dragged redraws while it moves", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction");
  const slider = await page.locator("[data-name='friction.mu_k'] input[type=range]").boundingBox();
  const seen = await drawn(page);
  await page.mouse.move(slider.x + 0.2 * slider.width, slider.y + slider.height / 2);
  await page.mouse.down();
  for (let step = 1; step <= 10; step++) {
    await page.mouse.move(slider.x + (0.2 + 0.02 * step) * slider.width, slider.y + slider.height / 2);
    await page.waitForTimeout(30);
  }
  assert.ok((await drawn(page)) > seen, "it is drawn before the button is released");
  await page.mouse.up();
  await computed(page);
  const value = Number(await page.locator("[data-name='friction.mu_k'] input[type=text]").inputValue());
  assert.ok(value > 0.15 && page.url().includes(`friction.mu_k=${value}`), page.url());
  assert.deepEqual(wrong, []);
});

test("laws are found by their name and what they do, by keyboard alone", async () => {
  const { page, wrong } = await opened("#v=1&law=LuGre");
  await page.locator("#add-law-bench").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await page.keyboard.type("transition band");
  assert.deepEqual(await page.locator(".law:visible b").allTextContents(), ["RooneyDeravi"]);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Space");
  await page.waitForFunction(() => location.hash === "#v=1&law=LuGre,RooneyDeravi");
  await computed(page);
  assert.deepEqual(await page.locator("#bench > .main > .legend strong").allTextContents(), ["LuGre", "RooneyDeravi"]);
  // The plots: cursor, zoom, reset.
  await page.locator("[data-kind=force-over-time] .area").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => /^Time 0\.4 s\. LuGre: .* N, RooneyDeravi: .* N$/.test(document.querySelector("#live").textContent));
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.locator("[data-kind=force-over-time] table").waitFor();
  assert.deepEqual(wrong, []);
});

test("presets set values, and eight laws are the most", async () => {
  const { page } = await opened("#v=1&law=LuGre");
  await page.locator("#preset-friction-LuGre").selectOption("canudas_1995");
  await page.waitForFunction(() => location.hash.includes("friction.mu_s=1.5"));
  await computed(page);
  assert.equal(await page.locator("#preset-friction-LuGre").inputValue(), "canudas_1995");
  await page.locator("#preset-friction-LuGre").selectOption("");
  await page.waitForFunction(() => location.hash === "#v=1&law=LuGre");
  await page.locator("#add-law-bench").click();
  for (const law of ["Coulomb", "Stribeck", "Bernard", "Threlfall", "Ambrosio", "Karnopp", "Hollars"]) await page.locator(`#law-bench-${law}`).check();
  await computed(page);
  assert.ok(await page.locator("#law-bench-Dahl").isDisabled());
  assert.equal(await fault(page), "");
});

test("a time plot and a loop are zoomed by dragging and by keys, and reset", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction");
  const shown = (kind) => pixels(page, `[data-kind=${kind}] .area canvas`);
  const drag = async (kind, [x0, y0], [x1, y1]) => {
    await page.locator(`[data-kind=${kind}]`).scrollIntoViewIfNeeded();
    const { x, y, width, height } = await page.locator(`[data-kind=${kind}] .area`).boundingBox();
    await page.mouse.move(x + x0 * width, y + y0 * height);
    await page.mouse.down();
    await page.mouse.move(x + x1 * width, y + y1 * height, { steps: 5 });
    await page.mouse.up();
    await page.mouse.move(0, 0);
    await page.waitForTimeout(100);
  };
  for (const kind of ["force-over-time", "force-over-velocity"]) {
    const whole = await shown(kind);
    await drag(kind, [0.3, 0.2], [0.6, 0.6]);
    assert.notEqual(await shown(kind), whole, kind);
    await page.locator(`[data-kind=${kind}] button`).last().click();
    await page.mouse.move(0, 0);
    await page.waitForTimeout(100);
    assert.equal(await shown(kind), whole, `${kind} after Reset`);
    await page.locator(`[data-kind=${kind}] .area`).focus();
    await page.keyboard.press("+");
    await page.waitForTimeout(100);
    assert.notEqual(await shown(kind), whole, `${kind} by a key`);
    await page.keyboard.press("Escape");
    await page.waitForTimeout(100);
    assert.equal(await shown(kind), whole, `${kind} after Escape`);
  }
  assert.deepEqual(wrong, []);
});

test("the block moves when it is played, and step by step where motion is reduced", async () => {
  const { page, close } = await opened("#v=1&law=LuGre");
  const at = (page) => page.locator(".stage input").evaluate(({ value }) => Number(value));
  const begin = await pixels(page, ".stage canvas");
  await page.locator("#play").click();
  await page.waitForFunction(() => Number(document.querySelector(".stage input").value) > 100);
  assert.equal(await page.locator("#play").textContent(), "Pause");
  await page.locator("#play").click();
  assert.notEqual(await pixels(page, ".stage canvas"), begin);
  assert.match(await page.locator("#bench > .main > .legend").textContent(), /N at .* s/, "the plots' cursor moves along");
  await close();
  const { page: still } = await opened("#v=1&law=LuGre", { reducedMotion: "reduce" });
  await still.locator("#play").click();
  const first = await at(still);
  await still.waitForTimeout(300);
  assert.ok(first > 0 && (await at(still)) === first, "one picture, which rests");
});

test("what is saved can be read again", async () => {
  const { page } = await opened("#v=1&law=CoulombStiction&until=15&rig.mass=1.5");
  const toml = (await saved(page, () => page.locator("#bench-save-toml").click())).toString();
  assert.equal(toml, 'system = "belt"\nlaw = ["CoulombStiction"]\nuntil = 15.0\n\n[set]\n"rig.mass" = 1.5\n');
  const table = (await saved(page, () => page.locator("#bench-save-csv").click())).toString().trim().split("\n");
  const heading = table[0].split(",");
  assert.equal(table.length, 1 + 1501);
  const column = (name) => table.slice(1).map((row) => Number(row.split(",")[heading.indexOf(name)]));
  const [time, force] = [column("time [s]"), column("friction.friction_force [N]")];
  // The block is carried by the belt until the spring breaks it away: k v_b t = mu_s m g.
  const breakaway = (0.15 * 1.5 * 9.81) / (2 * 0.1);
  time.forEach((t, at) => t < 0.99 * breakaway && assert.ok(Math.abs(force[at] + 2 * 0.1 * t) < 1e-6, `${t} s`));
  assert.ok(force.some((value) => Math.abs(value + 0.1 * 1.5 * 9.81) < 1e-9), "it slips");
  const svg = (await saved(page, () => page.getByLabel("force-over-time as SVG").click())).toString();
  const title = await page.evaluate((text) => {
    const picture = new DOMParser().parseFromString(text, "image/svg+xml");
    return picture.querySelector("parsererror")?.textContent ?? picture.querySelector("title").textContent;
  }, svg);
  assert.equal(title, "Friction force over time");
  const png = await saved(page, () => page.getByLabel("force-over-velocity as PNG").click());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.equal(await copied(page, "#bench-copy-command"), "stribeck run --law CoulombStiction --set rig.mass=1.5 --system belt --until 15.0");
});

test("the thesis' table is computed", async () => {
  const { page, wrong } = await opened("#v=1&law=CoulombStiction&until=1");
  await page.locator(".thesis summary").click();
  await page.locator("#compute-thesis").click();
  await page.waitForFunction(() => document.querySelectorAll(".thesis tbody tr").length === 8 && !document.querySelector("#compute-thesis").disabled, null, { timeout: 60_000 });
  const rows = await page.locator(".thesis tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map(([law]) => law).slice(0, 2), ["Karnopp", "BengisuAkay"]);
  assert.deepEqual(rows[0].slice(-4), ["1.4239", "1.9092", "DNC", "2.2380"]);
  assert.ok(rows.every(([, ours]) => Number(ours) > 0), JSON.stringify(rows));
  assert.deepEqual(await barriers(page), []);
  assert.deepEqual(wrong, []);
});
