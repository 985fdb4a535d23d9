"""The one way to measure: what a study is, how it runs, and what is kept of it.

`study.py` says what a module declares; the command `python -m studies` (`command.py`) finds studies by name
(`catalogue.py`), runs them (`run.py`) and keeps records (`record.py`), which age as what they stand on
changes (`probes.py`, `stale.py`).
"""
