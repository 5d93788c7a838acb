#pragma once

#include "core/language/image/controllerimage.h"
#include "core/runtime/memory/memory.h"

#include <dlfcn.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace camwright::bench {

/// Writes the main routine of an image as C, one function for so many instructions: what a C compiler makes of the same
/// work. Without guards or counting; only the operations that the benchmark's programs have. `oneNaN`: stores the one NaN of the
/// controller, so that results can be compared.
class CWriter {
public:
    CWriter(const ControllerImage& image, const Memory& memory, bool oneNaN) : m_image(image), m_memory(memory), m_oneNaN(oneNaN) {}

    std::string write()
    {
        m_out << "#include <stdint.h>\n#include <string.h>\n";
        for (const IrRoutine& routine : m_image.program.routines) {
            if (routine.kind == RoutineKind::Main)
                writeRoutine(routine);
        }
        m_out << "void scan(uint8_t *m) {\n";
        for (unsigned f = 0; f < m_functions; ++f)
            m_out << "f" << f << "(m);\n";
        m_out << "}\n";
        return m_out.str();
    }

private:
    static constexpr std::size_t InstructionsPerFunction = 800;

    void writeRoutine(const IrRoutine& routine)
    {
        std::vector<bool> isLabel(routine.code.size() + 1, false);
        std::vector<std::size_t> lastUse(routine.registers, 0);
        std::size_t farthest = 0;
        for (std::size_t at = 0; at < routine.code.size(); ++at) {
            const IrInstruction& i = routine.code[at];
            const IrShape& shape = shapeOf(i.op);
            if (shape.index == IrShape::Index::Target)
                isLabel[i.index] = true;
            if (shape.a)
                lastUse[i.a] = at;
            if (shape.b)
                lastUse[i.b] = at;
        }
        std::size_t begin = 0;
        for (std::size_t at = 0; at < routine.code.size(); ++at) {
            const IrInstruction& i = routine.code[at];
            if (at == begin)
                m_out << "static __attribute__((noinline)) void f" << m_functions << "(uint8_t *m) {\n";
            if (isLabel[at])
                m_out << "L" << at << ":;\n";
            writeInstruction(i);
            if (shapeOf(i.op).index == IrShape::Index::Target)
                farthest = std::max<std::size_t>(farthest, i.index);
            if (shapeOf(i.op).dest)
                farthest = std::max(farthest, lastUse[i.dest] + 1);
            const bool ends = at + 1 == routine.code.size() || (at - begin > InstructionsPerFunction && farthest <= at + 1);
            if (!ends)
                continue;
            if (isLabel[at + 1])
                m_out << "L" << at + 1 << ":;\n";
            m_out << "}\n";
            if (isLabel[at + 1])
                isLabel[at + 1] = false;
            begin = at + 1;
            ++m_functions;
        }
    }

    static const char* typeName(DataType type)
    {
        if (type == DataType::Real)
            return "float";
        if (type == DataType::Lreal)
            return "double";
        static const char* const Signed[] = {"int8_t", "int16_t", "int32_t", "int64_t"};
        static const char* const Unsigned[] = {"uint8_t", "uint16_t", "uint32_t", "uint64_t"};
        const unsigned bytes = byteWidth(type);
        const unsigned index = bytes == 1 ? 0 : bytes == 2 ? 1 : bytes == 4 ? 2 : 3;
        return isSigned(type) ? Signed[index] : Unsigned[index];
    }

    std::ostream& define(const IrInstruction& i)
    {
        return m_out << "const " << typeName(resultType(i.op, i.type)) << " r" << i.dest << " = ";
    }

    void binary(const IrInstruction& i, const char* sign)
    {
        const bool wraps = isSigned(i.type) && !isFloat(i.type) && (i.op == IrOp::Add || i.op == IrOp::Sub || i.op == IrOp::Mul);
        if (wraps)
            define(i) << "(" << typeName(i.type) << ")((uint32_t)r" << i.a << sign << "(uint32_t)r" << i.b << ");\n";
        else
            define(i) << "r" << i.a << sign << "r" << i.b << ";\n";
    }

    void writeInstruction(const IrInstruction& i)
    {
        const std::uint32_t offset = m_memory.offsetOf(i.address.area, i.address.byte);
        const bool isBit = i.type == DataType::Bool && i.address.bit != IrAddress::WholeByte;
        switch (i.op) {
        case IrOp::Nop: return;
        case IrOp::Jump: m_out << "goto L" << i.index << ";\n"; return;
        case IrOp::JumpIf: m_out << "if (r" << i.a << ") goto L" << i.index << ";\n"; return;
        case IrOp::JumpIfNot: m_out << "if (!r" << i.a << ") goto L" << i.index << ";\n"; return;
        case IrOp::Const:
            if (isFloat(i.type)) {
                m_out << typeName(i.type) << " r" << i.dest << "; { const uint64_t b = " << i.constant << "u; memcpy(&r" << i.dest << ", &b, "
                      << byteWidth(i.type) << "); }\n";
            } else {
                define(i) << "(" << typeName(i.type) << ")" << i.constant << "u;\n";
            }
            return;
        case IrOp::Load:
            if (isBit)
                define(i) << "(m[" << offset << "] >> " << unsigned{i.address.bit} << ") & 1;\n";
            else if (i.type == DataType::Bool)
                define(i) << "m[" << offset << "] != 0;\n";
            else
                m_out << typeName(i.type) << " r" << i.dest << "; memcpy(&r" << i.dest << ", m + " << offset << ", " << byteWidth(i.type) << ");\n";
            return;
        case IrOp::Store:
            if (isBit)
                m_out << "m[" << offset << "] = (uint8_t)((m[" << offset << "] & ~" << (1u << i.address.bit) << "u) | (r" << i.a << " << "
                      << unsigned{i.address.bit} << "));\n";
            else if (m_oneNaN && i.type == DataType::Real)
                m_out << "{ float f = r" << i.a << "; const uint32_t n = 0x7FC00000; if (f != f) memcpy(&f, &n, 4); memcpy(m + " << offset << ", &f, 4); }\n";
            else
                m_out << "memcpy(m + " << offset << ", &r" << i.a << ", " << byteWidth(i.type) << ");\n";
            return;
        case IrOp::Not: define(i) << (i.type == DataType::Bool ? "!r" : "~r") << i.a << ";\n"; return;
        case IrOp::And: return binary(i, " & ");
        case IrOp::Or: return binary(i, " | ");
        case IrOp::Xor: return binary(i, " ^ ");
        case IrOp::Add: return binary(i, " + ");
        case IrOp::Sub: return binary(i, " - ");
        case IrOp::Mul: return binary(i, " * ");
        case IrOp::Equal: return binary(i, " == ");
        case IrOp::NotEqual: return binary(i, " != ");
        case IrOp::Greater: return binary(i, " > ");
        case IrOp::GreaterEqual: return binary(i, " >= ");
        case IrOp::Less: return binary(i, " < ");
        case IrOp::LessEqual: return binary(i, " <= ");
        case IrOp::Convert: define(i) << "(" << typeName(i.type) << ")r" << i.a << ";\n"; return;
        default: std::fprintf(stderr, "no C for %s\n", std::string(name(i.op)).c_str()); std::abort();
        }
    }

    const ControllerImage& m_image;
    const Memory& m_memory;
    bool m_oneNaN;
    std::ostringstream m_out;
    unsigned m_functions = 0;
};

/// A shared library made by gcc; its scan() works on the bytes of a Memory. Null where there is no gcc.
class CProgram {
public:
    using Scan = void (*)(std::uint8_t*);

    static Scan compile(const ControllerImage& image, const Memory& memory, bool oneNaN)
    {
        static unsigned number = 0; // a library of a name that was loaded before would not be loaded again
        const std::filesystem::path folder
            = std::filesystem::temp_directory_path() / ("camwright-bench-" + std::to_string(::getpid()) + "-" + std::to_string(number++));
        std::filesystem::create_directories(folder);
        const std::string source = (folder / "scan.c").string();
        const std::string library = (folder / "scan.so").string();
        std::ofstream(source) << CWriter(image, memory, oneNaN).write();
        const int status = std::system(("gcc -O2 -ffp-contract=off -shared -fPIC -o " + library + " " + source).c_str());
        void* const handle = status == 0 ? ::dlopen(library.c_str(), RTLD_NOW) : nullptr;
        std::filesystem::remove_all(folder);
        return handle ? reinterpret_cast<Scan>(::dlsym(handle, "scan")) : nullptr;
    }
};

} // namespace camwright::bench
