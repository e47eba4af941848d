#!/usr/bin/env python3
# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what the documents say: links, anchors, pictures, code, names and numbers.

    check_documents.py <root of the repository>

- Relative links and anchors of README.md, CHANGES.md and doc/Spider/*.md lead somewhere, and pictures exist.
- Each block of C++ in them is part of a program in examples/Spider, up to blank lines; a line of the block that is only
  a comment with dots, /* ... */, stands for any number of lines. Lines of CMake are lines of the project in
  test/Spider/consumer. Scripts and options of CMake in blocks of sh exist.
- Whatever looks like a call in backquotes, `f()`, is a name in the public headers, or one of CGAL's in KNOWN.
- README.md and the manual state the headlines of doc/Spider/figures.json, and the tables say what it says.
- Every named parameter of parameters.h is documented and an option of the program spider, every example is listed, and the
  program has the options that are shown.
"""

import json
import pathlib
import re
import sys

KNOWN = {  # names of others that the documents mention
    "locate", "detect_sharp_edges", "stitch_borders", "detect_features", "number_of_iterations", "vertex_normal_map",
    "edge_is_constrained_map", "interpolated_corrected_curvatures", "std::ref", "boost::make_function_property_map",
    "smooth_shape", "geom_traits",
}

OPTIONS = {  # of the program spider, where they aren't named as the parameter is: what maps give comes from files
    "geodesic_radii": "geodesic-radius", "growth_cost_map": "growth-costs", "limb_elongation_map": "suggest-adaptive-limbs", "vertex_normal_map": "vertex-normals",
    "edge_is_constrained_map": "constrained-edges", "vertex_is_constrained_map": "constrained-vertices",
}
CGALS_PARAMETERS = ("number_of_iterations", "vertex_normal_map", "edge_is_constrained_map", "vertex_is_constrained_map")

errors = []


def complain(path, what):
    errors.append(f"{path}: {what}")


def anchor_of(heading):
    """GitHub's anchor for a heading."""
    text = re.sub(r"[`*]", "", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def without_code(text):
    return re.sub(r"```.*?```", "", text, flags=re.S)


def anchors(path):
    return {anchor_of(heading) for heading in re.findall(r"^#+ (.*)$", without_code(path.read_text()), flags=re.M)}


def check_links(root, path):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(path.read_text())):
        if re.match(r"\w+://|mailto:", target):
            continue
        name, _, anchor = target.partition("#")
        to = (path.parent / name).resolve() if name else path
        if not to.exists():
            complain(path.name, f"the link {target} leads nowhere")
        elif root not in to.parents:
            complain(path.name, f"the link {target} leaves the repository")
        elif anchor and anchor not in anchors(to):
            complain(path.name, f"{to.name} has no heading for the link {target}")


def lines_of_code(text):
    lines = (re.sub(r"\s+", " ", line).strip() for line in text.splitlines())
    return [line for line in lines if line and not re.fullmatch(r"//! \[.*\]", line)]


def is_gap(line):
    return re.fullmatch(r"/\*\s*\.\.\.\s*\*/|//\s*\.\.\.", line) is not None


def contains(program, block):
    """Tells whether the parts of a block between gaps are parts of the program, in their order."""
    parts = [[]]
    for line in block:
        if is_gap(line):
            parts.append([])
        else:
            parts[-1].append(line)
    start = 0
    for part in parts:
        found = next((i for i in range(start, len(program) - len(part) + 1) if program[i:i + len(part)] == part), None)
        if found is None:
            return False
        start = found + len(part)
    return True


def check_code(root, path):
    programs = [lines_of_code(example.read_text()) for example in (root / "examples/Spider").glob("*.cpp")]
    consumer = lines_of_code((root / "test/Spider/consumer/CMakeLists.txt").read_text())
    for language, block in re.findall(r"^```(\w+)\n(.*?)^```", path.read_text(), flags=re.S | re.M):
        lines = lines_of_code(block)
        if language in ("cpp", "c++") and not any(contains(program, lines) for program in programs):
            complain(path.name, "no example has this code:\n" + block)
        if language == "cmake":
            for line in lines:
                if line not in consumer:
                    complain(path.name, f"the tests' consumer does not have the line {line}")
        if language == "sh":
            for command in re.findall(r"^(scripts/\S+)", block, flags=re.M):
                if not (root / command).exists():
                    complain(path.name, f"there is no {command}")
            for option in re.findall(r"-D(SPIDER_\w+)", block):
                if f"option({option} " not in (root / "CMakeLists.txt").read_text():
                    complain(path.name, f"there is no option {option}")


def public_text(root):
    headers = (root / "include/CGAL/Spider").glob("*.h")
    return "\n".join(header.read_text() for header in headers)


def check_names(path, text, public):
    for name in re.findall(r"`(?:[\w:]*::)?(\w+)\(", text) + re.findall(r"\\spiderfn\{(?:\w+::)?(\w+)\}", text):
        if name not in {known.split("::")[-1] for known in KNOWN} and not re.search(rf"\b{name}\b", public):
            complain(path.name, f"{name}() is not in the public headers")


def check_tables(root, data):
    shown = lambda v: f"{v:.2g}" if v < 9.5 else f"{v:.0f}"  # noqa: E731
    for file, rows, measure in (("accuracy_table.md", data["accuracy"], "H"), ("speed_table.md", data["speed"], "time")):
        text = (root / "doc/Spider" / file).read_text()
        cells = [cell.strip(" *") for line in text.splitlines() if line.startswith("|")
                 for cell in line.split("|")[2:-1]]
        there = sorted(cell for cell in cells if re.fullmatch(r"[\d.e+-]*\d", cell))
        wanted = sorted(shown(row[measure]) for row in rows if row[measure] is not None)
        if there != wanted:
            complain(file, "its numbers aren't those of figures.json: make both anew, by the target manual_figures")


def check_headlines(root, data):
    documents = {path: re.sub(r"\s+", " ", (root / path).read_text()) for path in ("README.md", "doc/Spider/Spider.txt")}
    for headline in data["headlines"].values():
        if headline not in documents["doc/Spider/Spider.txt"]:
            complain("Spider.txt", f"does not say what figures.json has measured: \"{headline}\"")
    for key in ("H", "speed"):
        if data["headlines"][key] not in documents["README.md"]:
            complain("README.md", f"does not say what figures.json has measured: \"{data['headlines'][key]}\"")


def own_parameters(root):
    return set(re.findall(r"DO\((\w+)\)", (root / "include/CGAL/Spider/parameters.h").read_text()))


def check_parameters(root):
    names = own_parameters(root)
    documented = set(re.findall(r"^auto (\w+)\(", (root / "doc/Spider/Named_parameters.h").read_text(), flags=re.M))
    for name in names ^ documented:
        complain("Named_parameters.h", f"{name} is in one of parameters.h and this file only")


def check_examples(root):
    listed = set(re.findall(r"\\example (\S+)", (root / "doc/Spider/examples.txt").read_text()))
    for name in listed ^ {example.name for example in (root / "examples/Spider").glob("*.cpp")}:
        complain("examples.txt", f"{name} is in one of examples/Spider and this list only")


def check_program(root):
    """Options of the program spider in blocks of sh are options that it has, and so is every parameter."""
    options = (root / "tool/Spider/command_line.cpp").read_text()
    for name in sorted(own_parameters(root).union(CGALS_PARAMETERS)):
        option = "--" + OPTIONS.get(name, name.replace("_", "-"))
        if not re.search(rf'[",]{option}[",]', options):
            complain("command_line.cpp", f"{name} is no option of the program spider: there is no {option}")
    for path in (root / "README.md", root / "doc/Spider/Spider.txt"):
        for line in re.findall(r"^spider .*$", path.read_text(), flags=re.M):
            for option in re.findall(r"\s(--[\w-]+)", line.split("#")[0]):
                if not re.search(rf'[",]{option}[",]', options):
                    complain(path.name, f"spider has no option {option}")


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    documents = [root / "README.md", root / "CHANGES.md", *sorted((root / "doc/Spider").glob("*.md"))]
    public = public_text(root)
    for path in documents:
        check_links(root, path)
        check_code(root, path)
        check_names(path, without_code(path.read_text()), public)
    for path in sorted((root / "doc/Spider").glob("*.txt")):
        check_names(path, path.read_text(), public)
    data = json.loads((root / "doc/Spider/figures.json").read_text())
    check_tables(root, data)
    check_headlines(root, data)
    check_parameters(root)
    check_examples(root)
    check_program(root)
    for error in errors:
        print(error, file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
