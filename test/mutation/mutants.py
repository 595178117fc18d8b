# SPDX-License-Identifier: MIT
"""Makes the mutants of one C++ file from its syntax tree (libclang): each changes one place, as a slip would.

The same file gives the same mutants in the same order. Left out: functions declared `consteval` and static_assert (the
compiler would refuse them, or no program would contain them), labels of a case, and whatever comes from a macro.
"""

import re

import clang.cindex
from clang.cindex import CursorKind as Kind
from mutant import Mutant

OPERATORS = {  # of a comparison, of a decision, of arithmetic: what it becomes
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
    "&&": ("||",), "||": ("&&",),
    "+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "%": ("*",), "&": ("|",), "|": ("&",), "^": ("&",),
    "<<": (">>",), ">>": ("<<",),
    "+=": ("-=",), "-=": ("+=",), "*=": ("/=",), "/=": ("*=",), "&=": ("|=",), "|=": ("&=",), "^=": ("&=",),
    "<<=": (">>=",), ">>=": ("<<=",),
}
EXPRESSIONS = {Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.UNARY_OPERATOR,
               Kind.UNEXPOSED_EXPR, Kind.CSTYLE_CAST_EXPR}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.FUNCTION_TEMPLATE,
             Kind.CONVERSION_FUNCTION}
INTEGER = re.compile(r"(0x[0-9a-f']+|[0-9][0-9']*)([a-z_]\w*)?", re.IGNORECASE)
FLOAT = re.compile(r"([0-9][0-9']*\.?[0-9']*(?:e[-+]?[0-9]+)?)([a-z_]\w*)?", re.IGNORECASE)


def mutants(file, path, arguments):
    """`file`: its name in ids; `path`: where it is read; `arguments`: what the compiler needs to parse it."""
    unit = clang.cindex.Index.create().parse(path, args=[*arguments, "-ferror-limit=0"])
    errors = [str(d) for d in unit.diagnostics if d.severity >= clang.cindex.Diagnostic.Error]
    if errors:
        raise ValueError(f"{path} cannot be parsed, so nobody knows its mutants: {errors[0]}")
    maker = Maker(file, path)
    maker.walk(unit.cursor, "", True)
    return sorted(maker.found.values(), key=lambda m: (m.begin, m.end, m.operator))


class Maker:
    def __init__(self, file, path):
        self.file, self.path = file, path
        with open(path, "rb") as stream:
            self.text = stream.read()
        self.found = {}
        self.early = True  # of what is walked

    def inside(self, cursor):
        at = cursor.extent.start
        return at.file is not None and at.file.name == self.path

    def source(self, cursor):
        return self.text[cursor.extent.start.offset : cursor.extent.end.offset].decode()

    def add(self, begin, end, replacement, operator, function):
        if self.text[begin:end].decode() == replacement or (begin, end, replacement) in self.found:
            return
        first = self.text.rfind(b"\n", 0, begin) + 1
        last = self.text.find(b"\n", end)
        was, now = ((self.text[first:begin] + middle + self.text[end:last]).decode()
                    for middle in (self.text[begin:end], replacement.encode()))
        self.found[begin, end, replacement] = Mutant(
            self.file, begin, end, replacement, operator, self.text.count(b"\n", 0, begin) + 1, begin - first + 1,
            function, " ".join(was.split()), " ".join(now.split()), self.text.count(b"\n", 0, end) + 1, self.early)

    def replace(self, cursor, replacement, operator, function):
        self.add(cursor.extent.start.offset, cursor.extent.end.offset, replacement, operator, function)

    def walk(self, cursor, function, early):
        for child in cursor.get_children():
            if cursor.kind == Kind.TRANSLATION_UNIT and not self.inside(child):
                continue
            if child.kind == Kind.STATIC_ASSERT or self.is_declared(child, "consteval"):
                continue
            own, sooner = function, early
            if child.kind in FUNCTIONS:
                own, sooner = child.spelling, self.is_declared(child, "constexpr")
            elif child.kind in (Kind.PARM_DECL, Kind.FIELD_DECL):  # what it is without being told
                sooner = True
            self.early = sooner
            self.visit(child, own)
            self.walk(child, own, sooner)

    def is_declared(self, cursor, word):
        if cursor.kind not in FUNCTIONS:
            return False
        # Before the name: a template's requires-clause may have parentheses of its own there.
        before_name = self.text[cursor.extent.start.offset : cursor.location.offset].decode()
        return re.search(rf"\b{word}\b", before_name) is not None

    def visit(self, cursor, function):
        if not self.inside(cursor):
            return
        children = list(cursor.get_children())
        kind = cursor.kind
        if kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.operator(children[0].extent.end.offset, children[1].extent.start.offset, children, function)
        elif kind == Kind.CALL_EXPR:
            self.call(cursor, children, function)
        elif kind == Kind.UNARY_OPERATOR:
            self.unary(cursor, children, function)
        elif kind in (Kind.INTEGER_LITERAL, Kind.FLOATING_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR):
            self.constant(cursor, function)
        elif kind in (Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR):
            self.condition(cursor, children, function)
        elif kind == Kind.RETURN_STMT and children:
            self.returned(children[0], function)
        if kind in (Kind.COMPOUND_STMT, Kind.CASE_STMT, Kind.DEFAULT_STMT, Kind.SWITCH_STMT):
            for child in children[1 if kind == Kind.CASE_STMT else 0 :]:
                self.statement(child, function)

    def operator(self, begin, end, operands, function):
        between = self.text[begin:end].decode()
        sign = between.strip()
        for other in OPERATORS.get(sign, ()):
            at = begin + between.index(sign)
            self.add(at, at + len(sign), other, f"{sign} to {other}", function)
        if sign in ("&&", "||"):
            for operand in operands:
                self.negate(operand, function)

    def call(self, cursor, children, function):
        if cursor.spelling in ("min", "max") and children:
            text = self.source(children[0])
            other = "max" if cursor.spelling == "min" else "min"
            if re.search(rf"\b{cursor.spelling}$", text):
                end = children[0].extent.end.offset
                self.add(end - 3, end, other, f"{cursor.spelling} to {other}", function)
        elif cursor.spelling.startswith("operator") and len(children) == 3:
            sign = self.source(children[1])
            if sign in OPERATORS:
                self.operator(children[1].extent.start.offset, children[1].extent.end.offset, [], function)
        elif cursor.spelling in ("operator-", "operator!") and len(children) == 2 and self.source(cursor)[0] in "-!":
            self.add(cursor.extent.start.offset, cursor.extent.start.offset + 1, "", f"without {self.source(cursor)[0]}",
                     function)

    def unary(self, cursor, children, function):
        text, begin, end = self.source(cursor), cursor.extent.start.offset, cursor.extent.end.offset
        if text.startswith(("++", "--")):
            self.add(begin, begin + 2, "--" if text[0] == "+" else "++", f"{text[:2]} turned", function)
        elif text.endswith(("++", "--")):
            self.add(end - 2, end, "--" if text[-1] == "+" else "++", f"{text[-2:]} turned", function)
        elif text[0] in "-!~":
            self.add(begin, begin + 1, "", f"without {text[0]}", function)

    def constant(self, cursor, function):
        text = self.source(cursor)
        if text in ("true", "false"):
            self.replace(cursor, "false" if text == "true" else "true", "other bool", function)
        elif match := INTEGER.fullmatch(text):
            number, suffix = int(match[1].replace("'", ""), 16 if match[1].lower().startswith("0x") else 10), match[2] or ""
            self.replace(cursor, f"{number + 1}{suffix}", "one more", function)
            if number > 0:
                self.replace(cursor, f"{number - 1}{suffix}", "one less", function)
        elif match := FLOAT.fullmatch(text):
            number, suffix = float(match[1].replace("'", "")), match[2] or ""
            self.replace(cursor, f"{number * 2 or 1.0!r}{suffix}", "twice" if number else "one", function)
            if number:
                self.replace(cursor, f"0.0{suffix}", "zero", function)

    def condition(self, cursor, children, function):
        # Of `if (auto x = f(); c)` and `if (auto x = f())` the last expression before the statement.
        expressions = [c for c in children if c.kind.is_expression()]
        if expressions and (cursor.kind == Kind.CONDITIONAL_OPERATOR or children[0].kind.is_expression()
                            or len(children) > 2 and children[1].kind.is_expression()):
            self.negate(expressions[0], function)

    def negate(self, cursor, function):
        text = self.source(cursor)
        if self.inside(cursor) and text not in ("true", "false") and not text.startswith("!"):
            self.replace(cursor, f"!({text})", "negated", function)

    def returned(self, cursor, function):
        text = self.source(cursor)
        type_name = cursor.type.get_canonical().spelling
        if type_name == "bool":
            self.negate(cursor, function)
        elif text not in ("{}", "std::nullopt", "*this") and not text.startswith("{"):
            empty = "std::nullopt" if type_name.removeprefix("const ").startswith("std::optional") else "{}"
            self.replace(cursor, empty, "returns nothing", function)

    def statement(self, cursor, function):
        if cursor.kind in EXPRESSIONS or cursor.kind in (Kind.BREAK_STMT, Kind.CONTINUE_STMT) or (
                cursor.kind == Kind.RETURN_STMT and not list(cursor.get_children())):
            if self.inside(cursor):
                self.replace(cursor, "", "removed", function)
