# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw a model with its points coloured by how far they moved.

They take the place of the model's own faces and edges.
"""

from pivy import coin

from freecad.seamwright.gui.scene import coloured, stripes
from freecad.seamwright.plain import moves


class MoveColours:
    """Insert ``node`` at the start of the root of a view provider.

    While it is visible, the nodes after it are not drawn.
    """

    def __init__(self):
        self.node = coin.SoSwitch()
        self._drawn = coin.SoSeparator()
        self.node.addChild(self._drawn)
        self.node.addChild(stripes.unseen())

    def show(self, visible):
        """Show or hide the colours."""
        self.node.whichChild = coin.SO_SWITCH_ALL if visible else coin.SO_SWITCH_NONE

    def update(self, move_map, edges):
        """Draw another ShownMesh with moves, and the edges of its shape."""
        self._drawn.removeAllChildren()
        colours = moves.colours(move_map.moves_mm, move_map.largest_mm)
        lines = coloured.lines(coloured.polylines(edges))
        for node in (coloured.unpickable(), coloured.faces(move_map, colours), lines):
            self._drawn.addChild(node)
