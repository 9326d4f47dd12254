"""The ROS packages as files: whole, and of one mind with each other."""

import ast
import re
import subprocess
import sys
from xml.etree import ElementTree

import pytest

from tests.clients.ros.conftest import CLIENTS, ROS1, ROS2
from tests.clients.ros.rclpy_stub import fields_of, interfaces

INTERFACES, NODE2 = ROS2 / "cair_interfaces", ROS2 / "cair_ros2"
PACKAGES = [ROS1, INTERFACES, NODE2]
MESSAGES = ["msg/Action.msg", "msg/Reply.msg", "srv/Say.srv", "srv/Start.srv"]


def tree(file):
    return ast.parse(file.read_text(encoding="utf-8"))


def calls(file, *names):
    """Return the calls of these functions, in the order of the file."""
    return [
        one
        for one in ast.walk(tree(file))
        if isinstance(one, ast.Call)
        and (one.func.attr if isinstance(one.func, ast.Attribute) else getattr(one.func, "id", ""))
        in names
    ]


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.name)
def test_each_manifest_names_its_package_and_all_that_its_code_imports(package):
    manifest = ElementTree.parse(package / "package.xml").getroot()  # noqa: S314 - our own file
    assert manifest.findtext("name") == package.name
    needed = {one.text for one in manifest if one.tag.endswith("depend")}
    modules = [file for file in package.rglob("*.py") if file.name not in ("setup.py",)]
    imported = {
        (one.module or "").split(".")[0]
        for file in modules
        for one in ast.walk(tree(file))
        if isinstance(one, ast.ImportFrom) and not one.level
    }
    known = {"rospy", "rclpy", "std_msgs", "std_srvs", "cair_interfaces", "launch", "launch_ros"}
    assert imported & known <= needed


@pytest.mark.parametrize("package", [ROS1, INTERFACES], ids=lambda package: package.name)
def test_each_message_file_is_built(package):
    there = {file.name for kind in ("msg", "srv") for file in (package / kind).iterdir()}
    assert there == {name.split("/")[1] for name in MESSAGES}
    recipe = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    assert set(re.findall(r"\w+\.(?:msg|srv)", recipe)) == there


@pytest.mark.parametrize("name", MESSAGES)
def test_both_generations_of_ros_have_the_same_messages(name):
    first, second = ((one / name).read_text(encoding="utf-8") for one in (ROS1, INTERFACES))
    assert first.replace("cair_ros/", "cair_interfaces/") == second
    names = [[name for _, name in fields_of(part)] for part in second.split("---")]
    assert all(len(set(part)) == len(part) for part in names)


@pytest.mark.parametrize(
    "node", [ROS1 / "src/cair_ros/node.py", NODE2 / "cair_ros2/node.py"], ids=["ros1", "ros2"]
)
def test_the_code_names_only_fields_that_the_messages_have(node):
    modules = interfaces(INTERFACES)
    messages = modules["cair_interfaces.msg"]
    for call in calls(node, "Reply", "Action"):
        assert {one.arg for one in call.keywords} <= set(messages[call.func.id].fields)
    asked = {
        one.attr
        for one in ast.walk(tree(node))
        if isinstance(one, ast.Attribute) and getattr(one.value, "id", "") == "request"
    }
    services = modules["cair_interfaces.srv"].values()
    assert asked == {field for one in services for field in one.Request.fields}


def test_roslaunch_sets_what_the_ros_1_node_reads():
    launch = ElementTree.parse(ROS1 / "launch" / "cair.launch").getroot()  # noqa: S314 - our own file
    node = launch.find("node")
    assert (node.get("pkg"), node.get("type")) == ("cair_ros", "cair_node")
    assert (ROS1 / "scripts" / "cair_node").stat().st_mode & 0o111
    given = {one.get("name") for one in node.findall("param")}
    named = calls(ROS1 / "src/cair_ros/node.py", "get_param", "_text", "_number", "_names")
    first = [one.args[0] for one in named if isinstance(one.args[0], ast.Constant)]
    assert given | {"key"} == {one.value.lstrip("~") for one in first}
    assert given <= {one.get("name") for one in launch.findall("arg")}


def test_the_ros_2_launch_file_sets_what_the_node_declares():
    arguments = _dictionary(NODE2 / "launch" / "cair.launch.py", "ARGUMENTS")
    parameters = _dictionary(NODE2 / "cair_ros2" / "node.py", "PARAMETERS")
    assert set(arguments) | {"key"} == set(parameters)
    for name, told in arguments.items():
        assert told.elts[0].id == type(ast.literal_eval(parameters[name])).__name__


def _dictionary(file, name):
    """Return the values, unread, of a dictionary of a module."""
    for one in tree(file).body:
        if isinstance(one, ast.Assign) and getattr(one.targets[0], "id", "") == name:
            return {
                key.value: value
                for key, value in zip(one.value.keys, one.value.values, strict=True)
            }
    raise AssertionError(name)


def test_what_the_packages_share_is_one_file():
    shared = {
        ROS1 / "src/cair_ros/cair_client.py": CLIENTS / "python/cair_client.py",
        NODE2 / "cair_ros2/cair_client.py": CLIENTS / "python/cair_client.py",
        NODE2 / "cair_ros2/talk.py": ROS1 / "src/cair_ros/talk.py",
    }
    for link, file in shared.items():
        assert link.resolve() == file


def test_the_ros_2_package_installs_whole(tmp_path):
    pytest.importorskip("setuptools")
    (tmp_path / "cair_ros2").symlink_to(NODE2)
    command = [sys.executable, "setup.py", "-q", "egg_info", "--egg-base", str(tmp_path)]
    command += ["build", "--build-base", str(tmp_path / "build")]
    command += ["install", "--prefix", str(tmp_path / "to"), "--record", str(tmp_path / "files")]
    command += ["--single-version-externally-managed"]
    done = subprocess.run(
        command, cwd=NODE2, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 0, done.stderr
    installed = (tmp_path / "files").read_text()
    for name in ("cair_client.py", "talk.py", "node.py", "lib/cair_ros2/cair_node"):
        assert f"{name}\n" in installed
    for name in ("launch/cair.launch.py", "resource_index/packages/cair_ros2", "package.xml"):
        assert f"{name}\n" in installed
    assert not (NODE2 / "build").exists()


def test_no_page_is_longer_than_a_page():
    for folder in ("ros1", "ros2"):
        page = (CLIENTS / folder / "README.md").read_text(encoding="utf-8")
        assert len(page.splitlines()) <= 120
