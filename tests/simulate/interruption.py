# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep that is killed at any moment and resumed gives the same bytes, and so does any number of threads.

    interruption.py <tiprub-simulate> <folder>
"""
import glob
import os
import random
import signal
import subprocess
import sys
import time

from small_wheel import CASE, Bench, require

KILLS = 10

bench = Bench(sys.argv[1], sys.argv[2])
random.seed(5)


def clean():
    return not glob.glob(bench.path("*.part*")) and not glob.glob(bench.path("*.speeds"))


start = time.monotonic()
require(bench.run("--threads", "1").returncode == 0, "a sweep without interruption")
whole_time = time.monotonic() - start
whole = bench.read()
require(clean(), "leaves nothing beside it")

require(bench.run("--threads", "2", output="two.h5").returncode == 0 and bench.read("two.h5") == whole, "two threads: the same bytes")

kept = []
while len(kept) < KILLS:
    process = subprocess.Popen(bench.command("-q", "--threads", "2", output="killed.h5"))
    time.sleep(random.uniform(0, 0.1 * whole_time))
    process.send_signal(signal.SIGKILL)
    if process.wait() == 0:
        break
    kept.append(len(glob.glob(bench.path("killed.h5.speeds/*.h5"))))
require(len(kept) >= 4 and kept[-1] > 0, f"killed {len(kept)} times, speeds kept then: {kept}")
bench.run("-q", output="killed.h5")
require(bench.read("killed.h5") == whole, "killed and resumed: the same bytes")
require(clean(), "leaves nothing beside it")

process = subprocess.Popen(bench.command("-q", "--threads", "1", output="stopped.h5"))
time.sleep(0.4 * whole_time)
process.send_signal(signal.SIGINT)
require(process.wait() != 0, "interrupted from the keyboard")
require(not os.path.exists(bench.path("stopped.h5")) and not glob.glob(bench.path("stopped.h5.speeds/*.part*")),
        "no half response.h5, no half part")
bench.run("-q", output="stopped.h5")
require(bench.read("stopped.h5") == whole, "resumed: the same bytes")

spaced = "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40"
bench.write("few.toml", CASE.replace(spaced, "speeds_rpm = [9000, 12000]"))
again = bench.run(case="few.toml")
require("2 speeds" in again.stderr and " 0 computed now" in again.stderr, "fewer speeds: " + again.stderr.strip())
bench.write("more.toml", CASE.replace(spaced, "speeds_rpm = [9000, 10000, 12000]"))
again = bench.run(case="more.toml")
require("3 speeds" in again.stderr and " 1 computed now" in again.stderr, "more speeds: " + again.stderr.strip())
bench.write("other.toml", CASE.replace("2.0e-4", "2.1e-4").replace(spaced, "speeds_rpm = [9000]"))
again = bench.run(case="other.toml")
require(" 1 computed now" in again.stderr, "another casing: " + again.stderr.strip())
