#!/usr/bin/env python3
"""4,096 joints with friction at 1 kHz, as for learning: each is driven by a torque against LuGre friction of its own.

Prints the time of a step of friction, and 4,096 times that of a step of one joint in MuJoCo, with its dry friction.

    pip install dist/stribeck-*.whl mujoco && python3 examples/learning/joints.py
"""

import time

import mujoco
import numpy
import stribeck

JOINTS, DT, STEPS = 4096, 1e-3, 1000
INERTIA = 0.05  # kg m2
LEVEL = 0.5  # N m

MODEL = f"""
<mujoco>
  <option timestep="{DT}" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint name="joint" axis="0 0 1" frictionloss="{LEVEL}" damping="0.02"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{INERTIA} {INERTIA} {INERTIA}"/>
    </body>
  </worldbody>
  <actuator><motor joint="joint"/></actuator>
</mujoco>
"""


class Joints:
    """Joints with a friction coefficient each; velocities in rad/s, torques in N m: the lever arm is 1 m."""

    def __init__(self, joints: int, seed: int = 1) -> None:
        draw = numpy.random.default_rng(seed)
        self.friction = stribeck.batch(
            "LuGre",
            joints,
            normal_force=10.0,
            mu_k=0.1 * LEVEL * draw.uniform(0.7, 1.0, joints),
            mu_s=0.1 * LEVEL * 1.2,
            stribeck_velocity=0.1,
            sigma_0=500.0,
            sigma_1=1.0,
            viscous_coefficient=0.02,
        )
        self.velocity, self.torque = numpy.zeros(joints), numpy.empty(joints)
        self.spent = 0.0  # s, in steps of friction

    def step(self, torque: numpy.ndarray) -> numpy.ndarray:
        """Velocities after a step. Those that are at rest, and driven by less than their level, hardly move."""
        begin = time.process_time()
        self.friction.step(DT, velocity=self.velocity, out=self.torque)
        self.spent += time.process_time() - begin
        self.velocity += DT / INERTIA * (torque - self.torque)
        return self.velocity

    def reset(self, mask: numpy.ndarray) -> None:
        """Begins anew where the mask is true."""
        self.velocity[mask] = 0.0
        self.friction.reset(mask)


def time_of_mujoco() -> float:
    """Time of a step of one joint in s."""
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    data.ctrl[:] = 2.0 * LEVEL
    begin = time.process_time()
    mujoco.mj_step(model, data, nstep=100 * STEPS)
    return (time.process_time() - begin) / (100 * STEPS)


def main() -> None:
    """Drives the joints, and prints the times."""
    joints, draw = Joints(JOINTS), numpy.random.default_rng(2)
    for number in range(STEPS):
        if number % 20 == 0:
            torque = draw.uniform(-2.0, 2.0, JOINTS)
        joints.reset(numpy.abs(joints.step(torque)) > 20.0)
    print(f"friction of {JOINTS} joints: {1e6 * joints.spent / STEPS:.0f} us a step")
    print(f"{JOINTS} joints in MuJoCo: {1e6 * JOINTS * time_of_mujoco():.0f} us a step")


if __name__ == "__main__":
    main()
