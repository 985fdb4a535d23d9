"""Runs commands in the environment that this file is started in, as `python -I driver.py CASES.json`.

It is started by `environments.py` and imports nothing but what that environment has. Every case is a command
line of `loomlight`, a program, or words for a Python of its own; its exit code, what it printed and what it
wrote to stderr go to standard output as JSON. Code "traceback" is that of a case that ends in one.
"""

import io
import json
import os
import runpy
import subprocess
import sys
import traceback
from contextlib import redirect_stderr, redirect_stdout


def main(cases_file, folder):
    with open(cases_file, encoding="utf-8") as stream:
        cases = json.load(stream)
    os.chdir(folder)
    import loomlight

    answers = {"file": loomlight.__file__, "answers": [answer(**case) for case in cases]}
    json.dump(answers, sys.__stdout__)


def answer(words=None, program=None, python=None):
    if python is not None:
        done = subprocess.run([sys.executable, "-I", *python], capture_output=True, text=True)
        code = "traceback" if "Traceback" in done.stderr else done.returncode
        return {"code": code, "out": done.stdout, "err": done.stderr}
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = command(words) if words is not None else run_program(program)
    return {"code": code, "out": out.getvalue(), "err": err.getvalue()}


def command(words):
    try:
        from loomlight.cli.main import run

        return run(words)
    except BaseException:
        traceback.print_exc()
        return "traceback"


def run_program(program):
    from loomlight.core.errors import LoomlightError

    try:
        exec(program, {"__name__": "program"})
        return 0
    except LoomlightError as error:
        print(f"loomlight: {error}", file=sys.stderr)
        return 2
    except BaseException:
        traceback.print_exc()
        return "traceback"


if __name__ == "__main__":
    if sys.argv[1] == "--module":  # a module of a checkout: its root, its name, its arguments
        root, module, *arguments = sys.argv[2:]
        sys.path.append(root)
        sys.argv = [module, *arguments]
        runpy.run_module(module, run_name="__main__")
    else:
        main(*sys.argv[1:])
