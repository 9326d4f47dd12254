"""Builds cair_ros2; run by colcon."""

from setuptools import setup

setup(
    name="cair_ros2",
    version="1.0.0",
    description="A robot's side of a talk with a CAIR server.",
    license="Apache-2.0",
    packages=["cair_ros2"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/cair_ros2"]),
        ("share/cair_ros2", ["package.xml"]),
        ("share/cair_ros2/launch", ["launch/cair.launch.py"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    entry_points={"console_scripts": ["cair_node = cair_ros2.node:main"]},
)
