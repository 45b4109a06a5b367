# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeds of tests in Python, as support/random.hpp gives them to tests in C++."""

import os


def fnv1a(text):
    value = 2166136261
    for byte in text.encode():
        value = (value ^ byte) * 16777619 % 2**32
    return value


def seed_of_test(index=0):
    """The 32-bit FNV-1a hash of the name of the test that pytest runs, or SEAMWRIGHT_SEED. It is
    printed, which pytest shows when the test fails. Generators of one test have different
    indices."""
    given = os.environ.get("SEAMWRIGHT_SEED")
    # "folder/test_file.py::test_name[parameters] (call)": the phase is not part of the name.
    name = os.environ["PYTEST_CURRENT_TEST"].rsplit("/", 1)[-1].rpartition(" ")[0]
    seed = int(given) if given else fnv1a(name)
    print(f"Random numbers began with SEAMWRIGHT_SEED={seed}")
    return (seed + index * 2654435769) % 2**32
