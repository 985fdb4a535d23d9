"""`python -m tools.generate.shaders`; see `build.py`."""

import sys

from tools.generate.shaders.build import main

main(sys.argv[1:])
