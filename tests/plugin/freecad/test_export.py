# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of reports: their text, their permissions, and what is said where there is none."""

import csv
import io
import os
from unittest import mock

import pytest
from test_plain import TOLERANCE, seam

from freecad.seamwright.plain import export

REPORT = {
    "seams": [{**seam(1, edges=[1, 3]), "note": "sch\u00f6n"}],
    "tolerance": TOLERANCE,
    "freecad": {"edges": {"1": ["Box", "Edge1"], "3": ["Box", "Edge7"]}},
}


def test_json_is_indented_and_keeps_letters():
    assert export.json_text({"a": {"b": "\u00e4"}}) == '{\n  "a": {\n    "b": "\u00e4"\n  }\n}\n'


def test_edges_of_a_seam_are_separated_by_blanks():
    (line,) = csv.DictReader(io.StringIO(export.csv_text(REPORT)))
    assert (line["edges"], line["faces"]) == ("Box.Edge1 Box.Edge7", "Face1 Face2")
    assert (line["length_mm"], line["class"], line["note"]) == ("10.0", "smooth", "sch\u00f6n")


def test_what_cannot_be_written_is_told(tmp_path):
    def error_of(name):
        with pytest.raises(export.ExportError) as caught:
            export.write(REPORT, tmp_path / name)
        return str(caught.value).replace(str(tmp_path), "FOLDER")

    assert error_of("a.txt") == "FOLDER/a.txt: the name must end in .csv or .json."
    assert error_of("b/a.csv") == (
        "FOLDER/b/a.csv: the folder FOLDER/b does not exist; create it first."
    )
    with mock.patch("os.replace", side_effect=OSError(28, "No space left on device")):
        assert error_of("a.csv") == "FOLDER/a.csv: cannot be written: No space left on device."


def test_a_file_has_the_permissions_of_the_one_that_it_replaces_or_of_a_new_one(tmp_path):
    before = os.umask(0o026)
    try:
        for name, mode in (("new.csv", 0o640), ("old.csv", 0o604)):
            path = tmp_path / name
            if name == "old.csv":
                path.write_text("")
                path.chmod(mode)
            export.write(REPORT, path)
            assert path.stat().st_mode & 0o7777 == mode
        assert os.umask(0o026) == 0o026, "the mask of the program stays"
    finally:
        os.umask(before)


def test_the_columns_of_a_table():
    head = export.csv_text({}).rstrip().split(",")
    figures = ("gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel",
               "curvature_change_per_mm2", "curvature_change_rel")  # fmt: skip
    assert head == [
        "id", "kind", "class", "level", "edges", "faces", "length_mm",
        *("%s_%s" % (name, part) for name in figures for part in ("lower", "upper", "at")),
        "certified", "worst", "worst_at", "worst_x_mm", "worst_y_mm", "worst_z_mm", "note",
    ]  # fmt: skip
