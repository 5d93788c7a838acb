#include "devices/controller/controllease.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

TEST(ControlLeaseTest, oneClientHasItAndTheOtherIsRefused)
{
    ControlLease lease;
    EXPECT_TRUE(lease.take(1, "anna", 0ms));
    EXPECT_FALSE(lease.take(2, "bert", 1ms));
    EXPECT_EQ(lease.owner(), "anna");
    EXPECT_TRUE(lease.take(1, "anna", 2ms)) << "again is no harm";
}

TEST(ControlLeaseTest, itLapsesAfter500MsWithoutRenewal)
{
    ControlLease lease;
    lease.take(1, "anna", 0ms);
    EXPECT_FALSE(lease.lapse(499ms));
    EXPECT_TRUE(lease.renew(1, 499ms));
    EXPECT_FALSE(lease.lapse(998ms));
    EXPECT_EQ(lease.lapse(999ms), "anna");
    EXPECT_FALSE(lease.lapse(1000ms)) << "told once";
    EXPECT_FALSE(lease.renew(1, 1000ms)) << "a lapsed lease is not revived";
    EXPECT_TRUE(lease.take(2, "bert", 1000ms));
}

TEST(ControlLeaseTest, onlyItsHolderReleasesIt)
{
    ControlLease lease;
    lease.take(1, "anna", 0ms);
    lease.release(2);
    EXPECT_TRUE(lease.isHeldBy(1));
    lease.release(1);
    EXPECT_EQ(lease.holder(), 0u);
    EXPECT_FALSE(lease.isHeldBy(0));
}

} // namespace
