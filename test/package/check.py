# SPDX-License-Identifier: MIT
"""Usage: check.py DEB SOURCES KEPT
Tries a Debian package and the sources as one file in bare systems, and says of each step how it went. Each function named in
STEPS is one; what it does not say with an exception has passed. Without root and debootstrap only the first is run."""
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import bare

ORDINARY = {"PATH": "/usr/bin:/bin", "HOME": "/home/anna", "LC_ALL": "C.UTF-8"}


class Try:
    def __init__(self, system, deb, sources):
        self.system, self.deb, self.sources = system, deb, sources

    def root(self, *words, **options):
        return self.system.run(*words, capture_output=True, **options).stdout

    def anna(self, *words, folder="/home/anna", environment=None, **options):
        """As an ordinary user."""
        variables = ORDINARY if environment is None else environment
        return self.system.run(*words, user="anna", folder=folder, environment=variables, capture_output=True, **options)

    def file(self, path):
        return (self.system.folder / path.lstrip("/")).read_bytes()


def wanted(is_so, what):
    if not is_so:
        raise RuntimeError(what)


def version_of(deb):
    return bare.said("dpkg-deb", "-f", deb, "Version").strip()


def older(deb):
    """The package under a lower version, with a file that the newer one no longer has."""
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work, "older")
        bare.said("dpkg-deb", "-R", deb, folder)
        control = folder / "DEBIAN/control"
        control.write_text(control.read_text(encoding="utf-8").replace("Version: ", "Version: 0.0~"), encoding="utf-8")
        (folder / "usr/share/fantail/no_longer").write_text("")
        made = deb.with_name("older.deb")
        bare.said("dpkg-deb", "--root-owner-group", "-Znone", "-b", folder, made)
    return made


def an_older_version_is_installed_with_what_it_depends_on(t):
    made = older(t.deb)
    t.system.put(made, "/root/older.deb")
    made.unlink()
    t.root("useradd", "--create-home", "anna")
    t.root("apt-get", "update")
    t.root("apt-get", "install", "-y", "--no-install-recommends", "/root/older.deb")
    wanted(t.system.holds("/usr/share/fantail/no_longer"), "the older version is not whole")
    t.anna("fantail", "new", "mine", "--from", "tasha3_launch2")


def it_is_upgraded(t):
    t.system.put(t.deb, "/root/newer.deb")
    t.root("apt-get", "install", "-y", "--no-install-recommends", "/root/newer.deb")
    installed = t.root("dpkg-query", "-W", "-f", "${Version}", "fantail")
    wanted(installed == version_of(t.deb), f"installed is {installed}")
    wanted(not t.system.holds("/usr/share/fantail/no_longer"), "a file of the older version is left")
    wanted(t.root("dpkg", "--verify", "fantail") == "", "dpkg --verify finds what differs")


def an_ordinary_user_flies_within_a_minute(t):
    begun = time.monotonic()
    t.anna("fantail", "fly")
    wanted(time.monotonic() - begun < 60, "it took a minute or more")
    wanted(t.file("/home/anna/out/tasha3_launch2/report.html"), "there is no report")
    t.anna("fantail", "fly", "mine/scenario.toml", "--out", "out/mine")


def that_user_may_not_write_the_data(t):
    t.anna("sh", "-c", '! find /usr/share/fantail /usr/libexec/fantail /usr/bin/fantail ! -type l -writable | grep .')


def every_verb_starts(t):
    verbs = re.findall(r"^  ([a-z]+)  +[A-Z]", t.anna("fantail", "--help").stdout, re.MULTILINE)
    wanted(len(verbs) > 15, "the help lists hardly any verbs")
    for verb in verbs:
        t.anna("fantail", verb, "--help")


def no_home_and_one_that_cannot_be_written_do_not_matter(t):
    t.anna("fantail", "fly", "--out", "out/no_home", environment={"PATH": ORDINARY["PATH"]})
    t.root("install", "-d", "-m", "555", "/home/locked")
    t.anna("fantail", "fly", "--out", "out/locked", environment={**ORDINARY, "HOME": "/home/locked"})
    for file in ("flight.csv", "report.html"):
        wanted(t.file("/home/anna/out/no_home/" + file), "a file is empty")
        wanted(t.file("/home/anna/out/locked/" + file), "a file is empty")


def numbers_keep_their_point_where_german_is_spoken(t):
    t.root("apt-get", "install", "-y", "--no-install-recommends", "locales")
    t.root("localedef", "-i", "de_DE", "-f", "UTF-8", "de_DE.UTF-8")
    german = {**ORDINARY, "LANG": "de_DE.UTF-8", "LC_ALL": "de_DE.UTF-8"}
    wanted("," in t.anna("sh", "-c", "locale decimal_point", environment=german).stdout, "the locale is not there")
    fly = ("fantail", "fly", "--set", "controller.proportional_gain=0.25", "--out")
    t.anna(*fly, "out/point")
    t.anna(*fly, "out/comma", environment=german)
    for file in ("flight.csv", "flight.ftl", "summary.json"):
        same = t.file("/home/anna/out/point/" + file) == t.file("/home/anna/out/comma/" + file).replace(b"out/comma", b"out/point")
        wanted(same, f"{file} is another in German")
    refused = t.anna("fantail", "fly", "--set", "controller.proportional_gain=0,25", environment=german, check=False)
    wanted(refused.returncode != 0, "a comma is taken")


def pages_and_completions_lie_where_debian_looks(t):
    for path in ("man/man1/fantail-fly.1.gz", "man/man5/fantail.toml.5.gz", "zsh/vendor-completions/_fantail",
                 "bash-completion/completions/fantail", "fish/vendor_completions.d/fantail.fish", "fantail/firmware/image/fantail-stm32f405.hex"):
        wanted(t.file("/usr/share/" + path), path)


def removed_and_purged_it_leaves_only_the_files_of_its_users(t):
    for word in ("remove", "purge"):
        t.root("apt-get", "install", "-y", "--no-install-recommends", "/root/newer.deb")
        t.root("apt-get", word, "-y", "fantail")
        left = t.root("find", "/usr", "/etc", "/var", "-name", "*fantail*", "-not", "-path", "/var/log/*", "-not", "-path", "/var/cache/apt/*")
        wanted(left == "", f"after apt-get {word} there is still {left}")
    wanted(t.file("/home/anna/mine/scenario.toml") and t.file("/home/anna/out/tasha3_launch2/flight.csv"), "a user's files are gone")


def the_sources_as_one_file_build_and_fly_without_git(t):
    name = t.sources.name
    t.system.put(t.sources, "/home/anna/" + name)
    t.root("tar", "-C", "/home/anna", "-xzf", "/home/anna/" + name)
    folder = "/home/anna/" + name.removesuffix(".tar.gz")
    wanted(t.system.run("sh", "-c", "command -v git", check=False, capture_output=True).returncode, "git is there")
    t.root("./dev", "fly", folder=folder)
    wanted(t.system.run("sh", "-c", "command -v git", check=False, capture_output=True).returncode, "git was installed")
    said = t.root("./dev", "log", "info", "out/tasha3_launch2", folder=folder)
    print("   " + next(line for line in said.splitlines() if "-archive" in line))


STEPS = (
    an_older_version_is_installed_with_what_it_depends_on, it_is_upgraded, an_ordinary_user_flies_within_a_minute,
    that_user_may_not_write_the_data, every_verb_starts, no_home_and_one_that_cannot_be_written_do_not_matter,
    numbers_keep_their_point_where_german_is_spoken, pages_and_completions_lie_where_debian_looks,
    removed_and_purged_it_leaves_only_the_files_of_its_users, the_sources_as_one_file_build_and_fly_without_git)


def unpacked(deb):
    """Without root: what is in the package flies from a folder with any name."""
    with tempfile.TemporaryDirectory(prefix="a folder für Ölbaum ") as work:
        bare.said("dpkg-deb", "-x", deb, work + "/root")
        subprocess.run([work + "/root/usr/bin/fantail", "fly"], cwd=work, check=True, stdout=subprocess.DEVNULL)
        wanted(pathlib.Path(work, "out/tasha3_launch2/report.html").stat().st_size, "there is no report")


def step(what, action, *arguments):
    begun = time.monotonic()
    try:
        action(*arguments)
    except (RuntimeError, OSError, subprocess.CalledProcessError) as error:
        raise RuntimeError(f"{what}: {error}") from error
    print(f"package: {what}: passed, {time.monotonic() - begun:.1f} s", flush=True)


def main(deb, sources, kept):
    deb, sources = pathlib.Path(deb).resolve(), pathlib.Path(sources).resolve()
    step("unpacked, it flies from a folder with any name", unpacked, deb)
    refusal = bare.why_not()
    if refusal:
        print(f"package: NOT RUN in bare Debian 12 and 13 ({len(STEPS)} steps each): {refusal}", flush=True)
        return 0
    for suite in ("bookworm", "trixie"):
        step(f"{suite}: there is a bare system", bare.base, suite, kept)
        system = bare.System(bare.base(suite, kept), pathlib.Path(kept, "package-" + suite))
        for action in STEPS:
            step(f"{suite}: {action.__name__.replace('_', ' ')}", action, Try(system, deb, sources))
        system.remove()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(*sys.argv[1:]))
    except RuntimeError as error:
        print(f"package: NOT PASSED: {error}", file=sys.stderr)
        sys.exit(1)
