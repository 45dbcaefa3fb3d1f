"""Studies that are interrupted, divided among processes, and sent to a cluster: always the same table. The task
`faults` asks for more interruptions and processes."""

import os
import random
import subprocess
import sys
import time
from pathlib import Path

import distributed
import numpy
import pyarrow.parquet
import pytest
import stribeck

ELSEWHERE = {**os.environ, "PYTHONPATH": str(Path(stribeck.__file__).parents[1])}
KILLS = int(os.environ.get("STRIBECK_KILLS", "4"))
PROCESSES = int(os.environ.get("STRIBECK_PROCESSES", "6"))

STUDY = {
    "samples": 6000,
    "seed": 9,
    "keep": ["max rig.position", "events"],
    "vary": {"mu_s": {"uniform": [0.12, 0.2]}, "rig.mass": {"log": [0.5, 2.0]}},
    "run": {"law": ["CoulombStiction"], "until": 3.0, "tol": 1e-6},
}
# In a process of its own, on one thread.
CODE = "import stribeck, sys; stribeck.study({study!r}, sys.argv[1], shard=sys.argv[2], threads=1)"


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """The study in one piece."""
    return stribeck.study(STUDY, tmp_path_factory.mktemp("whole"))


def started(folder, shard, study=STUDY):
    return subprocess.Popen([sys.executable, "-c", CODE.format(study=study), str(folder), shard], env=ELSEWHERE)


def test_a_study_that_is_killed_at_any_moment_goes_on(undisturbed, tmp_path):
    draw = random.Random(4)
    began = time.monotonic()
    stribeck.study(STUDY, tmp_path / "timed", shard="1/6", threads=1)
    chunk = time.monotonic() - began
    killed = 0
    for _ in range(KILLS):
        process = started(tmp_path / "killed", "1/1")
        # From the import to some chunks later.
        time.sleep(draw.uniform(0.0, 0.5 + 2.0 * chunk))
        process.kill()
        killed += process.wait() != 0
    assert killed > 0
    again = stribeck.study(STUDY, tmp_path / "killed")
    assert again.path.read_bytes() == undisturbed.path.read_bytes()
    print(f"figure: study killed {killed} times, same table")


def test_many_processes_make_the_same_table(undisturbed, tmp_path):
    processes = [started(tmp_path, f"{number}/{PROCESSES}") for number in range(1, PROCESSES + 1)]
    assert {process.wait(timeout=600) for process in processes} == {0}
    # Nothing is left to be run.
    began = time.monotonic()
    table = stribeck.study(STUDY, tmp_path)
    assert table.path.read_bytes() == undisturbed.path.read_bytes()
    print(f"figure: {PROCESSES} processes, same table, joined in {time.monotonic() - began:.1f} s")


def test_a_cluster_makes_the_same_table(undisturbed, tmp_path):
    options = {"n_workers": 4, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        table = stribeck.study(STUDY, tmp_path / "cluster", client=client)
        assert table.path.read_bytes() == undisturbed.path.read_bytes()
        # Nothing is left to be sent out.
        again = stribeck.study(STUDY, tmp_path / "cluster", client=client)
        assert again.path.read_bytes() == table.path.read_bytes()
        with pytest.raises(TypeError, match="without shard and threads"):
            stribeck.study(STUDY, tmp_path / "cluster", client=client, shard="1/2")


# The printed form chatters before the block slips.
FAILING = {
    "samples": 6,
    "keep": ["max rig.position"],
    "vary": {"mu_k": {"uniform": [0.05, 0.15]}},
    "run": {"law": ["RooneyDeravi"], "until": 5.0, "set": {"variant": "Printed"}},
}


def test_too_many_failures_end_a_study(tmp_path):
    table = stribeck.study(FAILING, tmp_path / "all", max_failures=6)
    assert (table["end"] != "reached").sum() > 3
    assert numpy.isnan(table["max rig.position"]).sum() == (table["end"] != "reached").sum()
    with pytest.raises(stribeck.Refused, match=r"more than 3 \(max-failures\); the last one is row \d+: "):
        stribeck.study(FAILING, tmp_path / "few", max_failures=3)


def test_a_job_of_an_array_makes_its_part(tmp_path, monkeypatch):
    few = {**STUDY, "samples": 2100}
    for name, value in {"SLURM_ARRAY_TASK_MIN": "0", "SLURM_ARRAY_TASK_COUNT": "3"}.items():
        monkeypatch.setenv(name, value)
    for job in ("2", "0", "1"):
        monkeypatch.setenv("SLURM_ARRAY_TASK_ID", job)
        stribeck.study(few, tmp_path / "jobs", shard="array")
    assert len(list((tmp_path / "jobs").glob("chunk-*.csv"))) == 3
    whole = stribeck.study(few, tmp_path / "whole")
    assert stribeck.study(few, tmp_path / "jobs").path.read_bytes() == whole.path.read_bytes()


def test_a_table_as_parquet_has_the_same_bits(undisturbed, tmp_path):
    undisturbed.to_parquet(tmp_path / "study.parquet")
    read = pyarrow.parquet.read_table(tmp_path / "study.parquet")
    assert read.column_names == list(undisturbed)
    for name in ("mu_s", "max rig.position"):
        assert read[name].to_numpy().tobytes() == undisturbed[name].tobytes()
    assert read["end"].to_pylist() == list(undisturbed["end"])
