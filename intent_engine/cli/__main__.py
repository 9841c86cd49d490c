"""``python -m intent_engine.cli``, where the script is not on the path."""

from intent_engine.cli import main

main()
