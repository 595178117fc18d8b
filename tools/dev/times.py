# SPDX-License-Identifier: MIT
"""times.py BUILD: where the minutes of the last ./dev test went: stages, compilation by folder, tests, slow cases."""

import collections
import json
import pathlib
import sys
import xml.etree.ElementTree


def compilation(log):
    """Seconds of compiler by folder, of everything that stands in this build folder now, in whatever run it was built."""
    newest = {}
    for line in log.read_text().splitlines()[1:]:
        begin_ms, end_ms, _, output, _ = line.split("\t")
        newest[output] = (int(end_ms) - int(begin_ms)) / 1000
    folders = collections.Counter()
    counts = collections.Counter()
    for output, seconds in newest.items():
        if output.endswith((".o", ".gch")):
            folder = output.split("/CMakeFiles/")[0]
            folders[folder] += seconds
            counts[folder] += 1
    return folders, counts


def main(build):
    print("\nStages, seconds")
    for line in (build / "times.txt").read_text().splitlines():
        name, seconds = line.rsplit(" ", 1)
        print(f"  {int(seconds):6d}  {name.replace('_', ' ')}")
    for log in sorted(build.glob("*/.ninja_log")):
        folders, counts = compilation(log)
        print(f"\nCompiled in {log.parent}: {sum(counts.values())} objects, {sum(folders.values()):.0f} s of one core")
        for folder, seconds in folders.most_common(12):
            print(f"  {seconds:6.0f}  {counts[folder]:4d} objects  {folder}")
    results = build / "host/test-results.xml"
    if results.exists():
        cases = xml.etree.ElementTree.parse(results).getroot().iter("testcase")
        tests = sorted(((float(case.get("time")), case.get("name")) for case in cases), reverse=True)
        print(f"\nTests, seconds of wall clock: {sum(seconds for seconds, _ in tests):.0f} in {len(tests)} programs")
        for seconds, name in tests[:15]:
            print(f"  {seconds:6.1f}  {name}")
    cases = []
    for file in (build / "host/test-times").glob("*.json"):
        try:
            suites = json.loads(file.read_text())["testsuites"]
        except json.JSONDecodeError:  # two shards of a program wrote it at once
            continue
        for suite in suites:
            cases += [(float(case["time"].rstrip("s")), f"{suite['name']}.{case['name']}") for case in suite["testsuite"]]
    if cases:
        print(f"\nSlowest of {len(cases)} cases")
        for seconds, name in sorted(cases, reverse=True)[:15]:
            print(f"  {seconds:6.1f}  {name}")


main(pathlib.Path(sys.argv[1]))
