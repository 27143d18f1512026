# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases and studies by the programs, as make runs them; see cases/README.md and cases/study/README.md."""
import hashlib
import json
import os
import pty
import shlex
import shutil
import subprocess
import sys

from .responses import open_response

HERE = os.path.dirname(os.path.abspath(__file__))


class RunError(RuntimeError):
    """What a program said when it stopped."""


def _tiprub():
    """The folder that holds cases/chain.mk: TIPRUB, that of the package's source or installation, or that of the programs."""
    program = os.path.dirname(os.path.realpath(shutil.which("tiprub-simulate") or HERE))
    for folder in (os.environ.get("TIPRUB", ""), f"{HERE}/../../..", f"{HERE}/../../../../share/tiprub", f"{program}/../share/tiprub",
                   f"{program}/../.."):
        if os.path.exists(os.path.join(folder, "cases", "chain.mk")):
            return os.path.abspath(folder)
    raise RunError("found no cases/chain.mk: install Tiprub, or set TIPRUB to the folder of its source")


def _make(arguments, folder, progress):
    """Runs make, under a person's eyes on a terminal of its own, because the programs show their progress on a terminal only."""
    terminal, inner = pty.openpty() if progress and sys.stderr.isatty() else os.pipe()
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    with subprocess.Popen(["make", "--no-print-directory", *arguments], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          stdout=inner, stderr=inner) as running:
        os.close(inner)
        said = b""
        while part := _read(terminal):
            said = (said + part)[-10_000:]
            if progress:
                sys.stderr.write(part.decode(errors="replace"))
                sys.stderr.flush()
        os.close(terminal)
    if running.returncode != 0:
        lines = said.decode(errors="replace").replace("\r\n", "\n").strip().split("\n")
        lines = [line.rsplit("\r", 1)[-1] for line in lines]
        raise RunError("\n".join([line for line in lines if ": error: " in line] or lines[-5:]))


def _read(terminal):
    try:
        return os.read(terminal, 4096)
    except OSError:  # Linux tells the end of a terminal so.
        return b""


def run(case, set=None, folder=None, progress=True, **variables):  # pylint: disable=redefined-builtin
    """Runs a case to its report, as far as it is out of date, and returns its Response.

    `set` maps keys to values: {"casing.lobes": 3}. None removes a key from the case, so that its default holds. The files
    stand in `folder`; by default each set has one below `runs`.
    `variables` are those of a case's Makefile: MODEL="model.h5" and FIELDS="fields.h5" take a model, LAUNCH="mpirun -n 4"
    starts the sweep in four processes, SIMULATE_FLAGS="--threads 2" are options. `progress` shows what the programs print.

    >>> response = run("case.toml", set={"casing.lobes": 3}, MODEL="model.h5", FIELDS="fields.h5", progress=False)
    >>> response.sector_count, response.file["casing"].attrs["lobes"].item()
    (6, 3)
    """
    case = os.path.abspath(case)
    settings = " ".join(f"--set {shlex.quote(f'{key}={_value(value)}')}" for key, value in (set or {}).items())
    folder = folder or os.path.join("runs", hashlib.sha256(f"{case}\0{settings}".encode()).hexdigest()[:12])
    os.makedirs(folder, exist_ok=True)
    files = {name: os.path.abspath(value) for name, value in variables.items() if name in ("MESH", "MODEL", "FIELDS")}
    values = {"CASE": case, "SETTINGS": settings, **variables, **files}
    chain = os.path.join(_tiprub(), "cases", "chain.mk")
    _make(["-f", chain, *(f"{name}={value.replace('$', '$$')}" for name, value in values.items())], folder, progress)
    return open_response(os.path.join(folder, "response.h5"))


def _value(value):
    """As --set takes it, which removes a key without a value."""
    return "" if value is None else json.dumps(value)


def study(study_file, folder=None, jobs=None, progress=True, **variables):
    """Runs the points of a study, and returns its table of critical speeds as a pandas.DataFrame.

    `study_file` is the path of a study.toml, or a dictionary of the same form, with `case` as a path; there None as the
    value of a key removes it from the case. The results stand in `folder`: by default that of the file, or `study` for a
    dictionary. `jobs` points run at once, by default one.

    >>> table = study({"case": "case.toml", "model": "model.h5", "grid": {"lobes": {"key": "casing.lobes", "values": [2]}}}, progress=False)
    >>> table[["point", "lobes", "engine order"]]
         point  lobes  engine order
    0  lobes_2      2             6
    """
    import pandas
    if isinstance(study_file, dict):
        folder = folder or "study"
        os.makedirs(folder, exist_ok=True)
        files = {name: os.path.relpath(study_file[name], folder) for name in ("case", "mesh", "model", "fields") if name in study_file}
        study_file = _written({**study_file, **files}, os.path.join(folder, "study.toml"))
    folder = folder or os.path.dirname(os.path.abspath(study_file))
    values = {"STUDY": os.path.relpath(study_file, folder), **variables}
    makefile = os.path.join(_tiprub(), "cases", "study", "study.mk")
    _make(["-f", makefile, f"-j{jobs or 1}", *(f"{name}={value}" for name, value in values.items())], folder, progress)
    return pandas.read_csv(os.path.join(folder, "report", "study.csv"))


def _written(table, path):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"{key} = {_toml(value)}\n" for key, value in table.items())
    return path


def _toml(value):
    """JSON writes all values but tables as TOML does. A study removes a key by an empty table."""
    if value is None:
        return "{}"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {_toml(inner)}" for key, inner in value.items()) + "}"
    return json.dumps(value, ensure_ascii=False)
