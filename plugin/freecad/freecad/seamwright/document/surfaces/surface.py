# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that are surfaces made beside faces.

Each is a face at its position in the model. It follows its sources, which are only read.
"""

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.option_feature import OptionFeature, links_of, values_of
from freecad.seamwright.document.surfaces import sides
from freecad.seamwright.plain import options, surface_text
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.options import ANGLE, FLOAT, LENGTH, Option

ORDERS = ("G0", "G1", "G2", "G3")

#: Where a handle is for the value 1, by the length of the derivative there: as the inner poles of a
#: cubic.
HANDLE_SHARE = 1.0 / 3

#: Where along a side its name is shown: far from the handle, which lies at the middle.
MARKED = 0.1

TOLERANCES = (
    Option("GapTolerance", "gap_mm", LENGTH, 0.01, "Gap tolerance",
           "Largest distance between the two sides of a seam, in mm", least=0.0),
    Option("AngleTolerance", "angle_deg", ANGLE, 0.1, "Angle tolerance",
           "Largest angle between the tangent planes of a seam that is G1, in degrees", least=0.0),
    Option("CurvatureTolerance", "curvature_rel", FLOAT, 0.02, "Curvature tolerance",
           "Largest relative difference of curvature of a seam that is G2; 0.02 is 2 %",
           least=0.0, percent=True),
)  # fmt: skip


class Surface(OptionFeature):
    """Proxy of a Part::FeaturePython that holds a new face."""

    GROUP = "Surface"
    RESULTS = (
        ("Reached", "App::PropertyBool", "Whether every seam certainly has its level", "reached"),
        ("MaxGap", "App::PropertyLength", "Upper bound of the gaps, in mm", "gap_mm"),
        ("MaxAngle", "App::PropertyAngle",
         "Upper bound of the angles of seams that are to be G1 or more, in degrees", "angle_deg"),
        ("MaxCurvature", "App::PropertyFloat",
         "Upper bound of the relative differences of curvature of seams that are to be G2 or more",
         "curvature_rel"),
    )  # fmt: skip

    # Methods that a subclass defines.

    @classmethod
    def sides(cls, parts, chosen, values):
        """Return {property: Side} of {property: links}; raises SourceError or ValueError."""
        raise NotImplementedError

    @classmethod
    def arranged(cls, chosen):
        """Return ({property: links}, {argument: value}) for links of a selection.

        Raises SourceError or ValueError where they are not what is needed.
        """
        raise NotImplementedError

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        raise NotImplementedError

    @classmethod
    def compute(cls, model, numbers, values, progress):
        """Return the BlendedSurface; ``numbers``: of the Gathered. Any thread may call it."""
        raise NotImplementedError

    @classmethod
    def levels(cls, values):
        """Return {property: (its name in texts, level that its seams must have)}."""
        raise NotImplementedError

    @classmethod
    def handles_of(cls, surface, values):
        """Return what ``handles`` returns for a BSplineSurface."""
        raise NotImplementedError

    @classmethod
    def marks(cls, report):
        """Return [(point, text), ...] that the panel shows in the view."""
        return report.get("marks", [])

    # The document object.

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return surface_text.summary(report)

    @classmethod
    def job(cls, module, obj, private=False):
        """Return the Job that finds (report, shape)."""
        chosen = {name: links_of(obj, name) for name, *_ in cls.LINKS}
        for name in cls.REQUIRED:
            if not chosen[name]:
                raise sources.SourceError(
                    tr("the edges of {name} were deleted: {advice}").format(
                        name=tr(name), advice=cls.advice(name)
                    )
                )
        cls.check_links(obj, chosen)
        values = values_of(obj)
        options.checked(cls.OPTIONS, values)
        parts = sides.Parts([each for links in chosen.values() for each, _ in links])
        gathered = sides.gather(cls.sides(parts, chosen, values))
        make = feature.model_maker(module, gathered.shape, private)

        def run(progress):
            try:
                return cls.compute(make(), gathered.numbers, values, progress)
            except ValueError as error:
                raise ValueError(gathered.named(str(error))) from None

        def finish(found):
            return cls.report(found, gathered, values), found.model.to_freecad().Faces[-1]

        return feature.Job(tr("Making the surface\u2026"), run, finish)

    @classmethod
    def report(cls, found, gathered, values):
        """Return the report of a BlendedSurface."""
        report = found.to_dict()
        for each in report["sides"] + report["laterals"]:
            each["reason"] = cls.in_words(gathered.named(each["reason"]))
        levels = cls.levels(values)
        for seam in report["seams"]:
            name = next(
                name
                for name, (edges, _) in gathered.numbers.items()
                if name in levels and set(edges) & set(seam["edges"])
            )
            seam["side"], seam["target"] = levels[name]
            seam["name"] = ", ".join(gathered.names["edge"][edge - 1] for edge in seam["edges"])
        return {
            **report,
            **surface_text.largest(report["seams"]),
            "tolerance": {each.argument: values[each.argument] for each in TOLERANCES},
            "poles": list(found.surface.poles.shape[:2]),
            "handles": cls.handles_of(found.surface, values),
            "marks": [
                (found.surface.point(MARKED, at).tolist(), text) for at, text in cls.ends(found)
            ],
        }

    @classmethod
    def ends(cls, found):
        """Return [(parameter across, text), ...] of the marks of a BlendedSurface."""
        return []


def is_surface(obj):
    """Return whether a document object is a surface of this workbench."""
    proxy = getattr(obj, "Proxy", None)
    return isinstance(proxy, OptionFeature) and proxy.GROUP == Surface.GROUP
