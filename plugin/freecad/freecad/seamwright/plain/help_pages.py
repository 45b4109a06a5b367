# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which section of the documentation explains a command, and where the pages are."""

import os
import re

#: The pages for an installation that has none.
ONLINE = "https://example.org/seamwright/blob/main/docs/"

START = "workbench.md"

#: {name of a command, without "Seamwright_": page with section}.
SECTIONS = {
    "AnalyzeSeams": "workbench.md#use",
    "ExportReport": "workbench.md#use",
    "MatchSurfaces": "workbench.md#match-surfaces",
    "RepairSeams": "workbench.md#repair-seams",
    "UmbrellaFill": "fill.md#in-freecad",
    "CornerFillet": "corner_fillet.md#in-freecad",
    "ZebraStripes": "workbench.md#zebra-stripes",
    "Spline": "freecad_curves.md#points-of-a-spline",
    "Arcs": "freecad_curves.md#each-command",
    "FairCurve": "freecad_curves.md#each-command",
    "Clothoid": "freecad_curves.md#each-command",
    "LogSpiral": "freecad_curves.md#each-command",
    "Conic": "freecad_curves.md#each-command",
    "BlendCurves": "freecad_curves.md#each-command",
    "BridgeCurve": "freecad_curves.md#each-command",
    "JoinCurves": "freecad_curves.md#each-command",
    "BlendSurface": "freecad_surfaces.md#blend-surface",
    "ExtendSurface": "freecad_surfaces.md#extend-surface",
    "Umbrella": "freecad_surfaces.md#umbrella",
    "FrameLoft": "freecad_surfaces.md#loft-through-frames",
    "CurvatureComb": "freecad_analysis.md#curvature-comb",
    "CurvatureMap": "freecad_analysis.md#curvature-map",
    "ReflectionLines": "freecad_analysis.md#reflection-lines",
    "DraftAngle": "freecad_analysis.md#draft-angle",
    "Deviation": "freecad_analysis.md#deviation",
    "SeamPlot": "freecad_analysis.md#seam-plot",
    "Help": START,
}

#: Kinds of objects whose command has another name.
COMMANDS = {"SeamAnalysis": "AnalyzeSeams", "SeamRepair": "RepairSeams"}

#: The first pages of the contents.
FIRST = (
    START,
    "tutorial_freecad.md",
    "freecad_curves.md",
    "freecad_surfaces.md",
    "freecad_analysis.md",
    "fill.md",
    "corner_fillet.md",
    "repair.md",
    "match.md",
    "seams.md",
    "glossary.md",
)

PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def folder():
    """Return the folder of the pages: of the installed workbench or of the repository, or None."""
    for up in (2, 4):
        found = os.path.normpath(os.path.join(PACKAGE, *[os.pardir] * up, "docs"))
        if os.path.isfile(os.path.join(found, START)):
            return found
    return None


def section_of(command):
    """Return the page and section of a command, such as "fill.md#in-freecad"."""
    return SECTIONS.get(command.removeprefix("Seamwright_"), START)


def section_of_kind(kind):
    """Return the page and section of a kind of document objects."""
    return section_of(COMMANDS.get(kind, kind))


def address(section):
    """Return the address of a page and section: of a file where there is one."""
    pages = folder()
    return ONLINE + section if pages is None else "file://%s/%s" % (pages, section)


def contents():
    """Return [(page, its title, [(heading, anchor), ...]), ...] of the pages that are installed.

    The pages about the workbench come first, the others by their titles.
    """
    pages = folder()
    found = []
    for name in sorted(os.listdir(pages) if pages else []):
        if not name.endswith(".md"):
            continue
        with open(os.path.join(pages, name), encoding="utf-8") as file:
            text = re.sub(r"^```.*?^```", "", file.read(), flags=re.M | re.S)
        title, *_ = [*re.findall(r"^# (.+)$", text, re.M), name]
        sections = [plain(each) for each in re.findall(r"^## (.+)$", text, re.M)]
        found.append((name, plain(title), [(each, anchor(each)) for each in sections]))
    first = {name: place for place, name in enumerate(FIRST)}
    return sorted(found, key=lambda entry: (first.get(entry[0], len(first)), entry[1].lower()))


def plain(heading):
    """Return a heading without the marks of Markdown."""
    return re.sub(r"[*`]|\[([^\]]*)\]\([^)]*\)", r"\1", heading)


def anchor(heading):
    """Return the anchor of a heading, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def first_sentence(text):
    """Return the first sentence of a tool tip, for the status bar."""
    return re.split(r"(?<=[.!?]) |(?<=\u3002)", text, maxsplit=1)[0]
