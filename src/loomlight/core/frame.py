"""The local frame and its conventions, stated once for the whole package.

- ``z`` is the macro normal n_s, ``x`` = dp/du the weft direction, ``y`` = n_s × x the warp direction. On
  mirrored uv islands dp/dv points against ``y``; the draft's v is then flipped, so a Z twill stays Z.
- Directions are unit vectors pointing away from the surface, named ``light`` and ``view``. Mitsuba's
  ``si.wi`` is our ``view``; its ``wo`` argument is our ``light`` when tracing from the camera.
- Every model returns f(light, view)·|cos θ_light| in linear RGB, 1/sr.
- Lengths are millimetres, angles radians. End 1 of a draft lies at x = 0 and pick 1 at y = 0, both with
  their left or lower edge; a drawdown is ``True`` where the warp is on top.
- The back face is the front face of the cloth mirrored in the plane z = 0: drawdown inverted, twist
  negated, z of every direction negated. Scattering does not change under reflection.
"""
