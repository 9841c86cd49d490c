"""What loading costs in a process of its own: ``python -m benchmarks.fresh ENGINE MAP NAME`` prints one line of JSON.

The map is a map file for ours; for hassil, which keeps no poses, a list of names.

Keys: ``import``, ``load``, ``first`` and, if a name is given, ``place`` in s of processor time; ``memory`` in bytes:
what loading and the first sentence left behind; ``memory_place``: after the first sentence with a place.

Byte code is cached, as it is for whoever runs a program twice, in a folder of the measurement's own: a first run fills
it, for both engines, and is not counted.
"""

from __future__ import annotations

import gc
import json
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
FIRST = "turn left"
"""The first sentence: it asks for no place, so that a map costs what a map costs by being there."""
WITH_PLACE = "go to the {name}"
"""The second: the first that looks at the map."""


def resident() -> int:
    """Bytes of this process in memory."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def measured(name: str, map_file: str, last_name: str) -> dict[str, float]:
    """In this process, which must be new: import, load, first sentence, first place."""
    started = time.process_time()
    parse: Any
    if name == "ours":
        import intent_engine
        from intent_engine import IntentEngine

        imported = time.process_time()
        before = resident()
        begun = time.process_time()
        parse = IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=map_file or None).parse
        assert intent_engine
    else:
        import hassil
        import yaml

        imported = time.process_time()
        before = resident()
        begun = time.process_time()
        loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
        text = (ROOT / "benchmarks" / "peers" / "hassil.yaml").read_text("utf-8")
        intents = hassil.Intents.from_dict(yaml.load(text, Loader=loader))
        names = yaml.load(Path(map_file).read_text("utf-8"), Loader=loader) if map_file else []
        lists: dict[str, hassil.SlotList] = {"place": hassil.TextSlotList.from_strings(names, allow_template=False)}

        def parse(text: str) -> Any:
            return hassil.recognize(text, intents, slot_lists=lists, language="en")

    loaded = time.process_time()
    found = parse(FIRST)
    done = time.process_time()
    assert found
    gc.collect()
    result = {
        "import": imported - started,
        "load": loaded - begun,
        "first": done - loaded,
        "memory": float(resident() - before),
    }
    if last_name:
        begun = time.process_time()
        found = parse(WITH_PLACE.format(name=last_name))
        result["place"] = time.process_time() - begun
        assert found
        gc.collect()
        result["memory_place"] = float(resident() - before)
    return result


def _outputs(arguments: Sequence[str], runs: int, cache: Path) -> list[str]:
    """What Python prints in each of so many new processes, after one that only fills the cache of byte code."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(cache)
    command = [sys.executable, *arguments]
    found = [
        subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT, env=environment).stdout
        for _ in range(runs + 1)
    ]
    return found[1:]


def imported(module: str, runs: int, cache: Path) -> list[float]:
    """Seconds to import a module in new processes, without the interpreter's own start."""
    code = f"import time; t = time.process_time(); import {module}; print(time.process_time() - t)"
    return [float(printed) for printed in _outputs(["-c", code], runs, cache)]


def in_new_processes(name: str, map_file: Path, last_name: str, runs: int, cache: Path) -> list[dict[str, float]]:
    """:func:`measured` in new processes."""
    arguments = ["-m", "benchmarks.fresh", name, str(map_file), last_name]
    return [json.loads(printed) for printed in _outputs(arguments, runs, cache)]


if __name__ == "__main__":
    print(json.dumps(measured(*[*sys.argv[1:], "", "", ""][:3])))
