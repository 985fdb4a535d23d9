"""The query test of all models on the 24 held-out fabrics: the figures that recipes are chosen by.

    python experiments/query_test.py --models point,woven --output experiments/results/query_test.json
    python experiments/query_test.py --models woven --weights runs/a/woven.safetensors
    python experiments/query_test.py --models woven --fabrics 8 --pairs 40 --footprints 40     (a minute)

The protocol is docs/evaluation.md: 25 600 queries a fabric against slices on the reference plane, with 1, 3
and 16 Monte Carlo samples beside the models. The truths are kept on disk: the first run takes minutes, later
ones seconds. Tables are printed; `--output` writes every figure as JSON.

From other code: `run_query_test({"mine": predictor}, held_out_fabrics())` of `loomlight.evaluation` takes any
function (fabric, queries) -> Prediction, and `query_truth(fabric, seed)` gives queries and truth in numpy.
"""

from __future__ import annotations

import argparse
import sys
from functools import partial
from pathlib import Path

from loomlight.core.llvm import llvm_float
from loomlight.core.provenance import provenance
from loomlight.evaluation.held_out import held_out_fabrics
from loomlight.evaluation.predictions import Predictor, model_predictor
from loomlight.evaluation.query_test import SEED, run_query_test
from loomlight.evaluation.table import write_json
from loomlight.evaluation.truth import FOOTPRINTS, PAIRS
from loomlight.fabric.fabric import Fabric
from loomlight.models.registry import make_model
from loomlight.models.woven.encoding import encode
from loomlight.models.woven.model import WovenModel
from loomlight.models.woven.parameter_ranges import LAYOUT_RANGES, PARAMETER_RANGES
from loomlight.models.woven.weights import Weights, read_weights


def predictors(names: list[str], files: list[Path]) -> dict[str, Predictor]:
    """A predictor for each model by its name, and one for each file of weights of the woven network."""
    found = {name: model_predictor(partial(make_model, name)) for name in names}
    for file in files:
        found[f"woven {file.stem}"] = model_predictor(partial(woven_of, read_weights(file)))
    return found


def woven_of(weights: Weights, fabric: Fabric) -> WovenModel:
    """The woven network of these weights for a fabric."""
    return WovenModel(fabric, encode(fabric, weights, llvm_float()), weights)


def main() -> None:
    """Runs the test and prints its tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--models", default="", help="names, with commas between them")
    parser.add_argument("--weights", type=Path, action="append", default=[], help="weights of woven")
    parser.add_argument("--fabrics", type=int, default=None, help="only so many, of every kind")
    parser.add_argument("--varied-layouts", action="store_true", help="gaps and setts other than chen2024's")
    parser.add_argument("--pairs", type=int, default=PAIRS)
    parser.add_argument("--footprints", type=int, default=FOOTPRINTS)
    parser.add_argument("--seed", type=int, default=SEED, help="of the queries")
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    names = [name for name in arguments.models.split(",") if name]
    result = run_query_test(
        predictors(names, arguments.weights),
        held_out_fabrics(arguments.fabrics, LAYOUT_RANGES if arguments.varied_layouts else PARAMETER_RANGES),
        pairs=arguments.pairs,
        footprints=arguments.footprints,
        seed=arguments.seed,
        progress=lambda done, total: print(f"{done}/{total} fabrics", file=sys.stderr),
    )
    for table in result.tables():
        print(table.to_markdown())
    if arguments.output is not None:
        command = "python experiments/query_test.py " + " ".join(sys.argv[1:])
        write_json(arguments.output, {**provenance(command, Path(__file__).parent), **result.to_dict()})


if __name__ == "__main__":
    main()
