# SPDX-License-Identifier: LGPL-2.1-or-later
"""run_pytest.py ADDON TESTS: the tests that need no FreeCAD."""

import os
import subprocess
import sys


def main():
    addon, tests = sys.argv[1:]
    environment = {**os.environ, "PYTHONPATH": addon, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", tests]
    return subprocess.call(command, env=environment)


if __name__ == "__main__":
    sys.exit(main())
