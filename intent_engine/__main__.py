"""What the ``intent-engine`` script and ``python -m intent_engine`` run.

Loading the command line takes a tenth of a second. A Ctrl-C in it ends the program as it ends any other, without a
traceback of whatever was being loaded: nothing is under way yet that would have to be stopped.
"""

import signal

__all__ = ["main"]


def main() -> None:
    """Load the command line, and run it."""
    interrupted = signal.getsignal(signal.SIGINT)
    if interrupted is not signal.SIG_IGN:  # as a shell has it for what runs behind an "&"
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from intent_engine.cli import main as run

    signal.signal(signal.SIGINT, interrupted)
    run()


if __name__ == "__main__":
    main()
