"""Small networks compute fastest on one thread, and bit for bit the same on any machine's count of them."""

import os

import pytest

os.environ["OMP_NUM_THREADS"] = "1"  # of processes that tests start
torch = pytest.importorskip("torch")
torch.set_num_threads(1)
