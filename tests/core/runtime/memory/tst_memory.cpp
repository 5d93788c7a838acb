#include "core/family/family.h"
#include "core/language/lowering/memorylayout.h"
#include "core/runtime/memory/memory.h"

#include <gtest/gtest.h>

#include <bit>

using namespace camwright;

namespace {

/// The memory of a real model, addressed as its users write it.
class ModelMemory {
public:
    ModelMemory(const char* family, const char* model)
        : m_family(*findFamily(family)), m_model(*m_family.findModel(model)), m_layout(memoryLayout(m_family, m_model, 0, 1)),
          memory(m_layout, 16)
    {
    }

    Address at(const char* text) const { return m_family.parseAddress(text, m_model).value(); }
    Address at(const char* text, DataType type) const { return m_family.withType(at(text), type, m_model).value(); }
    std::int64_t number(const char* text) const { return memory.read(at(text)).asInteger(); }
    std::int64_t number(const char* text, DataType type) const { return memory.read(at(text, type)).asInteger(); }
    void set(const char* text, std::int64_t value) { memory.write(at(text), Value::ofInteger(at(text).type, value)); }

private:
    const Family& m_family;
    const ControllerModel& m_model;

public:
    MemoryLayout m_layout;
    Memory memory;
};

// KS-MEM-01, KS-MEM-02
TEST(MemoryTest, kincoAreasOverlapByByteNumber)
{
    ModelMemory m("kinco", "KS101M-04DX");
    m.set("%VD0", 0x04030201);
    EXPECT_EQ(m.number("%VB0"), 1);
    EXPECT_EQ(m.number("%VW0"), 0x0201);
    EXPECT_EQ(m.number("%VW2"), 0x0403);
    EXPECT_EQ(m.number("%V3.2"), 1);
    EXPECT_EQ(m.number("%V3.0"), 0);
    m.set("%V3.0", 1);
    EXPECT_EQ(m.number("%VD0"), 0x05030201);
    m.memory.write(m.at("%VR100"), Value::ofReal(-1.0f));
    EXPECT_EQ(m.number("%VD100", DataType::Dword), 0xBF800000);
    EXPECT_EQ(m.number("%MD0"), 0) << "another area";
}

// KS-MEM-03: %VD6 and %MD14 occur in the manual.
TEST(MemoryTest, doubleWordsNeedNotBeAligned)
{
    ModelMemory m("kinco", "KS101M-04DX");
    m.set("%VD6", -2);
    EXPECT_EQ(m.number("%VD6"), -2);
    EXPECT_EQ(m.number("%VB6"), 0xFE);
    EXPECT_EQ(m.number("%VW8", DataType::Word), 0xFFFF);
}

// TS-MEM-05
TEST(MemoryTest, ts600DoubleWordsHaveTheLowWordFirst)
{
    ModelMemory m("invt", "TS635");
    m.memory.write(m.at("D100", DataType::Dint), Value::ofInteger(DataType::Dint, 0x12345678));
    EXPECT_EQ(m.number("D100"), 0x5678);
    EXPECT_EQ(m.number("D101"), 0x1234);
    m.memory.write(m.at("D101", DataType::Real), Value::ofReal(1.0f));
    EXPECT_EQ(m.number("D101"), 0);
    EXPECT_EQ(m.number("D102"), 0x3F80);
    EXPECT_EQ(m.number("R100"), 0);
}

// TS-MEM-06
TEST(MemoryTest, ts600WordsHaveBits)
{
    ModelMemory m("invt", "TS635");
    m.set("D5.0", 1);
    m.set("D5.15", 1);
    EXPECT_EQ(m.number("D5", DataType::Word), 0x8001);
    m.set("D5.0", 0);
    EXPECT_EQ(m.number("D5", DataType::Word), 0x8000);
}

// TS-MEM-01; CONTRACTS 8: bit elements are one byte each.
TEST(MemoryTest, ts600BitElementsAreBytes)
{
    ModelMemory m("invt", "TS635");
    m.set("X17", 1);
    EXPECT_EQ(m.memory.area(m.at("X0").area)[15], 1);
    EXPECT_EQ(m.number("X16"), 0);
    EXPECT_EQ(m.number("Y17"), 0);
    m.set("M32767", 1);
    EXPECT_EQ(m.memory.area(m.at("M0").area).back(), 1);
}

TEST(MemoryTest, nothingBeyondAnAreaIsReadOrWritten)
{
    ModelMemory m("kinco", "KS101M-04DX");
    Address last = m.at("%VB16383");
    EXPECT_TRUE(m.memory.contains(last));
    last.type = DataType::Int;
    EXPECT_FALSE(m.memory.contains(last));
    EXPECT_FALSE(m.memory.write(last, Value::ofInteger(DataType::Int, -1)));
    EXPECT_EQ(m.memory.read(last), (Value{DataType::Int, 0}));
    EXPECT_FALSE(m.memory.contains(valueAddress(99, 0, DataType::Byte)));
    EXPECT_FALSE(m.memory.contains(valueAddress(last.area, 0xFFFFFFFF, DataType::Lword)));
    EXPECT_TRUE(m.memory.area(99).empty());
}

TEST(MemoryTest, storesOneNaNOnly)
{
    ModelMemory m("kinco", "KS101M-04DX");
    m.memory.write(m.at("%VR0"), {DataType::Real, 0xFFC12345});
    EXPECT_EQ(m.number("%VD0", DataType::Dword), 0x7FC00000);
}

TEST(MemoryTest, powerOnWritesTheInitialValuesAndClearsTheRest)
{
    ModelMemory m("kinco", "KS101M-04DX");
    m.m_layout.initialValues = {{m.at("%VW10"), Value::ofInteger(DataType::Int, 77)}};
    m.set("%VW12", 5);
    m.memory.powerOn(m.m_layout);
    EXPECT_EQ(m.number("%VW10"), 77);
    EXPECT_EQ(m.number("%VW12"), 0);
}

TEST(MemoryTest, forcesAreWrittenTypedAndBitByBit)
{
    ModelMemory m("kinco", "KS101M-04DX");
    const Force forces[] = {{m.at("%M0.3"), Value::ofBool(true)}, {m.at("%VR4"), Value::ofReal(2.5f)}};
    applyForces(m.memory, forces);
    EXPECT_EQ(m.number("%MB0"), 8);
    EXPECT_EQ(m.memory.read(m.at("%VR4")).asDouble(), 2.5);
}

TEST(MemoryTest, savesAndRestoresEverythingAndNothingElse)
{
    ModelMemory m("kinco", "KS101M-04DX");
    m.set("%VD6", 123456);
    m.set("%M4095.7", 1);
    ByteWriter saved;
    m.memory.save(saved);
    ModelMemory other("kinco", "KS101M-04DX");
    ByteReader reader(saved.bytes());
    ASSERT_TRUE(other.memory.restore(reader));
    EXPECT_EQ(other.number("%VD6"), 123456);
    EXPECT_EQ(other.number("%M4095.7"), 1);
    ModelMemory smaller("kinco", "KS105-16DT");
    ByteReader again(saved.bytes());
    EXPECT_FALSE(smaller.memory.restore(again));
}

} // namespace
