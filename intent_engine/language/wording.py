"""How people of a language put what they want: the words that a grammar file leaves to its language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Wording"]

_NONE = PhraseSet(())


@dataclass(frozen=True, slots=True)
class Wording:
    """How people of a language put what they want: no operators, but what tells how a sentence with them is meant."""

    greetings: tuple[tuple[str, ...], ...] = ()
    """What may be dictated though it is nothing but fillers: "say hello"."""
    thanking: PhraseSet = _NONE
    """What thanks, and makes an answer to somebody of a "no" before it: "no, *thanks*"."""
    hesitations: tuple[tuple[str, ...], ...] = ()
    """Fillers behind which something may be said anew: "left, uh, right"."""
    at_first: PhraseSet = _NONE
    """What says nothing behind the first of several commands: "close the door *first*, then start"."""
    for_each: PhraseSet = _NONE
    """What says behind a list that the rest holds for each: "for ten minutes *each*"."""
    both_of: PhraseSet = _NONE
    """What says before two things that both are meant: "*both* the cup and the plate"."""
    done_again: PhraseSet = _NONE
    """What asks by itself for what was done last, once more: "*do it again*"."""
    turns_to: PhraseSet = _NONE
    """What begins a text that goes on from the one before with another thing: "*now* the fan"."""
    leads: frozenset[str] = frozenset()
    """Prepositions of how something is done, which may be said before the verb: "*for* ten minutes water the beds"."""
    says_when: frozenset[str] = frozenset()
    """Those that say when before a time: "*in* ten minutes", but "*in* German"."""
    besides: PhraseSet = _NONE
    """What says nothing behind a command but that it is done besides: "turn on the lamp *as well*"."""
    no_joints: tuple[tuple[str, ...], ...] = ()
    """What begins like a joint and is none: "*next to* the door"."""
    at_times: PhraseSet = _NONE
    """What says how often where an utterance begins or ends, though its words may say nothing: "*now and then*"."""
    in_its_place: PhraseSet = _NONE
    """What says nothing behind a command but that it takes the place of another: "go to the bedroom *instead*"."""
    ways_back: PhraseSet = _NONE
    """What is backward, or the way back, where it stands behind a way: "to the kitchen and back"."""
    asks_for_doing: tuple[tuple[str, ...], ...] = ()
    """What asks for what a verb says behind it that ends in "-ing": "*would you mind* locking the door","""
    asks_to_do: tuple[tuple[str, ...], ...] = ()
    """and what does where the verb follows itself: "*would you be so kind as to* lock the door"."""
    asked: frozenset[str] = frozenset()
    """Words of people, behind the verb of a command that is a question as well: "gehen *Sie* in die Küche?"."""
    requests: frozenset[str] = frozenset()
    """Verbs with which people ask for something, and whose own verb may stand last: "*kannst* du links abbiegen?"."""
    agrees: frozenset[str] = frozenset()
    """Commands that say nothing where a pause and another command follow: "right, go forward"."""
    agreeing: tuple[tuple[str, ...], ...] = ()
    """Words that agree, beside which one of those says nothing either ("yeah right"), and which may be an answer or a
    message: "tell Anna okay"."""
    compares: frozenset[str] = frozenset()
    """Words of negations that compare ("in place of"), which join what a sentence has them between."""
    before_verbs: frozenset[str] = frozenset()
    """Words between a negation and the verb that it is of: "sans s'arrêter", "ohne zu bremsen"."""
    verb_follows: frozenset[str] = frozenset()
    """Words at the end of a filler from which a clause may go on with a verb: "if you *can*" turn left."""
    fillers_apart: tuple[tuple[str, ...], ...] = ()
    """Fillers that are a condition where anything goes on from them in one breath; none that a file has of its own."""
    adds: frozenset[str] = frozenset()
    """Words with which a joint begins that leaves what follows in the same clause: "and"."""
    of_speed: frozenset[str] = frozenset()
    """Words behind which a percentage is of the speed: "turn left *at* ninety percent"."""
    negated: tuple[tuple[str, ...], ...] = ()
    """How a negated command begins in speech, besides the negation itself: "do not"."""
    forbidding: tuple[tuple[str, ...], ...] = ()
    """The usual ways of these and of negations, for finding what was probably said."""
    before_negations: tuple[tuple[str, ...], ...] = ()
    """What may stand before a negation with which an utterance begins: "*please* don't turn left, turn right"."""
    behind_verbs: tuple[tuple[str, ...], ...] = ()
    """Negations that stand behind the first words of a command: "dreh dich *nicht* nach links"."""
    excludes: frozenset[tuple[str, ...]] = frozenset()
    """Negations that, behind a whole command, only name what is not meant by a part of it: "turn left, *not* right"."""
    excludes_apart: frozenset[tuple[str, ...]] = frozenset()
    """Those that do so before a whole command, and behind one only apart from it, as in its breath they forbid it:
    "nimm den Taster, *nicht* den Bohrer"."""
    may_forbid: frozenset[str] = frozenset()
    """Corrections that forbid what follows in one breath: "*no* turn left", but "no, turn left"."""
    none_of: frozenset[str] = frozenset()
    """Those of them that also say that a thing is not wanted: "with milk, *no* sugar"."""
    alternatives: frozenset[str] = frozenset()
    """Words before another one of something: "tell Anna *or* Tom"."""
    leaves_open: frozenset[str] = frozenset()
    """Words that make another meaning of a command wherever they stand: "*at most* two", "this *or* that"."""
    ranging: frozenset[str] = frozenset()
    """Words between two numbers of which any between is meant: "two *to* four"."""
    affirming: PhraseSet = _NONE
    """Answers that say yes to what is asked back."""
    declining: PhraseSet = _NONE
    """Answers that say that nothing of it is meant: "no", "neither"."""
    standing_for: frozenset[str] = frozenset()
    """Words for one of several things, behind what tells which: "the left *one*"."""
    placed: PhraseSet = _NONE
    """What says where something is, and not where it is to go: "die Lampe *im* Flur", but "in den Flur"."""
    stands_for_noun: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Words for a noun that was named before, each with its articles: "la puerta de entrada y *la* de salida"."""
    several: frozenset[str] = frozenset()
    """Pronouns for more than one thing: "them"."""
    there: PhraseSet = _NONE
    """What points to the place that the command before names, with its last word: "from *there*"."""
    there_at_last: PhraseSet = _NONE
    """What says behind a whole command that it is done where the one before it went: "drop it *there*"."""
    of_persons: frozenset[str] = frozenset()
    """Pronouns for somebody who was named before, in the same utterance: "focus on the actor and follow *him*"."""
    denying: frozenset[str] = frozenset()
    """Words behind a verb that only complete the negation before it: "ne va *pas* à la cuisine"."""
    forbidden: tuple[tuple[str, ...], ...] = ()
    """How verbs are forbidden, the form and the verb as it is told: "andare", "vai"; "-are", "-a" of any verb."""
    formal: tuple[str, ...] = ()
    """How a command is told to a stranger, and how to a friend: "-en sie/-e"."""
    asking: tuple[str, ...] = ()
    """How a friend is asked for something, and how it is told: "-st du/-e", "-es/-a"."""
    kindly: PhraseSet = _NONE
    """Fillers that make an order of such a question: "schaltest du *bitte* die Pumpe ein?"."""
    told_as: tuple[str, ...] = ()
    """How else a verb may be told that ends so: "-e/-", "hole" for "hol"."""
    vowels: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Vowels of a verb, each with those that it has where it is told: "r*e*gar", "r*ie*ga"."""
    joined: frozenset[str] = frozenset()
    """Words for whom something is done that are written with the verb: "apága*me* la bomba"."""
    points: frozenset[str] = frozenset()
    """Words that point to a thing, as its article would: "*that* vial", "*your* horn"."""
    wholes: PhraseSet = _NONE
    """What may stand before an article of all that there is: "*all* the carts", "*all of* that clay"."""
    sides: tuple[str, ...] = ()
    """Words for one way, each with the others for it: "left/to the left"."""
    up_to: frozenset[str] = frozenset()
    """Which way something goes until it is so much: "*up* to ten percent","""
    in_to: frozenset[str] = frozenset()
    """and behind a verb that has it: "zoom *in* to ten percent"."""
    sized: frozenset[str] = frozenset()
    """What may stand behind how long something is: "two meters *deep*"."""
    levels: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Verbs of what something is set to, each with the prepositions that say the same there: "*at* two bar"."""
    led_by: frozenset[str] = frozenset()
    """Words before how far something is to go, which may be left out: "turn left *by* thirty degrees"."""
    lasting: frozenset[str] = frozenset()
    """The same before how long something takes: "soak it *for* ten minutes"."""
    lasting_behind: frozenset[str] = frozenset()
    """Words behind how long something takes: "zwei Minuten *lang*"."""
    coming: frozenset[str] = frozenset()
    """What says no more between these with an article and how long: "for the *next* two hours"."""
    how_often: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """How often something is done in one word, each with the words for it: "twice", "two times"."""
    sizes: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Words between a size and how much it is, each with such sizes: "a *depth* of ten meters"."""
    idle_particles: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Verbs with what may belong to them and says no more than they do: "heat *up* the flask"."""
    switched: frozenset[str] = frozenset()
    """What ends an order without a verb: "lights *on*"."""
    switching: frozenset[str] = frozenset()
    """Verbs that say no more than these words do: "*turn* the lights on"."""
    wishes_for: PhraseSet = _NONE
    """What somebody says who wants a thing: "*could I get* a mojito"."""
    takes_along: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Those that tell what somebody does himself, each with the words that say so: "*I'll take* the tea *to* her"."""
    wishes_done: tuple[tuple[str, ...], ...] = ()
    """What somebody says who wants something done: "*I want* the beacon turned on","""
    to_be: PhraseSet = _NONE
    """and what may stand before the verb there: "*to be* turned on"."""
    permits: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """How somebody tells what may be done, each with the fillers that make an order of it: "*you can* land *now*","""
    pleads: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """and how he asks whether it may: "*can we* start, *please*?"."""
    tells_of_it: PhraseSet = _NONE
    """How somebody begins to tell why something is to be done: "*it is* dark, turn the lamp on","""
    tells_of: PhraseSet = _NONE
    """how he does of others than "it": "*I am* tired","""
    tells_of_whom: frozenset[str] = frozenset()
    """of somebody, with such a verb behind: "*they* look hungry","""
    tells_of_a: frozenset[str] = frozenset()
    """what may stand before a thing of which he tells: "*my* feet are cold","""
    tells_how: frozenset[str] = frozenset()
    """and the verb behind it: "my feet *are* cold"."""
    somewhat: PhraseSet = _NONE
    """What may stand before how something is, and names no thing: "it's *a bit* cold"."""
    tells_fully: frozenset[str] = frozenset()
    """Those with which all may be told: "die Gäste *warten*","""
    tells_who: frozenset[str] = frozenset()
    """also of these instead of a thing: "*hier* staubt es"."""
    tells_alone: PhraseSet = _NONE
    """What tells all by itself: "*llueve*", "*piove*"."""
    tells_can: frozenset[str] = frozenset()
    """Words with which that tells that something may wait, the verb being the same: "die Gäste *können* warten"."""
    perceives_none: PhraseSet = _NONE
    """What tells that nothing is seen or heard, and denies nothing: "*on n'entend rien*"."""
    tells_a_tale: frozenset[str] = frozenset()
    """Words with which the same tells no reason: "he is *saying* turn left"."""
    why: PhraseSet = _NONE
    """What says before such a telling that it is a reason: "*because* it's dark","""
    thinks: PhraseSet = _NONE
    """what says there that somebody thinks so: "*I think* it's dark","""
    why_apart: PhraseSet = _NONE
    """what does behind a pause, where in one breath some of it tells which is meant: "la puerta, *que* hace frío","""
    why_of: PhraseSet = _NONE
    """before a thing, or what is done then: "*because of* the trees", "*damit ich* etwas sehe","""
    why_to: PhraseSet = _NONE
    """and, behind a pause or a filler, before what can be done then: "so that *I can* see"."""
    merely: PhraseSet = _NONE
    """What says no more before so much: "go *just* two meters", "to, *let's say*, two"."""
    roughly: PhraseSet = _NONE
    """What says no more behind so much: "for a minute *or so*"."""
    ways_on: frozenset[str] = frozenset()
    """Words before one of ``ways_to`` and a place that say no more of the way: "*over* to the lab"."""
    puts: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Verbs, each with words that say no more before one of ``back_into``: "put it *down* in the tray"."""
    brings: frozenset[str] = frozenset()
    """Verbs behind which a thing of any words ends with none of these: "bring an ice bucket *up* to room 412"."""
    back_into: frozenset[str] = frozenset()
    """Prepositions of where something is put, before which the way back says no more: "put it *back* on the shelf"."""
    ways_to: frozenset[str] = frozenset()
    """Prepositions of where a way goes."""
    places_alone: frozenset[str] = frozenset()
    """Places that need none of them: "take me *home*"."""
    parted: tuple[str, ...] = ()
    """What is parted from a verb where somebody does something ("hebt *auf*"), and begins its infinitive."""
    adverbs: tuple[tuple[str, ...], ...] = ()
    """Words of order that may stand behind the verb of a command: "fahr *dann* in die Küche"."""
    gives: frozenset[str] = frozenset()
    """Verbs of what is done for somebody, where others are done to him: "*bring* me a cup", but "turn me round". None:
    the language has other words for the one and the other."""
    for_whom: frozenset[str] = frozenset()
    """Words behind a verb for whom something is done, which change nothing of it: "hol *mir* die Zange"."""
    others: PhraseSet = _NONE
    """Others, for whom something may be done that a grammar knows: "fold the towels for *them*","""
    other_people: frozenset[str] = frozenset()
    """the same with an article: "for the *kids*","""
    seeks: frozenset[str] = frozenset()
    """and verbs behind which they are what is looked for: "*search* the tank for them"."""
    for_whom_before: frozenset[str] = frozenset()
    """The same before a verb that is no order: "tu peux *m*'apporter la pelle"."""
    softens: PhraseSet = _NONE
    """Words behind a verb that soften the order and say nothing of it: "avvia *pure* il programma"."""
    hurries: tuple[tuple[str, ...], ...] = ()
    """Words there that only urge to be quick, of a grammar that has no such word: "va *vite* à la cuisine"."""
    vaguely: PhraseSet = _NONE
    """Words there that say nothing beside an amount: "tourne *un peu* de dix degrés"."""
    urges: PhraseSet = _NONE
    """Words at the end of an order that only urge: "abre la puerta, *anda*"."""
    namely: PhraseSet = _NONE
    """Words behind a pause with which an order goes on: "gieß die Blumen, *und zwar* mit zwei Litern"."""
    taken_up: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Articles, each with the pronouns for what it stands before: "*la* palette, descends-*la*"."""
    joined_short: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Short forms of verbs, behind which what is joined begins with its letter twice, each with the verb as it is told
    alone: "*fa*mmi", "fai"."""
    joined_first: frozenset[str] = frozenset()
    """Forms of ``joined`` that such a pronoun follows: "porta*me*la"."""
    once_more: PhraseSet = _NONE
    """Words behind a verb that say that it was so before: "mach das Licht *wieder* an"."""
    wishing: PhraseSet = _NONE
    """Fillers behind which the verb stands last, as what somebody does: "*ich möchte dass du* den Ball aufhebst"."""
    wonders: PhraseSet = _NONE
    """Words that ask whether somebody can, right behind those that request: "kannst du *eigentlich* links abbiegen"."""
    begging: PhraseSet = _NONE
    """Fillers behind which it stands last with a "zu": "*ich bitte dich*, den Ball aufzuheben"."""
    wished: tuple[tuple[str, ...], ...] = ()
    """How such a verb ends, and its infinitive: "nimmst", "nehmen"; "-st", "-en"."""
    particles: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """What a verb may have straight behind it, and behind what it is done to: "turn *on* the lamp", "turn the lamp
    *on*"."""
