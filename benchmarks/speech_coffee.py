"""Coffee orders by people, in kitchen noise, beside the five engines of the published benchmark.

Another domain, described in one YAML file. Scored as they were: the share of orders whose intent and every labelled
slot are right; slots that were not labelled are not held against an engine. Theirs are the published figures, the mean
of cafe and kitchen noise over 619 recordings; ours are on the 138 of the development data in kitchen noise.
"""

from __future__ import annotations

import json
from typing import Any

from benchmarks.recordings import DATA, PEER, ROOT, Ways, accuracy_rows, hear, kitchen, needs, row, some
from benchmarks.report import Report, Table
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.scoring import score
from intent_engine.evaluation.trial import Trial

_COMMAND = "python -m benchmarks --only speech_coffee"
FOLDER = DATA / "coffee"
OURS = "Intent Engine, tiny.en and Moonshine in doubt"
NOTE = (
    "Intent and every labelled slot right, in %; {count} recordings by more than 50 people, kitchen noise. The engines "
    "in italics as [published](https://github.com/Picovoice/speech-to-intent-benchmark): mean of cafe and kitchen "
    "noise, 619 recordings, among them these."
)


def run(quick: bool) -> Report:
    """The rows and the table of this benchmark."""
    needs(FOLDER, "the coffee orders of the development data")
    engine = IntentEngine.from_files(ROOT / "examples" / "coffee" / "coffee.yaml")
    published: dict[str, Any] = json.loads((FOLDER / "published.json").read_text("utf-8"))
    snrs = [float(snr) for snr in published["snr_db"]]
    rows = some(read_labels(FOLDER / "labels.jsonl", engine), quick)
    ways = Ways.of(engine, reflex=False)
    kitchen_noise = kitchen()
    ours, peer = hear("coffee", rows, Trial(kitchen_noise, snrs), (ways.ours, ways.peer))
    table, means = [], {}
    lines = [(OURS, ours), (PEER, peer)]
    for noise in kitchen_noise.names if kitchen_noise is not None else ():
        part = {snr: [one for one in found if kitchen_noise.of(one.row.id) == noise] for snr, found in ours.items()}
        if part[None]:
            lines.insert(-1, (f"the {len(part[None])} of them in {noise.replace('_', ' ')}", part))
    for name, heard in lines:
        rights = [100 * (score(heard[snr]).accuracy or 0.0) for snr in snrs]
        means[name] = sum(rights) / len(rights)
        clean = f"{100 * (score(heard[None]).accuracy or 0.0):.1f}"
        table.append([name, f"{means[name]:.1f}", *(f"{right:.1f}" for right in rights), clean])
    for name, mean in sorted(published["summary_pct"].items(), key=lambda item: -item[1]):
        shares = [f"{100 * value:.1f}" for value in published[name]]
        table.append([f"*{name}*", f"{mean:.1f}", *shares, ""])
    columns = ["engine", "mean", *(f"{snr:g} dB" for snr in snrs), "clean"]
    found = [
        row(
            "coffee orders not right, mean of 6 to 24 dB",
            _COMMAND,
            100 - means[OURS],
            "%",
            100 - best,
            peer=name,
            runs=len(rows),
        )
        for name, best in (
            (PEER, means[PEER]),
            ("Picovoice Rhino, published", published["summary_pct"]["Picovoice Rhino"]),
        )
    ]
    for snr, name in ((None, "clean"), (12.0, "kitchen noise at 12 dB")):
        found += accuracy_rows(f"coffee orders, {name}", _COMMAND, ours[snr], peer[snr])
    return Report(found, [Table("Coffee orders", columns, table, NOTE.format(count=len(rows)))])
