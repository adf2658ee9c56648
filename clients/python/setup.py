# SPDX-License-Identifier: AGPL-3.0-or-later
"""What pyproject.toml cannot say: the messages are made of the protocol's .proto files. Needs protoc."""
import pathlib
import sys

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from generate import generate  # noqa: E402


class BuildWithMessages(build_py):
    def run(self):
        super().run()
        generate(HERE.parent.parent / "protocol", pathlib.Path(self.build_lib))


setup(cmdclass={"build_py": BuildWithMessages})
