"""`python -m studies.papers.chen2024.data`: what it writes, and what it refuses in one sentence.

Covers: studies/papers/chen2024/data.py
"""

import pytest

from loomlight.cli.main import run
from studies.papers.chen2024.data import MATERIALS as OFFERED
from studies.papers.chen2024.data import app
from studies.papers.chen2024.dataset_store import QueryStore
from studies.papers.chen2024.materials import MATERIALS


def test_writes_a_store_and_goes_on_with_it(tmp_path, capsys):
    path = tmp_path / "queries.zarr"
    common = ["-o", str(path), "--queries", "2048", "--seed", "5"]
    assert run([*common, "--materials", "7"], app) == 0
    assert run([*common, "--materials", "7:9"], app) == 0
    assert capsys.readouterr().out.split() == [str(path)] * 2
    store = QueryStore(path)
    assert store.numbers == (7, 8)
    assert store.settings.seed == 5
    assert (
        store.attributes["made_with"]["command"]
        == "python -m studies.papers.chen2024.data --queries 2048 --seed 5"
    )
    assert store.material(8).queries.count == pytest.approx(2048, rel=0.1)


FAULTS = {
    "no suffix": (["-o", "queries"], "must end in .zarr"),
    "no folder": (["-o", "none/queries.zarr"], "folder none does not exist"),
    "no output": ([], "--output"),
    "no range": (["-o", "q.zarr", "--materials", "a:b"], '--materials "a:b"'),
    "an empty range": (["-o", "q.zarr", "--materials", "5:5"], '--materials "5:5"'),
    "too many": (["-o", "q.zarr", "--materials", "0:466"], "0 to 465"),
    "no number": (["-o", "q.zarr", "--queries", "many"], '--queries "many"'),
    "too few queries": (["-o", "q.zarr", "--queries", "10"], "--queries 10 is out of range"),
    "no seed": (["-o", "q.zarr", "--seed", "-1"], "--seed -1"),
    "foreign": (["-o", "foreign.zarr"], "other files in it"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_are_one_sentence(fault, tmp_path, refused):
    (tmp_path / "foreign.zarr").mkdir()
    (tmp_path / "foreign.zarr" / "a.txt").write_text("a")
    arguments, sentence = FAULTS[fault]
    assert sentence in refused(arguments, lambda given: run(given, app))


def test_the_command_offers_all_materials():
    assert len(MATERIALS) == OFFERED
