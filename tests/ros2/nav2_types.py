"""Makes the Python types of Nav2's ``NavigateToPose``, which is in no wheel, from its definition.

They differ between distributions, so they are made where they are needed and never shipped: rosidl's generators, which
the wheels of rclpy bring, write the sources, and gcc makes one library of them.
"""

from __future__ import annotations

import concurrent.futures
import json
import subprocess
import sys
import sysconfig
from pathlib import Path

NAME = "nav2_msgs"
NEEDS = ["builtin_interfaces", "geometry_msgs", "std_msgs", "unique_identifier_msgs", "action_msgs", "service_msgs"]
SUPPORTS = ["rosidl_typesupport_fastrtps_c", "rosidl_typesupport_introspection_c"]
"""What the middleware of Kilted and that of Jazzy look for."""
LIBRARIES = ["rosidl_generator_c", *SUPPORTS, "rosidl_typesupport_c"]

# The fields of nav2_msgs/action/NavigateToPose in Kilted.
NAVIGATE_TO_POSE = """\
geometry_msgs/PoseStamped pose
string behavior_tree
---
uint16 error_code
string error_msg
---
geometry_msgs/PoseStamped current_pose
builtin_interfaces/Duration navigation_time
builtin_interfaces/Duration estimated_time_remaining
int16 number_of_recoveries
float32 distance_remaining
"""


class CannotBuildError(Exception):
    """No compiler, or no generators; the reason is in the message."""


def build(folder: Path) -> dict[str, str]:
    """Make the package ``nav2_msgs`` in a folder; returns the variables by which programs find it.

    Raises:
        CannotBuildError: it cannot be made on this machine.
    """
    prefix = Path(sys.prefix)
    if not (prefix / "share" / "rosidl_generator_py" / "resource").is_dir():
        raise CannotBuildError("this ROS is not that of the wheels; install nav2_msgs")
    done = subprocess.run([sys.executable, __file__, folder], capture_output=True, text=True, check=False)
    if done.returncode:
        raise CannotBuildError(f"nav2_msgs could not be made: {done.stderr.strip().splitlines()[-1][:300]}")
    return {"PYTHONPATH": str(folder / "rosidl_generator_py"), "LD_LIBRARY_PATH": str(folder)}


def _generate(prefix: Path, folder: Path) -> None:
    import rosidl_generator_c
    import rosidl_typesupport_c
    import rosidl_typesupport_fastrtps_c
    import rosidl_typesupport_introspection_c
    from rosidl_adapter import convert_to_idl
    from rosidl_generator_py.generate_py_impl import generate_py
    from rosidl_generator_type_description import generate_type_hash

    package = folder / "definition" / NAME
    (package / "action").mkdir(parents=True)
    (package / "action" / "NavigateToPose.action").write_text(NAVIGATE_TO_POSE)
    convert_to_idl(package, NAME, Path("action/NavigateToPose.action"), package)

    def arguments(generator: str) -> str:
        output = folder / generator / NAME
        output.mkdir(parents=True)
        description = folder / "rosidl_generator_type_description" / NAME / "action/NavigateToPose.json"
        data = {
            "package_name": NAME,
            "output_dir": str(output),
            "template_dir": str(prefix / "share" / generator / "resource"),
            "idl_tuples": [f"{package}:action/NavigateToPose.idl"],
            "type_description_tuples": [f"action/NavigateToPose.idl:{description}"],
            "include_paths": [f"{name}:{prefix / 'share' / name}" for name in NEEDS],
            "ros_interface_dependencies": [],
            "target_dependencies": [],
        }
        path = folder / f"{generator}.json"
        path.write_text(json.dumps(data))
        header = f"{generator}__visibility_control.h"
        template = prefix / "share" / generator / "resource" / f"{header}.in"
        if template.exists():
            (output / "msg").mkdir()
            text = template.read_text().replace("@PROJECT_NAME@", NAME).replace("@PROJECT_NAME_UPPER@", NAME.upper())
            (output / "msg" / header).write_text(text)
        return str(path)

    generate_type_hash(arguments("rosidl_generator_type_description"))
    rosidl_generator_c.generate_c(arguments("rosidl_generator_c"))
    rosidl_typesupport_fastrtps_c.generate_typesupport_fastrtps_c(arguments("rosidl_typesupport_fastrtps_c"))
    rosidl_typesupport_introspection_c.generate_c(arguments("rosidl_typesupport_introspection_c"))
    rosidl_typesupport_c.generate_c(arguments("rosidl_typesupport_c"), SUPPORTS)
    generate_py(arguments("rosidl_generator_py"), ["rosidl_typesupport_c"])
    (folder / "rosidl_generator_py" / NAME / "__init__.py").touch()


def _compile(prefix: Path, folder: Path) -> None:
    import numpy

    parts = [*LIBRARIES, "rosidl_generator_py"]
    headers = [*(folder / part for part in parts), prefix / "include", *(prefix / "include").iterdir()]
    headers += [sysconfig.get_paths()["include"], numpy.get_include()]

    def compiled(source: Path) -> str:
        target = folder / (str(source.relative_to(folder)).replace("/", "_") + ".o")
        compiler = ["g++", "-std=c++17"] if source.suffix == ".cpp" else ["gcc"]
        flags = ["-O0", "-w", "-fPIC", *(f"-I{header}" for header in headers)]
        subprocess.run([*compiler, *flags, "-c", source, "-o", target], check=True)
        return str(target)

    sources = {part: sorted(p for p in (folder / part).rglob("*.c*") if p.suffix in (".c", ".cpp")) for part in parts}
    with concurrent.futures.ThreadPoolExecutor(2) as threads:
        objects = {part: list(threads.map(compiled, files)) for part, files in sources.items()}
    names = [f"{name}__{part}" for name in NEEDS for part in parts]
    names += ["rosidl_runtime_c", "rosidl_typesupport_c", "rosidl_typesupport_fastrtps_c"]
    names += ["rosidl_typesupport_introspection_c", "rosidl_typesupport_fastrtps_cpp", "fastcdr", "rcutils"]
    linked: list[Path] = [path for name in names if (path := prefix / "lib" / f"lib{name}.so").exists()]
    for part in parts:
        target = folder / f"lib{NAME}__{part}.so"
        if part == "rosidl_generator_py":
            target = folder / part / NAME / f"{NAME}_s__rosidl_typesupport_c.so"
        where = f"-Wl,-rpath,{prefix / 'lib'}:{folder}"
        options = ["-shared", where, "-Wl,--allow-shlib-undefined", "-o", target]
        subprocess.run(["g++", *options, *objects[part], *linked], check=True)
        linked.insert(0, target)


if __name__ == "__main__":
    _generate(Path(sys.prefix), Path(sys.argv[1]))
    _compile(Path(sys.prefix), Path(sys.argv[1]))
