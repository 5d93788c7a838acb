#include "core/model/objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace camwright;

namespace {

Variable variable(int number)
{
    Variable out;
    out.name = "V" + std::to_string(number);
    return out;
}

std::vector<Variable> variables(int count, int from = 0)
{
    std::vector<Variable> out;
    for (int n = 0; n < count; ++n)
        out.push_back(variable(from + n));
    return out;
}

TEST(VariableTableTest, replacingRowsIsReplacingInAList)
{
    std::mt19937 random(1);
    std::vector<Variable> list = variables(700);
    VariableTable table = VariableTable::of(list);
    for (int turn = 0; turn < 500; ++turn) {
        const std::size_t first = random() % (list.size() + 1);
        const std::size_t removed = std::min<std::size_t>(random() % 4 == 0 ? random() % 300 : random() % 2, list.size() - first);
        const auto inserted = variables(static_cast<int>(random() % 5 == 0 ? random() % 300 : random() % 2), 1000 + turn);
        table = table.replaced(first, removed, inserted);
        const auto at = list.erase(list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(first + removed));
        list.insert(at, inserted.begin(), inserted.end());
        ASSERT_EQ(table.rows(), list) << "turn " << turn;
        for (const auto& chunk : table.chunks)
            ASSERT_FALSE(chunk->empty());
    }
}

TEST(VariableTableTest, aChangedRowLeavesTheOtherChunksShared)
{
    const VariableTable before = VariableTable::of(variables(2000));
    const VariableTable after = before.replaced(1000, 1, {variable(-1)});
    std::size_t shared = 0;
    for (const auto& chunk : after.chunks)
        shared += static_cast<std::size_t>(std::count(before.chunks.begin(), before.chunks.end(), chunk));
    EXPECT_GE(shared + 2, before.chunks.size());
}

TEST(VariableTableTest, rowsAppendedOneByOneFillChunks)
{
    VariableTable table;
    for (int n = 0; n < 1000; ++n)
        table = table.replaced(table.rowCount(), 0, {variable(n)});
    EXPECT_LE(table.chunks.size(), 8u);
    EXPECT_EQ(table.row(999).name, "V999");
}

TEST(VariableTableTest, equalityDoesNotSeeTheChunks)
{
    const VariableTable one = VariableTable::of(variables(600));
    const VariableTable two = VariableTable::of(variables(300)).replaced(300, 0, variables(300, 300));
    EXPECT_EQ(one, two);
    EXPECT_FALSE(one == two.replaced(599, 1, {variable(0)}));
    EXPECT_FALSE(one == two.replaced(599, 1, {}));
}

} // namespace
