# SPDX-License-Identifier: MIT
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools/docs"))
import api_comments

QUANTITY = ElementTree.fromstring('<compounddef kind="class" id="angle"><compoundname>fantail::core::Angle</compoundname>'
                                  '<briefdescription>In radians.</briefdescription><detaileddescription/></compounddef>')


def described(text):
    return f"<briefdescription>{text}</briefdescription><detaileddescription/><location file='a.hpp' line='7'/>"


def member(name, kind="variable", type="float", text="", arguments="", more=""):
    return ElementTree.fromstring(f"<memberdef kind='{kind}' prot='public' id='{name}'><type>{type}</type><name>{name}</name>"
                                  f"<argsstring>{arguments}</argsstring>{more}{described(text)}</memberdef>")


def structure(text, *members):
    whole = ElementTree.fromstring(f"<compounddef kind='struct' id='s'><compoundname>fantail::S</compoundname>"
                                   f"<sectiondef/>{described(text)}</compounddef>")
    whole.find("sectiondef").extend(members)
    return whole


def refused(*parts):
    found = api_comments.Check({"a.hpp": [(1, "", part) for part in (QUANTITY, *parts)]}).all()
    return [what for file, line, what in found if (file, line) == ("a.hpp", 7)]


ANGLE = '<ref refid="angle">Angle</ref>'
VALUE = "<enumvalue><name>on</name><briefdescription/><detaileddescription/></enumvalue>"


@pytest.mark.parametrize("part, what", [
    (structure(""), "type S"),
    (structure("A thing.", member("height")), "field S::height"),
    (structure("A thing.", member("done", type="bool")), "field S::done"),
    (structure("A thing.", member("trim", type=ANGLE)), "field S::trim"),
    (structure("Has a <computeroutput>height</computeroutput>.", member("width")), "field S::width"),
    (structure("A thing.", member("other", type='std::optional&lt; <ref refid="s">S</ref> &gt;')), "field S::other"),
    (structure("A thing.", member("update", "function", arguments="(float x)")), "function update"),
    (member("operator\"\"_deg", "function"), "function operator\"\"_deg"),
    (member("most_rows", type="std::size_t"), "constant most_rows"),
    (member("Name", "typedef"), "type Name"),
    (member("Mode", "enum", more=VALUE, text="A mode, on or off."), "value Mode::on"),
], ids=lambda part: part if isinstance(part, str) else "")
def test_what_a_name_does_not_say_is_refused_without_a_comment(part, what):
    assert refused(part) == [what]


@pytest.mark.parametrize("part", [
    structure("A thing.", member("height_m"), member("turn_rate_rad_s"), member("next", type='<ref refid="s">S</ref>')),
    structure("Has a <computeroutput>height</computeroutput>.", member("height")),
    structure("A thing.", member("S", "function", arguments="()=default"), member("~S", "function", arguments="()=default"),
              member("operator+=", "function", arguments="(S other)")),
    structure("A thing.", member("add", "function", text="One."), member("add", "function")),
    member("Mode", "enum", more=VALUE, text="Is <computeroutput>on</computeroutput> or off."),
], ids=["units and types", "named in the comment of the type", "special members", "overloads", "named in that of the enumeration"])
def test_what_says_all_by_itself_needs_no_comment(part):
    assert refused(part) == []
