"""Models of textures and networks that are trained for one source: `neumip` and `latent`.

`queries` draws what is learned, of sources that `btfs` and `loomlight.mitsuba` answer for; `settings` says
how; `training`, `neumip_training` and `latent_training` learn it, by torch; `neumip` and `latent` are the
models, of the parts in `pyramid` and `model`.
"""
