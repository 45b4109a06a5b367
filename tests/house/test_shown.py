# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the documentation shows is run, and what it shows as output is what comes out.

In the files below every block of Python or shell is run in a folder that holds part.step, with the
installed command and Python package, unless a comment "not run" stands before it. A block of text
right after it is the expected output, in which "..." stands for anything.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
PREFIX = Path(os.environ["SEAMWRIGHT_PREFIX"])
MODELS = Path(os.environ["SEAMWRIGHT_MODELS"])
PAGES = (
    "README.md",
    *sorted(str(page.relative_to(SOURCE)) for page in (SOURCE / "docs").rglob("*.md")),
)
BLOCK = re.compile(
    r"(<!-- not run[^>]*-->\n)?^```(python|sh)\n(.*?)^```\n(?:\n?^```text\n(.*?)^```)?", re.M | re.S
)
RUN = {"python": ["/usr/bin/python3", "-c"], "sh": ["bash", "-uc"]}


def shown():
    for page in PAGES:
        for number, match in enumerate(
            BLOCK.finditer((SOURCE / page).read_text(encoding="utf-8")), 1
        ):
            skip, language, code, output = match.groups()
            if not skip:
                yield pytest.param(language, code, output, id=f"{page}:{number}")


@pytest.mark.parametrize("language, code, output", shown())
def test_block(tmp_path, language, code, output):
    shutil.copy(MODELS / "broken_block.step", tmp_path / "part.step")
    environment = {
        **os.environ,
        "PATH": f"{PREFIX}/bin:{os.environ['PATH']}",
        "PYTHONPATH": str(PREFIX / "lib/python3/dist-packages"),
    }
    run = subprocess.run(
        [*RUN[language], code], cwd=tmp_path, env=environment, capture_output=True, text=True
    )
    # 1 is an answer of the command: some seam falls short.
    assert run.returncode == 0 or (language == "sh" and run.returncode == 1), run.stderr
    assert run.stderr == ""
    if output:
        wanted = ".*".join(re.escape(part) for part in output.rstrip("\n").split("..."))
        assert re.fullmatch(wanted, run.stdout.rstrip("\n"), re.S), run.stdout


def test_links_lead_somewhere():
    broken = []
    for page in PAGES:
        for target in re.findall(r"\]\(([^)#]+)", (SOURCE / page).read_text(encoding="utf-8")):
            if not target.startswith("http") and not ((SOURCE / page).parent / target).exists():
                broken.append((page, target))
    assert broken == []
