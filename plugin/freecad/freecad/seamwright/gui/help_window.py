# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Help, and the window that shows the pages of the documentation."""

import FreeCADGui as Gui

from freecad.seamwright.gui.command import Command
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain import help_pages
from freecad.seamwright.plain.language import tr

SIZE = 1060, 760

#: Pixels of the contents and of the page.
WIDTHS = 240, 860

#: Room beside a picture, in pixels.
MARGIN = 40

#: The pixel at which the section is read that the window shows.
AT_TOP = QtCore.QPoint(20, 20)


class Pages(QtWidgets.QTextBrowser):
    """Shows pages in Markdown; pictures are as wide as the window at most.

    ``section_shown(anchor)`` is emitted for the section at the top of the window, "" before the
    first one.
    """

    section_shown = QtCore.Signal(str)

    def __init__(self):
        super().__init__()
        self.setOpenLinks(False)
        self.anchorClicked.connect(self.go)
        self.verticalScrollBar().valueChanged.connect(self._scrolled)

    def loadResource(self, kind, name):
        """Return a picture that fits, or what Qt loads."""
        if kind == QtGui.QTextDocument.ImageResource:
            image = QtGui.QImage(self.source().resolved(name).toLocalFile())
            width = self.viewport().width() - MARGIN
            if image.width() > width > 0:
                return image.scaledToWidth(width, QtCore.Qt.SmoothTransformation)
            return image
        return super().loadResource(kind, name)

    def go(self, url):
        """Follow a link: to a page here, to others in the browser of the system."""
        url = self.source().resolved(url)
        path = url.toLocalFile()
        if not url.isLocalFile():
            QtGui.QDesktopServices.openUrl(url)
        elif not QtCore.QFileInfo(path).exists():
            messages.say(tr("{path} is not installed; the repository has it.").format(path=path))
        elif path.endswith(".md"):
            self.setSource(url)
            self.show_section(url.fragment())
        else:
            QtGui.QDesktopServices.openUrl(url)

    def show_section(self, wanted):
        """Scroll to the heading with this anchor; return whether the page has it."""
        block = self.document().begin()
        while block.isValid():
            if block.blockFormat().headingLevel() and help_pages.anchor(block.text()) == wanted:
                top = self.document().documentLayout().blockBoundingRect(block).top()
                self.verticalScrollBar().setValue(int(top))
                self.section_shown.emit(_section_at(block))  # at the end, it is not at the top
                return True
            block = block.next()
        return False

    def _scrolled(self, _):
        self.section_shown.emit(_section_at(self.cursorForPosition(AT_TOP).block()))


def _section_at(block):
    """Return the anchor of the section in which a block lies; "" before the first one."""
    while block.isValid() and block.blockFormat().headingLevel() != 2:
        block = block.previous()
    return help_pages.anchor(block.text()) if block.isValid() else ""


class Contents(QtWidgets.QTreeWidget):
    """The pages and their sections; ``asked(address)`` is emitted for the one that is chosen."""

    asked = QtCore.Signal(QtCore.QUrl)

    def __init__(self):
        super().__init__()
        self.setHeaderHidden(True)
        self._page = None  # the item of the page that is shown
        for page, title, sections in help_pages.contents():
            item = self._add(self.invisibleRootItem(), title, page)
            for heading, anchor in sections:
                self._add(item, heading, "%s#%s" % (page, anchor))
        self.itemClicked.connect(self._chosen)
        self.itemActivated.connect(self._chosen)

    def _add(self, above, text, section):
        item = QtWidgets.QTreeWidgetItem(above, [text])
        item.setToolTip(0, text)
        item.setData(0, QtCore.Qt.UserRole, section)
        return item

    def _chosen(self, item, *_):
        self.asked.emit(QtCore.QUrl(help_pages.address(item.data(0, QtCore.Qt.UserRole))))

    def show_page(self, url):
        """Open the sections of a page, and no others."""
        name = url.fileName()
        for place in range(self.topLevelItemCount()):
            item = self.topLevelItem(place)
            is_shown = item.data(0, QtCore.Qt.UserRole) == name
            item.setExpanded(is_shown)
            if is_shown:
                self._page = item
                self.setCurrentItem(item)
                self.scrollToItem(item, QtWidgets.QAbstractItemView.PositionAtTop)

    def mark_section(self, anchor):
        """Mark the section of the shown page that has this anchor, or the page."""
        if self._page is None:
            return
        name = "%s#%s" % (self._page.data(0, QtCore.Qt.UserRole), anchor)
        sections = map(self._page.child, range(self._page.childCount()))
        found = [each for each in sections if each.data(0, QtCore.Qt.UserRole) == name]
        self.setCurrentItem(found[0] if found else self._page)


class HelpWindow(QtWidgets.QDialog):
    """The pages beside their contents, with buttons to go back and to close."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setWindowTitle(tr("Seamwright: help"))
        self.resize(*SIZE)
        self.pages = Pages()
        self.back = QtWidgets.QPushButton(tr("Back"))
        self.back.setToolTip(tr("Show the page before"))
        self.back.setEnabled(False)
        self.back.clicked.connect(self.pages.backward)
        self.pages.backwardAvailable.connect(self.back.setEnabled)
        self.contents = Contents()
        self.contents.asked.connect(self.pages.go)
        self.pages.sourceChanged.connect(self.contents.show_page)
        self.pages.section_shown.connect(self.contents.mark_section)
        both = QtWidgets.QSplitter()
        both.addWidget(self.contents)
        both.addWidget(self.pages)
        both.setStretchFactor(1, 1)
        both.setSizes(WIDTHS)
        box = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.Close)
        box.addButton(self.back, QtWidgets.QDialogButtonBox.ActionRole)
        box.rejected.connect(self.close)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(both)
        layout.addWidget(box)


class Help(Command):
    """Open the documentation."""

    name = "Seamwright_Help"
    menu = "Help"
    icon = "seamwright"
    tip = (
        "Open the documentation of Seamwright. With an object of Seamwright selected, it opens at "
        "the section about its command."
    )
    window = None

    def GetResources(self):
        """Return those of each command; FreeCAD runs this one while a panel is open, too."""
        return {**super().GetResources(), "CmdType": "ForEdit"}

    def IsActive(self):
        """Return True: the pages need no document."""
        return True

    def Activated(self):
        """Show the section of the selected object, or the first page."""
        kinds = [getattr(obj.Proxy, "Type", "") for obj in _selected()]
        self.show_section(help_pages.section_of_kind(kinds[0]) if kinds else help_pages.START)

    def show_section(self, section):
        """Show a page and section here, or on the web where no pages are installed."""
        url = QtCore.QUrl(help_pages.address(section))
        if not url.isLocalFile():
            QtGui.QDesktopServices.openUrl(url)
            return
        if self.window is None:
            self.window = HelpWindow(Gui.getMainWindow())
        self.window.show()
        self.window.raise_()
        self.window.pages.go(url)


def _selected():
    chosen = Gui.Selection.getSelection()
    return [obj for obj in chosen if hasattr(getattr(obj, "Proxy", None), "Type")]


def register():
    """Make the command known to FreeCAD; return its name."""
    Gui.addCommand(Help.name, Help())
    return [Help.name]
