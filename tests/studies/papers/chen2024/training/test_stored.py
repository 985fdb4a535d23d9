"""Training from a store: the same for any number of processes, and one sentence for what is wrong.

Covers: studies/papers/chen2024/training/stored.py, studies/papers/chen2024/training/curve.py
Covers: studies/papers/chen2024/training/batches.py, studies/papers/chen2024/training/train.py
"""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from safetensors.numpy import load_file

# Nothing below can be imported without torch, which only training needs (hence E402).
torch = pytest.importorskip("torch")
pytest.importorskip("zarr")

from loomlight.core.errors import InputError  # noqa: E402
from loomlight.core.llvm import llvm_float  # noqa: E402
from loomlight.models.neural.learned_truth import truth_numbers  # noqa: E402
from loomlight.models.neural.weights import read_weights  # noqa: E402
from studies.papers.chen2024.dataset_store import QueryStore, StoreSettings, make_store  # noqa: E402
from studies.papers.chen2024.training import stored, train  # noqa: E402
from studies.papers.chen2024.training.batches import Batches  # noqa: E402
from studies.papers.chen2024.training.config import TrainingConfig, read_config  # noqa: E402
from studies.papers.chen2024.training.curve import CurvePoint, LearningCurve, read_curve  # noqa: E402
from studies.papers.chen2024.training.network import ClothNetwork  # noqa: E402
from studies.papers.chen2024.training.stored import StoredFaces  # noqa: E402
from studies.papers.chen2024.training.train import (  # noqa: E402
    first_stage_identity,
    train_neural,
    training_identity,
)
from tests.limits import HANG  # noqa: E402

QUERIES = 2048
# Those that [data] fabrics = 3 asks for.
NUMBERS = (0, 155, 310)
TINY = {
    "network": {
        "latent": "vector",
        "width": 2,
        "latent_size": 8,
        "hidden": 16,
        "fibres": False,
        "heights": False,
    },
    "data": {"store": "q.zarr", "fabrics": 3, "weaves": "paper", "layouts": "paper"},
    "training": {
        "steps": 4,
        "fabrics": 1,
        "queries": 512,
        "updates": 1,
        "optimiser": "sgd",
        "rate": 5e-2,
        "schedule": "steps",
        "loss": "published",
        "small_footprints": 1.0,
    },
}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("stores") / "q.zarr"
    make_store(path, NUMBERS, StoreSettings(0, QUERIES), llvm_float(), "test")
    return path


@pytest.fixture
def store(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy, in the folder where the training runs."""
    monkeypatch.chdir(tmp_path)
    return Path(shutil.copytree(made, tmp_path / "q.zarr"))


def _config(**changes: dict[str, object]) -> TrainingConfig:
    return TrainingConfig.model_validate(
        {table: {**fields, **changes.get(table, {})} for table, fields in TINY.items()}
    )


def _faces(config: TrainingConfig) -> StoredFaces:
    return StoredFaces(config, truth_numbers(llvm_float()), llvm_float())


def test_queries_are_those_of_the_store(store: Path) -> None:
    faces, material = _faces(_config()), QueryStore(store).material(155)
    face = faces[1]
    assert faces.numbers == list(NUMBERS)
    assert face.count == material.queries.count
    index = np.arange(face.count)
    lights, views, truth = face.answers_of(index)
    np.testing.assert_array_equal(truth, material.truth().reshape(-1, 5))
    pair, footprint = np.divmod(index, len(material.queries.sizes))
    np.testing.assert_array_equal(lights, material.queries.lights[material.queries.pairs[pair, 0]])
    np.testing.assert_array_equal(views, material.queries.views[material.queries.pairs[pair, 1]])
    # Five threads a repeat, which is as many pitches: sizes in threads are sizes in repeats times five.
    sizes = face.footprints_of(index)[:, 2]
    np.testing.assert_allclose(
        sizes / sizes[0], material.queries.sizes[footprint] / material.queries.sizes[0]
    )


def test_some_queries_are_chosen_once_for_all(store: Path) -> None:
    config = _config(data={"store_queries": 600})
    one, again = _faces(config)[2], _faces(config)[2]
    assert one.count == 200
    assert len(np.unique(one.numbers)) == 200
    np.testing.assert_array_equal(one.numbers, again.numbers)
    # Spread over all of them: a tenth of the queries has a tenth of the chosen, one more or less at its ends.
    total = QueryStore(store).material(310).queries.count
    counts = np.histogram(one.numbers, bins=10, range=(0, total))[0]
    assert np.abs(counts - 20).max() <= 2
    whole = QueryStore(store).material(310).components.reshape(-1, 4)
    np.testing.assert_array_equal(one.components, whole[one.numbers])


def test_materials_are_read_when_a_step_needs_them(store: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[int] = []
    whole = QueryStore.material
    monkeypatch.setattr(
        QueryStore, "material", lambda self, number: (read.append(number), whole(self, number))[1]
    )
    config = _config()
    torch.manual_seed(0)
    batches = Batches(config, _faces(config), ClothNetwork(config.network), torch.device("cpu"))
    assert read == []
    for step in (0, 0):
        next(batches.losses(step))
    assert len(read) == 1


@pytest.mark.parametrize(("fabrics", "processes"), [(1, 2), (2, 2), (2, 3), (3, 4)])
def test_batches_do_not_depend_on_processes(
    fabrics: int, processes: int, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All parts of a step together draw what one process draws, and their losses add up to its loss."""
    config = _config(training={"fabrics": fabrics})
    torch.manual_seed(0)
    network = ClothNetwork(config.network)
    found = []
    for count in (1, processes):
        monkeypatch.setattr("studies.papers.chen2024.training.batches.process_count", lambda n=count: n)
        batches = Batches(config, _faces(config), network, torch.device("cpu"))
        parts = batches._parts(fabrics, 512, [0, 7, 3])
        assert len(parts) >= min(count, 2 * fabrics)
        drawn = sorted(
            (number, *stream.integers(1 << 30, size=4).tolist())
            for part in parts
            for number, stream in zip(part.numbers, part.streams, strict=True)
        )
        found.append((drawn, float(next(batches.losses(3)).detach())))
    assert found[0][0] == found[1][0]
    # Parts in bfloat16, where processors have it: 8 bits, on average over hundreds of queries.
    assert found[0][1] == pytest.approx(found[1][1], rel=1e-3)


_RUN = """
import sys
from pathlib import Path
import torch
# float32 everywhere, so that sums taken in another order are all that differs.
torch.cpu.get_capabilities = dict
from studies.papers.chen2024.training.config import TrainingConfig
from studies.papers.chen2024.training.train import process_group, train_neural
with process_group():
    for name in sys.argv[1:]:
        config = TrainingConfig.model_validate_json(Path(name + ".json").read_text())
        train_neural(config, Path(name + " by two"))
"""


@pytest.mark.slow
def test_two_processes_have_the_weights_of_one(
    store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Under torchrun, with gloo; one face whose queries are shared, and two faces."""
    monkeypatch.setattr(torch.cpu, "get_capabilities", dict, raising=False)
    configs = {f"{fabrics} faces": _config(training={"fabrics": fabrics}) for fabrics in (1, 2)}
    for name, config in configs.items():
        (tmp_path / f"{name}.json").write_text(config.model_dump_json())
    (tmp_path / "run.py").write_text(_RUN)
    starter = [sys.executable, "-m", "torch.distributed.run", "--standalone", "--nproc-per-node", "2"]
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parents[5]), "OMP_NUM_THREADS": "1"}
    subprocess.run([*starter, "run.py", *configs], check=True, cwd=tmp_path, env=environment, timeout=HANG)
    for name, config in configs.items():
        train_neural(config, tmp_path / f"{name} by one")
        one, two = (
            load_file(tmp_path / f"{name} by {by}" / "checkpoint.safetensors") for by in ("one", "two")
        )
        torch.manual_seed(0)
        first = {key: values.numpy() for key, values in ClothNetwork(config.network).state_dict().items()}
        moved = {
            key: np.abs(values - first[key.removeprefix("weights.")]).max() for key, values in one.items()
        }
        for key, values in one.items():
            # Sums of 512 float32 in another order, in gradients of length 1 at most and four steps of 0.05;
            # other queries would move weights by a tenth of what these do, or more.
            np.testing.assert_allclose(two[key], values, rtol=0, atol=max(1e-7, 1e-3 * moved[key]))
        assert max(moved.values()) > 1e-3


FAULTS = {
    "no store": ({"data": {"store": "none.zarr"}}, 'store = "none.zarr" is no folder below'),
    "another seed": ({"data": {"seed": 5}}, "write seed = 0"),
    "missing materials": ({"data": {"fabrics": 465}}, "lacks 462 of the 465 materials .* the first 1:"),
    "too many": ({"data": {"fabrics": 500}}, "fabrics = 500"),
    "drawn weaves": ({"data": {"weaves": "all"}}, 'write "paper" for both'),
    "a curve of minutes": ({"training": {"curve": True, "minutes": 1.0}}, "curve = true and minutes = 1"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_of_configurations_are_one_sentence(fault: str, store: Path, tmp_path: Path) -> None:
    changes, sentence = FAULTS[fault]
    with pytest.raises(InputError, match=sentence) as caught:
        train_neural(_config(**changes), tmp_path / "run")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("device", "sentence"), [("gpu", '--device "gpu" is none'), ("cuda", "NVIDIA card")])
def test_devices_that_are_not_there_are_refused(
    device: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(torch.cuda, "is_available", lambda: False)
    with pytest.raises(InputError, match=sentence):
        train_neural(_config(), tmp_path / "run", device=device)
    assert not (tmp_path / "run").exists()


def _edited(store: Path, change: Callable[[dict[str, Any]], None]) -> None:
    root = json.loads((store / "zarr.json").read_text())
    change(root["attributes"])
    (store / "zarr.json").write_text(json.dumps(root))


@pytest.mark.slow
def test_faults_of_stores_are_one_sentence(store: Path, tmp_path: Path) -> None:
    shard = store / "material_0310" / "components" / "c" / "0" / "0" / "0"
    content = bytearray(shard.read_bytes())
    content[len(content) // 3] ^= 0x10
    shard.write_bytes(content)
    with pytest.raises(InputError, match="material_0310 is damaged"):
        train_neural(_config(training={"steps": 40}), tmp_path / "run")
    _edited(store, lambda attributes: attributes.update(version=2))
    with pytest.raises(InputError, match="version 2 of its format"):
        train_neural(_config(), tmp_path / "run")


def test_stores_of_other_yarns_are_refused(store: Path, tmp_path: Path) -> None:
    _edited(store, lambda attributes: attributes["made_with"].update(truth=[1.0]))
    with pytest.raises(InputError, match="yarns that this version computes otherwise"):
        train_neural(_config(), tmp_path / "run")
    with pytest.raises(InputError, match="yarns that this version computes otherwise"):
        make_store(store, [1], StoreSettings(0, QUERIES), llvm_float(), "test")


def test_more_processes_than_shares_are_refused(
    store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(train, "process_count", lambda: 3)
    with pytest.raises(InputError, match="gives 2 shares a step, fewer than the 3 processes"):
        train_neural(_config(), tmp_path / "run")


@pytest.mark.slow
def test_weights_of_a_store_say_how_they_were_made(store: Path, tmp_path: Path) -> None:
    weights = read_weights(train_neural(_config(), tmp_path / "run"))
    assert weights.recipe["data"]["store"] == "q.zarr"
    assert not weights.table.heights
    assert weights.provenance["truth"] == QueryStore(store).attributes["made_with"]["truth"]
    # Another place for the same store is the same training.
    shutil.move(store, tmp_path / "elsewhere.zarr")
    moved = _config(data={"store": "elsewhere.zarr"})
    assert train_neural(moved, tmp_path / "run").is_file()


# ------------------------------------------------------------------------------------------------- identities


def test_identities_are_what_they_were() -> None:
    """Of a configuration without the fields that came later, computed before there were any."""
    assert training_identity(TrainingConfig()) == IDENTITY_BEFORE


IDENTITY_BEFORE = "ce8baae7eddbfe247e154033ab1fe7aa89bc84c09661b7e244a523b645f76052"


def test_the_first_stage_is_the_same_for_all_decoders() -> None:
    def changed(**fields: object) -> TrainingConfig:
        return TrainingConfig.model_validate({"training": fields})

    base = first_stage_identity(TrainingConfig())
    for fields in (
        {"decoder_hidden": 24},
        {"decoder_steps": 9},
        {"decoder_rate": 0.5},
        {"decoder_bundles": True},
    ):
        assert first_stage_identity(changed(**fields)) == base
        assert training_identity(changed(**fields)) != training_identity(TrainingConfig())
    for fields in ({"steps": 9}, {"rate": 0.5}, {"seed": 1}):
        assert first_stage_identity(changed(**fields)) != base


@pytest.mark.slow
def test_two_decoders_on_one_encoder(store: Path, tmp_path: Path) -> None:
    """A checkpoint is copied, the decoder's width changed: the first stage is not trained again."""
    one = train_neural(_config(training={"decoder_steps": 2, "decoder_hidden": 24}), tmp_path / "one")
    (tmp_path / "two").mkdir()
    shutil.copy(tmp_path / "one" / "checkpoint.safetensors", tmp_path / "two")
    steps: list[tuple[int, int]] = []
    two = train_neural(
        _config(training={"decoder_steps": 3, "decoder_hidden": 32}),
        tmp_path / "two",
        report=lambda done, total, loss: steps.append((done, total)),
    )
    assert steps == [(1, 3), (2, 3), (3, 3)]
    before, after = load_file(one), load_file(two)
    for name in before:
        if name.startswith("encoder"):
            np.testing.assert_array_equal(before[name], after[name])
    assert read_weights(two).table.hidden == 32


@pytest.mark.slow
def test_checkpoints_that_name_the_whole_configuration_are_gone_on_with(store: Path, tmp_path: Path) -> None:
    """As trainings before wrote them; afterwards other decoders take them too."""
    config, checkpoint = _config(training={"decoder_steps": 1}), tmp_path / "run" / "checkpoint.safetensors"
    train_neural(config, tmp_path / "run")
    tensors, facts = train.read_checkpoint(checkpoint)
    kept = {name: facts[name] for name in ("step", "seconds", "loss")}
    train.write_checkpoint(checkpoint, tensors, {"identity": training_identity(config), **kept})
    other = _config(training={"decoder_steps": 2})
    (tmp_path / "run" / "decoder.safetensors").unlink()
    with pytest.raises(InputError, match="another configuration"):
        train_neural(other, tmp_path / "run")
    train_neural(config, tmp_path / "run")
    (tmp_path / "run" / "decoder.safetensors").unlink()
    train_neural(other, tmp_path / "run")


# ------------------------------------------------------------------------------------------------------ curve


@pytest.mark.slow
def test_a_resumed_training_goes_on_with_its_curve(
    store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Stopped after its last checkpoint and gone on with: the curve of an undisturbed one."""
    monkeypatch.setattr(stored, "_HELD_OUT_QUERIES", 1024)
    config = _config(training={"steps": 16, "curve": True})
    train_neural(config, tmp_path / "whole")

    def stop(done: int, total: int, loss: float) -> None:
        if done == 14:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        train_neural(config, tmp_path / "run", report=stop, keep_every=0)
    train_neural(config, tmp_path / "run")
    whole = read_curve(tmp_path / "whole" / "curve.csv")
    assert read_curve(tmp_path / "run" / "curve.csv") == whole
    assert [point.step for point in whole] == [10, 11, 12, 14, 15, 16]
    assert len({point.nmae for point in whole}) == len(whole)


def test_rows_after_the_checkpoint_are_found_again(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    path.write_text("step,loss,nmae\n10,1.0,0.5\n11,0.9,0.4\n12,0.8,0.3\n")
    curve = LearningCurve(path, lambda: 0.25)
    curve(11, 100, 0.7)
    assert read_curve(path) == [CurvePoint(10, 1.0, 0.5), CurvePoint(11, 0.7, 0.25)]


def test_damaged_curves_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    path.write_text("step,loss,nmae\n10,1.0\n")
    with pytest.raises(InputError, match=r"curve\.csv is no learning curve"):
        LearningCurve(path, lambda: 0.25)(11, 100, 0.7)


def test_nmae_is_the_share_of_light_that_is_missed(store: Path) -> None:
    """Of a network that gives nothing it is 1."""
    config = _config()
    network = ClothNetwork(config.network)
    with torch.no_grad():
        network.decoder.angular[-1].weight.zero_()
        network.decoder.angular[-1].bias.zero_()
    faces = _faces(config)
    batches = Batches(config, faces, network, torch.device("cpu"))
    assert batches.reflection_nmae(faces) == pytest.approx(1, abs=1e-6)


def test_the_published_configuration_is_read() -> None:
    folder = Path(stored.__file__).parents[1]
    config = read_config(folder / "chen2024.toml")
    assert config.training.steps * config.training.queries == 10 * config.data.store_queries
    assert not config.network.heights
    assert config.training.curve
