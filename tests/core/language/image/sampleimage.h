#pragma once

#include "tests/core/runtime/executor/irbuilder.h"

namespace camwright::test {

/// An image in which nothing is left at its default: two routines, every kind of table, axes, variables, places, source.
inline ControllerImage sampleImage()
{
    IrBuilder b;
    ControllerImage& image = b.image();
    image.target.catalogue.bytes.fill(7);
    image.program.stateBytes = 64;
    image.program.timers = {{TimerKind::Ton, byteAt(40), bitAt(42, 0), 0, 10000000},
                            {TimerKind::T600Tmon, byteAt(44), byteAt(46), 24, 1000000}};
    image.program.counters = {{CounterKind::UpDown, Int, byteAt(50), bitAt(52, 1), 48}, {CounterKind::T600Up, Dint, byteAt(54), byteAt(58), 52}};
    IrBlock block;
    block.instruction = 1203;
    block.pins = {{IrPin::Kind::Memory, Bool, 0, bitAt(60, 5)}, {IrPin::Kind::Constant, Int, 0xFFFF, {}}, {}};
    image.program.blocks = {block};

    // One call a statement: the order of arguments is the compiler's choice, that of instructions must not be.
    const IrRegister first = b.bit(bitAt(0, 0));
    const IrRegister second = b.op(IrOp::Not, Bool, b.bit(bitAt(0, 1)));
    const IrRegister flow = b.op(IrOp::And, Bool, first, second);
    const IrRegister edge = b.indexed(IrOp::RisingEdge, Bool, 60, flow);
    const IrRegister preset = b.constant(Int, 5);
    const IrRegister timer = b.indexed(IrOp::Timer, Int, 0, edge, preset);
    b.store(Bool, bitAt(2, 4), b.op(IrOp::Or, Bool, timer, b.indexed(IrOp::Timer, Int, 1, flow, preset)));
    b.control(IrOp::CounterArm, 0, edge, flow);
    b.store(Bool, byteAt(3), b.indexed(IrOp::Counter, Int, 0, flow, preset));
    b.control(IrOp::CounterReset, 1, flow);
    b.control(IrOp::TimerReset, 1, edge);
    const std::size_t skip = b.control(IrOp::JumpIfNot, 0, flow);
    b.store(Real, byteAt(8), b.convert(IrOp::Convert, Int, Real, b.load(Int, byteAt(6))));
    b.control(IrOp::Call, 1);
    b.land(skip);
    b.control(IrOp::Block, 0, flow);
    b.routine("Sub");
    const IrRegister dividend = b.load(Dint, byteAt(16));
    const IrRegister divisor = b.constant(Dint, 0xFFFFFFFF);
    b.store(Dint, byteAt(12, B), b.op(IrOp::Div, Dint, dividend, divisor));
    b.control(IrOp::Return);
    for (std::size_t i = 0; i < b.code().size(); ++i)
        b.code()[i].source = static_cast<std::uint32_t>(i % 3);

    image.layout.areas.push_back({VariablesArea, "", 16, 0, 4});
    image.layout.initialValues = {{valueAddress(A, 100, Real), Value::ofReal(1.5f)}, {bitAddress(VariablesArea, 2), Value::ofBool(true)}};
    image.layout.instructionErrorFlag = bitAddress(B, 900, 6);
    image.configuration.scanPeriod = 2ms;
    image.configuration.watchdog = 500ms;
    image.configuration.network = {true, 500000, 50};
    image.configuration.axes = {{"Feed", 1, false, 10000, 100.0, 1000, 3, 10, 5, 1, -200, 300, 12.5, 2.0},
                                {"Turn", 2, true, 20000, 45.0, 500, 2, 20, 3, 0, -1e5, 1e5, 0, 1.5}};
    image.symbols = {{"Lamp", bitAddress(A, 2, 4), false}, {"Speed", valueAddress(VariablesArea, 4, Real), true}};
    image.debug.projectName = "feeder";
    image.debug.objects = {{ObjectKind::Program, "Main"}, {ObjectKind::Program, "Sub"}};
    image.debug.sources = {{0, 0, {1, 1, 1, 9}}, {1, 4, {20, 3, 21, 1}}};
    image.source = {{"programs/Main.il", "LD %M0.0\nST %M0.1\n"}, {"project.toml", "version = 1\n"}};
    return image;
}

} // namespace camwright::test
