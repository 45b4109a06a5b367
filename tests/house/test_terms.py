# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that earlier versions used are gone: docs/glossary.md says which terms replace them.

Only patterns that have no other meaning here are searched for: reports that were released have a
key `open_edges`, documents a property `OpenEdges`, and layouts of Qt a stretch.
"""

import re

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
        ["seams that are given up", "gives up"],
        ["gives upper bounds"],
    ),
    r"[Cc]ulprit": ("blamed seam", ["the culprit"], []),
    r"\b([Ll]oose|[Oo]pen) edges?\b|(loose|open|Loose)Edge": (
        "free edge",
        ["an open edge", "loose edges", "openEdge"],
        ["open_edges", "OpenEdges", "loose sheets"],
    ),
    r"\b[Ss]oundness\b": ("validity", ["Soundness of"], ["sound"]),
    r"Speed::|\b(R|r)ooted (speed|param)": (
        "centripetal, arc-length, affine arc-length",
        ["Speed::Even"],
        ["speeds: one"],
    ),
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
#: They name these words.
NAMERS = {"docs/glossary.md", "tests/house/test_terms.py"}


@pytest.mark.parametrize("pattern", WORDS)
def test_patterns_find_what_they_are_for(pattern):
    _, found, others = WORDS[pattern]
    assert all(re.search(pattern, text) for text in found)
    assert not any(re.search(pattern, text) for text in others)


def test_earlier_words_are_gone():
    files = {name: text for name, text in texts() if not name.endswith(".json")}
    files["README.md"] = (ROOT / "README.md").read_text(encoding="utf-8")
    files["CONTRIBUTING.md"] = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    assert len(files) > 500
    left = [
        f"{name}:{1 + text.count(chr(10), 0, match.start())}: '{match[0]}': write {term}"
        for name, text in files.items()
        if name not in NAMERS
        for pattern, (term, *_) in WORDS.items()
        for match in re.finditer(pattern, text)
    ]
    assert not left, "\n".join(left)


def test_the_glossary_names_them():
    """Each row of the table of earlier words has a term that the patterns give or the glossary
    defines."""
    glossary = (ROOT / "docs/glossary.md").read_text(encoding="utf-8")
    rows = glossary.split("## Earlier words")[1].splitlines()
    rows = [line.strip("| ").split(" | ") for line in rows if line.startswith("| ")][1:]
    assert len(rows) > 10
    for now, before in rows:
        assert now and before
