#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs model files with the command and tabulates what happened to their defects.

  benchmarks/repair_survey.py [--command build/release/bin/seamwright] [--limit SECONDS] [--out DIR]
                              MODEL... [-- OPTIONS OF REPAIR]

The columns for each model are:

* seams
* defects, after, in file: defects before the repair, after it in memory, and in the written file
* worse seams: seams that are defects in the file but were none before, without those that
  writing the given model spoils
* moved, worse: faces that moved, and those of them that became worse
* move mm: the largest move
* time: the time of the repair divided by that of the analysis

Then follow the sums, the median of the times, and how often each reason was given for a seam that
was not repaired. The reports stay in DIR; models that have a report there are not repaired again.
"""
import argparse
import collections
import json
import re
import statistics
import subprocess
import sys
from pathlib import Path

COLUMNS = [
    "seams",
    "defects",
    "after",
    "in file",
    "worse seams",
    "moved",
    "worse",
    "move mm",
    "time",
]


def run(command, limit_s):
    done = subprocess.run(command, capture_output=True, text=True, timeout=limit_s)
    if done.returncode not in (0, 1):
        raise RuntimeError(
            done.stderr.strip().splitlines()[-1]
            if done.stderr.strip()
            else f"exit {done.returncode}"
        )
    return done


def report_of(model, out, arguments, options):
    """Return the report of the repair, with the time of the analysis.

    A report from an earlier run is read; else the model is analysed and repaired.
    """
    kept = out / (model.name + ".json")
    if not kept.exists():
        analysis = json.loads(
            run([arguments.command, "analyze", model, "--format", "json"], arguments.limit).stdout
        )
        fresh = kept.with_suffix(".part")
        run(
            [
                arguments.command,
                "repair",
                model,
                "-o",
                out / written_name(model),
                "--overwrite",
                "--json",
                fresh,
                *options,
            ],
            arguments.limit,
        )
        report = json.loads(fresh.read_text())
        report["analysis_s"] = analysis["time_s"]["analyze"]
        fresh.write_text(json.dumps(report))
        fresh.rename(kept)
    return json.loads(kept.read_text())


def written_name(model):
    return model.stem + (".brep" if model.suffix in (".brep", ".brp") else ".step")


def faces_of(seam):
    return tuple(sorted(seam["faces"]))


def worse_in_file(report):
    """Return the number of seams that are defects in the file but were none before the repair.

    Defects are counted for each pair of faces. Defects that writing alone causes are not counted.
    """
    before = collections.Counter(
        faces_of(s["before"]) for s in report["seams"] if s["before"]["class"] == "defect"
    )
    in_file = collections.Counter(
        faces_of(s["after"]) for s in report["seams"] if s["after"]["class"] == "defect"
    )
    in_file.update(faces_of(s) for s in report["output"]["only_in_file"])
    grown = sum(max(0, in_file[faces] - before[faces]) for faces in in_file)
    return max(0, grown - (report["output"]["spoilt_by_writing"] or 0))


def row_of(report):
    summary = report["summary"]
    return {
        "seams": summary["seams"],
        "defects": summary["defects_before"],
        "after": summary["defects_after"],
        "in file": report["output"]["defects"],
        "worse seams": worse_in_file(report),
        "moved": len(report["moves"]),
        "worse": summary["worse_faces"],
        "move mm": summary["largest_move_mm"],
        "time": report["time_s"]["repair"] / report["analysis_s"],
    }


def text_of(name, row):
    move = f"{row['move mm']:.2g}" if row["moved"] else ""
    cells = [str(row[c]) for c in COLUMNS[:-2]] + [
        move,
        f"{row['time']:.2g}" if row["time"] < 10 else f"{row['time']:.0f}",
    ]
    return f"| `{name}` | " + " | ".join(cells) + " |"


def kind_of(reason):
    return re.sub(r"-?\d[\d.e+-]*", "#", reason)


def main():
    words, options = sys.argv[1:], []
    if "--" in words:
        words, options = words[: words.index("--")], words[words.index("--") + 1 :]
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--command", default="build/release/bin/seamwright")
    parser.add_argument("--limit", type=float, default=900, help="seconds for each model")
    parser.add_argument("--out", type=Path, default=Path("build/survey"))
    parser.add_argument("models", nargs="+", type=Path)
    arguments = parser.parse_args(words)
    arguments.out.mkdir(parents=True, exist_ok=True)

    print("| model | " + " | ".join(COLUMNS) + " |\n|" + "---|" * (len(COLUMNS) + 1), flush=True)
    rows, reasons, without_defects, failures = [], collections.Counter(), [], []
    for model in arguments.models:
        try:
            report = report_of(model, arguments.out, arguments, options)
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            failures.append(f"{model.name}: {error}")
            continue
        row = row_of(report)
        if row["defects"] == 0:
            without_defects.append(model.name)
            continue
        rows.append(row)
        print(text_of(model.name, row), flush=True)
        reasons.update(
            kind_of(s["reason"])
            for s in report["seams"]
            if s["before"]["class"] == "defect" and s["reason"]
        )
    if rows:
        total = {c: sum(row[c] for row in rows) for c in COLUMNS[:-2]}
        total |= {
            "move mm": max(row["move mm"] for row in rows),
            "time": statistics.median(row["time"] for row in rows),
        }
        print(text_of(f"{len(rows)} models", total))
        if total["defects"]:
            print(
                f"\nleft in memory {total['after'] / total['defects']:.1%}, in the file "
                f"{total['in file'] / total['defects']:.1%}"
            )
    print("\nwithout defects:", ", ".join(without_defects) or "none")
    print("not repaired:", "; ".join(failures) or "none")
    for reason, count in reasons.most_common(30):
        print(f"{count:5} {reason}")


if __name__ == "__main__":
    main()
