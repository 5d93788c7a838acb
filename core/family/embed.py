"""Turns the files of resources/families into one C++ source: embed.py OUTPUT ROOT FILE...

The output depends only on the files' bytes and their paths below ROOT.
"""
import pathlib
import sys


def main():
    output, root, files = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sorted(sys.argv[3:])
    out = ['#include "core/family/embedded.h"', "", "namespace camwright {", "", "namespace {"]
    rows = []
    for number, name in enumerate(files):
        data = (root / name).read_bytes()
        out.append(f"const char File{number}[] = {{")
        signed = [str(b if b < 128 else b - 256) for b in data]
        for start in range(0, len(signed), 40):
            out.append(",".join(signed[start:start + 40]) + ",")
        out.append("0};")
        rows.append(f'    {{"{name}", {{File{number}, {len(data)}}}}},')
    out += ["", "struct Row {", "    std::string_view path, bytes;", "};", "const Row Rows[] = {"] + rows + ["};"]
    out += ["} // namespace", "", "std::string_view embeddedFamilyFile(std::string_view path)", "{",
            "    for (const Row& row : Rows) {", "        if (row.path == path)", "            return row.bytes;", "    }",
            "    return {};", "}", "", "} // namespace camwright", ""]
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text("\n".join(out))


main()
