# SPDX-License-Identifier: MIT
"""Usage: image_report_test.py IMAGE_REPORT.py IMAGE.elf

A deepest stack that comes from half a call graph is a number that somebody trusts: where an object has none beside it, the
report says so, fails, and prints no number.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

report, elf = sys.argv[1], pathlib.Path(sys.argv[2])
if not elf.exists():
    print(f"SKIPPED: {elf} has not been built: ./dev firmware")
    sys.exit(77)


def lines(build: pathlib.Path) -> tuple[int, str]:
    done = subprocess.run([sys.executable, report, str(build / elf.name), "--check"], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as folder:
    build = pathlib.Path(folder)
    shutil.copy(elf, build)
    shutil.copy(elf.with_suffix(".map"), build)
    objects = [o for part in ("firmware", "hal") for o in (elf.parent / part).glob("**/*.obj")]
    for source in objects:
        copy = build / source.relative_to(elf.parent)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.touch()
        shutil.copy(source.with_suffix(".ci"), copy.with_suffix(".ci"))
    code, text = lines(build)
    assert code == 0 and "deepest stack  " in text, f"with all of it: {code}\n{text}"
    lost = copy.with_suffix(".ci")
    lost.unlink()
    code, text = lines(build)
    assert code == 1 and f"1 of {len(objects)} objects have no call graph" in text, f"without {lost.name}: {code}\n{text}"
    assert "deepest stack  " not in text, text
