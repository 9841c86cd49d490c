"""Which of two subscriptions to one topic brings news. No ROS is needed for it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.ros2.clock import mark_of
from intent_engine.ros2.latched import Newest


@given(st.data())
def test_after_both_have_brought_all_the_last_live_message_holds(data):
    """Publishers that keep messages are heard twice, in any order of the two; some clocks go wrong."""
    sent = data.draw(st.lists(st.tuples(st.integers(0, 5), st.booleans()), min_size=1))
    live = [(time, number) for number, (time, _) in enumerate(sent)]
    kept = [message for message, (_, keeps) in zip(live, sent, strict=True) if keeps]
    newest, held = Newest(), None
    while live or kept:
        if live and (not kept or data.draw(st.booleans())):
            time, held = live.pop(0)
            newest.live(time)
        else:
            time, number = kept.pop(0)
            held = number if newest.kept(time) else held
            if not live:
                assert held == len(sent) - 1
    assert held == len(sent) - 1


@pytest.mark.parametrize(("heard", "sent", "news"), [([], 0, True), ([], 7, True), ([8], 7, False), ([6], 7, True)])
def test_what_was_kept_is_news_unless_something_younger_was_heard(heard, sent, news):
    newest = Newest()
    for time in heard:
        newest.live(time)
    assert newest.kept(sent) is news


GID = {"implementation_identifier": "rmw", "data": b"\x01\x0f"}


@pytest.mark.parametrize(
    ("info", "mark"),
    [
        ({"source_timestamp": 7, "publication_sequence_number": 3, "publisher_gid": GID}, 7),
        ({"source_timestamp": 0, "publication_sequence_number": 3, "publisher_gid": GID}, (b"\x01\x0f", 3)),
        ({"source_timestamp": 0, "publication_sequence_number": None, "publisher_gid": GID}, None),
        ({"source_timestamp": 0, "publication_sequence_number": 3}, None),  # of whom?
        (None, None),
    ],
)
def test_a_message_is_known_again_by_what_the_middleware_says_of_it(info, mark):
    assert mark_of(info) == mark
