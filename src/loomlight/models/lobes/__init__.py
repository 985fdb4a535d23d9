"""Prefiltered fibre lobes (ours): any cloth at any distance, with no training.

Surface points of the yarns are clustered into a few groups of similar normals and fibre directions. A
footprint is then described by the coverage of each group (a pyramid over the repeat), by the groups'
visibility from view and light (tables over the hemisphere), and by the lobe of each group, a closed form of
the mean and covariance of its fibre direction. docs/research/models/lobes.md has the derivation.
"""
