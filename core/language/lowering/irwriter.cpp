#include "core/language/lowering/irwriter.h"

namespace camwright {

IrInstruction IrWriter::make(IrOp op, DataType type) const
{
    IrInstruction instruction;
    instruction.op = op;
    instruction.type = type;
    instruction.source = m_source;
    return instruction;
}

std::size_t IrWriter::emit(const IrInstruction& instruction)
{
    m_routine.code.push_back(instruction);
    return m_routine.code.size() - 1;
}

IrRegister IrWriter::define(IrInstruction instruction)
{
    instruction.dest = m_routine.registers++;
    m_routine.code.push_back(instruction);
    return instruction.dest;
}

IrRegister IrWriter::constant(DataType type, std::uint64_t bits)
{
    IrInstruction instruction = make(IrOp::Const, type);
    const unsigned width = bitWidth(type);
    instruction.constant = width == 64 ? bits : bits & ((std::uint64_t{1} << width) - 1);
    return define(instruction);
}

IrRegister IrWriter::load(DataType type, const IrAddress& address)
{
    IrInstruction instruction = make(IrOp::Load, type);
    instruction.address = address;
    return define(instruction);
}

void IrWriter::store(DataType type, const IrAddress& address, IrRegister value)
{
    IrInstruction instruction = make(IrOp::Store, type);
    instruction.address = address;
    instruction.a = value;
    m_routine.code.push_back(instruction);
}

IrRegister IrWriter::compute(IrOp op, DataType type, IrRegister a, IrRegister b)
{
    IrInstruction instruction = make(op, type);
    instruction.a = a;
    instruction.b = b;
    return define(instruction);
}

IrRegister IrWriter::bound(IrRegister a, std::uint32_t count)
{
    IrInstruction instruction = make(IrOp::Bound, DataType::Dint);
    instruction.a = a;
    instruction.constant = irConstant(0, count);
    return define(instruction);
}

IrRegister IrWriter::loadElement(DataType type, const IrAddress& address, IrRegister index, std::uint32_t stride)
{
    IrInstruction instruction = make(IrOp::LoadElement, type);
    instruction.address = address;
    instruction.b = index;
    instruction.constant = stride;
    return define(instruction);
}

void IrWriter::storeElement(DataType type, const IrAddress& address, IrRegister index, std::uint32_t stride, IrRegister value)
{
    IrInstruction instruction = make(IrOp::StoreElement, type);
    instruction.address = address;
    instruction.a = value;
    instruction.b = index;
    instruction.constant = stride;
    m_routine.code.push_back(instruction);
}

IrRegister IrWriter::convert(IrOp op, DataType from, DataType type, IrRegister a)
{
    IrInstruction instruction = make(op, type);
    instruction.from = from;
    instruction.a = a;
    return define(instruction);
}

IrRegister IrWriter::element(IrOp op, DataType type, std::uint32_t index, IrRegister a, IrRegister b)
{
    IrInstruction instruction = make(op, type);
    instruction.index = index;
    instruction.a = a;
    instruction.b = b;
    return define(instruction);
}

IrRegister IrWriter::select(DataType type, IrRegister condition, IrRegister a, IrRegister b)
{
    IrInstruction instruction = make(IrOp::Select, type);
    instruction.a = condition;
    instruction.b = a;
    instruction.index = b;
    return define(instruction);
}

void IrWriter::control(IrOp op, std::uint32_t index, IrRegister a, IrRegister b)
{
    IrInstruction instruction = make(op, DataType::Bool);
    instruction.index = index;
    instruction.a = a;
    instruction.b = b;
    m_routine.code.push_back(instruction);
}

std::size_t IrWriter::jumpIf(bool sense, IrRegister condition)
{
    control(sense ? IrOp::JumpIf : IrOp::JumpIfNot, 0, condition);
    return m_routine.code.size() - 1;
}

std::size_t IrWriter::jump()
{
    control(IrOp::Jump);
    return m_routine.code.size() - 1;
}

void IrWriter::land(std::size_t jump)
{
    land(jump, here());
}

void IrWriter::land(std::size_t jump, std::size_t target)
{
    m_routine.code[jump].index = static_cast<std::uint32_t>(target);
}

} // namespace camwright
