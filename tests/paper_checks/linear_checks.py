# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks 1 to 33: the model, the linear criterion, cyclic symmetry, the reduction."""
import os
import re
import subprocess

import h5py
import numpy

from registry import WHEEL, CannotBeMade, by_test, check, percent
from scene import read_vtu


# --- 3.1 model ---------------------------------------------------------------------------------------------------------------

def turned(place, angle):
    x, y, z = place.T
    return numpy.stack([numpy.cos(angle) * x - numpy.sin(angle) * y, numpy.sin(angle) * x + numpy.cos(angle) * y, z], axis=1)


@check(1, "ten sectors form the wheel; the cut faces match node by node within 1e-9 of the radius")
def _(c):
    mesh, sectors = c.mesh, c.model.sectors
    low, high = mesh.place[mesh.nodes("cyclic_low")], mesh.place[mesh.nodes("cyclic_high")]
    moved = turned(low, 2 * numpy.pi / sectors)
    radius = numpy.hypot(*mesh.place[:, :2].T).max()
    worst = max(numpy.linalg.norm(high - node, axis=1).min() for node in moved) / radius
    return len(low) == len(high) and sectors == 10 and worst < 1e-9, f"{sectors} sectors, {len(low)} pairs, worst {worst:.1e} R"


@check(2, "a sector has one main and one splitter blade, and contact nodes on the main blade's tip only")
def _(c):
    contact, main = c.mesh.nodes("contact"), c.mesh.nodes("main_blade")
    splitter = c.mesh.nodes("splitter")
    on_main, on_splitter = numpy.isin(contact, main).all(), numpy.isin(contact, splitter).any()
    return bool(on_main and not on_splitter), f"{len(contact)} nodes on the tip line, all on the main blade, none on the splitter"


@check(3, "ten contact nodes lie from leading to trailing edge on a meridional curve that turns by about 90 degrees")
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


@check(5, "there are at least 2 elements through the blade, 3 along its root and 3 through the disc")
def _(c):
    said = c.run_program("tiprub-mesh", *c.wheel.arguments, "--check", "-v")
    chord, disc, blade = (int(re.search(rf"(\d+) (?:elements )?{words}", said).group(1))
                          for words in ("along the chord", "through the disc", "through the blade"))
    return blade >= 2 and chord >= 3 and disc >= 3, f"{blade} through the blade, {chord} along its root, {disc} through the disc"


@check(6, "quadratic bricks give about 120,000 dofs per sector and a million in the wheel", WHEEL)
def _(c):
    dofs = 3 * len(c.mesh.place)
    bricks = c.mesh.types <= {12, 17}
    return bricks and 60e3 <= dofs <= 240e3, f"20-node bricks: {c.mesh.types == {17}}, {dofs} dofs a sector, {dofs * c.model.sectors / 1e6:.2f} million"


@check(7, "the nodes of the bore and no others are clamped; conflicts with cut faces are counted")
def _(c):
    clamped, radius = c.mesh.nodes("clamped"), numpy.hypot(*c.mesh.place[:, :2].T)
    bore = radius[clamped].mean()
    on_bore = numpy.flatnonzero(abs(radius - bore) < 1e-9 * radius.max())
    both = numpy.isin(clamped, numpy.union1d(c.mesh.nodes("cyclic_low"), c.mesh.nodes("cyclic_high"))).sum()
    return numpy.array_equal(clamped, on_bore), f"{len(clamped)} nodes at r = {1e3 * bore:.2f} mm, {both} of them on cut faces"


@check(8, "internal, boundary and cyclic nodes sum to the sector's nodes")
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


@check(9, "figures show the wheel, and the sector with clamp, contact nodes and cut faces")
def _(c):
    path = c.any_case.path("report", "fields", "modes_sector.vtu")
    if not os.path.exists(path):
        raise CannotBeMade(f"{c.any_case.name} was post-processed without fields.h5")
    found = numpy.bincount(read_vtu(path)["node_set"].astype(int), minlength=5)
    section = c.figures_exist(c.any_case, "meridional_section")[1]
    return (found[1:] > 0).all(), f"clamped {found[1]}, contact {found[2]}, cut faces {found[3]} and {found[4]} nodes of their own; {section}"


# --- 3.2 linear criterion ----------------------------------------------------------------------------------------------------

by_test(10, "every root of f = n Omega and of f = |n Omega - f_c| is found",
        ("postprocess-test", "LinearCriterion.*"))


@check(11, "combinations that the rule excludes are listed as excluded")
def _(c):
    rows = c.any_case.report("linear_criterion.csv")
    forward = [row for row in rows if row["direction"] == "forward"]
    excluded = sum(row["eq. 2"].startswith("excluded") for row in forward)
    return bool(forward) and excluded == len(forward), f"{len(forward)} forward waves listed, {excluded} of them as excluded by eq. 2"


RULES = ("eq. 2", "with aliasing")


def predicted(row, rule):
    """Whether a rule's lines pass a critical speed, as the report's table says."""
    return next(value for key, value in row.items() if key.endswith(rule))


def found_by(rule, crossings):
    """Crossings that a rule lists, at which the march found a critical speed."""
    return [row for row in crossings if row[rule] == "listed" and row["critical speed found"] == "yes"]


def rule_scores(case):
    """(misses, false alarms) of eq. 2 and of the rule with aliasing, and the number of critical speeds."""
    crossings = case.report("linear_criterion.csv")
    scores = []
    for rule in RULES:
        misses = sum(predicted(row, rule) == "no" for row in case.critical)
        alarms = sum(row[rule] == "listed" and row["nodal diameter can move"] == "yes" and row["critical speed found"] == "no"
                     for row in crossings)
        scores.append((misses, alarms))
    return scores, len(case.critical)


@check(12, "the rule is compared with the nonlinear results; its misses and false alarms are counted")
def _(c):
    words, good = [], True
    for case in c.cases:
        ((miss, alarm), (aliased_miss, aliased_alarm)), count = rule_scores(case)
        crossings = case.report("linear_criterion.csv")
        # The two tables tell of the same meetings: neither has a hit if the other has none.
        agree = all((sum(predicted(row, rule) == "yes" for row in case.critical) > 0) == (len(found_by(rule, crossings)) > 0)
                    for rule in RULES)
        good = good and count > 0 and agree
        words.append(f"{case.name}: of {count} critical speeds eq. 2 misses {miss} (false alarms {alarm}), "
                     f"with aliasing {aliased_miss} ({aliased_alarm}); both tables agree: {agree}")
    return good, "; ".join(words)


# --- 3.3 cyclic symmetry -----------------------------------------------------------------------------------------------------

by_test(13, "the assembled wheel is block-circulant, and couples neighbours only, to 1e-10", ("reduce_test", "Sectors/Wheel.MatricesAreBlockCirculant*"))
by_test(14, "the Fourier transform block-diagonalises it to 1e-10", ("reduce_test", "Sectors/Wheel.FourierTransformLeavesTheSectorsOwnBlocks*"),
        ("reduce_test", "Sectors/EverySectorCount.WavesExpandAndGather*"))


@check(15, "six blocks have the real size n for nodal diameters 0 and 5 and 2n otherwise, 10 n in all (at any one speed)")
def _(c):
    # The file holds what several speeds need, more on some nodal diameters; each speed takes modes_at_speed of it.
    contact, held = 3 * len(c.model.arc_length), [len(m["M"]) for m in c.model.matrices]
    taken = [contact + min(size - contact, c.model.modes_at_speed or size) for size in held]
    sizes, one = [c.model.times(n) * size for n, size in enumerate(taken)], taken[0]
    standing = max(numpy.abs(c.model.matrices[n]["K0"].imag).max() for n in (0, len(sizes) - 1))
    return len(sizes) == 6 and sum(sizes) == c.model.sectors * one and standing == 0, f"sizes {sizes}, together {sum(sizes)} = 10 x {one}; the file holds {held}"


by_test(16, "the blocks of eq. 6 equal the transformed wheel at each nodal diameter, and are symmetric",
        ("reduce_test", "Sectors/Wheel.FourierTransformLeavesTheSectorsOwnBlocks*"), ("reduce_test", "NodalDiameter/CraigBampton.ProjectionsAreHermitian*"))
by_test(17, "the blocks have the wheel's eigenvalues, with their multiplicity", ("reduce_test", "Sectors/Wheel.EigenvaluesAreTheUnion*"))


@check(18, "each family has ten members, 1 + 2x4 + 1")
def _(c):
    model = c.model
    factor = numpy.linalg.inv(numpy.linalg.cholesky(model.ring("M")))
    ring = numpy.sqrt(numpy.linalg.eigvalsh(factor @ model.ring("K0") @ factor.T)) / (2 * numpy.pi)
    union = numpy.sort(numpy.concatenate([numpy.repeat(model.frequencies(n, 0), model.times(n)) for n in range(len(model.matrices))]))
    worst = abs(ring[:len(union)] / union - 1).max()  # beyond them, what pads the smaller nodal diameters
    members = sum(model.times(n) for n in range(len(model.matrices)))
    return members == 10 and len(ring) == 10 * model.size and worst < 1e-8, \
        f"{members} members; the {len(union)} frequencies of the assembled reduced ring are those of the blocks, single and double, to {worst:.1e}"


@check(19, "the first five families at rest are drawn over the nodal diameter")
def _(c):
    rows = c.any_case.figure("interference")
    families = [key for key in rows[0] if key.startswith("family")]
    at_rest = [row for row in rows if float(row["speed [rpm]"]) == 0]
    return len(families) >= 5 and len(at_rest) == 6, f"{len(families)} families, {len(at_rest)} nodal diameters"


def energy_shares(c):
    """Nodal diameters x families of each part's share of the strain energy at rest, of the unreduced sector."""
    path = os.path.join(c.work, "modes.h5")
    if not os.path.exists(path):
        c.run_program("tiprub-reduce", *c.wheel.arguments, c.wheel.path("sector.msh"), "--modes", path, "--set", "reduce.verification_speeds=[0.0]")
    with h5py.File(path) as file:
        groups = [file[f"nodal_diameter/{n}/energy_share"] for n in range(len(file["nodal_diameter"]))]
        return {part: numpy.array([group[part][0] for group in groups]) for part in groups[0]}


@check(20, "the first family bends the main blade and hardly moves the splitter", WHEEL)
def _(c):
    shares = energy_shares(c)
    return shares["main_blade"][:, 0].min() > 0.8 and shares["splitter"][:, 0].max() < 0.1, \
        "strain energy at rest: " + ", ".join(f"{part} {percent(value[:, 0].min())} to {percent(value[:, 0].max())}" for part, value in shares.items())


@check(21, "a higher family moves the disc near the trailing edge", WHEEL)
def _(c):
    disc = energy_shares(c)["disc"]
    n, family = numpy.unravel_index(disc[:, 1:].argmax(), disc[:, 1:].shape)
    return disc[n, family + 1] > 0.1, \
        f"of {disc.shape[1]} families, {family + 2} has the largest share of its strain energy in the disc, {percent(disc[n, family + 1])} on nodal diameter {n}"


# --- 3.4 reduction -----------------------------------------------------------------------------------------------------------

by_test(22, "eq. 7 returns its three matrices to 1e-12", ("reduce_test", "PolynomialFit.*"))


@check(23, "at a speed that the basis was not built from, the first 50 frequencies are within 0.1 % of the unreduced sector's")
def _(c):
    errors = c.model.reduction_error(50)
    unseen = {share: error for share, error in errors.items() if share not in (0.0, 0.25, 0.5, 0.75, 1.0)}
    first = c.model.reduction_error(20)
    if not unseen:
        raise CannotBeMade("no unseen speed was verified")
    return max(unseen.values()) < 1e-3, "; ".join(f"{share} of full speed: {percent(error)} (first two families' 20: {percent(first[share])})"
                                                for share, error in unseen.items())


by_test(24, "static modes at rest are unchanged, the others orthonormal; rank and dropped vectors are counted", ("reduce_test", "NodalDiameter/CraigBampton.*"))
by_test(25, "reduced matrices are symmetric, the mass is positive definite, and contact dofs are physical",
        ("reduce_test", "NodalDiameter/CraigBampton.KeepsContactDofsPhysical*:NodalDiameter/CraigBampton.ProjectionsAreHermitian*"))


@check(26, "transformed back to sectors, the reduced wheel is block-circulant")
def _(c):
    ring, size = c.model.ring("K0"), c.model.size
    rolled = numpy.roll(numpy.roll(ring, size, axis=0), size, axis=1)
    symmetric, circulant = abs(ring - ring.T).max() / abs(ring).max(), abs(ring - rolled).max() / abs(ring).max()
    return symmetric < 1e-12 and circulant < 1e-12, f"from itself turned by a sector {circulant:.1e}, from its transpose {symmetric:.1e}"


@check(27, "the model has 300 physical and 600 generalized dofs, 0.09 % of the full model")
def _(c):
    physical = 3 * len(c.model.arc_length) * c.model.sectors
    size = len(c.model.matrices[0]["M"]) * c.model.sectors
    generalized = (c.model.modes_at_speed or size // c.model.sectors) * c.model.sectors
    full = 3 * len(c.mesh.place) * c.model.sectors
    return physical == 300 and generalized == 600, \
        f"{physical} + {generalized} at any one speed, {percent((physical + generalized) / full)} of {full} (the file holds {size})"


@check(28, "the first 50 frequencies at rest are within 1 % of the unreduced model's")
def _(c):
    error = c.model.reduction_error(50)[0.0]
    return error < 0.01, percent(error)


@check(29, "the same holds at every speed, also where the basis was not built")
def _(c):
    errors = c.model.reduction_error(50)
    return max(errors.values()) < 0.01, ", ".join(f"{percent(error)} at {share}" for share, error in errors.items()) + " of full speed"


def convergence(c, over):
    rows = [row for row in c.convergence if row["over"] == over]
    return {rpm: [(int(row["value"]), float(row["difference [1]"])) for row in rows if row["speed [rpm]"] == rpm]
            for rpm in dict.fromkeys(row["speed [rpm]"] for row in rows)}


@check(30, "tip motion converges monotonically with the number of modes, within 5 % of the finest from eta = 150 on")
def _(c):
    words, good = [], True
    for rpm, points in convergence(c, "eta").items():
        differences = [value for _, value in points[:-1]]
        beyond = max(value for count, value in points if count >= 150)
        falling = all(later < earlier for earlier, later in zip(differences, differences[1:]))
        good = good and beyond < 0.05 and falling
        words.append(f"{rpm} rpm: " + ", ".join(f"{count}: {percent(value)}" for count, value in points[:-1]))
    return good, "; ".join(words) + f" from all modes, eta = {points[-1][0]}; 150 is 600 component modes of the wheel"


@check(31, "halving the time step changes the settled motion by less than 1 %")
def _(c):
    halved = [at for case in c.cases for at in case.speeds if numpy.isfinite(at.attributes.get("halving_difference", numpy.nan))]
    settled = [at for at in halved if at.attributes["period_revolutions"] > 0]
    if not settled:
        raise CannotBeMade("no settled speed was computed with half the step")
    worst = max(settled, key=lambda at: at.attributes["halving_difference"])
    others = [at.attributes["halving_difference"] for at in halved if at.attributes["period_revolutions"] == 0]
    return worst.attributes["halving_difference"] < 0.01, \
        (f"{len(settled)} settled speeds, at most {percent(worst.attributes['halving_difference'])} ({worst.attributes['halving_measure'].decode()}, "
         f"{worst.rpm:.0f} rpm)" + (f"; averaged spectra of the {len(others)} others, at most {percent(max(others))}" if others else ""))


@check(32, "a sweep uses the reduced matrices only")
def _(c):
    def linked(program):
        path = os.path.join(c.tests.build, "bin", program)
        if not os.path.exists(path):
            raise CannotBeMade(f"{path} is not built")
        libraries = subprocess.run(["ldd", path], stdout=subprocess.PIPE, text=True, check=True).stdout.lower()
        return [name for name in ("deal.ii", "gmsh", "cholmod", "anasazi") if name in libraries]

    # Trilinos' NOX and LOCA, which find periodic motions of the reduced model, are neither.
    found, of_reduce = linked("tiprub-simulate"), linked("tiprub-reduce")
    return not found and bool(of_reduce), f"finite elements, meshers and sparse solvers in tiprub-simulate: {found}; in tiprub-reduce: {of_reduce}"


@check(33, "in the Campbell diagram frequencies rise with speed, and the first family is narrow against the second", WHEEL)
def _(c):
    c.any_case.figure("campbell")
    rest, full = c.model.families[0.0][:, :2], c.model.families[1.0][:, :2]
    spread = (rest.max(axis=0) - rest.min(axis=0)) / rest.mean(axis=0)
    return bool((full > rest).all() and spread[0] < spread[1]), \
        (f"family 1 {rest[:, 0].mean():.0f} to {full[:, 0].mean():.0f} Hz, 2 {rest[:, 1].mean():.0f} to {full[:, 1].mean():.0f} Hz "
         f"(ratio at rest {rest[:, 1].mean() / rest[:, 0].mean():.2f}); spread at rest {percent(spread[0])} and {percent(spread[1])}")
