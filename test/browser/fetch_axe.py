# SPDX-License-Identifier: MIT
"""Usage: fetch_axe.py FOLDER

Puts axe.min.js of axe-core (Deque Systems, MPL 2.0) into FOLDER, for pages_test.py. It is this very version, or nothing: it
judges pages in a test, and is no part of Fantail.
"""

import hashlib
import io
import pathlib
import ssl
import sys
import tarfile
import urllib.request

URL = "https://registry.npmjs.org/axe-core/-/axe-core-4.14.1.tgz"
SHA256 = "e6b0ce02b84d892e2e33e403485e7f3d6c29e2be6df65daf44d89ba564139745"

# The checksum says what it is, whoever sent it: a bare Debian has no certificates to ask.
with urllib.request.urlopen(URL, timeout=60, context=ssl._create_unverified_context()) as answer:
    packed = answer.read()
if hashlib.sha256(packed).hexdigest() != SHA256:
    sys.exit(f"{URL} is not the file with the checksum {SHA256}")
folder = pathlib.Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
with tarfile.open(fileobj=io.BytesIO(packed)) as files:
    (folder / "axe.min.js").write_bytes(files.extractfile("package/axe.min.js").read())
