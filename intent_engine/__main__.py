"""``python -m intent_engine``: the command line, where its script is not on the path."""

from intent_engine.cli import main

if __name__ == "__main__":
    main()
