"""What may be said where any words will do: the name of a thing or of a place that no map has."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from intent_engine.language import quantities
from intent_engine.language.grammar import Grammar, Slot
from intent_engine.language.normalize import without_accents
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.utterance import PhraseSet

__all__ = ["ALONE", "ARTICLES", "ARTICLES_IN", "FREE_KINDS", "UNFINISHED", "FreeText"]

FREE_KINDS = frozenset(("text", "object"))
ARTICLES = frozenset(("the", "a", "an", "my", "our", "your", "some", "this", "that", "those", "these", "another"))
ARTICLES_IN: Mapping[str, frozenset[str]] = {
    "en": ARTICLES,
    "de": frozenset(
        ("der", "die", "das", "den", "dem", "ein", "eine", "einen", "einem", "einer", "mein", "meine", "meinen")
    ),
    "fr": frozenset(("le", "la", "les", "l", "un", "une", "des", "du", "mon", "ma", "mes", "ce", "cette")),
    "es": frozenset(("el", "la", "los", "las", "un", "una", "unos", "unas", "mi", "mis", "este", "esta")),
    "it": frozenset(("il", "lo", "la", "i", "gli", "le", "l", "un", "uno", "una", "mio", "mia", "questo", "questa")),
}
"""Words before the name of a thing or a place that are no part of it, by language."""
UNFINISHED: Mapping[str, frozenset[str]] = {
    "en": frozenset(("the", "an", "my", "our", "your", "of")),
    "de": frozenset(("der", "den", "dem", "ein", "einen", "einem", "einer", "mein", "meinen", "dein", "deinen", "vom")),
    "fr": frozenset(("un", "une", "du", "des", "de", "d", "l", "mon", "ma", "mes", "ton", "ta", "tes", "cette")),
    "es": frozenset(("el", "un", "una", "unos", "unas", "del", "de", "mi", "mis", "tu", "tus")),
    "it": frozenset(("il", "l", "gli", "un", "una", "di", "d", "del", "dello", "della", "dei", "mio", "mia", "tuo")),
}
"""No thing ends so: who says "pick up the" has not said yet what. "box a" has a name; "nimm das" is whole."""
NO_THING: Mapping[str, frozenset[str]] = {
    "en": frozenset(
        ("to", "from", "with", "into", "onto", "for", "at", "in", "on", "under", "by", "through", "between", "against",
         "over", "around",
         "beside", "behind", "near", "inside", "outside", "above", "below", "beneath", "towards", "toward", "and", "or",
         "as", "than", "if", "since", "because", "before", "after", "whose", "its", "their", "his", "every", "each",
         "no", "very", "i", "he", "she", "we", "they", "is", "are", "was", "were", "be", "been", "being", "do", "does",
         "did", "have", "has", "had", "will", "shall", "should", "would", "could", "must", "might", "hold", "speed")
    ),
    "de": frozenset(
        ("zu", "zum", "zur", "von", "mit", "in", "im", "ins", "an", "am", "ans", "auf", "aufs", "aus", "bei", "beim",
         "für", "über", "unter", "vor", "hinter", "neben", "zwischen", "gegen", "durch", "um", "nach", "seit", "oder",
         "als", "denn", "damit", "sehr", "jede", "jeder", "jedes", "jeden", "sein", "euer", "seine", "seinen", "ihre",
         "ihren", "unser", "unsere", "unseren", "eure", "euren", "mich", "mir", "dich", "dir", "sich", "uns", "euch",
         "ihm", "ihr", "ihnen", "kann", "kannst", "mag", "möchte", "werden", "wahr", "hin", "her", "ab", "los", "weg",
         "hoch", "runter", "herum", "weiter")
    ),
    "fr": frozenset(
        ("à", "au", "aux", "avec", "pour", "dans", "sur", "sous", "par", "vers", "chez", "entre", "contre", "devant",
         "derrière", "depuis", "ou", "que", "dont", "très", "chaque", "leur", "leurs", "me", "te", "se", "est", "sont",
         "était", "ont", "va", "sera")
    ),
    "es": frozenset(
        ("al", "con", "para", "en", "sobre", "bajo", "por", "hacia", "desde", "entre", "contra", "que",
         "muy", "cada", "su", "sus", "me", "te", "se", "es", "son", "era", "está", "están", "ha", "han", "va", "será")
    ),
    "it": frozenset(
        ("al", "allo", "alla", "con", "per", "in", "nel", "nella", "su", "sul", "sulla", "da", "dal", "dalla", "tra",
         "fra", "verso", "che", "molto", "ogni", "mi", "ti", "si", "è", "sono", "era", "ha", "hanno", "va", "sarà")
    ),
}  # fmt: skip
"""No thing of a slot that lists things ends so: "pick up the cup from" goes on. A song may ("what I came for")."""
MAY_BEGIN: Mapping[str, frozenset[str]] = {
    "en": frozenset(("its", "their", "his", "every", "each", "no", "very", "hold", "speed")),
    "de": frozenset(
        ("sehr", "jede", "jeder", "jedes", "jeden", "sein", "euer", "seine", "seinen", "ihr", "ihre", "ihren", "unser",
         "unsere", "unseren", "eure", "euren")
    ),
    "fr": frozenset(("très", "chaque", "leur", "leurs")),
    "es": frozenset(("muy", "cada", "su", "sus")),
    "it": frozenset(("molto", "ogni")),
}  # fmt: skip
"""Of these words those with which the name of a thing may begin. "Drop by later" drops no "by later"."""
NEVER_IN: Mapping[str, frozenset[str]] = {
    "en": frozenset(
        ("or", "either", "whichever", "whatever", "whoever", "somebody", "someone", "anybody", "anyone", "before",
         "after", "later", "soon", "someday", "today", "tonight", "tomorrow", "yesterday", "noon", "midnight",
         "mondays", "tuesdays", "wednesdays", "thursdays", "fridays", "saturdays", "sundays", "weekends", "twice",
         "thrice", "once", "always", "often", "seldom", "sometimes", "ever", "times", "count", "during",
         "throughout", "only", "almost", "halfway", "partly", "somewhere", "elsewhere", "anywhere", "everywhere",
         "myself", "himself", "herself", "themselves", "ourselves", "etcetera", "as", "where", "huh", "said", "says",
         "saying", "means", "meant")
    ),
    "de": frozenset(
        ("oder", "entweder", "jemand", "jemanden", "irgendwen", "irgendjemanden", "bevor", "nachdem", "zweimal",
         "dreimal", "viermal", "mal", "einmal", "immer", "oft", "selten", "manchmal", "jemals", "irgendwo",
         "irgendwohin", "überall", "nirgends", "woanders", "später", "nachher", "irgendwann", "demnächst", "neulich",
         "vorhin", "morgens", "vormittags", "mittags", "nachmittags", "abends", "nachts", "montags", "dienstags",
         "mittwochs", "donnerstags", "freitags", "samstags", "sonntags", "sagt", "sagte", "gesagt", "heißt",
         "bedeutet")
    ),
    "fr": frozenset(("ou", "soit", "avant", "après")),
    "es": frozenset(("o", "u", "antes", "después")),
    "it": frozenset(("o", "oppure", "prima", "dopo")),
}  # fmt: skip
"""Not one thing, or none that anybody could know; no thing but when and how often: "the cup after lunch"; or what is
said of the sentence: "the cup, said Tom"."""
NO_BARE: Mapping[str, frozenset[str]] = {
    "en": frozenset(
        ("up", "down", "off", "out", "back", "along", "away", "together", "apart", "through", "forth", "rid", "used",
         "married", "divorced", "engaged", "busy", "dressed", "undressed", "drunk", "sober", "angry", "mad", "jealous",
         "serious", "real", "rich", "poor", "well", "better", "worse", "sick", "tired", "bored", "hungry", "thirsty",
         "stuck", "started", "done", "finished", "case", "theory", "practice", "general", "fact", "private", "public",
         "vain")
    ),
    "de": frozenset(("frei", "teil")),
}  # fmt: skip
"""No name begins so without an article: "get married", "take back control", "in case of fire", but "the used cup",
"the back wheel"."""
NO_HANDFUL: Mapping[str, frozenset[str]] = {
    "en": frozenset(
        ("action", "advantage", "charge", "charges", "comfort", "command", "control", "courage", "credit", "effect",
         "effort", "end", "exception", "heart", "help", "hold", "inspiration", "issue", "joy", "love", "luck",
         "mind", "offense", "past", "peace", "place", "pleasure", "possession", "power", "pressure", "pride",
         "refuge", "responsibility", "revenge", "root", "roots", "sake", "shape", "shelter", "sides", "sleep",
         "state", "strength", "sunshine", "thoughts", "truth", "meaning", "lies", "word", "wrong", "writing", "risk",
         "point", "space", "spirits", "worries", "ego", "law", "language", "habit", "benefit", "doubt", "creeps",
         "blame", "attitude", "act", "beat", "bass", "hint", "hints", "plunge", "bait", "slack", "bet", "job",
         "life", "grip", "haircut", "bath", "shower", "party", "internet", "spelling", "database", "password",
         "boil", "vote", "test", "court", "close", "touch", "mess", "hotel", "exit", "stairs", "subway", "bus",
         "hands", "hand", "head", "eyes", "feet", "mouth", "finger", "fingers", "face", "smile", "kid", "kids",
         "baby", "child", "children", "husband", "wife", "boss", "manager", "police", "policeman", "doctor",
         "lawyer", "plumber", "signal", "cue", "afternoon", "fun", "dream", "dreams", "joke", "example", "instance",
         "granted", "attention", "opinion", "opinions", "tension", "anger", "fear", "fears", "mood", "temper", "curse",
         "ban", "opportunity", "opportunities", "trouble", "troubles", "heat", "clue", "drift", "exercise", "air",
         "compliment", "limit", "limits", "use", "fire", "difference", "differences", "conversation", "scent",
         "argument", "arguments", "feeling", "feelings", "hope", "hopes", "chance", "chances", "voice", "chills",
         "win", "victory", "deal", "decision", "decisions", "initiative", "interest", "measures", "precautions",
         "notice", "stance", "oath", "pain", "relief", "satisfaction", "approval", "permission", "support", "closure",
         "justice", "success", "happiness", "sadness", "sense", "nonsense", "reason", "reasons", "excuse", "excuses",
         "apology", "blessing", "regards", "greetings", "trust", "faith", "respect", "honor", "glory", "fame",
         "memory", "memories", "future", "tone", "standards", "expectations", "stakes", "daily", "weekly", "monthly",
         "hourly")
    ),
    "de": frozenset(
        ("anlauf", "anstoß", "einfluss", "fahrt", "glück", "kontakt", "kredit", "maß", "mut", "ordnung", "rache",
         "reißaus", "schaden", "zuflucht", "polizei", "arzt", "chef", "kind", "kinder", "bahn", "treppe", "ausfahrt",
         "bad", "dusche", "essen", "arbeit", "schule", "thema", "kochen", "ende", "punkt", "chaos", "schuld", "wort",
         "adresse", "nummer", "rechtschreibung", "kontostand", "wahrheit", "fehler", "hand", "hände", "kopf",
         "beine", "finger", "augen", "mund", "rücken", "hosen", "sache", "tag", "woche", "monat", "jahr", "nächsten",
         "zeichen", "kommando", "notfall", "spaß", "scherz", "traum", "träumen", "beispiel", "gelegenheit", "chance",
         "kampf", "job", "hoffnung", "vergangenheit", "zukunft", "bemerkung", "weite", "lösung", "fakten", "stimmung",
         "freude", "angst", "wut", "meinung", "aufmerksamkeit", "entscheidung", "erlaubnis", "vertrauen", "geduld",
         "gefühl", "gefühle", "erfolg", "wahl", "grund", "ausrede")
    ),
}  # fmt: skip
"""People, what becomes of them, and what nobody can hold: "take charge", "put the kids to bed", "take a bath". With a
word behind them they are about a thing: "control panel", "baby bottle", "bath towel"."""
_MANNER: Mapping[str, re.Pattern[str]] = {
    "en": re.compile(
        r"\w{2,}(?:ally|ully|ously|ently|antly|edly|ingly|ickly|tely|rely|isely|udly|owly|ietly|ptly|iftly|ftly|arly|"
        r"ably|ibly|ively|[sc]tly|ightly)"
    ),
    "de": re.compile(r"\w{2,}(?:lich|weise)"),
}
"""Words that say how something is done, or what is thought of it, as a name does not end: "the cup carefully", "the cup
seriously". "Family", "assembly" and "butterfly" are no such words."""
THINGS_ALONE: Mapping[str, frozenset[str]] = {
    "en": frozenset(("it", "them", "him", "everything", "everyone")),
    "de": frozenset(("es", "ihn", "alles", "alle")),
}
"""A name of their own, that goes on with where a thing is and nothing else: "it slow" and "it done" are no things."""
_IN_THE_MIDDLE: Mapping[str, frozenset[str]] = {
    "en": frozenset(("the", "a", "an", "my", "our", "your")),
    "de": frozenset(("die", "das", "den", "ein", "eine", "einen", "mein", "meine", "meinen")),
}
"""Articles before which another thing begins, unless a word binds them to the one before: "the cup, the plate"."""
_BINDING: Mapping[str, frozenset[str]] = {
    "en": frozenset(("of", "all", "both", "half", "that", "like", "next", "off", "up", "down", "out")),
    "de": frozenset(("alle", "beide", "wie")),
}
_TELLS: Mapping[str, frozenset[str]] = {"en": frozenset(("is", "are", "isnt", "arent"))}
"""Words that say something of a thing: "the cup is red", but "the cup that is red". In German they are closed."""
TIMED: Mapping[str, frozenset[str]] = {"en": frozenset(("at", "by")), "de": frozenset(("um", "gegen"))}
"""Words between a thing and the time when it is wanted."""
_COUNTING = NUMBER_WORDS | {"couple", "pair"}
_AMOUNTS = ("distance", "angle", "duration", "speed", "percent")
ALONE: Mapping[str, frozenset[str]] = {
    "en": frozenset(("a", "on", "over", "up", "down", "off", "out", "in", "back", "along", "to", "from", "at", "with"))
}
"""By itself no thing: "carry on to the lab" carries nothing, "on" is a part of the verb."""


class FreeText:
    """The free words of one grammar's slots."""

    def __init__(self, grammar: Grammar) -> None:
        # Single words of these are closed to free slots already; phrases are only seen whole.
        self._language = grammar.language
        operators = grammar.operators
        changing = (
            *operators.stop, *operators.negation, *operators.correction, *operators.cancel, *operators.sequence,
        )  # fmt: skip
        self._operators = PhraseSet(words for words in changing if len(words) > 1)
        self._fillers = PhraseSet(grammar.fillers)
        self._articles = ARTICLES_IN.get(grammar.language, ARTICLES)
        self._no_thing = NO_THING.get(grammar.language, frozenset())
        self._no_beginning = self._no_thing - MAY_BEGIN.get(grammar.language, frozenset())
        self._no_bare = NO_BARE.get(grammar.language, frozenset())
        self._no_handful = NO_HANDFUL.get(grammar.language, frozenset())
        self._never_in = NEVER_IN.get(grammar.language, frozenset())
        self._alone_things = THINGS_ALONE.get(grammar.language, frozenset())
        self._tells = _TELLS.get(grammar.language, frozenset())
        self._in_the_middle = _IN_THE_MIDDLE.get(grammar.language, frozenset())
        self._binding = self._no_thing | self._articles | _BINDING.get(grammar.language, frozenset())
        self.unfinished = UNFINISHED.get(grammar.language, frozenset())
        """Words that are never the last."""
        self.alone = self.unfinished | ALONE.get(grammar.language, frozenset())
        """Words that are never the only one."""

    def unfinished_in(self, slot: Slot) -> frozenset[str]:
        """Words that are never the last in a slot."""
        return (self.unfinished | self._no_thing | self._no_bare) - slot.known if slot.known else self.unfinished

    def problem(self, slot: Slot, words: Sequence[str], start: int, end: int) -> str:
        """Why the words from ``start`` to ``end`` are nothing for a slot; empty: they may be."""
        said = words[start:end]
        wrong = slot.without.intersection(said)
        if said and slot.known and said[0] in self._no_beginning - slot.known - slot.allow:
            wrong = frozenset((said[0],))
        if said and slot.known and not wrong:
            wrong = self._no_name(slot, said)
        # One that begins here, wherever it ends: "down, change that to" holds the beginning of "change that to".
        if self._operators.may_stand_in(said):
            operator = next(((at, n) for at in range(start, end) if (n := self._operators.at(words, at))), None)
            phrase = words[operator[0] : sum(operator)] if operator is not None else ()
            if not slot.allow.issuperset(phrase):
                wrong = frozenset((" ".join(phrase),))
        return f"{min(wrong)!r} is nothing for slot {slot.name!r}" if wrong else ""

    def _no_name(self, slot: Slot, said: Sequence[str]) -> frozenset[str]:
        """The word that shows that words are not the name of one thing, in a slot that lists things."""
        allowed = slot.allow
        if never := self._never_in.intersection(said) - allowed - slot.known:
            return never
        if said[0] in self._no_bare - allowed and (len(said) > 1 or said[0] not in slot.known):
            return frozenset((said[0],))
        for place in range(1, len(said)):
            word = said[place]
            if said[place - 1] in self._alone_things and word not in self._no_thing | allowed:
                return frozenset((word,))
            if word in self._tells and said[place - 1] not in self._binding:
                return frozenset((word,))
            last = place == len(said) - 1  # "box a" has a letter
            if word in self._in_the_middle and not last and said[place - 1] not in self._binding:
                return frozenset((word,))
        return frozenset()

    def is_unfinished(self, slot: Slot, said: Sequence[str], start: int) -> bool:
        """Whether the words are only the beginning of a thing's name: for patterns; the automaton ends nothing so."""
        if slot.dictation and self._fillers.cover(said):
            return True  # "take a note, please"
        alone = list(said) == ["a"] and start > 0  # "ticket a" has a letter
        return (alone or said[-1] in self.unfinished_in(slot)) and said[-1] not in slot.allow

    def no_handful(self, slot: Slot, said: Sequence[str]) -> str:
        """The word of a whole name that says that no thing is meant, in a slot that lists things; empty: none does."""
        if not slot.known:
            return ""
        following = (*said[1:], "")
        return next(
            (
                word
                for word, after in zip(said, following, strict=True)
                if (word in self._no_handful or self._is_manner(word))
                and word not in slot.known | slot.allow
                and (not after or after in self._no_thing)
            ),
            "",
        )

    def _is_manner(self, word: str) -> bool:
        manner = _MANNER.get(self._language)
        return manner is not None and manner.fullmatch(word) is not None

    def is_amount(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether the words say only how much or how many, in a slot that lists things: "take five", "two meters".

        A coin may be called a quarter, so a fraction is none; "that one" is a thing that was named before. A name that
        ends with a time is an amount as well, "the cup at three"; so is a count before "to" or the like: "five to the
        library".
        """
        if slot.known and len(said) > 2 and said[-2] in TIMED.get(self._language, ()) and self._counts(said[-1]):
            return True
        if not slot.known or not any(map(self._counts, said)):
            return False
        end = next((place for place, word in enumerate(said) if place and word in self._no_thing), len(said))
        said = said[:end]
        bare = self._without_articles(said)
        for words in (said, bare) if len(bare) < len(said) else (said,):
            if any(quantities.evaluate(words, kind, self._language) is not None for kind in _AMOUNTS):
                return True
            count = quantities.evaluate(words, "number", self._language)
            if isinstance(count, float) and count.is_integer() and (count != 1 or words is said):
                return True
        return False

    def _counts(self, word: str) -> bool:
        """A quick look: whether a word may be one of a number."""
        if self._language == "en":
            return word in _COUNTING or word[:1].isdigit()
        return word[:1].isdigit() or quantities.is_number_word(word, self._language)

    def _without_articles(self, words: Sequence[str]) -> Sequence[str]:
        while len(words) > 1 and words[0] in self._articles and not _is_code(words):
            words = words[1:]
        return words

    def thing(self, slot: Slot, said: Sequence[str]) -> str:
        """The name without its articles, in one word where the slot lists it so ("screw driver"), and with its accents
        ("jose"). What is dictated is no name."""
        words = list(said)
        if slot.dictation:
            return " ".join(words)
        if accented := _accented(slot.known):
            words = [accented.get(word, word) for word in words]
        words = list(self._without_articles(words))
        for place in range(len(words) - 2, -1, -1):
            if (whole := "".join(words[place : place + 2])) in slot.known:
                words[place : place + 2] = [whole]
        return " ".join(words)


def _is_code(words: Sequence[str]) -> bool:
    """Whether words begin with a letter that is no article: "a 42"."""
    return len(words[0]) == 1 and is_numeral(words[1])


@lru_cache(maxsize=64)
def _accented(known: frozenset[str]) -> Mapping[str, str]:
    """Words with accents, by the same without."""
    return {plain: word for word in sorted(known) if (plain := without_accents(word)) not in known}
