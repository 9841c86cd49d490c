"""What people get wrong in grammar files. What they are told is in ``golden/grammar_mistakes.txt``."""

from __future__ import annotations


def wave(*lines: str, before: str = "") -> str:
    """A grammar with one intent of its own, whose last lines are given."""
    head = f"language: en\n{before}intents:\n  wave:\n    action: {{type: custom, name: wave}}\n"
    return head + "".join(f"    {line}\n" for line in lines)


def says(sentence: str, before: str = "") -> str:
    return wave("sentences:", f"  - '{sentence}'", before=before)


def slot(spec: str, sentence: str = "wave {it}") -> str:
    return says(sentence, f"slots:\n  it: {spec}\n")


def move(*lines: str, action: str = "move", sentence: str = "'go {direction} [{distance}] [at {speed}]'") -> str:
    head = (
        "language: en\nslots:\n  direction: {values: [forward, backward]}\n"
        "  distance: {type: distance, min: 0.1 m, max: 5 m}\n  speed: {type: speed, max: 1 m/s}\n"
        f"intents:\n  move:\n    action: {action}\n    sentences:\n      - {sentence}\n"
    )
    return head + "".join(f"    {line}\n" for line in lines)


MISTAKES: dict[str, str | bytes] = {
    # -- brackets and signs of sentences
    "a bracket that is never closed": says("wave (at|to"),
    "a bracket that closes nothing": says("wave at)"),
    "brackets that cross": says("wave (at]"),
    "an empty alternative": says("wave (at||to)"),
    "a slot and its second name the other way round": says("wave {far:way}", "slots:\n  way: distance\n"),
    "two slots and their second names the other way round": says(
        "wave {from:way} {to:way}", "slots:\n  way: distance\n"
    ),
    "a percentage as a plain number": slot("{type: percent, min: 0, max: 80}"),
    "a part of one where numbers are percent": slot("{type: percent, max: 1, unit: percent}"),
    "a unit of a number that has none": slot("{type: number, unit: degrees}"),
    "what is said of a unit, with brackets and without quotes": slot("{type: number, units: {1: (euro|euros) [each]}}"),
    "slots of an intent": wave("slots: {way: up}", "sentences: [wave]"),
    "units with their sizes behind them": slot("{type: number, units: {euro: 1, cent: 0.01}}"),
    "a speed as a plain number that is none": move("defaults: {speed: 50}"),
    "a turning speed in degrees": (
        "language: en\nintents:\n  spin:\n    action: {type: turn, direction: left, speed: 90}\n    sentences: [spin]\n"
    ),
    "a file that holds nothing": "null\n",
    "quotes of a word processor": says("wave", "").replace("'wave'", "[\u201cwave [at {it}]\u201d]"),
    "a quote that a word processor closes": says("wave").replace("'wave'", '"wave\u201d'),
    "a quote that is closed lines below": wave(
        "sentences:", '  - "wave', "  - bow", "examples:", '  - "wave": {}', '  - "bow": {}'
    ),
    "a quote that is closed lines below, in brackets": wave(
        "description: 'all of it'", 'sentences: ["wave]', 'examples: [{"wave": {}}]'
    ),
    "a colon of a Chinese keyboard": wave("sentences: [wave]").replace("language:", "language\uff1a"),
    "a colon of a Japanese keyboard in an intent": wave("sentences\uff1a[wave]", "priority: 1"),
    "a merge conflict": wave(
        "<<<<<<< HEAD", "sentences: [wave]", "=======", "sentences: [bow]", ">>>>>>> theirs"
    ).replace("    <<<<<<<", "<<<<<<<"),
    "a sentence with a colon before a slot": wave("sentences:", "  - look: {side}"),
    "a sentence in braces that are YAML's": wave("sentences: {side: up}"),
    "a sentence that is a slot alone, unquoted": wave("sentences: {side}"),
    "sections of an INI file": "; of another engine\n[Light]\nlight = on | off\nturn <light> the lamp\n",
    "sentences of an INI file": "[Light]\nturn (on | off){state} the lamp\n",
    "a context of Rhino": "context:\n  expressions:\n    order:\n      - make me a $drink:drink\n",
    "training data of Rasa": "version: '3.1'\nnlu:\n- intent: greet\n  examples: |\n    - hey\n",
    "the keys of Home Assistant": (
        "language: en\nintents:\n  HassTurnOn:\n    data:\n      - sentences: [turn on <name>]\n"
        "lists: {name: {values: [lamp]}}\nexpansion_rules: {turn: (turn|switch)}\nskip_words: [please]\n"
    ),
    "a shipped grammar by the path of the repository": says("wave", "include: [grammars/en.yaml]\n"),
    "degrees and percent in examples": (
        "language: en\nslots: {side: [left, right], far: angle, share: percent}\nintents:\n  spin:\n"
        "    action: custom\n    sentences: ['spin [{side}] {far} [at {share}]']\n    examples:\n"
        "      - spin left ninety degrees: {side: left, far: 90}\n"
        "      - spin ninety degrees at ten percent and left five degrees:\n"
        "          {steps: [{far: 90 deg, share: 10}, {side: left, far: 5 deg}]}\n"
    ),
    "an alternative without brackets that is empty": says("|wave"),
    "an empty optional": says("wave []"),
    "empty braces": says("wave {}"),
    "a name of two words": says("wave {my slot}"),
    "a semicolon outside brackets": says("wave; hand"),
    "either and any order in the same brackets": says("(wave;nod|bow)"),
    "a semicolon behind a bracket with alternatives": says("(wave|nod); now"),
    "seven parts in any order": says("(a;b;c;d;e;f;g)"),
    "forty-one brackets": says("(" * 41 + "wave" + ")" * 41),
    "the angles of another template language": says("wave at <name>"),
    "the dollar of another template language": says("wave at $name"),
    "what may be left out as in regular expressions": says("wave (at)? hand"),
    "a group of a regular expression": says("wave (?:the )?hand"),
    "a named group of a regular expression": says("wave (?P<thing>.+)"),
    "a star for repetition": says("wave (again)*"),
    "an underscore in a word": says("wave_hand"),
    "punctuation alone": says("wave ..."),
    "a sentence of spaces": says("  "),
    "a sentence without a necessary word": says("[wave] [hand]"),
    "a sentence of free text alone": slot("{type: text}", "[please] {it}"),
    "the same slot twice in a sentence": slot("{type: text}", "from {it} to {it}"),
    "units of another language than English": (
        "language: de\nslots:\n  it: {type: angle, max: 90 Grad, unit: grad}\n"
        "intents:\n  wave: {action: custom, sentences: ['wink {it}']}\n"
    ),
    # -- names
    "a misspelt slot": says("wave at {persn}", "slots:\n  person: text\n"),
    "a misspelt phrase inside a phrase": says("{greet}", "phrases:\n  hi: (hi|hello)\n  greet: '{hii} there'\n"),
    "nothing is defined": says("wave at {person}"),
    "a slot inside a value of a slot": says("wave {how}", "slots:\n  who: text\n  how: {values: {at: 'at {who}'}}\n"),
    "a phrase with a second name": says("{hi:hello}", "phrases:\n  hi: (hi|hello)\n"),
    "a phrase that holds itself": says("{a}", "phrases:\n  a: 'x [{a}]'\n"),
    "phrases in a circle": says("{a}", "phrases:\n  a: 'x {b}'\n  b: 'y {c}'\n  c: 'z [{a}]'\n"),
    "a slot named like a phrase": says("{it}", "phrases:\n  it: this\nslots:\n  it: text\n"),
    "a name with a space": "language: en\nintents:\n  my wave: {action: stop, sentences: [wave]}\n",
    # -- YAML
    "YAML's yes, no and on": wave("sentences: [yes, no, on]"),
    "YAML's no as the language": says("wave").replace("language: en", "language: no"),
    "YAML's yes in a choice": slot("{values: {agree: [yes, yeah], refuse: [no]}}"),
    "a number for a sentence": wave("sentences: [42]"),
    "nothing for a sentence": wave("sentences:", "  - wave", "  -"),
    "nothing for the sentences": wave("sentences:"),
    "an empty sentence": wave("sentences: ['']"),
    "several sentences as one text": wave("sentences: wave, bow"),
    "sentences on lines without a dash": wave("sentences:", "  wave", "  bow"),
    "sentences as a text of several lines": wave("sentences: |", "  wave", "  bow"),
    "a colon in a sentence": wave("sentences:", "  - wave: at me"),
    "a sentence that begins with a brace": wave("sentences:", "  - {go} there"),
    "a sentence that begins with a bracket": wave("sentences:", "  - [please] wave"),
    "a phrase that begins with a bracket": says("{it} there", "phrases:\n  it: [the] (cup|box)\n"),
    "a slot without quotes in a list on one line": wave("sentences: [bow, wave {person} over]"),
    "a quote that is never closed": wave("sentences:", '  - "wave', "  - bow"),
    "a bracket of YAML that is never closed": wave("sentences: [wave, bow"),
    "a tab": "language: en\nintents:\n\twave: {}\n",
    "a line that is indented too far": "language: en\nintents:\n  wave:\n    action: stop\n     sentences: [wave]\n",
    "commas that were to part a value": slot("{values: left, right, straight on}"),
    "a slot without quotes in an action": wave("sentences: [wave]").replace("name: wave", "name: wave, at: {it}"),
    "an action of a name alone": wave("sentences: [wave]").replace("type: custom, ", ""),
    "an action as a call": wave("sentences: [wave]").replace("{type: custom, name: wave}", "robot.wave()"),
    "a key twice": wave("sentences: [wave]", "sentences: [bow]"),
    "mistakes in what stands twice": (
        "language: en\nslots:\n  it: {type: txet}\n  it: {type: text}\n"
        "phrases:\n  there: ['at (it']\n  there: [at it]\n"
        "intents:\n  wave:\n    action: custm\n    sentences: ['wave {thing}']\n"
        "  wave:\n    action: custom\n    sentences: ['bow (down']\n    colour: red\n"
        "  wave: {sentences: ['nod {hat}']}\n"
    ),
    "an intent twice": says("wave") + "  wave: {action: stop, sentences: [halt]}\n",
    "two documents": says("wave") + "---\nlanguage: de\n",
    "an alias that nobody named": wave("sentences: [*wave]"),
    "an alias that holds itself": wave("sentences: &all [wave, *all]"),
    "aliases that unfold without end": "".join(
        f"{name}: &{name} [{', '.join([f'*{below}' if below else 'x'] * 20)}]\n"
        for name, below in [("a", ""), ("b", "a"), ("c", "b"), ("d", "c"), ("e", "d")]
    ),
    "a list for the file": "- wave\n- bow\n",
    "text for the file": "wave\n",
    "nothing in the file": "",
    "comments alone": "# language: en\n",
    "Latin-1": says("wave at the café").encode("latin-1"),
    "UTF-16": says("wave").encode("utf-16"),
    "a picture": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(256)),
    "a control character": says("wave \x07"),
    # -- keys of the file
    "a misspelt key": says("wave").replace("intents:", "intent:"),
    "a misspelt key of an intent": wave("sentence: [wave]"),
    "a misspelt key of a slot": slot("{type: distance, maximum: 3 m}"),
    "a language in words": says("wave").replace("language: en", "language: English"),
    "a language that is not known": says("wave").replace("language: en", "language: tlh"),
    "no intents": "language: en\nfillers: [please]\n",
    "an intent without an action": "language: en\nintents:\n  wave: {sentences: [wave]}\n",
    "an intent without sentences": wave("description: nothing can be said"),
    "fillers that are no list": says("wave", "fillers: please, uh\n"),
    "a filler that says no": says("wave", "fillers: [please, 'do not']\n"),
    "a filler that stops": says("wave", "fillers: [please, 'stop it']\n"),
    "sound-alikes of two words": says("wave", "sound_alikes: {the wave: [wave]}\n"),
    "an include that is not there": says("wave", "include: [gramar/base.yaml]\n"),
    "an include that includes itself": says("wave", "include: [grammar.yaml]\n"),
    # -- slots
    "a misspelt type": slot("{type: distnace}"),
    "a misspelt type in short": slot("distnace"),
    "an action whose type is misspelt": move(action="{typ: move}"),
    "a slot that is its own values": slot("{small: [tiny, little], large: big}", "wave [{it}]"),
    "a slot of values that are like keys": slot("{plus: [plus, and], minus: [minus, less]}", "wave [{it}]"),
    "a slot without a type": slot("{max_words: 2}"),
    "a choice without values": slot("{type: choice}"),
    "two values that are said alike": slot("{values: {small: [little, tiny], large: [big, little]}}"),
    "a value that needs no word": slot("{values: {small: '[very] [small]', large: big}}"),
    "a boolean that is neither": slot("{type: boolean, values: {open: [open], closed: [closed]}}"),
    "values for a distance": slot("{type: distance, values: [one meter]}"),
    "a limit for a choice": slot("{values: [a, b], max: 3}"),
    "a smallest size of nothing": slot("{type: angle, min: -90 deg, max: 90 deg, least: 0 deg}"),
    "a smallest size larger than max": slot("{type: angle, min: -90 deg, max: 90 deg, least: 2 rad}"),
    "a fixed value below the smallest size": move("defaults: {speed: 0.5}").replace("max: 1 m/s", "least: 1 m/s"),
    "a max below zero of what is never less": slot("{type: duration, max: -5 s}"),
    "a number in quotes": slot('{type: duration, max: "90"}'),
    "a number that YAML takes for a word": slot("{type: duration, max: 1e3}"),
    "a whole number in quotes": slot('{type: number, max: "1e2"}'),
    "min larger than max": slot("{type: distance, min: 5 m, max: 10 cm}"),
    "a limit in the wrong unit": slot("{type: distance, min: 5 kg}"),
    "a limit in words that are no number": slot("{type: duration, max: long}"),
    "a usual step of nothing": slot("{type: angle, usual_step: 0 deg}"),
    "one of several usual steps of nothing": slot("{type: angle, usual_step: [5 deg, 0 deg]}"),
    "usual steps in the wrong unit": slot("{type: angle, usual_step: [5 deg, 5 m]}"),
    "no usual steps": slot("{type: angle, usual_step: []}"),
    "a usual most of nothing": slot("{type: distance, usual_max: -1 m}"),
    "half of what is counted": slot("{type: number, whole: true}") + "    defaults: {it: 2.5}\n",
    "a distance that is whole": slot("{type: distance, whole: true}"),
    "a usual step for words": slot("{type: text, usual_step: 5}"),
    "a usual step in the wrong unit": slot("{type: angle, usual_step: 5 m}"),
    "a unit of something else": slot("{type: angle, unit: m}"),
    "a type as programs call it": slot("{type: float, max: 5}"),
    "a type that is a list": slot("{type: enum, values: [a, b]}"),
    "keys of a slot as programs call them": slot(
        "{type: number, minimum: 1, range: [1, 5], integer: true, default: 2}"
    ),
    "an action as programs call it": move(action="{type: drive}"),
    "a unit of its own of nothing": slot("{type: distance, units: {0 cm: step}}"),
    "a unit of its own of another kind": slot("{type: distance, units: {3 kg: step}}"),
    "a unit of its own that is one already": slot("{type: distance, units: {30 cm: [step, foot]}}"),
    "two units of its own with one name": slot("{type: distance, units: {30 cm: [step, pace], 70 cm: [pace]}}"),
    "digits of a speed": slot("{type: speed, digits: true}"),
    "digits in words": slot("{type: number, digits: two}"),
    "a number alone of a larger unit": slot("{type: number, unit: kilo, units: {1: [gram, g], 1000: kilo}}"),
    "a number alone where none is called one": slot("{type: number, unit: box, units: {6: box}}"),
    "a unit of its own without a word": slot("{type: distance, units: {30 cm: '[step]'}}"),
    "a unit of its own that is a slot": slot("{type: distance, units: {30 cm: '{it} step'}}"),
    "a unit of its own said in too many ways": slot(
        "{type: distance, units: {30 cm: '("
        + "|".join("abcdefgh")
        + ") ("
        + "|".join("abcdefgh")
        + ") ("
        + "|".join("abcdefgh")
        + ")'}}"
    ),
    "units of a text": slot("{type: text, units: {30 cm: step}}"),
    "too many words": slot("{type: text, max_words: 40}"),
    # -- actions and their values
    "a misspelt action": move(action="mvoe"),
    "an action of one's own without its type": move(action="dance"),
    "a misspelt parameter": move(action="{type: move, distnce: '{distance}'}"),
    "a parameter from a slot that no sentence has": move(action="{type: move, distance: '{far}'}"),
    "a parameter from a slot of another kind": move(action="{type: move, distance: '{speed}'}"),
    "a direction that no robot knows": move(action="{type: move, direction: sideways}"),
    "directions in another language": move().replace("[forward, backward]", "{vor: [vor], zurück: [zurück]}"),
    "navigation by free text": "language: en\nslots:\n  place: {type: text}\nintents:\n  go:\n"
    "    action: {type: navigate, location: '{place}'}\n    sentences: ['go to {place}']\n",
    "a sentence that cannot give what its action needs": "language: en\nintents:\n  go:\n    action: navigate\n"
    "    sentences: ['go there']\n",
    "a default that nothing takes": move("defaults: {sped: 0.3 m/s}"),
    "a speed with the sign of a direction": move(action="{type: move, direction: backward, speed: -0.3}"),
    "a default speed with the sign of a direction": move(
        "when: [{slots: {direction: backward}, defaults: {speed: -0.3}}]"
    ),
    "a turn without speed": (
        "language: en\nintents:\n  spin:\n    action: {type: turn, direction: left, speed: 0}\n    sentences: [spin]\n"
    ),
    "a place under another name": (
        "language: en\nslots: {place: location}\nintents:\n  go: {action: navigate, sentences: ['go to {place}']}\n"
    ),
    "a thing under another name": (
        "language: en\nslots: {thing: text}\nintents:\n  take: {action: pick, sentences: ['take {thing}']}\n"
    ),
    "a side under another name": (
        "language: en\nslots: {side: [left, right]}\nintents:\n  spin: {action: turn, sentences: ['spin {side}']}\n"
    ),
    "a default in the wrong unit": move("defaults: {speed: 0.3 kg}"),
    "a default above the slot's largest": move("defaults: {speed: 3 m/s}"),
    "a default below the slot's smallest": move("defaults: {distance: 1 cm}"),
    "a default that is no value": move("defaults: {direction: fwd}"),
    "a condition on a slot that no sentence has": move("when: [{slots: {side: left}, defaults: {speed: 0.3}}]"),
    "a condition on a value that there is not": move("when: [{slots: {direction: back}, defaults: {speed: 0.3}}]"),
    "a fixed slot that nothing takes": move(sentence="{say: back up, slots: {dirction: backward}}"),
    "a fixed slot in the wrong unit": move(sentence="{say: inch ahead, slots: {direction: forward, distance: 1 s}}"),
    "a state that is required and excluded": wave("sentences: [wave]", "requires: [docked]", "excludes: [docked]"),
    "a wait of an hour": wave("sentences: [wave]", "wait: 1 h"),
    "a wait that is no time": wave("sentences: [wave]", "wait: 2 m"),
    # -- sentences that meet
    "the same sentence in two intents": says("wave") + "  bow:\n    action: stop\n    sentences: [wave]\n",
    # -- patterns
    "a regex with an open bracket": wave("regex: 'wave (at'"),
    "a regex that looks ahead": wave("regex:", "  - 'bow'", "  - 'wave (?=at)'"),
    "a regex that repeats too much": wave("regex: 'wave ((a{500}){500}){500}'"),
    "a regex that fills no slot": wave("regex: 'wave at (?P<persn>.+)'", before="slots:\n  person: text\n"),
    "a regex that fits everything": wave("regex: '(?P<it>.*)'", before="slots:\n  it: text\n"),
    "a regex in capitals": wave("regex: 'Wave'"),
    "a lark grammar that is none": wave("lark: |", '  start: "wave" person', "  person: (", ""),
    "a lark rule that there is not": wave("lark: |", '  start: "wave" person'),
    "two groups of one name": wave("regex: 'bow (?P<far>up)|(?P<far>down) bow'", before="slots: {far: text}\n"),
    "a lark grammar without a start": wave("lark: |", '  begin: "wave"'),
    "a lark grammar that fits everything": wave("lark: |", "  start: /.*/"),
    # -- examples
    "a misspelt result of an example": wave("sentences: [wave]", "examples:", "  - 'do not wave': rejcted"),
    "an example with a slot that there is not": wave("sentences: [wave]", "examples:", "  - wave: {person: me}"),
    "an example of two sentences": wave("sentences: [wave]", "examples:", "  - {wave: {}, bow: {}}"),
    # -- what beginners of YAML write
    "an apostrophe between single quotes": wave("sentences:", "  - 'don't bow'"),
    "words behind a quote": wave("sentences:", '  - "wave" now'),
    "a quote that is closed by that of the next line": wave("sentences:", '  - "wave at me', '  - "wave"'),
    "a backslash between double quotes": wave('regex: "wave \\d+"'),
    "a slot alone": wave("sentences:", "  - {person}"),
    "an optional alone": wave("sentences:", "  - [please]", "  - wave"),
    "a star alone": wave("sentences:", "  - *"),
    "a dash without a blank": wave("sentences:", "  -wave", "  -bow"),
    "a colon without a blank": "language:en\nintents:\n  wave: {action: custom, sentences: [wave]}\n",
    "a blank that is no space": wave("sentences: [wave]").replace("    action", "\u00a0\u00a0\u00a0\u00a0action"),
    "a key that is indented less than its neighbours": wave("sentences: [wave]").replace("    sent", "   sent"),
    "a key of an intent beside the intent": wave("sentences: [wave]").replace("    sent", "  sent"),
    "an intent beside the intents": "language: en\nintents:\nwave:\n  action: custom\n  sentences: [wave]\n",
    "a slot beside the slots": "language: en\nslots:\nway: {type: distance}\n" + wave("sentences: [wave]")[13:],
    "a place for anchors": "x-far: &far {type: distance}\nlanguage: en\nslots:\n  way: *far\n"
    + wave("sentences: ['go {way}']")[13:],
    "intents as a list": "language: en\nintents:\n  - name: wave\n    action: custom\n",
    "a confidence in percent": wave("sentences: [wave]", "min_confidence: 70"),
    "a line without its colon": wave("sentences: [wave]").replace("intents:", "intents"),
    "an equals sign": wave("priority = 2", "sentences: [wave]"),
    "a sentence without its dash": wave("sentences:", "  - wave", "  bow", "  - hop"),
    "a dash further to the right": wave("sentences:", "  - wave", "   - bow"),
    "a dash before a tab": wave("sentences:", "  -\twave"),
    "a dash before a dash": wave("sentences:", "  - - wave"),
    "a bar at the beginning": wave("sentences:", "  - | wave"),
    "an optional at the beginning, in a list": wave("sentences: [[please] wave, bow]"),
    "a sentence with its slots, and no list": wave("sentences: {say: wave, slots: {way: up}}"),
    "a condition, and no list": wave("sentences: [wave]", "when: {slots: {way: up}, defaults: {far: 1}}"),
    "a condition without its keys": wave("sentences: [wave]", "when: [{way: up}]"),
    "an intent that is its sentence": "intents:\n  wave: wave at me\n",
    "slots among the intents": says("wave {far}") + "  slots:\n    far: distance\n",
    "intents among the slots": "slots:\n  far: distance\n  intents:\n    wave: {action: custom, sentences: [wave]}\n",
    "a unit that is known among one's own": slot("{type: distance, units: m}"),
    "a boolean as text": slot('{type: number, whole: "true"}'),
    "a confidence with its sign": wave("sentences: [wave]", "min_confidence: 70%"),
    "an anchor that holds itself": "intents: &all\n  wave: *all\n",
    "words around a slot of the action": says("wave {far}", "slots: {far: distance}\n").replace(
        "name: wave}", "name: wave, text: 'as far as {far}'}"
    ),
    "a line that is too long to be shown": wave("sentences: [" + "wave, " * 60 + "wave (at, " + "wave, " * 60 + "bow]"),
    "a wide sign, and one that takes no room": says("\u65e5cafe\u0301 wave ("),
    "templates where plain words stand": says(
        "wave {it}",
        "fillers: ['(please|kindly)', '...']\nwake: ['[hey] robot']\noperators: {stop: ['(hoho|hola)']}\n"
        "slots: {it: {type: text, known: ['(red|blue) cup']}}\n",
    ),
    # -- what other programs call it
    "a whole number by its name in Python": slot("int"),
    "a fraction by its name in Python": slot("float"),
    "a list of values by another name": slot("enum"),
    "a turn by another name": wave("sentences: [spin]").replace("{type: custom, name: wave}", "rotate"),
    "a list of Home Assistant": slot("{values: [{in: '(sofa|couch)', out: lounge}, {in: bath, out: bath}]}"),
    "values with what is said for them, as a list": slot("[lounge: sofa]"),
    "a range of Home Assistant": slot("{type: number, from: 0, to: 10}"),
    "free words of Home Assistant": slot("{wildcard: true}"),
    "states that have values": wave("sentences: [wave]", "requires: {domain: light}"),
    "a block of sentences of Home Assistant": wave("sentences:", "  - {sentences: [wave], response: hi}"),
    # -- numbers that are never meant
    "degrees without their unit": slot("{type: angle, max: 90}"),
    "a slot of the action, misspelt": wave("sentences: [wave]", before="slots:\n  person: text\n").replace(
        "name: wave}", "name: wave, who: '{persn}'}"
    ),
    "how far and how long at once": move("defaults: {distance: 1 m, duration: 2 s}"),
    "no time at all": move("defaults: {duration: 0}"),
    "a way back with a direction": move("defaults: {distance: -1 m}"),
    "a factor of nothing": wave("sentences: [slower]").replace(
        "{type: custom, name: wave}", "{type: change_speed, factor: 0}"
    ),
    "a boolean in quotes": wave(
        "sentences: ['wave [{on}]']", "defaults: {'on': 'true'}", before="slots: {'on': boolean}\n"
    ),
    # -- many at once
    "everything at once": move("defaults: {sped: 1}", "examples:", "  - yes", sentence="'go {driection} (now'").replace(
        "max: 1 m/s", "max: 1 m"
    )
    + "  wave:\n    sentences: [wave]\n    action: custom\n    regexp: wave\n"
    + "  bow: {action: bow, sentences: ['bow {who}']}\n",
}
