"""A draft: named, looked at, changed, and written as a WIF file that weaving software opens."""

import numpy as np

import loomlight
from loomlight.weave import draw_draft, summary

draft = loomlight.named_weave("herringbone 2/2 8")  # loomlight.weave_names() lists them
print(summary(draft))

# True where the warp is on top, [picks, ends]; pick 1 is row 0, end 1 column 0.
drawdown = draft.drawdown.copy()
drawdown[0] = ~drawdown[0]  # one pick woven the other way round
mine = loomlight.Draft(drawdown=drawdown, title="herringbone with a fault")
print(np.argwhere(mine.drawdown != draft.drawdown).shape[0], "crossings differ")

loomlight.save(mine, "draft.wif")
loomlight.save(draw_draft(mine), "draft.png")  # threading, tie-up, treadling and drawdown
