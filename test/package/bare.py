# SPDX-License-Identifier: MIT
"""Bare Debian systems in folders, made by debootstrap from the mirror that this machine's apt uses."""
import os
import pathlib
import shutil
import subprocess

PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
# How many compilers run at once is for the caller to say, there too.
ALWAYS = {name: os.environ[name] for name in ("CMAKE_BUILD_PARALLEL_LEVEL",) if name in os.environ}


def why_not():
    """What keeps this machine from making one, or nothing."""
    if os.geteuid() != 0:
        return "this user is not root: a bare system is entered with chroot"
    if not shutil.which("debootstrap"):
        return "debootstrap is not installed: apt-get install debootstrap"
    return ""


def said(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def mirror():
    sources = said("apt-get", "indextargets", "--format", "$(ORIGIN) $(CODENAME) $(REPO_URI)", "Created-By: Packages")
    for origin, name, address in (line.split() for line in sources.splitlines() if line.count(" ") == 2):
        if origin == "Debian" and not name.endswith(("-updates", "-security", "-backports")):
            return address
    return "http://deb.debian.org/debian"


def way_there():
    """The proxies of this machine's apt, and whether it looks at dates, as lines of its configuration."""
    wanted = ("Acquire::http::Proxy", "Acquire::https::Proxy", "Acquire::Check-")
    return "".join(line + "\n" for line in said("apt-config", "dump").splitlines() if line.startswith(wanted))


def base(suite, kept):
    """The archive of such a system; made once, in the folder `kept`."""
    archive = pathlib.Path(kept, suite + ".tar")
    if not archive.exists():
        folder = pathlib.Path(kept, suite + ".making")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        proxy = said("apt-config", "shell", "proxy", "Acquire::http::Proxy").strip().removeprefix("proxy=").strip("'")
        environment = {**os.environ, **({"http_proxy": proxy} if proxy else {})}
        log = archive.with_suffix(".log")
        with open(log, "w", encoding="utf-8") as out:
            made = subprocess.run(["debootstrap", "--variant=minbase", suite, folder, mirror()], env=environment, stdout=out, stderr=out, check=False)
        if made.returncode:
            raise RuntimeError(f"debootstrap could not make a bare {suite}; see {log}")
        pathlib.Path(folder, "etc/apt/apt.conf.d/90way").write_text(way_there(), encoding="utf-8")
        said("chroot", folder, "apt-get", "clean")
        said("tar", "-C", folder, "-cf", archive.with_suffix(".part"), ".")
        archive.with_suffix(".part").rename(archive)
        shutil.rmtree(folder)
    return archive


class System:
    """A bare system in a folder. What runs in it sees no other process, and its mounts are its own: nothing is left of them."""

    def __init__(self, archive, folder):
        self.folder = pathlib.Path(folder)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        said("tar", "-C", self.folder, "-xf", archive)

    def run(self, *words, user="root", folder="/", environment=None, check=True, **options):
        enter = ('mount --make-rprivate / && mount -t proc proc "$0/proc" && user=$1 folder=$2 && shift 2 && '
                 'exec chroot --userspec="$user" "$0" /usr/bin/env -C "$folder" -i "$@"')
        if environment is None:
            environment = {"PATH": PATH, "LC_ALL": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}
        variables = (f"{name}={value}" for name, value in (ALWAYS | environment).items())
        done = subprocess.run(
            ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", enter, self.folder, user, folder, *variables, *words],
            check=False, text=True, stdin=subprocess.DEVNULL, **options)
        if check and done.returncode:
            raise RuntimeError(f"{' '.join(words)} ended with {done.returncode}\n{done.stdout or ''}{done.stderr or ''}")
        return done

    def put(self, file, place):
        shutil.copy(file, self.folder / place.lstrip("/"))

    def holds(self, path):
        return os.path.lexists(self.folder / path.lstrip("/"))

    def remove(self):
        shutil.rmtree(self.folder)
