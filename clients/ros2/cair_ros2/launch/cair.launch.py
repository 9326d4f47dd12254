"""ros2 launch cair_ros2 cair.launch.py server:=https://cair.example language:=it person:=Anna."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import EnvironmentVariable, LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

#: The API key is read from the environment (CAIR_KEY): all nodes can read parameters.
ARGUMENTS = {
    "server": (str, EnvironmentVariable("CAIR_SERVER", default_value="http://127.0.0.1:8000")),
    "language": (str, ""),
    "culture": (str, ""),
    "state_file": (str, "~/.ros/{name}_talk.json"),
    "person": (str, ""),
    "gender": (str, ""),
    "capabilities": (str, ""),
    "greet": (bool, "true"),
    "step_seconds": (float, "0.0"),
    "patience": (float, "10.0"),
    "timeout": (float, "10.0"),
    "ca_file": (str, ""),
    "seed": (int, "0"),
}


def generate_launch_description():
    """Return the node, with an argument for each parameter."""
    declared = [
        DeclareLaunchArgument(name, default_value=default)
        for name, (_, default) in ARGUMENTS.items()
    ]
    parameters = {
        name: ParameterValue(LaunchConfiguration(name), value_type=kind)
        for name, (kind, _) in ARGUMENTS.items()
    }
    declared.append(DeclareLaunchArgument("name", default_value="cair"))
    node = Node(
        package="cair_ros2",
        executable="cair_node",
        name=LaunchConfiguration("name"),
        parameters=[parameters],
        output="screen",
        respawn=True,
        respawn_delay=2.0,
    )
    return LaunchDescription([*declared, node])
