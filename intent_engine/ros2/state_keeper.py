"""The states of the robot as the node ``intent_engine`` learns and tells them.

In: the parameter ``states``, ``voice_commands/state`` (std_msgs/String). Out: ``voice_commands/current_state``
(std_msgs/String), kept for who comes late.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from intent_engine.errors import ConfigError
from intent_engine.ros2.latched import HearLatched
from intent_engine.ros2.robot_states import PARAMETER, TOPIC, States, in_one_line, states_text

__all__ = ["StateKeeper"]


class StateKeeper:
    """Keeps the states. Everything happens in the thread that spins the node, and nothing that comes in raises.

    Args:
        node: an rclpy node that has the parameter ``states``.
        states: those that hold from the start.
        tell: is told of a change (``state``, ``states=[...]``) and of what is wrong (``error``, ``detail=...``).
    """

    def __init__(self, node: Any, states: States, tell: Callable[..., object]) -> None:
        from rclpy.parameter import Parameter
        from rclpy.qos import DurabilityPolicy, QoSProfile
        from std_msgs.msg import String

        self._states, self._tell, self._log, self._string = states, tell, node.get_logger(), String
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._current = node.create_publisher(String, "voice_commands/current_state", kept)
        # An empty list has the type of bytes, and one word is text: `ros2 param get` is to show what it is.
        names = Parameter("states", Parameter.Type.STRING_ARRAY, sorted(states.by_parameter))
        node.set_parameters([names])
        node.add_on_set_parameters_callback(self._allow)
        node.add_post_set_parameters_callback(self._set)
        self._ear = HearLatched(node, TOPIC, self._heard)
        self._publish()

    @property
    def held(self) -> frozenset[str]:
        """Those that hold."""
        return self._states.held

    def _allow(self, parameters: Iterable[Any]) -> Any:
        """Whether parameters may be set; nothing has been set yet, and another may still say no."""
        from rcl_interfaces.msg import SetParametersResult
        from rclpy.parameter import Parameter

        for each in parameters:
            if each.name != "states":
                continue
            if each.type_ == Parameter.Type.NOT_SET:
                reason = f"{PARAMETER}: it cannot be deleted; for no states set it to []"
                return SetParametersResult(successful=False, reason=reason)
            try:
                self._states.with_parameter(each.value)
            except ConfigError as error:
                return SetParametersResult(successful=False, reason=in_one_line(error))
        return SetParametersResult(successful=True)

    def _set(self, parameters: Iterable[Any]) -> None:
        for each in parameters:
            if each.name == "states":
                self._change(self._states.with_parameter(each.value))

    def _heard(self, text: str) -> None:
        try:
            states = self._states.with_message(text)
        except ConfigError as error:
            detail = f"{in_one_line(error)}; the states are as they were: {states_text(self.held)}"
            self._log.error(detail)
            self._tell("error", detail=detail)
        else:
            self._change(states)

    def _change(self, states: States) -> None:
        before, self._states = self.held, states
        if self.held != before:
            self._publish()
            self._tell("state", states=sorted(self.held))

    def _publish(self) -> None:
        self._current.publish(self._string(data=states_text(self.held)))
