"""A thread that spins a node, and ends before the node is destroyed."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

__all__ = ["Spinning"]

PATIENCE = 1.0
"""s in which a callback that is under way should return."""


class Spinning:
    """Calls the callbacks of one node.

    rclpy's executor cannot be shut down while another thread spins it: that may miss it, and waits for ever for a node
    that is destroyed, which ends the process with a segmentation fault. So the thread ends first.

    Args:
        node: of rclpy.
        failed: is told what a callback raised, which ends the spinning.
        over: called at the end, whatever the reason.
    """

    def __init__(
        self,
        node: Any,
        *,
        failed: Callable[[Exception], object] | None = None,
        over: Callable[[], object] = lambda: None,
    ) -> None:
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.task import Future

        self._executor = SingleThreadedExecutor(context=node.context)
        self._executor.add_node(node)
        self._failed = failed
        self._over = over
        self._ending = Future()
        self._thread = threading.Thread(target=self._spin, name="ros", daemon=True)
        self._thread.start()

    def end(self) -> bool:
        """Spin no more. Returns whether the node may be destroyed: False while a callback does not return."""
        self._ending.set_result(None)
        self._thread.join(PATIENCE)
        self._executor.shutdown(timeout_sec=PATIENCE)
        self._thread.join(PATIENCE)  # where an older rclpy does not see the end that it was given
        return not self._thread.is_alive()

    def _spin(self) -> None:
        from rclpy.executors import ExternalShutdownException

        try:
            self._executor.spin_until_future_complete(self._ending)
        except ExternalShutdownException:
            pass
        except Exception as error:
            if self._failed is None:
                raise
            self._failed(error)
        finally:
            self._over()
