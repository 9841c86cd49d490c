"""English words that sound the same, or are spelled in two ways: which of them was said only the grammar can tell.

A recogniser writes the commoner one: "break" for "brake", "gray" for "grey". A grammar that has the other one means
that. Only words that most speakers say alike are here, and none that people say in other ways than they are written
("caught" and "cot"); names of people are not, nor numbers, which have rules of their own.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

__all__ = ["LETTERS_BY_SOUND", "SPELLING_ALPHABET", "homophones", "spelled_otherwise"]

LETTERS_BY_SOUND = {
    "eh": "a", "hey": "a", "be": "b", "bee": "b", "see": "c", "sea": "c", "dee": "d", "eff": "f", "gee": "g",
    "eye": "i", "jay": "j", "kay": "k", "el": "l", "ell": "l", "em": "m", "en": "n", "owe": "o", "pea": "p",
    "pee": "p", "queue": "q", "cue": "q", "are": "r", "ess": "s", "tea": "t", "tee": "t", "you": "u", "ex": "x",
    "why": "y", "zed": "z", "zee": "z",
}  # fmt: skip
"""What is written for a letter that was said: "well bee two", "aisle see"."""

SPELLING_ALPHABET = {
    "alpha": "a", "alfa": "a", "bravo": "b", "charlie": "c", "delta": "d", "echo": "e", "foxtrot": "f", "golf": "g",
    "hotel": "h", "india": "i", "juliet": "j", "juliett": "j", "kilo": "k", "lima": "l", "mike": "m", "november": "n",
    "oscar": "o", "papa": "p", "quebec": "q", "romeo": "r", "sierra": "s", "tango": "t", "uniform": "u", "victor": "v",
    "whiskey": "w", "whisky": "w", "xray": "x", "yankee": "y", "zulu": "z",
}  # fmt: skip
"""Letters as pilots say them, by the alphabet of the International Civil Aviation Organization: "aisle bravo"."""

_ENGLISH = """
add ad; aeroplane airplane; aid aide; air heir; aisle isle; aisles isles; allowed aloud; altar alter; aluminum
aluminium; analog analogue; arc ark; armor armour; ascent assent; ax axe; axle axel; bail bale; bails bales; bait
bate; ball bawl; balls bawls; band banned; bar barre; bard barred; bare bear; baron barren; base bass; bases basses;
bay bey; bazaar bizarre; beach beech; beat beet; beats beets; behavior behaviour; bell belle; bells belles; berries
buries; berry bury; berth birth; billed build; bite byte; bites bytes; blew blue; bloc block; blocs blocks; boar
bore; board bored; boarder border; boarders borders; bold bowled; bolder boulder; bolt boult; brake break; brakes
breaks; braking breaking; breach breech; bread bred; brews bruise; bridal bridle; broach brooch; brows browse; buses
busses; buy bye; cache cash; caliber calibre; cancelled canceled; cancelling canceling; canon cannon; canvas
canvass; carrot karat carat; carrots carats; cart carte; cast caste; caster castor; catalog catalogue; cede seed;
ceiling sealing; cell sell; cellar seller; cellars sellers; cells sells; cent scent; center centre; centered
centred; centers centres; centimeter centimetre; centimeters centimetres; cents scents; cents sense; cereal serial;
chased chaste; check cheque czech; checks cheques; chews choose; chilly chili chile; choir quire; choral coral;
chord cord; chords cords; chute shoot; chutes shoots; cite sight site; cites sights sites; clause claws; close
clothes; coal kohl; coarse course; coat cote; cocoa coco; colonel kernel; colonels kernels; color colour; colored
coloured; colors colours; coop coupe; core corps; council counsel; cozy cosy; creak creek; cream creme; crews
cruise; cubicle cubical; cue queue; cues queues; currant current; cursor curser; cymbal symbol; cymbals symbols;
days daze; dear deer; desert dessert; deserts desserts; device devise; dew due; dialog dialogue; die dye; died dyed;
disc disk; discreet discrete; discs disks; doe dough; done dun; donut doughnut; donuts doughnuts; draft draught;
drafts draughts; dual duel; duct ducked; earn urn; earns urns; ewe yew; eye aye; eyes ayes; faint feint; fair fare;
fairs fares; fairy ferry; favorite favourite; feat feet; fiber fibre; fibers fibres; find fined; fir fur; firs furs;
flair flare; flavor flavour; flavors flavours; flea flee; flew flu flue; flour flower; flours flowers; flyer flier;
flyers fliers; foreword forward; forth fourth; foul fowl; freeze frees frieze; friar fryer; gait gate; gaits gates;
gauge gage; gilt guilt; gorilla guerrilla; gram gramme; grams grammes; grate great; grater greater; gray grey;
grease greece; groan grown;
guessed guest; hail hale; hair hare; hairs hares; hall haul; halls hauls; handsome hansom; hangar hanger; hangars
hangers; harbor harbour; hart heart; hay hey; heal heel; heals heels; hear here; heard herd; hertz hurts; hi high;
higher hire; him hymn; hoard horde; hoarse horse; hoes hose; hold holed; hole whole; holes wholes; honor honour;
hour our; hours ours; idle idol; in inn; inquiry enquiry; jam jamb; jewelry jewellery; judgment judgement; key quay;
keys quays; kilometer kilometre; kilometers kilometres; knead need; knew new; knight night; knights nights; knit
nit; knots nots; labeled labelled; labor labour; lack lac; lacks lax; lain lane; lamb lam; laps lapse; leach leech;
lead led; leak leek; leaks leeks; lean lien; leased least; lessen lesson; levee levy; license licence; lie lye;
lightning lightening; liter litre; liters litres; load lode; loads lodes; loan lone; loch lock; lochs locks lox;
loot lute; made maid; mail male; mails males; main mane; maize maze; mall maul; maneuver manoeuvre; manner manor;
mantel mantle; marshal martial; mast massed; meat meet mete; meats meets; medal meddle; metal mettle; meter metre;
meters metres; microliter microlitre; microliters microlitres; might mite; milliliter millilitre; milliliters
millilitres; millimeter millimetre; millimeters
millimetres; mind mined; miner minor; missed mist; mode mowed; mold mould; molds moulds; moose mousse; morning
mourning; muscle mussel; muscles mussels; mustache moustache; mustard mustered; naval navel; neighbor neighbour;
nose knows; oar ore or; oars ores; ode owed; ok okay; omelet omelette; organize organise; paced paste;
packed pact; pail pale; pails pales; pain pane; pains panes; pair pare pear; pairs pares pears; pajamas pyjamas;
palate palette pallet; palates pallets; passed past; patience patients; pause paws; peace piece; peak peek pique;
peaks peeks; peal peel; peas pees; pedal peddle; pedals peddles; peer pier; peers piers; phase faze; plain plane;
plains planes; plow plough; plows ploughs; plum plumb; pole poll; poles polls; pore pour; pored
poured; pores pours; practice practise; pray prey; principal principle; profit prophet; program programme; programs
programmes; rack wrack; rain reign rein; rains reigns reins; raise rays raze; rap wrap; rapped wrapped rapt; rapping
wrapping; raps wraps; read red; read reed; reads reeds; real reel; recognize recognise; reek wreak; rest wrest;
review revue; right write rite wright; ring wring; ringer wringer; rings wrings; road rode rowed; roe row; roes rows
rose; role roll; roles rolls; root route; roots routes; rote wrote; rough ruff; rumor rumour; rung wrung; rye wry;
sac sack; sacks sax sacs; sail sale; sails sales; saver savor; scene seen; scull skull; sea see; seam seem; seams
seems; seas sees seize; sensor censor; sensors censors; serf surf; sew so sow; sewing sowing; shear sheer; shoe
shoo; shone shown; side sighed; sighs size; sign sine; signs sines; sink sync; skeptic sceptic; slay sleigh; sleight
slight; soar sore; soared sword; sole soul; soles souls; some sum; son sun; sons suns; spade spayed; staid stayed;
stair stare; stairs stares; stake steak; stakes steaks; stationary stationery; steal steel; steals steels; step
steppe; steps steppes; stile style; stiles styles; storey story; storeys stories; straight strait; suede swayed;
suite sweet; suites sweets; sulfur sulphur; sundae sunday; tacks tax; tail tale; tails tales; taught taut; tea tee;
team teem; teams teems; teas tees tease; theater theatre; theaters theatres; their there; threw through; throes
throws; throne thrown; tic tick; tide tied; tire tyre; tires tyres; toad towed; toe tow; toes tows; told tolled;
tole toll; ton tonne; tons tonnes; tracked tract; traveler traveller; tray trey; troop troupe; undo undue; vain vane
vein; vale veil; vapor vapour; vapors vapours; vice vise; wade weighed; wail whale; wails whales; waist waste; wait
weight; waited weighted; waiting weighting; waits weights; waive wave; waived waved; waiver waver; waives waves;
ware wear where; wares wears; warn worn; watt what; watts whats; way weigh whey; ways weighs; weak week; weather
whether; wet whet; which witch; while wile; whine wine; whines wines; whirl whorl; whiskey whisky; whoa woe; whose
who's; wood would; yogurt yoghurt; yoke yolk; yolks yokes; zeros zeroes
"""


_EITHER_WAY = (
    (re.compile("(?<=[a-z]{3}[iy])[sz](?=(?:e|es|ed|er|ers|ing|ation|ations)$)"), str.maketrans("sz", "zs")),
)
"""Letters of which English has one and American English the other: "steriliSe", "analyZer"."""
_ENDINGS = (("our", "or"), ("tre", "ter"), ("bre", "ber"))
"""And how words end here and there, with at least three letters before: "harbour", "theatre", "fibre"."""
_MORE = ("", "s", "ed", "ing")


def spelled_otherwise(word: str) -> tuple[str, ...]:
    """How an English word is written elsewhere: "stabiliser" for "stabilizer", "harbor" for "harbour". Some of it is no
    word at all ("motour"), and nobody writes that."""
    found = [
        word[: match.start()] + match.group().translate(other) + word[match.end() :]
        for letters, other in _EITHER_WAY
        if (match := letters.search(word))
    ]
    for more in _MORE:
        stem = word.removesuffix(more)
        if more and stem == word:
            continue
        for pair in _ENDINGS:
            for one, other in (pair, pair[::-1]):
                if stem.endswith(one) and len(stem) >= len(one) + 3:
                    found.append(stem.removesuffix(one) + other + more)
    return tuple(dict.fromkeys(found))


@cache
def homophones(language: str) -> Mapping[str, tuple[str, ...]]:
    """Words that sound like others: each with those that may have been said in its place. None in other languages than
    English."""
    if language != "en":
        return {}
    found: dict[str, tuple[str, ...]] = {}
    for words in (written.split() for written in _ENGLISH.split(";")):
        for word in words:
            found[word] = (*found.get(word, ()), *(other for other in words if other != word))
    return found
