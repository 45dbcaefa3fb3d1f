/** Contents of the views of systems. */

import type { Layout } from "./bench";
import { block, strut } from "./drawings";
import { thesisTables } from "./thesis";

const isDyno = (name: string) => name.startsWith("dyno");
/** Systems whose block hangs on a spring; the others show how it moves along its ground. */
const ON_SPRING = ["belt", "belt-drive"];
const ON_GROUND = ["motion", "cylinder", "pulled-mass", "spring-slider", "servo", "incline", "two-blocks"];

export const BENCH: Layout = {
  view: "bench",
  systems: (name) => !isDyno(name),
  pictures: [
    { id: "position-over-time", title: "Position over time", up: ["position"] },
    { id: "velocity-over-time", title: "Relative velocity over time", up: ["velocity"] },
    { id: "acceleration-over-time", title: "Acceleration over time", up: ["acceleration"] },
    { id: "force-over-time", title: "Friction force over time", up: ["force"] },
    { id: "force-over-velocity", title: "Friction force over relative velocity", up: ["force"], across: "velocity" },
    { id: "force-over-displacement", title: "Friction force over displacement", up: ["force"], across: "displacement" },
    { id: "velocity-over-position", title: "Relative velocity over position", up: ["velocity"], across: "position" },
  ],
  record: {},
  names: {
    position: "Position",
    displacement: "Displacement",
    velocity: "Relative velocity",
    acceleration: "Acceleration",
    force: "Friction force",
  },
  scene: (system) => (ON_SPRING.includes(system) ? block(true) : ON_GROUND.includes(system) ? block(false) : undefined),
  below: thesisTables,
};

const PARTS = ["spring", "gas", "bump", "rebound", "damper", "friction"];
const CONTACTS = ["friction_1", "friction_2"];
const LOADS = ["normal_1", "normal_2"];

export const STRUT: Layout = {
  view: "strut",
  systems: isDyno,
  pictures: [
    { id: "force-over-velocity", title: "Force over velocity", up: ["force"], across: "velocity" },
    { id: "force-over-displacement", title: "Force over compression", up: ["force"], across: "displacement" },
    { id: "friction-over-velocity", title: "Friction over velocity", up: ["friction"], across: "velocity" },
    { id: "contacts-over-time", title: "Friction by contact over time", up: CONTACTS },
    { id: "loads-over-time", title: "Normal forces over time", up: LOADS },
    { id: "parts-over-time", title: "Parts of the force over time, first law", up: PARTS, first: true },
  ],
  record: Object.fromEntries([
    ...PARTS.map((part) => [part, `strut.force_${part}`]),
    ...[...CONTACTS, ...LOADS].map((name) => [name, `strut.${name}`]),
  ]),
  names: {
    displacement: "Compression",
    velocity: "Velocity",
    force: "Force",
    spring: "Spring",
    gas: "Gas",
    bump: "Bump stop",
    rebound: "Rebound stop",
    damper: "Damper",
    friction: "Friction",
    friction_1: "Rod guide",
    friction_2: "Piston",
    normal_1: "Rod guide",
    normal_2: "Piston",
  },
  scene: () => strut,
};
