# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input in, exact exit code and key phrase out.   messages.py <tiprub-simulate> <folder>"""
import os
import sys

from small_wheel import CASE, Bench, require, write_model

bench = Bench(sys.argv[1], sys.argv[2])


def expect(what, code, *phrases, arguments=(), **names):
    run = bench.run(*arguments, **names)
    lines = run.stderr.strip().splitlines()
    require(run.returncode == code and all(phrase in run.stderr for phrase in phrases), f"{what}: {run.stderr.strip()}")
    if code != 0:
        require(len(lines) == 1 and lines[0].startswith("tiprub-simulate: error: "), "  in one line")
        require(not os.path.exists(bench.path("response.h5")), "  and no response.h5")


def with_case(what, old, new, code, *phrases):
    if old not in CASE:
        raise ValueError(old)
    bench.write("changed.toml", CASE.replace(old, new))
    expect(what, code, *phrases, case="changed.toml")


def with_model(what, change, code, *phrases):
    write_model(bench.path("changed.h5"), change)
    expect(what, code, *phrases, model="changed.h5")


def spoil(name, value):
    def change(file):
        data = file[name][()]
        data.flat[1] = value
        file[name][...] = data
    return change


expect("no case", 1, "absent.toml: can't be read", case="absent.toml")
expect("no model", 1, "absent.h5: no such file", model="absent.h5")
expect("no folder", 1, "can't be written: no folder", output="absent/response.h5")
bench.write("text.h5", "text")
expect("no HDF5", 1, "text.h5: is not an HDF5 file, or is damaged", model="text.h5")

with_case("unknown key", "lobes = 2", "lobs = 2", 2, 'changed.toml:4:1: unknown key "lobs" in [casing]; known: shape, lobes')
with_case("unknown key", "damping_ratio", "damping", 2, 'unknown key "damping" in [simulate]; known: ')
with_case("negative clearance", "1.2e-4", "-1.2e-4", 2, "changed.toml:6:35: [casing] clearance = -0.00012 must be at least 0 [fraction of the chord, m]")
with_case("clearance outside the chord", "[1.0, 1.2", "[1.1, 1.2", 2, "must have its fractions of the arc length in 0 .. 1")
with_case("no amplitude", "amplitude = 2.0e-4\n", "", 2, "changed.toml:2:1: [casing] has no amplitude, and it has no default")
with_case("wide bumps", 'shape = "cosine"', 'shape = "bumps"\nbump_width_deg = 200', 2, "bump_width_deg = 200 must be more than 0 and at most 180 [deg]")
with_case("table beyond a lobe", 'shape = "cosine"\nlobes = 2\namplitude = 2.0e-4',
          'shape = "table"\nlobes = 2\ndistortion_table = [[0, 0], [200, 1e-4]]', 2, "must have its angles in 0 .. 360/lobes")
with_case("amplitude of a table", 'shape = "cosine"', 'shape = "table"\ndistortion_table = [[0, 0], [90, 1e-4]]', 2,
          'unknown key "amplitude" in [casing]')
with_case("paper's rule with the wrong scheme", "damping_ratio", 'contact = "paper"\ndamping_ratio', 2,
          'changed.toml:11:11: [simulate] contact = "paper" holds only with scheme = "central_differences"')
with_case("a jump with a law that remembers", "damping_ratio", 'acceleration = "anderson"\nscheme = "penalty"\ndamping_ratio', 2,
          '[simulate] acceleration = "anderson" holds only with contact = "complementarity" and neither')
with_case("unknown scheme", "damping_ratio", 'scheme = "newmark"\ndamping_ratio', 2,
          'scheme = "newmark" must be one of: trigonometric, central_differences, residual_flexibility, moreau_jean, penalty')
with_case("residual flexibility without modes", "damping_ratio", 'scheme = "residual_flexibility"\ndamping_ratio', 2,
          "[simulate] has no modes, and it has no default")
with_case("another scheme's key", "damping_ratio", 'moreau_jean_theta = 0.6\ndamping_ratio', 2, 'unknown key "moreau_jean_theta"')
with_case("theta that blows up", "damping_ratio", 'scheme = "moreau_jean"\nmoreau_jean_theta = 0.4\ndamping_ratio', 2,
          "moreau_jean_theta = 0.4 must be")
with_case("penalty too stiff for the step", "damping_ratio", 'scheme = "penalty"\npenalty_stiffness = 1e9\ndamping_ratio', 1,
          "no speed could be computed", "the penalty's springs included", "a lower penalty_stiffness")
with_case("fewer modes than contact nodes", "damping_ratio", "modes = 2\ndamping_ratio", 1, "no speed could be computed",
          "2 modes a nodal diameter can't move 3 contact nodes independently")
with_case("speeds the wrong way", "speed_max_rpm = 12000", "speed_max_rpm = 8000", 2, "[simulate] speed_max_rpm must be above speed_min_rpm")
with_case("speed beyond the model", "speed_max_rpm = 12000", "speed_max_rpm = 20000", 2, "speed_max_rpm goes to 20000 rev/min",
          "holds up to 19098.6")
with_case("a speed twice", "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40", "speeds_rpm = [9000, 9000]", 2,
          "speeds_rpm names a speed twice")
with_case("too few revolutions", "max_revolutions = 70", "max_revolutions = 10", 2, "max_revolutions must be at least min_revolutions")
with_case("step beyond the limit at every speed", "damping_ratio",
          'scheme = "central_differences"\nsteps_per_period = 4\nsamples_per_revolution = 12\ndamping_ratio', 1, "no speed could be computed",
          "central differences need h omega_max / 2 <= 1, and have", "set [simulate] steps_per_revolution to at least")
with_case("cold clearance closed by spin", "clearance =", 'clearance_state = "cold"\nclearance =', 1,
          "spin closes the cold clearance: contact node 0")

with_model("NaN in the model", spoil("nodal_diameter/0/K0", float("nan")), 1,
           "changed.h5: /nodal_diameter/0/K0: value 1 (row-major, from 0) is not finite")
with_model("wrong schema", lambda file: file.attrs.__setitem__("schema", b"tiprub-response"), 1,
           "is tiprub-response version 1, expected tiprub-model version 1")
with_model("mass of no mass", spoil("nodal_diameter/0/M", 0.5), 1, "/M is not Hermitian")
with_model("unstable rotor", lambda file: file.__setitem__("nodal_diameter/1/K1", -1e3 * file["nodal_diameter/1/M"][()]), 1,
           "no speed could be computed", "nodal diameter 1 has omega^2 = -", "statically unstable")

check = bench.run("--check")
require("at least 400 a period of the lowest frequency, for errors of 0.005" in check.stderr, "  and the step's reason")
require(check.returncode == 0 and "nodal diameters 0, 2: multiples of gcd(6 sectors, 2 lobes) = 2" in check.stderr, "--check says the scope")
require(not os.path.exists(bench.path("response.h5")), "--check writes nothing")
bench.write("changed.toml", CASE.replace("damping_ratio", "step_tolerance = 2e-2\ndamping_ratio"))
check = bench.run("--check", case="changed.toml")
require("at least 200 a period" in check.stderr, "four times the tolerance: half the steps")
bench.write("changed.toml", CASE.replace("damping_ratio", 'acceleration = "anderson"\ndamping_ratio'))
check = bench.run("--check", case="changed.toml")
require("settling: by a jump to the fixed point of 1/6 of a revolution and a shift of 1 sectors" in check.stderr, "--check says how it settles")
