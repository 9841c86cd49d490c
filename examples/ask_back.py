"""What to say when a sentence was not accepted: every refusal has its reason, and often what was meant.

It prints::

    person: go to the
    robot:  Where to?
    person: go to bay
    robot:  Which one: bay 1 or bay 2?
    person: go to the baggage claim
    robot:  Sorry, no place is called 'baggage claim'. Did you mean charging station or packing table?
    person: go to bay nine
    robot:  On my way to bay 9.
    person: make me a sandwich
    robot:  Sorry, I did not understand.
"""

from intent_engine import IntentEngine, Interpretation, Status

engine = IntentEngine.from_files("grammars/en.yaml", locations="locations/warehouse.yaml")


def answer(found: Interpretation) -> str:
    """One sentence to say, for each status."""
    options = " or ".join(found.alternatives[:2])
    match found.status:
        case Status.ACCEPTED:
            return f"On my way to {found.slots['place']}."
        case Status.INCOMPLETE:
            return "Where to?"
        case Status.AMBIGUOUS:
            return f"Which one: {options}?"
        case Status.REJECTED if found.reason.startswith("no place"):
            return f"Sorry, {found.reason}. Did you mean {options}?"
        case Status.REJECTED:
            return "Sorry, I did not understand."


for text in ("go to the", "go to bay", "go to the baggage claim", "go to bay nine", "make me a sandwich"):
    print(f"person: {text}")
    print(f"robot:  {answer(engine.parse(text))}")
