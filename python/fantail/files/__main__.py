# SPDX-License-Identifier: MIT
"""What the programs of Fantail call, with a file as standard input and its result as standard output:

  read ENDING            a line of JSON (units, notes, what is no column), then the columns as CSV
  convert ENDING ENDING  the one kind of file as the other
  export FORMAT          a flight that fantail log export hands over (_export.py)
  install FOLDER         makes an environment with the packages of requirements.txt

Exit codes: 0, 65 bad file, 69 a package is missing (its name is the message), 70 anything else. It opens no file by name.
"""
import importlib
import json
import os
import pathlib
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
if not __package__:  # run by its path, without the rest of the package, which needs a compiled module
    sys.path[0] = str(HERE.parent)
    from files import BadFile, read_stream, written
else:
    from . import BadFile, read_stream, written

BAD_FILE, NOT_INSTALLED, INTERNAL_ERROR, INTERRUPTED = 65, 69, 70, 130
# What unpacks to more is a bomb: the memory of its data, and what it may write.
MOST_MEMORY, MOST_WRITTEN = 4 << 30, 512 << 20


def part(name):
    return importlib.import_module(f"{read_stream.__module__}.{name}")


def read(ending):
    table = read_stream(sys.stdin.buffer, ending)
    lines = part("_table").csv_lines(table)
    head = {"units": table.units, "not_columns": table.not_columns, "notes": table.notes}
    sys.stdout.buffer.write(json.dumps(head).encode() + b"\n")
    for line in lines:
        sys.stdout.buffer.write(line.encode() + b"\n")


def convert(ending, target):
    table = read_stream(sys.stdin.buffer, ending)
    sys.stdout.buffer.write(written(table, target))
    for note in table.notes:
        print(note, file=sys.stderr)


def export(kind):
    module = part("_export")
    sys.stdout.buffer.write(module.EXPORTS[kind](module.Flight(sys.stdin.buffer)))


def install(folder):
    import venv
    try:
        venv.create(folder, with_pip=True, clear=True)
    except subprocess.CalledProcessError:  # Debian has it in a package of its own
        raise ImportError("python3-venv, a Debian package") from None
    subprocess.run([os.path.join(folder, "bin", "python"), "-m", "pip", "--disable-pip-version-check", "install", "--no-deps", "-r",
                    HERE / "requirements.txt"], check=True, stdout=sys.stderr)


def main(words):
    verbs = {"read": read, "convert": convert, "export": export, "install": install}
    try:
        if words[0] != "install":
            resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))
            resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_WRITTEN, MOST_WRITTEN))
        verbs[words[0]](*words[1:])
        sys.stdout.flush()
        return 0
    except BadFile as error:
        return said(error, BAD_FILE)
    except ImportError as error:
        return said((error.name or str(error)).partition(".")[0], NOT_INSTALLED)
    except MemoryError:
        return said(f"takes more than {MOST_MEMORY >> 30} GB of memory", BAD_FILE)
    except KeyboardInterrupt:
        return INTERRUPTED
    except OSError as error:
        return said(f"is too large: more than {MOST_WRITTEN >> 20} MB" if error.errno == 27 else error, BAD_FILE)  # EFBIG
    except Exception as error:
        return said(f"{type(error).__name__}: {error}", INTERNAL_ERROR)


def said(message, code):
    print(" ".join(str(message).split()), file=sys.stderr)
    sys.stdout = open(os.devnull, "w")  # what was written in part is flushed into nothing
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
