// Constraints in batches of four, and the numbers that are handled four at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "base/random.h"
#include "solver/contact_batches.h"

namespace ping_pong
{
namespace
{
std::vector<ConstraintBatch> placedIn(const std::vector<std::array<std::uint32_t, 2>>& constraints,
                                      std::set<std::uint32_t>& indices)
{
  std::vector<ConstraintBatch> batches;
  OpenBatches open;
  for (const auto& [a, b] : constraints)
  {
    const ConstraintIndex index = open.add(batches, a, b);
    EXPECT_TRUE(indices.insert(index.value).second) << "each constraint has a lane of its own";
    EXPECT_EQ(batches[index.batch()].a[index.lane()], a);
    EXPECT_EQ(batches[index.batch()].b[index.lane()], b);
  }
  return batches;
}

std::size_t constraintsIn(const ConstraintBatch& batch)
{
  std::size_t count = 0;
  for (std::size_t k = 0; k < kLanes; ++k) count += batch.has(k);
  return count;
}

TEST(Batches, NoBallIsTwiceInOne)
{
  std::vector<std::array<std::uint32_t, 2>> constraints;  // a cubic lattice, 12 wide
  for (std::uint32_t i = 0; i < 12 * 12 * 12; ++i)
    for (const std::uint32_t step : {1u, 12u, 144u})
      if (i / step % 12 != 11) constraints.push_back({i, i + step});
  std::set<std::uint32_t> indices;
  const std::vector<ConstraintBatch> batches = placedIn(constraints, indices);
  std::size_t found = 0;
  for (const ConstraintBatch& batch : batches)
  {
    std::set<std::uint32_t> balls;
    for (std::size_t k = 0; k < kLanes; ++k)
      if (batch.has(k)) balls.insert({batch.a[k], batch.b[k]});
    EXPECT_EQ(balls.size(), 2 * constraintsIn(batch));
    EXPECT_EQ(batch.full(), constraintsIn(batch) == kLanes);
    found += constraintsIn(batch);
  }
  EXPECT_EQ(found, constraints.size());
  std::printf("[ measured ] lanes in use: %.1f %%\n",
              100.0 * static_cast<double>(found) / static_cast<double>(kLanes * batches.size()));
  EXPECT_GE(found, 0.9 * static_cast<double>(kLanes * batches.size())) << "else little is gained by four at a time";
}

TEST(Batches, ConstraintsOfOneBallAreAllInDifferentOnes)
{
  std::vector<std::array<std::uint32_t, 2>> constraints;
  for (std::uint32_t k = 1; k <= 20; ++k) constraints.push_back({0, k});
  std::set<std::uint32_t> indices;
  EXPECT_EQ(placedIn(constraints, indices).size(), 20u);
}

TEST(Batches, ABallWithABodySharesNoneWithOthers)
{
  std::set<std::uint32_t> indices;
  const std::vector<ConstraintBatch> batches = placedIn({{0, ConstraintBatch::kBody},
                                                         {1, ConstraintBatch::kBody},
                                                         {2, ConstraintBatch::kBody},
                                                         {0, ConstraintBatch::kBody}},
                                                        indices);
  ASSERT_EQ(batches.size(), 2u);
  EXPECT_EQ(constraintsIn(batches[0]), 3u);
  EXPECT_EQ(constraintsIn(batches[1]), 1u);
  EXPECT_FALSE(batches[0].full());
}

TEST(Lanes, ComeToTheSameAsOneByOne)
{
  Random random(1, 0);
  const auto number = [&] { return static_cast<float>(random.uniform(-2.0, 2.0)); };
  std::array<Lanes, kLanes> records;
  for (Lanes& record : records) record = Lanes{number(), number(), number(), number()};
  Lanes last;
  const LaneVectors vectors = vectorsOf(records, last);
  const std::array<Lanes, kLanes> again = recordsOf(vectors, last);
  const LaneVectors other = vectorsOf({records[3], records[2], records[1], records[0]});
  const Lanes product = dot(vectors, other), root = squareRoot(product * product);
  const LaneVectors normal = cross(vectors, other);
  for (std::size_t k = 0; k < kLanes; ++k)
  {
    const Eigen::Vector3f a = vectors.at(k), b = other.at(k);
    for (std::size_t i = 0; i < kLanes; ++i) EXPECT_EQ(again[k][i], records[k][i]);
    EXPECT_EQ(a, Eigen::Vector3f(records[k][0], records[k][1], records[k][2]));
    EXPECT_EQ(last[k], records[k][3]);
    EXPECT_EQ(product[k], a.x() * b.x() + a.y() * b.y() + a.z() * b.z());
    EXPECT_EQ(root[k], std::sqrt(product[k] * product[k]));
    EXPECT_EQ(normal.at(k), a.cross(b));
  }
}

TEST(Lanes, WhatIsNoNumberGivesWay)
{
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(greater(Lanes{none, 1.0f, -1.0f, 0.0f}, Lanes{})[0], 0.0f);
  EXPECT_EQ(lesser(Lanes{none, 1.0f, -1.0f, 0.0f}, allLanes(0.5f))[0], 0.5f);
  EXPECT_TRUE(anyLane(Lanes{0.0f, 0.0f, 0.0f, 1.0f} > Lanes{}));
  EXPECT_FALSE(anyLane(Lanes{} > Lanes{}));
}
}  // namespace
}  // namespace ping_pong
