# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences of the user, as FreeCAD stores them; also without a window.

What is stored but not allowed is ignored: then the default holds.
"""

import FreeCAD as App

from freecad.seamwright.plain import palette, preferences

PATH = "User parameter:BaseApp/Preferences/Mod/Seamwright"


def _group():
    return App.ParamGet(PATH)


def _stored(group, preference):
    if isinstance(preference.default, bool):
        return group.GetBool(preference.name, preference.default)
    if preference in preferences.COLOURS:
        return group.GetUnsigned(preference.name, preference.default)
    if isinstance(preference.default, int):
        return group.GetInt(preference.name, preference.default)
    return group.GetFloat(preference.name, preference.default)


def values():
    """Return {name: value} of all preferences."""
    group = _group()
    return preferences.usable({each.name: _stored(group, each) for each in preferences.ALL})


def store(given):
    """Store {name: value} of all preferences; those that are the defaults are not kept.

    Raises ValueError where one is not allowed, TypeError for other names or where one is
    missing; then nothing is stored.
    """
    preferences.check(given)
    for each in preferences.ALL:
        if each.name not in given:
            raise TypeError("missing preference %r" % each.name)
    reset()
    group = _group()
    for each in preferences.ALL:
        value = given[each.name]
        if value == each.default:
            continue
        if isinstance(each.default, bool):
            group.SetBool(each.name, value)
        elif each in preferences.COLOURS:
            group.SetUnsigned(each.name, value)
        elif isinstance(each.default, int):
            group.SetInt(each.name, value)
        else:
            group.SetFloat(each.name, value)


def reset():
    """Remove what is stored."""
    group = _group()
    for each in preferences.ALL:
        for remove in (group.RemBool, group.RemUnsigned, group.RemInt, group.RemFloat):
            remove(each.name)


def threads():
    """Return the number of threads of a computation; 0: one for each processor."""
    return values()[preferences.THREADS.name]


def comb_lines():
    """Return the number of lines of a comb on each curve."""
    return values()[preferences.COMB_LINES.name]


def zebra_stripes():
    """Return the number of light zebra stripes that a whole ball has."""
    return values()[preferences.ZEBRA_STRIPES.name]


def live_preview():
    """Return whether panels compute when a field is changed."""
    return values()[preferences.LIVE_PREVIEW.name]


def use_colours():
    """Let the palette have the colours of the user."""
    found = values()
    palette.use(
        {
            entry.key: palette.unpacked(found[each.name])
            for entry, each in zip((*palette.CLASSES, *palette.LEVELS), preferences.COLOURS)
        }
    )


def apply(obj):
    """Give a new object the tolerances, the density and the stripes of the user.

    Only tolerances with the usual defaults change: the faces of a fill have their own.
    """
    found, kind = values(), obj.Proxy
    given = {argument: (name, default) for name, argument, _, default, _ in kind.TOLERANCES}
    given.update(
        {each.argument: (each.name, each.default) for each in getattr(kind, "OPTIONS", ())}
    )
    if given.get("gap_mm", ("", None))[1] == preferences.STANDARD["gap_mm"]:
        for each in preferences.TOLERANCES:
            name, default = given.get(each.argument, ("", None))
            if default == each.default != found[each.name]:
                setattr(obj, name, found[each.name])
    if kind.Type == "CurvatureComb":
        obj.Density = found[preferences.COMB_LINES.name]
    if kind.Type == "ReflectionLines":
        obj.Stripes = found[preferences.ZEBRA_STRIPES.name]
