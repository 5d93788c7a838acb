#include "core/fieldbus/objectdictionary.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

ObjectInfo object(ObjectId id, DataType type, ObjectAccess access = ObjectAccess::ReadWrite)
{
    ObjectInfo info;
    info.id = id;
    info.type = type;
    info.access = access;
    return info;
}

class ObjectDictionaryTest : public testing::Test {
protected:
    ObjectDictionaryTest()
    {
        ObjectInfo ranged = object({0x6073, 0}, DataType::Uint);
        ranged.maximum = 2048;
        ObjectInfo name = object({0x1008, 0}, DataType::Byte, ObjectAccess::Constant);
        name.text = "A drive";
        dictionary.add(object({0x607A, 0}, DataType::Dint));
        dictionary.add(ranged);
        dictionary.add(object({0x6041, 0}, DataType::Uint, ObjectAccess::ReadOnly));
        dictionary.add(object({0x2000, 1}, DataType::Usint, ObjectAccess::WriteOnly));
        dictionary.add(object({0x6098, 0}, DataType::Sint));
        dictionary.add(name);
    }
    SdoAbort write(ObjectId id, Bytes data)
    {
        ObjectDictionary::Slot slot = ObjectDictionary::kNone;
        return dictionary.checkWrite(id, data, slot, value);
    }
    ObjectDictionary dictionary;
    std::int64_t value = 0;
};

} // namespace

TEST_F(ObjectDictionaryTest, findsObjectsAddedInAnyOrder)
{
    EXPECT_NE(dictionary.find({0x607A, 0}), ObjectDictionary::kNone);
    EXPECT_EQ(dictionary.find({0x607A, 1}), ObjectDictionary::kNone);
    EXPECT_TRUE(dictionary.hasIndex(0x2000));
    EXPECT_FALSE(dictionary.hasIndex(0x2001));
}
TEST_F(ObjectDictionaryTest, readsLittleEndianAndSigned)
{
    dictionary.setNumber({0x607A, 0}, -2);
    Bytes out;
    EXPECT_EQ(dictionary.read({0x607A, 0}, out), SdoAbort::None);
    EXPECT_EQ(out, (Bytes{0xFE, 0xFF, 0xFF, 0xFF}));
    EXPECT_EQ(write({0x607A, 0}, {0xFE, 0xFF, 0xFF, 0xFF}), SdoAbort::None);
    EXPECT_EQ(value, -2);
    EXPECT_EQ(write({0x6098, 0}, {0x80}), SdoAbort::None);
    EXPECT_EQ(value, -128);
}
TEST_F(ObjectDictionaryTest, readsTextWithoutItsEnd)
{
    Bytes out;
    EXPECT_EQ(dictionary.read({0x1008, 0}, out), SdoAbort::None);
    EXPECT_EQ(std::string(out.begin(), out.end()), "A drive");
}
TEST_F(ObjectDictionaryTest, saysWhyAnObjectIsMissing)
{
    Bytes out;
    EXPECT_EQ(dictionary.read({0x2000, 2}, out), SdoAbort::NoSuchSubindex);
    EXPECT_EQ(dictionary.read({0x3000, 0}, out), SdoAbort::NoSuchObject);
}
TEST_F(ObjectDictionaryTest, guardsAccess)
{
    Bytes out;
    EXPECT_EQ(dictionary.read({0x2000, 1}, out), SdoAbort::WriteOnly);
    EXPECT_EQ(write({0x6041, 0}, {0, 0}), SdoAbort::ReadOnly);
    EXPECT_EQ(write({0x1008, 0}, {0}), SdoAbort::ReadOnly);
}
TEST_F(ObjectDictionaryTest, checksLengthBeforeRange)
{
    EXPECT_EQ(write({0x6073, 0}, {0}), SdoAbort::TooShort);
    EXPECT_EQ(write({0x6073, 0}, {0, 0, 0}), SdoAbort::TooLong);
    EXPECT_EQ(write({0x6073, 0}, {0x01, 0x08}), SdoAbort::ValueTooHigh);
    EXPECT_EQ(write({0x6073, 0}, {0x00, 0x08}), SdoAbort::None);
}
TEST_F(ObjectDictionaryTest, restoresItsValues)
{
    dictionary.setNumber({0x607A, 0}, 77);
    ByteWriter writer;
    dictionary.save(writer);
    dictionary.setNumber({0x607A, 0}, 1);
    ByteReader reader(writer.bytes());
    dictionary.restore(reader);
    EXPECT_TRUE(reader.ok() && reader.atEnd());
    EXPECT_EQ(dictionary.number({0x607A, 0}), 77);
}
TEST_F(ObjectDictionaryTest, refusesValuesOfAnotherDictionary)
{
    ByteWriter writer;
    ObjectDictionary{}.save(writer);
    ByteReader reader(writer.bytes());
    dictionary.restore(reader);
    EXPECT_FALSE(reader.ok());
}
