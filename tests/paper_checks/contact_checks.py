# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks 34 to 62: the contact algorithm, aliasing, post-processing."""
import os

import numpy

from free_ring import odd_force_share, odd_share
from registry import ByConstruction, CannotBeMade, by_test, check, percent
from scene import read_vtu, signed


# --- 3.5 contact algorithm ---------------------------------------------------------------------------------------------------

by_test(34, "the predictor is eq. 13, of order two", ("simulate_test", "CentralDifferences.AreThePapersEquation13:Schemes.AreOfOrderTwo:TimeMarch.DecaysFreely*"))


@check(35, "after each step active gaps are zero, and no inactive node is in the casing")
def _(c):
    left = sum(case.attribute("leftover_steps").sum() for case in c.cases)
    deepest = max(case.attribute("largest_penetration").max() for case in c.cases)
    scale = max(case.amplitude.max() for case in c.cases)
    return left == 0 and deepest < 1e-9 * scale, f"{left:.0f} steps leave a node in the casing; deepest {deepest:.1e} m"


@check(36, "the contact force is never tensile")
def _(c):
    least = min(min(case.attribute("smallest_multiplier").min(), min(at.smallest_force for at in case.speeds)) for case in c.cases)
    return least >= 0, f"smallest multiplier {least:.3g} N over {sum(len(case.speeds) for case in c.cases)} speeds"


@check(37, "without friction the force is along the normal")
def _(c):
    raise ByConstruction("the march knows one multiplier a node, along the node's normal; response.h5 has no other force")


@check(38, "the contact operator is symmetric and positive definite; its condition number is reported")
def _(c):
    condition = numpy.concatenate([case.attribute("compliance_condition") for case in c.cases])
    good, text = c.tests.run(("simulate_test", "Complementarity.*"))
    return good and bool(numpy.isfinite(condition).all() and (condition >= 1).all()), f"condition {condition.min():.3g} to {condition.max():.3g}; {text}"


@check(39, "work of contact, dissipation and change of energy balance to 1e-9")
def _(c):
    worst = max(abs(case.attribute("energy_closing_error")).max() for case in c.cases)
    return worst < 1e-9, f"closes to {worst:.1e} at every speed"


by_test(40, "the limit of the time step is printed, and a larger step is refused",
        ("stability_test", "CentralDifferencesLimit.*"))
by_test(41, "without contact the response is linear", ("simulate_test", "TimeMarch.MovesNothingWithoutContact:TimeMarch.DecaysFreely*"))


# --- 3.6 aliasing ------------------------------------------------------------------------------------------------------------

@check(42, "the contact force's fundamental frequency is N_l Omega (median over periodic speeds, 99 % of its variance)")
def _(c):
    words, good = [], True
    for case in c.cases:
        shares = []
        for at in (case.speeds[i] for i in numpy.flatnonzero(case.steady)):
            power = sum(waves[1:].__pow__(2).sum(axis=1) for waves in at.force_waves)
            orders = numpy.arange(1, len(power) + 1)
            if power.sum() > 0:
                shares.append(power[orders % case.lobes == 0].sum() / power.sum())
        good = good and numpy.median(shares) > 0.99
        words.append(f"{case.name}: on multiples of {case.lobes}, median {percent(numpy.median(shares))}, least {percent(min(shares))} of {len(shares)} speeds")
    return good, "; ".join(words)


def zig_zag(order):
    """The paper's fig. 13 for ten sectors."""
    return [0, 1, 2, 3, 4, 5, 4, 3, 2, 1][order % 10]


def on_the_zig_zag(case, orders):
    """Whether the marched motion puts each order on its nodal diameter; what was measured."""
    strongest = case.strongest_diameters(orders)
    return all(n == zig_zag(k) for k, (n, _) in strongest.items()), \
        f"{case.name}: " + ", ".join(f"EO {k} on {n} ({percent(share)})" for k, (n, share) in strongest.items())


@check(43, "on ten blades cos 6 theta is cos 4 theta and cos 8 theta is cos 2 theta, also for EO 6 and EO 8 of the computed motion")
def _(c):
    good, text = c.tests.run(("postprocess-test", "Aliasing.TenBladesCannotTellSixFromFour"))
    same, measured = on_the_zig_zag(c.lobed(2), (6, 8))
    return good and same, f"{measured}; {text}"


@check(44, "engine orders lie on the nodal diameters of the zig-zag of ten sectors, in the computed motion up to EO 12")
def _(c):
    good, text = c.tests.run(("postprocess-test", "Aliasing.*"))
    found = [on_the_zig_zag(case, range(case.lobes, 13, case.lobes)) for case in c.cases]
    return good and all(same for same, _ in found), "; ".join([*(measured for _, measured in found), text])


@check(45, "two lobes: EO 2, 4, 6, 8, 10, 12 lie on 2, 4, 4, 2, 0, 2; 1, 3 and 5 are free to respond and do not")
def _(c):
    same, measured = on_the_zig_zag(c.lobed(2), (2, 4, 6, 8, 10, 12))
    empty, odd = c.free_ring.verdict(odd_share)
    return same and empty, f"{measured}; power on 1, 3, 5 {odd}"


@check(46, "three lobes: EO 3, 6, ... 30 lie on 3, 4, 1, 2, 5, 2, 1, 4, 3, 0")
def _(c):
    return on_the_zig_zag(c.lobed(3), range(3, 31, 3))


@check(47, "eq. 17 gives the smallest k for each nodal diameter and number of lobes")
def _(c):
    good, text = c.tests.run(("postprocess-test", "Aliasing.TheNodalDiameterSolvesEquation17"))
    words = []
    for case in c.cases:
        strongest, smallest = case.strongest_diameters(range(case.lobes, 31, case.lobes)), {}
        for order, (n, _) in strongest.items():
            smallest.setdefault(n, order // case.lobes)
        expected = {n: c.aliasing.smallest_multiple(n, case.lobes) for n in smallest}
        good = good and smallest == expected
        words.append(f"{case.lobes} lobes, in the marched motion: " + ", ".join(f"k = {k} on {n}" for n, k in sorted(smallest.items())))
    return good, "; ".join([*words, text])


@check(48, "ten oscillators give table 1 in closed form and in time; other coefficients are zero to 1e-10")
def _(c):
    rows = c.aliasing.table_1()
    good, text = c.tests.run(("simulate_test", "TimeMarch.ReproducesTheAliasingTable*"))
    of_scheme = max(abs(float(row[6]) / float(row[5]) - 1) for row in rows)
    of_table = max(abs(float(row[6]) / float(row[4]) - 1) for row in rows)
    others = max(float(row[7]) for row in rows)
    diameters = [row[1] for row in rows]
    return good and diameters == [3, 4, 1, 2] and of_scheme < 1e-9 and of_table < 1e-5 and others < 1e-10, \
        f"on {diameters}; marched against the scheme's closed form {of_scheme:.0e}, against the table {of_table:.0e}, others {others:.0e}; {text}"


@check(49, "two lobes: in a steady motion each sector repeats its neighbour's signal 36 degrees later")
def _(c):
    two = c.lobed(2)
    two.figure("tip_motion")
    words = []
    for case in c.cases:
        residuals = numpy.array([at.shift_residual for at in case.speeds])[case.steady]
        words.append(f"{case.name}: median {numpy.median(residuals):.1e}, below 1 % at {(residuals < 0.01).sum()} of {len(residuals)} periodic speeds")
    here = two.speeds[two.example].shift_residual
    return here < 0.01, f"{here:.1e} of the motion at {two.rpm[two.example]:.0f} rpm; " + "; ".join(words)


@check(50, "two lobes: odd nodal diameters have less than 1 % of the power")
def _(c):
    empty, odd = c.free_ring.verdict(odd_share)
    two = c.lobed(2)
    breaking = sum(at.attributes["symmetry"].decode() == "breaking" for at in two.speeds)
    return empty, f"power {odd}; at {breaking} of {len(two.speeds)} speeds a disturbance of the odd ones would grow"


by_test(51, "two signals of close frequencies on two nodal diameters have one peak in time, and two in the two-way spectrum",
        ("postprocess-test", "TravellingSpectrum.SeparatesCloseFrequencies*"))


@check(52, "the leading edge's force is never negative, is periodic, and has peaks at multiples of N_l Omega only (99 %)")
def _(c):
    two = c.lobed(2)
    at = two.speeds[two.example]
    waves = at.force_waves[0]
    power = (waves[1:] ** 2).sum(axis=1)
    orders = numpy.arange(1, len(power) + 1)
    share = power[orders % 2 == 0].sum() / power.sum() * (1 - at.force_off_orders[0])
    _, force = two.signals(two.example)
    pulses = int((numpy.diff(numpy.concatenate([[0], force[:at.samples, 0] > 0]).astype(int)) == 1).sum())
    return force.min() >= 0 and share > 0.99, f"{two.rpm[two.example]:.0f} rpm: {pulses} pulses a revolution of sector 0, {percent(share)} on even orders"


@check(53, "the forces of all leading edges have even nodal diameters only")
def _(c):
    return c.free_ring.verdict(odd_force_share)


@check(54, "EO 1 to 4 travel backward, 6 to 9 forward, 0 and 5 stand; EO 4 and EO 6 on nodal diameter 4 run in opposite directions")
def _(c):
    good, text = c.tests.run(("postprocess-test", "Aliasing.DirectionOfTheEngineOrders:TravellingSpectrum.NamesTheDirection*"))
    index = [signed(p, 10) for p in (3, 6, 9, 12)]
    good = good and index == [3, -4, -1, 2]
    two = c.lobed(2)
    waves = two.waves[two.steady]
    four, six = waves[:, 4, 4].sum() / waves[:, 4, [4, 6]].sum(), waves[:, 6, 6].sum() / waves[:, 6, [4, 6]].sum()
    return good and four > 0.99 and six > 0.99, (f"p = 3, 6, 9, 12 on {index}; periodic speeds of {two.name}: EO 4 {percent(four)} backward, "
                                               f"EO 6 {percent(six)} forward; {text}")


# --- 3.7 post-processing -----------------------------------------------------------------------------------------------------

@check(55, "at evenly spaced speeds and some between them, motions are computed until steady, and transformed over whole revolutions")
def _(c):
    even = max(abs(numpy.diff(case.first_speeds, 2)).max() / numpy.diff(case.first_speeds).mean() for case in c.cases)
    whole = all(at.whole for case in c.cases for at in case.speeds)
    steady = {case.name: f"{len(case.first_speeds)} even ones and {len(case.speeds) + case.failed - len(case.first_speeds)} between, "
                         f"{int(case.periodic.sum())} periodic, {case.failed} failed" for case in c.cases}
    return even < 1e-6 and whole, f"steps equal to {even:.0e}; {steady}"


@check(56, "waterfall and interaction map show the same data, with engine orders and modal lines; crossings are listed")
def _(c):
    case = c.any_case
    waterfall, total = case.figure("waterfall"), case.figure("interaction_map_leading_edge")
    here = {(row["speed [rpm]"], row["frequency [Hz]"]): row["total [mm]"] for row in total}
    shared = [(row["total [mm]"], here[key]) for row in waterfall if (key := (row["speed [rpm]"], row["frequency [Hz]"])) in here]
    same = all(a == b for a, b in shared)
    return same and len(shared) > 0 and bool(case.report("linear_criterion.csv")), f"{len(shared)} points in both, equal: {same}; {len(case.report('linear_criterion.csv'))} crossings"


@check(57, "the contact map has 200 areas and a column per speed, for both edges")
def _(c):
    shapes = [case.contact_map(edge)[2].shape for case in c.cases for edge in ("leading", "trailing")]
    return all(shape[1] == 200 for shape in shapes), f"speeds x areas: {shapes}"


@check(58, "the counters sum to the contact steps of their node")
def _(c):
    good, text = c.tests.run(("postprocess-test", "ContactMap.DividesByTheStepsOverEachArea"))
    nodes = kept = 0
    for case in c.cases:
        for at in case.speeds:
            sums = at.count.sum(axis=2)
            per_sample = int(at.attributes["steps_per_revolution"]) // at.samples
            nodes += sums.size
            kept += int(((sums >= at.pushed_samples) & (sums <= per_sample * at.pushed_samples)).sum())
    return good and kept == nodes, f"{kept} of {nodes} nodes lie between their samples under force and all of those samples' steps; {text}"


@check(59, "contrast distinguishes speeds whose motion repeats from others; contrast and places are printed for each")
def _(c):
    words, good = [], True
    for case in c.cases:
        contrast, places, _ = case.contact_map("trailing")
        repeats = numpy.array([at.repeats for at in case.speeds])
        if repeats[case.even].all():
            words.append(f"{case.name}: every motion repeats")
            continue
        one, other = (numpy.median(contrast[case.even & which]) for which in (repeats, ~repeats))
        good = good and one > other
        words.append(f"{case.name}, trailing edge: median contrast {one:.3f} at speeds whose motion repeats, {other:.3f} at the {(case.even & ~repeats).sum()} others")
    return good, "; ".join(words)


@check(60, "trackings follow again from the stored motion")
def _(c):
    worst = 0.0
    for case in c.cases:
        diameters, orders = case.by_diameter(), case.figure("engine_order_tracking")
        for rows, pick in ((case.figure("nodal_diameter_tracking"), lambda f, k: (int(f.split()[1]), int(k.split()[1]))),
                           (orders, lambda f, k: (int(k.split()[1]), int(f.split()[2])))):
            for row in rows:
                i = abs(case.rpm - float(row["speed [rpm]"])).argmin()
                if row["curve"] == "mean":
                    continue
                order, n = pick(row["followed"], row["curve"])
                worst = max(worst, abs(1e-3 * float(row["amplitude [mm]"]) - diameters[i, order, n]))
    scale = max(case.waves[:, 1:].max() for case in c.cases)
    return worst < 1e-6 * scale, f"largest difference {worst / scale:.1e} of the largest amplitude"


@check(61, "bars at one speed show all nodal diameters at one engine order, and all engine orders on one nodal diameter")
def _(c):
    return c.figures_exist(c.any_case, "harmonic_bars")


@check(62, "displacement and stress are recovered on the wheel; half a turn leaves a two-lobe field unchanged")
def _(c):
    two = c.lobed(2)
    path = two.path("report", "fields", "contact_wheel.vtu")
    if not os.path.exists(path) or two.sectors % 2 != 0:
        raise CannotBeMade(f"{two.name} was post-processed without fields.h5, or has no half turn")
    wheel = read_vtu(path)
    # R u and R sigma R' of half a turn; a file for ParaView is in single precision
    vector, tensor = numpy.array([-1, -1, 1]), numpy.array([1, 1, 1, 1, -1, -1])
    displacement, stress = (abs(numpy.roll(field, two.sectors // 2, axis=0) - field * turn).max() / abs(field).max() for field, turn in (
        (wheel[name].reshape(two.sectors, -1, len(turn)), turn) for name, turn in (("displacement_vibration", vector), ("stress_vibration", tensor))))
    return displacement < 1e-6 and stress < 1e-6, f"after half a turn: displacement {displacement:.1e}, stress {stress:.1e} of the largest"
