"""A copy of the project in out/, to be deliberately broken and tested there."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class ProjectCopy:
    """A copy of the files known to git, in their present state. The build output of an earlier copy is kept beside it
    and reused."""

    def __init__(self, name):
        self.out = ROOT / "out" / name
        self.root = self.out / "copy"
        self.renew()

    def renew(self):
        """Makes the copy equal to the project again."""
        shutil.rmtree(self.root, ignore_errors=True)
        listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        done = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True)
        names = done.stdout.split("\0")
        if done.returncode != 0 or "Cargo.toml" not in names:
            sys.exit(f"{ROOT} is not a git checkout, which lists the files to copy: clone the project\n{done.stderr}")
        for name in filter(None, names):
            if (ROOT / name).is_file():
                (self.root / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, self.root / name)

    def cargo(self, *words):
        """The messages of a cargo command in the copy, and whether it succeeded."""
        settings = {**os.environ, "CARGO_TARGET_DIR": str(self.out / "target"), "CARGO_PROFILE_DEV_DEBUG": "0"}
        command = ["cargo", *words, "--message-format=json"]
        done = subprocess.run(command, cwd=self.root, env=settings, capture_output=True, text=True)
        return [json.loads(line) for line in done.stdout.splitlines()], done.returncode == 0

    def build_tests(self, names):
        """The paths of these test programs; that of the library itself is called stribeck. None if they do not
        build."""
        tests = ["--lib", *(f"--test={name}" for name in names)]
        messages, succeeded = self.cargo("test", "--no-run", "--package", "stribeck", *tests)
        programs = {m["target"]["name"]: m["executable"] for m in messages if m.get("executable")}
        return programs if succeeded and programs.keys() == {"stribeck", *names} else None


def errors(messages):
    """The error messages of the compiler."""
    found = [m["message"] for m in messages if m["reason"] == "compiler-message"]
    return [message for message in found if message["level"] == "error"]
