#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks every relative link, picture and anchor in the Markdown files of the tree, without a network.

  links.py TREE             one line for each that leads nowhere; status 1 if there is one
  links.py TREE --targets   the files that pages link to, for scripts/docs
  links.py --self-test      shows that each kind of broken link is told

Anchors of headings are those that GitHub makes; an `<a id="...">` is one too.
"""

import pathlib
import re
import sys
import tempfile
import urllib.parse

TOP = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")
# Of a link, a picture, a reference and a tag of HTML: what is linked to.
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*<?([^()\s>]+(?:\([^()\s]*\))?)>?(?:\s+\"[^\"]*\")?\s*\)")
REFERENCE = re.compile(r"^ {0,3}\[[^\]]+\]:\s*<?(\S+?)>?(?:\s|$)", re.MULTILINE)
TAG = re.compile(r"<(?:img|a|source)\b[^>]*?\b(?:src|href)=\"([^\"]+)\"")
IMAGE_AROUND = re.compile(r"\[(!\[[^\]]*\]\([^()]*\))\]\(")


def pages(tree):
    """The Markdown files that readers are led to."""
    found = [tree / name for name in TOP if (tree / name).is_file()]
    for folder in ("docs", "core", "assets", "tests", "benchmark"):
        found += sorted(p for p in (tree / folder).rglob("*.md") if "corpus" not in p.parts)
    return found


def without_code(text):
    """The text with code blocks and spans blanked, line for line."""
    text = re.sub(r"^( {0,3})(```+|~~~+).*?^ {0,3}\2[^\n]*$",
                  lambda m: "\n" * m.group().count("\n"), text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"(`+)(?!`)(.+?)(?<!`)\1(?!`)", lambda m: re.sub(r"[^\n]", "x", m.group()), text)


def slug(heading):
    """The anchor of a heading, as GitHub makes it."""
    heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    heading = re.sub(r"<[^>]*>", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


def anchors(page):
    """All that a link into the page may end with."""
    text = page.read_text(encoding="utf-8")
    blocks_out = re.sub(r"^( {0,3})(```+|~~~+).*?^ {0,3}\2[^\n]*$", "", text,
                        flags=re.MULTILINE | re.DOTALL)
    found = set(re.findall(r"<\w+\s[^>]*\b(?:id|name)=\"([^\"]+)\"", blocks_out))
    for heading in re.findall(r"^#{1,6}\s+(.*?)\s*#*$", blocks_out, flags=re.MULTILINE):
        name, number = slug(heading), 0
        unique = name
        while unique in found:
            number += 1
            unique = f"{name}-{number}"
        found.add(unique)
    return found


def links(page):
    """(line, target) of all links that do not leave the tree."""
    text = without_code(page.read_text(encoding="utf-8"))
    for pattern in (LINK, REFERENCE, TAG):
        for match in pattern.finditer(text):
            target = match.group(1)
            # A picture that is a link: the inner one is found as well.
            if not re.match(r"[a-z][a-z0-9+.-]*:|//", target, re.IGNORECASE):
                yield text.count("\n", 0, match.start()) + 1, target
    for match in IMAGE_AROUND.finditer(text):
        inner = LINK.match(match.group(1))
        if inner:
            yield text.count("\n", 0, match.start()) + 1, inner.group(1)


def resolved(tree, page, target):
    """The file of a link and its anchor."""
    path, _, anchor = urllib.parse.unquote(target).partition("#")
    if not path:
        return page, anchor
    return (tree / path[1:] if path.startswith("/") else page.parent / path).resolve(), anchor


def problem(tree, page, target):
    """What is wrong with a link, or None."""
    path, anchor = resolved(tree, page, target)
    if not path.is_relative_to(tree):
        return "leads out of the tree"
    if not path.exists():
        return "there is no such file"
    if anchor and path.suffix == ".md" and anchor not in anchors(path):
        return f"{path.relative_to(tree)} has no anchor #{anchor}"
    return None


def check(tree):
    """The complaints about a tree, in lines `page:line: link: what`."""
    complaints = []
    for page in pages(tree):
        for line, target in links(page):
            what = problem(tree, page, target)
            if what:
                complaints.append(f"{page.relative_to(tree)}:{line}: {target}: {what}")
    return complaints


GOOD = """# A *page* with `code`, twice

[self](#again) [other](docs/b.md#a-page-with-code-twice) ![picture](docs/p.png "title")
[![a picture](docs/p.png)](docs/b.md) <img src="docs/p.png"> [far](https://example.org/x#y)
`[code](nowhere.md)` [spaces](docs/with%20space.md) [second](docs/b.md#again-1) [id](docs/b.md#eq-5)

```
[block](nowhere.md)
```

## Again
"""
OTHER = "# A *page* with `code`, twice\n<a id=\"eq-5\"></a>\n## Again\n## Again\n[up](../README.md)\n"


def made_tree(folder, more):
    tree = pathlib.Path(folder).resolve()
    (tree / "docs").mkdir(exist_ok=True)
    (tree / "docs/p.png").write_bytes(b"")
    (tree / "docs/with space.md").write_text("# X\n", encoding="utf-8")
    (tree / "docs/b.md").write_text(OTHER, encoding="utf-8")
    (tree / "README.md").write_text(GOOD + more, encoding="utf-8")
    return tree


def self_test():
    broken = {"[x](docs/c.md)": "README.md:13: docs/c.md: there is no such file",
              "![x](docs/q.png)": "there is no such file",
              "[![x](docs/q.png)](docs/b.md)": "docs/q.png: there is no such file",
              "[![x](docs/p.png)](docs/c.md)": "docs/c.md: there is no such file",
              "<img src=\"docs/q.png\">": "there is no such file",
              "[x](#nothing)": "README.md has no anchor #nothing",
              "[x](docs/b.md#again-2)": "docs/b.md has no anchor #again-2",
              "[x]: docs/c.md": "there is no such file",
              "[x](../elsewhere.md)": "leads out of the tree"}
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        complaints = check(made_tree(folder, ""))
        if complaints:
            failures.append(f"complains about a good tree: {complaints}")
        for link, what in broken.items():
            complaints = check(made_tree(folder, f"\n{link}\n"))
            if len(complaints) != 1 or what not in complaints[0]:
                failures.append(f"{link}: expected '{what}', got {complaints}")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        complaints = self_test()
    elif len(arguments) == 2 and arguments[1] == "--targets":
        tree = pathlib.Path(arguments[0]).resolve()
        for path in sorted({resolved(tree, page, target)[0]
                            for page in pages(tree) for _, target in links(page)} | set(pages(tree))):
            print(path.relative_to(tree))
        return 0
    elif len(arguments) == 1:
        complaints = check(pathlib.Path(arguments[0]).resolve())
    else:
        print(__doc__, file=sys.stderr)
        return 2
    print(*complaints, sep="\n" if complaints else "")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
