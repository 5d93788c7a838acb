#pragma once

#include "core/language/image/controllerimage.h"

#include <memory>
#include <string>

namespace camwright::test {

using enum DataType;

inline constexpr AreaId A = 3; ///< a byte area, 1024 bytes
inline constexpr AreaId B = 8; ///< another one

inline IrAddress byteAt(std::uint32_t byte, AreaId area = A) { return {area, IrAddress::WholeByte, byte}; }
inline IrAddress bitAt(std::uint32_t byte, std::uint8_t bit, AreaId area = A) { return {area, bit, byte}; }

/// Writes IR by hand: one main routine, two areas.
class IrBuilder {
public:
    IrBuilder()
    {
        m_image.target = {"kinco", "KS101M-04DX", {}};
        m_image.layout.areas = {{A, "V", 1024, 0, 512}, {B, "M", 1024, 0, 0}};
        m_image.program.routines.push_back({"Main", RoutineKind::Main, 0, {}});
    }

    IrBuilder& routine(std::string name)
    {
        m_image.program.routines.push_back({std::move(name), RoutineKind::Subroutine, 0, {}});
        m_current = m_image.program.routines.size() - 1;
        return *this;
    }

    IrRegister constant(DataType type, std::uint64_t bits)
    {
        IrInstruction i = make(IrOp::Const, type);
        i.constant = bits;
        return withDest(i);
    }
    IrRegister load(DataType type, IrAddress address)
    {
        IrInstruction i = make(IrOp::Load, type);
        i.address = address;
        return withDest(i);
    }
    IrRegister bit(IrAddress address) { return load(DataType::Bool, address); }
    IrRegister op(IrOp op, DataType type, IrRegister a, IrRegister b = NoRegister)
    {
        IrInstruction i = make(op, type);
        i.a = a;
        i.b = b;
        return withDest(i);
    }
    IrRegister convert(IrOp op, DataType from, DataType type, IrRegister a)
    {
        IrInstruction i = make(op, type);
        i.from = from;
        i.a = a;
        return withDest(i);
    }
    IrRegister indexed(IrOp op, DataType type, std::uint32_t index, IrRegister a, IrRegister b = NoRegister)
    {
        IrInstruction i = make(op, type);
        i.index = index;
        i.a = a;
        i.b = b;
        return withDest(i);
    }
    void store(DataType type, IrAddress address, IrRegister a)
    {
        IrInstruction i = make(IrOp::Store, type);
        i.address = address;
        i.a = a;
        code().push_back(i);
    }
    /// Returns the place of the instruction, for land().
    std::size_t control(IrOp op, std::uint32_t index = 0, IrRegister a = NoRegister, IrRegister b = NoRegister)
    {
        IrInstruction i = make(op, DataType::Bool);
        i.index = index;
        i.a = a;
        i.b = b;
        code().push_back(i);
        return code().size() - 1;
    }
    void land(std::size_t jump) { code()[jump].index = static_cast<std::uint32_t>(code().size()); }

    ControllerImage& image() { return m_image; }
    std::vector<IrInstruction>& code() { return m_image.program.routines[m_current].code; }
    std::shared_ptr<const ControllerImage> share() const { return std::make_shared<const ControllerImage>(m_image); }

private:
    static IrInstruction make(IrOp op, DataType type)
    {
        IrInstruction i;
        i.op = op;
        i.type = type;
        return i;
    }
    IrRegister withDest(IrInstruction i)
    {
        i.dest = m_image.program.routines[m_current].registers++;
        code().push_back(i);
        return i.dest;
    }

    ControllerImage m_image;
    std::size_t m_current = 0;
};

} // namespace camwright::test
