"""The ROS package around the nodes: its files agree with each other. ``ros2 launch`` itself is in no wheel."""

from __future__ import annotations

import ast
import re
import tomllib
import xml.etree.ElementTree as ET
from importlib import import_module

import pytest
import yaml

from intent_engine.errors import ConfigError


@pytest.fixture(scope="module")
def package(root):
    return root / "ros2" / "intent_engine_ros"


@pytest.fixture(scope="module")
def launch(package):
    return ET.parse(package / "launch/voice_commands.launch.xml").getroot()


@pytest.fixture(scope="module")
def scripts(package):
    """Name -> what it runs, as setup.py says."""
    calls = [node for node in ast.walk(ast.parse((package / "setup.py").read_text())) if isinstance(node, ast.Call)]
    (setup,) = [call for call in calls if getattr(call.func, "id", "") == "setup"]
    (points,) = [ast.literal_eval(word.value) for word in setup.keywords if word.arg == "entry_points"]
    return dict(map(str.strip, each.split("=")) for each in points["console_scripts"])


@pytest.fixture(scope="module")
def parameters(package):
    """Those that a robot file may have too are comments, so that they do not go before it unseen."""
    text = (package / "config/voice_commands.yaml").read_text()
    data = yaml.safe_load(re.sub(r"^    # (\w+: )", r"    \1", text, flags=re.MULTILINE))
    return {name.rpartition("/")[2]: values["ros__parameters"] for name, values in data.items()}


def test_the_launch_file_starts_what_the_package_installs(launch, scripts, package):
    name = ET.parse(package / "package.xml").getroot().findtext("name")
    nodes = launch.findall("node")
    assert {node.get("exec") for node in nodes} == set(scripts)
    assert {node.get("pkg") for node in nodes} == {name}
    assert (package / "resource" / name).exists()
    for target in scripts.values():
        module, function = target.split(":")
        assert callable(getattr(import_module(module), function))


def test_the_launch_file_uses_the_arguments_that_it_declares(launch):
    declared = {arg.get("name") for arg in launch.findall("arg")}
    texts = [value for element in launch.iter() for value in element.attrib.values()]
    used = {part.partition(")")[0] for text in texts for part in text.split("$(var ")[1:]}
    assert used == declared
    assert all(arg.get("description") for arg in launch.findall("arg"))


def test_files_that_are_installed_exist(package):
    text = (package / "setup.py").read_text()
    assert "launch/voice_commands.launch.xml" in text
    assert "config/voice_commands.yaml" in text


def test_versions_are_one(root, package):
    version = tomllib.loads((root / "pyproject.toml").read_text())["project"]["version"]
    assert ET.parse(package / "package.xml").getroot().findtext("version") == version
    assert f'version="{version}"' in (package / "setup.py").read_text()


def test_scripts_are_those_of_the_engine(root, scripts):
    project = tomllib.loads((root / "pyproject.toml").read_text())["project"]["scripts"]
    assert set(scripts.values()) <= set(project.values())


@pytest.mark.ros2
@pytest.mark.parametrize("name", ["intent_engine", "speech"])
def test_the_parameter_file_says_every_parameter_and_its_default(parameters, name):
    import rclpy

    from intent_engine.execution.robots.ros2_support import own_node
    from intent_engine.ros2 import parameters as node_parameters
    from intent_engine.ros2 import speech

    context, node = own_node(name)
    try:
        {"intent_engine": node_parameters.read_parameters, "speech": speech.read_parameters}[name](node)
        of_ros = ("use_sim_time", "start_type_description_service")
        declared = {
            each: parameter.value for each, parameter in node.get_parameters_by_prefix("").items() if each not in of_ros
        }
    finally:
        node.destroy_node()
        rclpy.shutdown(context=context)
    told = {
        each: value[0] if isinstance(value, list) and len(value) == 1 else value
        for each, value in parameters[name].items()
    }
    assert told == declared


def test_nothing_in_the_parameter_file_goes_before_a_robot_file(package):
    data = yaml.safe_load((package / "config/voice_commands.yaml").read_text())
    shared = {"max_linear", "max_angular", "rate", "ttl", "expire_after"}
    assert not shared & set(data["/**/intent_engine"]["ros__parameters"])


def read(name, given):
    """What a node of that name reads from parameters that are given."""
    import rclpy
    from rclpy.parameter import Parameter

    from intent_engine.ros2 import parameters, speech

    context = rclpy.Context()
    rclpy.init(args=[], context=context)
    overrides = [Parameter(each, value=value) for each, value in given.items()]
    node = rclpy.create_node(name, context=context, parameter_overrides=overrides)
    try:
        return {"intent_engine": parameters.read_parameters, "speech": speech.read_parameters}[name](node)
    finally:
        node.destroy_node()
        rclpy.shutdown(context=context)


@pytest.mark.ros2
@pytest.mark.parametrize(
    ("file", "asked", "found", "over"),
    [
        (None, None, 0.5, "clamp"),
        (None, 1.5, 1.5, "clamp"),
        ("limits: {linear_velocity: 0.22}", None, 0.22, "refuse"),
        ("limits: {linear_velocity: 0.22}", 0.1, 0.1, "refuse"),
        ("limits: {linear_velocity: 0.22}", 0.5, 0.22, "refuse"),  # nobody says by it that this robot can do more
        ("limits: {distance: 3.0}", None, 0.5, "clamp"),
    ],
)
def test_a_parameter_makes_the_limit_of_a_robot_file_less_and_never_more(tmp_path, file, asked, found, over):
    given = {"max_linear": asked} if asked is not None else {}
    if file is not None:
        given["robot"] = str(tmp_path / "robot.yaml")
        (tmp_path / "robot.yaml").write_text(f"name: mine\n{file}\n")
    limits = read("intent_engine", given).robot.limits
    assert (limits.linear_velocity, limits.over_each.get("linear_velocity", limits.over)) == (found, over)


@pytest.mark.ros2
@pytest.mark.parametrize(
    ("given", "found"),
    [
        ({}, ["home.yaml"]),
        ({"grammar": "de"}, ["zuhause.yaml"]),
        ({"grammar": ["de", "en"]}, ["zuhause.yaml", "home.yaml"]),
        ({"grammar": "de", "locations": ""}, ["zuhause.yaml"]),
        ({"grammar": "de", "locations": "home"}, ["home.yaml"]),
    ],
)
@pytest.mark.parametrize("name", ["intent_engine", "speech"])
def test_without_a_map_it_is_the_home_in_the_language_of_the_grammar(name, given, found):
    assert [file.name for file in read(name, given).locations] == found


@pytest.mark.ros2
@pytest.mark.parametrize("name", ["intent_engine", "speech"])
def test_files_that_are_missing_are_told_together(name):
    with pytest.raises(ConfigError) as told:
        read(name, {"grammar": "klingon", "locations": "moon"})
    assert [problem.message for problem in told.value.problems] == [
        "no file klingon.yaml in grammars/",
        "no file moon.yaml in locations/",
    ]


@pytest.mark.ros2
def test_the_parameter_file_can_be_given(peer, package):
    from ros_stage import NodeProcess, until

    with NodeProcess(peer, "--params-file", str(package / "config/voice_commands.yaml")) as node:
        peer.meet()
        peer.say("turn left ten degrees")
        until(lambda: peer.goals("succeeded"))
        assert node.end() == 0
