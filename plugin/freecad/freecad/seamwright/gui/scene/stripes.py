# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw triangles as a mirror of stripes: light tubes in a dark room, far away.

The reflection depends on the normal as the eye sees it. A shader computes it for each pixel, so the
stripes glide over the faces as the view turns. They are the same for a normal and its opposite.
"""

import math
from typing import NamedTuple

import numpy
from pivy import coin

from freecad.seamwright.document import preferences
from freecad.seamwright.plain.preferences import ZEBRA_STRIPES


class Stripes(NamedTuple):
    """Stripes: how many light ones a ball has, the angle by which they lean, and how much of a pair
    of a light and a dark stripe the light one has.

    The lean makes stripes visible on a cylinder of any direction.
    """

    count: int = ZEBRA_STRIPES.default
    lean_rad: float = math.radians(30)
    width: float = 0.5


#: Brightness of dark and of light stripes, and the factor where a face is seen from the side.
DARK, LIGHT, GRAZING = 0.07, 0.97, 0.7

VERTEX = """
varying vec3 normal;
void main() {
  normal = gl_NormalMatrix * gl_Normal;
  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
  gl_Position = ftransform();
}
"""

#: ``position`` counts pairs of a light and a dark stripe, from the middle of the light stripe at
#: the eye. A pixel that contains much of a pair becomes grey.
FRAGMENT = """
varying vec3 normal;
void main() {
  vec3 n = normalize(normal);
  float position = %(pairs).8f * dot(n.xy, vec2(%(x).8f, %(y).8f));
  float pixel = max(fwidth(position), 1e-6);
  float inside = abs(fract(position) - 0.5) - %(half).8f;
  float part = mix(clamp(0.5 + inside / pixel, 0.0, 1.0), %(width).8f,
                   clamp(2.0 * pixel - 0.5, 0.0, 1.0));
  float shade = mix(%(dark).8f, %(light).8f, part) * mix(%(grazing).8f, 1.0, abs(n.z));
  gl_FragColor = vec4(vec3(shade), 1.0);
}
"""


def _fragment(look):
    return FRAGMENT % {
        "pairs": look.count / 2,  # components of a normal go from -1 to 1
        "x": math.cos(look.lean_rad),
        "y": math.sin(look.lean_rad),
        "half": (1 - look.width) / 2,
        "width": look.width,
        "dark": DARK,
        "light": LIGHT,
        "grazing": GRAZING,
    }


def unseen():
    """Return a node that hides the nodes after it, though the mouse still finds them."""
    style = coin.SoDrawStyle()
    style.style = coin.SoDrawStyle.INVISIBLE
    style.setOverride(True)
    return style


def node(shown):
    """Return a separator that draws a ShownMesh with stripes, transparent for the mouse."""
    group, pick, binding = coin.SoSeparator(), coin.SoPickStyle(), coin.SoNormalBinding()
    pick.style = coin.SoPickStyle.UNPICKABLE
    binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    for child in (pick, binding, *shader(Stripes(preferences.zebra_stripes())), *mesh(shown)):
        group.addChild(child)
    return group


def shader(look):
    """Return the nodes that draw the triangles after them with Stripes."""
    program = coin.SoShaderProgram()
    for index, (shader, text) in enumerate(
        ((coin.SoVertexShader(), VERTEX), (coin.SoFragmentShader(), _fragment(look)))
    ):
        shader.sourceType = coin.SoShaderObject.GLSL_PROGRAM
        shader.sourceProgram = text
        program.shaderObject.set1Value(index, shader)
    return (program,)


def mesh(shown):
    """Return the nodes of the triangles of a ShownMesh, with a normal at each corner."""
    points, normals, faces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
    ended = numpy.full((len(shown.triangles), 4), -1, numpy.int32)
    ended[:, :3] = shown.triangles
    for field, values in (
        (points.point, shown.points.astype(numpy.float32)),
        (normals.vector, shown.normals.astype(numpy.float32)),
        (faces.coordIndex, ended.ravel()),
    ):
        field.setNum(0)
        field.setValues(0, len(values), values)
    return points, normals, faces
