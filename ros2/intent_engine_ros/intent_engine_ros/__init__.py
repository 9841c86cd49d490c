"""Makes Intent Engine's nodes known to ROS 2. The nodes themselves are in ``intent_engine.ros2``."""
