# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Finds what can be changed in a header: each operator and each constant, with what it becomes, and the
expression around it that a switch could choose."""
import dataclasses
import re

TOKEN = re.compile(r"""
    (?P<skip>\s+|//[^\n]*|/\*.*?\*/|^\#(?:[^\n]*\\\n)*[^\n]*)
  | (?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])+')
  | (?P<number>\d(?:[\w.]|'\w)*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign><=>|\.\.\.|<<=|>>=|::|->|\+\+|--|(?<=\s)<<|(?<=\s)>>|<=|>=|==|!=|\+=|-=|\*=|/=|%=|&=|\|=|\^=|.)
    """, re.VERBOSE | re.MULTILINE | re.DOTALL)
BINDS = {"or": 1, "and": 2, "|": 3, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, ">": 7, "<=": 7, ">=": 7, "<=>": 8,
         "<<": 9, ">>": 9, "+": 10, "-": 10, "*": 11, "/": 11, "%": 11}
TIGHT = 12
BECOMES = {"==": "!=", "!=": "==", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "+": "-", "-": "+", "and": "or",
           "or": "and", "not": "", "true": "false", "false": "true", "++": "--"}
ENDS = {";", ",", "?", ":", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "return", "else",
        "case", "requires", "noexcept", "consteval", "constexpr"}
OPENS = {"(": ")", "[": "]", "{": "}", "<": ">"}
# Lines that say nothing to a running program.
LEFT_OUT = ("#", "static_assert", "namespace")


@dataclasses.dataclass(frozen=True)
class Change:
    """One change: what stands at [start, end) becomes `new`. `first` to `last` is the expression that it
    changes; without one only a compiler can be asked."""
    header: str
    line: int
    start: int
    end: int
    new: str
    becomes: str
    first: int
    last: int
    lines: range

    def apply(self, text):
        return text[:self.start] + self.new + text[self.end:]

    @property
    def key(self):
        """What survivors.txt names: the header, and the line as it becomes."""
        return self.header, self.becomes


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    is_binary: bool = False
    partner: int = -1


def is_left_out(code, column):
    """Whether a place of a line is not changed: a line that says nothing, or the parameters of a template."""
    if code.lstrip().startswith("template"):
        depth = 0
        for at, sign in enumerate(code):
            depth += (sign == "<") - (sign == ">")
            if sign == ">" and depth == 0:
                return column <= at
        return True
    return code.lstrip().startswith(LEFT_OUT) or "if constexpr" in code


def tokens_of(text):
    """The tokens, with each bracket's partner. A sign between blanks takes two operands: the layout that
    .clang-format prescribes tells `a < b` from `list<b>`."""
    found = [Token(match.lastgroup, match.group(), match.start(), match.end())
             for match in TOKEN.finditer(text) if match.lastgroup != "skip"]
    stack = []
    for at, token in enumerate(found):
        is_apart = text[token.start - 1].isspace() and text[token.end:token.end + 1].isspace()
        token.is_binary = token.text in BINDS and is_apart
        if token.kind != "sign" or token.is_binary:
            continue
        if token.text in OPENS:
            stack.append(at)
        elif token.text in OPENS.values():
            while stack and OPENS[found[stack[-1]].text] != token.text and found[stack[-1]].text == "<":
                stack.pop()
            if stack and OPENS[found[stack[-1]].text] == token.text:
                token.partner = stack.pop()
                found[token.partner].partner = at
    return found


def reach(tokens, at, step, binds):
    """The last token, to one side of `at`, of an operand that is bound tighter than `binds`; None where it
    is no plain expression."""
    here, last = at + step, None
    while 0 <= here < len(tokens):
        token = tokens[here]
        if token.text == "...":
            return None
        if token.partner >= 0:
            if (token.partner > here) != (step > 0):
                break
            here = token.partner
        elif token.text in ENDS or token.text in OPENS or token.text in OPENS.values():
            if not token.is_binary:
                break
        if token.is_binary and (BINDS[token.text] < binds or BINDS[token.text] == binds and step > 0):
            break
        last = here
        here += step
    return last


def back_to_name(tokens, at):
    """The first token of what `at`, a sign behind it, counts up."""
    here = at - 1
    while True:
        if tokens[here].partner >= 0:
            here = tokens[here].partner - 1
            continue
        if tokens[here - 1].text not in (".", "->", "::"):
            return here
        here -= 2


def expression(tokens, at):
    """From where to where the expression goes that a change of this token changes; None: of no expression."""
    token = tokens[at]
    if token.is_binary:
        left, right = (reach(tokens, at, step, BINDS[token.text]) for step in (-1, 1))
    elif token.text == "++" and (tokens[at - 1].kind == "word" or tokens[at - 1].text in (")", "]")) and \
            tokens[at - 1].text not in ENDS:
        left, right = back_to_name(tokens, at), at
    elif token.text in ("not", "++"):
        left, right = at, reach(tokens, at, 1, TIGHT)
    else:
        left = right = at
    if left is None or right is None:
        return None
    return tokens[left].start, tokens[right].end


def becomes(token):
    """What a token is changed to; None: nothing."""
    if token.kind == "number" and re.fullmatch(r"[\d']+U?", token.text):
        digits = token.text.rstrip("U")
        return str(int(digits.replace("'", "")) + 1) + token.text[len(digits):]
    if token.kind == "text" and re.fullmatch(r"'\d'", token.text):
        return f"'{(int(token.text[1]) + 1) % 10}'"
    if token.text not in BECOMES or token.text in BINDS and not token.is_binary:
        return None
    return BECOMES[token.text]


def changes_of(header, text):
    """Each change of a header, in order."""
    tokens, lines, found = tokens_of(text), text.splitlines(), []
    for at, token in enumerate(tokens):
        new = becomes(token)
        line = text.count("\n", 0, token.start) + 1
        code = lines[line - 1]
        if new is None or is_left_out(code, token.start - text.rfind("\n", 0, token.start) - 1):
            continue
        span = expression(tokens, at) if tokens[at - 1].text != "operator" else None
        first, last = span or (-1, -1)
        over = range(text.count("\n", 0, first) + 1, text.count("\n", 0, last) + 2) if span else range(0)
        end = tokens[at + 1].start if token.text == "not" else token.end
        begin = text.rfind("\n", 0, token.start) + 1
        changed = (text[begin:token.start] + new + text[end:]).splitlines()[0].strip()
        found.append(Change(header, line, token.start, end, new, changed, first, last, over))
    return found
