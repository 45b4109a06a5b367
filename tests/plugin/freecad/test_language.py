# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts in the user's language."""

import pytest

from freecad.seamwright.plain import language

GERMAN = {("Seamwright", "Gap tolerance"): "Spalttoleranz",
          ("App::Property", "The seams"): "Die N\u00e4hte"}  # fmt: skip


@pytest.fixture
def german(monkeypatch):
    monkeypatch.setattr(
        language, "translate", lambda context, text: GERMAN.get((context, text), text)
    )


def test_without_a_translation_texts_stay():
    assert language.tr("Gap tolerance") == language.mark("Gap tolerance") == "Gap tolerance"
    assert language.description("The seams") == "The seams"
    assert language.inside("Gap tolerance") == "gap tolerance"


def test_texts_and_descriptions_have_contexts_of_their_own(german):
    assert language.tr("Gap tolerance") == "Spalttoleranz"
    assert language.tr("The seams") == "The seams"
    assert language.description("The seams") == "Die N\u00e4hte"


def test_a_translated_title_keeps_its_capital(german):
    assert language.inside("Gap tolerance") == "Spalttoleranz"
    assert language.inside("Angle tolerance") == "angle tolerance"
