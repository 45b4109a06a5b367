# SPDX-License-Identifier: LGPL-2.1-or-later
"""Model files written by hand, so that the tests of the command need no other program."""

import pathlib

OCCT_DATA = pathlib.Path("/usr/share/opencascade/data")
BROKEN = pathlib.Path(__file__).resolve().parents[2] / "data" / "broken"


def installed(path):
    """The path of a model of OpenCASCADE's."""
    assert path.exists(), f"{path} is missing: install Debian's package occt-misc"
    return path


def _planar_part(points, faces):
    """Entities of planar faces over numbered points: vertices, edges shared between faces, loops.
    Returns (lines, ids)."""
    lines, edges, face_ids = [], {}, []

    def add(text):
        lines.append(f"#{100 + len(lines)}={text};")
        return f"#{99 + len(lines)}"

    def point(p):
        return add("CARTESIAN_POINT('',({:.17E},{:.17E},{:.17E}))".format(*p))

    def direction(d):
        return add("DIRECTION('',({:.17E},{:.17E},{:.17E}))".format(*d))

    vertices = [add(f"VERTEX_POINT('',{point(p)})") for p in points]

    def edge(a, b):
        if (b, a) in edges:
            return edges[b, a], ".F."
        delta = [q - p for p, q in zip(points[a], points[b])]
        line = add(
            f"LINE('',{point(points[a])},{add(f'VECTOR({chr(39) * 2},{direction(delta)},1.)')})"
        )
        edges[a, b] = add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{line},.T.)")
        return edges[a, b], ".T."

    for corners in faces:
        uses = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            number, sense = edge(a, b)
            uses.append(add(f"ORIENTED_EDGE('',*,*,{number},{sense})"))
        p, q, r = (points[k] for k in corners[:3])
        s, t = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(q, r)]
        normal = (s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0])
        axes = add(f"AXIS2_PLACEMENT_3D('',{point(p)},{direction(normal)},{direction(s)})")
        plane = add(f"PLANE('',{axes})")
        loop = add(f"EDGE_LOOP('',({','.join(uses)}))")
        bound = add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        face_ids.append(add(f"ADVANCED_FACE('',({bound}),{plane},.T.)"))
    return lines, face_ids


_HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('part','2024-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('part','part','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=SHAPE_DEFINITION_REPRESENTATION(#8,#10);
#11=CARTESIAN_POINT('',(0.,0.,0.));
#12=DIRECTION('',(0.,0.,1.));
#13=DIRECTION('',(1.,0.,0.));
#14=AXIS2_PLACEMENT_3D('',#11,#12,#13);
#17=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#18=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
"""
_MILLIMETRE = "#16=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"


def step_text(points, faces, **how):
    """A STEP file of planar faces; each face a list of indices into points, counter-clockwise from
    outside."""
    return file_text(*_planar_part(points, faces), **how)


def file_text(lines, face_ids, unit=_MILLIMETRE, closed=True):
    """A STEP file of these entities, numbered from 100, with one shell of these faces."""
    shell = "CLOSED_SHELL" if closed else "OPEN_SHELL"
    model = "MANIFOLD_SOLID_BREP('',#21)" if closed else "SHELL_BASED_SURFACE_MODEL('',(#21))"
    kind = (
        "ADVANCED_BREP_SHAPE_REPRESENTATION" if closed else "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"
    )
    units = "#16,#17,#18" if unit else "#17,#18"
    return (
        _HEAD
        + unit
        + "#15=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#19))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({units}))REPRESENTATION_CONTEXT('',''));\n"
        + f"#19=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{'#16' if unit else '#17'},'',"
          "'');\n"
        + f"#10={kind}('',(#14,#20),#15);\n#20={model};\n#21={shell}('',({','.join(face_ids)}));\n"
        + "\n".join(lines)
        + "\nENDSEC;\nEND-ISO-10303-21;\n"
    )


def curve_text(lines, sets):
    """A STEP file of these entities, numbered from 1000, with these sets of curves."""
    return (
        _HEAD
        + _MILLIMETRE
        + "#15=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#19))"
        "GLOBAL_UNIT_ASSIGNED_CONTEXT((#16,#17,#18))REPRESENTATION_CONTEXT('',''));\n"
        "#19=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#16,'','');\n"
        f"#10=SHAPE_REPRESENTATION('',(#14,{','.join(sets)}),#15);\n"
        + "\n".join(lines)
        + "\nENDSEC;\nEND-ISO-10303-21;\n"
    )


_BOX_FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def box_text(x=10, y=20, z=30, **how):
    points = [
        (0, 0, 0),
        (x, 0, 0),
        (x, y, 0),
        (0, y, 0),
        (0, 0, z),
        (x, 0, z),
        (x, y, z),
        (0, y, z),
    ]
    return step_text(points, _BOX_FACES, **how)


def roof_text(angle_deg):
    """Two squares of 10 mm that meet along a line at this angle of their planes: one seam."""
    import math

    c, s = 10 * math.cos(math.radians(angle_deg)), 10 * math.sin(math.radians(angle_deg))
    points = [(-10, 0, 0), (0, 0, 0), (0, 10, 0), (-10, 10, 0), (c, 0, s), (c, 10, s)]
    return step_text(points, [[0, 1, 2, 3], [1, 4, 5, 2]], closed=False)


def reader_that_finds(other, folder, real):
    """A reader that finds another model where the written one waits for its place."""
    reader = folder / "reader.sh"
    reader.write_text(
        "#!/bin/bash\nargs=()\nfor arg; do\n"
        f"  case \"$arg\" in *.part) args+=({str(other)!r});; *) args+=(\"$arg\");; esac\n"
        f"done\nexec {str(real)!r} \"${{args[@]}}\"\n"
    )
    reader.chmod(0o755)
    return reader
