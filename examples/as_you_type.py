"""Text that is still being typed or spoken: may it go on to a command, and with which words?

It prints::

    go to the: incomplete, "kitchen" may follow
    go to the kit: impossible
    go to the kitchen: complete
    turn left: extendable, "ninety" may follow
"""

from intent_engine import IntentEngine

engine = IntentEngine.from_files("grammars/en.yaml", locations="locations/home.yaml")
for text in ("go to the", "go to the kit", "go to the kitchen", "turn left"):
    prefix = engine.prefix(text)
    examples = [word for word in ("kitchen", "ninety") if word in prefix.next_words]
    print(f"{text}: {prefix.status}" + "".join(f', "{word}" may follow' for word in examples))
