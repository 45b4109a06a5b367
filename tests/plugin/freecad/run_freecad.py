# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs unittest modules inside FreeCAD, on the console or (--window) on an invisible screen.

Each run has a fresh home folder. Exit status: 0 all passed, else a failure. FreeCAD's own exit
status says little: a run also fails unless it reports its result.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SETTINGS = HERE.parents[2] / "plugin" / "freecad" / "tools" / "picture.user.cfg"
SCREEN = "-screen 0 %sx24 +extension GLX +render -noreset"

#: What is added to the settings for a style sheet.
PREFERENCES = '<FCParamGroup Name="Preferences">\n'
STYLE = """        <FCParamGroup Name="MainWindow">
          <FCText Name="StyleSheet">%s.qss</FCText>
        </FCParamGroup>
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--window", action="store_true", help="run FreeCAD with its window")
    parser.add_argument("--mod", required=True, help="the addon folder")
    parser.add_argument("--out", required=True, help="folder for pictures and files")
    parser.add_argument("--timeout", type=int, default=240, help="seconds")
    parser.add_argument("--screen", default="1600x1000", help="pixels of the invisible screen")
    parser.add_argument("--scale", default="1", help="pixels of the screen for one of the window")
    parser.add_argument("--style", default="", help="a style sheet of FreeCAD, such as Dark-blue")
    parser.add_argument("modules", nargs="+", help="unittest modules beside this file")
    return parser.parse_args()


def find(*names):
    """The first of the programs that is installed; ends the run without one."""
    for name in names:
        if shutil.which(name):
            return shutil.which(name)
    sys.exit("not installed: " + " or ".join(names))


def command(options):
    macro = str(HERE / "run_cases.FCMacro")
    # The script comes first: FreeCAD 0.20 hands options that precede it to Python.
    if not options.window:
        return [find("freecadcmd", "FreeCADCmd"), macro, "-M", options.mod]
    freecad = [find("freecad", "FreeCAD"), macro, "-M", options.mod]
    limit = ["timeout", "-k", "10", str(options.timeout)]
    return [find("xvfb-run"), "-a", "-s", SCREEN % options.screen, *limit, *freecad]


def environment(options, home):
    """Variables for a run that neither reads nor writes the user's settings."""
    (home / "home" / ".config" / "FreeCAD").mkdir(parents=True)
    (home / "run").mkdir(mode=0o700)
    settings = SETTINGS.read_text(encoding="utf-8")
    if options.style:
        settings = settings.replace(PREFERENCES, PREFERENCES + STYLE % options.style, 1)
    (home / "home" / ".config" / "FreeCAD" / "user.cfg").write_text(settings, encoding="utf-8")
    dropped = (
        "XDG_CONFIG_HOME",
        "XDG_DATA_HOME",
        "XDG_CACHE_HOME",
        "FREECAD_USER_HOME",
        "PYTHONPATH",
    )
    kept = {name: value for name, value in os.environ.items() if name not in dropped}
    return {
        **kept,
        "HOME": str(home / "home"),
        "XDG_RUNTIME_DIR": str(home / "run"),
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "QT_SCALE_FACTOR": options.scale,
        "SEAMWRIGHT_TEST_STYLE": options.style,
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
        "SEAMWRIGHT_TEST_DIR": str(HERE),
        "SEAMWRIGHT_TEST_OUT": options.out,
        "SEAMWRIGHT_TEST_MODULES": " ".join(options.modules),
        "SEAMWRIGHT_TEST_RESULT": str(home / "result"),
    }


def main():
    options = arguments()
    os.makedirs(options.out, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="seamwright-test-") as folder:
        home = pathlib.Path(folder)
        run = subprocess.run(
            command(options),
            env=environment(options, home),
            stdin=subprocess.DEVNULL,
            timeout=options.timeout + 30,
            check=False,
        )
        result = home / "result"
        report = result.read_text() if result.exists() else "no result was reported"
    print("FreeCAD ended with status %d; tests: %s" % (run.returncode, report))
    return 0 if run.returncode == 0 and report == "passed" else 1


if __name__ == "__main__":
    sys.exit(main())
