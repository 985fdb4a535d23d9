"""Numbers of the network's architecture that its weights do not show, shared with code without torch."""

from __future__ import annotations

SLOPE = 0.01  # of leaky ReLU
BINS = 8  # of one-blob coding
# The reach of a bin, in bins: neighbours overlap as Gaussians of one bin's deviation do.
BLOB_REACH = 2.5
# What the decoder is told of directions along the fibres of either family; see `network.fibre_features`.
# Bins of the half vector's inclination, over −1 to 1, and their reach in bins.
INCLINATION_BINS = 16
INCLINATION_REACH = 2.0
# How inclinations spread over the bins: three times as many to a degree at 0 as evenly.
INCLINATION_CROWDING = 0.5
# The density of a fibre's normals, as ln(30 D + 1)/4.
DENSITY_GAIN, DENSITY_SCALE = 30.0, 0.25
# Numbers of fibre features that lights bring, and that views do.
LIGHT_FEATURES, VIEW_FEATURES = 2 + 2 * INCLINATION_BINS + 2, 2
# Added to squared lengths: keeps the half vector of opposite directions finite.
OPPOSITE = 1e-4
# Bundles of fibres that lie alike, of each family: slopes along the yarn, times places across it, and one
# that is the same in all directions.
BUNDLE_SLOPES, BUNDLE_PLACES = 8, 3
BUNDLES = BUNDLE_SLOPES * BUNDLE_PLACES + 1
# What the network puts out for a bundle is of the order of 1 where its share of the light, 1/sr, is this.
BUNDLE_UNIT = 0.02
# Half the span of ln α over the parameter box.
LOG_ROUGHNESS = 1.15
# Side of the maps of a repeat for "vector", and maps a thread for "field".
VECTOR_MAP = 128
FIELD_MAP = 16
# ln(k x + 1) of the terms in reflection and in transmission (chen2024 eq. 9).
REFLECTION_GAIN = 100.0
TRANSMISSION_GAIN = 1000.0
# e^8 / 100 is brighter than any component.
LARGEST_OUTPUT = 8.0
# Ends or picks of the largest repeat that the encoder takes.
MOST_THREADS = 64
