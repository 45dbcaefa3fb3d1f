/** A law led to and fro, and at held velocities: on the page, in Python and in C. */

import { literal } from "./copy";
import type { Model, Series, Value } from "./types";

/** Samples of a period, periods, and velocities on a curve (chosen). */
const PERIOD = 400;
const PERIODS = 2;
const POINTS = 201;

export interface Motion {
  /** Highest velocity of the curve, m/s. */
  velocity: number;
  /** Length of the strokes, m, and their highest speed, m/s. */
  stroke: number;
  speed: number;
}

/** What acts on a law that slides along one line: by the names of its inputs. */
const ACROSS: Record<string, number> = { velocity_y: 0, velocity_z: 0, normal_x: 0, normal_y: 0, normal_z: 1 };

export class Strokes {
  readonly velocity: string;
  readonly force: string;
  private readonly hasAcceleration: boolean;
  private readonly held: Record<string, number>;

  constructor(
    private readonly model: Model,
    private readonly parameters: Record<string, Value>,
    /** Values of inputs that are held. */
    inputs: Record<string, number>,
    private readonly motion: Motion,
  ) {
    const names = model.variables.map(({ name }) => name);
    this.velocity = names.includes("velocity") ? "velocity" : "velocity_x";
    this.force = names.includes("friction_force") ? "friction_force" : "friction_force_x";
    this.hasAcceleration = names.includes("acceleration");
    const across = Object.entries(ACROSS).filter(([name]) => names.includes(name));
    this.held = { ...Object.fromEntries(across), ...inputs };
  }

  /** Interval of the samples, s: the speed rises and falls along straight lines, so that a stroke takes 2 s / v. */
  get every(): number {
    return (4 * this.motion.stroke) / this.motion.speed / PERIOD;
  }

  private series(inputs: Record<string, number[]>): Series {
    const held = Object.entries(this.held).map(([name, value]) => [name, [value]]);
    return { model: this.model.name, set: this.parameters, inputs: { ...Object.fromEntries(held), ...inputs }, results: [this.force] };
  }

  /** Velocities of the curve, closer together near 0. */
  get velocities(): number[] {
    const middle = (POINTS - 1) / 2;
    return Array.from({ length: POINTS }, (_, at) => {
      const x = (at - middle) / middle;
      return this.motion.velocity * x * Math.abs(x);
    });
  }

  /** Forces at held velocities. */
  get curve(): Series {
    const acceleration: Record<string, number[]> = this.hasAcceleration ? { acceleration: [0] } : {};
    return this.series({ [this.velocity]: this.velocities, ...acceleration });
  }

  get speeds(): number[] {
    const { speed } = this.motion;
    return Array.from({ length: PERIODS * PERIOD + 1 }, (_, at) => {
      const u = (at % PERIOD) / (PERIOD / 4);
      return speed * (u <= 1 ? u : u <= 3 ? 2 - u : u - 4);
    });
  }

  private get accelerations(): number[] {
    const slope = this.motion.speed / ((PERIOD / 4) * this.every);
    return this.speeds.map((_, at) => (Math.floor((at % PERIOD) / (PERIOD / 4)) % 3 === 0 ? slope : -slope));
  }

  /** Forces along the strokes. */
  get loop(): Series {
    const acceleration: Record<string, number[]> = this.hasAcceleration ? { acceleration: this.accelerations } : {};
    return this.series({ [this.velocity]: this.speeds, ...acceleration });
  }

  /** Displacement at the samples: the sum of trapezia. */
  get displacements(): Float64Array {
    const v = this.speeds;
    const way = new Float64Array(v.length);
    for (let at = 1; at < v.length; at++) way[at] = way[at - 1]! + 0.5 * (v[at - 1]! + v[at]!) * this.every;
    return way;
  }

  /** The same in Python. */
  asPython(): string {
    const { velocity, speed } = this.motion;
    const others = Object.entries({ ...this.held, ...this.parameters });
    const given = others.map(([name, value]) => `    ${JSON.stringify(name)}: ${literal(value)},\n`).join("");
    const slope = `speed / (${PERIOD / 4} * dt)`;
    const acceleration = `\nacceleration = numpy.where(k // ${PERIOD / 4} % 3 == 0, ${slope}, -${slope})`;
    const lead = this.hasAcceleration ? ", acceleration=acceleration" : "";
    const steady =
      this.velocity === "velocity"
        ? `\nx = (numpy.arange(${POINTS}) - ${(POINTS - 1) / 2}) / ${(POINTS - 1) / 2}\n` +
          `held = ${velocity} * x * abs(x)  # m/s\nforce = stribeck.force("${this.model.name}", held, **given)  # N\n`
        : "";
    return (
      `import numpy\nimport stribeck\n\ngiven = {\n${given}}${steady ? "\n" : "\n"}${steady}\n` +
      `# Strokes to and fro, whose speed rises and falls along straight lines.\n` +
      `speed, dt = ${speed}, ${this.every}  # m/s, s\nk = numpy.arange(${PERIODS * PERIOD + 1}) % ${PERIOD}\nu = k / ${PERIOD / 4}\n` +
      `velocity = speed * numpy.where(u <= 1, u, numpy.where(u <= 3, 2 - u, u - 4))` +
      `${this.hasAcceleration ? acceleration : ""}\n` +
      `loop = stribeck.simulate("${this.model.name}", ${this.velocity}=velocity${lead}, dt=dt, **given)\n` +
      `way = numpy.concatenate([[0.0], numpy.cumsum(0.5 * (velocity[:-1] + velocity[1:]) * dt)])  # m\n` +
      `print(loop["${this.force}"])\n`
    );
  }

  /** The strokes in C. */
  asC(): string {
    const lines = Object.entries({ ...this.held, ...this.parameters }).map(([name, value]) => {
      const choices = this.model.variables.find((variable) => variable.name === name)?.choices ?? [];
      const chosen = choices.findIndex((choice) => choice.name === value) + 1;
      const number = chosen > 0 ? chosen : Number(value);
      return `    check(stribeck_set_by_name(law, "${name}", ${number}), law);\n`;
    });
    const count = PERIODS * PERIOD + 1;
    const inputs = this.hasAcceleration ? [this.velocity, "acceleration"] : [this.velocity];
    const find = (name: string, place: string) => `    check(stribeck_find(law, "${name}", ${place}), law);\n`;
    return `/* Strokes to and fro, whose speed rises and falls along straight lines. */
#include <stdio.h>
#include <stdlib.h>
#include "stribeck.h"

#define SAMPLES ${count}

static void check(stribeck_status status, const stribeck_instance *law) {
    if (status != STRIBECK_OK) {
        fprintf(stderr, "%s\\n", stribeck_last_error(law));
        exit(1);
    }
}

int main(void) {
    static double velocity[SAMPLES], acceleration[SAMPLES], force[SAMPLES];
    const double speed = ${this.motion.speed}, dt = ${this.every}; /* m/s, s */
    stribeck_instance *law = NULL;
    uint32_t in[2], out;
    const double *given[2] = {velocity, acceleration};
    double *results[1] = {force};
    check(stribeck_create("${this.model.name}", &law), law);
${lines.join("")}    for (int i = 0; i < SAMPLES; i++) {
        double u = (i % ${PERIOD}) / ${PERIOD / 4}.0;
        velocity[i] = speed * (u <= 1 ? u : u <= 3 ? 2 - u : u - 4);
        acceleration[i] = i % ${PERIOD} / ${PERIOD / 4} % 3 == 0 ? speed / (${PERIOD / 4} * dt) : -speed / (${PERIOD / 4} * dt);
    }
${inputs.map((name, at) => find(name, `&in[${at}]`)).join("")}${find(this.force, "&out")}    stribeck_samples inputs = {in, given, ${inputs.length}};
    stribeck_results forces = {&out, results, 1};
    check(stribeck_run(law, dt, SAMPLES, 0, &inputs, &forces), law);
    for (int i = 0; i < SAMPLES; i++) printf("%.17g,%.17g,%.17g\\n", i * dt, velocity[i], force[i]);
    stribeck_free(law);
    return 0;
}
`;
  }
}
