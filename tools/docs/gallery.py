# SPDX-License-Identifier: MIT
"""Usage: gallery.py PROJECT FANTAIL PAGES WORK

The gallery: pages as the commands below write them, each with a picture and its command; and the pictures of the tutorials, of what
their own lines write. A picture stands in a tutorial as a comment: picture: PAGE what it shows.
"""

import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # not between the sources
import pictures

# What it is, what to look at, the commands. The last one writes the page.
ENTRIES = [
    ("A flight", "Did the roll hold, and why? The rocket beside the same one without control, and every signal.", "fly tasha3_launch2"),
    ("Hands on a gimbal", "The rocket is turned by hand about all three axes: what the avionics measures.", "fly gimbal"),
    ("Two flights on one page", "With the law as published, and with integral action.",
     "fly tasha3_launch2_integral", "report out/tasha3_launch2 out/tasha3_launch2_integral"),
    ("Two logs, compared", "The error of the rocket's own estimate.",
     "compare out/tasha3_launch2 out/tasha3_launch2 --b true --window control"),
    ("What if", "A recorded flight through the flight law again, with another gain.",
     "replay out/tasha3_launch2 --set controller.proportional_gain=0.3"),
    ("The roll model from a log", "Damping, torque and fin offset, with their intervals.",
     "identify out/tasha3_launch2 --window 0.9:8"),
    ("Steps in the tunnel", "Sixteen steps of 45 degrees, each identified.", "fly tunnel_steps",
     "tunnel steps out/tunnel_steps --vehicle tasha3_launch2 --speed 22 --out out/steps"),
    ("Stability in the tunnel", "Static margin of a rocket that swings on its pins.",
     "fly tunnel_stability", "tunnel stability out/tunnel_stability"),
    ("No go", "The first launch, predicted with the fin offset that its flight showed.", "predict tasha3_launch1"),
    ("A campaign", "How often the roll is held over all uncertain values, and which of them matter.", "campaign tasha3_launch2 --runs 200"),
    ("One canard at its stop", "Where the apogee lies when a canard fails, for each canard, stop and instant.", "campaign hardover tasha3_launch2"),
    ("A device broken in every phase", "Faults of the servos: is each outcome one that was stated beforehand?",
     "campaign faults tasha3_launch2 --device servo"),
    ("Gains, searched and flown", "New gains beside those of the plan.", "tune tasha3_launch2 --flights 40"),
    ("A rocket from its shape", "Stability and roll before any tunnel.", "airframe tasha3_launch2"),
    ("Somebody's log", "When would the flight law have detected this launch?", "listen out/tasha3_launch2/flight.csv"),
    ("The publication, repeated", "Every printed number beside ours, with the errors in print.", "paper"),
]
# Pages that need more than a build of the site has: the commands that make them, and where they are then.
MADE = [
    ("The sheet of the bench",
     "A canard that turns the wrong way, found before the launch. This sheet is stored in the repository and was not made with this site.",
     "docs/sheets/bench_canard3_reversed.html",
     "with-vcan sh -c './dev node bench_canard3_reversed --can vcan0 & ./dev bench limits --can vcan0 --wait 60 --vehicle tasha3_bench "
     "--out out/reversed'"),
    ("The playground", "Control code and simulator in your browser: turn the sliders. This page was made before the site.", "docs/playground.html", "playground"),
]
PICTURE = re.compile(r"<!-- picture: (\S+) (.*?) -->")


def page_of(fantail, work, commands):
    """The page that the last of these commands has written."""
    for command in commands:
        done = subprocess.run([fantail, *command.split()], cwd=work, capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):  # 1: the answer is no
            raise SystemExit(f"dev: docs: fantail {command} ended with {done.returncode}:\n{done.stderr}")
    pages = re.findall(r"^  (?:report|page) +(\S.*)$", done.stdout, re.MULTILINE)
    if not pages:
        raise SystemExit(f"dev: docs: fantail {command} has written no page:\n{done.stdout}")
    return work / pages[0]


def card(title, meaning, shown, commands):
    lines = "\n".join(f"./dev {command}" for command in commands)
    return f'<div markdown>\n\n{shown}\n\n### {title}\n\n{meaning}\n\n``` {{ .text .wrap }}\n{lines}\n```\n\n</div>\n\n'


def gallery(project, fantail, album, work):
    cards = []
    for number, (title, meaning, *commands) in enumerate(ENTRIES, 1):
        print(f"docs: page {number} of {len(ENTRIES)}: ./dev {commands[-1]}", file=sys.stderr)
        html = page_of(fantail, work, commands)
        cards.append(card(title, meaning, album.add(html, re.sub(r"\W+", "_", title.lower()), title, "docs/gallery.md"), commands))
    for title, meaning, html, *commands in MADE:
        if (project / html).exists():
            name = re.sub(r"\W+", "_", title.lower())
            cards.append(card(title, meaning, album.add(project / html, name, title, "docs/gallery.md"), commands))
    (album.pages / "docs/gallery.md").write_text(
        "---\nhide: [toc]\n---\n\n# Gallery\n\nPages that Fantail writes, each with the command that writes it, which was run while this "
        "site was built, except where the text says otherwise. Press a picture to open the page itself, which needs no network.\n\n"
        '<div class="shots" markdown>\n\n' + "".join(cards) + "</div>\n",
        encoding="utf-8")
    return len(cards)


def tutorial(project, fantail, album, work, file):
    """Runs the lines of a tutorial, and puts the pictures of what they have written into its page."""
    print(f"docs: {file.stem}: its lines", file=sys.stderr)
    work.mkdir(parents=True)
    script = project / "test/system/documented_lines.py"
    lines = [sys.executable, "-B", script, project, fantail, file.relative_to(project), "--in", work]
    if subprocess.run(lines, check=False, stdout=sys.stderr).returncode:
        raise SystemExit(f"dev: docs: {file.name}: its lines do not do what it says; see above")
    page = album.pages / file.relative_to(project)
    count = 0

    def shown(match):
        nonlocal count
        count += 1
        html = list(work.glob(match[1]))
        if len(html) != 1:
            raise SystemExit(f"dev: docs: {file}: a picture of {match[1]}, and that is {len(html)} pages")
        return album.add(html[0], f"{file.stem}_{count}", match[2], file.relative_to(project))

    page.write_text(PICTURE.sub(shown, page.read_text(encoding="utf-8")), encoding="utf-8")
    return count


def main():
    project, fantail, pages, work = (pathlib.Path(word).absolute() for word in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    (work / "gallery").mkdir(parents=True)
    with pictures.Album(pages) as album:
        tutorials = sorted((project / "docs/tutorials").glob("*.md"))
        count = sum(tutorial(project, fantail, album, work / file.stem, file) for file in tutorials)
        count += gallery(project, fantail, album, work / "gallery")
    print(f"docs: pictures of {count} pages", file=sys.stderr)


main()
