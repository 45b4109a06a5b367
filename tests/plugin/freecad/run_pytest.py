# SPDX-License-Identifier: LGPL-2.1-or-later
"""run_pytest.py ADDON TESTS: the tests that need no FreeCAD; ends with 77 when pytest is
missing."""

import importlib.util
import os
import subprocess
import sys

SKIPPED = 77


def main():
    addon, tests = sys.argv[1:]
    if importlib.util.find_spec("pytest") is None:
        print("pytest is missing for", sys.executable)
        return SKIPPED
    environment = {**os.environ, "PYTHONPATH": addon, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", tests]
    return subprocess.call(command, env=environment)


if __name__ == "__main__":
    sys.exit(main())
