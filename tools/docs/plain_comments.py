# SPDX-License-Identifier: MIT
"""Usage: plain_comments.py HEADER

A header as Doxygen is to read it: plain comments that stand right before a declaration, or behind one, are what is said of it.
"""

import re
import sys

lines = open(sys.argv[1], encoding="utf-8").read().split("\n")
DECLARES = re.compile(r"\s*(struct|class|enum|using|template|inline|constexpr|\[\[|[\w:<>]+&? \w+[\s({;=])")
FOR_TOOLS = re.compile(r"SPDX|NOLINT|clang-format")
PLAIN = re.compile(r"(\s*)//(?!/)( .*)")
documents = False  # does the line below a comment declare something, or go on with such a comment?
for i in reversed(range(len(lines))):
    if match := PLAIN.fullmatch(lines[i]):
        if documents and not FOR_TOOLS.search(lines[i]):
            lines[i] = f"{match[1]}///{match[2]}"
    else:
        lines[i] = re.sub(r"([;,])(\s+)//(?!/) ", r"\1\2///< ", lines[i])
        documents = DECLARES.match(lines[i]) is not None
print("\n".join(lines), end="")
