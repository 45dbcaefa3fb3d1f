// Fingers on sliders and plots.

import assert from "node:assert/strict";
import { test } from "node:test";
import { computed, drawn, opened, pixels } from "./browser.mjs";

/** A page on a phone, and fingers that go from places to others, together. */
async function onPhone(hash) {
  const { page, wrong, close } = await opened(hash, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const client = await page.context().newCDPSession(page);
  const send = (type, places) => client.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  const fingers = async (...ways) => {
    const at = (share) => ways.map(([from, to]) => from.map((begin, axis) => begin + share * (to[axis] - begin)));
    await send("touchStart", at(0));
    for (let step = 1; step <= 10; step++) await send("touchMove", at(step / 10));
    await send("touchEnd", []);
    await page.waitForTimeout(150);
  };
  return { page, wrong, close, fingers };
}

/** Where a part of a plot is on the screen. */
async function placesOn(page, kind) {
  await page.locator(`[data-kind=${kind}]`).evaluate((plot) => plot.scrollIntoView({ block: "end" }));
  await page.waitForTimeout(200);
  const { x, y, width, height } = await page.locator(`[data-kind=${kind}] .area`).boundingBox();
  return (right, down) => [x + right * width, y + down * height];
}

test("a finger moves a slider, and the curves follow", async () => {
  const { page, wrong, fingers, close } = await onPhone("#v=1&law=CoulombStiction");
  const slider = page.locator("[data-name='friction.mu_k'] input[type=range]");
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider.boundingBox();
  const seen = await drawn(page);
  await fingers([[x + 0.2 * width, y + height / 2], [x + 0.6 * width, y + height / 2]]);
  await computed(page, seen + 1);
  const value = Number(await page.locator("[data-name='friction.mu_k'] input[type=text]").inputValue());
  assert.ok(value > 0.2 && page.url().includes(`friction.mu_k=${value}`), page.url());
  assert.deepEqual(wrong, []);
  await close();
});

test("fingers move the cursor, spread and move what a plot shows, and tap it back", async () => {
  const { page, wrong, fingers, close } = await onPhone("#v=1&law=CoulombStiction");
  for (const kind of ["force-over-time", "force-over-displacement"]) {
    const at = await placesOn(page, kind);
    const shown = () => pixels(page, `[data-kind=${kind}] .area canvas`);
    const legend = () => page.locator("#bench > .main > .legend").textContent();
    const tap = (place) => page.touchscreen.tap(...place);
    // A loop has its cursor where the curve is near.
    if (kind === "force-over-time") {
      await fingers([at(0.4, 0.5), at(0.7, 0.5)]);
      assert.match(await legend(), /N at (2[4-9]|3\d)\.?\d* s/, kind);
    }
    await tap(at(0.98, 0.02));
    await page.waitForTimeout(500);
    const whole = await shown();
    await fingers([at(0.45, 0.5), at(0.25, 0.4)], [at(0.65, 0.5), at(0.85, 0.6)]);
    const spread = await shown();
    assert.notEqual(spread, whole, `${kind}: two fingers apart`);
    await fingers([at(0.7, 0.5), at(0.5, 0.5)]);
    const moved = await shown();
    assert.notEqual(moved, spread, `${kind}: one finger along`);
    await fingers([at(0.5, 0.5), at(0.7, 0.5)]);
    assert.equal(await page.evaluate(() => visualViewport.scale), 1, "the page itself keeps its size");
    // Two fingers together show all again.
    await fingers([at(0.1, 0.3), at(0.5, 0.5)], [at(0.9, 0.7), at(0.55, 0.5)]);
    await tap(at(0.98, 0.02));
    await page.waitForTimeout(500);
    assert.equal(await shown(), whole, `${kind}: two fingers together`);
    await fingers([at(0.45, 0.5), at(0.3, 0.5)], [at(0.65, 0.5), at(0.8, 0.5)]);
    assert.notEqual(await shown(), whole);
    await tap(at(0.98, 0.02));
    await tap(at(0.98, 0.02));
    await page.waitForTimeout(500);
    assert.equal(await shown(), whole, `${kind}: two taps`);
  }
  assert.deepEqual(wrong, []);
  await close();
});

test("a finger that goes up over a plot scrolls the page", async () => {
  const { page, fingers, close } = await onPhone("#v=1&law=CoulombStiction");
  const at = await placesOn(page, "position-over-time");
  const place = () => page.evaluate(() => scrollY);
  const before = await place();
  await fingers([at(0.5, 0.9), at(0.5, 0.1)]);
  await page.waitForFunction((before) => scrollY > before + 50, before);
  await close();
});
