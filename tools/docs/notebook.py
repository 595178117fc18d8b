# SPDX-License-Identifier: MIT
"""A notebook as a page: its texts and its code. What the code prints is not kept in the repository."""

import json


def as_page(file):
    parts = []
    for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
        text = "".join(cell["source"])
        parts.append(text if cell["cell_type"] == "markdown" else f"```python\n{text}\n```")
    parts.append(f"*This is `docs/notebooks/{file.name}`; `./dev examples` runs it, and so does Jupyter with the package "
                 "[fantail](../python.md).*")
    return "\n\n".join(parts) + "\n"
