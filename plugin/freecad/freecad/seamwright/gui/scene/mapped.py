# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw a display mesh with a row of colours, by texture.

The mesh is one group of nodes that all maps share. A map adds a picture and places in it, so that
another map needs no other mesh. Limits between colours are sharp inside of triangles too.
"""

import math

import numpy
from pivy import coin

from freecad.seamwright.gui.scene import coloured, stripes
from freecad.seamwright.plain import ramps

#: Qualities of a texture in the scene library: without and with mixing of neighbouring pixels, and
#: with smaller sizes for stripes that are narrower than a pixel.
SHARP, MIXED, SCALED = 0.1, 0.4, 0.9


def mesh_group(shown, edges, placement):
    """Return (separator of triangles, separator of edges) of a ShownMesh at a placement.

    ``edges``: lists of points.
    """
    faces, lines = coin.SoGroup(), coin.SoGroup()
    hints, offset = coin.SoShapeHints(), coin.SoPolygonOffset()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    binding = coin.SoNormalBinding()
    binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    for node in (hints, offset, binding, *_moved(placement), *stripes.mesh(shown)):
        faces.addChild(node)
    for node in (*_moved(placement), coloured.lines(edges)):
        lines.addChild(node)
    return faces, lines


def _moved(placement):
    if placement.isIdentity():
        return ()
    node = coin.SoTransform()
    node.translation, node.rotation = tuple(placement.Base), placement.Rotation.Q
    return (node,)


def node(groups, look, part):
    """Return a separator that draws a mesh in the colours of a Look.

    ``groups``: of ``mesh_group``. ``part``: the slice of the points of the Look that are those of
    the mesh.
    """
    places = ramps.texture_places(look)[part].astype(numpy.float32)
    coordinates = coin.SoTextureCoordinate2()
    coordinates.point.setNum(0)
    coordinates.point.setValues(0, len(places), places)
    width, height, pixels = ramps.image(look)
    quality = SCALED if look.repeats else MIXED if look.smooth else SHARP
    texture = _texture(width, height, pixels, look.repeats)
    return _separator(groups, quality, texture, coordinates, edges=look.legend is not None)


def mirror(groups, look):
    """Return a separator that draws a mesh with the stripes of a stripes.Stripes, by a shader."""
    return _separator(groups, None, *stripes.shader(look))


class TurningStripes:
    """Zebra stripes without a shader: places that have to be set when the view has turned.

    ``node`` draws the mesh. ``normals`` are those of the model, (n, 3).
    """

    def __init__(self, groups, normals, look):
        self._normals, self._look = normals, look
        self._coordinates = coin.SoTextureCoordinate2()
        drawn = ramps.stripes_look(numpy.zeros(1), look.width, (ramps.LIGHT, ramps.DARK))
        texture = _texture(*ramps.image(drawn), True)
        self.node = _separator(groups, SCALED, texture, self._coordinates)
        self.turn((0.0, 0.0, 0.0, 1.0))

    def turn(self, quaternion):
        """Let the stripes be those seen by a camera of this orientation."""
        sideways = coin.SbRotation(*quaternion)
        lean = self._look.lean_rad
        axis = sideways.multVec(coin.SbVec3f(math.cos(lean), math.sin(lean), 0.0)).getValue()
        places = numpy.full((len(self._normals), 2), 0.25, numpy.float32)
        places[:, 0] = self._look.count / 2 * (self._normals @ numpy.array(axis))
        self._coordinates.point.setNum(0)
        self._coordinates.point.setValues(0, len(places), places)


def _texture(width, height, pixels, repeats):
    texture = coin.SoTexture2()
    texture.image.setValue(coin.SbVec2s(width, height), 3, pixels)
    texture.wrapS = coin.SoTexture2.REPEAT if repeats else coin.SoTexture2.CLAMP
    texture.wrapT = coin.SoTexture2.CLAMP
    texture.model = coin.SoTexture2.DECAL
    return texture


def _separator(groups, quality, *nodes, edges=False):
    faces, lines = groups
    whole, inside = coin.SoSeparator(), coin.SoSeparator()
    # Faces stay lit: without light, the scene library hands over no normals.
    if quality is not None:
        complexity = coin.SoComplexity()
        complexity.textureQuality = quality
        inside.addChild(complexity)
    for each in (*nodes, faces):
        inside.addChild(each)
    # Lines along the edges would hide how stripes meet there.
    for each in (coloured.unpickable(), inside, *([lines] if edges else [])):
        whole.addChild(each)
    return whole
