#include "tests/core/runtime/kinco/kincobench.h"

#include "core/family/family.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace camwright {

namespace {

const Family& kincoFamily()
{
    return *findFamily("kinco");
}

IrAddress irAddress(const Address& address)
{
    IrAddress out;
    out.area = address.area;
    out.byte = address.byte;
    out.bit = address.isBit ? address.bit : IrAddress::WholeByte;
    return out;
}

IrPin pinOf(const Pin& pin, const std::string& operand, const ControllerModel& model)
{
    IrPin out;
    const std::vector<DataType> types = pin.types.list();
    out.type = types.empty() ? DataType::Dword : types.front();
    if (operand.starts_with("%")) {
        const Result<Address> address = kincoFamily().parseAddress(operand, model);
        if (!address)
            throw std::runtime_error(englishText(address.error()));
        out.kind = IrPin::Kind::Memory;
        out.address = irAddress(*address);
    } else {
        const Result<Value> value = parseValue(out.type, operand);
        if (!value)
            throw std::runtime_error(englishText(value.error()));
        out.kind = IrPin::Kind::Constant;
        out.constant = value->bits;
    }
    return out;
}

AxisConfiguration axisOf(std::uint8_t number, const char* name, bool rotary, double perTurn)
{
    AxisConfiguration axis;
    axis.number = number;
    axis.name = name;
    axis.rotary = rotary;
    axis.mechanicalEquivalent = perTurn;
    axis.inhibitTimeMs = 2;
    axis.lowerLimitSwitch = -5000;
    axis.upperLimitSwitch = 5000;
    axis.homeSwitch = 50;
    return axis;
}

} // namespace

KincoBench::KincoBench()
{
    const ControllerModel& model = *kincoFamily().findModel("KS101M-04DX");
    m_image.target = {"kinco", model.name, kincoFamily().catalogue().hash()};
    for (const MemoryArea& area : kincoFamily().areas()) {
        const AreaLayout& layout = model.area(area.id);
        m_image.layout.areas.push_back({area.id, area.name, layout.bytes, layout.retainedFirst, layout.retainedEnd});
    }
    m_image.configuration.watchdog = 500ms;
    m_image.configuration.network = {true, 1000000, 100};
    m_image.configuration.axes = {axisOf(1, "Feed", false, 100), axisOf(2, "Turn", true, 45)};
    m_image.program.routines.push_back({"Main", RoutineKind::Main, 0, {}});
    m_image.debug.projectName = "bench";
}

void KincoBench::call(std::string_view mnemonic, const std::vector<std::string>& operands, std::string_view enable)
{
    const ControllerModel& model = *kincoFamily().findModel("KS101M-04DX");
    const Instruction* const instruction = kincoFamily().catalogue().find(mnemonic);
    IrBlock block;
    block.instruction = static_cast<std::uint16_t>(instruction->id);
    block.instance = static_cast<std::uint32_t>(m_image.program.blocks.size());
    for (std::size_t i = 0; i < operands.size(); ++i)
        block.pins.push_back(pinOf(instruction->pins[i], operands[i], model));
    IrRoutine& main = m_image.program.routines.front();
    IrInstruction load;
    load.op = IrOp::Load;
    load.type = DataType::Bool;
    load.dest = main.registers++;
    load.address = irAddress(*kincoFamily().parseAddress(enable, model));
    IrInstruction run;
    run.op = IrOp::Block;
    run.a = load.dest;
    run.index = block.instance;
    main.code.push_back(load);
    main.code.push_back(run);
    m_image.program.blocks.push_back(std::move(block));
}

Bytes KincoBench::imageBytes() const
{
    ControllerImage image = m_image;
    IrInstruction end;
    end.op = IrOp::Return;
    image.program.routines.front().code.push_back(end);
    return write(image);
}

void KincoBench::start()
{
    const Result<void> loaded = m_engine.load(imageBytes());
    ASSERT_TRUE(loaded) << englishText(loaded.error());
    const Result<void> run = m_engine.apply(input::Run{});
    ASSERT_TRUE(run) << englishText(run.error());
    ASSERT_TRUE(stepUntil([this] { return m_engine.status().state == RunState::Run; }, 3s));
    step(2ms);
}

bool KincoBench::stepUntil(const std::function<bool()>& condition, Time limit)
{
    for (Time t{0}; t < limit; t += 1ms) {
        if (condition())
            return true;
        step(1ms);
    }
    return condition();
}

void KincoBench::set(std::string_view name, double value)
{
    const Result<ValueRef> ref = m_engine.resolve(name);
    ASSERT_TRUE(ref) << name;
    ASSERT_TRUE(m_engine.apply(input::Write{*ref, Value::ofLreal(value)})) << name;
}

double KincoBench::number(std::string_view name) const
{
    const Result<ValueRef> ref = m_engine.resolve(name);
    if (!ref) {
        ADD_FAILURE() << name << ": " << englishText(ref.error());
        return 0;
    }
    return m_engine.read(*ref)->asDouble();
}

void KincoBench::addHomingMethod()
{
    call("MC_WPARAS", {"%M500.0", "1", "%VB3000", "%VD3004", "1", "%M500.1", "%M500.2", "%MD504"});
}

void KincoBench::writeHomingMethod()
{
    set("%VB3000", 3);
    set("%VD3004", 19);
    setBit("%M500.0");
    ASSERT_TRUE(stepUntil([this] { return bit("%M500.1"); }, 1s));
    EXPECT_FALSE(bit("%M500.2"));
}

Result<void> KincoBench::panel(AxisCommandKind kind, double position, double velocity, std::uint16_t axis)
{
    return m_engine.apply(input::Panel{axis, kind, position, velocity, 0});
}

void KincoBench::beat()
{
    (void)m_engine.apply(input::Heartbeat{m_engine.cycle()});
}

void KincoBench::stepBeating(Time span)
{
    for (Time t{0}; t < span; t += 1ms) {
        if (t % 20ms == 0ms)
            beat();
        step(1ms);
    }
}

std::vector<LogEntry> KincoBench::logged(Code code) const
{
    std::vector<LogEntry> out;
    for (LogEntry& entry : m_engine.logSince(0)) {
        if (entry.message.code == code)
            out.push_back(std::move(entry));
    }
    return out;
}

} // namespace camwright
