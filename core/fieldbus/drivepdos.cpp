#include "core/fieldbus/drivepdos.h"

#include "core/fieldbus/canopenmaster.h"
#include "core/fieldbus/framebytes.h"

namespace camwright {

namespace {

constexpr std::array<DrivePdo, kDriveReceivePdos + kDriveTransmitPdos> kPdos{{
    {false, 1, 3, {0x60400010, 0x60600008, 0x607A0020}},
    {false, 2, 2, {0x60810020, 0x60FF0020}},
    {true, 1, 3, {0x60410010, 0x60610008, 0x60640020}},
    {true, 2, 2, {0x606C0020, 0x60620020}},
    {true, 3, 3, {0x60780010, 0x60FD0020, 0x603F0010}},
}};

} // namespace

std::uint32_t DrivePdo::id(std::uint8_t node) const
{
    return transmit ? transmitPdoId(number, node) : receivePdoId(number, node);
}

std::span<const DrivePdo> drivePdos() { return kPdos; }

CanFrame packOutputs(const DriveOutputs& outputs, unsigned number, std::uint8_t node)
{
    CanFrame frame;
    frame.id = receivePdoId(number, node);
    if (number == 1) {
        frame.length = 7;
        putLittle(&frame.data[0], outputs.controlWord, 2);
        frame.data[2] = static_cast<std::uint8_t>(outputs.mode);
        putLittle(&frame.data[3], static_cast<std::uint32_t>(outputs.targetPosition), 4);
    } else {
        frame.length = 8;
        putLittle(&frame.data[0], outputs.profileVelocity, 4);
        putLittle(&frame.data[4], static_cast<std::uint32_t>(outputs.targetVelocity), 4);
    }
    return frame;
}

bool unpackInputs(const CanFrame& frame, unsigned number, DriveInputs& inputs)
{
    const auto u = [&frame](unsigned at, unsigned size) { return static_cast<std::uint32_t>(getLittle(&frame.data[at], size)); };
    if (frame.length < (number == 1 ? 7 : 8))
        return false;
    switch (number) {
    case 1:
        inputs.statusWord = static_cast<std::uint16_t>(u(0, 2));
        inputs.mode = static_cast<std::int8_t>(u(2, 1));
        inputs.position = static_cast<std::int32_t>(u(3, 4));
        return true;
    case 2:
        inputs.velocity = static_cast<std::int32_t>(u(0, 4));
        inputs.demandPosition = static_cast<std::int32_t>(u(4, 4));
        return true;
    default:
        inputs.torque = static_cast<std::int16_t>(u(0, 2));
        inputs.digitalInputs = u(2, 4);
        inputs.errorCode = static_cast<std::uint16_t>(u(6, 2));
        return true;
    }
}

} // namespace camwright
