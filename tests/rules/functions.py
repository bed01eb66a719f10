"""Where the functions of a C++ file begin and end, by its braces."""

import re

# What may hold a brace without meaning one. A number is named so that its ' opens no character.
QUIET = re.compile(r"""
    (?P<keep>\b\d[\w'.]*)
  | //(?:\\\n|[^\n])*
  | /\*.*?\*/
  | R"(?P<mark>[^(\s"]*)\(.*?\)(?P=mark)"
  | "(?:\\.|[^"\\\n])*"
  | '(?:\\.|[^'\\\n])+'
  | ^[ \t]*\#(?:\\\n|[^\n])*
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

SCOPE = re.compile(r"^(?:(?:inline|template|export|typedef)\s*)*(?:namespace|class|struct|union|enum|extern)\b")
LAMBDA = re.compile(r"(?<![\w\]])\[[^\[\]]*\]\s*(?:\(\))?\s*(?:mutable\b|constexpr\b|noexcept\b|->[^;{}]*|\s)*$")


def without_quiet_text(text):
    """The text with comments, literals and preprocessor lines blank; lines stay where they are."""
    def blank(match):
        return match[0] if match["keep"] else re.sub(r"[^\n]", " ", match[0])
    return QUIET.sub(blank, text)


def flat(head):
    """The head of a block without what stands in <> and in (); "()" is left of the latter."""
    for inner, left in ((r"\([^()]*\)", "\0"), (r"<[^<>]*>", "")):
        while re.search(inner, head):
            head = re.sub(inner, left, head)
    return re.sub("\0+", "()", head).strip()


def kind_of(head, around):
    """What the block after this head is, in a block of kind `around`."""
    head = flat(head)
    if around in ("function", "lambda"):
        return "part"
    if LAMBDA.search(head):
        return "lambda"
    if around in ("part", "values"):
        return around
    if SCOPE.match(head):
        return "scope"
    head = re.sub(r"operator\s*[-+*/<>=!%&|^]*=", "operator", head)
    return "function" if "()" in head and "=" not in head else "values"


def functions(text):
    """(first line, number of lines, head) of each function, from its return type to its last brace.

    A lambda in no function is one as well; what stands inside a function belongs to it. The code is
    as clang-format leaves it. Macros that open a brace without closing it are not understood.
    """
    text = without_quiet_text(text)
    found, blocks, start = [], [("scope", 0)], 0  # blocks: kind, and where the head starts
    for match in re.finditer(r"[{};]|\b(?:public|protected|private)\s*:", text):
        around, at = blocks[-1][0], match.start()
        if match[0] == "{":
            blocks.append((kind_of(text[start:at], around), start))
            start = match.end()
        elif match[0] == "}" and len(blocks) > 1:
            kind, head = blocks.pop()
            start = match.end()
            if kind == "function" and re.match(r"\s*[,{]", text[start:]):
                start = head  # a member's initialiser in braces: the head goes on
            elif kind in ("function", "lambda"):
                head += len(text[head:]) - len(text[head:].lstrip())
                found.append((text.count("\n", 0, head) + 1, text.count("\n", head, at) + 1,
                              " ".join(text[head:text.index("{", head)].split())))
        elif around == "scope":
            start = match.end()
    return found
