# SPDX-License-Identifier: MIT
"""Usage: container_test.py PROJECT
What can be said of the container's files without root: `./dev package --container` runs them."""
import json
import os
import pathlib
import sys
import tempfile
import unittest

import container


class Container(unittest.TestCase):
    def test_every_instruction_of_the_dockerfiles_is_known(self):
        for file in ("Dockerfile", ".devcontainer/Dockerfile"):
            self.assertGreater(len(container.steps_of(file)), 5)

    def test_an_instruction_that_is_not_known_is_refused(self):
        with tempfile.NamedTemporaryFile("w") as file:
            file.write("FROM debian:12\nRUN a && \\\n  b\nADD x y\n")
            file.flush()
            with self.assertRaisesRegex(ValueError, "ADD"):
                container.steps_of(file.name)
        self.assertEqual([("RUN", "a &&    b")], list(container.instructions("# c\nRUN a && \\\n  b\n")))

    def test_copied_is_the_folder_without_what_is_ignored(self):
        with tempfile.TemporaryDirectory() as work:
            project, stage = pathlib.Path(work, "project"), pathlib.Path(work, "stage")
            for file in ("build/x", "source/build/y", ".dockerignore"):
                (project / file).parent.mkdir(parents=True, exist_ok=True)
                (project / file).write_text("build\n", encoding="utf-8")
            build = container.Build(project, work)
            build.copy(project, stage, into=False)
            self.assertEqual([".dockerignore", "source"], sorted(os.listdir(stage)))
            self.assertTrue((stage / "source/build/y").exists())

    def test_the_folder_for_development_names_a_user_that_its_dockerfile_makes(self):
        said = json.loads(pathlib.Path(".devcontainer/devcontainer.json").read_text(encoding="utf-8"))
        self.assertTrue(pathlib.Path(".devcontainer", said["build"]["dockerfile"]).exists())
        self.assertIn(("USER", said["remoteUser"]), container.steps_of(".devcontainer/Dockerfile"))


if __name__ == "__main__":
    os.chdir(sys.argv.pop())
    unittest.main()
