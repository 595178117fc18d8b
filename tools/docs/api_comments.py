# SPDX-License-Identifier: MIT
"""What a public header must say of what it declares. Whatever Doxygen is told of, others will call without reading its source.

- Each type, alias, enumeration and function has a comment; overloads of one header may share one. None is asked of destructors, of
  defaulted and deleted members, and of operators, which do what they do to numbers.
- Each value of an enumeration has one, or is named in that of its enumeration, in back quotes.
- Each field and constant has one, or is named so in that of its type, or says all itself: its name ends with its unit, or its type is one
  of these headers, which has a comment of its own, and is neither a bare quantity, whose zero and sense no type tells, nor optional.
"""

import re
import sys

UNIT = re.compile(r"_(m|m2|m_s|m_s2|rad_s|s|per_s|hz|hz_s|us|mv|kg_m2|kg_m3)$")
QUANTITIES = ("Angle", "Microseconds", "Vector3")
FUNCTIONS = ("function", "friend")


def comment(element):
    return [element.find(tag) for tag in ("briefdescription", "detaileddescription")]


def has_comment(element):
    return any("".join(part.itertext()).strip() for part in comment(element))


def in_back_quotes(element):
    return {"".join(code.itertext()) for part in comment(element) for code in part.iter("computeroutput")}


def name(element):
    return element.findtext("name") or element.findtext("compoundname").split("::")[-1]


def needs_none(function):
    operates = re.match(r"~|operator(?!\"\")\W", name(function))
    return operates or re.search(r"=\s*(default|delete)$", function.findtext("argsstring"))


class Check:
    def __init__(self, headers):
        self.parts = [element for parts in headers.values() for _, _, element in parts]
        members = [member for element in self.parts for member in element.findall("sectiondef/memberdef")]
        self.types = {element.get("id") for element in self.parts + members if element.get("kind") not in (*FUNCTIONS, "variable")}
        self.missing = []

    def ask(self, element, what, owner=None, place=None):
        if has_comment(element) or (owner is not None and name(element) in in_back_quotes(owner)):
            return
        location = (element if place is None else place).find("location")
        of = f"{name(owner)}::" if owner is not None else ""
        self.missing.append((location.get("file"), int(location.get("line")), f"{what} {of}{name(element)}"))

    def says_all(self, variable):
        kind = variable.find("type")
        types = [ref.text for ref in kind.findall("ref") if ref.get("refid") in self.types]
        described = types and not any(word in QUANTITIES for word in types) and "optional" not in "".join(kind.itertext())
        return UNIT.search(name(variable)) or described

    def members(self, members, owner=None):
        said = {(member.find("location").get("file"), name(member)) for member in members if has_comment(member)}
        for member in members:
            kind = member.get("kind")
            if kind in FUNCTIONS:
                if not needs_none(member) and (member.find("location").get("file"), name(member)) not in said:
                    self.ask(member, "function")
            elif kind == "variable":
                if not self.says_all(member):
                    self.ask(member, "constant" if owner is None else "field", owner)
            else:
                self.ask(member, "enumeration" if kind == "enum" else "type")
                for value in member.findall("enumvalue"):
                    self.ask(value, "value", member, member)

    def all(self):
        self.members([element for element in self.parts if element.tag == "memberdef"])
        for compound in (element for element in self.parts if element.tag == "compounddef"):
            self.ask(compound, "type")
            self.members([one for one in compound.findall("sectiondef/memberdef") if one.get("prot") == "public"], compound)
        return sorted(set(self.missing))


def check(headers):
    """Ends the program where something is missing."""
    missing = Check(headers).all()
    for file, line, what in missing:
        print(f"{file}:{line}: {what} has no comment, and its name does not say all (tools/docs/api_comments.py has the rule)",
              file=sys.stderr)
    if missing:
        sys.exit(1)
