#pragma once

#include "core/language/image/controllerimage.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

namespace camwright::test {

/// A second executor for tests, as simple as can be: one instruction after the other, every register a number in a table,
/// nothing fused, nothing shared with the interpreter.
class NaiveEvaluator {
public:
    explicit NaiveEvaluator(const ControllerImage& image) : m_image(image), m_state(image.program.stateBytes, 0)
    {
        for (const ImageArea& area : image.layout.areas)
            m_areas[area.id].assign(area.bytes, 0);
    }

    std::vector<std::uint8_t>& area(AreaId id) { return m_areas[id]; }

    void scan() { run(m_image.program.routines[0]); }

private:
    void run(const IrRoutine& routine)
    {
        std::vector<std::uint64_t> r(routine.registers, 0);
        for (std::size_t at = 0; at < routine.code.size(); ++at) {
            const IrInstruction& i = routine.code[at];
            switch (i.op) {
            case IrOp::Jump: at = i.index - std::size_t{1}; break;
            case IrOp::JumpIf: at = r[i.a] ? i.index - std::size_t{1} : at; break;
            case IrOp::JumpIfNot: at = r[i.a] ? at : i.index - std::size_t{1}; break;
            case IrOp::Call: run(m_image.program.routines[i.index]); break;
            case IrOp::Return: return;
            case IrOp::Const: r[i.dest] = i.constant; break;
            case IrOp::Load: r[i.dest] = load(i); break;
            case IrOp::Store: store(i, r[i.a]); break;
            case IrOp::RisingEdge: r[i.dest] = r[i.a] && !m_state[i.index]; m_state[i.index] = r[i.a] != 0; break;
            case IrOp::FallingEdge: r[i.dest] = !r[i.a] && m_state[i.index]; m_state[i.index] = r[i.a] != 0; break;
            default: r[i.dest] = compute(i, r[i.a], i.b == NoRegister ? 0 : r[i.b]); break;
            }
        }
    }

    std::uint64_t load(const IrInstruction& i)
    {
        const std::uint8_t* p = m_areas[i.address.area].data() + i.address.byte;
        if (i.type == DataType::Bool)
            return i.address.bit == IrAddress::WholeByte ? *p != 0 : (*p >> i.address.bit) & 1;
        std::uint64_t bits = 0;
        for (unsigned k = 0; k < byteWidth(i.type); ++k)
            bits |= std::uint64_t{p[k]} << (8 * k);
        return bits;
    }

    void store(const IrInstruction& i, std::uint64_t bits)
    {
        std::uint8_t* p = m_areas[i.address.area].data() + i.address.byte;
        if (i.type == DataType::Bool) {
            const unsigned mask = i.address.bit == IrAddress::WholeByte ? 0xFF : 1u << i.address.bit;
            const unsigned one = i.address.bit == IrAddress::WholeByte ? 1u : mask;
            *p = static_cast<std::uint8_t>((*p & ~mask) | (bits ? one : 0));
            return;
        }
        if (i.type == DataType::Real)
            bits = realBits(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        for (unsigned k = 0; k < byteWidth(i.type); ++k)
            p[k] = static_cast<std::uint8_t>(bits >> (8 * k));
    }

    static std::uint64_t realBits(float value)
    {
        return std::isnan(value) ? 0x7FC00000u : std::bit_cast<std::uint32_t>(value);
    }

    static std::uint64_t cut(DataType type, std::int64_t number)
    {
        const unsigned width = bitWidth(type);
        return static_cast<std::uint64_t>(number) & (width == 64 ? ~0ull : (1ull << width) - 1);
    }

    static std::uint64_t compute(const IrInstruction& i, std::uint64_t a, std::uint64_t b)
    {
        if (i.op == IrOp::Convert)
            return convert(i, a);
        if (i.type == DataType::Real)
            return computeReal(i.op, std::bit_cast<float>(static_cast<std::uint32_t>(a)), std::bit_cast<float>(static_cast<std::uint32_t>(b)));
        return computeInteger(i.op, i.type, Value{i.type, a}.asInteger(), Value{i.type, b}.asInteger());
    }

    static std::uint64_t convert(const IrInstruction& i, std::uint64_t a)
    {
        const Value value{i.from, a};
        if (isFloat(i.from))
            return Value::ofDouble(i.type, value.asDouble()).bits;
        return i.type == DataType::Real ? realBits(static_cast<float>(value.asInteger())) : cut(i.type, value.asInteger());
    }

    static std::uint64_t computeReal(IrOp op, float a, float b)
    {
        switch (op) {
        case IrOp::Add: return realBits(a + b);
        case IrOp::Sub: return realBits(a - b);
        case IrOp::Mul: return realBits(a * b);
        case IrOp::Div: return realBits(a / b);
        case IrOp::Equal: return a == b;
        case IrOp::NotEqual: return !(a == b);
        case IrOp::Greater: return a > b;
        case IrOp::GreaterEqual: return a >= b;
        case IrOp::Less: return a < b;
        default: return a <= b;
        }
    }

    static std::uint64_t computeInteger(IrOp op, DataType type, std::int64_t a, std::int64_t b)
    {
        switch (op) {
        case IrOp::Not: return cut(type, ~a);
        case IrOp::And: return cut(type, a & b);
        case IrOp::Or: return cut(type, a | b);
        case IrOp::Xor: return cut(type, a ^ b);
        case IrOp::Add: return cut(type, a + b);
        case IrOp::Sub: return cut(type, a - b);
        case IrOp::Mul: return cut(type, static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b)));
        case IrOp::Div: return b == 0 ? 0 : cut(type, a / b);
        case IrOp::Mod: return b == 0 ? 0 : cut(type, a % b);
        case IrOp::Equal: return a == b;
        case IrOp::NotEqual: return a != b;
        case IrOp::Greater: return a > b;
        case IrOp::GreaterEqual: return a >= b;
        case IrOp::Less: return a < b;
        default: return a <= b;
        }
    }

    const ControllerImage& m_image;
    std::map<AreaId, std::vector<std::uint8_t>> m_areas;
    std::vector<std::uint8_t> m_state;
};

} // namespace camwright::test
