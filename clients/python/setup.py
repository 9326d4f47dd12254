"""Builds cair-client; all but the stubs is in setup.cfg."""

import os

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithStubs(build_py):
    """Adds cair_client.pyi where type checkers look; beside a module they do not (PEP 561)."""

    def run(self):
        build_py.run(self)
        self.mkpath(os.path.dirname(self._stub()))
        self.copy_file("cair_client.pyi", self._stub(), preserve_mode=False)

    def get_outputs(self, include_bytecode=1):
        return build_py.get_outputs(self, include_bytecode) + [self._stub()]

    def _stub(self):
        return os.path.join(self.build_lib, "cair_client-stubs", "__init__.pyi")


setup(cmdclass={"build_py": BuildWithStubs})
