# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a stored report, read in parts.

Python's parser lets no other thread work until it is done with a text. A report of 40,000 seams
takes it more than a second, in which the window would stand still. So the seams are parsed some at
a time.
"""

import json
import re

#: Characters of one part; a choice: such a part takes about 5 ms.
PART = 200_000

_SEAMS = re.compile(r'"seams":\s*\[')
_NEXT = re.compile(r',\s*(?=\{"id":)')


def read(text):
    """Return the report as a dict, as ``json.loads`` does."""
    found = _SEAMS.search(text)  # the count of seams in the summary has no bracket
    if found is None or len(text) < PART:
        return json.loads(text)
    seams, begin = [], found.end()
    while True:
        border = _NEXT.search(text, begin + PART)
        if border is None:
            break
        seams += json.loads("[" + text[begin : border.start()] + "]")
        begin = border.end()
    report = json.loads(text[: found.end()] + text[begin:])
    report["seams"][:0] = seams
    return report


def with_entry(text, key, value):
    """Return the text of a report with one more entry at its end."""
    return "%s, %s: %s}" % (text.rstrip()[:-1], json.dumps(key), json.dumps(value))
