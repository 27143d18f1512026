# SPDX-License-Identifier: GPL-3.0-or-later
"""The 81 checks, in the paper's order. Each returns (holds, what was measured), or raises CannotBeMade.

Thresholds are named where they are used. WHEEL marks checks whose outcome depends on the paper's confidential wheel: a
public one may fail them and still reproduce the paper.
"""
import os
import re
import subprocess

import h5py
import numpy

from scene import CannotBeMade, signed

CHECKS = []
WHEEL = "wheel"


def check(number, text, depends=""):
    def register(function):
        CHECKS.append((number, text, depends, function))
        return function
    return register


def percent(share):
    return f"{100 * share:.3g} %"


def by_test(number, text, *filters):
    """A check that the project's own tests make."""
    check(number, text)(lambda c: c.tests.run(*filters))


# --- 3.1 model ---------------------------------------------------------------------------------------------------------------

def turned(place, angle):
    x, y, z = place.T
    return numpy.stack([numpy.cos(angle) * x - numpy.sin(angle) * y, numpy.sin(angle) * x + numpy.cos(angle) * y, z], axis=1)


@check(1, "ten sectors close the circle; cut faces match node by node to 1e-9 of the radius")
def _(c):
    mesh, sectors = c.mesh, c.model.sectors
    low, high = mesh.place[mesh.nodes("cyclic_low")], mesh.place[mesh.nodes("cyclic_high")]
    moved = turned(low, 2 * numpy.pi / sectors)
    radius = numpy.hypot(*mesh.place[:, :2].T).max()
    worst = max(numpy.linalg.norm(high - node, axis=1).min() for node in moved) / radius
    return len(low) == len(high) and sectors == 10 and worst < 1e-9, f"{sectors} sectors, {len(low)} pairs, worst {worst:.1e} R"


@check(2, "one main and one splitter blade; contact nodes on the main blade's tip only")
def _(c):
    contact, main = c.mesh.nodes("contact"), c.mesh.nodes("main_blade")
    splitter = c.mesh.nodes("splitter")
    on_main, on_splitter = numpy.isin(contact, main).all(), numpy.isin(contact, splitter).any()
    return bool(on_main and not on_splitter), f"{len(contact)} nodes on the tip line, all on the main blade, none on the splitter"


@check(3, "ten contact nodes, leading to trailing edge, on a meridional curve that turns by about 90 degrees")
def _(c):
    r, _, z = c.model.position.T
    ways = numpy.degrees(numpy.unwrap(numpy.arctan2(numpy.diff(r), numpy.diff(z))))
    turn = abs(ways[-1] - ways[0])
    ordered = bool((numpy.diff(c.model.arc_length) > 0).all())
    return len(r) == 10 and ordered and 75 <= turn <= 100, f"{len(r)} nodes, chords of the curve turn by {turn:.1f} degrees"


@check(4, "contact normals turn from radial at the leading edge to mostly axial at the trailing edge")
def _(c):
    radial, _, axial = abs(c.model.normal.T)
    angles = numpy.degrees(numpy.arctan2(axial, radial))
    return angles[0] < 30 and angles[-1] > 60, f"{angles[0]:.1f} and {angles[-1]:.1f} degrees from radial"


@check(5, "at least 2 elements through the blade, 3 along its root, 3 through the disc")
def _(c):
    said = c.run_program("tiprub-mesh", os.path.join(c.wheel, "case.toml"), "--check", "-v")
    chord, disc, blade = (int(re.search(rf"(\d+) (?:elements )?{words}", said).group(1))
                          for words in ("along the chord", "through the disc", "through the blade"))
    return blade >= 2 and chord >= 3 and disc >= 3, f"{blade} through the blade, {chord} along its root, {disc} through the disc"


@check(6, "quadratic bricks, about 120,000 dofs a sector, about a million in the ring", WHEEL)
def _(c):
    dofs = 3 * len(c.mesh.place)
    bricks = c.mesh.types <= {12, 17}
    return bricks and 60e3 <= dofs <= 240e3, f"20-node bricks: {c.mesh.types == {17}}, {dofs} dofs a sector, {dofs * c.model.sectors / 1e6:.2f} million"


@check(7, "the nodes of the bore, and only those, are clamped; conflicts with cut faces counted")
def _(c):
    clamped, radius = c.mesh.nodes("clamped"), numpy.hypot(*c.mesh.place[:, :2].T)
    bore = radius[clamped].mean()
    on_bore = numpy.flatnonzero(abs(radius - bore) < 1e-9 * radius.max())
    both = numpy.isin(clamped, numpy.union1d(c.mesh.nodes("cyclic_low"), c.mesh.nodes("cyclic_high"))).sum()
    return numpy.array_equal(clamped, on_bore), f"{len(clamped)} nodes at r = {1e3 * bore:.2f} mm, {both} of them on cut faces"


@check(8, "internal, boundary and cyclic nodes sum to the sector")
def _(c):
    held, low, high = (c.mesh.nodes(name) for name in ("clamped", "cyclic_low", "cyclic_high"))
    contact = [int(numpy.linalg.norm(numpy.stack([numpy.hypot(*c.mesh.place[:, :2].T) - r, c.mesh.place[:, 2] - z], axis=1)
                                     + 1e3 * ~numpy.isin(numpy.arange(len(c.mesh.place)), c.mesh.nodes("contact"))[:, None],
                                     axis=1).argmin()) for r, _, z in c.model.position]
    cut = numpy.setdiff1d(numpy.union1d(low, high), held)
    boundary = numpy.unique(contact)
    outside = numpy.union1d(numpy.union1d(held, cut), boundary)
    internal = len(c.mesh.place) - len(outside)
    good, text = c.tests.run(("reduce_test", "SectorDofs.*"))
    whole = len(boundary) == len(contact) and not numpy.isin(boundary, cut).any() and not numpy.isin(boundary, held).any()
    return good and whole, (f"{internal} internal + {len(boundary)} boundary + {len(cut)} cyclic + {len(held)} clamped = "
                            f"{len(c.mesh.place)} nodes; {text}")


@check(9, "figures: the wheel, the sector with clamp, contact and cut faces")
def _(c):
    return c.figures_exist(c.any_case, "wheel", "sector")


# --- 3.2 linear criterion ----------------------------------------------------------------------------------------------------

by_test(10, "every root of f = n Omega, and of f = |n Omega - f_c|",
        ("postprocess-test", "LinearCriterion.*"))


@check(11, "combinations that the rule excludes are listed as excluded")
def _(c):
    rows = c.any_case.report("linear_criterion.csv")
    forward = [row for row in rows if row["wave"] == "forward"]
    excluded = sum(row["eq. 2"].startswith("excluded") for row in forward)
    return bool(forward) and excluded == len(forward), f"{len(forward)} forward waves listed, {excluded} of them as excluded by eq. 2"


def rule_scores(case):
    """(misses, false alarms) of eq. 2 and of the rule with aliasing, and the number of critical speeds."""
    crossings = case.report("linear_criterion.csv")
    scores = []
    for foretold, listed in (("foretold by eq. 2", "eq. 2"), ("foretold with aliasing", "with aliasing")):
        misses = sum(row[foretold] == "no" for row in case.critical)
        alarms = sum(row[listed] == "listed" and row["nodal diameter can move"] == "yes" and row["critical speed found"] == "no"
                     for row in crossings)
        scores.append((misses, alarms))
    return scores, len(case.critical)


@check(12, "the rule's list stands beside the nonlinear one; misses and false alarms counted")
def _(c):
    words = []
    for case in c.cases:
        ((miss, alarm), (aliased_miss, aliased_alarm)), count = rule_scores(case)
        words.append(f"{case.name}: of {count} critical speeds eq. 2 misses {miss} (false alarms {alarm}), "
                     f"with aliasing {aliased_miss} ({aliased_alarm})")
    return True, "; ".join(words)


# --- 3.3 cyclic symmetry -----------------------------------------------------------------------------------------------------

by_test(13, "the assembled ring is block-circulant, neighbours only, to 1e-10", ("reduce_test", "Sectors/Wheel.MatricesAreBlockCirculant*"))
by_test(14, "the Fourier transform block-diagonalises it to 1e-10", ("reduce_test", "Sectors/Wheel.FourierTransformLeavesTheSectorsOwnBlocks*"),
        ("reduce_test", "Sectors/EverySectorCount.WavesExpandAndGather*"))


@check(15, "six blocks, of real size n for 0 and 5, 2n else; in all 10 n")
def _(c):
    sizes = [c.model.times(n) * len(m["M"]) for n, m in enumerate(c.model.matrices)]
    one = len(c.model.matrices[0]["M"])
    standing = max(numpy.abs(c.model.matrices[n]["K0"].imag).max() for n in (0, len(sizes) - 1))
    return len(sizes) == 6 and sum(sizes) == c.model.sectors * one and standing == 0, f"sizes {sizes}, together {sum(sizes)} = 10 x {one}"


by_test(16, "the blocks of eq. 6 equal the transformed ring for each nodal diameter, and are symmetric",
        ("reduce_test", "Sectors/Wheel.FourierTransformLeavesTheSectorsOwnBlocks*"), ("reduce_test", "NodalDiameter/CraigBampton.ProjectionsAreHermitian*"))
by_test(17, "the blocks' eigenvalues are the ring's, with their multiplicity", ("reduce_test", "Sectors/Wheel.EigenvaluesAreTheUnion*"))


@check(18, "each family has ten members, 1 + 2x4 + 1")
def _(c):
    model = c.model
    size = len(model.matrices[0]["M"])
    factor = numpy.linalg.inv(numpy.linalg.cholesky(model.ring("M")))
    ring = numpy.sqrt(numpy.linalg.eigvalsh(factor @ model.ring("K0") @ factor.T)) / (2 * numpy.pi)
    union = numpy.sort(numpy.concatenate([numpy.repeat(model.frequencies(n, 0), model.times(n)) for n in range(len(model.matrices))]))
    worst = abs(ring / union - 1).max()
    members = sum(model.times(n) for n in range(len(model.matrices)))
    return members == 10 and len(ring) == 10 * size and worst < 1e-8, \
        f"{members} members; the {len(ring)} frequencies of the assembled reduced ring are those of the blocks, single and double, to {worst:.1e}"


@check(19, "the first five families over the nodal diameter, drawn at rest")
def _(c):
    rows = c.any_case.figure("interference")
    families = [key for key in rows[0] if key.startswith("family")]
    at_rest = [row for row in rows if float(row["speed [rpm]"]) == 0]
    return len(families) >= 5 and len(at_rest) == 6, f"{len(families)} families, {len(at_rest)} nodal diameters"


def energy_shares(c):
    """Nodal diameters x families of each part's share of the strain energy at rest, of the unreduced sector."""
    path = os.path.join(c.work, "modes.h5")
    if not os.path.exists(path):
        with open(os.path.join(c.wheel, "case.toml"), encoding="utf-8") as file:
            text = re.sub(r"^verification_speeds = .*\n", "", file.read(), flags=re.M)
        case = os.path.join(c.work, "case.toml")
        with open(case, "w", encoding="utf-8") as file:
            file.write(re.sub(r"^\[reduce\]", "[reduce]\nverification_speeds = [0.0]", text, flags=re.M))
        c.run_program("tiprub-reduce", case, os.path.join(c.wheel, "sector.msh"), "--modes", path)
    with h5py.File(path) as file:
        groups = [file[f"nodal_diameter/{n}/energy_share"] for n in range(len(file["nodal_diameter"]))]
        return {part: numpy.array([group[part][0] for group in groups]) for part in groups[0]}


@check(20, "the first family bends the main blade, with little motion of the splitter", WHEEL)
def _(c):
    shares = energy_shares(c)
    return shares["main_blade"][:, 0].min() > 0.8 and shares["splitter"][:, 0].max() < 0.1, \
        "strain energy at rest: " + ", ".join(f"{part} {percent(value[:, 0].min())} to {percent(value[:, 0].max())}" for part, value in shares.items())


@check(21, "a higher family moves the disc near the trailing edge", WHEEL)
def _(c):
    disc = energy_shares(c)["disc"]
    n, family = numpy.unravel_index(disc[:, 1:].argmax(), disc[:, 1:].shape)
    return disc[n, family + 1] > 0.1, \
        f"of {disc.shape[1]} families the most has {family + 2}, on nodal diameter {n}: {percent(disc[n, family + 1])} of its strain energy in the disc"


# --- 3.4 reduction -----------------------------------------------------------------------------------------------------------

by_test(22, "eq. 7 gives back its three matrices to 1e-12", ("reduce_test", "SpeedPolynomial.*"))


@check(23, "at a speed that the basis never saw, frequencies within 0.1 % (first 50; model against unreduced sector)")
def _(c):
    errors = c.model.reduction_error(50)
    unseen = {share: error for share, error in errors.items() if share not in (0.0, 0.25, 0.5, 0.75, 1.0)}
    first = c.model.reduction_error(20)
    if not unseen:
        raise CannotBeMade("no unseen speed was verified")
    return max(unseen.values()) < 1e-3, "; ".join(f"{share} of full speed: {percent(error)} (first two families' 20: {percent(first[share])})"
                                                for share, error in unseen.items())


by_test(24, "static modes at rest unchanged, the rest orthonormal; rank and drops counted", ("reduce_test", "NodalDiameter/CraigBampton.*"))
by_test(25, "reduced matrices symmetric, mass positive, contact dofs physical",
        ("reduce_test", "NodalDiameter/CraigBampton.KeepsContactDofsPhysical*:NodalDiameter/CraigBampton.ProjectionsAreHermitian*"))


@check(26, "back in sectors, the reduced ring is block-circulant")
def _(c):
    ring, size = c.model.ring("K0"), len(c.model.matrices[0]["M"])
    rolled = numpy.roll(numpy.roll(ring, size, axis=0), size, axis=1)
    symmetric, circulant = abs(ring - ring.T).max() / abs(ring).max(), abs(ring - rolled).max() / abs(ring).max()
    return symmetric < 1e-12 and circulant < 1e-12, f"from itself turned by a sector {circulant:.1e}, from its transpose {symmetric:.1e}"


@check(27, "300 physical and 600 generalized dofs, 0.09 % of the full model")
def _(c):
    physical = 3 * len(c.model.arc_length) * c.model.sectors
    size = len(c.model.matrices[0]["M"]) * c.model.sectors
    generalized = (c.model.modes_at_speed or size // c.model.sectors) * c.model.sectors
    full = 3 * len(c.mesh.place) * c.model.sectors
    return physical == 300 and generalized == 600, \
        f"{physical} + {generalized} at any one speed, {percent((physical + generalized) / full)} of {full} (the file holds {size})"


@check(28, "first 50 frequencies at rest within 1 % of the unreduced model")
def _(c):
    error = c.model.reduction_error(50)[0.0]
    return error < 0.01, percent(error)


@check(29, "the same at every speed, also at those the basis never saw")
def _(c):
    errors = c.model.reduction_error(50)
    return max(errors.values()) < 0.01, ", ".join(f"{percent(error)} at {share}" for share, error in errors.items()) + " of full speed"


def convergence(c, over):
    rows = [row for row in c.convergence if row["over"] == over]
    return {rpm: [(int(row["value"]), float(row["difference [1]"])) for row in rows if row["speed [rpm]"] == rpm]
            for rpm in dict.fromkeys(row["speed [rpm]"] for row in rows)}


@check(30, "tip motion converges with the number of modes: from eta = 150 on within 5 % of the finest, and ever nearer")
def _(c):
    words, good = [], True
    for rpm, points in convergence(c, "eta").items():
        differences = [value for _, value in points[:-1]]
        beyond = max(value for count, value in points if count >= 150)
        falling = all(later < earlier for earlier, later in zip(differences, differences[1:]))
        good = good and beyond < 0.05 and falling
        words.append(f"{rpm} rpm: " + ", ".join(f"{count}: {percent(value)}" for count, value in points[:-1]))
    return good, "; ".join(words) + f" from all modes, eta = {points[-1][0]}; 150 is 600 component modes of the wheel"


@check(31, "halving the step changes the settled motion by less than 1 %")
def _(c):
    halved = [(at.rpm, at.attributes["halving_difference"], at.attributes["halving_measure"].decode())
              for case in c.cases for at in case.speeds if numpy.isfinite(at.attributes.get("halving_difference", numpy.nan))]
    if not halved:
        raise CannotBeMade("no speed was computed with half the step")
    worst = max(difference for _, difference, _ in halved)
    return worst < 0.01, f"{len(halved)} speeds, at most {percent(worst)}"


@check(32, "a sweep computes with the reduced matrices only")
def _(c):
    path = os.path.join(c.tests.build, "bin", "tiprub-simulate")
    if not os.path.exists(path):
        raise CannotBeMade(f"{path} is not built")
    libraries = subprocess.run(["ldd", path], stdout=subprocess.PIPE, text=True, check=True).stdout
    found = [name for name in ("deal_II", "trilinos", "gmsh", "cholmod") if name.lower() in libraries.lower()]
    return not found, "tiprub-simulate links no finite elements, mesher or sparse solver" if not found else f"links {found}"


@check(33, "Campbell diagram: frequencies rise with speed; the first family is narrow against the second", WHEEL)
def _(c):
    c.any_case.figure("campbell")
    rest, full = c.model.families[0.0][:, :2], c.model.families[1.0][:, :2]
    spread = (rest.max(axis=0) - rest.min(axis=0)) / rest.mean(axis=0)
    return bool((full > rest).all() and spread[0] < spread[1]), \
        (f"family 1 {rest[:, 0].mean():.0f} to {full[:, 0].mean():.0f} Hz, 2 {rest[:, 1].mean():.0f} to {full[:, 1].mean():.0f} Hz "
         f"(ratio at rest {rest[:, 1].mean() / rest[:, 0].mean():.2f}); spread at rest {percent(spread[0])} and {percent(spread[1])}")


# --- 3.5 contact algorithm ---------------------------------------------------------------------------------------------------

by_test(34, "the predictor is eq. 13; order two", ("simulate_test", "CentralDifferences.AreThePapersEquation13:Schemes.AreOfOrderTwo:TimeMarch.DecaysFreely*"))


@check(35, "after each step active gaps are zero, and no inactive node is in the casing")
def _(c):
    left = sum(case.attribute("leftover_steps").sum() for case in c.cases)
    deepest = max(case.attribute("largest_penetration").max() for case in c.cases)
    scale = max(case.amplitude.max() for case in c.cases)
    return left == 0 and deepest < 1e-9 * scale, f"{left:.0f} steps leave a node in the casing; deepest {deepest:.1e} m"


@check(36, "the casing never pulls")
def _(c):
    least = min(min(case.attribute("smallest_multiplier").min(), min(at.smallest_force for at in case.speeds)) for case in c.cases)
    return least >= 0, f"smallest multiplier {least:.3g} N over {sum(len(case.speeds) for case in c.cases)} speeds"


@check(37, "without friction the force is along the normal")
def _(c):
    lengths = numpy.linalg.norm(c.model.normal, axis=1)
    return abs(lengths - 1).max() < 1e-12, f"the march knows one multiplier a node, along a normal of length 1 within {abs(lengths - 1).max():.0e}"


@check(38, "the contact operator is symmetric, positive definite; its condition number")
def _(c):
    condition = numpy.concatenate([case.attribute("compliance_condition") for case in c.cases])
    good, text = c.tests.run(("simulate_test", "Complementarity.*"))
    return good and bool(numpy.isfinite(condition).all() and (condition >= 1).all()), f"condition {condition.min():.3g} to {condition.max():.3g}; {text}"


@check(39, "work of contact, dissipation and change of energy balance to 1e-9")
def _(c):
    worst = max(abs(case.attribute("energy_closing_error")).max() for case in c.cases)
    return worst < 1e-9, f"closes to {worst:.1e} at every speed"


by_test(40, "the limit of the step is printed, and a run beyond it refused",
        ("stability_test", "CentralDifferencesLimit.*"))
by_test(41, "without contact the response is the linear one", ("simulate_test", "TimeMarch.MovesNothingWithoutContact:TimeMarch.DecaysFreely*"))


# --- 3.6 aliasing ------------------------------------------------------------------------------------------------------------

@check(42, "the contact force's fundamental frequency is N_l Omega (median over the periodic speeds, 99 % of its variance)")
def _(c):
    words, good = [], True
    for case in c.cases:
        shares = []
        for at in (case.speeds[i] for i in numpy.flatnonzero(case.periodic)):
            power = sum(waves[1:].__pow__(2).sum(axis=1) for waves in at.force_waves)
            orders = numpy.arange(1, len(power) + 1)
            if power.sum() > 0:
                shares.append(power[orders % case.lobes == 0].sum() / power.sum())
        good = good and numpy.median(shares) > 0.99
        words.append(f"{case.name}: on multiples of {case.lobes}, median {percent(numpy.median(shares))}, least {percent(min(shares))} of {len(shares)} speeds")
    return good, "; ".join(words)


@check(43, "on ten blades cos 6 theta is cos 4 theta, cos 8 theta is cos 2 theta")
def _(c):
    theta = 2 * numpy.pi * numpy.arange(10) / 10
    worst = max(abs(numpy.cos(a * theta) - numpy.cos(b * theta)).max() for a, b in ((6, 4), (8, 2)))
    return worst < 1e-13, f"largest difference {worst:.1e}"


@check(44, "engine order to nodal diameter is the zig-zag of ten sectors")
def _(c):
    got = [abs(signed(k, 10)) for k in range(31)]
    good, text = c.tests.run(("postprocess-test", "Aliasing.*"))
    return good and got == [0, 1, 2, 3, 4, 5, 4, 3, 2, 1] * 3 + [0], text


@check(45, "two lobes: 2, 4, 6, 8, 10, 12 on 2, 4, 4, 2, 0, 2; 1, 3, 5 empty")
def _(c):
    got = [abs(signed(k, 10)) for k in range(2, 62, 2)]
    return got[:6] == [2, 4, 4, 2, 0, 2] and not set(got) & {1, 3, 5}, str(got[:6])


@check(46, "three lobes: 3, 6, ... 30 on 3, 4, 1, 2, 5, 2, 1, 4, 3, 0")
def _(c):
    got = [abs(signed(k, 10)) for k in range(3, 33, 3)]
    return got == [3, 4, 1, 2, 5, 2, 1, 4, 3, 0], str(got)


@check(47, "eq. 17: the smallest k for each nodal diameter and number of lobes")
def _(c):
    got = {lobes: [c.aliasing.smallest_multiple(n, lobes) for n in range(6)] for lobes in (2, 3)}
    brute = {lobes: [next((k for k in range(1, 200) if any(a * 10 + s * n == k * lobes for a in range(200) for s in (1, -1))), None)
                     for n in range(6)] for lobes in (2, 3)}
    return got == brute, "; ".join(f"{lobes} lobes: k = {values}" for lobes, values in got.items())


@check(48, "table 1, by closed form and by marching ten oscillators; other coefficients zero to 1e-10")
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
        residuals = numpy.array([at.shift_residual for at in case.speeds])[case.periodic]
        words.append(f"{case.name}: median {numpy.median(residuals):.1e}, below 1 % at {(residuals < 0.01).sum()} of {len(residuals)} periodic speeds")
    here = two.speeds[two.example].shift_residual
    return here < 0.01, f"{here:.1e} of the motion at {two.rpm[two.example]:.0f} rpm; " + "; ".join(words)


@check(50, "two lobes: odd nodal diameters hold less than 1 %")
def _(c):
    two = c.lobed(2)
    power = two.waves[:, 1:] ** 2
    share = power[:, :, 1::2].sum() / power.sum()
    breaking = sum(at.attributes["symmetry"].decode() == "breaking" for at in two.speeds)
    return share < 0.01, (f"{percent(share)} over all speeds (nodal diameters that move: {[int(n) for n in two.moving]}); "
                          f"at {breaking} of {len(two.speeds)} speeds a disturbance of the odd ones would grow")


by_test(51, "two signals, close in frequency, on two nodal diameters: one peak over time, two in the two-way spectrum",
        ("postprocess-test", "TravellingSpectrum.SeparatesCloseFrequencies*"))


@check(52, "leading-edge force: never negative, periodic, peaks at multiples of N_l Omega only (99 %)")
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


@check(53, "force of all leading edges: even nodal diameters only")
def _(c):
    two = c.lobed(2)
    power = two.speeds[two.example].force_waves[0] ** 2
    share = power[:, 1::2].sum() / power.sum()
    return share < 0.01, f"odd ones hold {percent(share)} at {two.rpm[two.example]:.0f} rpm"


@check(54, "direction: orders 1-4 backward, 6-9 forward, 0 and 5 standing; EO 4 and EO 6 on nodal diameter 4 run apart")
def _(c):
    good, text = c.tests.run(("postprocess-test", "Aliasing.DirectionOfTheEngineOrders:TravellingSpectrum.NamesTheDirection*"))
    index = [signed(p, 10) for p in (3, 6, 9, 12)]
    good = good and index == [3, -4, -1, 2]
    two = c.lobed(2)
    waves = two.waves[two.periodic]
    four, six = waves[:, 4, 4].sum() / waves[:, 4, [4, 6]].sum(), waves[:, 6, 6].sum() / waves[:, 6, [4, 6]].sum()
    return good and four > 0.99 and six > 0.99, (f"p = 3, 6, 9, 12 on {index}; periodic speeds of {two.name}: EO 4 {percent(four)} backward, "
                                               f"EO 6 {percent(six)} forward; {text}")


# --- 3.7 post-processing -----------------------------------------------------------------------------------------------------

@check(55, "evenly spaced speeds, each marched until steady by a criterion, transformed over whole revolutions")
def _(c):
    even = max(abs(numpy.diff(case.rpm, 2)).max() / numpy.diff(case.rpm).mean() for case in c.cases)
    whole = all(at.whole for case in c.cases for at in case.speeds)
    steady = {case.name: f"{int(case.periodic.sum())} periodic of {len(case.speeds)}, {case.failed} failed" for case in c.cases}
    return even < 1e-6 and whole, f"steps equal to {even:.0e}; {steady}"


@check(56, "waterfall and interaction map of the same data, engine orders and modal lines on them; crossings listed")
def _(c):
    case = c.any_case
    waterfall, total = case.figure("waterfall"), case.figure("interaction_map")
    here = {(row["speed [rpm]"], row["frequency [Hz]"]): row["total [mm]"] for row in total}
    shared = [(row["total [mm]"], here[key]) for row in waterfall if (key := (row["speed [rpm]"], row["frequency [Hz]"])) in here]
    same = all(a == b for a, b in shared)
    return same and len(shared) > 0 and bool(case.report("linear_criterion.csv")), f"{len(shared)} points in both, equal: {same}; {len(case.report('linear_criterion.csv'))} crossings"


@check(57, "contact map: 200 areas, a column a speed, both edges")
def _(c):
    shapes = [case.contact_map(edge)[2].shape for case in c.cases for edge in ("leading", "trailing")]
    return all(shape[1] == 200 for shape in shapes), f"speeds x areas: {shapes}"


@check(58, "the counters sum to the contact steps of their node")
def _(c):
    good, text = c.tests.run(("postprocess-test", "ContactMap.KeepsEveryCount"))
    nodes = kept = 0
    for case in c.cases:
        for at in case.speeds:
            sums = at.count.sum(axis=2)
            per_sample = int(at.attributes["steps_per_revolution"]) // at.samples
            nodes += sums.size
            kept += int(((sums >= at.pushed_samples) & (sums <= per_sample * at.pushed_samples)).sum())
    return good and kept == nodes, f"{kept} of {nodes} nodes lie between their samples under force and all of those samples' steps; {text}"


@check(59, "contrast tells repeating from irregular speeds; contrast and places printed for each")
def _(c):
    words, good = [], True
    for case in c.cases:
        contrast, places, _ = case.contact_map("trailing")
        irregular = numpy.array([at.motion == "irregular" for at in case.speeds])
        if not irregular.any():
            words.append(f"{case.name}: no irregular speed")
            continue
        one, other = numpy.median(contrast[case.periodic]), numpy.median(contrast[irregular])
        good = good and one > other
        words.append(f"{case.name}, trailing edge: median contrast {one:.3f} periodic, {other:.3f} irregular")
    return good, "; ".join(words)


@check(60, "trackings can be computed again from the stored motion")
def _(c):
    worst = 0.0
    for case in c.cases:
        diameters, orders = case.by_diameter(), case.figure("engine_order_tracking")
        for rows, pick in ((case.figure("nodal_diameter_tracking"), lambda f, k: (int(f.split()[1]), int(k.split()[1]))),
                           (orders, lambda f, k: (int(k.split()[1]), int(f.split()[2])))):
            index = {f"{rpm:.0f}": i for i, rpm in enumerate(case.rpm)}
            for row in rows:
                i = index[f"{float(row['speed [rpm]']):.0f}"]
                if row["curve"] == "mean":
                    continue
                order, n = pick(row["followed"], row["curve"])
                worst = max(worst, abs(1e-3 * float(row["amplitude [mm]"]) - diameters[i, order, n]))
    scale = max(case.waves[:, 1:].max() for case in c.cases)
    return worst < 1e-6 * scale, f"largest difference {worst / scale:.1e} of the largest amplitude"


@check(61, "bars at one speed: all nodal diameters at one engine order, all engine orders on one nodal diameter")
def _(c):
    return c.figures_exist(c.any_case, "harmonic_bars")


@check(62, "displacement and stress recovered on the wheel; half a turn leaves a two-lobe field as it is")
def _(c):
    two = c.lobed(2)
    with open(two.path("report", "report.html"), encoding="utf-8") as file:
        said = re.search(r"Turned by (\d+) of \d+ sectors, the displacement is itself within ([-+.e0-9]+) of its largest value, "
                         r"the stress within ([-+.e0-9]+?)\.\s", file.read())
    if said is None:
        raise CannotBeMade(f"{two.name} was post-processed without fields.h5")
    displacement, stress = float(said.group(2)), float(said.group(3))
    return displacement < 1e-6 and stress < 1e-6, f"turned by {said.group(1)} sectors: displacement {displacement:.1e}, stress {stress:.1e} of the largest"


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


@check(64, "the map is the sum of its six parts to 1e-12")
def _(c):
    good, text = c.tests.run(("postprocess-test", "InteractionMap.TotalIsTheSumOfItsParts"))
    worst = top = 0.0
    for row in c.any_case.figure("interaction_map"):
        total = float(row["total [mm]"])
        parts = sum(float(value) for key, value in row.items() if key.startswith("nodal diameter"))
        worst, top = max(worst, abs(total - parts)), max(top, total)
    return good and worst < 1e-8 * top, f"printed tables agree to {worst / top:.0e} (ten digits); {text}"


@check(65, "two lobes: the odd parts of the map are negligible at every speed")
def _(c):
    two = c.lobed(2)
    parts = two.by_diameter()[:, 1:].max(axis=1)
    ratio = (parts[:, 1::2].max(axis=1) / parts[:, 0::2].max(axis=1)).max()
    return ratio < 0.01, f"largest odd over largest even, worst speed: {ratio:.1e}"


@check(66, "two lobes: nodal diameters 2 and 4 carry most of the motion")
def _(c):
    two = c.lobed(2)
    power = (two.by_diameter()[:, 1:] ** 2).sum(axis=(0, 1))
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


@check(68, "two lobes: EO 2 shows nodal diameter 2, EO 4 shows 4, others small (95 % of the power)")
def _(c):
    two = c.lobed(2)
    power = (two.by_diameter() ** 2)
    shares = {order: power[:, order, n].sum() / power[:, order].sum() for order, n in ((2, 2), (4, 4))}
    steady = {order: power[two.periodic, order, n].sum() / power[two.periodic, order].sum() for order, n in ((2, 2), (4, 4))}
    return min(shares.values()) > 0.95, "; ".join(f"EO {k}: {percent(shares[k])} (periodic speeds {percent(steady[k])})" for k in shares)


@check(69, "two lobes: within EO 1-6 nodal diameter 2 answers EO 2 only (95 % of the power); EO 8 beside it")
def _(c):
    two = c.lobed(2)
    power = two.by_diameter()[:, :, 2] ** 2
    share, steady = (power[rows, 2].sum() / power[rows, 1:7].sum() for rows in (slice(None), two.periodic))
    eight = numpy.sqrt(power[:, 8].max() / power[:, 2].max())
    return share > 0.95, f"{percent(share)} of the power within 1-6 (periodic speeds {percent(steady)}); EO 8 reaches {percent(eight)} of EO 2's amplitude"


@check(70, "two lobes: nodal diameter 4 holds EO 4 and EO 6 at all speeds; EO 6 above EO 4 where speeds are critical")
def _(c):
    two = c.lobed(2)
    amplitude = two.by_diameter()[:, :, 4]
    floor = 0.01
    both = numpy.minimum(amplitude[:, 4], amplitude[:, 6]) > floor * amplitude[:, 1:].max(axis=1)
    above = amplitude[:, 6] > amplitude[:, 4]
    critical = numpy.array([numpy.argmin(abs(two.rpm - float(row["speed [rpm]"]))) for row in two.critical], dtype=int)
    at_critical = above[critical].mean() if len(critical) else 0
    return bool(both.all()) and at_critical > 0.5, \
        (f"both above {percent(floor)} of the part's largest at {both.sum()} of {len(both)} speeds; EO 6 above EO 4 at {percent(above.mean())} "
         f"of all speeds, at {above[critical].sum()} of {len(critical)} critical ones")


@check(71, "two lobes: about four places rubbed by the leading edge at most speeds", WHEEL)
def _(c):
    two = c.lobed(2)
    _, places, _ = two.contact_map("leading")
    counts = {int(k): int((places == k).sum()) for k in numpy.unique(places)}
    return (abs(places - 4) <= 1).mean() > 0.5, f"places: speeds {counts}"


def extra_places(case):
    _, places, _ = case.contact_map("trailing")
    return places, places > case.lobes


@check(72, "two lobes: two places rubbed by the trailing edge at most speeds; bands of more lie on amplitude peaks")
def _(c):
    two = c.lobed(2)
    places, extra = extra_places(two)
    critical = numpy.array([float(row["speed [rpm]"]) for row in two.critical])
    near = numpy.array([abs(critical / rpm - 1).min() < 0.02 if len(critical) else False for rpm in two.rpm])
    inside, outside = extra[near].mean(), extra[~near].mean()
    return (places == 2).mean() > 0.5 and inside > outside, \
        (f"two places at {percent((places == 2).mean())} of the speeds, median {numpy.median(places):.0f}; more than two at {percent(inside)} "
         f"of the speeds within 2 % of a critical one and at {percent(outside)} of the others")


@check(73, "two lobes: in bands of more places, EO 6 meets families above the first")
def _(c):
    two = c.lobed(2)
    _, extra = extra_places(two)
    highest = {share: table[:, 0].max() for share, table in c.model.families.items()}
    first = numpy.interp(two.rpm * numpy.pi / 30 / c.model.speed_max, sorted(highest), [highest[k] for k in sorted(highest)])
    above = (6 * two.rpm / 60 > 1.05 * first)[extra]
    return bool(above.size and above.mean() > 0.5), f"6 Omega lies above the first family at {percent(above.mean() if above.size else 0)} of the {above.size} speeds with extra places"


@check(74, "the tighter trailing edge touches first")
def _(c):
    words, good = [], True
    for case in c.cases:
        # Before the first contact nothing moves, so the gap alone tells when it comes: clearance - ramp(t) d(theta + Omega t).
        revolutions = numpy.arange(0, 3, 1 / 3600)
        x = revolutions / 3
        ramp = x ** 3 * (10 - 15 * x + 6 * x * x)  # the case's ramp of three revolutions
        place = 2 * numpy.pi * (revolutions[:, None] + numpy.arange(case.sectors) / case.sectors)
        inward = numpy.interp(place % (2 * numpy.pi), case.angle, case.distortion).max(axis=1)
        touch = [revolutions[(clearance - ramp * inward <= 0).argmax()] if (clearance - ramp * inward <= 0).any() else numpy.inf
                 for clearance in case.clearance]
        good = good and case.clearance[-1] < case.clearance[0] and int(numpy.argmin(touch)) == len(touch) - 1
        words.append(f"{case.name}: node {int(numpy.argmin(touch))} of {len(touch)} after {min(touch):.3f} revolutions, leading edge after {touch[0]:.3f}")
    return good, "; ".join(words)


@check(75, "the leading edge's contact drifts linearly with speed; the slope against chord over wave speed")
def _(c):
    two = c.lobed(2)
    drift = two.report("contact_drift.csv")[0]
    with open(os.path.join(c.wheel, "case.toml"), encoding="utf-8") as file:
        text = file.read()
    stiffness, density = (float(re.search(rf"^{key} = (\S+)", text, flags=re.M).group(1)) for key in ("young_modulus", "density"))
    chord = float(drift["tip length [m]"]) / (stiffness / density) ** 0.5  # the fastest wave along a bar of this material
    slope, r2 = float(drift["slope [s]"]), float(drift["R^2"])
    return r2 > 0.9, f"R^2 {r2:.3f}, slope {1e6 * slope:.1f} us; tip length over the bar's wave speed {1e6 * chord:.1f} us"


# --- three lobes -------------------------------------------------------------------------------------------------------------

@check(76, "three lobes: EO 3 on nodal diameter 3, EO 6 on 4, EO 9 on 1 (most of each order's power)")
def _(c):
    three = c.lobed(3)
    power = three.by_diameter() ** 2
    shares = {order: (int(power[:, order].sum(axis=0).argmax()), power[:, order].sum(axis=0).max() / power[:, order].sum()) for order in (3, 6, 9)}
    steady = {order: power[three.periodic, order].sum(axis=0).max() / power[three.periodic, order].sum() for order in (3, 6, 9)}
    return [shares[k][0] for k in (3, 6, 9)] == [3, 4, 1], \
        "; ".join(f"EO {k}: nodal diameter {n}, {percent(share)} (periodic speeds {percent(steady[k])})" for k, (n, share) in shares.items())


@check(77, "three lobes: large peaks on EO 3, EO 6 and EO 9 (each above a quarter of the largest)")
def _(c):
    three = c.lobed(3)
    top = {order: three.by_diameter()[:, order].sum(axis=1).max() for order in (3, 6, 9)}
    largest = three.by_diameter()[:, 1:].sum(axis=2).max()
    return min(top.values()) > 0.25 * largest, ", ".join(f"EO {k}: {1e3 * value:.4f} mm" for k, value in top.items()) + f"; largest of all {1e3 * largest:.4f} mm"


@check(78, "three lobes: contrast is higher at the trailing edge")
def _(c):
    three = c.lobed(3)
    edges = {edge: numpy.median(three.contact_map(edge)[0]) for edge in ("leading", "trailing")}
    return edges["trailing"] > edges["leading"], ", ".join(f"{edge} {value:.3f}" for edge, value in edges.items()) + " (medians)"


@check(79, "an abrupt change of contact pattern between neighbouring speeds; sweeps up and down there")
def _(c):
    case = c.lobed(3)
    _, _, shares = case.contact_map("trailing")
    distance = abs(numpy.diff(shares, axis=0)).sum(axis=1) / numpy.maximum(shares[1:].sum(axis=1) + shares[:-1].sum(axis=1), 1e-300)
    middle = numpy.median(distance)
    spread = 1.4826 * numpy.median(abs(distance - middle))
    worst = int(distance.argmax())
    words = f"largest distance {distance[worst]:.2f} between {case.rpm[worst]:.0f} and {case.rpm[worst + 1]:.0f} rpm, median {middle:.2f}, scaled median deviation {spread:.2f}"
    outlier = distance[worst] > middle + 5 * spread
    try:
        differ = case.report("sweeps.csv")
    except CannotBeMade as missing:
        raise CannotBeMade(f"{words}; no sweep to classify it ({missing})") from None
    apart = [row for row in differ if row["differ"] == "yes"]
    return bool(outlier), words + f"; sweeps differ at {len(apart)} of {len(differ)} speeds" + \
        (f", the first {float(apart[0]['speed [rpm]']):.0f} rpm" if apart else "")


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


@check(81, "subharmonics are negligible (1 % of the motion at the median speed); speeds above are flagged")
def _(c):
    words, good = [], True
    for case in c.cases:
        off = numpy.array([at.off_orders[0] for at in case.speeds])
        flags = [row["motion"] for row in case.report("speeds.csv") if row["motion"]]
        flagged = all(flag != "periodic" for flag, share in zip(flags, off) if share > 0.01)
        good = good and numpy.median(off) < 0.01 and flagged
        words.append(f"{case.name}: median {percent(numpy.median(off))}, above 1 % at {(off > 0.01).sum()} of {len(off)} speeds, all flagged: {flagged}")
    return good, "; ".join(words)
