# SPDX-License-Identifier: MIT
"""Numbers keep their point where a program round the package has set a locale with a decimal comma."""

import os
import pathlib
import subprocess
import sys

import pytest

SCRIPT = """
import locale, sys
import fantail
if sys.argv[1]:
    locale.setlocale(locale.LC_ALL, sys.argv[1])
    assert locale.localeconv()["decimal_point"] == ","
plan = fantail.plan("tasha3_launch2", set={"controller.proportional_gain": 0.45})
flight = fantail.fly("tasha3_launch2", set={"wind.speed_m_s": 2.5})
flight.write(sys.argv[2])
open(sys.argv[2] + "/plan.toml", "w").write(str(plan))
print(flight.verdict)
"""


@pytest.fixture(scope="module")
def german(tmp_path_factory):
    if not pathlib.Path("/usr/share/i18n/locales/de_DE").exists():
        pytest.skip("no locales to make one of (package locales)")
    folder = tmp_path_factory.mktemp("locales")
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], capture_output=True, text=True)
    assert made.returncode in (0, 1), made.stderr  # 1: with warnings
    return {**os.environ, "LOCPATH": str(folder)}


def test_nothing_that_is_read_or_written_changes_with_a_decimal_comma(german, tmp_path):
    said = [subprocess.run([sys.executable, "-c", SCRIPT, locale, str(tmp_path / (locale or "plain"))], env=german,
                           capture_output=True, text=True, check=True).stdout for locale in ("", "de_DE.UTF-8")]
    assert said[0] == said[1]
    for file in (tmp_path / "plain").iterdir():
        assert file.read_bytes() == (tmp_path / "de_DE.UTF-8" / file.name).read_bytes(), file.name


def test_the_programs_heed_no_locale(german, tmp_path):
    for locale in ("C", "de_DE.UTF-8"):
        subprocess.run([os.environ["FANTAIL_PROGRAM"], "fly", "tasha3_launch2", "--set", "wind.speed_m_s=2.5", "--out", str(tmp_path / locale)],
                       env={**german, "LC_ALL": locale}, stdout=subprocess.DEVNULL, check=True)
    for file in (tmp_path / "C").iterdir():
        assert file.read_bytes() == (tmp_path / "de_DE.UTF-8" / file.name).read_bytes(), file.name
