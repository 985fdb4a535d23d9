"""The network that ships, on a card: what it is, what made it, and whether its yarns are today's."""

from __future__ import annotations

from loomlight.core.llvm import llvm_float
from loomlight.evaluation.table import Cell, Table
from loomlight.models.neural.decoder import decoder_cost
from loomlight.models.neural.learned_truth import moved_since, truth_numbers
from studies.harness.study import Found, Run, Study
from studies.papers.chen2024.stage import WeightsSettings


def card(settings: WeightsSettings, run: Run) -> Found:
    """Facts of the network, from its weights file."""
    weights = settings.network()
    table, recipe, made = weights.table, dict(weights.recipe), dict(weights.provenance)
    data, training = recipe.get("data", {}), recipe.get("training", {})
    decoder, encoder = (
        sum(values.size for name, values in weights.tensors.items() if name.startswith(part))
        for part in ("decoder.", "encoder.")
    )
    cost, fitted = decoder_cost(weights, False), decoder_cost(weights, True)
    change = moved_since(made, truth_numbers(llvm_float()))
    old = "trained before they were kept" if change == float("inf") else f"moved by {change or 0:.1%}"
    facts: dict[str, Cell] = {
        "checksum": weights.sha256[:12],
        "parameters of the encoder": encoder,
        "parameters of the decoder": decoder,
        "width of the decoder": table.hidden,
        "multiply-adds of a footprint and view": cost.per_view,
        "multiply-adds of a light": cost.per_light,
        "more, where the last layer is fitted to the fabric": fitted.per_light - cost.per_light,
        "bytes fetched": cost.bytes_fetched,
        "parts that its paper has not": ", ".join(
            name
            for name, there in (
                ("latent field", table.latent == "field"),
                ("fibre features", table.fibres),
                ("lobe basis", table.bundles),
                ("parallax", table.parallax),
            )
            if there
        ),
        "fabrics": data.get("fabrics"),
        "weaves": data.get("weaves"),
        "layouts": data.get("layouts"),
        "optimiser": training.get("optimiser"),
        "steps": made.get("steps"),
        "sources it was trained by": made.get("sources"),
        "machine": made.get("machine"),
        "yarns since then": "the same" if change is None else old,
    }
    run.report(1, 1)
    shown = Table("The network that ships", [""], {name: [value] for name, value in facts.items()})
    return Found(settings.figures(shown))


STUDIES = (
    Study(
        "papers/chen2024/card",
        "the network that ships: what it is, what made it, whether its yarns are today's",
        WeightsSettings(),
        card,
        stands_on=("network", "truth"),
    ),
)
