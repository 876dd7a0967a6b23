// Balls that fly apart and meet in islands: nobody is overlooked, and the windows leave no trace in the result.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "detect/broad_phase.h"
#include "testing/overlaps.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double a, double b) { return a + (b - a) * static_cast<double>(engine_()) / 4294967296.0; }
  Vector3d vector(double a, double b)
  {
    const double x = in(a, b), y = in(a, b);
    return {x, y, in(a, b)};
  }

private:
  std::mt19937 engine_;
};

// Boxes of many sizes, some a kilometre and more away, some points, some twice at one place.
std::vector<CoarseBox> someBoxes(std::size_t count, unsigned seed)
{
  Random random(seed);
  std::vector<CoarseBox> boxes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double size = i % 7 == 0 ? 0.0 : i % 31 == 0 ? 3.0 : random.in(0.0, 0.2);
    Vector3d p = random.vector(-1.0, 1.0);
    if (i % 41 == 0) p *= 1e3;
    if (i % 97 == 0) p *= 1e6;
    Box box;
    box.low = p;
    box.high = p + Vector3d(size, random.in(0.0, size), size);
    boxes.emplace_back(box);
    if (i % 13 == 0) boxes.emplace_back(box);
  }
  return boxes;
}

// A gas: many cells, and few boxes that are longer than one.
std::vector<CoarseBox> evenBoxes(std::size_t count, unsigned seed)
{
  Random random(seed);
  const double spacing = 1.0 / std::cbrt(static_cast<double>(count));
  std::vector<CoarseBox> boxes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3d low = random.vector(0.0, 1.0);
    boxes.emplace_back(Box{low, low + random.vector(0.0, i % 20 == 0 ? 4.0 * spacing : spacing)});
  }
  return boxes;
}

// The grid rounds: what it takes for a pair has to be looked at.
void build(BroadPhase& broad_phase, const std::vector<CoarseBox>& boxes, Workers& workers)
{
  broad_phase.build(
      boxes.size(), [&](std::size_t i) { return boxes[i]; }, workers);
}

// Calls action(index, added).
template <class Action>
void eachOverlapping(const BroadPhase& broad_phase, const CoarseBox& box, const Action& action)
{
  std::vector<std::uint32_t> list;
  broad_phase.listOverlapping(box, list);
  for (const std::uint32_t entry : list) action(entry & ~BroadPhase::kAdded, (entry & BroadPhase::kAdded) != 0);
}

Pairs everyPair(const std::vector<CoarseBox>& boxes)
{
  Pairs pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a)
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
      if (boxes[a].overlaps(boxes[b])) pairs.insert({a, b});
  return pairs;
}

TEST(BroadPhase, FindsEveryPairOnceInSharesOfAnySize)
{
  for (const std::size_t threads : {1, 3})
  {
    Workers workers;
    workers.start(threads);
    BroadPhase broad_phase;
    for (const std::size_t count : {1, 2, 5, 40, 300, 2000, 2001})
    {
      const auto seed = static_cast<unsigned>(count);
      const std::vector<CoarseBox> boxes = count % 2 == 0 ? someBoxes(count, seed) : evenBoxes(count, seed);
      build(broad_phase, boxes, workers);
      const std::size_t share = 1 + broad_phase.boxes() / threads;
      Pairs pairs, told, deferred;
      for (std::size_t begin = 0; begin < broad_phase.boxes(); begin += share)
        broad_phase.eachPairs(
            begin, std::min(begin + share, broad_phase.boxes()),
            [&](std::uint32_t a, std::uint32_t b) { deferred.insert(std::minmax(a, b)); },
            [&](const BroadPhase::Pair* some, std::size_t how_many)
            {
              for (std::size_t p = 0; p < how_many; ++p)
              {
                const auto [a, b] = std::minmax(some[p][0], some[p][1]);
                EXPECT_TRUE(deferred.count({a, b})) << "not announced";
                EXPECT_TRUE(told.insert({a, b}).second) << "told twice";
                if (boxes[a].overlaps(boxes[b])) pairs.insert({a, b});
              }
            });
      EXPECT_EQ(pairs, everyPair(boxes)) << count;
    }
  }
}

Pairs pairsFound(const BroadPhase& broad_phase, const std::vector<CoarseBox>& boxes)
{
  Pairs pairs;
  broad_phase.eachPair(
      [&](std::uint32_t a, std::uint32_t b)
      {
        if (boxes[a].overlaps(boxes[b]))
        {
          EXPECT_TRUE(pairs.insert(std::minmax(a, b)).second) << "told twice";
        }
      });
  return pairs;
}

// Several workers begin with the order of the time before; in between everything may be elsewhere, or of another number.
TEST(BroadPhase, FindsEveryPairWhereverBoxesWereBefore)
{
  for (const std::size_t threads : {2, 5})
  {
    Workers workers;
    workers.start(threads);
    BroadPhase broad_phase;
    for (const std::size_t count : {3000, 3000, 3000, 1700, 1700})
      for (unsigned seed = 0; seed < 3; ++seed)
      {
        std::vector<CoarseBox> boxes = seed == 2 ? someBoxes(count, seed) : evenBoxes(count, seed);
        for (std::size_t i = 0; i < boxes.size(); i += 11) boxes[i] = CoarseBox();
        build(broad_phase, boxes, workers);
        EXPECT_EQ(pairsFound(broad_phase, boxes), everyPair(boxes)) << count << ", " << seed;
        EXPECT_EQ(broad_phase.boxes(), boxes.size() - (boxes.size() + 10) / 11);
      }
  }
}

// A gas: rounding to small parts of a cell adds little to what overlaps.
TEST(BroadPhase, HardlyTakesOthersForPairs)
{
  Random random(6);
  std::vector<CoarseBox> boxes;
  for (int i = 0; i < 3000; ++i)
  {
    const Vector3d low = random.vector(0.0, 1.0);
    boxes.emplace_back(Box{low, low + random.vector(0.03, 0.08)});
  }
  Workers alone;
  BroadPhase broad_phase;
  build(broad_phase, boxes, alone);
  std::size_t told = 0;
  broad_phase.eachPair([&](std::uint32_t, std::uint32_t) { ++told; });
  const std::size_t pairs = everyPair(boxes).size();
  measured("pairs told, by pairs that overlap", static_cast<double>(told) / static_cast<double>(pairs));
  EXPECT_LT(told, pairs + pairs / 10);
}

TEST(BroadPhase, LeavesOutEmptyBoxes)
{
  std::vector<CoarseBox> boxes = someBoxes(100, 7);
  for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = CoarseBox();
  Workers alone;
  BroadPhase broad_phase;
  build(broad_phase, boxes, alone);
  EXPECT_EQ(broad_phase.boxes(), static_cast<std::size_t>(std::count_if(
                                     boxes.begin(), boxes.end(), [](const CoarseBox& box) { return !box.empty(); })));
  build(broad_phase, std::vector<CoarseBox>(5), alone);
  EXPECT_EQ(broad_phase.boxes(), 0u);
}

TEST(CoarseBox, IsNeverSmallerAndHardlyLarger)
{
  Random random(9);
  for (int i = 0; i < 10000; ++i)
  {
    const double scale = std::pow(10.0, random.in(-6.0, 6.0));
    Box box;
    box.low = random.vector(-scale, scale);
    box.high = box.low + random.vector(0.0, scale);
    const CoarseBox coarse(box);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(static_cast<double>(coarse.low[axis]), box.low[axis]);
      EXPECT_GE(static_cast<double>(coarse.high[axis]), box.high[axis]);
      EXPECT_GE(static_cast<double>(coarse.low[axis]), box.low[axis] - 1e-6 * scale);
      EXPECT_LE(static_cast<double>(coarse.high[axis]), box.high[axis] + 1e-6 * scale);
    }
  }
}

std::set<std::uint32_t> addedNear(const BroadPhase& broad_phase, const CoarseBox& box)
{
  std::set<std::uint32_t> told;
  eachOverlapping(broad_phase, box,
                  [&](std::uint32_t i, bool added)
                  {
                    if (!added) return;
                    EXPECT_TRUE(told.insert(i).second) << "told twice";
                  });
  return told;
}

struct ListOfAdditions
{
  BroadPhase::Additions additions;
};

void add(BroadPhase& broad_phase, const std::vector<CoarseBox>& boxes, Workers& workers)
{
  std::vector<ListOfAdditions> lists(2);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) broad_phase.deferInsertion(i, boxes[i], lists[i % 2].additions);
  broad_phase.add(lists, &ListOfAdditions::additions, workers);
}

void expectToFindAdded(Workers& workers)
{
  BroadPhase broad_phase;
  const std::vector<CoarseBox> boxes = someBoxes(2500, 3), later = someBoxes(400, 8), asked = someBoxes(300, 4);
  build(broad_phase, boxes, workers);
  add(broad_phase, later, workers);
  std::size_t overlapping = 0;
  for (const CoarseBox& box : asked)
  {
    const std::set<std::uint32_t> told = addedNear(broad_phase, box);
    for (std::uint32_t i = 0; i < later.size(); ++i)
    {
      if (!later[i].overlaps(box)) continue;
      ++overlapping;
      EXPECT_TRUE(told.count(i)) << i;
    }
  }
  EXPECT_GT(overlapping, 500u);
  build(broad_phase, boxes, workers);
  for (const CoarseBox& box : asked) EXPECT_TRUE(addedNear(broad_phase, box).empty());
}

TEST(BroadPhase, FindsBoxesThatWereAddedLater)
{
  for (const std::size_t threads : {1, 4})
  {
    Workers workers;
    workers.start(threads);
    expectToFindAdded(workers);
  }
}

TEST(BroadPhase, LooksAtFewOfManyAddedBoxes)
{
  Random random(5);
  std::vector<CoarseBox> boxes;
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3d low = random.vector(0.0, 1.0);
    boxes.emplace_back(Box{low, low.array() + 0.05});
  }
  Workers alone;
  BroadPhase broad_phase;
  build(broad_phase, boxes, alone);
  add(broad_phase, boxes, alone);
  std::size_t looked_at = 0;
  for (const CoarseBox& box : boxes)
    eachOverlapping(broad_phase, box, [&](std::uint32_t, bool added) { looked_at += added; });
  measured("added boxes looked at, of 5000", static_cast<double>(looked_at) / 5000.0);
  EXPECT_LT(looked_at / 5000, 250u);
}

TEST(BroadPhase, FindsWhoOverlapsABoxThatWasNotThere)
{
  Workers alone;
  BroadPhase broad_phase;
  for (const std::vector<CoarseBox>& boxes : {someBoxes(500, 3), evenBoxes(2000, 3)})
  {
    build(broad_phase, boxes, alone);
    std::vector<CoarseBox> asked = someBoxes(200, 4);
    const std::vector<CoarseBox> even = evenBoxes(2000, 4);
    asked.insert(asked.end(), even.begin(), even.begin() + 200);
    for (const CoarseBox& box : asked)
    {
      std::set<std::uint32_t> told, found, expected;
      eachOverlapping(broad_phase, box,
                      [&](std::uint32_t i, bool added)
                      {
                        EXPECT_FALSE(added);
                        EXPECT_TRUE(told.insert(i).second) << "told twice";
                        if (boxes[i].overlaps(box)) found.insert(i);
                      });
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].overlaps(box)) expected.insert(i);
      EXPECT_EQ(found, expected);
    }
  }
}

// --- a gas against a list of events that anybody would write ---

struct Particle
{
  Vector3d p, v;
};

// Elastic balls of equal mass in a cube, nothing else: all pairs, all walls, again after every event.
class Gas
{
public:
  Gas(std::vector<Particle> particles, double half, double radius)
      : particles_(std::move(particles)), half_(half), radius_(radius)
  {
  }

  int run(double duration)
  {
    int hits = 0;
    for (double left = duration; left > 0.0;)
    {
      double nextEvent = left;
      std::size_t first = 0, second = 0;
      int wall = -1;
      for (std::size_t i = 0; i < particles_.size(); ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
          if (const double t = wallTime(particles_[i], axis); t < nextEvent) nextEvent = t, first = i, wall = axis;
        for (std::size_t k = i + 1; k < particles_.size(); ++k)
          if (const double t = pairTime(particles_[i], particles_[k]); t < nextEvent)
            nextEvent = t, first = i, second = k, wall = -1;
      }
      for (Particle& particle : particles_) particle.p += nextEvent * particle.v;
      left -= nextEvent;
      if (left <= 0.0) break;
      ++hits;
      if (wall >= 0)
        particles_[first].v[wall] *= -1.0;
      else
        exchange(particles_[first], particles_[second]);
    }
    return hits;
  }

  const std::vector<Particle>& particles() const { return particles_; }

private:
  double wallTime(const Particle& a, int axis) const
  {
    const double room = half_ - radius_;
    if (a.v[axis] > 0.0) return (room - a.p[axis]) / a.v[axis];
    return a.v[axis] < 0.0 ? (-room - a.p[axis]) / a.v[axis] : 1e300;
  }

  double pairTime(const Particle& a, const Particle& b) const
  {
    const Vector3d d = a.p - b.p, u = a.v - b.v;
    const double closing = d.dot(u), reach = 2.0 * radius_;
    const double root = closing * closing - u.squaredNorm() * (d.squaredNorm() - reach * reach);
    return closing < 0.0 && root >= 0.0 ? (d.squaredNorm() - reach * reach) / (std::sqrt(root) - closing) : 1e300;
  }

  static void exchange(Particle& a, Particle& b)
  {
    const Vector3d n = (a.p - b.p).normalized();
    const Vector3d along = n.dot(a.v - b.v) * n;
    a.v -= along;
    b.v += along;
  }

  std::vector<Particle> particles_;
  double half_, radius_;
};

std::vector<Particle> cloud(int per_edge, double spacing, unsigned seed)
{
  Random random(seed);
  std::vector<Particle> particles;
  for (int i = 0; i < per_edge * per_edge * per_edge; ++i)
  {
    const Vector3d place(i % per_edge, i / per_edge % per_edge, i / per_edge / per_edge);
    particles.push_back({spacing * (place - Vector3d::Constant(0.5 * (per_edge - 1))), random.vector(-2.0, 2.0)});
  }
  return particles;
}

SceneBuilder room(const std::vector<Particle>& particles, double half)
{
  SceneBuilder builder;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      builder.box("wall" + std::to_string(axis) + (side > 0.0 ? "+" : "-"),
                  Vector3d::Constant(4.0 * half) - (4.0 * half - 0.2) * Vector3d::Unit(axis),
                  at((half + 0.1) * side * Vector3d::Unit(axis)));
  for (const Particle& particle : particles) builder.ball(particle.p, particle.v);
  return builder;
}

std::vector<Vector3d> positions(const World& world)
{
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < world.ballCount(); ++i) all.push_back(positionOf(world, i));
  return all;
}

TEST(Islands, AGasGoesAsTheListOfAllEvents)
{
  constexpr double kHalf = 0.3, kDuration = 0.25;
  const std::vector<Particle> start = cloud(5, 0.1, 1);
  Gas gas(start, kHalf, kR);
  const int expected = gas.run(kDuration);
  for (const double tick : {kDuration, kDuration / 60.0})
  {
    World world = room(start, kHalf).world();
    const std::size_t hits = run(world, tick, static_cast<int>(std::lround(kDuration / tick))).size();
    double worst = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i)
      worst = std::max(worst, (positionOf(world, i) - gas.particles()[i].p).norm());
    measured("gas of 125: hits", static_cast<double>(hits));
    measured("worst difference of a position from the list of all events [m]", worst);
    EXPECT_EQ(hits, static_cast<std::size_t>(expected));
    EXPECT_GT(hits, 250u);
    EXPECT_LE(worst,
              1e-9);  // a few hits a ball, each of which makes 1e-16 m larger by the path over the radius, about 10
  }
}

// Chaos makes any difference large: the same bits mean the same events, found at the same instants.
TEST(Islands, TheSameBitsInWindowsOfAnyLength)
{
  for (const bool air : {false, true})
  {
    Scene scene = room(cloud(4, 0.12, 2), 0.3).gravity(kG).restitution(0.9).build();
    scene.forces.drag = scene.forces.magnus = air;
    std::vector<Vector3d> first;
    for (const int ticks : {1, 7, 500, 4000})
    {
      World world(scene);
      std::size_t hits = 0;
      // Ticks of 2^-n s: their ends are the same numbers.
      for (int i = 0; i < ticks; ++i)
      {
        const double end = std::ldexp(std::floor(std::ldexp((i + 1.0) / ticks, 20)), -20);
        hits += world.advance(end - world.time()).contacts;
      }
      EXPECT_GT(hits, 200u);
      const std::vector<Vector3d> now = positions(world);
      if (first.empty()) first = now;
      EXPECT_EQ(now, first) << ticks << " ticks, air: " << air;
    }
  }
}

// In short ticks one looks ahead; what somebody changes in between may not be overlooked.
class Meddler
{
public:
  explicit Meddler(World& world) : world_(world) {}

  // Every call does something else, to others.
  void meddle()
  {
    const BallId id = world_.ballId(static_cast<std::size_t>(7 * calls_) % world_.ballCount());
    BallState state = world_.ballState(world_.findBall(id));
    state.v_WB = -2.0 * state.v_WB;
    switch (calls_++ % 4)
    {
      case 0:
        EXPECT_TRUE(world_.setBallState(id, state).reason.empty());
        break;
      case 1:
        EXPECT_TRUE(world_.deleteBall(id).reason.empty());
        EXPECT_TRUE(world_.spawnBall(BallParams(), state).reason.empty());
        break;
      case 2:
        EXPECT_TRUE(world_.setBodyPose(0, at(world_.bodyPose(0).p - Vector3d(0.05, 0, 0))).reason.empty());
        break;
      default:
        EXPECT_TRUE(world_.setBodyPose(0, at(world_.bodyPose(0).p + Vector3d(0.05, 0, 0))).reason.empty());
    }
  }

private:
  World& world_;
  int calls_ = 0;
};

TEST(Islands, ShortTicksOverlookNothingThatIsChangedInBetween)
{
  std::vector<Vector3d> first;
  for (const int ticks : {1, 64})
  {
    World world = room(cloud(6, 0.09, 5), 0.3).gravity(kG).world();
    Meddler meddler(world);
    std::size_t hits = 0;
    for (int i = 0; i < 24; ++i)
    {
      for (int k = 0; k < ticks; ++k) hits += world.advance(std::ldexp(1.0, -5) / ticks).contacts;
      EXPECT_LE(deepestPair(world), 1e-12);
      meddler.meddle();
    }
    EXPECT_GT(hits, 2000u);
    const std::vector<Vector3d> now = positions(world);
    if (first.empty()) first = now;
    EXPECT_EQ(now, first) << ticks << " ticks";
  }
}

// Far from each other balls leave the place where the grid has them before they meet.
TEST(Islands, TheSameBitsInShortTicksOfADiluteGas)
{
  std::vector<Vector3d> first;
  for (const int ticks : {1024, 65536})
  {
    World world = room(cloud(8, 0.25, 6), 1.0).world();
    std::size_t hits = 0;
    for (int i = 0; i < ticks; ++i) hits += world.advance(64.0 / ticks).contacts;
    EXPECT_GT(hits, 5000u);
    const std::vector<Vector3d> now = positions(world);
    if (first.empty()) first = now;
    EXPECT_EQ(now, first) << ticks << " ticks";
  }
}

// In air a ball that has left a path is thought to meet whoever was near: who has not has to be looked for again.
TEST(Islands, TheSameBitsInShortTicksInAir)
{
  Scene scene = room(cloud(7, 0.2, 9), 0.75).build();
  scene.forces.drag = true;
  std::vector<Vector3d> first;
  for (const int ticks : {16, 1024, 4096})
  {
    World world(scene);
    std::size_t hits = 0;
    for (int i = 0; i < ticks; ++i) hits += world.advance(16.0 / ticks).contacts;
    EXPECT_GT(hits, 1000u);
    EXPECT_LE(deepestPair(world), 1e-9);
    const std::vector<Vector3d> now = positions(world);
    if (first.empty()) first = now;
    EXPECT_EQ(now, first) << ticks << " ticks";
  }
}

TEST(Islands, ContactsAreReportedOnceAndInOrder)
{
  World world = room(cloud(6, 0.09, 3), 0.3).gravity(kG).world();
  for (int i = 0; i < 20; ++i)
  {
    const StepStatus status = world.advance(0.02);
    EXPECT_EQ(status.contacts, world.contacts().size());
    double before = world.time() - 0.02 - 1e-12;
    for (const Contact& contact : world.contacts())
    {
      EXPECT_GE(contact.time, before);
      before = contact.time;
    }
  }
}

TEST(Islands, NoOverlapAndNoLossOfEnergyInACrowd)
{
  World world = room(cloud(8, 0.07, 4), 0.4).gravity(kG).world();
  const double energy = world.totals().energy();
  double deepest = 0.0;
  std::size_t hits = 0;
  for (int i = 0; i < 50; ++i)
  {
    hits += world.advance(0.01).contacts;
    deepest = std::max(deepest, deepestPair(world));
  }
  measured("crowd of 512: hits", static_cast<double>(hits));
  measured("deepest overlap of two balls at the ends of ticks [m]", deepest);
  measured("relative change of energy", world.totals().energy() / energy - 1.0);
  EXPECT_GT(hits, 5000u);
  EXPECT_LE(deepest, 1e-12);
  EXPECT_NEAR(world.totals().energy() / energy, 1.0, 1e-12);
}

// A tick as long as one window and not quite a half of the shortest can not be divided, however many meet in it.
TEST(Islands, ATickHardlyLongerThanTheShortestWindowEnds)
{
  constexpr std::size_t kBalls = 24;
  constexpr double kGap = 1e-6;  // [m]
  SceneBuilder builder;
  builder.restitution(1.0).ball({-0.04 - kGap, 0, 0}, {1, 0, 0});
  for (std::size_t i = 1; i < kBalls; ++i) builder.ball({static_cast<double>(i - 1) * (0.04 + kGap), 0, 0});
  World world(builder.build());
  const StepStatus status = world.advance(1.2e-4);
  EXPECT_EQ(status.contacts, kBalls - 1);
  EXPECT_NEAR(world.ballState(kBalls - 1).v_WB.x(), 1.0, 1e-12);
}
}  // namespace
}  // namespace ping_pong
