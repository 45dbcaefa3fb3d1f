// The library as WebAssembly against the same one for this machine.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { open } from "./engine.mjs";

const { LIBRARY, NATIVE, PYTHON } = process.env;
const RUNS = 500;
/** Laws that the solver halves steps for take long: they are run for a short time. */
const SHORT = 0.05;

/** Numbers below one, the same in every run (Park and Miller). */
function random(seed) {
  let state = seed;
  return () => (state = (48271 * state) % 2147483647) / 2147483647;
}

/** Hashes of the answers of the native library, and what it tells of a fit. */
function natively(questions) {
  return new Promise((resolve, reject) => {
    const child = spawn(PYTHON, [fileURLToPath(new URL("native.py", import.meta.url)), NATIVE], {
      stdio: ["pipe", "pipe", "inherit"],
    });
    let text = "";
    child.stdout.on("data", (data) => (text += data));
    child.on("error", reject);
    child.on("close", () => resolve(text.trim().split("\n").map((line) => line.split("\t"))));
    child.stdin.end(questions.map((question) => `${JSON.stringify(question)}\n`).join(""));
  });
}

async function agree(questions, answers) {
  const native = await natively(questions);
  questions.forEach((question, at) => assert.equal(answers[at].hash, native[at][0], JSON.stringify(question).slice(0, 400)));
}

/** Numbers of the fits of two libraries, compared with the intervals. */
function alike(one, other) {
  assert.deepEqual(one.laws.map(({ law }) => law), other.laws.map(({ law }) => law));
  one.laws.forEach(({ estimates }, place) => {
    estimates.forEach(({ name, verdict, value, interval }, at) => {
      const there = other.laws[place].estimates[at];
      assert.deepEqual([name, verdict.slice(0, 12)], [there.name, there.verdict.slice(0, 12)]);
      if (value === null) return;
      const [low, high] = interval;
      assert.ok(Math.abs(value - there.value) < 1e-3 * (high - low), `${name}: ${value} and ${there.value} of ${high - low}`);
    });
  });
}

const values = (answers) => answers.reduce((sum, { arrays }) => sum + arrays.reduce((all, array) => all + array.length, 0), 0);

test("runs of systems have the same bits in a browser and on this machine", { timeout: 600_000 }, async () => {
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
  // Whole runs of laws that are quick, through stick and slip; sines as inputs; a strut.
  for (const law of ["CoulombStiction", "LuGre", "Karnopp", "Andersson"]) {
    for (const system of ["belt", "motion", "dyno", "dyno-ramps"]) questions.push({ ask: "solve", run: { system, law: [law] }, law });
  }
  const answers = questions.map(ask);
  const solved = answers.filter(({ answer }) => answer.reached);
  await agree(questions, answers);
  assert.equal(new Set(solved.map(({ answer }) => answer.law)).size, laws.length, "every law has run");
  assert.ok(solved.length > 0.95 * questions.length, `only ${solved.length} runs`);
  console.log(`figure: ${solved.length} runs over ${laws.length} laws: ${values(solved)} values with the same bits`);
});

test("curves, strokes and records have the same bits, and fits the same values", { timeout: 600_000 }, async () => {
  const heard = [];
  const ask = await open(LIBRARY, (rms) => heard.push(rms));
  const { laws, fitted } = ask({ ask: "catalogue" }).answer;
  const velocity = Array.from({ length: 41 }, (_, at) => 1e-3 * (at - 20));
  const questions = [];
  for (const { name, variables } of laws) {
    const inputs = {};
    for (const { name: input, role } of variables) if (role === "Input") inputs[input] = [/^normal_(force|z)$/.test(input) ? 1 : 0];
    const along = "velocity" in inputs ? "velocity" : "velocity_x";
    const result = variables.find(({ name }) => /^friction_force(_x)?$/.test(name)).name;
    const series = { model: name, set: {}, inputs: { ...inputs, [along]: velocity }, results: [result] };
    questions.push({ ask: "follow", every: 1e-4, series }, { ask: "settle", ...series });
  }
  const rig = { ask: "rig", law: "LuGre", mass: 2, normal_force: 20, duration: 1.5, faults: true, seed: 3 };
  const { force, camera } = ask(rig).answer;
  const known = { table: force, motion: camera, longest_delay: 0.05, mass: 2, normal_force: 20 };
  const wanted = { laws: ["Coulomb", "LuGre"], budget: 200, repetitions: 2 };
  questions.push(rig, { ask: "quality", ...known });
  const answers = questions.map(ask);
  // Forces that keep fluctuating are refused.
  const refused = answers.filter(({ answer }) => answer.refused).map(({ answer }) => answer.refused);
  assert.ok(refused.length < 6 && refused.every((text) => text.includes("do not settle")), refused.join("\n"));
  assert.ok(fitted.length > 25);
  await agree(questions, answers);
  console.log(`figure: curves and strokes of ${laws.length} laws and a record: ${values(answers)} values with the same bits`);
  // The products of matrices in a search are summed in an order that depends on the processor.
  const fit = { ask: "fit", known, wanted };
  const { answer } = ask(fit);
  const [[, there]] = await natively([fit]);
  alike(answer.ranking, JSON.parse(there).answer.ranking);
  assert.ok(heard.length > 10 && heard.at(-1) < heard[0], "the search tells how far it is");
});
