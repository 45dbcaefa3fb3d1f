"""Rubber mounts in the struts of the car: against rigid ones, statics, and the balance of energy of a strut."""

import numpy
import pytest

from examples.car import car_mount, car_ride
from examples.car.car_accuracy import ON_POSTS, Answer, Job
from examples.car.car_description import CAR, CORNERS, read_car
from examples.car.car_rest import on_rubber, settle
from examples.car.car_struts import parameters_of
from examples.car.car_study import heat as heat_of
from examples.car.car_tyres import read_tyre
from examples.car.exudyn_car import ExudynCar
from examples.car.manoeuvres import manoeuvre

DESCRIPTION = read_car()
POSTS = manoeuvre("four-post", duration=0.15, frequency=8.0, stroke=0.01)
# Rubber that is a spring: all that it takes it gives back.
SPRING = {"mount.k_e": 3e5, "mount.k_v": 0.0, "mount.F_max": 0.0}


def test_stiff_mounts_are_none():
    """With a light rod behind stiff rubber the car moves as with rigid mounts; with soft rubber it does not."""
    stiff = {"mount.k_e": 1e10, "mount.k_v": 0.0, "mount.F_max": 0.0, "mount.mass": 1e-3}
    rubber = on_rubber(DESCRIPTION, {})
    cases = ((DESCRIPTION, {}), (rubber, stiff), (rubber, {}))
    rigid, hard, soft = (car_ride.simulate(car, POSTS, "LuGre", changes) for car, changes in cases)
    assert not rigid["fl.mount"].any()
    for column, allowed in (("heave", 2e-7), ("fl.length", 1e-6), ("rl.friction", 0.3), ("fl.load", 0.1)):
        assert hard[column] == pytest.approx(rigid[column], abs=allowed), column
        assert numpy.abs(soft[column] - rigid[column]).max() > 10.0 * allowed, column
    # At rest they carry the struts without being displaced.
    assert soft.rest.lengths == pytest.approx(rigid.rest.lengths, abs=1e-12)


@pytest.fixture(scope="module")
def on_springs():
    """Runs on mounts that are springs, by the mass of their rods."""
    changes = {"gas.enabled": False, **SPRING}
    car = on_rubber(DESCRIPTION, changes)
    return {
        mass: car_ride.simulate(car, POSTS, "Hollars", {**changes, "mount.mass": mass}, step=5e-4)
        for mass in (0.3, 5.0)
    }


def work_of(run: car_ride.Run, column: str, along: numpy.ndarray) -> float:
    """Work of a force along steps."""
    return 0.5 * float((run[column][1:] + run[column][:-1]) @ along)


def test_a_strut_with_a_mount_keeps_its_energy(on_springs):
    """What pushes the eyes apart comes from spring, mount and rod; friction and damper take their heat inside, where
    the strut moves by more than its eyes."""
    run, preloads = on_springs[0.3], on_rubber(DESCRIPTION, {"gas.enabled": False})
    all_heat = all_outside = 0.0
    for name in CORNERS:
        strut = preloads.corners[name].strut
        length, mount = run[f"{name}.length"], run[f"{name}.mount"]
        compression = strut["geom.length_extended"] - length - mount
        stored = strut["spring.preload"] * compression + 0.5 * strut["spring.k"] * compression**2
        stored += strut["mount.preload"] * mount + 0.5 * SPRING["mount.k_e"] * mount**2
        stored += 0.5 * 0.3 * numpy.gradient(mount, run.step) ** 2
        moved, inside = numpy.diff(length), numpy.diff(length + mount)
        heat, outside = (
            work_of(run, f"{name}.friction", along) - work_of(run, f"{name}.force_damper", along)
            for along in (inside, moved)
        )
        work = work_of(run, f"{name}.force", moved)
        assert work + stored[-1] - stored[0] + heat == pytest.approx(0.0, abs=0.01 * heat), name
        all_heat, all_outside = all_heat + heat, all_outside + outside
    # So do the tables, and the balance of the whole car, which is a step longer.
    assert heat_of(run, "friction") - heat_of(run, "force_damper") == pytest.approx(all_heat, rel=1e-9)
    assert run.works.dissipated == pytest.approx(all_heat, rel=0.01)
    assert abs(all_outside - all_heat) > 0.03 * all_heat > 0.3


def test_the_balance_of_the_car_contains_the_forces_on_rods_alone(on_springs):
    """Rods of 5 kg behind the mounts take and give half a joule: no more is missing than with light ones."""
    light, heavy = on_springs.values()
    taken = sum(work_of(heavy, f"{name}.rod_force", numpy.diff(heavy[f"{name}.length"])) for name in CORNERS)
    assert abs(taken) > 0.3
    assert heavy.works.residual == pytest.approx(light.works.residual, abs=0.1 * abs(taken))


def test_mounts_without_preload_yield_at_rest():
    changes = {"mount.enabled": True, "gas.enabled": False, **SPRING}
    rest = settle(ExudynCar(DESCRIPTION), read_tyre(DESCRIPTION), parameters_of(DESCRIPTION, "None", changes))
    for name, force in rest.forces.items():
        strut = DESCRIPTION.corners[name].strut
        compression = strut["geom.length_extended"] - rest.lengths[name] - force / SPRING["mount.k_e"]
        assert force == pytest.approx(strut["spring.preload"] + strut["spring.k"] * compression, rel=1e-9)


def test_a_part_of_the_force_does_not_reach_the_rod():
    """On a stand the tube pushes the chassis, which is bolted down: only what reaches the rod moves the suspension."""
    lengths = []
    for force, rod_force in ((900.0, 100.0), (800.0, 0.0), (900.0, 0.0)):
        model = ExudynCar(DESCRIPTION, on_stand=True)
        for name in CORNERS:
            model.set_strut(name, force, 33e3, 0.18)
            model.push_rod(name, rod_force)
        model.settle("on a stand")
        lengths.append([model.look(name)[0] for name in CORNERS])
    assert lengths[0] == pytest.approx(lengths[1], abs=5e-5)
    assert numpy.abs(numpy.subtract(lengths[2], lengths[1])).min() > 1e-3


def test_both_codes_feel_the_mounts():
    rubber = on_rubber(DESCRIPTION, {})
    runs = [
        [car_ride.simulate(car, POSTS, "None", code=code) for car in (DESCRIPTION, rubber)]
        for code in ("exudyn", "mujoco")
    ]
    for column in ("fl.length", "rl.length"):
        one, other = (numpy.ptp(soft[column]) - numpy.ptp(rigid[column]) for rigid, soft in runs)
        assert one == pytest.approx(other, rel=0.1), column
        assert abs(one) > 1e-4, column


def test_table_of_the_mounts(monkeypatch):
    """Each column has the runs of its law and mounts."""

    def answer(job: Job) -> Answer:
        value = 10.0 * job.has_mounts + (100.0 if job.law == "Dahl" else 0.0) + 1e3 * job.course.stroke
        return Answer({name: value for name, _, _ in ON_POSTS}, None)

    monkeypatch.setattr(car_mount, "answers", lambda jobs, _: [answer(job) for job in jobs])
    table = car_mount.report_mounts(CAR, POSTS, "Dahl", {}, 1e-3, "exudyn", 1)
    heads, *rows = table.splitlines()
    assert [head.strip() for head in heads.split("  ")][-4:] == [
        "None, rigid",
        "None, rubber",
        "Dahl, rigid",
        "Dahl, rubber",
    ]
    assert len(rows) == len(car_mount.ON_THE_POSTS) + len(car_mount.SHAKING)
    strokes = [1e3 * POSTS.stroke] * len(car_mount.ON_THE_POSTS) + [1e3 * stroke for stroke, _ in car_mount.SHAKING]
    for row, stroke in zip(rows, strokes, strict=True):
        assert [float(cell) for cell in row.split()[-4:]] == pytest.approx(
            [stroke, 10.0 + stroke, 100.0 + stroke, 110.0 + stroke]
        )
