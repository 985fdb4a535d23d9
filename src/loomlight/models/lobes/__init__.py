"""Prefiltered fibre lobes (ours): any cloth at any distance, with no training.

The points of a yarn are parted into a few groups of like normals and fibre directions. What a footprint needs
to know is how much of each group it holds, which a pyramid of a few bytes tells; how much of a group a view
sees and a light reaches, which small tables over directions tell; and the lobe of a group, a closed form of
its mean fibre direction and the spread about it. docs/models/lobes.md derives all of it.
"""
