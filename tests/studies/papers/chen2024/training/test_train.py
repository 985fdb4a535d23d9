"""Training learns, is the same after kill −9 at any moment, and refuses what is not its own.

Covers: studies/papers/chen2024/training/__main__.py, studies/papers/chen2024/training/batches.py
Covers: studies/papers/chen2024/training/config.py
Covers: studies/papers/chen2024/training/dataset.py, studies/papers/chen2024/training/losses.py
"""

import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from tests.marks import slow

# Nothing below can be imported without torch, which only training needs (hence E402).
torch = pytest.importorskip("torch")

from loomlight.core.errors import InputError  # noqa: E402
from loomlight.core.llvm import llvm_float  # noqa: E402
from loomlight.models.neural.architecture import NetworkTable  # noqa: E402
from loomlight.models.neural.learned_truth import moved_since, truth_numbers  # noqa: E402
from loomlight.models.neural.weights import read_weights, shipped_weights  # noqa: E402
from studies.papers.chen2024.training import train  # noqa: E402
from studies.papers.chen2024.training.batches import Batches, _draw  # noqa: E402
from studies.papers.chen2024.training.config import TrainingConfig, read_config  # noqa: E402
from studies.papers.chen2024.training.dataset import read_faces  # noqa: E402
from studies.papers.chen2024.training.losses import LOSSES, mapped, unmapped  # noqa: E402
from studies.papers.chen2024.training.train import rate_factor, take_shipped_encoder, train_neural  # noqa: E402
from tests.helpers.neural_networks import network  # noqa: E402

TINY = """
[network]
width = 4
latent_size = 8
hidden = 16
[data]
layouts = "paper"
fabrics = 2
pairs = 64
footprints = 16
lights = 16
views = 16
texels_per_thread = 8
[training]
steps = {steps}
fabrics = 2
queries = 64
decoder_steps = {decoder_steps}
decoder_hidden = {decoder_hidden}
decoder_bundles = true
optimiser = "{optimiser}"
"""


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the dataset that all trainings here share."""
    folder = tmp_path_factory.mktemp("dataset")
    train_neural(_config(folder, 1), folder)
    return folder


def _config(
    folder: Path, steps: int, decoder_steps: int = 0, optimiser: str = "adam", decoder_hidden: int = 0
) -> TrainingConfig:
    path = folder / "tiny.toml"
    path.write_text(
        TINY.format(
            steps=steps, decoder_steps=decoder_steps, decoder_hidden=decoder_hidden, optimiser=optimiser
        )
    )
    return read_config(path)


def _with_dataset(dataset: Path, folder: Path) -> Path:
    folder.mkdir()
    for made in dataset.glob("pool-*"):
        (folder / made.name).symlink_to(made)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("optimiser", ["adam", "soap"])
def test_training_learns(dataset: Path, tmp_path: Path, optimiser: str) -> None:
    losses: list[float] = []
    train_neural(
        _config(tmp_path, 60, optimiser=optimiser),
        _with_dataset(dataset, tmp_path / "run"),
        report=lambda done, total, loss: losses.append(loss),
    )
    assert losses[-1] < 0.9 * losses[0]


@pytest.mark.slow
def test_the_decoder_alone_is_trained_last(dataset: Path, tmp_path: Path) -> None:
    short, longer = (
        load_file(train_neural(_config(tmp_path, 5, more), _with_dataset(dataset, tmp_path / f"run {more}")))
        for more in (0, 5)
    )
    for name, values in short.items():
        assert np.array_equal(values, longer[name]) == (not name.startswith("decoder")), name


def test_a_decoder_made_anew_is_written_as_such(dataset: Path, tmp_path: Path) -> None:
    config = _config(tmp_path, 2, 3, decoder_hidden=24)
    weights = read_weights(train_neural(config, _with_dataset(dataset, tmp_path / "run")))
    assert (weights.table.hidden, weights.table.bundles) == (24, True)
    assert not weights.recipe["network"]["bundles"]
    assert weights.tensor("decoder.angular.1.weight").shape == (24, 24)
    assert weights.recipe["network"]["hidden"] == 16


def _on_the_shipped_encoder(table: NetworkTable, decoder_steps: int) -> TrainingConfig:
    config = TrainingConfig(network=table)
    data = config.data.model_copy(
        update={
            "fabrics": 1,
            "pairs": 64,
            "footprints": 16,
            "lights": 16,
            "views": 16,
            "texels_per_thread": 8,
        }
    )
    training = config.training.model_copy(
        update={"encoder": "shipped", "fabrics": 1, "queries": 64, "decoder_steps": decoder_steps}
    )
    return config.model_copy(update={"data": data, "training": training})


def test_a_decoder_is_trained_on_the_encoder_that_ships(tmp_path: Path) -> None:
    """The encoder stays as it is, and the decoder begins anew."""
    shipped = shipped_weights()
    trained = read_weights(train_neural(_on_the_shipped_encoder(shipped.table, 1), tmp_path))
    for name, values in shipped.tensors.items():
        same = np.array_equal(values, trained.tensor(name))
        assert same if name.startswith("encoder.") else not (same and values.any()), name


def test_a_training_without_work_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="give decoder_steps"):
        train_neural(_on_the_shipped_encoder(shipped_weights().table, 0), tmp_path)


def test_a_shipped_encoder_of_another_shape_is_refused() -> None:
    with pytest.raises(InputError, match="is of another shape than"):
        take_shipped_encoder(network("field"))


@pytest.mark.parametrize("computed", [False, True])
def test_half_precision_is_for_processors_that_compute_with_it(
    computed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(torch.cpu, "get_capabilities", lambda: {"avx512_bf16": computed}, raising=False)
    batches = Batches(TrainingConfig(), [], network("field"), torch.device("cpu"))
    with batches._half_precision():
        assert torch.is_autocast_enabled("cpu") == computed


@pytest.mark.slow
@pytest.mark.parametrize("optimiser", [slow("adam"), "soap"])
def test_interrupted_training_ends_with_the_same_weights(
    dataset: Path, tmp_path: Path, optimiser: str
) -> None:
    """Stopped by an exception after any step, and gone on with: bit for bit the same."""
    config = _config(tmp_path, 12, decoder_steps=6, optimiser=optimiser, decoder_hidden=24)
    whole = load_file(train_neural(config, _with_dataset(dataset, tmp_path / "whole")))
    folder = _with_dataset(dataset, tmp_path / "stopped")
    for stop in (3, 7, 14):
        with pytest.raises(KeyboardInterrupt):
            train_neural(config, folder, report=_stop_at(stop), keep_every=0)
    resumed = load_file(train_neural(config, folder, keep_every=0))
    assert whole.keys() == resumed.keys()
    assert all(np.array_equal(whole[name], resumed[name]) for name in whole)


def _stop_at(step: int):
    """Interrupts after so many steps in all, those of the decoder alone included."""

    def report(done: int, total: int, loss: float) -> None:
        if (done if total == 12 else 12 + done) == step:
            raise KeyboardInterrupt

    return report


@pytest.mark.slow
def test_killed_training_goes_on(dataset: Path, tmp_path: Path) -> None:
    """kill −9 twice, each time once some further checkpoints are there, in a process of its own."""
    config = tmp_path / "tiny.toml"
    config.write_text(TINY.format(steps=12, decoder_steps=12, decoder_hidden=24, optimiser="soap"))
    whole = load_file(train_neural(read_config(config), _with_dataset(dataset, tmp_path / "whole")))
    folder = _with_dataset(dataset, tmp_path / "killed")
    command = [sys.executable, "-c", _COMMAND, str(config), str(folder)]
    # The first within the training of the whole, the second within that of the decoder.
    for checkpoints in ("5", "12"):
        done = subprocess.run([*command, checkpoints], stderr=subprocess.DEVNULL)
        assert done.returncode == -signal.SIGKILL
    subprocess.run([*command, "0"], check=True, stderr=subprocess.DEVNULL)
    resumed = load_file(folder / "neural.safetensors")
    assert all(np.array_equal(whole[name], resumed[name]) for name in whole)


# Kills itself after so many checkpoints.
_COMMAND = """
import os, signal, sys
from pathlib import Path
from loomlight.training import loop
left, keep = int(sys.argv[3]), loop._keep
def keep_and_die(*given):
    global left
    keep(*given)
    left -= 1
    if left == 0:
        os.kill(os.getpid(), signal.SIGKILL)
loop._keep = keep_and_die
from studies.papers.chen2024.training.config import read_config
from studies.papers.chen2024.training.train import train_neural
train_neural(read_config(sys.argv[1]), Path(sys.argv[2]), keep_every=0)
"""


def test_checkpoint_of_another_configuration_is_refused(dataset: Path, tmp_path: Path) -> None:
    folder = _with_dataset(dataset, tmp_path / "run")
    train_neural(_config(tmp_path, 1), folder)
    with pytest.raises(InputError, match="another configuration"):
        train_neural(_config(tmp_path, 2), folder)
    checkpoint = folder / "checkpoint.safetensors"
    checkpoint.write_bytes(checkpoint.read_bytes()[:500])
    with pytest.raises(InputError, match="damaged"):
        train_neural(_config(tmp_path, 1), folder)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[training]\nsteps = 0", "training.steps = 0"),
        ("[training]\nspeed = 1", "training.speed"),
        ("[training]\ndecoder_hidden = -1", "training.decoder_hidden = -1"),
        ('[network]\nlatent = "tree"', "network.latent = 'tree'"),
        ("[training", "no TOML"),
    ],
)
def test_bad_configurations_end_in_a_sentence(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_config(path)
    assert words in str(caught.value)
    assert str(path) in str(caught.value)


@pytest.mark.parametrize("published", [False, True])
def test_components_come_back_through_the_map(published: bool) -> None:
    components = torch.rand(50, 4) * 2.9  # outputs are cut off at ln(1000 · 2.98 + 1)
    light = torch.nn.functional.normalize(torch.randn(50, 3), dim=1)
    back = unmapped(mapped(components, light, published), light, published)
    # e^x − 1 of float32 logarithms up to 8: 8·6e-8 relative, times a few.
    torch.testing.assert_close(back, components, rtol=3e-6, atol=1e-7)


@pytest.mark.parametrize("name", list(LOSSES))
def test_losses_vanish_at_the_truth_alone(name: str) -> None:
    truth = torch.rand(512, 5)
    light = torch.nn.functional.normalize(torch.randn(512, 3), dim=1)
    output = mapped(truth[:, :4], light, name == "published")
    assert LOSSES[name](output, truth[:, 4], truth, light) < 1e-5
    assert LOSSES[name](output + 0.1, truth[:, 4], truth, light) > 1e-3
    assert LOSSES[name](output, truth[:, 4] + 0.1, truth, light) > 1e-4


def test_faint_highlights_count_by_shares() -> None:
    light = torch.tensor([[0.0, 0.0, 1.0]]).repeat(64, 1)

    def cost(name: str, value: float, factor: float) -> float:
        truth = torch.tensor([[0.1, 0.1, value, value, 0.0]]).repeat(64, 1)
        off = truth[:, :4] * torch.tensor([1.0, 1.0, factor, factor])
        return float(LOSSES[name](mapped(off, light, False), truth[:, 4], truth, light))

    # Twice as bright as it should be: all the same to "faint" but for what "balanced" says as well.
    faint, bright = (cost("faint", value, 2) - cost("balanced", value, 2) for value in (0.005, 0.2))
    assert faint == pytest.approx(bright, rel=0.2)
    assert cost("balanced", 0.005, 2) < 0.1 * cost("balanced", 0.2, 2)
    # What is below 0, however far, stands for 0, and is still told to rise.
    for below in (-0.5, -100.0):
        output = torch.full((64, 4), below, requires_grad=True)
        truth = torch.full((64, 5), 0.1)
        LOSSES["faint"](output, truth[:, 4], truth, light).backward()
        assert output.grad.isfinite().all()
        assert (output.grad[:, 2:] < 0).all()


def test_small_footprints_are_drawn_less_often(dataset: Path) -> None:
    face = read_faces(next(dataset.glob("pool-*/*.safetensors")))[0]
    count, small = 40000, 0.25
    places, lights, views, truth = _draw(face, np.random.default_rng(3), count, small, False)
    assert len(places) == len(lights) == len(views) == len(truth) == count
    sizes = face.places[..., 2].ravel()
    kept = np.clip(np.sqrt(sizes / 2), small, 1)
    for below in (1 / 8, 0.5, 2.0):
        expected = kept[sizes < below].sum() / kept.sum()
        # 5 standard errors of a share among so many.
        assert abs((places[:, 2] < below).mean() - expected) < 5 * np.sqrt(expected / count)
    # A query keeps its own directions and truth.
    row = {place.tobytes(): k for k, place in enumerate(face.places.reshape(-1, 3))}
    for k in range(50):
        actual = row[places[k].tobytes()]
        pair = actual // face.places.shape[1]
        np.testing.assert_array_equal(lights[k], face.lights[pair])
        np.testing.assert_array_equal(views[k], face.views[pair])
        np.testing.assert_array_equal(truth[k], face.truth.reshape(-1, 5)[actual])


def test_small_footprints_are_where_their_rays_meet_yarn(dataset: Path) -> None:
    face = read_faces(next(dataset.glob("pool-*/*.safetensors")))[0]
    plane, seen = (_draw(face, np.random.default_rng(3), 4000, 1.0, parallax) for parallax in (False, True))
    moved = np.linalg.norm((seen[0] - plane[0])[:, :2], axis=1)
    size, cosine = plane[0][:, 2], plane[2][:, 2]
    assert (moved[size > 2] == 0).all()
    # Where rays come in low, they meet yarn farther away.
    small = size < 0.25
    middle = np.median(cosine[small])
    low, high = (moved[small & chosen].mean() for chosen in (cosine < middle, cosine > middle))
    assert low > 1.5 * high > 0
    for part in (1, 2, 3):
        np.testing.assert_array_equal(plane[part], seen[part])


def test_schedules() -> None:
    steps = TrainingConfig.model_validate({"training": {"schedule": "steps"}}).training
    assert [round(rate_factor(steps, progress), 3) for progress in (0, 0.59, 0.61, 0.95)] == [1, 1, 0.2, 0.04]
    cosine = TrainingConfig().training
    assert rate_factor(cosine, 0) < 1e-6
    assert rate_factor(cosine, 0.01) == pytest.approx(1, abs=1e-3)
    assert rate_factor(cosine, 1) == pytest.approx(0, abs=1e-6)


def test_weights_say_what_their_yarns_gave(dataset: Path, tmp_path: Path) -> None:
    folder = _with_dataset(dataset, tmp_path / "run")
    weights = read_weights(train_neural(_config(tmp_path, 1), folder))
    assert moved_since(weights.provenance, truth_numbers(llvm_float())) is None


def test_data_of_other_yarns_are_not_added_to(
    dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = _with_dataset(dataset, tmp_path / "run")
    monkeypatch.setattr(
        train, "truth_numbers", lambda _: [2 * number for number in truth_numbers(llvm_float())]
    )
    with pytest.raises(InputError, match=r"pool-.* has data of yarns that this version computes otherwise"):
        train_neural(_config(tmp_path, 1), folder)
