#include "core/online/messages.h"

#include <gtest/gtest.h>

#include <set>

using namespace camwright;

namespace {

template <std::size_t... I>
std::vector<message::Type> typesOfVariant(std::index_sequence<I...>)
{
    return {std::variant_alternative_t<I, Message>::type...};
}

TEST(MessagesTest, eachMessageHasItsRowInOrder)
{
    const auto types = typesOfVariant(std::make_index_sequence<std::variant_size_v<Message>>{});
    std::set<message::Type> numbers;
    std::set<std::string> names;
    for (std::size_t i = 0; i < types.size(); ++i) {
        const MessageRule& rule = messageRules()[i];
        EXPECT_EQ(rule.type, types[i]) << rule.name;
        EXPECT_TRUE(numbers.insert(rule.type).second) << rule.name;
        EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    }
}

TEST(MessagesTest, whatMovesOrChangesNeedsControlAndStopDoesNot)
{
    EXPECT_TRUE(ruleOf(message::Axis{}).needsControl);
    EXPECT_TRUE(ruleOf(message::Heartbeat{}).needsControl);
    EXPECT_TRUE(ruleOf(message::Write{}).needsControl);
    EXPECT_TRUE(ruleOf(message::Force{}).needsControl);
    EXPECT_TRUE(ruleOf(message::Run{}).needsControl);
    EXPECT_TRUE(ruleOf(message::BeginDownload{}).needsControl);
    EXPECT_FALSE(ruleOf(message::StopAll{}).needsControl);
    EXPECT_EQ(ruleOf(message::StopAll{}).role, Role::Nobody);
}

TEST(MessagesTest, stopAndHeartbeatOvertake)
{
    EXPECT_TRUE(ruleOf(message::StopAll{}).urgent);
    EXPECT_TRUE(ruleOf(message::Heartbeat{}).urgent);
    EXPECT_TRUE(ruleOf(message::RenewControl{}).urgent);
    EXPECT_FALSE(ruleOf(message::Piece{}).urgent);
}

} // namespace
