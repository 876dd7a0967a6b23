// A scene pays only for what it names: how often each force, contact law and search is evaluated, counted in the code.
//
// Each case is a scene and the laws that it names; all others must not have been evaluated once, and these must have
// been.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "base/law_counter.h"
#include "evolve/flight.h"
#include "ping_pong_sim/choose_method.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
using Laws = std::set<std::string>;

const char* const kNames[] = {"flight model",
                              "constant acceleration",
                              "drag",
                              "drag table",
                              "lift",
                              "lift table",
                              "spin ratio",
                              "spin decay",
                              "collocation of degree 5",
                              "collocation of degree 7",
                              "collocation of degree 9",
                              "orientation",
                              "restitution",
                              "slip",
                              "friction",
                              "tangential restitution",
                              "rolling resistance",
                              "spin friction",
                              "box",
                              "cylinder",
                              "sphere",
                              "half-space",
                              "moving body",
                              "broad phase",
                              "pair",
                              "paddle motion"};
static_assert(std::size(kNames) == static_cast<std::size_t>(Law::Count), "one name for each law, in their order");

long evaluationsOf(Law law)
{
  return evaluations[static_cast<std::size_t>(law)];
}

Laws evaluated()
{
  Laws laws;
  for (std::size_t i = 0; i < evaluations.size(); ++i)
    if (evaluations[i] > 0) laws.insert(kNames[i]);
  return laws;
}

struct Case
{
  const char* title;
  std::function<Scene()> scene;
  Laws every{};           ///< evaluated by every method
  Laws exact{};           ///< and by `exact`
  Laws located{};         ///< and by those that locate contacts
  Laws sampled{};         ///< and by those that do not
  double duration = 1.0;  ///< [s]
  Laws impulse{};         ///< evaluated by `impulse`, beside those of methods that locate contacts
};

// What is evaluated from the first tick to the last, states asked for included.
Laws lawsOf(const Case& what, Method method)
{
  Scene scene = what.scene();
  scene.method = method;
  World world(scene);
  if (world.bodyCount() > 0) world.command(world.bodyCount() - 1, velocityCommand({0.1, 0, 0}, {0, 0, 0.5}));
  evaluations.fill(0);
  for (int i = 0; i < 100; ++i) world.advance(0.01 * what.duration);
  for (std::size_t i = 0; i < world.ballCount(); ++i) world.ballState(i);
  return evaluated();
}

// A ball without spin over a smooth floor: three bounces in a second.
SceneBuilder smooth()
{
  SceneBuilder builder;
  builder.gravity(kG).floor().restitution(0.8).ball({0, 0, 0.3}, {0.5, 0, 0});
  return builder;
}

Scene spinning(Scene scene)
{
  scene.balls.front().state.w_WB = {3, 40, 5};
  return scene;
}

// Changes the forces of a ball over the smooth floor.
std::function<Scene()> with(const std::function<void(Forces&)>& change, bool spins = true)
{
  return [=]
  {
    Scene scene = spins ? spinning(smooth().build()) : smooth().build();
    change(scene.forces);
    return scene;
  };
}

// Changes the contact law of a ball and the floor. Low and lossy: it comes to rest.
std::function<Scene()> on(const std::function<void(Surface&)>& change)
{
  return [=]
  {
    Scene scene = spinning(smooth().build());
    scene.balls.front().state.p_WB.z() = 0.03;
    Surface law;
    law.restitution = 0.3;
    change(law);
    scene.surfaces.set(0, 1, law);
    return scene;
  };
}

std::function<Scene()> near(const std::function<void(SceneBuilder&)>& change)
{
  return [=]
  {
    SceneBuilder builder = smooth();
    change(builder);
    return builder.build();
  };
}

void constantDrag(Forces& forces)
{
  forces.drag = true;
  forces.drag_law = DragLaw::constant(0.5);
}

void dragTable(Forces& forces, std::vector<double> spin_ratios)
{
  forces.drag = true;
  forces.drag_law.reynolds = {1e3, 1e5};
  forces.drag_law.values = {0.4, 0.5, 0.45, 0.55};
  forces.drag_law.values.resize(2 * spin_ratios.size());
  forces.drag_law.spin_ratio = std::move(spin_ratios);
}

void lift(Forces& forces, LiftLaw::Kind kind)
{
  forces.magnus = true;
  forces.lift_law.kind = kind;
  forces.lift_law.spin_ratio = {0.5, 1.0};
  forces.lift_law.values = {0.2, 0.25};
}

// A law that names one thing more than the one before it.
void grippy(Surface& law)
{
  law.friction = 0.2;
}
void springy(Surface& law)
{
  grippy(law);
  law.tangential_restitution = 0.3;
}
void rolls(Surface& law)
{
  grippy(law);
  law.rolling_resistance = 0.05;
}
void twists(Surface& law)
{
  grippy(law);
  law.spin_friction = 0.05;
}

const Laws kVacuum = {"constant acceleration", "restitution", "half-space"};
const Laws kAir = {"drag", "restitution", "half-space"};

Laws operator+(Laws laws, const Laws& more)
{
  laws.insert(more.begin(), more.end());
  return laws;
}

const Laws kPieces = {"collocation of degree " + std::to_string(pieceDegree(Scene().tolerance))};
const Laws kTurns = {"orientation"};
const Laws kRubs = {"slip", "friction", "orientation"};

const Case kCases[] = {
    {"gravity and a smooth floor", [] { return smooth().build(); }, kVacuum},
    {"a ball that spins on nothing", [] { return spinning(smooth().build()); }, kVacuum + kTurns},
    {"buoyancy, added mass and a wind that nothing feels",
     with(
         [](Forces& f)
         {
           f.buoyancy = f.added_mass = true;
           f.wind = {1, 0, 0};
         },
         false),
     kVacuum},
    {"spin decay", with([](Forces& f) { f.spin_decay = 0.2; }), kVacuum + kTurns + Laws{"spin decay"}},
    {"drag", with(constantDrag, false), kAir, kPieces},
    {"drag that depends on spin", with([](Forces& f) { f.drag = true; }, false), kAir + Laws{"spin ratio"}, kPieces},
    {"a table of drag by Reynolds number", with([](Forces& f) { dragTable(f, {0.1}); }, false),
     kAir + Laws{"drag table"}, kPieces},
    {"a table of drag by Reynolds number and spin",
     with(
         [](Forces& f) {
           dragTable(f, {0.1, 0.2});
         },
         false),
     kAir + Laws{"drag table", "spin ratio"}, kPieces},
    {"linear lift", with([](Forces& f) { lift(f, LiftLaw::Kind::Linear); }),
     Laws{"lift", "restitution", "half-space"} + kTurns, kPieces},
    {"saturating lift", with([](Forces& f) { lift(f, LiftLaw::Kind::Saturating); }),
     Laws{"lift", "spin ratio", "restitution", "half-space"} + kTurns, kPieces},
    {"a table of lift", with([](Forces& f) { lift(f, LiftLaw::Kind::Table); }),
     Laws{"lift", "lift table", "spin ratio", "restitution", "half-space"} + kTurns, kPieces},
    {"friction", on(grippy), kVacuum + kRubs},
    {"tangential restitution", on(springy), kVacuum + kRubs + Laws{"tangential restitution"}},
    {"rolling resistance", on(rolls), kVacuum + kRubs, {}, {"rolling resistance"}},
    {"spin friction", on(twists), kVacuum + kRubs, {}, {"spin friction"}},
    {"a box out of the way",
     near(
         [](SceneBuilder& b) {
           b.box("box", {1, 1, 1}, at({0, 9, 0}));
         }),
     kVacuum,
     {},
     {},
     Laws{"box"}},
    {"a box below the floor, where only a path without bounces would go",
     near(
         [](SceneBuilder& b) {
           b.box("box", {1, 1, 1}, at({0, 0, -0.501}));
         }),
     kVacuum,
     {},
     {},
     Laws{"box"},
     1.0,
     Laws{"box"}},
    {"a cylinder and a sphere below the floor",
     near(
         [](SceneBuilder& b)
         {
           b.body("can", BodyKind::Static, {cylinderShape(2, 0.1)}, at({0, 0, -0.051}));
           b.body("globe", BodyKind::Static, {sphereShape(5)}, at({0, 0, -5.001}));
         }),
     kVacuum,
     {},
     {},
     Laws{"cylinder", "sphere"},
     1.0,
     Laws{"cylinder", "sphere"}},
    {"a paddle that moves",
     near(
         [](SceneBuilder& b) {
           b.paddle("paddle", boxShape({0.1, 0.1, 0.1}), at({0, 9, 1}));
         }),
     kVacuum + Laws{"box", "moving body", "paddle motion"}},
    {"a second ball far away",
     near(
         [](SceneBuilder& b) {
           b.ball({0, 9, 0.3});
         }),
     kVacuum,
     {},
     {"broad phase"},
     {"pair"}},
    {"a second ball in the way",
     near(
         [](SceneBuilder& b) {
           b.ball({0.1, 0, 0.3});
         }),
     kVacuum + Laws{"pair"},
     {},
     {"broad phase"}},
};

class PayForWhatYouName : public testing::TestWithParam<Case>
{
};

void PrintTo(const Case& what, std::ostream* out)
{
  *out << what.title;
}

INSTANTIATE_TEST_SUITE_P(Scenes, PayForWhatYouName, testing::ValuesIn(kCases),
                         [](const auto& info)
                         {
                           std::string title = info.param.title;
                           for (char& letter : title)
                             if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
                           return title;
                         });

TEST_P(PayForWhatYouName, AndForNothingElse)
{
  const Case& what = GetParam();
  for (const Method method : kMethods)
  {
    Laws expected = what.every;
    if (method == Method::Exact) expected = expected + what.exact;
    expected = expected + (locatesContacts(method) ? what.located : what.sampled);
    if (method == Method::Impulse) expected = expected + what.impulse;
    if (method == Method::Impulse)
      expected.erase("constant acceleration");  // worked out when a ball comes into the solver
    if (method == Method::Impulse && std::string(what.title) == "a paddle that moves")
      for (const char* law : {"box", "moving body"}) expected.erase(law);  // out of reach, it is not looked at
    EXPECT_EQ(lawsOf(what, method), expected) << name(method);
  }
}

// Not even a flight: it was worked out when the world was made.
TEST(PayForWhatYouNameHow, ASceneThatNamesNothingIsFree)
{
  const Case nothing{"nothing", [] { return SceneBuilder().ball({0, 0, 1}, {1, 2, 3}).build(); }};
  for (const Method method : kMethods)
    EXPECT_EQ(lawsOf(nothing, method),
              method == Method::Exact || method == Method::Impulse ? Laws{} : Laws{"constant acceleration"})
        << name(method);
}

TEST(PayForWhatYouNameHow, AForceModelIsSetUpOncePerTypeOfBall)
{
  Scene scene = SceneBuilder().ball({0, 0, 1}).ball({0, 1, 1}).ball({0, 2, 1}).build();
  scene.balls.back().params.mass *= 2.0;
  evaluations.fill(0);
  World world(scene);
  EXPECT_EQ(evaluationsOf(Law::FlightModel), 2);
}

TEST(PayForWhatYouNameHow, TheToleranceSetsTheDegree)
{
  const std::pair<double, Law> degrees[] = {
      {1e-3, Law::Collocation5}, {1e-7, Law::Collocation7}, {1e-11, Law::Collocation9}};
  for (const auto& [tolerance, used] : degrees)
  {
    Scene scene = with(constantDrag, false)();
    scene.tolerance = tolerance;
    World world(scene);
    evaluations.fill(0);
    world.advance(1.0);
    for (const auto& [other, law] : degrees)
      EXPECT_EQ(evaluationsOf(law) > 0, law == used) << tolerance << ' ' << other;
    EXPECT_EQ(kNames[static_cast<std::size_t>(used)],
              "collocation of degree " + std::to_string(pieceDegree(tolerance)));
  }
}

// One parabola per bounce, not per tick.
TEST(PayForWhatYouNameHow, AParabolaIsWorkedOutOncePerContact)
{
  World world(smooth().build());
  evaluations.fill(0);
  const std::size_t hits = run(world, 1e-3, 1000).size();
  EXPECT_EQ(evaluationsOf(Law::Restitution), static_cast<long>(hits));
  EXPECT_LE(evaluationsOf(Law::ConstantAcceleration), 2 * static_cast<long>(hits) + 1);  // and one to see if it rests
  EXPECT_GT(hits, 2u);
}

// Balls in flight are sorted into a grid once for many ticks, at any time.
TEST(PayForWhatYouNameHow, AGridServesManyShortTicks)
{
  for (const double before : {0.0, 60.0})
  {
    SceneBuilder builder;
    for (int i = 0; i < 64; ++i) builder.ball(0.1 * Vector3d(i % 4, i / 4 % 4, i / 16));
    World world(builder.build());
    world.advance(before);
    for (int i = 0; i < 64; ++i)
    {
      BallState state = world.ballState(static_cast<std::size_t>(i));
      state.v_WB = Vector3d(std::sin(i), std::cos(i), std::sin(2 * i));
      ASSERT_FALSE(world.setBallState(static_cast<BallId>(i), state));
    }
    evaluations.fill(0);
    EXPECT_GT(run(world, 1e-3, 500).size(), 10u);
    EXPECT_GT(evaluationsOf(Law::BroadPhase), 2);
    EXPECT_LT(evaluationsOf(Law::BroadPhase), 50) << "after " << before << " s";
  }
}

// What chooseMethod() says of a scene is what is then counted.
TEST(PayForWhatYouNameHow, AutoComputesWhatItSays)
{
  for (const Case& what : kCases)
  {
    Scene scene = what.scene();
    scene.method = Method::Auto;
    const std::string says = chooseMethod(scene).reason;
    const Laws laws = lawsOf(what, Method::Auto);
    const auto said = [&](const char* words) { return says.find(words) != std::string::npos; };
    const bool pieces = laws.count(*kPieces.begin()) > 0;
    EXPECT_EQ(said("closed form"), !pieces) << what.title << ": " << says;
    EXPECT_EQ(said(kPieces.begin()->c_str()), pieces) << what.title << ": " << says;
    EXPECT_EQ(said("no pair search"), laws.count("broad phase") == 0) << what.title << ": " << says;
    const bool spin_counts = laws.count("slip") + laws.count("spin ratio") + laws.count("lift") > 0;
    EXPECT_EQ(said("spin is not integrated"), !spin_counts) << what.title << ": " << says;
  }
}
}  // namespace
}  // namespace ping_pong
