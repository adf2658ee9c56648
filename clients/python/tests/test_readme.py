# SPDX-License-Identifier: AGPL-3.0-or-later
"""The beginnings of the README and of docs/integrate.md, as they stand there."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from serving import SOURCE, Server


class Readme(unittest.TestCase):
    def run_program_of(self, page):
        """What the page's program says. It runs in `self.folder`, which has the examples."""
        server = Server()
        self.addCleanup(server.stop)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        program = re.search(r"```python\n(.*?)```", (SOURCE / page).read_text(), flags=re.DOTALL).group(1)
        self.assertIn("ws://127.0.0.1:7464/v1", program)
        done = subprocess.run(
            [sys.executable, "-c", program.replace("ws://127.0.0.1:7464/v1", server.url)],
            cwd=self.folder, env=server.environment, capture_output=True, text=True, timeout=240)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_the_readme(self):
        said = self.run_program_of("clients/python/README.md")
        self.assertEqual(len(re.findall(r"^without the hole at .* m: 13\.4\d MPa", said, flags=re.MULTILINE)), 4, said)
        self.assertRegex(said, r"8398 triangles; 13\.4\d MPa at \[")
        self.assertIn("<VTKFile", (self.folder / "part.vtu").read_bytes()[:200].decode())

    def test_the_integrators_manual(self):
        self.assertRegex(self.run_program_of("docs/integrate.md"), r"^13\.447\d* MPa\n13\.449\d* MPa\n$")


if __name__ == "__main__":
    unittest.main()
