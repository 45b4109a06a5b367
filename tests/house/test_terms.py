# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that earlier versions used are gone: docs/glossary.md says which terms replace them.

Only patterns that have no other meaning here are searched for: reports that were released have a
key `open_edges`, documents a property `OpenEdges`.
"""

import re
from bisect import bisect

import pytest

from sources import ROOT, texts

#: What not to write: the term to use, and what the pattern must find and must not find.
WORDS = {
    r"\b[Ff]ace ?[Uu]ses?\b|face_use": ("coedge", ["FaceUse use", "faceUse("], ["surface used"]),
    r"\bdear(er|est)?\b|Dear[A-Z]": ("costly, weight", ["DearSeams", "a dear seam"], ["Dear all"]),
    r"[Ll]ead_?[Rr]each": ("end transition, blend length", ["LeadReach", "lead_reach"], ["leads"]),
    r"\b[Tt]o the bit\b": ("bitwise", ["equal to the bit"], ["to the bitmap"]),
    r"\b([Gg]ives?|[Gg]ave|[Gg]iven|[Gg]iving) up\b": (
        "exclude",
        ["seams that are given up", "gives up", "give up"],
        ["gives upper bounds"],
    ),
    r"[Cc]ulprit": ("blamed seam", ["the culprit"], []),
    r"\b([Ll]oose|[Oo]pen) edges?\b|(loose|open|Loose)Edge": (
        "free edge",
        ["an open edge", "loose edges", "openEdge"],
        ["open_edges", "OpenEdges", "loose sheets"],
    ),
    r"\b[Ss]oundness\b": ("validity", ["Soundness of"], ["sound"]),
    r"Speed::\w*|\b(R|r)ooted (speed|param)|::(Even|Bent|Rooted)\b|\b(Even|Bent|Rooted),": (
        "centripetal, arc-length, affine arc-length",
        ["Speed::Even", "Kind::Bent", "rooted speed"],
        ["speeds: one", "an even number, bent"],
    ),
    r"\b[Ss]tretch(es)?\b": ("interval", ["a stretch", "stretches"], ["stretched", "addStretch("]),
    r"\b[Rr]ims?\b|\bRim[A-Z]": ("boundary vertex", ["Rim rim", "RimSpoke"], ["trims"]),
    r"\b[Ss]tars?\b|\bStar[A-Z]": ("extraordinary vertex", ["a star"], ["start", "Startup"]),
    r"\b(is)?Crossings?\b|[Cc]rossing (vert|corner)": (
        "regular vertex",
        ["isCrossing()", "Crossing", "a crossing vertex"],
        ["crossing(series, knot)", "crossing curves"],
    ),
    r"\bWays?\b(?! )|\bWays?::": ("strategy", ["Way::Fill", "Way>"], ["Ways to write", "way"]),
    r"\b[Pp]ull(s|ed|ing)?\b(?! request)|[a-z]Pull\b": (
        "weight",
        ["pull", "withPull"],
        ["pull request"],
    ),
    r"\blooseText\b|\bopenText\b": ("free edge", ["looseText("], ["a loose sheet"]),
    r"[Cc]ross[ -][Ff]ields?\b|CrossField|cross_field": (
        "cross-boundary derivative",
        ["cross field", "CrossFields"],
        ["crossed fields"],
    ),
    r"FaceFollow|face_follow|SeamFollow": (
        "constrained deformation",
        ["FaceFollower", "face_follow.cpp"],
        ["faces follow"],
    ),
    r"\b[Aa]new\b|Anew[A-Z_(]?": ("again", ["done anew", "LedAnew("], ["a new one"]),
    r"\b[Ii]s no matter\b": ("is negligible, does not matter", ["is no matter to"], ["no matter"]),
    r"\bSeamLaws?\b": ("connection functions", ["SeamLaw law"], ["the seam's law"]),
    r"seams? that flow": ("smooth seams", ["seams that flow"], ["seams that fall"]),
    r"did not come to an end": ("exceeded the limit", ["did not come to an end"], []),
    r"\b[Ss]urely\b": ("certainly", ["is surely within", "Surely G1"], ["surelyReaches"]),
}
#: Earlier words that no pattern finds, as they have other meanings.
NOT_SEARCHED = {
    "place": "parts stand at places of an assembly, and points lie at places of a surface",
}
#: They name these words.
NAMERS = {"docs/glossary.md", "tests/house/test_terms.py"}
#: Tests and benchmarks are of solids with rims and of polygons that are stars.
SHAPES = ("tests/", "benchmarks/")
MOULD = "the direction in which a mould opens"
#: Where a word means something else: beginnings of paths.
OTHERWISE = {
    "stretch": {
        "plugin/freecad/freecad/seamwright/gui/": "of layouts of Qt",
        "docs/n_sided_fill.md": "a patch is stretched",
    },
    "way": {"occ_adapter/repair/passed_faces.cpp": "of a point while its face moves"},
    "pull": {
        "plugin/freecad/freecad/seamwright/document/maps/draft.py": MOULD,
        "plugin/freecad/freecad/seamwright/plain/map": MOULD,
        "plugin/freecad/freecad/seamwright/plain/ramps.py": MOULD,
        "plugin/freecad/freecad/seamwright/resources/translations/": MOULD,
        "tests/plugin/freecad/map_": MOULD,
        "tests/plugin/freecad/test_map": MOULD,
        "tests/plugin/freecad/test_ramps.py": MOULD,
        "samples/35_analysis.FCMacro": MOULD,
        "docs/freecad_analysis.md": MOULD,
        "occ_adapter/match/least_moves.": "the downward gradient draws moves to what is asked",
        "occ_adapter/model/format.cpp": "a command of Git",
        "plugin/python/bind_spline.cpp": "a tension draws a curve to its polygon",
        "samples/16_alpha_curve.py": "a tension draws a curve to its polygon",
    },
    "star": {
        "docs/fill.md": "a shape of holes",
        "docs/theory/fills.md": "vectors from a centre",
        "docs/umbrella.md": "vectors from a centre",
    },
}


def joined(text):
    """The text in one line, without the marks of comments and of strings that continue, and where
    each of its lines begins there."""
    parts, starts, at, length = [], [0], 0, 0
    for match in re.finditer(r"\"[ \t]*\n[ \t]*\"|[ \t]*\n[ \t]*(//[/!]?<?|#:?)?[ \t]*", text):
        parts += [text[at : match.start()], "" if match[0][0] == '"' else " "]
        length += len(parts[-2]) + len(parts[-1])
        starts += [length]
        at = match.end()
    return "".join([*parts, text[at:]]), starts


def uses(name, text):
    """Line, text and term of each use of an earlier word."""
    line, starts = joined(text)
    for pattern, (term, *_) in WORDS.items():
        for match in re.finditer(pattern, line):
            word = re.sub(r"(e?s|ed|ing)$", "", match[0].lower())
            apart = OTHERWISE.get(word, OTHERWISE.get(match[0].lower(), {}))
            if word[:3] in ("rim", "sta") and name.startswith(SHAPES):
                continue
            if not any(name.startswith(path) for path in apart):
                yield bisect(starts, match.start()), match[0], term


@pytest.mark.parametrize("pattern", WORDS)
def test_patterns_find_what_they_are_for(pattern):
    _, found, others = WORDS[pattern]
    assert all(re.search(pattern, text) for text in found)
    assert not any(re.search(pattern, text) for text in others)


def test_words_are_found_across_lines():
    for text in (
        "a\n// so an open\n  // edge is",
        "a\n# so an open\n# edge is",
        "a\n an open\nedge",
        'a\n f("an open "\n  "edge");',
    ):
        assert list(uses("a.cpp", text)) == [(2, "open edge", "free edge")]


def test_earlier_words_are_gone():
    files = {name: text for name, text in texts() if not name.endswith(".json")}
    files["README.md"] = (ROOT / "README.md").read_text(encoding="utf-8")
    files["CONTRIBUTING.md"] = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    assert len(files) > 500
    left = [
        f"{name}:{line}: '{word}': write {term}"
        for name, text in files.items()
        if name not in NAMERS
        for line, word, term in uses(name, text)
    ]
    assert not left, "\n".join(left)


def rows_of(text):
    """The cells of the tables, without the heads."""
    rows = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    return [row for row in rows if row[0] not in ("term", "now")]


def words_of(cell):
    cell = re.sub(r"\(.*?\)|\*", "", cell)
    return [word.strip() for word in re.split("[,;]", cell)]


def is_found(word):
    """Whether a pattern finds the word in one of its examples."""
    plain = word.replace(" ", "")
    return any(
        plain in re.sub("[ _]", "", match[0]).lower()
        for pattern, (_, found, _) in WORDS.items()
        for text in found
        for match in re.finditer(pattern, text)
    )


def test_the_glossary_names_them():
    """Each word of the table of earlier words is searched for, and what replaces it is a term of
    the glossary or one that a pattern gives."""
    glossary = (ROOT / "docs/glossary.md").read_text(encoding="utf-8")
    terms, earlier = glossary.split("## Earlier words")
    known = {word for row in rows_of(terms) for word in words_of(row[0])}
    known |= {word for term, *_ in WORDS.values() for word in words_of(term)}
    rows = rows_of(earlier)
    assert len(rows) > 10
    before = {word for _, cell in rows for word in words_of(cell)}
    assert {word for word in before if word not in NOT_SEARCHED and not is_found(word)} == set()
    assert NOT_SEARCHED.keys() - before == set()
    assert {word for cell, _ in rows for word in words_of(cell)} - known == set()
