# SPDX-License-Identifier: GPL-3.0-or-later
"""One mass on a spring: writes model.h5 and case.toml, runs tiprub-simulate, reads response.h5. Written from reduce/format.md and
simulate/keys.md, format.md and theory.md alone.

    one_mass.py <tiprub-simulate> <folder> [tolerance]

1. Free decay: a table casing has one bump; it pushes the mass once a revolution and lets it go. What follows is compared
   with the closed form of the discrete decay and with the exact one.
2. A bouncing orbit: a cosine casing lifts the mass, loses it, and catches it again, without rebound. The impact oscillator
   in closed form: on the wall u = w(t); it leaves where m w'' + c w' + k w changes sign; free flight; it returns where
   the free flight meets the wall.
3. With `tolerance`, and only that, because it takes 1e8 steps: the tolerance that the step is halved for, kept on orbits with
   impacts.
"""
import bisect
import math
import os
import subprocess
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    print("SKIPPED: needs python3-h5py")
    sys.exit(77)

PROGRAM, FOLDER = sys.argv[1], sys.argv[2]
MASS, STIFFNESS, RATIO = 0.02, 8.0e4, 0.02
OMEGA = math.sqrt(STIFFNESS / MASS)
DAMPED = OMEGA * math.sqrt(1 - RATIO**2)


def write_model(path):
    with h5py.File(path, "w") as file:
        file.attrs["schema"] = np.bytes_("tiprub-model")
        file.attrs["schema_version"] = 1
        file.attrs["generator"] = np.bytes_("one_mass.py")
        file.attrs["sector_count"] = 1
        file.attrs["speed_max"] = 2000.0
        file["contact/position"] = [[0.1, 0.0, 0.0]]
        file["contact/normal"] = [[1.0, 0.0, 0.0]]
        file["contact/arc_length"] = [0.0]
        file["nodal_diameter/0/K0"] = STIFFNESS * np.eye(3)
        file["nodal_diameter/0/M"] = MASS * np.eye(3)


def run(name, case):
    os.makedirs(FOLDER, exist_ok=True)
    model, toml, response = (os.path.join(FOLDER, name + end) for end in (".model.h5", ".toml", ".response.h5"))
    for old in (response,):
        if os.path.exists(old):
            os.remove(old)
    write_model(model)
    with open(toml, "w") as file:
        file.write(case)
    subprocess.run([PROGRAM, toml, model, "-o", response, "-q"], check=True)
    with h5py.File(response) as file:
        speed = file["speed/00000"]
        return dict(speed.attrs), speed["displacement"][:, 0, 0, 0], speed["contact_force"][:, 0, 0]


def require(holds, what):
    print(("ok: " if holds else "WRONG: ") + what)
    if not holds:
        sys.exit(1)


def free_decay():
    attributes, u, force = run("decay", f"""
[casing]
shape = "table"
lobes = 1
distortion_table = [[0.0, 0.0], [20.0, 1.2e-3], [40.0, 0.0]]
clearance = [[0.0, 1.0e-3]]
[simulate]
speeds_rpm = [2000.0]
unusual = true  # a tenth of what the model holds
damping_ratio = {RATIO}
steps_per_revolution = 2400
samples_per_revolution = 2400
recorded_revolutions = 1
""")
    require(attributes["steps_per_revolution"] == 2400, "a sample a step")
    h = 2 * math.pi / attributes["speed"] / 2400
    last = int(np.flatnonzero(force)[-1])
    free = u[last + 1:]
    require(len(free) > 1500, f"free for {len(free)} steps")
    root = np.exp(complex(-RATIO * OMEGA, DAMPED) * h)
    # discrete: the free step of simulate/theory.md, from two samples on
    a, b = 2 * root.real, abs(root)**2
    discrete = list(free[:2])
    while len(discrete) < len(free):
        discrete.append(a * discrete[-1] - b * discrete[-2])
    error = np.abs(np.array(discrete) - free).max() / np.abs(free).max()
    require(error < 1e-10, f"discrete decay: {error:.1e}")
    # exact: Re(z e^{s t}), z from the first sample and one a quarter of a period later
    quarter = round(math.pi / 2 / DAMPED / h)
    matrix = [[1.0, 0.0], [(root**quarter).real, -(root**quarter).imag]]
    z = complex(*np.linalg.solve(matrix, [free[0], free[quarter]]))
    exact = (z * root**np.arange(len(free))).real
    error = np.abs(exact - free).max() / np.abs(free).max()
    require(error < 1e-10, f"exact decay: {error:.1e}")


def closed_orbit(speed, amplitude, clearance, lobes):
    """Phase of leaving and of return (rad of the casing, crest at 0), and the flight between, as a function of phase."""
    wave = lobes * speed
    wall = lambda p: clearance - amplitude * math.cos(p)
    slope = lambda p: amplitude * wave * math.sin(p)
    bend = lambda p: amplitude * wave**2 * math.cos(p)
    pull = lambda p: MASS * bend(p) + 2 * RATIO * OMEGA * MASS * slope(p) + STIFFNESS * wall(p)

    def crossing(f, low, high):
        for _ in range(200):
            middle = (low + high) / 2
            low, high = (middle, high) if f(middle) * f(low) > 0 else (low, middle)
        return (low + high) / 2

    leave = crossing(pull, 0.0, math.pi)  # the wall pushes while m w'' + c w' + k w < 0
    x, v = wall(leave), slope(leave)

    def flight(p):
        t = (p - leave) / wave
        decay = math.exp(-RATIO * OMEGA * t)
        return decay * (x * math.cos(DAMPED * t) + (v + RATIO * OMEGA * x) / DAMPED * math.sin(DAMPED * t))

    p = leave + 1e-3
    while flight(p) < wall(p):
        p += 1e-4
    catch = crossing(lambda q: flight(q) - wall(q), p - 1e-4, p)
    return leave, catch, wall, flight, pull


def bouncing_orbit():
    speed, amplitude, clearance, lobes = 700.0, 1.0e-3, 0.4e-3, 1
    errors = []
    for steps in (2400, 9600):
        attributes, u, force = run("orbit", f"""
[casing]
shape = "cosine"
lobes = {lobes}
amplitude = {amplitude}
clearance = [[0.0, {clearance}]]
[simulate]
speeds_rpm = [{speed * 60 / (2 * math.pi)!r}]
damping_ratio = {RATIO}
steps_per_revolution = {steps}
samples_per_revolution = {steps}
recorded_revolutions = 1
""")
        require(attributes["motion"] == b"periodic", "the orbit is periodic")
        leave, catch, wall, flight, pull = closed_orbit(speed, amplitude, clearance, lobes)
        phase = 2 * math.pi * np.arange(steps) / steps
        turned = np.where(phase < leave, phase + 2 * math.pi, phase)
        exact = np.array([flight(p) if p < catch else wall(p) for p in turned])
        errors.append(np.abs(exact - u).max() / np.abs(exact).max())
        touching = np.flatnonzero(force)
        begin, end = 2 * math.pi * touching[0] / steps, 2 * math.pi * touching[-1] / steps
        print(f"{steps} steps: leaves at {leave:.5f} rad, returns at {catch:.5f}, error {errors[-1]:.1e}")
        closed = np.zeros(steps, bool)
        closed[touching] = True
        expected = (turned > catch) | (np.abs(turned - leave - 2 * math.pi) < 1e-12)
        require((closed != expected).sum() <= 6, f"in contact where it should be, but for {(closed != expected).sum()} steps")
        on_wall = closed & np.roll(closed, 3) & np.roll(closed, -3)
        push = np.array([-pull(p) for p in turned])
        error = np.abs(force - push)[on_wall & (turned > catch + 0.05)].max() / push.max()
        require(error < 50.0 / steps, f"contact force: {error:.1e}")
    require(errors[1] < 2e-3 and errors[1] < errors[0] / 3, "the orbit converges")


def impact_orbit(speed, amplitude, clearance):
    """The settled motion by events, as a function of the casing's phase: on the wall while it pushes, else free flight; an impact
    takes the wall's velocity. From 52 turns, of which what comes before the 50th has died out."""
    wall = lambda p: clearance - amplitude * math.cos(p)
    slope = lambda p: amplitude * speed * math.sin(p)
    pull = lambda p: MASS * amplitude * speed**2 * math.cos(p) + 2 * RATIO * OMEGA * MASS * slope(p) + STIFFNESS * wall(p)

    def root(f, low, high):
        sign = f(low)
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if f(middle) * sign > 0 else (low, middle)
        return (low + high) / 2

    def flight(start):
        x, v = wall(start), slope(start)

        def at(p):
            t = (p - start) / speed
            return math.exp(-RATIO * OMEGA * t) * (
                x * math.cos(DAMPED * t) + (v + RATIO * OMEGA * x) / DAMPED * math.sin(DAMPED * t))
        return at

    step, starts, pieces, p = 1e-3, [], [], 0.0
    while p < 2 * math.pi * 52:
        if pull(p) < 0:
            starts.append(p)
            pieces.append(wall)
            q = p
            while pull(q) < 0:
                q += step
            p = root(pull, q - step, q)
        fly = flight(p)
        starts.append(p)
        pieces.append(fly)
        q = p + step
        while fly(q) < wall(q):
            q += step
        p = root(lambda at: fly(at) - wall(at), q - step, q)
    return lambda p: pieces[bisect.bisect_right(starts, p + 100 * math.pi) - 1](p + 100 * math.pi)


def kept_tolerance():
    """Symptom once: steps went as tolerance^-1/2, but impacts make errors of first order: 120 times a tolerance of 5e-6."""
    amplitude, clearance, samples = 1.0e-3, 0.4e-3, 240
    for speed in (1050.0, 1055.0, 1058.9, 1060.0, 1065.0):
        orbit = impact_orbit(speed, amplitude, clearance)
        exact = np.array([orbit(2 * math.pi * sample / samples) for sample in range(samples)])
        for tolerance in (5e-2, 5e-3, 5e-4, 5e-5, 5e-6):
            attributes, u, _ = run("tolerance", f"""
[casing]
lobes = 1
amplitude = {amplitude}
clearance = [[0.0, {clearance}]]
[simulate]
speeds_rpm = [{speed * 60 / (2 * math.pi)!r}]
damping_ratio = {RATIO}
step_tolerance = {tolerance}
settle_tolerance = {min(1e-4, tolerance / 50)}
samples_per_revolution = {samples}
examine = "none"
""")
            error = np.linalg.norm(u[:samples] - exact) / np.linalg.norm(exact)
            require(attributes["motion"] == b"periodic" and error < 1.5 * tolerance,
                    f"{speed} rad/s, {attributes['steps_per_revolution']} steps: error {error:.1e}, tolerance {tolerance:.0e}")


if sys.argv[3:] == ["tolerance"]:
    kept_tolerance()
else:
    free_decay()
    bouncing_orbit()
