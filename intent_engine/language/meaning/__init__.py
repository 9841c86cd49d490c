"""What an utterance means: stop first, then exact sentences, then the operators of speech, then misheard names.

The order is the safety of it. Nothing fuzzy is tried on words that hold a negation, a correction or a word that
changes a sentence's sense; a compound is taken whole or not at all; two meanings are nobody's order.

Each rule has its module, and knows only those above it:

- ``phrases``: fillers, wake words and operators, found in words;
- ``clause``: what is understood as one command, or why not;
- ``command``: one command, exactly said or with misheard names;
- ``dictation``: "write down ...", and then anything;
- ``corrections/``: "turn left no right", "drawer 3 and 4, no, 5";
- ``several/``: "unlock drawer 3 and 4", "turn the fan on and the pump off";
- ``joints``: where commands may part;
- ``compound``: "go forward and turn left";
- ``cancelled``: "turn left, never mind, go back";
- ``run_on``: "go forward turn left";
- ``negations/``: "don't turn left, turn right";
- ``stops``: "stop", wherever it is a command;
- ``told``: how what was understood is told;
- ``fillers_or_words``: "right then turn left";
- ``wordings/``, ``written_otherwise``: "fahr dann in die Küche", "the lamp on", "photograph it";
- ``taken_otherwise``: "t turn left", "would you mind turning left";
- ``not_commands/``: "left, right?", "turned left", and what is told of words that no rule understood;
- ``interpreter``: the order in which they are asked, and what comes of it.

``steps`` marks what they decide, for explanations.
"""

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.interpreter import MAX_CHARACTERS, MAX_WORDS, Interpreter, Understood

__all__ = ["MAX_CHARACTERS", "MAX_WORDS", "Clause", "Interpreter", "Understood"]
