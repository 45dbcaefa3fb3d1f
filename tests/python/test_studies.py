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
CHUNKS = 6
# In a process of its own, on one thread; the line says that the study begins.
CODE = "import stribeck, sys; print(flush=True); stribeck.study({study!r}, sys.argv[1], shard=sys.argv[2], threads=1)"


@pytest.fixture(scope="module")
def timed(tmp_path_factory):
    """The study in one piece, and how long one thread takes for a chunk, in s."""
    began = time.monotonic()
    table = stribeck.study(STUDY, tmp_path_factory.mktemp("whole"), threads=1)
    return table, (time.monotonic() - began) / CHUNKS


@pytest.fixture(scope="module")
def undisturbed(timed):
    """The study in one piece."""
    return timed[0]


def started(folder, shard, output=subprocess.DEVNULL):
    code = CODE.format(study=STUDY)
    return subprocess.Popen([sys.executable, "-c", code, folder, shard], env=ELSEWHERE, stdout=output)


def is_killed(process, patience):
    """Whether a study was still running after this time, in s, and ended then."""
    try:
        assert process.wait(patience) == 0
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait() != 0
    return False


def test_a_study_that_is_killed_at_any_moment_goes_on(timed, tmp_path):
    undisturbed, chunk = timed
    draw = random.Random(4)
    killed = ended = 0
    while killed < KILLS:
        with started(tmp_path / str(ended), "1/1", subprocess.PIPE) as process:
            process.stdout.readline()
            is_met = is_killed(process, draw.uniform(0.0, 2.0 * chunk))
        killed += is_met
        if not is_met:
            table = stribeck.study(STUDY, tmp_path / str(ended))
            assert table.path.read_bytes() == undisturbed.path.read_bytes()
            ended += 1
    table = stribeck.study(STUDY, tmp_path / str(ended))
    assert table.path.read_bytes() == undisturbed.path.read_bytes()
    print(f"figure: studies killed while they ran {killed} times, {ended + 1} same tables")


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
        told = []
        table = stribeck.study(STUDY, tmp_path / "cluster", client=client, progress=lambda *rows: told.append(rows))
        assert table.path.read_bytes() == undisturbed.path.read_bytes()
        assert told == [(1000 * chunk, 6000) for chunk in (1, 2, 3, 4, 5, 6, 6)]
        # Nothing is left to be sent out.
        again = stribeck.study(STUDY, tmp_path / "cluster", client=client)
        assert again.path.read_bytes() == table.path.read_bytes()
        with pytest.raises(TypeError, match="without shard and threads"):
            stribeck.study(STUDY, tmp_path / "cluster", client=client, shard="1/2")


def test_progress_is_told_to_the_end_and_may_end_a_study(tmp_path):
    told = []
    stribeck.study(STUDY, tmp_path / "half", shard="2/2", threads=1, progress=lambda *rows: told.append(rows))
    assert {rows for _, rows in told} == {3000}
    assert told == sorted(told)
    # Some times a second, not once per row.
    assert 2 < len(told) < 1000
    assert told[-1] == (3000, 3000)

    def enough(done, _):
        told.append(done)
        if done > 3000:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        stribeck.study(STUDY, tmp_path / "half", threads=1, progress=enough)
    assert len(list((tmp_path / "half").glob("chunk-*.csv"))) < 6
    # The call after the refused one is another one.
    with pytest.raises(TypeError):
        stribeck.study(STUDY, tmp_path / "half", progress=1)


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
