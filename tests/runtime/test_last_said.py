"""What "again" points back to, after any utterances."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Move, Pick, Stop, Turn
from intent_engine.interpretation import Interpretation, Status
from intent_engine.runtime.last_said import LastSaid

UTTERANCES = st.builds(
    lambda actions, status: Interpretation("", status, actions=actions if status is Status.ACCEPTED else ()),
    st.sampled_from([(), (Stop(),), (Move(0.5, 1.0, 2.0),), (Turn(1.0, 0.5, 2.0), Stop()), (Turn(1.0, 0.5, 2.0),)]),
    st.sampled_from(Status),
)


@given(st.lists(UTTERANCES))
def test_it_is_the_last_that_did_something_since_the_last_stop(said):
    last = LastSaid()
    for one in said:
        last.take(one)
    stops = [place for place, one in enumerate(said) if one.stops]
    since = [one for one in said[stops[-1] + 1 if stops else 0 :] if one.actions]
    assert last.meaning == (since[-1] if since else ())


@given(UTTERANCES)
def test_what_is_forgotten_is_not_pointed_back_to(one):
    last = LastSaid()
    last.take(one)
    last.forget()
    assert last.meaning == ()


@given(st.lists(st.sampled_from([(Move(0.5, 1.0, 2.0),), (Turn(1.0, 0.5, 2.0),)]), min_size=1))
def test_what_was_named_stands_before_what_was_done_since(since):
    last, named = LastSaid(), Interpretation("", Status.ACCEPTED, actions=(Pick("cup"), Pick("plate")))
    for one in (named, *(Interpretation("", Status.ACCEPTED, actions=actions) for actions in since)):
        last.take(one)
    assert last.meaning.actions == (*named.actions, *since[-1])
