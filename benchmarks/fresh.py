"""What loading costs in a process of its own: ``python -m benchmarks.fresh ENGINE MAP`` prints one line of JSON.

The map is a map file for ours; for hassil, which keeps no poses, a list of names.

Keys: ``import``, ``load``, ``first`` in s of processor time; ``memory`` in bytes: what loading and the first sentence
left behind.
"""

from __future__ import annotations

import gc
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
FIRST = "turn left"
"""The first sentence: it asks for no place, so that a map costs what a map costs by being there."""


def resident() -> int:
    """Bytes of this process in memory."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def measured(name: str, map_file: str) -> dict[str, float]:
    """In this process, which must be new: import, load, first sentence."""
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
    return {
        "import": imported - started,
        "load": loaded - begun,
        "first": done - loaded,
        "memory": float(resident() - before),
    }


def imported(module: str) -> float:
    """Seconds to import a module in a new process, without the interpreter's own start."""
    code = f"import time; t = time.process_time(); import {module}; print(time.process_time() - t)"
    return float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)


def in_new_process(name: str, map_file: Path | None) -> dict[str, float]:
    """:func:`measured` in a new process."""
    command = [sys.executable, "-m", "benchmarks.fresh", name, str(map_file or "")]
    found = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT)
    result: dict[str, float] = json.loads(found.stdout)
    return result


if __name__ == "__main__":
    print(json.dumps(measured(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "")))
