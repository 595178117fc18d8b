# SPDX-License-Identifier: MIT
"""Pages on the headers of flight law and device interfaces, of what Doxygen has read of them: one a header, in its order."""

import re
import sys
import xml.etree.ElementTree as ElementTree

import api_comments

TYPES = ("class", "struct")
LONGEST_LINE = 80  # of a signature; a longer one has a parameter a line
INCLUDED_AS = {"firmware/core/": "core/", "hal/include/hal/": "hal/"}


def name_of(file):
    """As a header is included."""
    for folder, name in INCLUDED_AS.items():
        if file.startswith(folder):
            return name + file.removeprefix(folder)
    raise ValueError(file)


def escaped(text):
    return re.sub(r"([\\`*_\[\]|])", r"\\\1", text or "").replace("<", "&lt;").replace(">", "&gt;")


def plain(element):
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip() if element is not None else ""


class Api:
    def __init__(self, folder):
        self.headers, self.places, self.taken, self.commented, self.shown = {}, {}, set(), 0, 0
        compounds = [ElementTree.parse(file).getroot().find("compounddef") for file in sorted(folder.glob("*.xml"))
                     if file.name.startswith(("class", "struct", "namespace"))]
        for compound in compounds:
            if compound.get("kind") in TYPES and compound.get("prot") != "private":
                self.add(compound, compound.findtext("compoundname").removeprefix("fantail::"))
            elif compound.get("kind") == "namespace":
                for member in compound.findall("sectiondef/memberdef"):
                    self.add(member, member.findtext("name"))

    def add(self, element, title):
        place = element.find("location")
        header = name_of(place.get("file"))
        anchor = title.split("::")[-1]
        self.headers.setdefault(header, []).append((int(place.get("line")), title, element))
        self.places[element.get("id")] = (header, anchor.lower())

    def text(self, element, header):
        """Of a description, or of a type, with links to what it names."""
        parts = [escaped(element.text)]
        for child in element:
            if child.tag == "computeroutput":
                parts.append(f"`{plain(child)}`")
            elif child.tag == "ref" and child.get("refid") in self.places:
                there, anchor = self.places[child.get("refid")]
                page = "" if there == header else f"../{there.removesuffix('.hpp')}.md"
                parts.append(f"[{escaped(plain(child))}]({page}#{anchor})")
            elif child.tag in ("para", "listitem"):
                parts.append(("\n\n" if child.tag == "para" else "\n- ") + self.text(child, header).strip())
            elif child.tag in ("verbatim", "programlisting", "preformatted"):
                parts.append(f"\n\n```\n{''.join(child.itertext())}\n```\n\n")
            else:
                parts.append(self.text(child, header))
            parts.append(escaped(child.tail))
        return "".join(parts)

    def said(self, element, header, line=False):
        """The comment; `line`: for a table."""
        texts = [self.text(element.find(tag), header).strip() for tag in ("briefdescription", "detaileddescription")]
        self.shown += 1
        self.commented += any(texts)
        return re.sub(r"\s+", " ", " ".join(texts)).strip() if line else "\n\n".join(filter(None, texts))

    def table(self, head, rows):
        """Without the columns that have nothing in them."""
        used = [column for column in range(len(head)) if any(row[column] for row in rows)]
        lines = [head, ["---"] * len(head), *rows]
        return [*(f"| {' | '.join(line[column] for column in used)} |" for line in lines), ""]

    def function(self, member):
        template = ", ".join(" ".join(filter(None, [plain(one.find("type")), one.findtext("declname")]))
                             for one in member.findall("templateparamlist/param"))
        words = [word for word in ("static", "explicit") if member.get(word) == "yes"]
        words += ["virtual"] if member.get("virt") in ("virtual", "pure-virtual") else []
        words += [plain(member.find("type")), member.findtext("name")]
        begin, end = " ".join(filter(None, words)), member.findtext("argsstring")
        if len(begin + end) > LONGEST_LINE:
            parameters = [self.parameter(one) for one in member.findall("param")]
            end = "(\n    " + ",\n    ".join(parameters) + ")" + end.rpartition(")")[2]
        return (f"template <{template}>\n" if template else "") + begin + end

    def parameter(self, one):
        value = plain(one.find("defval"))
        return " ".join(filter(None, [plain(one.find("type")), one.findtext("declname")])) + (f" = {value}" if value else "")

    def heading(self, depth, text, name):
        """With a place of its own for the first of that name on a page: overloads share it."""
        if not re.fullmatch(r"\w+", name) or name.lower() in self.taken:
            return f"{depth} {escaped(text)}"
        self.taken.add(name.lower())
        return f"{depth} {escaped(text)} {{ #{name.lower()} }}"

    def block(self, member, header, depth):
        kind, name = member.get("kind"), member.findtext("name")
        if kind == "enum":
            values = [[f"`{one.findtext('name')}`", self.said(one, header, True)] for one in member.findall("enumvalue")]
            return [self.heading(depth, f"enum {name}", name), "", self.said(member, header), "",
                    *self.table(["value", "meaning"], values)]
        code = self.function(member) if kind in ("function", "friend") else plain(member.find("definition")).replace(
            "fantail::core::", "").replace("fantail::hal::", "") + (" " + plain(member.find("initializer"))).rstrip()
        return [self.heading(depth, name, name), "", "``` { .cpp .wrap }", code, "```", "", self.said(member, header), ""]

    def compound(self, compound, title, header):
        heading = self.heading("##", f"{compound.get('kind')} {title.split('::', 1)[-1]}", title.split("::")[-1])
        lines = [heading, "", self.said(compound, header), ""]
        members = [one for one in compound.findall("sectiondef/memberdef")
                   if one.get("prot") == "public" and not one.findtext("name").startswith("~")]
        fields = [[f"`{one.findtext('name')}`", self.text(one.find("type"), header),
                   f"`{plain(one.find('initializer')).removeprefix('= ')}`" if plain(one.find("initializer")) else "",
                   self.said(one, header, True)] for one in members if one.get("kind") == "variable"]
        if fields:
            lines += self.table(["field", "type", "at first", "meaning"], fields)
        for one in members:
            if one.get("kind") != "variable":
                lines += self.block(one, header, "###")
        return lines

    def page(self, header):
        folder = next(folder for folder, name in INCLUDED_AS.items() if header.startswith(name))
        file = folder + header.split("/")[1]
        self.taken = set()
        lines = [f"# {escaped(header)}", "", f"[API](../index.md) · [the header itself](../../{file})", ""]
        for _, title, element in sorted(self.headers[header], key=lambda one: one[0]):
            lines += self.compound(element, title, header) if element.tag == "compounddef" else self.block(element, header, "##")
        return "\n".join(lines)

    def index(self):
        lines = ["# API", "", "The headers that others include: the flight law (`Fantail::core`) and the interfaces of devices.", ""]
        for folder, what in (("core/", "The flight law"), ("hal/", "Interfaces of devices")):
            rows = [[f"[{escaped(header)}]({header.removesuffix('.hpp')}.md)",
                     ", ".join(dict.fromkeys(
                         f"`{title.split('::', 1)[-1]}`" for _, title, element in sorted(parts, key=lambda one: one[0])
                         if element.tag == "compounddef" or element.get("kind") in ("enum", "function")))]
                    for header, parts in sorted(self.headers.items()) if header.startswith(folder)]
            lines += [f"## {what}", "", *self.table(["header", "has"], rows)]
        return "\n".join(lines)


def pages(folder):
    """Their texts by their names."""
    api = Api(folder)
    api_comments.check(api.headers)
    texts = {"api/index.md": api.index()}
    texts.update((f"api/{header.removesuffix('.hpp')}.md", api.page(header)) for header in api.headers)
    print(f"docs: {len(api.headers)} headers; {api.commented} of {api.shown} types, functions and values have a comment, "
          "the others need none", file=sys.stderr)
    return texts
