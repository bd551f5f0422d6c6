#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""words_of_help.py man|completion PROGRAM VERSION: the manual page of the program, or its completion
for bash, made of what it says with --help."""
import re
import subprocess
import sys


def help_of(program, *command):
    """Summary, usage, and {section: [(names, text)]} of a help page."""
    text = subprocess.run([program, *command, "--help"], check=True, capture_output=True,
                          text=True).stdout
    summary, rest = text.split("\n", 1)
    usage = re.search(r"^Usage: (.*)$", rest, re.MULTILINE).group(1)
    sections, rows = {}, []
    for line in rest.splitlines():
        if re.match(r"[A-Z]\w+:$", line):
            rows = sections.setdefault(line[:-1], [])
        elif match := re.match(r"  (\S.*?)  +(\S.*)$", line):
            names, words = match.groups()
            rows.append((re.sub(" (TEXT|REQUIRED)", "", names), words))
    sections.pop("Example", None)
    return summary, usage, sections


def escaped(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def rows_of_man(rows):
    return [line for names, text in rows for line in (".TP", f".B {escaped(names)}", escaped(text))]


def man(program, version):
    summary, usage, sections = help_of(program)
    lines = [f'.TH FOLDLESS 1 "" "foldless {version}" "User Commands"', ".SH NAME",
             "foldless \\- deform planar meshes without folds", ".SH SYNOPSIS", f".B {escaped(usage)}",
             ".SH DESCRIPTION", escaped(summary),
             "Without a command it opens the editor.", ".SH OPTIONS"]
    lines += rows_of_man(sections["Positionals"] + sections["Options"])
    lines.append(".SH COMMANDS")
    for name, _ in sections["Subcommands"]:
        about, usage, parts = help_of(program, name)
        lines += [f".SS {escaped(usage)}", escaped(about[:1].upper() + about[1:]) + "."]
        lines += rows_of_man(parts.get("Positionals", []) + parts["Options"])
    lines += [".SH EXIT STATUS", ".TP", ".B 0", "Done.", ".TP", ".B 1",
              "Done, but not what was asked for: handles are not reached, or a map folds.", ".TP",
              ".B 2", "The input cannot be used; one sentence on standard error says why.", ".TP",
              ".B 130", "Interrupted; what was reached is written."]
    return "\n".join(lines) + "\n"


def flags_of(rows):
    return " ".join(flag for names, _ in rows for flag in re.findall(r"--[a-z-]+", names))


def completion(program, _):
    sections = help_of(program)[2]
    names = [name for name, _ in sections["Subcommands"]]
    cases = [f"    {name}) flags='{flags_of(help_of(program, name)[2]['Options'])}' ;;"
             for name in names]
    first = f"{' '.join(names)} {flags_of(sections['Options'])}"
    return f"""# bash completion for foldless
_foldless() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} flags=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{first}' -- "$word"; compgen -f -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
""" + "\n".join(cases) + """
  esac
  case $word in
    -*) mapfile -t COMPREPLY < <(compgen -W "$flags" -- "$word") ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
  esac
}
complete -o filenames -F _foldless foldless
"""


if __name__ == "__main__":
    sys.stdout.write({"man": man, "completion": completion}[sys.argv[1]](*sys.argv[2:]))
