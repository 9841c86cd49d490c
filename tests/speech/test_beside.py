"""Work beside: in turn, with what it raises, and never in the way of the process's end."""

from __future__ import annotations

import gc
import subprocess
import sys
import textwrap
import threading
import weakref

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.beside import Beside


@given(st.lists(st.one_of(st.integers(), st.just("fails")), max_size=8))
def test_each_answers_for_itself_and_in_turn(work):
    beside = Beside("test")
    done = []

    def ask(piece, *, twice):
        done.append(piece)
        return int(piece) * twice

    futures = [beside.submit(ask, piece, twice=2) for piece in work]
    beside.close()
    for piece, future in zip(work, futures, strict=True):
        if piece == "fails":
            with pytest.raises(ValueError, match="fails"):
                future.result(timeout=10)
        else:
            assert future.result(timeout=10) == 2 * piece
    assert done == work


def test_a_closed_thread_ends():
    beside = Beside("ends")
    beside.close()
    beside.close()
    for thread in threading.enumerate():
        if thread.name == "ends":
            thread.join(timeout=10)
            assert not thread.is_alive()


def test_a_forgotten_thread_ends_and_keeps_nobody_whom_it_worked_for():
    class Model:
        def hears(self) -> None: ...

    model, beside = Model(), Beside("forgotten")
    gone = weakref.ref(model)
    beside.submit(model.hears).result(timeout=10)
    (thread,) = (one for one in threading.enumerate() if one.name == "forgotten")
    del model, beside
    gc.collect()
    thread.join(timeout=10)
    assert not thread.is_alive()
    assert gone() is None


def ended(program):
    """What a program of its own printed, and how it ended."""
    found = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program)], capture_output=True, text=True, timeout=60, check=False
    )
    return found.stdout.split(), found.returncode


def test_a_model_that_hangs_does_not_keep_the_process():
    """Ctrl-C would leave the program there for ever."""
    program = """
        import threading
        from intent_engine.speech.beside import Beside
        begun = threading.Event()
        def hang():
            begun.set()
            threading.Event().wait()
        Beside("hung", patience=0.1).submit(hang)
        begun.wait()
        print("over", flush=True)
    """
    assert ended(program) == (["over"], 0)


def test_the_end_of_the_process_waits_for_what_is_done_and_not_for_what_waits():
    """Native code that came back to an interpreter that is gone would abort."""
    program = """
        import atexit, threading
        from intent_engine.speech.beside import Beside
        begun, ending = threading.Event(), threading.Event()
        beside = Beside("busy")
        def work():
            begun.set()
            ending.wait()
            print("worked", flush=True)
        beside.submit(work)
        beside.submit(print, "never begun")
        begun.wait()
        atexit.register(ending.set)
    """
    assert ended(program) == (["worked"], 0)


def test_an_idle_thread_keeps_no_process():
    assert ended('from intent_engine.speech.beside import Beside; Beside("idle").submit(print, "done").result()') == (
        ["done"],
        0,
    )
