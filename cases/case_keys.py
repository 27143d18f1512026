# SPDX-License-Identifier: GPL-3.0-or-later
"""The same case with other values, for scripts that study what a key does."""
import re


def with_keys(case, table, keys):
    """The text of a case whose table has these keys, instead of its own ones or besides them."""
    head, tail = re.split(rf"^\[{table}\]$", case, maxsplit=1, flags=re.M)
    own, *others = re.split(r"^(?=\[\w+\]$)", tail, flags=re.M)
    for key in keys:
        own = re.sub(rf"^{key} = .*\n", "", own, flags=re.M)
    return f"{head}[{table}]\n" + "".join(f"{key} = {value}\n" for key, value in keys.items()) + own.lstrip("\n") + "".join(others)
