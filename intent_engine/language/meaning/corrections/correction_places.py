"""Where the words that correct a command may begin and end in what was said."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.reading import Reading, SlotReading

__all__ = ["beginnings", "ends", "same_but"]


def same_but(begun: Reading, run: list[SlotReading], stop: int, reading: Reading, at: int, after: int) -> bool:
    """Whether two readings differ in nothing but some slots: those of ``run``, which begin before ``stop``, in the one,
    and in the other those that begin between ``at`` and ``after``. They go equally far into the words that follow:
    "two" and "three" of "meters"."""
    again = [slot for slot in sorted(reading.slots, key=lambda slot: slot.start) if at <= slot.start < after]
    if [(slot.label, max(slot.end - stop, 0)) for slot in run] != [
        (slot.label, max(slot.end - after, 0)) for slot in again
    ]:
        return False
    replaced, old, new = {slot.label for slot in run}, begun.values(), reading.values()
    return set(old) == set(new) and all(old[label] == new[label] for label in set(old) - replaced)


def beginnings(said: list[str], meant: list[str], start: int, articles: Collection[str] = ()) -> Iterator[int]:
    """Where ``meant`` may begin in ``said``: at a slot, or with words before it that it says again ("bed five"). One of
    the ``articles`` takes the place of another: "*den* Hammer, nein, *die* Zange"."""
    yield start
    if start and meant and said[start - 1] != meant[0] and {said[start - 1], meant[0]} <= {*articles}:
        yield start - 1
    for length in range(1, min(start, len(meant))):
        if said[start - length : start] == meant[:length]:
            yield start - length


def ends(said: list[str], meant: list[str], end: int) -> Iterator[int]:
    """Where ``said`` may go on after ``meant``: after a slot, or after words behind it that it says again ("times")."""
    yield end
    for length in range(1, min(len(said) - end, len(meant) - 1) + 1):
        if said[end : end + length] == meant[-length:]:
            yield end + length
