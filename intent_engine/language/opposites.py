"""Words of which one means the opposite of the other: whoever hears "off" does nothing that says "on".

They often sound alike ("on" and "off", "clockwise" and "counterclockwise"), stand at the same place of a sentence, and
of no other words does it matter as much which of them was said.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

__all__ = ["opposed"]

_PAIRS: Mapping[str, str] = {
    "en": """
        on/off up/down in/out left/right open/close open/shut opened/closed start/stop forward/backward forward/back
        forwards/backwards lock/unlock with/without more/less raise/lower increase/decrease first/last mute/unmute
        dock/undock plug/unplug fold/unfold attach/detach load/unload arm/disarm enable/disable tighten/loosen
        warmer/colder warmer/cooler hotter/colder hotter/cooler louder/quieter louder/softer brighter/darker
        brighter/dimmer faster/slower higher/lower bigger/smaller longer/shorter hot/cold high/low north/south east/west
        top/bottom front/back front/rear inside/outside before/after above/below over/under push/pull
        clockwise/counterclockwise clockwise/anticlockwise increase/reduce connect/disconnect activate/deactivate
        upstairs/downstairs upward/downward upwards/downwards leftmost/rightmost""",
    "de": """
        an/aus ein/aus auf/zu öffne/schließe öffnen/schließen hoch/runter rauf/runter links/rechts vor/zurück
        vorwärts/rückwärts rein/raus mit/ohne mehr/weniger wärmer/kälter lauter/leiser heller/dunkler
        schneller/langsamer höher/tiefer oben/unten vorne/hinten erster/letzter heiß/kalt starte/stoppe""",
    "fr": """
        allume/éteins allumer/éteindre ouvre/ferme ouvrir/fermer monte/descends monter/descendre gauche/droite
        avance/recule avancer/reculer avec/sans plus/moins dedans/dehors haut/bas devant/derrière""",
    "es": """
        enciende/apaga encender/apagar abre/cierra abrir/cerrar sube/baja subir/bajar izquierda/derecha adelante/atrás
        con/sin más/menos dentro/fuera arriba/abajo""",
    "it": """
        accendi/spegni accendere/spegnere apri/chiudi aprire/chiudere alza/abbassa alzare/abbassare sinistra/destra
        avanti/indietro con/senza più/meno dentro/fuori su/giù sopra/sotto""",
}


def _table(pairs: str) -> Mapping[str, Collection[str]]:
    table: dict[str, set[str]] = {}
    for pair in pairs.split():
        one, other = pair.split("/")
        table.setdefault(one, set()).add(other)
        table.setdefault(other, set()).add(one)
    return table


_OPPOSITES = {language: _table(pairs) for language, pairs in _PAIRS.items()}


def opposed(word: str, language: str | None = None) -> Collection[str]:
    """The words that mean the opposite of a word; none, where that is not known.

    Args:
        word: as texts are compared.
        language: two letters; None: English.
    """
    return _OPPOSITES.get(language or "en", {}).get(word, ())
