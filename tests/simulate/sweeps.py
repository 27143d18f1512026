# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps over processes, upwards and downwards: same bytes whatever the ranks and interruptions; every scheme runs.

    sweeps.py <tiprub-simulate> <folder> <mpirun>
"""
import glob
import os
import random
import signal
import struct
import subprocess
import sys
import time

from small_wheel import CASE, Bench, require  # leaves with 77 where h5py is missing

import h5py
import numpy as np

bench = Bench(sys.argv[1], sys.argv[2])
mpirun = [sys.argv[3], "--oversubscribe", "-n", "2"]
if os.geteuid() == 0:
    mpirun.insert(1, "--allow-run-as-root")
random.seed(7)
small = CASE.replace("speed_count = 40", "speed_count = 12")

bench.write("small.toml", small)
require(bench.run("-q", "--threads", "1", case="small.toml").returncode == 0, "one process")
whole = bench.read()
ranks = subprocess.run(mpirun + bench.command("--threads", "1", case="small.toml", output="ranks.h5"),
                       stderr=subprocess.PIPE, text=True)
require(ranks.returncode == 0, "two processes: " + ranks.stderr.strip())
require(ranks.stderr.count("12 speeds") == 1, "only one of them reports")
require(bench.read("ranks.h5") == whole, "two processes: the same bytes")
require(not glob.glob(bench.path("*.speeds")), "and leave nothing beside it")

# Symptom: each process put the time of the run into its place, and the second didn't find what it had written beside it.
for _ in range(4):
    timed = subprocess.run(mpirun + bench.command("--threads", "1", "--times", bench.path("times.csv"), case="small.toml", output="ranks.h5"),
                           stderr=subprocess.PIPE, text=True)
    require(timed.returncode == 0, "two processes, which note one time: " + timed.stderr.strip()[-200:])

bench.write("adaptive.toml", small.replace("speed_max_rpm = 12000", "speed_max_rpm = 10000").replace('speeds = "given"\n', ""))
run = bench.run("--threads", "1", case="adaptive.toml", output="adaptive.h5")
require(run.returncode == 0 and " more scanned" in run.stderr, "adaptive: " + run.stderr.strip())
with h5py.File(bench.path("adaptive.h5")) as file:
    scanned = file["scanned_speed"][:]
    require(len(scanned) > len(file["speed"]) and (scanned[1:] > scanned[:-1]).all(), "  and the response lists what was scanned")
once = bench.read("adaptive.h5")
run = bench.run("--threads", "1", case="adaptive.toml", output="adaptive.h5")  # symptom: the scan was computed again
require("; 0 computed now" in run.stderr and bench.read("adaptive.h5") == once, "  nothing is computed twice: " + run.stderr.strip())
bench.run("-q", "--threads", "2", case="adaptive.toml", output="two.h5")
subprocess.run(mpirun + bench.command("-q", "--threads", "1", case="adaptive.toml", output="shared.h5"))
process = subprocess.Popen(bench.command("-q", "--threads", "1", case="adaptive.toml", output="killed.h5"))
time.sleep(1)
process.send_signal(signal.SIGKILL)
require(process.wait() != 0, "  killed")
bench.run("-q", "--threads", "1", case="adaptive.toml", output="killed.h5")
for name in ("two", "shared", "killed"):
    require(bench.read(name + ".h5") == bench.read("adaptive.h5"), f"  {name}: the same bytes")
os.remove(bench.path("killed.h5"))
# symptom: speeds that the run before had examined passed for critical speeds, and branches began at them
plain = ("-q", "--threads", "1", "--set", 'simulate.examine="none"')
bench.run(*plain, case="adaptive.toml", output="two.h5")
bench.run(*plain, case="adaptive.toml", output="plain.h5")
require(bench.read("two.h5") == bench.read("plain.h5") != once, "  after a run that examined: the same bytes as without it")

# symptom: branches began at the speeds that the first process had examined itself
bench.write("branches.toml", small.replace("speed_min_rpm = 9000", "speed_min_rpm = 9700").replace("speed_max_rpm = 12000", "speed_max_rpm = 11500")
            .replace("speed_count = 12", "speed_count = 8").replace('speeds = "given"\n', "") + 'branches = "critical_speeds"\nbranch_steps = 3\n')
run = bench.run("--threads", "2", case="branches.toml", output="branches.h5")
require(" branches of orbits" in run.stderr, "branches: " + run.stderr.strip())
subprocess.run(mpirun + bench.command("-q", "--threads", "1", case="branches.toml", output="branches_shared.h5"))
require(bench.read("branches_shared.h5") == bench.read("branches.h5"), "  two processes: the same bytes")

bench.write("orbit.toml", small + 'steady_state = "orbit"\n')
run = bench.run("--threads", "1", case="orbit.toml", output="orbit.h5")
require(run.returncode == 0, "orbits: " + run.stderr.strip())
with h5py.File(bench.path("orbit.h5")) as file:
    found = sum(at.attrs["orbit"] == b"found" for at in file["speed"].values())
    require(found > 0, f"  found at {found} of 12 speeds")
bench.run("-q", "--threads", "2", case="orbit.toml", output="orbit_two.h5")
subprocess.run(mpirun + bench.command("-q", "--threads", "1", case="orbit.toml", output="orbit_shared.h5"))
for name in ("orbit_two", "orbit_shared"):
    require(bench.read(name + ".h5") == bench.read("orbit.h5"), f"  {name}: the same bytes")

for direction in ("up", "down"):
    bench.write("carry.toml", small + f'sweep = "{direction}"\n')
    start = time.monotonic()
    run = bench.run("--threads", "1", case="carry.toml", output=direction + ".h5")
    spent = time.monotonic() - start
    require(run.returncode == 0, direction + ": " + run.stderr.strip())
    kills = 0
    while kills < 5:
        process = subprocess.Popen(bench.command("-q", case="carry.toml", output="killed.h5"))
        time.sleep(random.uniform(0, 0.3 * spent))
        process.send_signal(signal.SIGKILL)
        if process.wait() == 0:
            break
        kills += 1
    require(kills >= 2, f"killed {kills} times")
    bench.run("-q", case="carry.toml", output="killed.h5")
    require(bench.read("killed.h5") == bench.read(direction + ".h5"), direction + ", killed and resumed: the same bytes")
    os.remove(bench.path("killed.h5"))
    with h5py.File(bench.path(direction + ".h5")) as file:
        speeds = [file["speed"][name].attrs for name in file["speed"]]
        compared = [at for at in speeds if "rest_difference" in at]
        require(len(compared) == 11, "all but the first are compared with the motion from rest")

# A process that failed left the others waiting for ever. Here only the leader can: a stranger's folder stands in for a finished speed.
with h5py.File(bench.path("down.h5")) as file:
    third = sorted(at.attrs["speed"] for at in file["speed"].values())[-3]
os.makedirs(bench.path("stuck.h5.speeds/" + struct.pack(">d", third).hex() + ".h5"))
bench.write(bench.path("stuck.h5.speeds/" + struct.pack(">d", third).hex() + ".h5/note.txt"), "mine")
stuck = subprocess.run(["timeout", "60"] + mpirun + bench.command("-q", case="carry.toml", output="stuck.h5"),
                       stderr=subprocess.PIPE, text=True)
require(stuck.returncode == 1 and "can't be replaced: it is no file" in stuck.stderr, "all end where one fails: " + stuck.stderr)

breaking = CASE.replace("speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40", "speeds_rpm = [9000, 17576.27119]")
breaking = breaking.replace("damping_ratio = 0.005", "damping_ratio = 0.002\nsymmetry_check_revolutions = 300")  # the growth scatters
bench.write("mark.toml", breaking)
run = bench.run("--threads", "1", case="mark.toml", output="mark.h5")
require("symmetry-breaking at 1 speeds" in run.stderr and "speeds_rpm = [17576.27119]" in run.stderr, "a broken symmetry is named")
require(not os.path.exists(bench.path("mark_full.h5")), "  and no more is done")
bench.write("full.toml", breaking + 'when_symmetry_breaks = "full_run"\n')
run = bench.run("--threads", "1", case="full.toml", output="one.h5")
require(run.returncode == 0 and "one_full.h5: 1 speeds" in run.stderr, "or run whole: " + run.stderr.strip())
with h5py.File(bench.path("one_full.h5")) as file:
    require(list(file["nodal_diameters"]) == [0, 1, 2, 3] and file.attrs["independent_sectors"] == 6, "  with all sectors")
    require(b"full_run" in file.attrs["scope"], "  and says why")
    u = file["speed/00000/displacement"][()]
    apart = np.abs(u[:, :3] - u[:, 3:]).max() / np.abs(u).max()
    require(apart > 1e-2, f"  opposite sectors differ by {apart:.1e} there")
bench.run("-q", "--threads", "1", case="full.toml", output="again.h5")
ranks = subprocess.run(mpirun + bench.command("-q", "--threads", "1", case="full.toml", output="shared.h5"))
for name in ("again", "shared"):
    require(bench.read(name + "_full.h5") == bench.read("one_full.h5"), f"  {name}: the same bytes")

motions = {}
for scheme, more in (("trigonometric", ""), ("central_differences", "steps_per_revolution = 4000\n"),
                     ("residual_flexibility", "modes = 10\n"), ("moreau_jean", "steps_per_revolution = 4000\n"),
                     ("penalty", "penalty_stiffness = 300\nsteps_per_revolution = 40000\n")):
    bench.write("scheme.toml", CASE.replace("speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40", "speeds_rpm = [9000]")
                + f'scheme = "{scheme}"\n' + more)
    run = bench.run("-q", case="scheme.toml", output="scheme.h5")
    require(run.returncode == 0, f"scheme {scheme} {run.stderr.strip()}")
    with h5py.File(bench.path("scheme.h5")) as file:
        at = file["speed/00000"]
        require(abs(at.attrs["energy_closing_error"]) < 1e-9, f"  energy closes to {at.attrs['energy_closing_error']:.1e}")
        motions[scheme] = np.sqrt((at["displacement"][()] ** 2).mean())
        print("  rms", motions[scheme], "halving", at.attrs.get("halving_difference"))
for scheme, rms in motions.items():
    allowed = 0.2 if scheme in ("residual_flexibility", "penalty") else 0.05
    require(abs(rms / motions["trigonometric"] - 1) < allowed, f"{scheme}: the rms motion of the default")

# Symptom: a forced motion whose lobes drive above the resolved frequency was called broadband: nothing in the band had its period.
bench.write("lobes.toml", CASE.replace("lobes = 2", "lobes = 14").replace("damping_ratio = 0.005", "damping_ratio = 0.05\nunusual = true")
            .replace("speed_count = 40", "speed_count = 6\nresolved_frequency_hz = 1000"))
run = bench.run("-q", case="lobes.toml", output="lobes.h5")
require(run.returncode == 0, "14 lobes, and frequencies resolved up to engine orders of 5 to 7: " + run.stderr.strip())
with h5py.File(bench.path("lobes.h5")) as file:
    classes = [speed.attrs["motion"].decode() for speed in file["speed"].values()]
    require(classes == ["periodic"] * 6, f"  all motions are periodic: {classes}")
