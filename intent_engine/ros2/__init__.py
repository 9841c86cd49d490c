"""The ROS 2 nodes: text to a moving robot, and speech to text. Nothing outside this room imports it."""
