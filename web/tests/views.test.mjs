// All views: how they look to everybody, and the views of a law, a strut and a fit.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { barriers, computed, copied, drawn, fault, folder, opened, pixels, reopened, saved } from "./browser.mjs";

const VIEWS = { bench: 7, law: 3, strut: 6, fit: 4 };
/** The view of a fit with a record and a search that take a second. */
const QUICK = "#v=1&view=fit&fit.budget=200&fit.repetitions=0&rig.duration=1";
const text = (page, kind) => page.locator(`[data-kind=${kind}] > .unseen`).textContent();

/** Measures on the virtual rig. */
async function measure(page) {
  const seen = await drawn(page);
  await page.locator("#measure-rig").click();
  await computed(page, seen + 2);
}

test("every view opens without a message, a request or a barrier, light and dark, wide and narrow", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [360, 1300]) {
      const { page, wrong, close } = await opened(QUICK, { colorScheme, viewport: { width, height: 900 } });
      for (const [view, plots] of Object.entries(VIEWS)) {
        await page.locator(`#to-${view}`).click();
        await computed(page, 1);
        assert.match(await page.locator(".intro").textContent(), /\. Try: .*\.$/, view);
        assert.equal(await page.locator("figure.plot:visible").count(), plots, view);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `${view} at ${width}`);
        assert.deepEqual(await barriers(page), [], `${view} at ${width}, ${colorScheme}`);
        assert.equal(await fault(page), "");
      }
      assert.deepEqual(wrong, []);
      await close();
    }
  }
});

test("a print has the plots out of sight", async () => {
  const { page } = await opened("#v=1&view=strut", { viewport: { width: 1300, height: 500 } });
  const last = () => page.locator("figure.plot canvas").last().evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return data.some((value) => value !== 0);
  });
  const count = await page.locator("figure.plot").count();
  const drawnPlots = () => page.evaluate(() => [...document.querySelectorAll("figure.plot")].filter((plot) => plot.querySelector("canvas")).length);
  assert.ok((await drawnPlots()) < count);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await drawnPlots(), count);
  assert.ok(await last());
});

test("views keep what was set in them, and undo goes back through them", async () => {
  const { page } = await opened("#v=1&rig.mass=2");
  await page.locator("#to-strut").click();
  await computed(page, 1);
  assert.ok(page.url().endsWith("#v=1&view=strut"));
  await page.locator("#to-bench").click();
  await computed(page, 1);
  assert.ok(page.url().endsWith("#v=1&rig.mass=2"));
  await page.locator("#undo").click();
  await page.waitForFunction(() => location.hash === "#v=1&view=strut");
  assert.equal(await page.locator("[aria-current=page]").textContent(), "Strut");
});

test("the curve and the strokes of a law follow its sliders, beside its equations", async () => {
  const { page, wrong } = await opened("#v=1&view=law&law=Dahl");
  assert.ok((await page.locator("article math").count()) > 5);
  assert.match(await page.locator("article").textContent(), /Source/);
  const most = async () => Number(/to ([\d.]+) N$/.exec((await text(page, "force-at-held-velocity")).trim())[1]);
  // Dahl's law: mu_k times the normal force.
  const [load, mu] = [await page.locator("[id='set-held_normal_force']").inputValue(), await page.locator("[id='set-friction_mu_k']").inputValue()];
  assert.ok(Math.abs((await most()) - load * mu) < 1e-3 * load * mu, `${await most()} N of ${mu} times ${load} N`);
  const seen = await drawn(page);
  await page.locator("[id='set-held_normal_force']").fill("50");
  await page.keyboard.press("Tab");
  await computed(page, seen + 2);
  assert.ok(Math.abs((await most()) - 50 * mu) < 0.05 * mu, `${await most()} N of ${mu} times 50 N`);
  // Work of the strokes is lost: the loop is run through with the area inside.
  const rows = (await saved(page, () => page.locator("#law-save-csv").click())).toString().trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
  const period = rows.slice(400);
  const area = period.slice(1).reduce((sum, [, x, , f], at) => sum + 0.5 * (f + period[at][3]) * (x - period[at][1]), 0);
  assert.ok(area > 0 && Math.abs(period.at(-1)[1] - period[0][1]) < 1e-15, `${area} J`);
  // LuGre gives energy back, unless the viscous part takes it: 158 N s/m are 316 (0.15 - 0.1) / 0.1.
  assert.equal(await page.locator("#passivity").textContent(), "");
  await page.locator("#the-law").selectOption("LuGre");
  await page.waitForFunction(() => /^viscous_coefficient = 0\.1: below 158\.114 /.test(document.querySelector("#passivity").textContent));
  await page.locator("[id='set-friction_viscous_coefficient']").fill("158.114");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.querySelector("#passivity").textContent === "");
  // A law that keeps fluctuating has strokes, but no curve.
  await page.locator("#the-law").selectOption("Bristle");
  await page.waitForFunction(() => /No curve: the results do not settle/.test(document.querySelector("#law .progress").textContent), null, { timeout: 60_000 });
  assert.equal(await fault(page), "");
  await page.locator("#law-to-bench").click();
  await page.waitForFunction(() => location.hash === "#v=1&law=Bristle");
  assert.deepEqual(wrong, []);
});

test("a strut on the dyno rubs more under side load, on the guide and on the piston", async () => {
  const { page, wrong } = await opened("#v=1&view=strut&law=CoulombStiction");
  const most = async (name) => Number(new RegExp(`${name} from .*? to ([\\d.]+) N`).exec(await text(page, "contacts-over-time"))[1]);
  const [guide, piston] = [await most("rod guide"), await most("piston")];
  const seen = await drawn(page);
  await page.locator("[id='set-strut_side_force_m']").fill("400");
  await page.keyboard.press("Tab");
  await computed(page, seen + 1);
  assert.ok((await most("rod guide")) > guide + 5 && (await most("piston")) > piston + 5);
  const before = await pixels(page, ".stage canvas");
  await page.locator(".stage input").focus();
  await page.keyboard.press("PageUp");
  assert.notEqual(await pixels(page, ".stage canvas"), before);
  const ssv = (await saved(page, () => page.locator("#strut-save-ssv").click())).toString();
  assert.match(ssv, /friction\.model/);
  await page.locator("#system-strut").selectOption("dyno-ramps");
  await computed(page);
  // Ramps of 0.02 m at 2 Hz: 4 A f.
  await page.waitForFunction(() => document.querySelector("[data-kind=force-over-velocity] .area canvas") && location.hash.includes("dyno-ramps"));
  const table = (await saved(page, () => page.locator("#strut-save-csv").click())).toString().split("\n");
  const at = table[0].split(",").indexOf("strut.velocity [m/s]");
  assert.ok(table.slice(1, -1).every((row) => Math.abs(Math.abs(Number(row.split(",")[at])) - 0.16) < 1e-12));
  assert.deepEqual(wrong, []);
});

test("a fit finds the law of the virtual rig again, tells how far it is, and can be cancelled", { timeout: 300_000 }, async () => {
  const { page, wrong } = await opened("#v=1&view=fit&fit.budget=600&fit.repetitions=4&rig.duration=2");
  assert.match(await page.locator("#drop").textContent(), /nothing is uploaded/);
  await measure(page);
  await page.locator("#start-fit").click();
  await page.waitForFunction(() => /Fitting LuGre for \d+ s, RMS residual [\d.e−]+ N so far/.test(document.querySelector("#fit .progress").textContent));
  // As with Ctrl-C on the command line, the best so far is kept.
  await page.locator("#cancel-fit").click();
  await page.locator(".outcome table").first().waitFor();
  assert.match(await page.locator(".outcome .note").textContent(), /^ended early: the best values so far, without profiles and repetitions$/);
  assert.match((await saved(page, () => page.locator("#fit-save-toml").click())).toString(), /law = \["LuGre"\]/);
  await page.locator("#start-fit").click();
  await page.waitForFunction(() => !document.querySelector(".outcome .note"), null, { timeout: 240_000 });
  const rows = await page.locator(".outcome tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  const [, estimate, , repeated, truth, verdict] = rows.find(([name]) => name === "mu_k");
  assert.equal(verdict, "determined");
  const [value, apart] = estimate.split(/ [+±]/).map(Number.parseFloat);
  assert.ok(apart > 0 && apart < 0.02 * value && Math.abs(value - Number(truth)) < 0.02 * truth, `${estimate}, truth ${truth}`);
  // All numbers of a row have as many decimals.
  assert.equal(new Set(`${estimate} ${repeated}`.match(/\d+\.\d+/g).map((one) => one.length)).size, 1, `${estimate}; ${repeated}`);
  assert.deepEqual(await barriers(page), []);
  const toml = (await saved(page, () => page.locator("#fit-save-toml").click())).toString();
  assert.match(toml, /law = \["LuGre"\][^]*mu_k = 0\.\d+/);
  await page.locator("#fit-to-law").click();
  await page.waitForFunction(() => /^#v=1&view=law&held\.|^#v=1&view=law&.*friction\.mu_k=/.test(location.hash));
  assert.deepEqual(wrong, []);
});

/** Values at the cursor beside the names of curves. */
const told = (page, kind) => page.locator(`[data-kind=${kind}] .value`).allTextContents();
const svg = async (page, kind) => (await saved(page, () => page.getByLabel(`${kind} as SVG`).click())).toString();
/** Numbers of the horizontal axis. */
const across = async (page, kind) => (await svg(page, kind)).match(/text-anchor="middle">[−\d.]+(?=<)/g);

/** Names of the curves of a plot. */
const names = (page, kind) => page.locator(`[data-kind=${kind}] .keys li > span:first-of-type:not(.value)`).allTextContents();

test("measured, true and fitted friction are told apart where they lie on each other", async () => {
  const { page, wrong } = await opened(QUICK);
  assert.deepEqual(await names(page, "friction-over-time"), ["measured", "true", "LuGre fitted"]);
  // Measured friction is pale: what lies on it shows.
  assert.equal((await svg(page, "friction-over-time")).match(/stroke-opacity="0.4"/g).length, 2);
  assert.deepEqual(wrong, []);
});

test("residuals lie below measured, true and fitted friction, on the same axis and with the same cursor", async () => {
  const { page, wrong } = await opened(QUICK);
  assert.deepEqual(await names(page, "residual-over-time"), ["measured", "true", "LuGre fitted", "residual"]);
  assert.ok((await svg(page, "residual-over-time")).includes("Residual in N"));
  const times = (kind) => across(page, kind);
  const whole = await times("friction-over-time");
  assert.deepEqual(await times("residual-over-time"), whole);
  const areas = ["friction", "residual"].map((what) => page.locator(`[data-kind=${what}-over-time] .area`));
  const [above, below] = await Promise.all(areas.map((area) => area.boundingBox()));
  assert.ok(below.y > above.y + above.height && below.height < 0.7 * above.height && below.width === above.width);
  const at = async (area) => {
    await area.press("ArrowRight");
    const values = (await told(page, "residual-over-time")).map((one) => Number.parseFloat(one.replace("at ", "").replace("−", "-")));
    const [measured, , fitted, residual] = values;
    assert.ok(Math.abs(measured - fitted - residual) < 1.01e-3 && residual !== 0, values.join());
    return values.at(-1);
  };
  assert.deepEqual([await at(areas[0]), await at(areas[1])], [0.01, 0.02]);
  assert.match(await page.locator("#live").textContent(), /^Time 0\.02 s\. measured: .* N, true: .* N, LuGre fitted: .* N, residual: .* N$/);
  // Of a thousand samples of white noise the farthest are three to four standard deviations away.
  const noise = Number(/Noise of the force([\d.]+) N/.exec(await page.locator(".worth").textContent())[1]);
  const farthest = /; band: 95 % of the noise\. residual from −([\d.]+) to ([\d.]+) N$/.exec(await text(page, "residual-over-time")).slice(1);
  assert.ok(farthest.every((one) => one > 2.5 * noise && one < 5 * noise), `${farthest} N, noise ${noise} N`);
  await areas[1].press("+");
  assert.notDeepEqual(await times("residual-over-time"), whole);
  assert.deepEqual(await times("friction-over-time"), await times("residual-over-time"));
  await areas[0].press("Escape");
  assert.deepEqual(await times("residual-over-time"), whole);
  assert.deepEqual(await barriers(page), []);
  assert.deepEqual(wrong, []);
});

test("the view of a fit begins with a record and its fit, unless the link is wrong", async () => {
  const { page, wrong } = await opened(QUICK);
  assert.match(await page.locator(".worth").textContent(), /Record: virtual rig with LuGre/);
  const rows = await page.locator(".outcome tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.ok(rows.some(([name, , , , , verdict]) => name === "mu_k" && verdict === "determined"), JSON.stringify(rows));
  assert.equal(await page.locator("figure.plot:visible").count(), VIEWS.fit);
  await reopened(page, "#v=1&view=fit&rig.weight=1");
  assert.match(await fault(page), /'rig.weight' is unknown/);
  assert.equal(await page.locator(".worth").textContent(), "");
  assert.deepEqual(wrong, []);
});

test("what there is not cannot be exported", async () => {
  const { page } = await opened("#v=1&view=fit&rig.mass=-1");
  await page.waitForFunction(() => /mass = -1/.test(document.querySelector("#fault").textContent));
  const off = () => page.locator(".take button:disabled").evaluateAll((all) => all.map((one) => one.id.replace(/^\w+?-/, "")));
  assert.deepEqual(await off(), ["copy-python", "copy-command", "save-csv", "save-toml", "save-ssv", "to-law"]);
  await reopened(page, "#v=1&view=law&law=Dahl");
  assert.deepEqual(await off(), []);
  await page.locator("[id='set-friction_mu_k']").fill("-1");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => !document.querySelector("#fault").hidden);
  await page.locator("[id='set-motion_stroke']").fill("0");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.querySelector("#law-save-csv").disabled);
  assert.deepEqual(await off(), ["copy-python", "copy-c", "save-csv", "save-ssv", "to-bench"]);
});

test("parameters have their meaning and their symbol beside their name", async () => {
  const { page } = await opened("#v=1&view=law&law=LuGre");
  const row = page.locator("[data-name='friction.sigma_0']");
  assert.equal(await row.locator(".symbol").textContent(), "σ0");
  const meaning = await row.locator(".meaning").textContent();
  assert.match(meaning, /stiffness of the bristles/i);
  // Whoever hears the page is told the same.
  const id = await row.locator("input[type=text]").getAttribute("aria-describedby");
  assert.equal(await page.locator(`[id='${id}']`).textContent(), meaning);
  const bare = await page.locator("[data-part=friction] .control").evaluateAll((rows) => rows.filter((one) => !one.querySelector(".symbol math") || !one.querySelector(".meaning").textContent).map((one) => one.dataset.name));
  assert.deepEqual(bare, []);
});

test("a browser whose searches cannot hear of their end says so", async () => {
  const { page, wrong } = await opened();
  await page.addInitScript(() => delete WebAssembly.Suspending);
  await reopened(page, "#v=1&view=fit&rig.duration=2");
  await measure(page);
  await page.locator("#start-fit").click();
  await page.waitForFunction(() => /Fitting LuGre/.test(document.querySelector("#fit .progress").textContent));
  await page.locator("#cancel-fit").click();
  assert.equal(await page.locator("#fit .progress").textContent(), "Stopped; this browser cannot return a partial result.");
  assert.ok(await page.locator("#start-fit").isEnabled());
  assert.deepEqual(wrong, []);
});

test("the seconds of a fit go on while its search is silent", async () => {
  const { page, wrong } = await opened(QUICK);
  await page.evaluate(() => (Worker.prototype.postMessage = () => {}));
  await page.locator("#start-fit").click();
  await page.waitForFunction(() => /Fitting LuGre for [1-9] s$/.test(document.querySelector("#fit .progress").textContent));
  assert.deepEqual(wrong, []);
});

test("a visitor with a spring of 500 N/m gets LuGre against Coulomb as a link", async () => {
  const { page, wrong } = await opened("", { permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#add-law-bench").click();
  await page.getByLabel("Search").fill("coulomb");
  await page.getByRole("checkbox", { name: "Coulomb Coulomb friction", exact: true }).check();
  await page.getByRole("button", { name: "Remove CoulombStiction" }).click();
  await page.getByLabel("stiffness", { exact: true }).and(page.locator("[type=text]")).fill("500");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Copy link" }).first().click();
  await page.getByRole("button", { name: "Link copied" }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(link.endsWith("#v=1&law=LuGre,Coulomb&rig.stiffness=500"), link);
  await computed(page);
  assert.deepEqual(await page.locator("#bench > .main > .legend strong").allTextContents(), ["LuGre", "Coulomb"]);
  assert.deepEqual(wrong, []);
});

test("silly numbers are refused by name, value and limit, and a message stays in sight", async () => {
  const { page, wrong } = await opened();
  const field = page.locator("[data-name='rig.mass'] input[type=text]");
  const silly = [["-1", /mass = -1: must be > 0/], ["1e400", /mass = inf: must be > 0 and finite/], ["0x10", /mass = '0x10': must be a number/], ["", /mass = '': must be a number/]];
  for (const [text, expected] of silly) {
    await field.fill(text);
    await page.keyboard.press("Tab");
    await page.waitForFunction((text) => document.querySelector("#fault").textContent.includes(text), text === "1e400" ? "inf" : text || "''");
    assert.match(await fault(page), expected);
  }
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  assert.ok(await page.locator("#fault").evaluate((line) => line.getBoundingClientRect().top >= 0), "it has scrolled out of sight");
  await page.evaluate(() => scrollTo(0, 0));
  await page.locator("#reset").click();
  await computed(page);
  assert.equal(await fault(page), "");
  await page.locator("#to-fit").click();
  await page.locator("#fit .solver summary").click();
  for (const [name, text, expected] of [["seed", "-1", /seed = -1: must be a whole number >= 0/], ["duration", "1e9", /duration = 1000000000 s: must be from 0.1 s to 1000 s/], ["seed", "1.5", /seed = 1.5: must be/]]) {
    const before = await page.locator(`#rig-${name}`).inputValue();
    await page.locator(`#rig-${name}`).fill(text);
    await page.locator("#measure-rig").click();
    await page.waitForFunction((text) => document.querySelector("#fault").textContent.includes(text), `${name} = `);
    assert.match(await fault(page), expected);
    await page.locator(`#rig-${name}`).fill(before);
    await page.keyboard.press("Tab");
    await page.locator("#measure-rig").click();
    await page.waitForFunction(() => document.querySelector("#fault").hidden && !document.querySelector("#start-fit").disabled);
  }
  assert.deepEqual(wrong, []);
});

/** Drops files on the page of the fit, and waits until they are read or refused. */
async function drop(page, files) {
  const seen = await drawn(page);
  await page.evaluate((files) => {
    const transfer = new DataTransfer();
    for (const { name, text } of files) transfer.items.add(new File([text], name));
    document.querySelector("#drop").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, files);
  await page.waitForFunction((seen) => Number(document.querySelector(".view").dataset.drawn) > seen + 1 || !document.querySelector("#fault").hidden, seen);
}

test("good files are read and spoilt ones are refused by what is wrong with them", async () => {
  const { page, wrong } = await opened(`${QUICK}&rig.duration=4`);
  const good = (await saved(page, () => page.locator("#fit-save-csv").click())).toString();
  await page.locator("#reset").click();
  const row = (number) => `${(0.001 * number).toFixed(3)},${Math.sin(number)},${0.001 * Math.cos(number)}\n`;
  const rows = (count) => Array.from({ length: count }, (_, number) => row(number)).join("");
  const spoilt = [
    ["", /empty|heading|column/],
    ["\u0000\u0001\u0002 PK\u0003\u0004", /time/],
    ["time [s],force [N]\n0,1\n1,2\n", /at least 20|displacement/],
    [`time [s],force [furlong],displacement [m]\n${rows(30)}`, /furlong/],
    [`time [s],force [N],displacement [m]\n${rows(30)}0.001,1,1\n`, /times must ascend/],
    [`time [s],force [N],displacement [m]\n${rows(30)}0.030,one,1\n`, /one/],
    [`time [s],force [N],displacement [m]\n${rows(5)}`, /5 samples; at least 20/],
  ];
  for (const [content, expected] of spoilt) {
    await drop(page, [{ name: "spoilt.csv", text: content }]);
    assert.match(await fault(page), /^spoilt\.csv: /, JSON.stringify(content.slice(0, 40)));
    assert.match(await fault(page), expected);
    assert.ok(await page.locator("#start-fit").isDisabled());
  }
  await drop(page, [1, 2, 3].map((number) => ({ name: `${number}.csv`, text: good })));
  assert.match(await fault(page), /3 files: must be 1, or 2/);
  await drop(page, [{ name: "good.csv", text: good }]);
  assert.match(await fault(page), /^good\.csv: no column 'normal_force', and no value was given for it$/);
  await page.locator("#rig-normal_force").fill("20");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Record: good\.csv.*4001 over 4 s/.test(document.querySelector(".worth").textContent));
  assert.equal(await fault(page), "");
  assert.ok(await page.locator("#start-fit").isEnabled());
  // By the file chooser, as with a keyboard: decimal commas, other units.
  const file = join(folder, "other.csv");
  const commas = good.trim().split("\n").slice(1).map((row) => row.split(",").map((one, at) => String(Number(one) * [1e3, 1, 1e3][at]).replace(".", ",")).join(";"));
  writeFileSync(file, `time [ms];force [N];displacement [mm]\n${commas.join("\n")}\n`);
  await page.locator("#record").setInputFiles(file);
  await page.waitForFunction(() => /Record: other\.csv/.test(document.querySelector(".worth").textContent));
  assert.match(await page.locator(".worth").textContent(), /4001 over 4 s/);
  assert.ok(readFileSync(file).length > 1000);
  assert.deepEqual(wrong, []);
});

test("a map of a joint is fitted as steady sliding, in the words and units of a joint", { timeout: 120_000 }, async () => {
  const { page, wrong } = await opened("#v=1&view=fit&law=CoulombViscous&fit.budget=200&fit.repetitions=2");
  const speeds = [-3, -2, -1, -0.5, 0.5, 1, 2, 3];
  const rows = speeds.flatMap((v) => [0.02, -0.02].map((noise) => `${v},${(Math.sign(v) * 1.5 + 0.25 * v + noise).toFixed(4)}\n`));
  await drop(page, [{ name: "joint.csv", text: `velocity [rad/s],torque [N.m]\n${rows.join("")}` }]);
  // What is not known of the rig that made a file is not made up.
  assert.match(await fault(page), /^joint\.csv: .*give normal_force; with 1 the coefficients are forces, or torques of a joint$/);
  await page.locator("#rig-normal_force").fill("1");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Map: joint\.csv.*16 at 8 speeds/.test(document.querySelector(".worth").textContent));
  assert.match(await page.locator("label[for=rig-mass]").textContent(), /^Moment of inertia$/);
  assert.match(await page.locator(".worth").textContent(), /Angular velocity−3 to 3 rad\/s.*Scatter of the repeats0\.02828 N·m/);
  await page.locator("#start-fit").click();
  await page.locator(".outcome table").first().waitFor();
  const cells = await page.locator(".outcome tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  const value = (wanted) => Number(cells.find(([name]) => name === wanted)[1].split(" ")[0]);
  assert.ok(Math.abs(value("mu_k") - 1.5) < 1e-3 && Math.abs(value("viscous_coefficient") - 0.25) < 1e-3, JSON.stringify(cells));
  assert.deepEqual(await page.locator("#fit [data-kind]").evaluateAll((all) => all.filter((one) => !one.hidden).map((one) => one.dataset.kind)), ["friction-over-velocity", "residual-over-velocity"]);
  // Each row is as far from the law as it was made, and the cursor goes from row to row.
  assert.match(await text(page, "residual-over-velocity"), /^Residual over angular velocity; band: 95 % of the scatter\. residual from −0\.02 to 0\.02 N·m$/);
  await page.getByLabel("Friction torque over angular velocity", { exact: true }).press("End");
  assert.deepEqual(await told(page, "residual-over-velocity"), ["2.23 N·m", "2.25 N·m", "−0.02 N·m", "at 3 rad/s"]);
  const whole = await across(page, "residual-over-velocity");
  await page.getByLabel("Friction torque over angular velocity", { exact: true }).press("+");
  const part = await across(page, "residual-over-velocity");
  assert.ok(part.length > 1 && part.join() !== whole.join(), part.join());
  assert.deepEqual(await across(page, "friction-over-velocity"), part);
  const picture = await svg(page, "friction-over-velocity");
  for (const text of ["Friction torque over angular velocity", "Angular velocity in rad/s", "Friction torque in N·m", "CoulombViscous, 1 N·m"]) {
    assert.ok(picture.includes(text), text);
  }
  assert.equal(await copied(page, "#fit-copy-command"), "stribeck identify joint.csv --budget 200 --law CoulombViscous --normal-force 1.0 --repetitions 2");
  await page.locator("#fit-to-law").click();
  await page.waitForFunction(() => /view=law&.*friction\.mu_k=1\.5/.test(location.hash));
  assert.deepEqual(wrong, []);
});

test("a record of a joint shows torque over angle", async () => {
  const { page, wrong } = await opened("#v=1&view=fit&law=CoulombViscous");
  const row = (number) => {
    const time = 0.005 * number;
    return `${time},${Math.sign(Math.cos(3 * time)) * 2},${57.2958 * Math.sin(3 * time)}\n`;
  };
  await drop(page, [{ name: "arm.csv", text: `time [s],torque [N.m],angle [deg]\n${Array.from({ length: 1500 }, (_, at) => row(at)).join("")}` }]);
  await page.locator("#rig-normal_force").fill("1");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Record: arm\.csv/.test(document.querySelector(".worth").textContent));
  const picture = await svg(page, "friction-over-displacement");
  assert.ok(picture.includes("Friction torque over angle") && picture.includes("Angle in rad"), picture.slice(0, 300));
  assert.deepEqual(await page.locator("#fit .choices .unit").evaluateAll((all) => all.slice(0, 2).map((one) => one.textContent)), ["kg·m²", "N·m"]);
  assert.deepEqual(wrong, []);
});

/** A record of a rope around half a drum: mu_k = 0.12, 1 mm of pre-sliding, 10 N on side 1. */
function rope() {
  let [share, before] = [1, 0];
  const row = (number) => {
    const [time, sense] = [0.004 * number, Math.sign(Math.cos(8 * 0.004 * number))];
    const way = 4e-3 * Math.sin(8 * time);
    share = sense - (sense - share) * Math.exp(-Math.abs(way - before) / 1e-3);
    before = way;
    return `${time},${way},${10 * Math.expm1(0.12 * Math.PI * share) + 0.01 * Math.sin(1e4 * time * time)}\n`;
  };
  return `time [s],displacement [m],force [N]\n${Array.from({ length: 300 }, (_, number) => row(number)).join("")}`;
}

test("a component is fitted to a record of its own, driven by a column or a value", { timeout: 120_000 }, async () => {
  const { page, wrong } = await opened("#v=1&view=fit&law=Capstan&fit.budget=60&fit.repetitions=2&fit.fix=preload%3D0");
  assert.match(await page.locator(".worth").textContent(), /drop a record of Capstan, with time, force, displacement or velocity, tension_1 \[N\]\.$/);
  assert.ok(await page.locator("#start-fit").isDisabled());
  assert.equal(await page.locator("#rig-normal_force").count(), 0);
  assert.deepEqual(await barriers(page), []);
  await drop(page, [{ name: "rope.csv", text: rope() }]);
  assert.match(await fault(page), /^rope\.csv: no column 'tension_1'; there are .*: it drives Capstan, in N; /);
  await page.getByLabel("Tension 1").fill("ten");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /tension_1 = 'ten': must be a number/.test(document.querySelector("#fault").textContent));
  await page.getByLabel("Tension 1").fill("10");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Record: rope\.csv.*300 over/.test(document.querySelector(".worth").textContent));
  assert.equal(await fault(page), "");
  await page.locator("#start-fit").click();
  await page.locator(".outcome table").first().waitFor();
  const rows = await page.locator(".outcome tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  const [, estimate, , repeated, verdict] = rows.find(([name]) => name === "mu_k");
  assert.equal(verdict, "determined");
  assert.ok(Math.abs(Number.parseFloat(estimate) - 0.12) < 0.01 && repeated !== "", JSON.stringify(rows));
  assert.match(await page.locator(".outcome .note").textContent(), /^Capstan is a component: save its values as SSV/);
  assert.equal(await page.locator("figure.plot:visible").count(), VIEWS.fit);
  const off = await page.locator(".take button:disabled").evaluateAll((all) => all.map((one) => one.id));
  assert.deepEqual(off, ["fit-save-toml", "fit-to-law"]);
  assert.match((await saved(page, () => page.locator("#fit-save-ssv").click())).toString(), /name="mu_k"/);
  assert.equal(
    await copied(page, "#fit-copy-command"),
    "stribeck identify rope.csv --budget 60 --fix preload=0.0 --fix tension_1=10.0 --law Capstan --repetitions 2",
  );
  assert.deepEqual(await barriers(page), []);
  // A law needs a normal force again, and no tension.
  await page.locator("#add-law-fit").click();
  await page.locator("#law-fit-Coulomb").check();
  await page.waitForFunction(() => /no column 'normal_force'/.test(document.querySelector("#fault").textContent));
  await page.getByRole("button", { name: "Remove Capstan" }).click();
  await page.waitForFunction(() => !document.querySelector("#held-tension_1"));
  assert.ok(!page.url().includes("held."), page.url());
  await page.locator("#rig-normal_force").fill("20");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Record: rope\.csv/.test(document.querySelector(".worth").textContent));
  // The normal force of the rig is not that of a component.
  await page.locator("#law-fit-Capstan").check();
  await page.getByRole("button", { name: "Remove Coulomb" }).click();
  await page.getByLabel("Tension 1").fill("10");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => /Record: rope\.csv/.test(document.querySelector(".worth").textContent));
  assert.equal(await fault(page), "");
  assert.deepEqual(wrong, []);
});

test("a law in place of a component, by the list or by a link, begins with the virtual rig", async () => {
  const { page, wrong } = await opened();
  const cheap = "fit.budget=100&fit.repetitions=0&rig.duration=1";
  const byList = async () => {
    await page.locator("#add-law-fit").click();
    await page.locator("#law-fit-Coulomb").check();
    await page.getByRole("button", { name: "Remove Capstan" }).click();
  };
  const byLink = () => page.evaluate((cheap) => (location.hash = `#v=1&view=fit&law=Coulomb&${cheap}`), cheap);
  for (const change of [byList, byLink]) {
    await reopened(page, `#v=1&view=fit&law=Capstan&${cheap}`);
    await change();
    await page.waitForFunction(() => /virtual rig with LuGre/.test(document.querySelector(".worth").textContent));
  }
  assert.deepEqual(wrong, []);
});

test("everything is reached by the keyboard, and the focus is never lost", async () => {
  for (const view of Object.keys(VIEWS)) {
    const { page, close } = await opened(view === "fit" ? QUICK : `#v=1&view=${view}`);
    await page.evaluate(() => document.activeElement?.blur());
    const wanted = await page.evaluate(() => {
      const all = document.querySelectorAll("button, select, input, summary, [tabindex='0']");
      const seen = [...all].filter((one) => one.checkVisibility() && !one.disabled);
      seen.forEach((one, number) => (one.dataset.stop = String(number)));
      return seen.length;
    });
    const found = new Set();
    for (let press = 0; press < wanted + 5; press++) {
      await page.keyboard.press("Tab");
      const stop = await page.evaluate(() => document.activeElement?.dataset.stop);
      if (stop !== undefined) found.add(stop);
    }
    assert.equal(found.size, wanted, view);
    await close();
  }
});
