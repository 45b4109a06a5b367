# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports as CSV and JSON files.

A file is written beside its target and then renamed. So a reader never finds a half-written file,
and a failed export leaves an older file unchanged.
"""

import csv
import io
import json
import os
import tempfile

from freecad.seamwright.plain import rows
from freecad.seamwright.plain.language import tr

HEAD = ("id", "kind", "class", "level", "edges", "faces", "length_mm")
TAIL = ("certified", "worst", "worst_at", "worst_x_mm", "worst_y_mm", "worst_z_mm", "note")


class ExportError(Exception):
    """A report could not be written; the text says which file and why."""


def json_text(report):
    """Return the report as JSON; its key "freecad" says to which object each number belongs."""
    return json.dumps(report, indent=2, ensure_ascii=False) + "\n"


def csv_text(report):
    """Return the report as CSV with one line for each seam.

    Each figure has three columns: lower, upper, at. Cells of figures that were not measured are
    empty.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    parts = [
        "%s_%s" % (figure, part) for figure in rows.QUANTITIES for part in ("lower", "upper", "at")
    ]
    writer.writerow([*HEAD, *parts, *TAIL])
    for seam in report.get("seams", ()):
        writer.writerow(_csv_line(report, seam))
    return out.getvalue()


def _csv_line(report, seam):
    names = {
        kind: " ".join(rows.element_text(report, kind, number, True) for number in seam[kind])
        for kind in ("edges", "faces")
    }
    line = [{**seam, **names}[key] for key in HEAD]
    for name in rows.QUANTITIES:
        figure = seam.get(name) or {}
        line += [figure.get(part) for part in ("lower", "upper", "at")]
    worst = seam.get("worst") or {"quantity": None, "at": None, "point": (None, None, None)}
    return [*line, seam["certified"], worst["quantity"], worst["at"], *worst["point"], seam["note"]]


def write(report, path):
    """Write the report to ``path``: as CSV for a name ending in .csv, as JSON for .json.

    Raises ExportError for another ending, a missing folder, or a file that cannot be written.
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    makers = {".csv": csv_text, ".json": json_text}
    if ending not in makers:
        raise ExportError(tr("{path}: the name must end in .csv or .json.").format(path=path))
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise ExportError(tr("{path}: the folder {folder} does not exist; create it first.").format(
            path=path, folder=folder
        ))
    try:
        _replace(path, folder, makers[ending](report))
    except OSError as error:
        raise ExportError(tr("{path}: cannot be written: {strerror}.").format(
            path=path, strerror=error.strerror
        )) from error


def _replace(path, folder, text):
    handle, beside = tempfile.mkstemp(prefix=".seamwright-", dir=folder)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.chmod(beside, _mode_for(path))
        os.replace(beside, path)
    except BaseException:
        os.unlink(beside)
        raise


def _mode_for(path):
    """Return the permissions of the file that is replaced, or those of a new file."""
    if os.path.exists(path):
        return os.stat(path).st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
