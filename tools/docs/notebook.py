# SPDX-License-Identifier: MIT
"""A notebook as a page: its texts, its code, and what is kept of what that prints and draws."""

import base64
import json


def outputs(cell, picture):
    """`picture` takes the bytes of one and says where it is."""
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            yield "``` { .text .wrap }\n" + "".join(output["text"]).rstrip("\n") + "\n```"
        elif "image/png" in output.get("data", {}):
            there = picture(base64.b64decode("".join(output["data"]["image/png"])))
            yield f"![What the code above draws]({there})"


def as_page(file, picture):
    parts = []
    for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(text)
        else:
            parts += [f"```python\n{text}\n```", *outputs(cell, picture)]
    parts.append(f"*This is `docs/notebooks/{file.name}`; `./dev examples` runs it, and so does Jupyter with the package "
                 "[fantail](../python.md).*")
    return "\n\n".join(parts) + "\n"
