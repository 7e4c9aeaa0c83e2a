"""The tables of the trace: every traced call with what its arguments mean, and names by group."""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TYPES = {"GLbyte": "Byte", "GLubyte": "UnsignedByte", "GLshort": "Short", "GLushort": "UnsignedShort", "GLint": "Int",
         "GLsizei": "Int", "int": "Int", "GLuint": "UnsignedInt", "GLenum": "Enum", "GLbitfield": "Bits",
         "GLboolean": "Boolean", "GLfloat": "Float", "GLclampf": "Float", "GLdouble": "Double", "GLclampd": "Double",
         "GLintptr": "Long", "GLint64": "Long", "GLhalfNV": "UnsignedShort", "GLchar": "Pointer", "GLDEBUGPROC": "Pointer", "GLsizeiptr": "Long", "uint64_t": "UnsignedLong", "char": "String",
         "OSMesaContext": "Pointer", "OSMESAproc": "Pointer", "void": "Pointer"}
NO_NAMES, ANY_NAME, NAMES_OF_PARAMETER = 0, 1, 255
# Buffers that the library fills after the call.
LATER = {"FeedbackBuffer", "SelectBuffer"}
QUERIES = {"Light": "light", "Material": "material", "TexParameter": "texture", "TexEnv": "texture_environment",
           "TexGen": "texture_generation"}


class Names:
    """Names by group: those of GL 1.0 to 1.5; and the group of all names, of later versions and extensions, too."""
    def __init__(self, root, rows):
        self.blob, self.offsets = [], {}
        self.length = 0
        self.groups = {"any": {}}  # value: name
        self.values = {}           # token: group
        enums = {e.get("name"): e for group in root.findall("enums") for e in group.findall("enum")
                 if e.get("api") in (None, "gl")}
        bitmasks = {e.get("name") for group in root.findall("enums") if group.get("type") == "bitmask"
                    for e in group.findall("enum")}
        core, later = [], []
        for feature in root.findall("feature"):
            if feature.get("api") == "gl":
                wanted = core if float(feature.get("number")) <= 1.5 else later
                wanted += [e.get("name") for e in feature.findall("require/enum")]
        for extension in root.findall("extensions/extension"):
            if "gl" in extension.get("supported").split("|") and extension.get("name")[3:6] in ("ARB", "EXT", "KHR"):
                later += [e.get("name") for e in extension.findall("require/enum")]
        self.value_of = {name: int(e.get("value"), 0) for name, e in enums.items()}
        for name in core:
            for group in (enums[name].get("group") or "").split(","):
                if group:
                    self.groups.setdefault(group, {}).setdefault(self.value_of[name], name)
        for kind, *fields in rows:
            if kind == "enum":
                group, value, name = fields
                self.groups.setdefault(group, {})[int(value, 0)] = name
                self.value_of[name] = int(value, 0)
        for name in core + later:  # small values are names of too many things
            if name in enums and name not in bitmasks and 0x100 <= self.value_of[name] < 0xffffffff:
                self.groups["any"].setdefault(self.value_of[name], name)
        self.numbers = {"": NO_NAMES, "any": ANY_NAME}
        for kind, *fields in rows:
            if kind == "value":
                self.values[self.value_of[fields[0]]] = self.number(fields[1])

    def number(self, group):
        """Of a group that is used; one without names counts as none."""
        if group not in self.groups:
            return NO_NAMES
        return self.numbers.setdefault(group, len(self.numbers))

    def offset(self, name):
        if name not in self.offsets:
            self.offsets[name] = self.length
            self.blob.append(name)
            self.length += len(name) + 1
        return self.offsets[name]


def read_rows():
    rows = []
    for number, line in enumerate(open(os.path.join(HERE, "names.tsv")), 1):
        if line.startswith("#") or not line.strip():
            continue
        kind, rest = line.strip().split(None, 1)
        fields = [rest] if kind == "function" else rest.split()
        if kind not in ("enum", "value", "function") or len(fields) != {"enum": 3, "value": 2, "function": 1}[kind]:
            sys.exit(f"names.tsv:{number}: not a row of this file")
        rows.append((kind, *fields))
    return rows


def parameter(kind, group, length="Value", operand=0, out=False):
    return f"{{TraceType::{kind}, {group}, TraceLength::{length}, {operand}, {'true' if out else 'false'}}}"


def gl_parameter(row, command, index, names):
    """A parameter of gl.xml as a row of the table."""
    p = command.parameters[index]
    kind = TYPES[p.base().replace("const", "").strip()]
    position = {q.name: i for i, q in enumerate(command.parameters)}
    follows_name = index > 0 and command.parameters[index - 1].name == "pname"
    group = NAMES_OF_PARAMETER if follows_name else names.number(p.group)
    if not p.pointer:
        return parameter(kind, group)
    size = re.sub(r"^COMPSIZE\((\w+)\)$", r"\1", p.length or "")
    out = not p.type.startswith("const")
    levels = p.type.count("*")
    if levels == 2:
        kind = "Pointer"
    if command.name in LATER or (kind == "Pointer" and levels == 1 and command.name != "CallLists"):
        return parameter("Pointer", 0)
    if command.name == "CallLists":
        return parameter("Pointer", 0, "Lists", 0)
    if size.isdigit():
        return parameter(kind, group, "Fixed", size, out)
    if size == "pname":
        table = re.match(r"Get(\w+?)[fid]v$", command.name)
        if command.name in ("GetBooleanv", "GetIntegerv", "GetInteger64v", "GetFloatv", "GetDoublev"):
            return parameter(kind, group, "State", 0, out)
        if row is not None and row.convert.startswith("pname:"):
            return parameter(kind, group, "Parameter", f"kCountOf_{row.convert[6:]}", out)
        if table and table.group(1) in QUERIES:
            return parameter(kind, group, "Parameter", f"kCountOf_{QUERIES[table.group(1)]}", out)
        return parameter(kind, group, "Fixed", 1, out)
    if size in position:
        return parameter(kind, group, "Argument", position[size], out)
    return parameter("Pointer", 0)


def named(row, name, names):
    """A row of the table with the name of its parameter."""
    return f"{{{names.offset(name)}, {row[1:]}"


def result_type(text, group, names):
    text = text.replace("const ", "").strip()
    if text == "void":
        return "Void", 0
    if text in ("GLubyte*", "char*"):
        return "String", 0
    return ("Pointer", 0) if "*" in text else (TYPES[text], names.number(group))


def own_function(prototype, names):
    """Name, parameters and result of a row `function`."""
    returns, name, arguments = re.match(r"(.*?)\s*(\w+)\((.*)\)$", prototype).groups()
    parameters = []
    for text in filter(None, arguments.split(", ")):
        kind, group, stars, argument, count = re.match(
            r"(?:const )?(\w+)(?:\((\w+)\))?(\**) (\w+)(?:\[(\d+)\])?$", text).groups()
        after = parameters and "OSMesaName" in arguments
        names_of = NAMES_OF_PARAMETER if after else names.number(group or "")
        if argument == "format" and stars:
            names_of = names.number("OSMesaFormat")
        if argument == "attributes":
            parameters.append(parameter("Int", names.number("OSMesaName"), "Attributes"))
        elif count:
            parameters.append(parameter("Pointer" if len(stars) == 2 else TYPES[kind], names_of, "Fixed", count, True))
        elif stars:
            parameters.append(parameter("String" if kind == "char" else "Pointer", 0))
        else:
            parameters.append(parameter(TYPES[kind], names_of))
        parameters[-1] = named(parameters[-1], argument, names)
    return name, parameters, result_type(returns, "", names)


def lines_of(entries):
    """Several a line."""
    lines, line = [], "   "
    for entry in entries:
        if len(line) + len(entry) > 107:
            lines.append(line)
            line = "   "
        line += f" {entry},"
    return "".join(text + "\n" for text in lines + [line])


def string_blob(words, indent):
    lines, line = [], ""
    for word in words:
        part = f"{word}\\0"
        if len(line) + len(part) > 104:
            lines.append(line)
            line = ""
        line += part
    return "\n".join(f'{indent}"{text}"' for text in lines + [line])


def tables(root, doors, banner):
    """`doors`: (exported name without gl, its row or None, its command of gl.xml)."""
    rows = read_rows()
    names = Names(root, rows)
    calls = []
    for export, row, command in doors:
        parameters = [named(gl_parameter(row, command, i, names), p.name, names)
                      for i, p in enumerate(command.parameters)]
        calls.append(("gl" + export, parameters, result_type(command.returns, command.group, names)))
    calls += [own_function(fields[0], names) for kind, *fields in rows if kind == "function"]

    files = {}
    files["api/generated/traced_calls.h"] = (
        banner + "// The calls that a trace knows.\n#pragma once\n\n#include <cstdint>\n\nnamespace softgl {\n\n"
        "enum class TracedCall : uint16_t {\n" + "".join(f"  {name},\n" for name, _, _ in calls) + "};\n\n} // namespace softgl\n")

    sequence, firsts = [], {}
    call_rows = ""
    for name, parameters, (kind, group) in calls:
        key = tuple(parameters)
        if key not in firsts:
            firsts[key] = len(sequence)
            sequence += parameters
        call_rows += f"    {{{names.offset(name)}, {firsts[key]}, {len(parameters)}, TraceType::{kind}, {group}}},\n"
    entries, starts = [], []
    for group in names.numbers:
        starts.append(len(entries))
        for value, name in sorted(names.groups.get(group, {}).items()):
            entries.append(f"{{0x{value:x}, {names.offset(name)}}}")
    starts.append(len(entries))
    values = "".join(f"    {{0x{token:x}, {group}}},\n" for token, group in sorted(names.values.items()))
    files["api/generated/trace_tables.cpp"] = (
        banner + "// What the trace knows of calls and names.\n\n#include \"api/trace_tables.h\"\n\n"
        "#include \"api/argument_conversion.h\"\n\nnamespace softgl {\n\n"
        "const TraceCall kTraceCalls[] = {\n" + call_rows + "};\n\n"
        "const TraceParameter kTraceParameters[] = {\n" + "".join(f"    {p},\n" for p in sequence) + "};\n\n"
        "// The names of a group, sorted by value, begin where the group begins; behind the last group is the end.\n"
        "const uint16_t kTraceGroups[] = {" + ", ".join(map(str, starts)) + "};\n\n"
        "const TraceName kTraceNames[] = {\n" + lines_of(entries) + "};\n\n"
        "const TraceValueGroup kTraceValueGroups[] = {\n" + values + "};\n"
        "const int kTraceValueGroupCount = sizeof kTraceValueGroups / sizeof kTraceValueGroups[0];\n\n"
        "const char kTraceText[] =\n" + string_blob(names.blob, "    ") + ";\n\n} // namespace softgl\n")
    return files
