#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""public_members.py HEADER...: fails where a class has more than 30 public members.

A name counts once, whatever its overloads; constructors, destructors, operators, types and what is
nested do not count. --self-test: shows that it can fail.
"""
import re
import sys

MOST = 30


def body_at(text, start):
    """What stands between the brace at `start` and the one that closes it."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return text[start + 1 : i]
    raise SystemExit("a brace is not closed")


def without_bodies(text):
    """Bodies of functions, initialisers and nested types as `{}`, and templates' arguments away."""
    flat, depth = "", 0
    for character in text:
        depth -= character == "}"
        if depth == 0:
            flat += character
        depth += character == "{"
    while re.search(r"<[^<>]*>", flat):
        flat = re.sub(r"<[^<>]*>", "", flat)
    return flat


def public_members(name, body, access):
    members = set()
    flat = re.sub(r"\}(?!;)", "};", without_bodies(body))
    for statement in flat.split(";"):
        for label in re.findall(r"\b(public|protected|private)\s*:", statement):
            access = label
        statement = re.sub(r"\b(public|protected|private)\s*:", "", statement).strip()
        if access != "public" or re.match(r"(using|friend|struct|class|enum|template|static_assert)\b", statement):
            continue
        statement = statement.split("=")[0]
        found = re.search(r"(\w+)\s*\(", statement) or re.search(r"(\w+)\s*(=|\{|$)", statement)
        if found and found.group(1) not in (name, "operator") and "operator" not in statement:
            members.add(found.group(1))
    return members


def classes_in(text):
    text = re.sub(r"//[^\n]*", "", text)
    for found in re.finditer(r"\b(?:class|struct)\s+(\w+)[^;{}()]*\{", text):
        before = text[: found.start()].rstrip()
        if before.endswith("enum"):
            continue
        access = "public" if found.group(0).startswith("struct") else "private"
        name = found.group(1)
        yield name, public_members(name, body_at(text, found.end() - 1), access)


def self_test():
    text = "".join(f"  int f{i}() const {{ return {i}; }}\n" for i in range(30))
    text = "class A {\n public:\n  A();\n  ~A();\n  A(const A&) = delete;\n  A& operator=(const A&) = delete;\n" + text
    more = "  int f0(int x);\n private:\n  std::function<void(int)> g_ = {};\n  void hidden();\n};\n"
    assert [(n, len(m)) for n, m in classes_in(text + more)] == [("A", 30)]
    more = "  const std::vector<int>& one_more() const { if (x) { return y; } return z; }\n};\n"
    assert [(n, len(m)) for n, m in classes_in(text + more)] == [("A", 31)]


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    crowded = [
        f"{path}: {name} has {len(members)} public members: {', '.join(sorted(members))}"
        for path in sys.argv[1:]
        for name, members in classes_in(open(path, encoding="utf-8").read())
        if len(members) > MOST
    ]
    if crowded:
        sys.exit("\n".join(crowded))


if __name__ == "__main__":
    main()
