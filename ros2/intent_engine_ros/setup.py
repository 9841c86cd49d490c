"""What colcon, or pip, installs: the nodes under their ROS names, the launch file and its parameters."""

from setuptools import setup

NAME = "intent_engine_ros"

setup(
    name=NAME,
    version="0.1.0",
    packages=[NAME],
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
        (f"share/{NAME}/launch", ["launch/voice_commands.launch.xml"]),
        (f"share/{NAME}/config", ["config/voice_commands.yaml"]),
    ],
    zip_safe=True,
    license="Apache-2.0",
    description="A person speaks, a robot does it: the nodes of Intent Engine.",
    entry_points={
        "console_scripts": [
            "intent_engine = intent_engine.ros2.node:main",
            "speech = intent_engine.ros2.speech:main",
        ]
    },
)
