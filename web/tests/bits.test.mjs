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

/** Hashes of the answers of the native library. */
function natively(questions) {
  return new Promise((resolve, reject) => {
    const child = spawn(PYTHON, [fileURLToPath(new URL("native.py", import.meta.url)), NATIVE], {
      stdio: ["pipe", "pipe", "inherit"],
    });
    let text = "";
    child.stdout.on("data", (data) => (text += data));
    child.on("error", reject);
    child.on("close", () => resolve(text.trim().split("\n")));
    child.stdin.end(questions.map((question) => `${JSON.stringify(question)}\n`).join(""));
  });
}

async function agree(questions, answers) {
  const native = await natively(questions);
  questions.forEach((question, at) => assert.equal(answers[at].hash, native[at], JSON.stringify(question).slice(0, 400)));
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

test("curves, strokes, records and fits have the same bits", { timeout: 600_000 }, async () => {
  const heard = [];
  let end;
  const ask = await open(LIBRARY, (rms) => {
    heard.push(rms);
    return Number(heard.length === end);
  });
  const { laws, fitted } = ask({ ask: "catalogue" }).answer;
  const questions = [];
  for (const { name, variables } of laws) {
    const held = Object.fromEntries(variables.filter(({ name }) => name === "normal_force").map(({ name }) => [name, 1]));
    const strokes = { model: name, held, velocity: 0.02, stroke: 1e-4, speed: 0.02 };
    questions.push({ ask: "strokes", ...strokes }, { ask: "curve", ...strokes });
  }
  const rig = (duration, faults) => ({ ask: "rig", rig: { law: "LuGre", mass: "2", normal_force: "20", duration, faults, seed: "3" } });
  const asked = ({ force, camera }, law = "", options = {}) => {
    const fit = { records: "force", law, mass: "2", normal_force: "20", ...options, ...(camera === null ? {} : { motion: "camera", delay: "find:0.05" }) };
    return { fit, files: { force, ...(camera === null ? {} : { camera }) } };
  };
  const measured = rig("1.5", "true");
  questions.push(measured, { ask: "quality", ...asked(ask(measured).answer) });
  const answers = questions.map(ask);
  // Forces that keep fluctuating are refused.
  const refused = answers.filter(({ answer }) => answer.refused).map(({ answer }) => answer.refused);
  assert.ok(refused.length < 6 && refused.every((text) => text.includes("do not settle")), refused.join("\n"));
  assert.ok(fitted.length > 25);
  await agree(questions, answers);
  console.log(`figure: curves and strokes of ${laws.length} laws and a record: ${values(answers)} values with the same bits`);
  const short = ask(rig("0.6", "false")).answer;
  const cheap = { budget: "100", repetitions: "2" };
  const fits = [["Coulomb", "LuGre"], ["Stribeck", "Dahl", "MaxwellSlip"]].map((laws) => ({ ask: "fit", ...asked(short, laws.join(), cheap) }));
  // A component has no normal force; JSON leaves out what is undefined.
  fits.push({ ask: "fit", ...asked(short, "Capstan", { ...cheap, normal_force: undefined, fix: "tension_1=20,preload=0" }) });
  const found = fits.map(ask);
  await agree(fits, found);
  for (const { answer } of found) assert.ok(answer.ranking.laws[0].estimates.some(({ repeated }) => repeated), JSON.stringify(answer).slice(0, 400));
  console.log("figure: fits of 5 laws and a component with intervals and repetitions: the same bits");
  assert.ok(heard.length > 10 && heard.at(-1) < heard[0], "the search tells how far it is");
  // What a search that is ended has told last is what it answers with.
  heard.length = 0;
  end = 3;
  const { answer } = ask({ ask: "fit", ...asked(short, "LuGre", { budget: "3000" }) });
  assert.match(answer.early, /^ended early: the best values so far/);
  assert.ok(heard.length < 10, `${heard.length} reports`);
  assert.ok(answer.ranking.laws[0].rms <= Math.max(...heard), `${answer.ranking.laws[0].rms} N after ${heard}`);
  assert.ok(answer.ranking.laws[0].estimates.every(({ repeated }) => repeated === null));
});
