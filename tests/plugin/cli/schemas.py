# SPDX-License-Identifier: LGPL-2.1-or-later
"""The schemas of the reports, and whether they notice what is wrong."""

import copy
import json
import pathlib

import jsonschema

DOCS = pathlib.Path(__file__).parents[3] / "docs"


def schema(name):
    return json.loads((DOCS / f"{name}-1.schema.json").read_text())


def validator(name):
    return jsonschema.Draft202012Validator(schema(name))


def expect_valid(report, validator):
    errors = [f"{error.json_path}: {error.message}" for error in validator.iter_errors(report)]
    assert not errors, errors[:5]


def paths_of(value, path=()):
    """Paths to every key of the report, the first element of arrays only."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield path + (key,)
            yield from paths_of(inner, path + (key,))
    elif isinstance(value, list) and value:
        yield from paths_of(value[0], path + (0,))


def expect_every_key_matters(report, validator):
    """A missing key, a wrong type and a foreign key are noticed."""
    expect_valid(report, validator)
    for path in paths_of(report):
        for change in ("missing", "wrong"):
            broken = copy.deepcopy(report)
            inner = broken
            for key in path[:-1]:
                inner = inner[key]
            if change == "missing":
                del inner[path[-1]]
            else:
                inner[path[-1]] = {"unexpected": True}
            assert not validator.is_valid(broken), (path, change)
    assert not validator.is_valid({**report, "extra": 1})
