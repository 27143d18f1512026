# SPDX-License-Identifier: GPL-3.0-or-later
"""model.h5."""
import numpy

from corpus_hdf5 import Stage, attribute, edit, replaced, without

MODEL = Stage("simulate", "model.h5")
PAIRS = "nodal_diameter/1/M"


def scaled(factor):
    return lambda values: values * factor


def one_row_less(values):
    return values[:-1]


def as_words(values):
    return values.astype([("x", "f8"), ("y", "f8")]) if values.dtype.kind != "c" else numpy.array(
        list(zip(values.real.ravel(), values.imag.ravel())), dtype=[("x", "f8"), ("y", "f8")]).reshape(values.shape)


def renamed(old, new):
    return edit(lambda file: file.move(old, new))


def of_matrices():
    for name in ("K0", "K1", "K2", "M"):
        path = f"nodal_diameter/1/{name}"
        yield MODEL.entry(f"{name}.not_square", replaced(path, one_row_less), f"/nodal_diameter/1/{name} is " if name != "M" else " must be ")
        yield MODEL.entry(f"{name}.other_members", replaced(path, as_words), f"/{path}: has compound members that are not r and i")
        yield MODEL.entry(f"{name}.not_hermitian", replaced(path, lambda values: values * 1j + values), f"/{name} is not Hermitian")
        yield MODEL.entry(f"{name}.other_unit", attribute("unit", b"lb", path), 'has the unit "lb", must be ')
    yield MODEL.entry("M.negative", replaced(PAIRS, scaled(-1)), "has no mass in contact dof 0")
    yield MODEL.entry("M.zero", replaced(PAIRS, scaled(0)), "has no mass in contact dof 0")
    yield MODEL.entry("M.smaller_than_contact", replaced(PAIRS, lambda values: values[:2, :2]), "but the contact nodes alone have 6 dofs")
    yield MODEL.entry("M.empty", replaced(PAIRS, lambda values: values[:0, :0]), "but the contact nodes alone have 6 dofs")
    yield MODEL.entry("M.complex_at_0", replaced("nodal_diameter/0/M", lambda values: values + 1j * (numpy.tri(len(values)) - numpy.tri(len(values)).T)),
                      "must be real: this nodal diameter is a standing wave")
    yield MODEL.entry("K2.name_of_two_lines", renamed("nodal_diameter/1/K2", "nodal_diameter/1/a\nb"), "/nodal_diameter/1/a\\nb is not known")
    yield MODEL.entry("one_diameter_less", renamed("nodal_diameter/3", "nodal_diameter/03"), "/nodal_diameter/3/M: is missing")


def of_contact():
    arc = "contact/arc_length"
    yield MODEL.entry("arc.backwards", replaced(arc, lambda values: values[::-1]), "/contact/arc_length must increase from the leading edge")
    yield MODEL.entry("arc.in_mm", replaced(arc, scaled(1000)), "both must be in metres, from leading to trailing edge")
    yield MODEL.entry("arc.matrix", replaced(arc, lambda values: values[:, None]), "/contact/arc_length: has shape 2 x 1, must have one axis")
    yield MODEL.entry("arc.empty", replaced(arc, lambda values: values[:0]), "/contact holds no node")
    yield MODEL.entry("arc.longer", replaced(arc, lambda values: numpy.append(values, 1.0)), "/contact: every table must have 3 rows")
    yield MODEL.entry("normal.of_length_2", replaced("contact/normal", scaled(2)), "/contact/normal: row 0 is not of unit length")
    yield MODEL.entry("normal.inward", replaced("contact/normal", scaled(-1)), "normals point from the blade to the casing; reverse them")
    yield MODEL.entry("theta.in_degrees", replaced("contact/position", lambda values: values * [1, 57.29577951308232, 1]), "is it in degrees?")
    for name in ("position", "normal", "static_shift_1", "static_shift_2"):
        path = f"contact/{name}"
        yield MODEL.entry(f"{name}.two_columns", replaced(path, lambda values: values[:, :2]), f"/{path} must have three columns: r, theta, z")
        yield MODEL.entry(f"{name}.one_row", replaced(path, lambda values: values[:1]), "/contact: every table must have 2 rows")


def of_higher_terms():
    for path, phrase in (("contact/static_shift_3", "/contact: every table must have 2 rows"), ("nodal_diameter/1/K8", "/nodal_diameter/1/K8 is ")):
        yield from MODEL.of_dataset(path, 2, optional=True)
        yield MODEL.entry(f"{path.replace('/', '.')}.one_row", replaced(path, lambda values: values[:1]), phrase)
    yield MODEL.entry("static_shift_3.other_unit", attribute("unit", b"mm", "contact/static_shift_3"), 'has the unit "mm", must be "m s^6"')
    yield MODEL.entry("static_shift_3.absent", without("contact/static_shift_3"), "/contact/static_shift_4 is not known")
    yield MODEL.entry("K8.of_another_name", renamed("nodal_diameter/1/K8", "nodal_diameter/1/K10"), "/nodal_diameter/1/K10 is not known")


def of_verification():
    yield MODEL.entry("misfit.shape", replaced("verification/polynomial_misfit", one_row_less), "/verification/polynomial_misfit is 1 x 4, must be 2 x 4")
    for kind in ("unreduced", "reduced"):
        path = f"verification/nodal_diameter/0/{kind}"
        yield MODEL.entry(f"{kind}.shape", replaced(path, one_row_less), f"/{path} is 1 x ")
        yield MODEL.entry(f"{kind}.negative", replaced(path, scaled(-1)), f"/{path} holds -")
    yield MODEL.entry("speed.descending", replaced("verification/speed", lambda values: values[::-1]), "/verification/speed must begin at 0 or above, and ascend")
    yield MODEL.entry("M.times_1000", replaced(PAIRS, scaled(1000)), " but K and M of this nodal diameter give ")


def of_attributes():
    yield from MODEL.of_attribute("sector_count")
    yield from MODEL.of_attribute("speed_max")
    yield MODEL.entry("no_sector", attribute("sector_count", 0), "sector_count must be at least 1")
    yield MODEL.entry("more_sectors", attribute("sector_count", 8), "/nodal_diameter/4/M: is missing")
    yield MODEL.entry("half_a_sector", attribute("sector_count", 2.5), "attribute sector_count is not a whole number")
    yield MODEL.entry("most_sectors", attribute("sector_count", 2e9), "/nodal_diameter/4/M: is missing")
    yield MODEL.entry("speed_backwards", attribute("speed_max", -1.0), "speed_max must be at least 0")
    yield MODEL.entry("modes_is_a_text", attribute("modes_at_speed", b"all"), "has no number attribute modes_at_speed")
    yield MODEL.entry("contact_by_lines", attribute("contact", "lines"), "attribute contact is \"lines\", must be \"points\" or \"segments\"")
    yield MODEL.entry("prestress_of_another_kind", attribute("prestress", b"cubic"), 'attribute prestress is "cubic", must be "given", ')
    yield MODEL.entry("softening_of_another_kind", attribute("spin_softening", b"some"), 'attribute spin_softening is "some", must be "on" or "off"')
    yield MODEL.entry("effect_of_another_kind", renamed("effects/coriolis", "effects/magnetism"), "/effects/magnetism is not known")
    yield MODEL.entry("treatment_of_another_kind", attribute("treatment", b"some", "effects/coriolis"), 'attribute treatment is "some", must be ')
    yield MODEL.entry("prestress_is_a_number", attribute("prestress", 1), "has no text attribute prestress")


ENTRIES = [*MODEL.of_file("tiprub-model"), *MODEL.of_dataset("contact/arc_length", 1), *MODEL.of_dataset("contact/position", 2),
           *MODEL.of_dataset("contact/normal", 2), *MODEL.of_dataset("nodal_diameter/0/K0", 2), *MODEL.of_dataset(PAIRS, 2),
           *MODEL.of_dataset("verification/nodal_diameter/0/reduced", 2), *of_matrices(), *of_contact(), *of_higher_terms(), *of_verification(), *of_attributes()]
