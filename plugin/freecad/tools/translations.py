#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The translations of the workbench.

    translations.py update               bring the .ts files up to date with the texts of the source
    translations.py compile IN.ts OUT.qm make the file that FreeCAD loads

``update`` keeps the translations of texts that still exist, and drops the others. New texts are
marked as unfinished; FreeCAD shows them in English. The files can be edited with Qt Linguist.
"""

import argparse
import ast
import pathlib
import struct
import sys
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape

ADDON = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = ADDON / "freecad" / "seamwright"
FILES = PACKAGE / "resources" / "translations"

TEXTS, PROPERTIES, COMMAND = "Seamwright", "App::Property", "Seamwright_"

#: Functions of the source whose first argument is a text, and the context of the text.
MARKS = {"tr": TEXTS, "mark": TEXTS, "inside": TEXTS, "description": PROPERTIES}

#: Attributes of classes that hold texts.
OF_CLASSES = ("LABEL", "NEEDS", "TITLE", "PREVIEW_TIP", "GROUP")

#: Methods that add a property, with the place of its description among the arguments.
ADDERS = {"add": 3, "add_with": 3, "addProperty": 3, "add_choice": 2}

#: What stands at the beginning of a .qm file, and the tags of its parts.
MAGIC = bytes.fromhex("3cb86418caef9c95cd211cbf60a1bddd")
HASHES, MESSAGES = 0x42, 0x69
END, TRANSLATION, SOURCE, CONTEXT = 1, 3, 6, 7


def texts():
    """Return the set of (context, text) of the source."""
    found = set()
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            found.update(_texts_of(node))
    return {(context, text) for context, text in found if text}


def _texts_of(node):
    if isinstance(node, ast.Call):
        yield from _of_call(node)
    elif isinstance(node, ast.ClassDef):
        yield from _of_class(node)
    elif isinstance(node, ast.Tuple):
        if any((_text(each) or "").startswith(PROPERTIES) for each in node.elts):
            yield PROPERTIES, _last_phrase(node)
    elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
        yield from _of_assignment(node.targets[0].id, node.value)


def _text(node):
    is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
    return node.value if is_text else None


def _last_phrase(row):
    """Return the last text of a table's row that has a blank: later ones are keys."""
    found = [_text(each) for each in row.elts if " " in (_text(each) or "")]
    return found[-1] if found else None


def _of_call(node):
    name = getattr(node.func, "attr", getattr(node.func, "id", ""))
    first = _text(node.args[0]) if node.args else None
    if name in MARKS and isinstance(node.func, ast.Name):
        yield MARKS[name], first
    elif name in ("QT_TRANSLATE_NOOP", "translate"):
        yield first, _text(node.args[1])
    elif name == "Option":
        yield TEXTS, _text(node.args[4])
        yield PROPERTIES, _text(node.args[5])
    elif name in ADDERS and isinstance(node.func, ast.Attribute) and len(node.args) > ADDERS[name]:
        yield PROPERTIES, _text(node.args[ADDERS[name]])


def _of_class(node):
    values = {
        each.targets[0].id: _text(each.value)
        for each in node.body
        if isinstance(each, ast.Assign) and isinstance(each.targets[0], ast.Name)
    }
    for name in OF_CLASSES:
        yield TEXTS, values.get(name)
    command = values.get("name") or COMMAND + (values.get("Type") or "")
    for name in ("menu", "tip", "LABEL", "TIP"):
        yield command, values.get(name)


def _of_assignment(name, value):
    if name == "tip":
        yield PROPERTIES, _text(value)
    if name in ("LINKS", "ELEMENTS") and isinstance(value, ast.Tuple):
        for row in value.elts:
            if isinstance(row, ast.Tuple):
                yield PROPERTIES, _text(row.elts[-1])
                if name == "LINKS" and len(row.elts) == 3:
                    yield TEXTS, _text(row.elts[1])


def read(path):
    """Return {(context, text): translation} of a .ts file; "" where it is unfinished."""
    found = {}
    for context in ElementTree.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            done = translation.get("type") != "unfinished"
            key = context.findtext("name"), message.findtext("source")
            found[key] = (translation.text or "") if done else ""
    return found


def write(path, language, translations):
    """Write a .ts file."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>"]
    lines.append('<TS version="2.1" language="%s" sourcelanguage="en">' % language)
    for context in sorted({context for context, _ in translations}):
        lines += ["<context>", "    <name>%s</name>" % escape(context)]
        for key in sorted(key for key in translations if key[0] == context):
            lines += ["    <message>", "        <source>%s</source>" % escape(key[1])]
            done, text = "" if translations[key] else ' type="unfinished"', translations[key]
            lines.append("        <translation%s>%s</translation>" % (done, escape(text)))
            lines.append("    </message>")
        lines.append("</context>")
    path.write_text("\n".join([*lines, "</TS>", ""]), encoding="utf-8")


def update():
    """Bring all .ts files up to date, and say how complete they are."""
    wanted = texts()
    for path in sorted(FILES.glob("*.ts")):
        known = read(path)
        now = {key: known.get(key, "") for key in wanted}
        write(path, path.stem.split("_", 1)[1].replace("-", "_"), now)
        print("%s: %d of %d translated" % (path.name, sum(map(bool, now.values())), len(now)))


def compiled(translations):
    """Return the contents of a .qm file; unfinished texts are left out."""
    messages, hashes = b"", []
    for (context, text), translation in sorted(translations.items()):
        if translation:
            source = text.encode("utf-8")
            hashes.append((_hash(source), len(messages)))
            messages += _part(TRANSLATION, translation.encode("utf-16-be"))
            messages += _part(SOURCE, source) + _part(CONTEXT, context.encode("utf-8"))
            messages += bytes([END])
    index = b"".join(struct.pack(">II", *each) for each in sorted(hashes))
    return MAGIC + _part(HASHES, index) + _part(MESSAGES, messages)


def _part(tag, data):
    return struct.pack(">BI", tag, len(data)) + data


def _hash(source):
    """Return the hash by which Qt finds a text: that of object files in the format ELF."""
    found = 0
    for byte in source:
        found = (found << 4) + byte
        high = found & 0xF0000000
        found = (found ^ (high >> 24)) & ~high
    return found or 1


def main():
    """Run the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("update")
    compiler = commands.add_parser("compile")
    compiler.add_argument("ts", type=pathlib.Path)
    compiler.add_argument("qm", type=pathlib.Path)
    options = parser.parse_args()
    if options.command == "update":
        update()
    else:
        options.qm.write_bytes(compiled(read(options.ts)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
