#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each stage is killed at random moments, has little address space, and works in a folder with an odd name.

    hostile.py killed|memory|odd_names PROGRAMS_FOLDER CASE WORK_FOLDER
"""
import os
import random
import re
import resource
import shutil
import signal
import stat
import subprocess
import sys
import time

MOMENTS = 4  # of each signal
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
ROOMS = (2 << 20, 16 << 20, 128 << 20, 1 << 30)  # bytes beside what a program takes to begin
LONGEST = 60  # s
ERROR_LINE = re.compile(r"tiprub-\w+: error: [^\n]+\n")
# Output, command, and a setting that makes another one.
STAGES = {
    "sector.msh": (["mesh"], "mesh.elements_along_span=3"),
    "model.h5": (["reduce", "sector.msh", "--fields", "fields.h5"], "reduce.fixed_interface_modes=5"),
    "response.h5": (["simulate", "model.h5"], "simulate.casing_areas=10"),
    "report": (["postprocess", "model.h5", "response.h5", "--fields", "fields.h5"], "postprocess.engine_order_max=5"),
}
# gnuplot takes seconds for a report.
GNUPLOT = r"""#!/bin/sh
[ "$1" = --version ] && exit
for name in $(sed -n "s/^load '\(.*\)[.]gp'$/\1/p" "$1"); do
  echo '<svg></svg>' > "$name.svg" && printf 'IEND\256B`\202' > "$name.png" || exit
done
"""


RUN = re.compile(rb'<div id="run">.*?</div>', re.DOTALL)  # a page's only part that says when and how it was made


class Bench:
    def __init__(self, programs, case, folder):
        self.programs, self.folder = programs, folder
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(self.path("bin"))
        with open(self.path("bin/gnuplot"), "w", encoding="utf-8") as file:
            file.write(GNUPLOT)
        os.chmod(self.path("bin/gnuplot"), stat.S_IRWXU)
        shutil.copy(case, self.path("case.toml"))
        self.environment = dict(os.environ, PATH=self.path("bin") + ":" + os.environ["PATH"], OPENBLAS_NUM_THREADS="1")

    def path(self, name):
        return os.path.join(self.folder, name)

    def start(self, stage, *arguments, **more):
        return subprocess.Popen([os.path.join(self.programs, f"tiprub-{stage}"), *arguments], cwd=self.folder, env=self.environment,
                                text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, **more)

    def finish(self, stage, *arguments):
        run = self.start(stage, "case.toml", *arguments, "-q")
        said = run.communicate(timeout=10 * LONGEST)[1]
        assert run.returncode == 0, f"{stage} {arguments}: {run.returncode}: {said}"

    def contents(self, name):
        """Of a file, or of all files in a folder; nothing if there is neither."""
        path = self.path(name)
        if os.path.isfile(path):
            with open(path, "rb") as file:
                return RUN.sub(b"", file.read())
        return {found: self.contents(os.path.join(folder, found)) for folder, _, files in os.walk(path) for found in files} or None

    def remove(self, name):
        shutil.rmtree(self.path(name), ignore_errors=True)
        if os.path.exists(self.path(name)):
            os.remove(self.path(name))


def killed(bench):
    for output, (command, other) in STAGES.items():
        bench.finish(*command, "--set", other)
        old = bench.contents(output)
        begin = time.monotonic()
        bench.finish(*command)
        takes, whole = time.monotonic() - begin, bench.contents(output)
        assert whole != old
        found = []
        for number in SIGNALS:
            for moment in range(MOMENTS):
                before = None if moment % 2 else old
                bench.remove(output)
                if before:
                    bench.finish(*command, "--set", other)
                run = bench.start(command[0], "case.toml", *command[1:], "-q")
                time.sleep(random.uniform(0, takes))
                run.send_signal(number)
                said = run.communicate(timeout=LONGEST)[1]
                after = bench.contents(output)
                assert after in (before, whole), f"{output}: neither the old one nor the whole new one after {number.name}; {said}"
                assert run.returncode in (0, -number, 128 + number), f"{output}: {run.returncode} after {number.name}: {said}"
                assert run.returncode != 0 or after == whole, said
                stray = [name for name in os.listdir(bench.folder) if ".part" in name]
                assert number == signal.SIGKILL or not stray, f"{output}: {stray} is left after {number.name}"
                found.append(after == whole)
                bench.finish(*command)
                assert bench.contents(output) == whole, f"{output}: another one after {number.name}"
        print(f"ok: {command[0]}: killed at {len(found)} moments, finished at {sum(found)} of them")


def limited(bench, room, stage, *arguments):
    """Exit code and words of a stage with so much address space [bytes]."""
    run = bench.start(stage, *arguments, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room, room)))
    said = run.communicate(timeout=LONGEST)[1]
    return run.returncode, said


def least_room(bench, stage):
    """The address space that a stage takes to begin, to a MB."""
    low, high = 1 << 20, 16 << 30
    while high - low > 1 << 20:
        middle = (low + high) // 2
        low, high = (low, middle) if limited(bench, middle, stage, "--version")[0] == 0 else (middle, high)
    return high


def memory(bench):
    for output, (command, _) in STAGES.items():
        least = least_room(bench, command[0])
        codes = []
        for room in ROOMS:
            bench.remove(output)
            code, said = limited(bench, least + room, command[0], "case.toml", *command[1:], "-q")
            assert code in (0, 1) and (code == 0 or ERROR_LINE.fullmatch(said)), f"{output}: {code} with {room} bytes: {said}"
            assert (bench.contents(output) is not None) == (code == 0), f"{output}: {said}"
            codes.append(code)
        assert codes[-1] == 0, f"{output}: {said}"
        bench.finish(*command)
        print(f"ok: {command[0]}: exit codes {codes} with {[room >> 20 for room in ROOMS]} MB beside {least >> 20}")


def odd_names(bench):
    """Whole runs, by names with a path and without one, in the folder and from elsewhere."""
    plain = {}
    for output, (command, _) in STAGES.items():
        bench.finish(*command)
        plain[output] = bench.contents(output)
    for name in ("with blanks  in it", "ä ö ü ß", "it's \"quoted\"", "$(touch ran) `touch ran`; #&*?", "-q", "a\tb\nc"):
        odd = Bench(bench.programs, bench.path("case.toml"), bench.path(os.path.join("odd", name)))
        for output, (command, _) in STAGES.items():
            stage, *inputs = (word if word.startswith("--") or word == "mesh" or not word.count(".") else odd.path(word) for word in command)
            run = bench.start(stage, odd.path("case.toml"), *inputs, "-q", "-o", odd.path(output))
            said = run.communicate(timeout=10 * LONGEST)[1]
            assert run.returncode == 0, f"{name}: {output}: {said}"
            assert odd.contents(output) == plain[output], f"{name}: {output} is another one"
        assert not os.path.exists(bench.path("ran")) and not os.path.exists(odd.path("ran"))
        print(f"ok: {name!r}")


def main(step, programs, case, work):
    random.seed(12)
    {"killed": killed, "memory": memory, "odd_names": odd_names}[step](Bench(programs, case, work))


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
