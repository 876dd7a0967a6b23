// The umpire and balls that really fly: the physics makes the touches, the umpire reads them.
#include <gtest/gtest.h>

#include <random>

#include "flown_match.h"
#include "ping_pong_sim/shots.h"

namespace ping_pong::game
{
namespace
{
const Vector3d kAboveTable(0, 0, kTableHeight);

BallState shot(const std::string& name)
{
  const Shot& found = *findShot(name);
  return flying(found.p_TB + kAboveTable, found.v_TB, found.w_TB);
}

/// Seen from the other end.
BallState turned(const BallState& state)
{
  const Eigen::DiagonalMatrix<double, 3> half_turn(-1.0, -1.0, 1.0);
  return flying(half_turn * state.p_WB, half_turn * state.v_WB, half_turn * state.w_WB);
}

/// The serve of the launcher, by A from -x or by B from +x.
BallState serveBy(Player server)
{
  return server == Player::B ? shot("serve") : turned(shot("serve"));
}
std::string lettersOf(Player server)
{
  return server == Player::B ? "+-" : "-+";  // own court, then the other
}

class Flown : public ::testing::TestWithParam<Player>
{
protected:
  Player me = GetParam();
  std::string s() const { return name(GetParam()); }
  std::string r() const { return name(other(GetParam())); }
  /// Of a ball that comes from the server's end, as seen from there.
  BallState mine(const BallState& from_plus) const { return me == Player::B ? from_plus : turned(from_plus); }
};
INSTANTIATE_TEST_SUITE_P(FromBothSides, Flown, ::testing::Values(Player::A, Player::B),
                         [](const auto& info) { return name(info.param); });

TEST_P(Flown, AGoodServiceThatNobodyReturnsScores)
{
  FlownMatch match(me);
  match.serve(serveBy(me));
  match.flyUntil(Phase::InCourt);
  EXPECT_EQ(match.touches, lettersOf(me));
  EXPECT_EQ(match.umpire.phase(), Phase::InCourt) << match.said();
  match.fly();
  EXPECT_EQ(match.said(), "point 2.10.1.3 " + s());
}

TEST_P(Flown, ATossTooLowIsAFaultHoweverGoodTheServiceIs)
{
  FlownMatch match(me);
  match.serve(serveBy(me), 0.12);
  EXPECT_EQ(match.said(), "fault 2.6.2 " + r());
}

// Slower and slower serves: over the net, off its top, into it. At the top of the net some are lets.
TEST_P(Flown, ServicesLowerAndLowerAreGoodThenLetsThenFaults)
{
  std::string outcomes;
  for (int i = 0; i <= 60; ++i)
  {
    FlownMatch match(me);
    BallState served = shot("serve");
    served.v_WB.z() += 0.015 * i;  // a higher bounce on the own court is a later one, and meets the net lower
    served.v_WB.x() *= 1.0 - 0.004 * i;
    match.serve(mine(served));
    match.flyUntil(Phase::InCourt);
    const std::string said = match.said();
    outcomes += said.empty() ? 'g' : said[0];
    const bool let_due = match.touches.find('n') != std::string::npos && match.touches.back() == lettersOf(me)[1];
    EXPECT_EQ(said == "let 2.9.1.1", let_due) << match.touches << " " << said;
  }
  std::printf("[ outcomes ] %s\n", outcomes.c_str());
  EXPECT_NE(outcomes.find('g'), std::string::npos);
  EXPECT_NE(outcomes.find('l'), std::string::npos);
  EXPECT_NE(outcomes.find('f'), std::string::npos);
}

// What the launcher plays as returns lands; unanswered it scores.
TEST_P(Flown, TheNamedShotsAreGoodReturns)
{
  const Player server = other(me);
  for (const char* name : {"push", "drive", "loop", "smash", "lob"})
  {
    FlownMatch match(server);
    match.serve(serveBy(server));
    match.flyUntil(Phase::InCourt);
    match.strike(match.umpire.endOf(me), mine(shot(name)));
    match.fly();
    EXPECT_EQ(match.said(), "point 2.10.1.3 " + s()) << name << " " << match.touches;
    EXPECT_EQ(match.umpire.score().strokes, 2);
  }
}

/// A return by `me` from its end, flown until it is decided.
std::string returned(Player me, const BallState& struck, std::string* touches = nullptr)
{
  FlownMatch match(other(me));
  match.serve(serveBy(other(me)));
  match.flyUntil(Phase::InCourt);
  match.touches.clear();
  match.strike(match.umpire.endOf(me), struck);
  match.fly();
  if (touches) *touches = match.touches;
  return match.said();
}

TEST_P(Flown, ALongBallIsOutBeforeItTouchesTheFloor)
{
  std::string touches;
  EXPECT_EQ(returned(me, mine(flying({1.5, 0, 1.1}, {-16, 0, 2})), &touches), "point 2.10.1.4 " + r());
  EXPECT_EQ(touches, "");
}

TEST_P(Flown, ABallIntoTheNetIsLostOnTheOwnCourt)
{
  std::string touches;
  EXPECT_EQ(returned(me, mine(flying({0.8, 0, 0.86}, {-5, 0, 0.3})), &touches), "point 2.10.1.2 " + r());
  EXPECT_EQ(touches[0], 'n');
}

// A ball that comes down at the side line: on the top, on its edge, past it.
TEST_P(Flown, OntoTheEdgeIsInAndPastItIsOut)
{
  const auto downAt = [&](double beyond_line) {
    return returned(me, mine(flying({-0.7, 0.5 * kTableWidth + beyond_line, 1.2}, {0, 0, -1})));
  };
  EXPECT_EQ(downAt(-0.03), "point 2.10.1.3 " + s());
  EXPECT_EQ(downAt(0.005), "point 2.10.1.3 " + s());
  EXPECT_EQ(downAt(0.0195), "point 2.10.1.3 " + s());
  EXPECT_EQ(downAt(0.0205), "point 2.10.1.2 " + r());
}

// A flat ball at the side of the top: what counts is whether its centre is above the edge.
TEST_P(Flown, OntoTheSideIsOut)
{
  const auto flatAt = [&](double height) {
    return returned(me, mine(flying({-0.7, 0.5 * kTableWidth + 0.04, kTableHeight + height}, {0, -10, 0})));
  };
  EXPECT_EQ(flatAt(-0.01), "point 2.10.1.2 " + r());
  EXPECT_EQ(flatAt(-0.0005), "point 2.10.1.2 " + r());
  EXPECT_EQ(flatAt(+0.001), "point 2.10.1.3 " + s());
}

// What is decided follows from the order of touches alone, read here in another way.
TEST_P(Flown, RandomReturnsAreDecidedAsTheirTouchesSay)
{
  std::mt19937 random(24);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const char own = me == Player::B ? '+' : '-', their = me == Player::B ? '-' : '+';
  int good = 0, bad = 0, off_the_net = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3d p(1.3 + 0.6 * part(random), 0.9 * part(random), 1.0 + 0.2 * part(random));
    const Vector3d v(-5.0 + 3.0 * part(random), 1.0 * part(random), 1.5 + 1.5 * part(random));
    const Vector3d w(100 * part(random), 200 * part(random), 100 * part(random));
    std::string touches;
    const std::string said = returned(me, mine(flying(p, v, w)), &touches);
    const std::string first = touches.substr(std::min(touches.find_first_not_of('n'), touches.size()), 1);
    const bool in = first == std::string(1, their);
    (in ? good : bad) += 1;
    off_the_net += in && touches[0] == 'n';
    EXPECT_EQ(said.back(), (in ? s() : r())[0]) << touches << " " << said;
    EXPECT_EQ(said.substr(0, 14), in ? "point 2.10.1.3" : said.substr(0, 14)) << touches;
    if (!in && first == std::string(1, own))
    {
      EXPECT_EQ(said, "point 2.10.1.2 " + r()) << touches;
    }
  }
  std::printf("[ measured ] good %d, lost %d, good off the net %d\n", good, bad, off_the_net);
  EXPECT_GT(good, 25);
  EXPECT_GT(bad, 25);
}
}  // namespace
}  // namespace ping_pong::game
