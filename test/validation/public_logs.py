# SPDX-License-Identifier: MIT
"""What `fantail listen` makes of logs of others: the table of docs/validation.md.

Usage: public_logs.py FANTAIL FILE... (Python alone; FANTAIL_PYTHON for binary logs). Each file is read with nothing said about it.
"""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile


def heard(fantail, file):
    """The map that fits, or the reason; when the launch was detected, in seconds after lift-off; is it in doubt?"""
    with tempfile.TemporaryDirectory() as folder:
        said = subprocess.run([fantail, "listen", str(file), "--out", folder], capture_output=True, text=True, check=False)
    if said.returncode:
        reason = said.stderr.strip().removeprefix(f"fantail: {file}").lstrip(":0123456789 ")
        return "named", re.split(r"\. |; |, the first|: no reading", reason)[0], None, False
    head, finding = said.stdout.splitlines()[:2]
    after = re.search(r"detected after lift-off +([0-9.]+) s", said.stdout)
    return "read", re.search(r"columns of the map (\w+)", head)[1], float(after[1]) if after else None, "in doubt" in finding.split(":")[0]


def main(fantail, files):
    groups = collections.defaultdict(list)
    for file in map(pathlib.Path, files):
        how, what, after_s, doubted = heard(fantail, file)
        print(file.name, how, what, after_s, doubted, file=sys.stderr)
        groups[how, what].append((file.suffix, after_s, doubted))
    print("| | files | launch detected after lift-off, s | in doubt |\n|---|---|---|---|")
    for (how, what), logs in sorted(groups.items(), key=lambda group: (group[0][0] != "read", group[0][1])):
        times = sorted(after_s for _, after_s, _ in logs if after_s is not None)
        detected = f"{times[0]:.2f} to {times[-1]:.2f} ({len(times)})" if times else "-"
        endings = ", ".join(sorted({suffix.lower() for suffix, _, _ in logs}))
        print(f"| {'`' + what + '`' if how == 'read' else what} | {len(logs)} ({endings}) | {detected} | {sum(doubted for *_, doubted in logs) or '-'} |")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
