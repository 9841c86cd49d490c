"""What is wanted instead of a command that was broken off: "räum nicht Tisch zehn, sondern Tisch elf ab"."""

from __future__ import annotations

import pytest

GERMAN = """
language: de
slots:
  tisch: {type: number, min: 1, max: 30, whole: true}
  menge: {type: number, max: 1000}
  tür: [Haustür, Hintertür, Tor]
  was: [Bier, Wasser]
  anteil: percent
intents:
  räum: {action: custom, sentences: ["räum tisch {tisch} ab", "tisch {tisch} abräumen"]}
  gieß: {action: custom, sentences: ["gieß {menge} Milliliter {was} ein"]}
  tür: {action: custom, sentences: ["mach (die|das) {tür} auf"]}
  bring: {action: custom, sentences: ["bring [ein|{menge}] {was} an tisch {tisch}"]}
  dimm: {action: custom, sentences: ["dimm das Licht auf {anteil}"]}
"""
ENGLISH = """
language: en
slots:
  door: [front door, back door]
  amount: {type: number, max: 1000}
intents:
  pull: {action: custom, sentences: ["pull the {door} open"]}
  pour: {action: custom, sentences: ["pour {amount} milliliters of water"]}
  turn: {action: custom, sentences: ["turn around"]}
"""
FRENCH = """
language: fr
slots: {table: {type: number, max: 30, whole: true}, nombre: {type: number, max: 12, whole: true}}
intents:
  apporte: {action: custom, sentences: ["apporte {nombre} bières à la table {table}"]}
"""


@pytest.mark.parametrize(
    ("grammar", "said", "meant"),
    [
        (GERMAN, "räum nicht Tisch zehn, sondern Tisch elf ab", "räum Tisch elf ab"),
        (GERMAN, "räum bitte nicht Tisch zehn sondern elf ab", "räum Tisch elf ab"),
        (GERMAN, "nicht Tisch zehn, sondern Tisch elf abräumen", "räum Tisch elf ab"),
        (GERMAN, "gieß nicht fünfzig, sondern achtzig Milliliter Wasser ein", "gieß achtzig Milliliter Wasser ein"),
        (GERMAN, "gieß fünfzig Milliliter nicht Bier, sondern Wasser ein", "gieß fünfzig Milliliter Wasser ein"),
        (GERMAN, "mach nicht die Haustür, sondern das Tor auf", "mach das Tor auf"),
        (GERMAN, "bring kein Bier, sondern ein Wasser an Tisch sechs", "bring ein Wasser an Tisch sechs"),
        (GERMAN, "dimm das Licht nicht auf 30, sondern auf 40 Prozent", "dimm das Licht auf 40 Prozent"),
        (ENGLISH, "don't pour fifty but eighty milliliters of water", "pour eighty milliliters of water"),
        (ENGLISH, "pour not fifty but eighty milliliters of water", "pour eighty milliliters of water"),
        (ENGLISH, "don't pull the front door but the back door open", "pull the back door open"),
        (FRENCH, "n'apporte pas deux mais trois bières à la table quatre", "apporte trois bières à la table quatre"),
    ],
)
def test_what_was_begun_goes_on_as_what_is_wanted(engine_of, grammar: str, said: str, meant: str) -> None:
    engine = engine_of(grammar)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()
    assert engine.parse(said, spoken=True).actions == engine.parse(meant).actions


@pytest.mark.parametrize(
    ("grammar", "said"),
    [
        (GERMAN, "räum nicht Tisch zehn, sondern Tisch vierzig ab"),
        (GERMAN, "räum nicht nur Tisch zehn, sondern auch Tisch elf ab"),
        (GERMAN, "räum nicht Tisch zehn, sondern nicht Tisch elf ab"),
        (GERMAN, "er räumt nicht Tisch zehn, sondern Tisch elf ab"),
        (GERMAN, "Tom soll nicht Tisch zehn, sondern Tisch elf abräumen"),
        (GERMAN, "ich sagte nicht die Haustür, sondern das Tor auf"),
        (GERMAN, "gieß nicht fünfzig, achtzig"),
        (ENGLISH, "don't just pull the front door but the back door open"),
        (ENGLISH, "don't pour the tea but eighty milliliters of water"),
        (ENGLISH, "she didn't pour fifty but eighty milliliters of water"),
    ],
)
def test_where_it_is_not_clear_nothing_is_done(engine_of, grammar: str, said: str) -> None:
    assert engine_of(grammar).parse(said).actions == ()
