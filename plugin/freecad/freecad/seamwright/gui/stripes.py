# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw triangles as a mirror of stripes: light tubes in a dark room, far away.

What a mirror shows is told by its normal, seen from the eye. A shader works it out for each pixel,
so the stripes glide over the faces as the view turns. They are the same for a normal and its
opposite.
"""

import math

import numpy
from pivy import coin

#: Light stripes over a ball, and the angle they lean by, so that a tube shows them however it lies.
STRIPES, LEAN = 32, math.radians(30)

#: Brightness of the dark and the light stripes, and how much of it is left where a face is seen from the side.
DARK, LIGHT, ASKANCE = 0.07, 0.97, 0.7

VERTEX = """
varying vec3 normal;
void main() {
  normal = gl_NormalMatrix * gl_Normal;
  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
  gl_Position = ftransform();
}
"""

#: ``place`` counts pairs of a light and a dark stripe from the middle of the light one that the eye stands in; where a
#: pixel holds much of a pair, it is grey.
FRAGMENT = """
varying vec3 normal;
void main() {
  vec3 n = normalize(normal);
  float place = %(pairs).8f * dot(n.xy, vec2(%(x).8f, %(y).8f));
  float pixel = max(fwidth(place), 1e-6);
  float inside = abs(fract(place) - 0.5) - 0.25;
  float part = mix(clamp(0.5 + inside / pixel, 0.0, 1.0), 0.5, clamp(2.0 * pixel - 0.5, 0.0, 1.0));
  float shade = mix(%(dark).8f, %(light).8f, part) * mix(%(askance).8f, 1.0, abs(n.z));
  gl_FragColor = vec4(vec3(shade), 1.0);
}
""" % {
    "pairs": STRIPES / 2,  # a normal's components go from -1 to 1
    "x": math.cos(LEAN),
    "y": math.sin(LEAN),
    "dark": DARK,
    "light": LIGHT,
    "askance": ASKANCE,
}


def unseen():
    """A node after which nothing is drawn, though the mouse still finds it."""
    style = coin.SoDrawStyle()
    style.style = coin.SoDrawStyle.INVISIBLE
    style.setOverride(True)
    return style


def node(shown):
    """A separator that draws the ShownMesh; they let the mouse through."""
    group, pick, binding = coin.SoSeparator(), coin.SoPickStyle(), coin.SoNormalBinding()
    pick.style = coin.SoPickStyle.UNPICKABLE
    binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    for child in (pick, binding, _mirror(), *mesh(shown)):
        group.addChild(child)
    return group


def _mirror():
    program = coin.SoShaderProgram()
    for place, (shader, text) in enumerate(
        ((coin.SoVertexShader(), VERTEX), (coin.SoFragmentShader(), FRAGMENT))
    ):
        shader.sourceType = coin.SoShaderObject.GLSL_PROGRAM
        shader.sourceProgram = text
        program.shaderObject.set1Value(place, shader)
    return program


def mesh(shown):
    """The nodes of the triangles of a ShownMesh, with a normal at each corner."""
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
