"""A law that was added to a copy, against Dahl's law with alpha = 1, whose equations it has under other names."""

import numpy as np
import pytest
import stribeck

LAW = "SpringSlider"
# Names of the same quantities in both laws.
NAMES = {"mu_k": "coefficient", "sigma_0": "k_b"}
VALUES = {"mu_k": 0.17, "sigma_0": 3e4}


def named(law, values):
    return values if law == "Dahl" else {NAMES[name]: value for name, value in values.items()}


def test_it_has_a_text_variables_and_an_fmu():
    assert LAW in [str(law) for law in stribeck.laws()]
    assert stribeck.law(LAW).variables["k_b"].unit == "N/m"
    assert stribeck.fmu(LAW).is_file()


def test_its_steps_are_those_of_dahl():
    time = np.linspace(0.0, 1.0, 2001)
    motion = {"velocity": 0.02 * np.sin(9.0 * time), "normal_force": 20.0 + 5.0 * np.sin(5.0 * time), "dt": time[1]}
    forces = [stribeck.simulate(law, **motion, **named(law, VALUES))["friction_force"] for law in ("Dahl", LAW)]
    assert np.abs(forces[0]).max() > 3.0
    assert forces[1] == pytest.approx(forces[0], abs=1e-12)


def test_a_strut_carries_its_force_as_that_of_dahl():
    """Side forces that come and go: what a contact holds from a larger load must fall with it, in both alike."""
    runs = []
    for law in ("Dahl", LAW):
        names = {"sigma_0": 3e5} if law == "Dahl" else {"k_b": 3e5}
        strut = stribeck.Model(
            "ShockAbsorber", **{"friction.model": law}, **{f"friction.{k}": v for k, v in names.items()}
        )
        forces = []
        for step in range(400):
            strut["length"] = 0.1775 + 1e-5 * np.sin(0.05 * step)
            strut["velocity"] = 1e-5 * 0.05 * np.cos(0.05 * step) / 1e-3
            strut["side_force_m"] = 2000.0 * (step % 80 < 40)
            strut.step(1e-3)
            forces.append(strut["friction_1"] + strut["friction_2"])
        runs.append(forces)
    assert np.ptp(runs[0]) > 1.0
    assert runs[1] == pytest.approx(runs[0], abs=1e-9)


def test_a_fit_finds_it_as_it_finds_dahl():
    """Ranges and verdicts follow from what the parameters are for, so that both are searched and told alike."""
    time = np.linspace(0.0, 2.0, 2001)
    velocity = 0.02 * np.sin(2 * np.pi * time) + 0.004 * np.sin(23.0 * time)
    force = stribeck.simulate("Dahl", velocity=velocity, normal_force=20.0, dt=time[1], **VALUES)["friction_force"]
    noise = np.random.default_rng(1).normal(0.0, 0.02, time.size)
    record = {"time": time, "velocity": velocity, "force": force + noise}
    dahl, other = (stribeck.identify(record, law, normal_force=20.0, repetitions=0).best for law in ("Dahl", LAW))
    assert set(other.estimates) == {"coefficient", "k_b"}
    for name, one in dahl.estimates.items():
        same = other.estimates[NAMES[name]]
        assert (same.verdict, same.unit) == (one.verdict, one.unit) == ("determined", one.unit)
        assert same.value == pytest.approx(one.value, rel=1e-5)
        assert same.interval[0] < VALUES[name] < same.interval[1]
