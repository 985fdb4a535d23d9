"""The model clustered as shaders read it: summed-area tables, and tables of clusters by direction.

Summed-area tables hold the coefficients of compressed densities, whose sums they are too; uncompressed ones
of every half vector would take gigabytes.
"""

from __future__ import annotations

import numpy as np

from loomlight.models.clustered.footprint_sums import summed_areas
from loomlight.models.clustered.model import ClusteredModel
from loomlight.realtime.word_table import Tables, fill, packed_bytes
from loomlight.yarn.layout import ClothLayout


def pack_clustered(
    record: np.void, model: ClusteredModel, layout: ClothLayout | None, tables: Tables
) -> None:
    """Appends the tables of a fabric.

    Args:
        record: of the fabric.
    """
    del layout
    baked, words = model.tables, tables.words
    columns, rows = baked.counts
    width, height = model.source.repeat_mm
    sums = [
        summed_areas(*face, baked.clusters)
        for face in zip(baked.labels, baked.coefficients, baked.parallax, strict=True)
    ]
    values: dict[str, float] = {
        "is_baked": 1,
        "clusters": baked.clusters,
        "rank": baked.rank,
        "channels": sums[0].shape[2],
        "columns": columns,
        "rows": rows,
        "texel_width": width / columns,
        "texel_height": height / rows,
        "samples": model.options.samples,
        "sums": words.add(np.stack(sums).view(np.uint32)),
        "labels": words.add(packed_bytes(baked.labels)),
        "coefficients": words.add(packed_bytes(baked.coefficients)),
        "basis": words.add(baked.basis),
        "moments": words.add(baked.moments),
        "texels": words.add(baked.texels),
        "light": words.add(baked.light),
        "heights": words.add(baked.heights),
    }
    fill(record["clustered"], values)
