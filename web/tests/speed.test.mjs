// How long a slider takes to redraw: figures, not limits.

import assert from "node:assert/strict";
import { test } from "node:test";
import { opened } from "./browser.mjs";

const MOVES = 50;
const EIGHT = "CoulombStiction,LuGre,Dahl,Stribeck,Karnopp,Andersson,Specker,BrownMcPhee";

test("a slider redraws the belt", async () => {
  for (const names of ["CoulombStiction", "LuGre", EIGHT]) {
    const { page, close } = await opened(`#v=1&law=${names}`);
    // Curves may come before the sliders.
    const slider = await page.waitForSelector("[data-name='friction.mu_k'] input[type=range]");
    const times = await slider.evaluate(async (slider, moves) => {
      const view = document.querySelector(".view");
      const times = [];
      for (let move = 0; move < moves; move++) {
        const done = new Promise((done) => {
          const observer = new MutationObserver(() => {
            if (view.dataset.running !== "0") return;
            observer.disconnect();
            done(performance.now());
          });
          observer.observe(view, { attributeFilter: ["data-drawn"] });
        });
        const begin = performance.now();
        slider.value = String(100 + move);
        slider.dispatchEvent(new Event("input"));
        times.push((await done) - begin);
        // The screen shows it before the next one.
        await new Promise((next) => requestAnimationFrame(next));
      }
      return times.sort((a, b) => a - b);
    }, MOVES);
    assert.equal(times.length, MOVES);
    const count = names.split(",").length;
    const what = count === 1 ? names : `${count} laws`;
    console.log(`figure: ${what} redrawn in ${times[MOVES / 2].toFixed(0)} ms (median of ${MOVES}), 40 s of the belt with 4001 points`);
    await close();
  }
});
