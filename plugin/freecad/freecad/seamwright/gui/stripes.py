# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw triangles as a mirror of stripes: dark and light tubes in a bright room.

The graphics card looks up each corner's reflection in a striped texture (a sphere map), so the stripes glide over
the faces as the view turns. A reflection does not depend on which side of a face its normal points to.
"""

from pivy import coin

#: Light stripes from one end of the reflected half space to the other.
STRIPES = 20

DARK, LIGHT = 20, 250
TEXTURE_PX = 256

#: From dark to light, as a part of a stripe and the next: sharper edges look jagged.
SOFT = 0.06


def unseen():
    """A node after which nothing is drawn, though the mouse still finds it."""
    style = coin.SoDrawStyle()
    style.style = coin.SoDrawStyle.INVISIBLE
    style.setOverride(True)
    return style


def node(facets):
    """A separator that draws the Facets; they let the mouse through."""
    group = coin.SoSeparator()
    pick, hints, material = coin.SoPickStyle(), coin.SoShapeHints(), coin.SoMaterial()
    pick.style = coin.SoPickStyle.UNPICKABLE
    hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    material.ambientColor, material.specularColor = (0, 0, 0), (0, 0, 0)
    material.diffuseColor, material.emissiveColor = (0.35, 0.35, 0.35), (0.65, 0.65, 0.65)
    binding, quality = coin.SoNormalBinding(), coin.SoComplexity()
    binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    quality.textureQuality = 1.0
    for child in (pick, hints, material, binding, quality, *_mirror(), *_mesh(facets)):
        group.addChild(child)
    return group


def _mirror():
    """The striped texture, and that the reflection tells which place of it is seen."""
    texture, scale = coin.SoTexture2(), coin.SoTexture2Transform()
    row = bytes(_shade((place + 0.5) / TEXTURE_PX) for place in range(TEXTURE_PX))
    texture.image.setValue(coin.SbVec2s(TEXTURE_PX, 2), 1, row * 2)
    texture.wrapS = texture.wrapT = coin.SoTexture2.REPEAT
    texture.model = coin.SoTexture2.MODULATE
    scale.scaleFactor = (STRIPES, 1.0)
    return texture, scale, coin.SoTextureCoordinateEnvironment()


def _shade(place):
    """Brightness at a place 0..1 of one dark and one light stripe."""
    from_edge = min(abs(place - edge) for edge in (0.0, 0.5, 1.0))
    inside = min(0.5, from_edge / SOFT)
    part = 0.5 + inside if place >= 0.5 else 0.5 - inside
    return round(DARK + part * (LIGHT - DARK))


def _mesh(facets):
    points, normals, faces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
    for field, values in (
        (points.point, facets.points),
        (normals.vector, facets.normals),
        (faces.coordIndex, [place for triangle in facets.triangles for place in (*triangle, -1)]),
    ):
        field.setNum(0)
        field.setValues(0, len(values), values)
    return points, normals, faces
