# SPDX-License-Identifier: GPL-3.0-or-later
"""case.toml: each key of each table with a value of another type, not finite, out of its range, missing or misspelt; and what is no case."""
import re

from corpus import Entry

PROGRAMS = {"mesh": "mesh", "reduce": "reduce", "casing": "simulate", "simulate": "simulate", "postprocess": "postprocess",
            "material": "postprocess"}
# Key: a number out of its range.
NUMBERS = {
    "mesh": {"bore_radius": "0", "rim_radius": "-1", "axial_length": "0", "tip_radius": "-0.1", "stagger_root_deg": "90",
             "stagger_tip_deg": "-90", "grading_along_chord": "0.5", "grading_along_span": "101", "fillet_radius": "-0.001"},
    "reduce": {"young_modulus": "0", "poisson_ratio": "0.5", "density": "-1", "speed_max_rpm": "0", "frequency_tolerance": "0",
               "polynomial_tolerance": "-1", "verification_tolerance": "2", "cyclic_tolerance": "1"},
    "casing": {"amplitude": "-1", "ramp_revolutions": "0"},
    "simulate": {"peak_prominence": "2", "damping_ratio": "-1", "resolved_frequency_hz": "-1", "damping_ratio_beyond": "1000",
                 "step_tolerance": "0", "settle_tolerance": "0"},
    "postprocess": {"prominence": "-1", "prediction_tolerance": "-1", "amplitude_decades": "0", "amplitude_max_mm": "-1",
                    "shown_speed_rpm": "-1", "operating_min_rpm": "-1", "operating_max_rpm": "-1", "operating_amplitude_mm": "-1",
                    "tip_patch_mm": "-1", "wear_coefficient": "-1"},
    "material": {"ultimate_strength": "0", "endurance_limit": "-1", "yield_strength": "-1"},
}
INTEGERS = {
    "mesh": {"blade_count": "0", "elements_along_chord": "0", "elements_through_disc": "1000000000", "elements_between_blades": "-2",
             "elements_through_blade": "1", "elements_along_span": "401"},
    "reduce": {"contact_nodes": "0", "fixed_interface_modes": "-1", "modes_at_speed": "-1", "polynomial_speeds": "-1",
               "verification_modes": "0", "threads": "0"},
    "casing": {"lobes": "0"},
    "simulate": {"scan_per_interval": "-1", "speed_count_max": "1", "modes": "-1", "steps_per_revolution": "-1",
                 "samples_per_revolution": "0", "recorded_revolutions": "0", "min_revolutions": "0", "max_revolutions": "1",
                 "casing_areas": "0", "threads": "-1", "symmetry_check_revolutions": "-1"},
    "postprocess": {"families": "0", "engine_order_max": "0"},
}
CHOICES = {
    "mesh": ["family", "blade", "element", "clamped"], "reduce": ["prestress", "contact"], "casing": ["shape", "clearance_state"],
    "simulate": ["speeds", "examine", "scheme", "contact", "nodal_diameters", "steady_state", "branches", "sweep", "when_symmetry_breaks"],
    "postprocess": ["component", "edge"],
}
POINTS = {"mesh": ["disc_profile", "thickness_root", "thickness_tip"], "casing": ["clearance"]}
LISTS = {"reduce": ["verification_speeds"], "simulate": ["speeds_rpm"]}
REQUIRED = {
    "mesh": ["family", "blade_count", "bore_radius", "rim_radius", "axial_length", "tip_radius", "thickness_root", "thickness_tip"],
    "reduce": ["young_modulus", "poisson_ratio", "density", "speed_max_rpm"], "casing": ["amplitude", "clearance"],
    "material": ["ultimate_strength", "endurance_limit"],
}


def edit(change):
    """A change of a text as one of its file."""
    def changed(path):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(change(text))
    return changed


def with_line(table, key, line):
    def change(text):
        begin, head, rest = text.partition(f"[{table}]\n")
        inside, bracket, after = rest.partition("\n[")
        inside = re.sub(rf"(?m)^{key} = .*\n?", "", inside + "\n")
        return begin + head + line + "\n" + inside + bracket + after
    return edit(change)


def of_key(table, key, kind, value, phrase):
    return Entry(f"{table}.{key}.{kind}", PROGRAMS[table], "case.toml", with_line(table, key, f"{key} = {value}" if value else ""), 2, phrase)


def of_keys():
    for table, keys in NUMBERS.items():
        for key, bad in keys.items():
            where = f"[{table}] {key} "
            yield of_key(table, key, "word", '"much"', where + "is not a number")
            yield of_key(table, key, "nan", "nan", where + "= nan must be a finite number")
            yield of_key(table, key, "range", bad, f"{where}= {bad} must be")
    for table, keys in INTEGERS.items():
        for key, bad in keys.items():
            where = f"[{table}] {key} "
            yield of_key(table, key, "fraction", "2.5", where + "is not a whole number")
            yield of_key(table, key, "list", "[2]", where + "is not a whole number")
            yield of_key(table, key, "range", bad, f"{where}= {float(bad):g} must be")
    for table, keys in CHOICES.items():
        for key in keys:
            yield of_key(table, key, "other", '"other"', f'[{table}] {key} = "other" must be one of: ')
            yield of_key(table, key, "number", "1", f"[{table}] {key} must be one of: ")
    for table, keys in REQUIRED.items():
        for key in keys:
            yield of_key(table, key, "absent", "", f"[{table}] has no {key}, and it has no default; add it")


def of_lists():
    for table, keys in POINTS.items():
        for key in keys:
            where = f"[{table}] {key} "
            yield of_key(table, key, "number", "1.0", where + "must be a list of [x, y] pairs")
            yield of_key(table, key, "empty", "[]", where + "must be a list of [x, y] pairs")
            yield of_key(table, key, "triple", "[[0.0, 1.0, 2.0]]", where + "must be a list of [x, y] pairs")
            yield of_key(table, key, "back", "[[1.0, 0.001], [0.0, 0.001]]", "with x increasing; 0 follows 1")
            yield of_key(table, key, "inf", "[[0.0, inf]]", where + "= inf must be a finite number")
    for table, keys in LISTS.items():
        for key in keys:
            where = f"[{table}] {key} "
            yield of_key(table, key, "number", "1.0", where + "must be a list of numbers")
            yield of_key(table, key, "empty", "[]", where + "must be a list of numbers")
            yield of_key(table, key, "word", '["fast"]', where + "is not a number")
            yield of_key(table, key, "negative", "[-1.0]", where + "= -1 must be")


def of_tables():
    for table, program in PROGRAMS.items():
        yield Entry(f"{table}.unknown", program, "case.toml", with_line(table, "colour", "colour = 3"), 2,
                    f'unknown key "colour" in [{table}]; known: ')
        yield Entry(f"{table}.twice", program, "case.toml", edit(lambda text, table=table: text + f"\n[{table}]\n"), 2, "not TOML: ")
        if table != "material":
            yield Entry(f"{table}.absent", program, "case.toml", edit(lambda text, table=table: text.replace(f"[{table}]", "[material]")
                        if "[material]" not in text else re.sub(rf"(?ms)^\[{table}\]\n.*?(?=^\[|\Z)", "", text)), 2, f"has no [{table}] table; add it")
    yield of_key("reduce", "spin_softening", "number", "1", "[reduce] spin_softening must be true or false")
    for key in ("speed_min_rpm", "speed_max_rpm", "speed_count"):
        yield Entry(f"speeds_rpm.and_{key}", "simulate", "case.toml", with_line("simulate", "speeds_rpm", f"speeds_rpm = [20000.0]\n{key} = 20000"), 2,
                    f"[simulate] {key} belongs to a range of speeds, and speeds_rpm lists them; leave one of them out (--set simulate.{key}= removes this key)")
    for key in ("response_up", "response_down"):
        yield of_key("postprocess", key, "number", "1", f"[postprocess] {key} must be a text in quotes")


def text_entry(name, change, phrase):
    return Entry(name, "reduce", "case.toml", edit(change), 2, phrase)


OTHER_TEXTS = [
    text_entry("empty", lambda text: "", "has no [reduce] table; add it"),
    text_entry("binary", lambda text: "\x00\x01" + text, "1:1: the byte \\x00 is no letter of UTF-8; is this a case file, saved as UTF-8?"),
    text_entry("not_utf8", lambda text: text + "# \udcff\n", "the byte \\xff is no letter of UTF-8"),
    text_entry("turned", lambda text: text.replace("density", "\u202edensity"), "\\xe2\\x80\\xae"),
    text_entry("endless_word", lambda text: text.replace("density", f'prestress = "{60000 * "x"}"\ndensity'), "xxx ... xxx"),
    text_entry("escape", lambda text: text + "\"\x1b[31m\" = 1\n", "unescaped control characters other than TAB"),
    text_entry("unclosed", lambda text: text.replace("[reduce]", "[reduce"), "not TOML: "),
    text_entry("no_value", lambda text: text.replace("density = ", "density = #"), "not TOML: "),
    text_entry("comma", lambda text: text.replace("4430.0", "4430,0"), "not TOML: "),
    text_entry("twice", lambda text: text.replace("density", "density = 1.0\ndensity", 1), "not TOML: "),
    text_entry("other_table", lambda text: text + "[reduction]\n", '"reduction" is not known here; known: title (a text), and the tables'),
    text_entry("top_level_key", lambda text: "colour = 3\n" + text, '"colour" is not known here'),
    text_entry("title_is_a_number", lambda text: text.replace("title = ", "title = 3 # "), '"title" is not known here'),
    text_entry("array_of_tables", lambda text: text.replace("[reduce]", "[[reduce]]"), '"reduce" is not known here'),
    text_entry("line_break_in_a_key", lambda text: text.replace("[reduce]", "[reduce]\n\"a\\nb\" = 1"), 'unknown key "a\\nb" in [reduce]'),
    text_entry("deep_brackets", lambda text: text + "x = " + 100000 * "[", "exceeded maximum nested value depth"),
    text_entry("many_dots", lambda text: text + 50000 * "a." + "a = 1\n", "a key of more than 16 parts; no case has one"),
    text_entry("subnormal", lambda text: text.replace("4430.0", "1e-320"), "density = "),
    text_entry("overflow", lambda text: text.replace("4430.0", "1e999"), "not TOML: "),
    text_entry("integer_overflow", lambda text: text.replace("4430.0", "99999999999999999999"), "is not representable in 64 bits"),
]
ENTRIES = [*of_keys(), *of_lists(), *of_tables(), *OTHER_TEXTS]
