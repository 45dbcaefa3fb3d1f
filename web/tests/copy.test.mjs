// What is copied and saved gives the same curves elsewhere, to the last bit.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { copied, folder, opened, saved } from "./browser.mjs";

const { PYTHON, PACKAGE, STRIBECK, C_COMPILER, C_LIBRARY } = process.env;
const INCLUDE = resolve("include");

const numbers = (text) => text.trim().split("\n").slice(1).map((row) => row.split(",").map(Number));

/** What a Python program prints. */
function python(text) {
  const file = join(folder, "copied.py");
  writeFileSync(file, text);
  return execFileSync(PYTHON, [file], { cwd: folder, env: { ...process.env, PYTHONPATH: PACKAGE }, encoding: "utf8", maxBuffer: 1e8 });
}

/** What the command line writes to a table. */
function commanded(words) {
  const out = join(folder, "commanded.csv");
  execFileSync(STRIBECK, [...words, "--out", out], { encoding: "utf8" });
  return readFileSync(out, "utf8");
}

/** Words of a command as a shell reads it. */
const words = (command) => [...command.matchAll(/'([^']*)'|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain).slice(1);

test("runs are the same on the command line, in Python and from a file", async () => {
  const links = [
    "#v=1&law=LuGre&rig.mass=1.3&friction.mu_s=0.17&until=12&tol=1e-7",
    "#v=1&system=motion&law=Leuven&until=0.3&friction.velocity.amplitude=0.004",
    "#v=1&view=strut&law=CoulombStiction&strut.length.amplitude=0.013&strut.side_force_m=250",
  ];
  for (const link of links) {
    const { page, close } = await opened(link);
    const view = link.includes("view=strut") ? "strut" : "bench";
    const table = (await saved(page, () => page.locator(`#${view}-save-csv`).click())).toString();
    assert.ok(table.length > 1000);
    const command = await copied(page, `#${view}-copy-command`);
    assert.equal(commanded(words(command)), table, command);
    const toml = join(folder, "saved.toml");
    writeFileSync(toml, await saved(page, () => page.locator(`#${view}-save-toml`).click()));
    assert.equal(commanded(["run", "--config", toml]), table, link);
    const script = await copied(page, `#${view}-copy-python`);
    const heading = table.split("\n", 1)[0].split(",").slice(1).map((one) => one.replace(/ \[.*/, ""));
    const told = JSON.parse(python(`${script}\nimport json\nprint(json.dumps([solution[name].tolist() for name in ${JSON.stringify(heading)}]))\n`));
    const rows = numbers(table);
    told.forEach((column, at) => assert.deepEqual(column, rows.map((row) => row[at + 1]), `${link}: ${heading[at]}`));
    await close();
  }
});

/** What a program in C prints. */
function compiled(text) {
  const source = join(folder, "copied.c");
  writeFileSync(source, text);
  const program = join(folder, "copied");
  execFileSync(C_COMPILER, ["-std=c99", "-Wall", "-Wextra", "-Werror", "-I", INCLUDE, source, "-L", C_LIBRARY, "-lstribeck", "-o", program]);
  return execFileSync(program, { env: { ...process.env, LD_LIBRARY_PATH: C_LIBRARY }, encoding: "utf8", maxBuffer: 1e8 });
}

test("co-simulation of a system is the same in C", async () => {
  const links = [
    "#v=1&law=LuGre&rig.mass=1.3&until=9",
    "#v=1&system=belt&law=CoulombStiction&friction.mu_s=0.2&until=8",
    // Inputs that move: sines, and straight lines.
    "#v=1&view=strut&law=Dahl&strut.side_force_m=250&strut.length.amplitude=0.013",
    "#v=1&view=strut&system=dyno-ramps&until=0.9996",
  ];
  for (const link of links) {
    const { page, close } = await opened(`${link}&solver=co-simulation`);
    const view = link.includes("view=strut") ? "strut" : "bench";
    const table = (await saved(page, () => page.locator(`#${view}-save-csv`).click())).toString();
    const printed = compiled(await copied(page, `#${view}-copy-c`));
    const columns = (text) => {
      const heading = text.split("\n", 1)[0].trim().split(",");
      return Object.fromEntries(heading.map((name, at) => [name, numbers(text).map((row) => row[at])]));
    };
    const [here, there] = [columns(table), columns(printed)];
    assert.ok(Object.keys(there).length >= 4 && there["time [s]"].length > 400);
    for (const [name, column] of Object.entries(there)) assert.deepEqual(column, here[name], `${link}: ${name}`);
    if (view === "strut") assert.ok("strut.friction_1 [N]" in there, Object.keys(there).join());
    await close();
  }
  const { page } = await opened("#v=1&law=LuGre");
  await page.locator("#bench-copy-c").click();
  await page.waitForFunction(() => /solver auto: a program in C makes steps of the models; choose co-simulation/.test(document.querySelector("#fault").textContent));
});

test("strokes are the same in Python and C", async () => {
  const links = [
    "#v=1&view=law&law=LuGre&friction.sigma_0=23456.7&held.normal_force=12.5&motion.speed=0.00031",
    "#v=1&view=law&law=Stribeck&friction.curve=Tustin&held.external_force=0.25",
    "#v=1&view=law&law=NonReversible",
    "#v=1&view=law&law=Liang",
  ];
  for (const link of links) {
    const { page, close } = await opened(link);
    const rows = numbers((await saved(page, () => page.locator("#law-save-csv").click())).toString());
    assert.equal(rows.length, 801);
    const forces = rows.map(([, , , force]) => force);
    assert.ok(Math.max(...forces) > 0.1);
    const result = link.includes("Liang") ? "friction_force_x" : "friction_force";
    const script = await copied(page, "#law-copy-python");
    const told = JSON.parse(python(`${script.replace(/print.*\n$/, "")}\nimport json\nprint(json.dumps([list(way), list(velocity), loop["${result}"].tolist()]))\n`));
    assert.deepEqual(told, [1, 2, 3].map((at) => rows.map((row) => row[at])), `${link} in Python`);
    const printed = compiled(await copied(page, "#law-copy-c"));
    assert.deepEqual(numbers(`heading\n${printed}`).map(([, , force]) => force), forces, `${link} in C`);
    await close();
  }
});

test("curves at held velocities are those of Python", async () => {
  const { page } = await opened("#v=1&view=law&law=LuGre&friction.mu_s=0.21&held.normal_force=7.5");
  const script = await copied(page, "#law-copy-python");
  const [velocity, force] = JSON.parse(python(`${script}\nimport json\nprint(json.dumps([list(held), list(force)]))\n`.replace(/print\(loop.*\n/, "")));
  // The table behind the plot has one of five of its points.
  await page.locator("[data-kind=force-at-held-velocity] summary").click();
  await page.locator("[data-kind=force-at-held-velocity] tbody tr").first().waitFor();
  const cells = await page.locator("[data-kind=force-at-held-velocity] tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => Number(cell.textContent.replace("\u2212", "-").replace("e\u2212", "e-")))));
  assert.ok(cells.length > 30);
  const every = Math.ceil(200 / 40);
  cells.forEach(([v, f], row) => {
    const at = row * every;
    assert.ok(Math.abs(v - velocity[at]) <= 1e-3 * Math.abs(velocity[at]) && Math.abs(f - force[at]) <= 1e-3 * Math.abs(force[at]) + 1e-12, `${v} m/s: ${f} N, in Python ${force[at]} N`);
  });
  const ssv = (await saved(page, () => page.locator("#law-save-ssv").click())).toString();
  const set = await page.evaluate((text) => {
    const file = new DOMParser().parseFromString(text, "application/xml");
    return [...file.getElementsByTagNameNS("*", "Parameter")].map((one) => [one.getAttribute("name"), one.firstElementChild.getAttribute("value")]);
  }, ssv);
  assert.deepEqual(set, [["mu_s", "0.21"]]);
});

/** Values of a parameter set in TOML. */
const values = (toml) => Object.fromEntries([...toml.matchAll(/^(\w+) = (-?[\d.e+-]+)$/gm)].map(([, name, value]) => [name, Number(value)]));

test("a fit is the same on the command line and in Python, with a camera too", { timeout: 300_000 }, async () => {
  for (const faults of [false, true]) {
    const link = `#v=1&view=fit&law=Coulomb&rig.law=CoulombViscous&fit.budget=200&fit.repetitions=2&rig.duration=2&rig.faults=${faults}`;
    const { page, close } = await opened(link);
    await page.locator(".outcome table").first().waitFor();
    const toml = values((await saved(page, () => page.locator("#fit-save-toml").click())).toString());
    assert.ok(toml.mu_k > 0.01, JSON.stringify(toml));
    const downloads = [];
    page.on("download", (download) => downloads.push(download));
    await page.locator("#fit-save-csv").click();
    await page.waitForTimeout(500);
    assert.deepEqual(downloads.map((one) => one.suggestedFilename()), faults ? ["force.csv", "motion.csv"] : ["force.csv"]);
    for (const one of downloads) await one.saveAs(join(folder, one.suggestedFilename()));
    const command = await copied(page, "#fit-copy-command");
    execFileSync(STRIBECK, [...words(command), "--out", "found.toml"], { cwd: folder });
    assert.deepEqual(values(readFileSync(join(folder, "found.toml"), "utf8")), toml, command);
    const script = await copied(page, "#fit-copy-python");
    const found = JSON.parse(python(`${script.replace(/print.*\n$/, "")}\nimport json\nprint(json.dumps(found.best.values))\n`));
    for (const [name, value] of Object.entries(toml)) assert.equal(found[name], value, `${name}: ${script}`);
    await close();
  }
});
