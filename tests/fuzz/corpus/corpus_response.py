# SPDX-License-Identifier: GPL-3.0-or-later
"""response.h5."""
from corpus_hdf5 import Stage, attribute, bytes_of, edit, replaced, with_value, without, without_attribute

RESPONSE = Stage("postprocess", "response.h5")
SPEED = "speed/00001"
# Attributes of a speed that take no negative number.
NOT_NEGATIVE = ("amplitude", "change", "step_ratio", "largest_penetration", "period_revolutions", "revolutions", "contact_steps", "tension_steps",
                "solver_fallbacks", "compliance_condition", "leftover_steps", "tension_share")
AT_LEAST_ONE = ("steps_per_revolution", "samples_per_revolution", "recorded_revolutions")
NAMES = ("motion", "symmetry", "depth")


def endless_heap(path):
    """HDF5 1.10 never gets past an object without number and size in the heap of texts."""
    edit(lambda file: None)(path)
    with open(path, "r+b") as file:
        data = file.read()
        first = data.index(b"GCOL") + 16
        file.seek(first + 16 + -(-int.from_bytes(data[first + 8:first + 16], "little") // 8) * 8)
        file.write(bytes(16))


def of_scene():
    # Symptom: this message came after 50 s.
    yield RESPONSE.entry("texts.endless", endless_heap, "is not an HDF5 file, or is damaged (HDF5 dies of it: ")
    yield RESPONSE.entry("angle.backwards", replaced("casing/angle", lambda values: values[::-1]), "/casing/angle must increase within 0 .. 2 pi")
    yield RESPONSE.entry("angle.one", replaced("casing/angle", lambda values: values[:1]), "/casing/")
    yield RESPONSE.entry("distortion.shorter", replaced("casing/distortion", lambda values: values[1:]), "/casing/")
    yield RESPONSE.entry("clearance.longer", replaced("casing/clearance", lambda values: values.repeat(2)), "/clearance: has shape 2, must have 4 contact nodes (as /casing/clearance)")
    yield RESPONSE.entry("no_lobes", attribute("lobes", 0, "casing"), "/casing: attribute lobes must be at least 1")
    yield RESPONSE.entry("state", attribute("clearance_state", b"warm", "casing"), 'attribute clearance_state is "warm", must be ')
    yield RESPONSE.entry("scheme", attribute("scheme", b"leapfrog"), 'attribute scheme is "leapfrog", must be ')
    yield RESPONSE.entry("contact", attribute("contact", b"glued"), 'attribute contact is "glued", must be ')
    yield RESPONSE.entry("damping.above_critical", replaced("damping/ratio_by_family", with_value(2.0)), "/damping/ratio_by_family must be within 0 .. 1")
    yield RESPONSE.entry("damping.beyond", attribute("ratio_beyond", -1.0, "damping"), "/damping: attribute ratio_beyond must be within 0 .. 1")
    yield RESPONSE.entry("damping.of_modes", replaced("frequencies/damping_ratio/0", lambda values: values[:, 1:]), "/frequencies/damping_ratio/0: has shape")
    yield RESPONSE.entry("effect.treatment", attribute("treatment", b"some", "effects/friction"), '/effects/friction: attribute treatment is "some", must be "modelled", ')
    yield RESPONSE.entry("sectors_0", attribute("sector_count", 0), "independent_sectors must divide sector_count, both at least 1")
    yield RESPONSE.entry("sectors_7", attribute("sector_count", 7), "independent_sectors must divide sector_count, both at least 1")
    yield RESPONSE.entry("independent_4", attribute("independent_sectors", 4), "independent_sectors must divide sector_count, both at least 1")
    yield RESPONSE.entry("independent_0", attribute("independent_sectors", 0), "independent_sectors must divide sector_count, both at least 1")
    yield RESPONSE.entry("resolved_0", attribute("resolved_frequency", 0.0), "attribute resolved_frequency must be above 0")
    yield RESPONSE.entry("diameters.beyond", replaced("nodal_diameters", with_value(4)), "/nodal_diameters must increase within 0 .. sector_count/2")
    yield RESPONSE.entry("diameters.fraction", replaced("nodal_diameters", lambda values: values + 0.5), "/nodal_diameters: has a value that is not a whole number")
    yield RESPONSE.entry("another_model", attribute("model_digest", b"0123456789abcdef"), "was made with another model", 2)
    for name in ("key", "model_digest", "scope"):
        yield RESPONSE.entry(f"no_{name}", without_attribute(name), f"has no text attribute {name}")


def of_frequencies():
    speeds = "frequencies/speed"
    yield RESPONSE.entry("frequencies.absent", without("frequencies"), "/frequencies/speed must hold at least 4 speeds")
    yield RESPONSE.entry("frequencies.backwards", replaced(speeds, lambda values: values[::-1]), "/frequencies/speed must increase")
    yield RESPONSE.entry("frequencies.shorter", replaced(speeds, lambda values: values[1:]), "/frequencies/")
    yield RESPONSE.entry("frequencies.one_diameter", without("frequencies/nodal_diameter/3"), "/frequencies/nodal_diameter/3: is missing")
    yield RESPONSE.entry("frequencies.no_mode", replaced("frequencies/nodal_diameter/1", lambda values: values[:, :0]), "/frequencies/nodal_diameter/1")


def of_speed():
    for name in NOT_NEGATIVE:
        yield RESPONSE.entry(f"{name}.negative", attribute(name, -1.0, SPEED), f"/{SPEED}: attribute {name} is -1, must be ")
    for name in AT_LEAST_ONE:
        yield RESPONSE.entry(f"{name}.zero", attribute(name, 0, SPEED), f"/{SPEED}: attribute {name} is 0, must be ")
        if name != "steps_per_revolution":
            yield RESPONSE.entry(f"{name}.most", attribute(name, 2147483647, SPEED), f"/{SPEED}")
        yield RESPONSE.entry(f"{name}.nan", attribute(name, float("nan"), SPEED), f"/{SPEED}: attribute {name} is not finite")
    for name in NAMES:
        yield RESPONSE.entry(f"{name}.other", attribute(name, b"other", SPEED), f"/{SPEED}: attribute {name} is \"other\", must be ")
        yield RESPONSE.entry(f"{name}.number", attribute(name, 1, SPEED), f"/{SPEED}: has no text attribute {name}")
    yield RESPONSE.entry("speed_0", attribute("speed", 0.0, SPEED), f"/{SPEED}: attribute speed is 0, must be ")
    yield RESPONSE.entry("speed_before", attribute("speed", 1.0, SPEED), f"/{SPEED}: attribute speed must be above that of the group before it")
    yield RESPONSE.entry("chatter_node", attribute("chatter_node", 2, SPEED), "must be one of the 2 contact nodes, from 0")
    yield RESPONSE.entry("positive_multiplier", attribute("smallest_multiplier", 1.0, SPEED), "attribute smallest_multiplier is 1, must be ")
    yield RESPONSE.entry("no_speeds", edit(lambda file: [file["speed"].__delitem__(name) for name in list(file["speed"])]), "holds no speed; run tiprub-simulate")


def of_arrays():
    yield RESPONSE.entry("count.negative", replaced(f"{SPEED}/contact_count", with_value(-1)), f"/{SPEED}/contact_count: must be within 0 .. the recorded steps")
    yield RESPONSE.entry("count.beyond", replaced(f"{SPEED}/contact_count", with_value(1 << 30)), f"/{SPEED}/contact_count: must be within 0 .. the recorded steps")
    for name in ("displacement", "contact_force", "contact_count"):
        path = f"{SPEED}/{name}"
        yield RESPONSE.entry(f"{name}.shorter", replaced(path, lambda values: values[1:]), f"/{path}")
        yield RESPONSE.entry(f"{name}.narrower", replaced(path, lambda values: values[:, 1:]), f"/{path}")
        yield RESPONSE.entry(f"{name}.empty", replaced(path, lambda values: values[:0]), f"/{path}")
    for name in ("0", "2"):
        path = f"{SPEED}/snapshot/{name}"
        yield RESPONSE.entry(f"snapshot_{name}.shorter", replaced(path, lambda values: values[1:]), f"/{SPEED}/snapshot")
        yield RESPONSE.entry(f"snapshot_{name}.absent", without(path), f"/{SPEED}/snapshot")


def one_bit(data):
    """Of a number in the middle; the seal stays."""
    at = len(data) // 2
    return data[:at] + bytes([data[at] ^ 1]) + data[at + 1:]


ENTRIES = [*RESPONSE.of_file("tiprub-response"), *RESPONSE.of_dataset("casing/angle", 1), *RESPONSE.of_dataset("casing/clearance", 1), *RESPONSE.of_dataset("damping/ratio_by_family", 1),
           *RESPONSE.of_dataset("frequencies/nodal_diameter/0", 2), *RESPONSE.of_dataset(f"{SPEED}/displacement", 2),
           *RESPONSE.of_dataset(f"{SPEED}/contact_force", 2), *RESPONSE.of_attribute("sector_count"),
           *of_scene(), *of_frequencies(), *of_speed(), *of_arrays(),
           RESPONSE.entry("damaged", bytes_of(one_bit), "was damaged after it was written (its seal is broken); run tiprub-simulate again")]
