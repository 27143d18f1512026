#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The disk is full at random moments of each stage: the old output stands, or none, finished speeds are kept, and the stage
ends with 1 and one line that names a file.

    full_disk.py PROGRAMS_FOLDER CASE WORK_FOLDER

It is full for one process: none of its files may grow beyond a limit, and what it writes further fails (RLIMIT_FSIZE; Python
ignores the signal that comes with it, and so do its children).
"""
import os
import random
import re
import resource
import shutil
import stat
import subprocess
import sys

MOMENTS = 20
MOMENTS_OF_AN_OPTION = 6
ERROR_LINE = re.compile(r"tiprub-\w+: error: [^\n]+\n")
# gnuplot takes seconds for a report; that its pictures are whole is tested beside draw().
GNUPLOT = r"""#!/bin/sh
[ "$1" = --version ] && exit
for name in $(sed -n "s/^load '\(.*\)[.]gp'$/\1/p" "$1"); do
  echo '<svg></svg>' > "$name.svg" && printf 'IEND\256B`\202' > "$name.png" || exit
done
"""

programs, case, work = map(os.path.abspath, sys.argv[1:])
random.seed(12)


def path(name):
    return os.path.join(work, name)


def run(stage, *arguments, room=None):
    """A stage in the work folder, with so much room on the disk [bytes] for each file; quiet then."""
    quiet = [] if room is None else ["-q"]
    def fill():
        if room is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))
    environment = dict(os.environ, PATH=path("bin") + ":" + os.environ["PATH"], OPENBLAS_NUM_THREADS="1")
    return subprocess.run([os.path.join(programs, f"tiprub-{stage}"), "case.toml", *arguments, *quiet], cwd=work, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, restore_signals=False, preexec_fn=fill)


def finish(stage, *arguments):
    done = run(stage, *arguments)
    assert done.returncode == 0, done.stderr
    return done.stderr


def contents(name):
    """Every file in a folder, or the file itself, and its bytes; folders too."""
    found = {}
    for folder, folders, files in os.walk(path(name)):
        found.update((os.path.join(folder, one), None) for one in folders)
        files = [os.path.join(folder, one) for one in files]
        found.update((one, open(one, "rb").read()) for one in files)
    if os.path.isfile(path(name)):
        found[path(name)] = open(path(name), "rb").read()
    return found


def largest(names):
    return max(len(data) for name in names for data in contents(name).values() if data is not None)


def remove(names):
    for name in names:
        shutil.rmtree(path(name), ignore_errors=True)
        if os.path.exists(path(name)):
            os.remove(path(name))


def require_failure(stage, done, room):
    what = f"{stage} with room for {room} bytes"
    assert done.returncode == 1, f"{what}: exit {done.returncode}; {done.stderr}"
    assert ERROR_LINE.fullmatch(done.stderr), f"{what}: {done.stderr}"


def rooms(size, moments):
    """Small ones more often: so are the files of a report."""
    return [0, size - 1] + [int(size * random.random()**2) for _ in range(moments - 2)]


def test_outputs(stage, arguments, outputs, old_settings, moments):
    """Whole outputs are replaced by nothing, and nothing is left where there were none."""
    finish(stage, *arguments)
    size = largest(outputs)
    messages = set()
    for old in (True, False):
        remove(outputs)
        if old:
            finish(stage, *arguments, "--set", old_settings)
        before = contents("")
        for room in rooms(size, moments // 2):
            done = run(stage, *arguments, room=room)
            require_failure(stage, done, room)
            messages.add(done.stderr)
            after = contents("")
            assert after == before, f"{done.stderr}: changed {[name for name in {*before, *after} if before.get(name) != after.get(name)]}"
    remove(outputs)
    finish(stage, *arguments)
    print(f"ok: {stage} {' '.join(arguments)}: {moments} moments, {len(messages)} messages, such as {min(messages)}", end="")


def test_exports(option, folder):
    """A folder of files, each of which is whole or not there."""
    finish("reduce", "sector.msh", option, folder)
    whole = contents(folder)
    for room in rooms(largest([folder]), MOMENTS_OF_AN_OPTION):
        remove([folder])
        done = run("reduce", "sector.msh", "-o", "exported.h5", option, folder, room=room)
        require_failure("reduce", done, room)
        assert contents(folder).items() <= whole.items(), done.stderr
        assert not os.path.exists(path("exported.h5")), done.stderr
    print(f"ok: reduce {option}: {MOMENTS_OF_AN_OPTION} moments, such as {done.stderr}", end="")


def test_finished_speeds():
    """What was finished before is kept, and not computed again."""
    # Critical speeds would be examined, and so computed again, when those beside them are there.
    once = ("simulate", "model.h5", "--set", 'simulate.examine="none"')
    response, kept = "response.h5", "response.h5.speeds"
    finish(*once, "--set", "simulate.speeds_rpm=[20000, 27000]")
    room = largest([response]) - 1
    remove([response])
    require_failure("simulate", run(*once, "--set", "simulate.speeds_rpm=[20000, 27000]", room=room), room)
    two = contents(kept)
    assert len(two) == 2, two.keys()
    remove([kept])
    finish(*once)
    whole = contents(response)
    numbers_kept = set()
    for room in rooms(largest([response]), MOMENTS):
        remove([response])
        os.makedirs(path(kept))
        for name, data in two.items():
            with open(name, "wb") as file:
                file.write(data)
        require_failure("simulate", run(*once, room=room), room)
        after = contents(kept)
        assert two.items() <= after.items() and not contents(response), (room, after.keys())
        numbers_kept.add(len(after))
        said = finish(*once)
        assert f" {4 - len(after)} computed now" in said, said
        assert contents(response) == whole and not os.path.exists(path(kept))
    assert numbers_kept >= {2, 4}, numbers_kept
    print(f"ok: simulate: {MOMENTS} moments with finished speeds; kept {numbers_kept}")


def main():
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(path("bin"))
    with open(path("bin/gnuplot"), "w", encoding="utf-8") as file:
        file.write(GNUPLOT)
    os.chmod(path("bin/gnuplot"), stat.S_IRWXU)
    shutil.copy(case, path("case.toml"))
    test_outputs("mesh", [], ["sector.msh"], "mesh.elements_along_span=3", MOMENTS)
    test_outputs("reduce", ["sector.msh"], ["model.h5"], "reduce.fixed_interface_modes=5", MOMENTS)
    test_outputs("reduce", ["sector.msh", "--fields", "fields.h5"], ["model.h5", "fields.h5"], "reduce.fixed_interface_modes=5",
                 MOMENTS_OF_AN_OPTION)
    test_outputs("reduce", ["sector.msh", "--modes", "modes.h5"], ["modes.h5"], "reduce.verification_modes=1", MOMENTS_OF_AN_OPTION)
    test_exports("--export-ccx", "decks")
    test_exports("--export-matrix-market", "matrices")
    test_finished_speeds()
    report = ["postprocess", ["model.h5", "response.h5"], ["report"], "postprocess.engine_order_max=5"]
    test_outputs(*report, MOMENTS)
    report[1] += ["--fields", "fields.h5"]
    test_outputs(*report, MOMENTS_OF_AN_OPTION)


main()
