// `method: auto`: what it takes, what it says, and that a world of it runs.
#include <gtest/gtest.h>

#include "ping_pong_sim/choose_method.h"
#include "ping_pong_sim/scene_loader.h"
#include "testing/scene_builder.h"

namespace ping_pong
{
namespace
{
std::string reasonFor(Scene scene)
{
  scene.method = Method::Auto;
  const Choice choice = chooseMethod(scene);
  EXPECT_EQ(choice.method, Method::Exact);
  return choice.reason;
}

Scene oneBall()
{
  return SceneBuilder().gravity(kG).floor().ball({0, 0, 1}).build();
}

void makeRough(Scene& scene, const std::string& a, const std::string& b)
{
  const auto find = [&](const std::string& name)
  {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      if (scene.materials[i] == name) return static_cast<MaterialId>(i);
    return MaterialId(0);
  };
  Surface rough;
  rough.friction = 0.3;
  scene.surfaces.set(find(a), find(b), rough);
}

const std::string kNoSpin = "no friction and no force that feels spin, so spin is not integrated";

TEST(ChooseMethod, VacuumHasAClosedForm)
{
  Scene scene = oneBall();
  const std::string rest = "; one ball, so no pair search; " + kNoSpin;
  EXPECT_EQ(reasonFor(scene), "exact: flight in closed form, since no force but gravity acts" + rest);
  scene.forces.buoyancy = true;
  EXPECT_EQ(reasonFor(scene), "exact: flight in closed form, since no force but gravity and buoyancy acts" + rest);
  scene.forces.gravity.setZero();
  EXPECT_EQ(reasonFor(scene), "exact: flight in closed form, since no force acts" + rest);
}

TEST(ChooseMethod, AirNeedsCollocationAtTheTolerance)
{
  Scene scene = oneBall();
  scene.forces.drag = true;
  scene.forces.drag_law = DragLaw::constant(0.5);
  EXPECT_EQ(reasonFor(scene),
            "exact: flight by collocation of degree 7 to 1e-06 m, for drag; one ball, so no pair search; " + kNoSpin);
  scene.tolerance = 1e-3;
  scene.forces.magnus = true;
  scene.forces.wind = {1, 0, 0};
  EXPECT_EQ(reasonFor(scene),
            "exact: flight by collocation of degree 5 to 0.001 m, for drag, the Magnus force and wind; "
            "one ball, so no pair search; spin carried, for the Magnus force");
}

TEST(ChooseMethod, DragFeelsSpinIfItsLawDoes)
{
  Scene scene = oneBall();
  scene.forces.drag = true;
  EXPECT_NE(reasonFor(scene).find("; spin carried, for drag"), std::string::npos) << reasonFor(scene);
  scene.forces.drag_law.reynolds = {1e4};
  scene.forces.drag_law.spin_ratio = {0.1};
  scene.forces.drag_law.values = {0.4};
  EXPECT_NE(reasonFor(scene).find(kNoSpin), std::string::npos) << reasonFor(scene);
  scene.forces.drag_law.spin_ratio = {0.1, 0.2};
  scene.forces.drag_law.values = {0.4, 0.5};
  EXPECT_NE(reasonFor(scene).find("; spin carried, for drag"), std::string::npos) << reasonFor(scene);
}

TEST(ChooseMethod, OnlyFrictionThatABallCanTouchCounts)
{
  const auto carries = [](const Scene& scene)
  { return reasonFor(scene).find("spin carried, for friction") != std::string::npos; };
  Scene scene = SceneBuilder().floor().box("table", {1, 1, 1}, at({5, 0, 0}), "wood").ball({0, 0, 1}).build();
  EXPECT_FALSE(carries(scene));
  makeRough(scene, "wood", "wall");  // furniture on furniture
  makeRough(scene, "ball", "ball");  // there is no second ball
  EXPECT_FALSE(carries(scene));
  Scene with_rough_table = scene;
  makeRough(with_rough_table, "ball", "wood");
  EXPECT_TRUE(carries(with_rough_table));
  scene.balls.push_back(scene.balls.front());
  EXPECT_TRUE(carries(scene));
}

TEST(ChooseMethod, SaysHowManyBallsAreSearched)
{
  Scene scene = SceneBuilder().ball({0, 0, 1}).ball({1, 0, 1}).build();
  EXPECT_NE(reasonFor(scene).find("; 2 balls, so pairs are searched; "), std::string::npos) << reasonFor(scene);
  scene.balls.clear();
  EXPECT_NE(reasonFor(scene).find("; no ball; "), std::string::npos) << reasonFor(scene);
}

TEST(ChooseMethod, ANamedMethodStays)
{
  for (const Method method : kMethods)
  {
    Scene scene = oneBall();
    scene.method = method;
    EXPECT_EQ(chooseMethod(scene).method, method);
    EXPECT_EQ(chooseMethod(scene).reason, std::string(name(method)) + ", as the scene says");
    EXPECT_EQ(World(scene).method(), method);
  }
}

TEST(ChooseMethod, TheWorldRunsWhatAutoCameTo)
{
  Scene scene = loadScene(std::string(SCENES_DIR) + "/rally.yaml");
  scene.method = Method::Exact;
  World exact(scene);
  scene.method = Method::Auto;
  World world(scene);
  for (int round = 0; round < 2; ++round, world.reset(), exact.reset())
  {
    EXPECT_EQ(world.method(), Method::Exact);
    EXPECT_EQ(world.scene().method, Method::Auto);  // as loaded
    const std::size_t hits = run(world, 0.01, 100).size();
    EXPECT_GT(hits, 0u);
    EXPECT_EQ(hits, run(exact, 0.01, 100).size());
    EXPECT_EQ(positionOf(world), positionOf(exact));
  }
}

TEST(ChooseMethod, AutoIsWhatASceneBuiltInCodeStartsWith)
{
  EXPECT_EQ(Scene().method, Method::Auto);
  EXPECT_EQ(World(Scene()).method(), Method::Exact);
}
}  // namespace
}  // namespace ping_pong
