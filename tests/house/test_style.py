# SPDX-License-Identifier: LGPL-2.1-or-later
"""What CONTRIBUTING.md asks of every source file and no compiler checks."""

import re
from collections import Counter
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

from sources import CODE, LANGUAGES, ROOT, texts

COLUMNS = 100
CPP = (".cpp", ".hpp", ".i")
#: What a bug throws too: handlers of these hand the exception on, or are in EXPECTED.
WIDE = re.compile(
    r"\bcatch\s*\(\s*(?:const\s+)?(?P<what>\.\.\.|std::(?:exception|runtime_error|logic_error"
    r"|invalid_argument|domain_error|out_of_range|length_error|range_error|overflow_error"
    r"|underflow_error)\b)[^){]*\)\s*\{"
)
#: Statements that hand on what was caught, whatever it was.
HANDS_ON = re.compile(
    r"(?:^|[;{}])\s*(?:throw|[\w\[\].]+\s*=\s*std::current_exception\(\))\s*;"
)
#: Handlers that do not: file, what they catch, why. Several in one file have a reason each.
EXPECTED = {
    ("benchmarks/program.hpp", "std::exception"): "the end of a program: prints the error",
    ("core/blend/frame_features.cpp", "std::domain_error"): (
        "a piece where the curve may stop: it is counted as unknown"
    ),
    ("core/blend/loft_builder.cpp", "std::invalid_argument"): "throws it with omega of the frame",
    ("core/blend/loft_frames.cpp", "std::invalid_argument"): "throws it with omega of the frame",
    ("core/blend/match_pieces.cpp", "std::invalid_argument"): (
        "throws it with the number of the frame"
    ),
    ("core/fair/profile_sum.cpp", "std::domain_error"): (
        "a segment where the curve may stop: it is counted as undecided"
    ),
    ("core/join/network/network_topology.cpp", "std::invalid_argument"): (
        "throws it with the name of the surface"
    ),
    ("core/planar/conic_spline.cpp", "std::domain_error"): (
        "singular equations of the tangents: the step is left out"
    ),
    ("core/planar/fairing_run.cpp", "std::domain_error"): (
        "no spline through moved points: the move is not made"
    ),
    ("core/planar/fairing_run.cpp", "std::invalid_argument"): (
        "moves made neighbours equal: the move is not made"
    ),
    ("core/blend/hermite_sheet.cpp", "std::invalid_argument"): (
        "a ribbon that is no valid curve: throws it with the end"
    ),
    ("occ_adapter/blend/blend_surface.cpp", "std::invalid_argument"): (
        "edges that are no side: throws it with the end"
    ),
    ("occ_adapter/blend/lateral_boundary.cpp", "std::invalid_argument"): (
        "throws it with the edges of the boundary"
    ),
    ("core/planar/clothoid_fit.cpp", "std::domain_error"): (
        "no spline through points that are too far apart: more points are taken; no clothoids near"
        " arcs, or no spline through points: the other ones are taken"
    ),
    ("core/planar/arc_clothoids.cpp", "std::domain_error"): (
        "no transition between arcs: shorter ones are tried, and the last failure is thrown"
    ),
    ("core/planar/conic_fit.cpp", "std::domain_error"): (
        "no conics through points that are too far apart: more points are taken"
    ),
    ("core/spline/alpha_spline.cpp", "std::invalid_argument"): (
        "throws it with the number of the link"
    ),
    ("core/planar/clothoid_fit.cpp", "std::domain_error"): (
        "points that are too far apart for the turn between them: more points",
        "no arcs, or no transitions between them: a spline through points",
        "no spline through points: the one near arcs, or hands it on",
    ),
    ("occ_adapter/analyze/measure_seam.cpp", "std::domain_error"): (
        "a surface that has no enclosure: the seam is sampled instead"
    ),
    ("occ_adapter/analyze/measure_seam.cpp", "std::invalid_argument"): (
        "a surface with poles that are not finite: the seam is sampled instead"
    ),
    ("occ_adapter/analyze/measure_seam.cpp", "std::logic_error"): (
        "calls itself an internal error in the note of the seam, so that the others are reported"
    ),
    ("occ_adapter/fill/corner_fillet.cpp", "std::domain_error"): (
        "the construction refuses the sides of a corner: throws CornerRefused"
    ),
    ("occ_adapter/fill/filling.cpp", "std::domain_error"): (
        "a construction of core has no result for the sides: the reason of the fill"
    ),
    ("occ_adapter/fill/filling.cpp", "std::invalid_argument"): (
        "a construction of core refuses the sides: the reason of the fill"
    ),
    ("occ_adapter/fill/filling.cpp", "std::overflow_error"): (
        "sides whose polynomials leave the range of numbers: the reason of the fill"
    ),
    ("occ_adapter/match/candidate.cpp", "std::invalid_argument"): (
        "nearestJoin() refuses the poles: the reason of the candidate"
    ),
    ("occ_adapter/model/reader_main.cpp", "std::exception"): (
        "the end of a process: tells its parent what went wrong, whatever it was"
    ),
    ("occ_adapter/curves/space_spline.cpp", "std::domain_error"): (
        "throws GeometryError with the edges"
    ),
    ("occ_adapter/curves/space_spline.cpp", "std::invalid_argument"): (
        "throws GeometryError with the edges"
    ),
    ("plugin/cli/blend_command.cpp", "std::invalid_argument"): (
        "a part of a loft without area: the loft is one face",
        "key curves that do not correspond: throws it with the file",
    ),
    ("plugin/cli/fair_splines.cpp", "std::domain_error"): (
        "a curve made fair that may stop: a smaller move is tried"
    ),
    ("plugin/cli/key_curves.cpp", "std::domain_error"): "throws it with the file",
    ("plugin/cli/key_curves.cpp", "std::invalid_argument"): "throws it with the file",
    ("occ_adapter/planar/planar_wires.cpp", "std::domain_error"): (
        "a kind of curve that core refuses: the reason of the chain"
    ),
    ("occ_adapter/planar/planar_wires.cpp", "std::invalid_argument"): (
        "numbers that core refuses: the reason of the chain"
    ),
    ("occ_adapter/topology/built_model.cpp", "std::domain_error"): (
        "thrown again with the number of the edge"
    ),
    ("occ_adapter/topology/built_model.cpp", "std::invalid_argument"): (
        "thrown again with the label of the item"
    ),
    ("occ_adapter/repair/improve.cpp", "std::domain_error"): (
        "a curve or a surface that can't be evaluated: the reason of all seams"
    ),
    ("plugin/cli/curve_command.cpp", "std::logic_error"): (
        "core refuses the curve: the reason in the report, and the others are done"
    ),
    ("plugin/cli/curve_command.cpp", "std::overflow_error"): (
        "a curve whose polynomials leave the range of numbers: the reason in the report"
    ),
    ("plugin/cli/curve_output.cpp", "std::logic_error"): (
        "core finds no arcs near the curve: the reason in the report, and the others are drawn"
    ),
    ("plugin/cli/curve_arcs.cpp", "std::domain_error"): (
        "no clothoids through points that are too far apart: biarcs instead"
    ),
    ("plugin/cli/curve_conics.cpp", "std::domain_error"): (
        "no figures of a kink: throws what to do",
        "a part of the tolerance that is too small: the conics of the others",
        "points that are too few for their turns: the conics of other parts, or through the points",
        "no conics through the points: those near them, or throws it",
    ),
    ("plugin/cli/curve_methods.cpp", "std::domain_error"): (
        "points that are too close together: throws it with their lines",
        "throws it with the origin of the coordinates",
    ),
    ("plugin/cli/main.cpp", "std::exception"): "the end of a program: prints the error",
    ("samples/01_analyze_model.cpp", "std::exception"): "the end of a program: prints the error",
}


def measures():
    """The script tools/measures as a module."""
    loader = SourceFileLoader("measures", str(ROOT / "tools/measures"))
    module = module_from_spec(spec_from_loader("measures", loader))
    loader.exec_module(module)
    return module


def scripts():
    """Path and text of each script that is run by its name, and of what shell scripts source."""
    for name, text in texts((*LANGUAGES, "tools"), ("", ".sh")):
        if text.startswith("#!") or name.endswith(".sh"):
            yield name, text


def test_lines_have_at_most_100_columns():
    files = dict(texts((*LANGUAGES, "tools"), CODE))
    assert len(files) > 500
    files |= scripts()
    assert {"benchmarks/compare", "tools/measures", "tools/steps.sh"} <= files.keys()
    long = [
        f"{name}:{number}: {len(line)} columns"
        for name, text in files.items()
        for number, line in enumerate(text.splitlines(), 1)
        if len(line) > COLUMNS
    ]
    assert not long, "\n".join(long)


def handlers(text):
    """Of each handler of what a bug throws too: what it catches and its body without the blocks
    in it, as these may be left out."""
    text = re.sub(r"//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'", " ", text)
    for match in WIDE.finditer(text):
        depth, end = 1, match.end()
        while depth > 0:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        body = text[match.end() : end - 1]
        while (shorter := re.sub(r"\{[^{}]*\}", "{}", body.replace("{}", " "))) != body:
            body = shorter
        yield match["what"], body


def test_handlers_are_found():
    body = "catch (%s) { if (is_bad) { throw; } fail(\"} throw;\"); }"
    for what in ("...", "const std::exception& error", "std::logic_error const&"):
        ((caught, rest),) = handlers("} " + body % what)
        assert caught in what and not HANDS_ON.search(rest)
    assert not list(handlers("} " + body % "const Standard_Failure& failure"))
    for body in ("throw;", "errors[k] = std::current_exception();", "log(); throw;"):
        ((_, rest),) = handlers("} catch (...) {\n  %s\n}" % body)
        assert HANDS_ON.search(rest)
    ((_, rest),) = handlers("} catch (...) { if (is_bad) throw; }")
    assert not HANDS_ON.search(rest)


def test_no_handler_takes_a_bug_for_a_reason():
    """Handlers name what they expect. Those of what a bug throws too hand it on, or say why not."""
    found = Counter(
        (name, what)
        for name, text in texts(("core", "occ_adapter", "plugin", "samples", "benchmarks"), CPP)
        for what, body in handlers(text)
        if not HANDS_ON.search(body)
    )
    listed = Counter(
        {key: len(why) if isinstance(why, tuple) else 1 for key, why in EXPECTED.items()}
    )
    surplus = found - listed
    assert not surplus, f"name what is expected, rethrow, or list them here: {dict(surplus)}"
    gone = listed - found
    assert not gone, f"they are listed and not there: {dict(gone)}"


def test_functions_and_classes_are_short():
    tool = measures()
    found = tool.Measures(tool.files_of(None))
    assert found.functions > 3000
    long = [
        f"{name}:{block.first}: {block.kind} {block.name} has {block.lines} lines"
        for name, blocks in found.long.items()
        for block in blocks
    ]
    assert not long, "\n".join(long)


#: Tests of what other systems than Linux, or other Pythons than FreeCAD's, have not.
MAY_SKIP = {
    "tests/occ_adapter/errors_test.cpp",
    "tests/occ_adapter/prove_test.cpp",
    "tests/plugin/cli/test_repair.py",
    "tests/plugin/python/test_repair.py",
}


def test_no_test_is_skipped_where_the_packages_are_installed():
    pattern = r"GTEST_SKIP|importorskip|pytest\.skip|mark\.skip|skipTest|SKIP_RETURN_CODE"
    files = [
        name
        for name, text in texts(("tests",), (*CODE, ".txt"))
        if name != "tests/house/test_style.py" and re.search(pattern, text)
    ]
    assert set(files) == MAY_SKIP


#: Functions and classes that Eigen declares everywhere and defines in its module Geometry alone.
GEOMETRY = re.compile(
    r"\.cross\(|unitOrthogonal|Quaternion|AngleAxis|\bhomogeneous\(\)|hnormalized|Hyperplane"
    r"|AlignedBox|Isometry3|Affine3|Eigen::Translation"
)


def test_files_that_use_eigens_geometry_include_it():
    """Without it a build links only if another file of the program has the function."""
    users = {
        name: text
        for name, text in texts(("core", "occ_adapter", "plugin", "tests", "benchmarks"), CPP)
        if GEOMETRY.search(text)
    }
    assert len(users) > 50
    without = [
        name
        for name, text in users.items()
        if not re.search(r"#include <Eigen/(Geometry|Dense)>", text)
    ]
    assert not without, "\n".join(without)


def test_files_that_join_with_fmt_include_it():
    """From fmt 11 on, format.h does not contain join()."""
    wrong = [
        path
        for path, text in texts(LANGUAGES, (".cpp", ".hpp"))
        if "fmt::join" in text and "#include <fmt/ranges.h>" not in text
    ]
    assert wrong == []


def test_every_file_of_tests_is_run():
    lists = {
        folder: set(re.findall(r"\w+", (ROOT / folder / "CMakeLists.txt").read_text()))
        for folder in ("tests/plugin/cli", "tests/plugin/python")
    }
    files = {
        folder: {path.stem.removeprefix("test_") for path in (ROOT / folder).glob("test_*.py")}
        for folder in lists
    }
    assert all(files.values())
    missing = {folder: files[folder] - lists[folder] for folder in lists}
    assert not any(missing.values()), missing


def test_files_of_the_addon_are_staged():
    """A module that its build leaves out is missing only in FreeCAD."""
    addon = ROOT / "plugin" / "freecad"
    listed = (addon / "CMakeLists.txt").read_text()
    files = [path.relative_to(addon).as_posix() for path in (addon / "freecad").rglob("*.py")]
    assert len(files) > 50
    assert [name for name in files if name not in listed] == []
