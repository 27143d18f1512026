# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks 63 to 81: what the paper found with two and three lobes, and its claims."""
import os
import math
import re

import numpy

from free_ring import odd_to_even
from linear_checks import rule_scores
from registry import WHEEL, CannotBeMade, check, percent


# --- 3.8 results, two lobes --------------------------------------------------------------------------------------------------

@check(63, "the gap repeats every 180 (120) degrees and has two (three) minima")
def _(c):
    words, good = [], True
    for case in c.cases:
        ring = case.distortion[:-1]
        turn = len(ring) // case.lobes
        residual = abs(ring - numpy.roll(ring, turn)).max() / abs(ring).max()
        minima = int(((ring > numpy.roll(ring, 1)) & (ring >= numpy.roll(ring, -1))).sum())
        good = good and residual < 1e-9 and minima == case.lobes
        words.append(f"{case.lobes} lobes: {minima} minima of the gap, periodic to {residual:.0e}")
    return good, "; ".join(words)


@check(64, "the interaction map is the sum of its six parts to 1e-12")
def _(c):
    good, text = c.tests.run(("postprocess-test", "InteractionMap.TotalIsTheSumOfItsParts"))
    worst = top = 0.0
    for row in c.any_case.figure("interaction_map_leading_edge"):
        total = float(row["total [mm]"])
        parts = sum(float(value) for key, value in row.items() if key.startswith("nodal diameter"))
        worst, top = max(worst, abs(total - parts)), max(top, total)
    return good and worst < 1e-8 * top, f"printed tables agree to {worst / top:.0e} (ten digits); {text}"


@check(65, "two lobes: the odd parts of the map are negligible")
def _(c):
    negligible, ratio = c.free_ring.verdict(odd_to_even)
    return negligible, f"largest odd over largest even, {ratio}"


@check(66, "two lobes: nodal diameters 2 and 4 have most of the motion")
def _(c):
    two = c.lobed(2)
    power = (two.by_diameter()[two.even, 1:] ** 2).sum(axis=(0, 1))
    share = power / power.sum()
    return share[2] + share[4] > 0.5, ", ".join(f"{n}: {percent(value)}" for n, value in enumerate(share))


@check(67, "two lobes: the highest point of the map is not on EO 2 (paper: EO 6, nodal diameter 4)", WHEEL)
def _(c):
    two = c.lobed(2)
    parts = two.by_diameter()
    total = parts.sum(axis=2)[:, 1:]
    i, k = numpy.unravel_index(total.argmax(), total.shape)
    n = int(parts[i, k + 1].argmax())
    best = {order: f"{1e3 * total[:, order - 1].max():.4f} mm at {two.rpm[total[:, order - 1].argmax()]:.0f} rpm" for order in (2, 4, 6, 8)}
    return k + 1 != 2, f"EO {k + 1}, nodal diameter {n}, {two.rpm[i]:.0f} rpm; highest by engine order: {best}"


@check(68, "two lobes: EO 2 has 95 % of its power on nodal diameter 2, and EO 4 on 4")
def _(c):
    two = c.lobed(2)
    power = (two.by_diameter() ** 2)
    shares, steady = ({order: power[rows, order, n].sum() / power[rows, order].sum() for order, n in ((2, 2), (4, 4))}
                      for rows in (two.even, two.steady))
    return min(shares.values()) > 0.95, "; ".join(f"EO {k}: {percent(shares[k])} (periodic speeds {percent(steady[k])})" for k in shares)


@check(69, "two lobes: within EO 1 to 6, nodal diameter 2 has 95 % of its power on EO 2; EO 8 is reported")
def _(c):
    two = c.lobed(2)
    power = two.by_diameter()[:, :, 2] ** 2
    share, steady = (power[rows, 2].sum() / power[rows, 1:7].sum() for rows in (two.even, two.steady))
    eight = numpy.sqrt(power[:, 8].max() / power[:, 2].max())
    return share > 0.95, f"{percent(share)} of the power within 1-6 (periodic speeds {percent(steady)}); EO 8 reaches {percent(eight)} of EO 2's amplitude"


@check(70, "two lobes: nodal diameter 4 has EO 4 and EO 6 at all speeds, and EO 6 exceeds EO 4 at most critical speeds")
def _(c):
    two = c.lobed(2)
    amplitude = two.by_diameter()[:, :, 4]
    floor = 0.01
    both = numpy.minimum(amplitude[:, 4], amplitude[:, 6]) > floor * amplitude[:, 1:].max(axis=1)
    above = amplitude[:, 6] > amplitude[:, 4]
    critical = numpy.array([numpy.argmin(abs(two.rpm - float(row["speed [rpm]"]))) for row in two.critical], dtype=int)
    at_critical = above[critical].mean() if len(critical) else 0
    return bool(both.all()) and at_critical > 0.5, \
        (f"both above {percent(floor)} of the part's largest at {both.sum()} of {len(both)} speeds; EO 6 above EO 4 at {percent(above[two.even].mean())} "
         f"of the even ones, at {above[critical].sum()} of {len(critical)} critical ones")


@check(71, "two lobes: the leading edge touches at about four places at most speeds", WHEEL)
def _(c):
    two = c.lobed(2)
    places = two.contact_map("leading")[1][two.even]
    counts = {int(k): int((places == k).sum()) for k in numpy.unique(places)}
    return (abs(places - 4) <= 1).mean() > 0.5, f"places: speeds {counts}"


def extra_places(case):
    _, places, _ = case.contact_map("trailing")
    return places, places > case.lobes


@check(72, "two lobes: the trailing edge touches at two places at most speeds, and at more in bands at the peaks")
def _(c):
    two = c.lobed(2)
    places, extra = extra_places(two)
    critical = numpy.array([float(row["speed [rpm]"]) for row in two.critical])
    near = numpy.array([abs(critical / rpm - 1).min() < 0.02 if len(critical) else False for rpm in two.rpm])
    inside, outside = extra[near].mean(), extra[~near].mean()  # more speeds near a critical one do no harm here
    even = [percent(extra[which & two.even].mean()) for which in (near, ~near)]
    places = places[two.even]
    return (places == 2).mean() > 0.5 and inside > outside, \
        (f"two places at {percent((places == 2).mean())} of the even speeds, median {numpy.median(places):.0f}; more than two at {percent(inside)} "
         f"of the speeds within 2 % of a critical one and at {percent(outside)} of the others (even speeds alone: {even[0]} and {even[1]})")


@check(73, "two lobes: in these bands EO 6 meets families above the first")
def _(c):
    two = c.lobed(2)
    _, extra = extra_places(two)
    highest = {share: table[:, 0].max() for share, table in c.model.families.items()}
    first = numpy.interp(two.rpm * numpy.pi / 30 / c.model.speed_max, sorted(highest), [highest[k] for k in sorted(highest)])
    above = (6 * two.rpm / 60 > 1.05 * first)[extra & two.even]
    return bool(above.size and above.mean() > 0.5), f"6 Omega lies above the first family at {percent(above.mean() if above.size else 0)} of the {above.size} speeds with extra places"


def touched_alone(case):
    """The numbers of speeds at which only the leading and only the trailing edge touches."""
    touches = numpy.array([at.count.sum(axis=(0, 2)) > 0 for at in case.speeds])[:, [0, -1]]
    return (touches & ~touches[:, ::-1]).sum(axis=0)


@check(74, "two lobes: the trailing edge, with the smaller clearance, touches first: where only one edge touches, it is this one")
def _(c):
    text = "; ".join(f"{case.name}: only the leading edge at {leading} speeds, only the trailing edge at {trailing} of {len(case.speeds)}"
                     for case in c.cases for leading, trailing in [touched_alone(case)])
    leading, trailing = touched_alone(c.lobed(2))
    if leading + trailing == 0:
        raise CannotBeMade(text)
    return leading == 0, text


@check(75, "the leading edge's contact drifts linearly with speed; the slope is compared with chord over wave speed")
def _(c):
    two = c.lobed(2)
    middle, _, lag = two.report("contact_drift.csv")  # the middle of an edge's contact turns over at resonances; the edges' lag doesn't
    if math.isnan(float(lag["median lag [s]"])):
        raise CannotBeMade("both edges touch at fewer than three speeds")
    stiffness, density = (float(re.search(rf"^{key} = (\S+)", c.wheel.written, flags=re.M).group(1)) for key in ("young_modulus", "density"))
    chord = float(lag["tip length [m]"]) / (stiffness / density) ** 0.5  # the fastest wave along a bar of this material
    r2, *times = (float(lag[key]) for key in ("R^2", "slope [s]", "median lag [s]", "lower quartile [s]", "upper quartile [s]"))
    slope, median, low, high = (1e6 * time for time in times)
    return r2 > 0.9, (f"the leading edge's force after the trailing edge's: R^2 {r2:.3f}, slope {slope:.1f} us, median {median:.1f} us "
                      f"(quartiles {low:.1f}, {high:.1f}); tip length over the bar's wave speed {1e6 * chord:.1f} us; "
                      f"the middle of the leading edge's contact: R^2 {float(middle['R^2']):.3f}")


# --- three lobes -------------------------------------------------------------------------------------------------------------

@check(76, "three lobes: EO 3 has most of its power on nodal diameter 3, EO 6 on 4, EO 9 on 1")
def _(c):
    three = c.lobed(3)
    even, settled = (three.by_diameter()[rows] ** 2 for rows in (three.even, three.steady))
    shares = {order: (int(even[:, order].sum(axis=0).argmax()), even[:, order].sum(axis=0).max() / even[:, order].sum()) for order in (3, 6, 9)}
    steady = {order: settled[:, order].sum(axis=0).max() / settled[:, order].sum() for order in (3, 6, 9)}
    return [shares[k][0] for k in (3, 6, 9)] == [3, 4, 1], \
        "; ".join(f"EO {k}: nodal diameter {n}, {percent(share)} (periodic speeds {percent(steady[k])})" for k, (n, share) in shares.items())


@check(77, "three lobes: peaks on EO 3, EO 6 and EO 9 are large (each above a quarter of the largest)")
def _(c):
    three = c.lobed(3)
    top = {order: three.by_diameter()[:, order].sum(axis=1).max() for order in (3, 6, 9)}
    largest = three.by_diameter()[:, 1:].sum(axis=2).max()
    return min(top.values()) > 0.25 * largest, ", ".join(f"EO {k}: {1e3 * value:.4f} mm" for k, value in top.items()) + f"; largest of all {1e3 * largest:.4f} mm"


@check(78, "three lobes: contrast is higher at the trailing edge")
def _(c):
    three = c.lobed(3)
    edges = {edge: numpy.median(three.contact_map(edge)[0][three.even]) for edge in ("leading", "trailing")}
    return edges["trailing"] > edges["leading"], ", ".join(f"{edge} {value:.3f}" for edge, value in edges.items()) + " (medians)"


@check(79, "the contact pattern of an edge changes abruptly between neighbouring speeds; sweeps up and down are compared there")
def _(c):
    case = c.lobed(3)
    words, outlier, where = [], False, set()
    for edge in ("leading", "trailing"):
        shares = case.contact_map(edge)[2][case.even]  # neighbours equally far apart
        distance = abs(numpy.diff(shares, axis=0)).sum(axis=1) / numpy.maximum(shares[1:].sum(axis=1) + shares[:-1].sum(axis=1), 1e-300)
        middle = numpy.median(distance)
        spread = 1.4826 * numpy.median(abs(distance - middle))
        worst = int(distance.argmax())
        outlier = outlier or distance[worst] > middle + 5 * spread
        low, high = case.rpm[case.even][worst:worst + 2]
        where |= {round(rpm) for rpm in case.rpm if low <= rpm <= high}
        words.append(f"{edge} edge: largest distance {distance[worst]:.2f} between {low:.0f} and {high:.0f} rpm, "
                     f"median {middle:.2f}, scaled median deviation {spread:.2f}")
    try:
        differ = case.report("sweeps.csv")
    except CannotBeMade as missing:
        raise CannotBeMade(f"{'; '.join(words)}; no sweep to classify it ({missing})") from None
    apart = [round(float(row["speed [rpm]"])) for row in differ if row["differ"] == "yes"]
    there = sorted(where & set(apart))
    return bool(outlier), "; ".join(words) + f"; sweeps differ at {len(apart)} of {len(differ)} speeds, of these at {there}"


# --- claims ------------------------------------------------------------------------------------------------------------------

@check(80, "eq. 2 misses most critical speeds; each peak has a family, a nodal diameter and an engine order")
def _(c):
    words, good = [], True
    for case in c.cases:
        ((misses, _), (aliased, _)), count = rule_scores(case)
        labelled = all(row["family"] and row["nodal diameter"] and row["engine order"] for row in case.critical)
        good = good and labelled and count > 0 and misses > 0.5 * count
        words.append(f"{case.name}: eq. 2 misses {misses} of {count}, with aliasing {aliased}")
    return good, "; ".join(words)


@check(81, "subharmonics (energy off the multiples of N_l Omega) are below 1 % at the median speed; speeds above are flagged")
def _(c):
    words, good = [], True
    for case in c.cases:
        off = case.attribute("off_beat_energy")
        flags = [row["motion"] for row in case.report("speeds.csv") if row["motion"]]
        flagged = all(flag != "periodic" for flag, share in zip(flags, off) if share > 0.01)
        good = good and numpy.median(off[case.even]) < 0.01 and flagged
        words.append(f"{case.name}: median {percent(numpy.median(off[case.even]))}, above 1 % at {(off > 0.01).sum()} of {len(off)} speeds, all flagged: {flagged}")
    return good, "; ".join(words)
