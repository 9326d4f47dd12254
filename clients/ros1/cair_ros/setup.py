"""Builds the Python side of cair_ros; run by catkin, not by hand."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=["cair_ros"], package_dir={"": "src"}))
