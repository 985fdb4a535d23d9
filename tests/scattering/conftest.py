"""Makes the references beside these tests importable; the import mode leaves their folder out."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
