// Scenes: good ones load with the values of the file; bad ones name file, line, key, value and what was expected.
#include <cmath>
#include <random>
#include <set>

#include "testing/load_checks.h"

namespace ping_pong
{
namespace
{
constexpr char kBoxUrdf[] = R"(<robot name="box"><link name="wood">
  <collision><geometry><box size="1 1 1"/></geometry></collision>
</link></robot>
)";

constexpr char kBatUrdf[] = R"(<robot name="bat"><link name="bat">
  <collision name="rubber"><geometry><cylinder radius="0.1" length="0.02"/></geometry></collision>
  <collision name="handle"><origin xyz="0 0 -0.2"/><geometry><sphere radius="0.05"/></geometry></collision>
</link></robot>
)";

// The line numbers in the table of errors count from the first line of this text.
constexpr char kScene[] = R"(name: sample
forces: {gravity: 9.81}
floor: {height: -0.5, material: lawn}
bodies:
  - name: box
    urdf: box.urdf
    kind: static
    position: [0, 0, 0.5]
  - name: bat
    urdf: bat.urdf
    kind: kinematic
    position: [5, 0, 1]
    rpy: [0, 0, 1.5707963267948966]
    limits: {speed: 20, acceleration: .inf}
balls:
  - position: [0, 0, 2]
    velocity: [1, -2, 3e-1]
    spin: [0, 50, 0]
    radius: 0.03
    mass: 0.004
    color: [0.1, 0.2, 0.3]
    material: rubber
  - grid: {count: [3, 2, 2], spacing: [0.06, 0.07, 0.08], origin: [1, 1, 1], velocity: [0, 0, 1]}
  - random: {count: 40, min: [2, 2, 2], max: [2.5, 2.5, 2.5], seed: 7, speed: 0.5, color: mixed}
surfaces:
  - {pair: [ball, any], restitution: 0.8}
  - {pair: [rubber, ball], restitution: 0.7}
  - {pair: [rubber, lawn], restitution: 0.2}
  - {pair: [any, any], restitution: 0.1}
method: euler_semi_implicit
dt: 0.002
)";

// Every key that kScene has not.
constexpr char kAirScene[] = R"(forces:
  gravity: 9.81
  air: {temperature: 20, altitude: 100, viscosity: 1.5e-5}
  drag: {table: {reynolds: [1e4, 2e4], spin_ratio: [0, 0.5, 1], values: [[0.4, 0.5, 0.6], [0.3, 0.4, 0.7]]}}
  magnus: {law: table, spin_ratio: [0.2, 0.4], values: [0.1, 0.3]}
  buoyancy: true
  added_mass: true
  spin_decay: 0.15
  wind: [1, -2, 0.5]
floor: {}
balls: [{position: [0, 0, 1], inertia: solid}]
surfaces:
  - {pair: [ball, any], restitution: 0.9, restitution_slope: 0.02, friction: .inf, tangential_restitution: -0.3,
     rolling_resistance: 0.01, spin_friction: 0.002}
  - {pair: [ball, floor], preset: table_match}
tolerance: 1e-9
threads: 2
)";

class SceneLoader : public ::testing::Test
{
protected:
  SceneLoader()
  {
    folder_.write("box.urdf", kBoxUrdf);
    folder_.write("bat.urdf", kBatUrdf);
  }

  Scene load(const std::string& text, const LoadOptions& options = {}) const
  {
    return loadScene(folder_.write("scene.yaml", text), options);
  }
  Forces forcesOf(const std::string& text) const { return load(text).forces; }
  std::string errorOf(const std::string& text) const
  {
    return loadErrorOf([&] { load(text); });
  }
  std::string file() const { return folder_.path("scene.yaml"); }

  TempFolder folder_;
};

std::size_t materialIndex(const Scene& scene, const std::string& name)
{
  const auto found = std::find(scene.materials.begin(), scene.materials.end(), name);
  return static_cast<std::size_t>(found - scene.materials.begin());
}

double restitution(const Scene& scene, const std::string& a, const std::string& b)
{
  return scene.surfaces
      .at(static_cast<MaterialId>(materialIndex(scene, a)), static_cast<MaterialId>(materialIndex(scene, b)))
      .restitution;
}

TEST_F(SceneLoader, ReadsGeneralValues)
{
  const Scene scene = load(kScene);
  EXPECT_EQ(scene.name, "sample");
  EXPECT_EQ(scene.path, file());
  EXPECT_EQ(scene.forces.gravity, Vector3d(0, 0, -9.81));
  EXPECT_EQ(scene.method, Method::EulerSemiImplicit);
  EXPECT_EQ(scene.dt, 0.002);
}

TEST_F(SceneLoader, ReadsBodiesAndPutsTheFloorLast)
{
  const Scene scene = load(kScene);
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].name, "box");
  EXPECT_EQ(scene.bodies[0].kind, BodyKind::Static);
  EXPECT_EQ(scene.bodies[0].pose.p, Vector3d(0, 0, 0.5));
  EXPECT_EQ(scene.bodies[0].pose.q.coeffs(), Quaterniond::Identity().coeffs());
  EXPECT_EQ(scene.bodies[0].urdf_path, folder_.path("box.urdf"));
  EXPECT_EQ(scene.bodies[1].kind, BodyKind::Kinematic);
  EXPECT_EQ(scene.bodies[1].shapes.size(), 2u);
  EXPECT_EQ(scene.bodies[1].limits.speed, 20.0);
  EXPECT_TRUE(std::isinf(scene.bodies[1].limits.acceleration));
  EXPECT_EQ(scene.bodies[1].limits.angular_speed, DriveLimits().angular_speed);
  EXPECT_EQ(scene.bodies[2].name, "floor");
  ASSERT_EQ(scene.bodies[2].shapes.size(), 1u);
  EXPECT_EQ(scene.bodies[2].shapes[0].kind, ShapeKind::HalfSpace);
  EXPECT_EQ(scene.bodies[2].shapes[0].material, materialIndex(scene, "lawn"));
  EXPECT_EQ(scene.bodies[2].pose.p, Vector3d(0, 0, -0.5));
  EXPECT_EQ(scene.bodies[2].urdf_path, "");
}

TEST_F(SceneLoader, ReadsHowAPaddleStarts)
{
  const std::string limits = "limits: {speed: 20, acceleration: .inf}";
  const auto start = [&](const std::string& keys) { return load(edited(kScene, limits, keys)).bodies.at(1).twist; };
  EXPECT_EQ(start("").v, Vector3d(0, 0, 0));
  EXPECT_EQ(start("").w, Vector3d(0, 0, 0));
  EXPECT_EQ(start("velocity: [1, -2, 3e-1]").v, Vector3d(1, -2, 0.3));
  EXPECT_EQ(start("velocity: [1, -2, 3e-1]").w, Vector3d(0, 0, 0));
  EXPECT_EQ(start("angular_velocity: [0, 50, -1]").w, Vector3d(0, 50, -1));
  // Just as fast as the limits allow, be they the default's, wider or infinite; wherever they stand.
  EXPECT_EQ(start("velocity: [0, 30, 0]").v, Vector3d(0, 30, 0));
  EXPECT_EQ(start("angular_velocity: [0, 0, 60]").w, Vector3d(0, 0, 60));
  EXPECT_EQ(start("velocity: [0, 31, 0]\n    limits: {speed: 31}").v, Vector3d(0, 31, 0));
  EXPECT_EQ(start("limits: {angular_speed: .inf}\n    angular_velocity: [0, 1e6, 0]").w, Vector3d(0, 1e6, 0));
}

TEST_F(SceneLoader, TurnsBodiesAsUrdfDoes)
{
  const Scene scene = load(edited(kScene, "rpy: [0, 0, 1.5707963267948966]", "rpy: [0.3, -0.4, 0.5]"));
  // Fixed axes: roll about x first, then pitch about y, then yaw about z.
  const auto rotation = [](double angle, const Vector3d& axis)
  { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); };
  const Matrix3d expected =
      rotation(0.5, Vector3d::UnitZ()) * rotation(-0.4, Vector3d::UnitY()) * rotation(0.3, Vector3d::UnitX());
  EXPECT_LT((scene.bodies[1].pose.q.toRotationMatrix() - expected).norm(), 1e-15);  // a few roundings
}

TEST_F(SceneLoader, ReadsASingleBall)
{
  const Scene scene = load(kScene);
  const SceneBall& ball = scene.balls.at(0);
  EXPECT_EQ(ball.state.p_WB, Vector3d(0, 0, 2));
  EXPECT_EQ(ball.state.v_WB, Vector3d(1, -2, 0.3));
  EXPECT_EQ(ball.state.w_WB, Vector3d(0, 50, 0));
  EXPECT_EQ(ball.params.radius, 0.03);
  EXPECT_EQ(ball.params.mass, 0.004);
  EXPECT_EQ(ball.params.color.b, 0.3f);
  EXPECT_EQ(ball.params.material, materialIndex(scene, "rubber"));
}

TEST_F(SceneLoader, PlacesAGridXFirst)
{
  const Scene scene = load(kScene);
  ASSERT_EQ(scene.balls.size(), 1u + 12u + 40u);
  EXPECT_EQ(scene.balls[1].state.p_WB, Vector3d(1, 1, 1));
  EXPECT_EQ(scene.balls[2].state.p_WB, Vector3d(1 + 0.06, 1, 1));
  EXPECT_EQ(scene.balls[4].state.p_WB, Vector3d(1, 1 + 0.07, 1));
  EXPECT_EQ(scene.balls[12].state.p_WB, Vector3d(1 + 2 * 0.06, 1 + 0.07, 1 + 0.08));
  EXPECT_EQ(scene.balls[12].state.v_WB, Vector3d(0, 0, 1));
  EXPECT_EQ(scene.balls[12].params.radius, BallParams().radius);
}

TEST_F(SceneLoader, PlacesARandomCrowdWithoutOverlap)
{
  const Scene scene = load(kScene);
  std::set<float> greens;
  for (std::size_t i = 13; i < scene.balls.size(); ++i)
  {
    const SceneBall& ball = scene.balls[i];
    EXPECT_TRUE((ball.state.p_WB.array() >= 2.0).all() && (ball.state.p_WB.array() <= 2.5).all());
    EXPECT_NEAR(ball.state.v_WB.norm(), 0.5, 1e-15);
    greens.insert(ball.params.color.g);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((ball.state.p_WB - scene.balls[j].state.p_WB).norm(),
                ball.params.radius + scene.balls[j].params.radius - 1e-9);
  }
  EXPECT_GT(greens.size(), 4u);
}

TEST_F(SceneLoader, GivesTheSameCrowdForTheSameSeed)
{
  LoadOptions options;
  options.has_seed = true;
  options.seed = 7;
  const Scene own = load(kScene), same = load(kScene, options);
  options.seed = 8;
  const Scene other = load(kScene, options);
  EXPECT_EQ(own.balls.back().state.p_WB, same.balls.back().state.p_WB);
  EXPECT_EQ(own.balls.back().state.v_WB, same.balls.back().state.v_WB);
  EXPECT_NE(own.balls.back().state.p_WB, other.balls.back().state.p_WB);
  EXPECT_EQ(own.balls[5].state.p_WB, other.balls[5].state.p_WB);
}

TEST_F(SceneLoader, KeepsTheBitsOfTheGenerator)
{
  // splitmix64 and IEEE 754 fix these digits on every machine; a change here changes every recorded crowd.
  const Vector3d p = load(kScene).balls.at(13).state.p_WB;
  EXPECT_EQ(p, Vector3d(2.1874518800512432, 2.4857971661364844, 2.4171641712171943));
}

TEST_F(SceneLoader, ShiftsAGridByItsJitterOnly)
{
  const std::string grid = "spacing: [0.06, 0.07, 0.08]";
  const Scene even = load(kScene), uneven = load(edited(kScene, grid, grid + ", jitter: 0.005, seed: 3"));
  for (std::size_t i = 1; i < 13; ++i)
  {
    const Vector3d shift = uneven.balls[i].state.p_WB - even.balls[i].state.p_WB;
    EXPECT_GT(shift.norm(), 0.0);
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 0.005);
  }
}

TEST_F(SceneLoader, LetsTheMoreSpecificPairWin)
{
  const Scene scene = load(kScene);
  EXPECT_EQ(restitution(scene, "ball", "ball"), 0.8);
  EXPECT_EQ(restitution(scene, "ball", "wood"), 0.8);
  EXPECT_EQ(restitution(scene, "wood", "ball"), 0.8);
  EXPECT_EQ(restitution(scene, "ball", "rubber"), 0.7);
  EXPECT_EQ(restitution(scene, "rubber", "lawn"), 0.2);
  EXPECT_EQ(restitution(scene, "rubber", "wood"), 0.1);
}

TEST_F(SceneLoader, NeedsLittle)
{
  const Scene scene = load("balls: [{position: [0, 0, 1]}]\n");
  EXPECT_EQ(scene.name, "scene");  // the file's
  EXPECT_EQ(scene.forces.gravity, Vector3d::Zero());
  EXPECT_EQ(scene.method, Method::Auto);
  EXPECT_EQ(scene.materials, std::vector<std::string>{"ball"});
  EXPECT_EQ(scene.balls.at(0).params.material, 0);
  EXPECT_EQ(load("{}").balls.size(), 0u);
}

TEST_F(SceneLoader, TakesEveryMethodByName)
{
  for (const Method method : kMethods) EXPECT_EQ(load("method: " + std::string(name(method))).method, method);
  EXPECT_EQ(load("method: auto").method, Method::Auto);
}

TEST_F(SceneLoader, TakesGravityAsAVector)
{
  EXPECT_EQ(load("forces: {gravity: [1, 2, -3]}").forces.gravity, Vector3d(1, 2, -3));
}

TEST_F(SceneLoader, AllowsTouching)
{
  EXPECT_EQ(errorOf("floor: {}\nballs: [{position: [0, 0, 0.02]}, {position: [0.04, 0, 0.02]}]\n"
                    "surfaces: [{pair: [ball, any], restitution: 1}]"),
            "");
}

TEST_F(SceneLoader, ReadsNumbersWhateverTheLocale)
{
  const DecimalComma comma;
  const Scene scene = load(kScene);
  EXPECT_EQ(scene.forces.gravity.z(), -9.81);
  EXPECT_EQ(scene.bodies[1].shapes[0].half_size.x(), 0.1);
}

TEST_F(SceneLoader, NamesTheUrdfFileAndLineOfAUrdfProblem)
{
  folder_.write("box.urdf", edited(kBoxUrdf, "1 1 1", "1 0 1"));
  expectMessage(
      errorOf(kScene),
      folder_.path("box.urdf") + ":2: robot/link/collision/geometry/box.size: 1 0 1: expected 3 finite numbers > 0");
}

TEST_F(SceneLoader, SaysThatAFileIsMissing)
{
  const std::string missing = folder_.path("no.yaml");
  expectMessage(loadErrorOf([&] { loadScene(missing); }),
                missing + ":1: scene: No such file or directory: expected a readable file");
  expectMessage(loadErrorOf([&] { loadScene(folder_.path("")); }), folder_.path("") + ":1: scene: Is a directory: ");
  expectMessage(loadErrorOf([&] { loadScene("/dev/zero"); }), "/dev/zero:1: scene: larger than 16 MiB: ");
}

TEST_F(SceneLoader, ComputesNoForceThatIsNotListed)
{
  const Forces none = forcesOf("forces: {air: {density: 1}, wind: [1, 2, 3]}");
  EXPECT_FALSE(none.drag || none.magnus || none.buoyancy || none.added_mass);
  EXPECT_EQ(none.spin_decay, 0.0);
  const Forces off = forcesOf("forces: {buoyancy: false, added_mass: false, spin_decay: 0}");
  EXPECT_FALSE(off.drag || off.magnus || off.buoyancy || off.added_mass);
}

TEST_F(SceneLoader, ReadsForces)
{
  const Forces f = forcesOf(
      "forces:\n  gravity: 9.81\n  air: {density: 1.1, viscosity: 1.6e-5}\n"
      "  drag: {coefficient: 0.5}\n  magnus: {law: saturating, slope: 2, saturation: 6}\n"
      "  buoyancy: true\n  added_mass: true\n  spin_decay: 0.15\n  wind: [1, -2, 0.5]\n");
  EXPECT_EQ(f.air_density, 1.1);
  EXPECT_EQ(f.air_viscosity, 1.6e-5);
  EXPECT_TRUE(f.drag && f.magnus && f.buoyancy && f.added_mass);
  EXPECT_EQ(f.drag_law.at(3e4, 0.2), 0.5);
  EXPECT_EQ(f.lift_law.perSpinRatio(0.5), 2.0 / (1.0 + 6.0 * 0.5));
  EXPECT_EQ(f.spin_decay, 0.15);
  EXPECT_EQ(f.wind, Vector3d(1, -2, 0.5));
}

TEST_F(SceneLoader, ReadsEveryKeyOfAir)
{
  EXPECT_EQ(errorOf(kAirScene), "");
}

TEST_F(SceneLoader, ReadsLiftLaws)
{
  const auto lift = [&](const std::string& law, double S)
  { return forcesOf("forces: {magnus: " + law + "}").lift_law.perSpinRatio(S) * S; };
  EXPECT_EQ(lift("{law: linear, slope: 0.6}", 0.5), 0.3);
  EXPECT_EQ(lift("{law: constant, coefficient: 0.25}", 0.5), 0.25);
  const std::string table = "{law: table, spin_ratio: [0.2, 0.4], values: [0.1, 0.3]}";
  EXPECT_NEAR(lift(table, 0.1), 0.05, 1e-16);  // one rounding
  EXPECT_NEAR(lift(table, 0.3), 0.2, 1e-16);
  EXPECT_NEAR(lift(table, 2.0), 0.3, 1e-16);
}

TEST_F(SceneLoader, ReadsDragThatGrowsWithSpin)
{
  const DragLaw law = forcesOf("forces: {drag: {without_spin: 0.3, with_spin: 0.5, half_at: 0.1}}").drag_law;
  EXPECT_EQ(law.at(3e4, 0.0), 0.3);
  EXPECT_NEAR(law.at(3e4, 0.1), 0.4, 1e-16);  // one rounding
  EXPECT_NEAR(law.at(3e4, 1e6), 0.5, 1e-13);
}

TEST_F(SceneLoader, ReadsADragTableRowByReynoldsNumber)
{
  const DragLaw law = forcesOf(
                          "forces: {drag: {table: {reynolds: [1e4, 2e4], spin_ratio: [0, 0.5, 1],\n"
                          "  values: [[0.4, 0.5, 0.6], [0.3, 0.4, 0.7]]}}}")
                          .drag_law;
  EXPECT_EQ(law.at(0.0, 0.0), 0.4);
  EXPECT_EQ(law.at(1e4, 1.0), 0.6);
  EXPECT_EQ(law.at(2e4, 0.0), 0.3);
  EXPECT_EQ(law.at(1e9, 9.0), 0.7);
  EXPECT_NEAR(law.at(1.5e4, 0.25), 0.4, 1e-16);
}

TEST_F(SceneLoader, WorksOutTheAirFromTemperatureAndAltitude)
{
  const auto air = [&](const std::string& text) { return forcesOf("forces: {air: " + text + "}"); };
  EXPECT_NEAR(air("{temperature: 20}").air_density, 1.2041, 1e-4);  // tables of dry air, 4 digits
  EXPECT_NEAR(air("{temperature: 25}").air_density, 1.1839, 1e-4);
  EXPECT_NEAR(air("{temperature: 5.25, altitude: 1500}").air_density, 1.0581, 2e-4);  // ICAO standard atmosphere
  EXPECT_NEAR(air("{temperature: 20}").air_viscosity, 1.51e-5, 1e-7);                 // sources differ by 1 %
  EXPECT_EQ(air("{altitude: 800}").air_density, air("{temperature: 20, altitude: 800}").air_density);
  EXPECT_EQ(air("{temperature: 25, viscosity: 1e-5}").air_viscosity, 1e-5);
  EXPECT_EQ(air("{}").air_density, Forces().air_density);
}

TEST_F(SceneLoader, KnowsFlightPresets)
{
  struct Known
  {
    const char* name;
    double drag, lift;  ///< C_D and C_L at S = 0.4
  };
  const double with_spin = 0.33 + 0.20 * 36.0 / 37.0;  // S = 6 half_at
  for (const Known& known :
       {Known{"table_rally", with_spin, 0.333 * 7.3 * 0.4 / 3.92}, Known{"default", with_spin, 0.24806},
        Known{"table_rally_constant_drag", 0.53, 0.24806}, Known{"half_saturating", 0.44, 0.4 / 1.8},
        Known{"tebbe", 0.40, 0.24}, Known{"mujoco_deepmind", 0.47, 0.532}, Known{"ace", 0.55, 0.267}})
  {
    SCOPED_TRACE(known.name);
    const std::string name = known.name;
    const Forces both = forcesOf("forces: {preset: " + name + "}");
    EXPECT_TRUE(both.drag && both.magnus);
    EXPECT_NEAR(both.drag_law.at(3e4, 0.4), known.drag, 1e-15);
    EXPECT_NEAR(both.lift_law.perSpinRatio(0.4) * 0.4, known.lift, 1e-5);  // its digits
    const Forces drag = forcesOf("forces: {drag: " + name + "}"), magnus = forcesOf("forces: {magnus: " + name + "}");
    EXPECT_TRUE(drag.drag && !drag.magnus && magnus.magnus && !magnus.drag);
    EXPECT_EQ(drag.drag_law.at(3e4, 0.4), both.drag_law.at(3e4, 0.4));
    EXPECT_EQ(magnus.lift_law.perSpinRatio(0.4), both.lift_law.perSpinRatio(0.4));
  }
}

TEST_F(SceneLoader, HasTheDefaultsOfTheCoreAsItsDefaultPreset)
{
  const Forces preset = forcesOf("forces: {preset: default}"), core;
  EXPECT_EQ(preset.drag_law.at(3e4, 0.4), core.drag_law.at(3e4, 0.4));
  EXPECT_EQ(preset.lift_law.perSpinRatio(0.4), core.lift_law.perSpinRatio(0.4));
}

Surface surfaceOf(const Scene& scene)
{
  return scene.surfaces.at(0, scene.bodies.back().shapes[0].material);
}

std::string ballOnFloor(const std::string& law)
{
  return "floor: {}\nballs: [{position: [0, 0, 1]}]\nsurfaces: [{pair: [ball, floor], " + law + "}]\n";
}

TEST_F(SceneLoader, ReadsContactLaws)
{
  const Surface smooth = surfaceOf(load(ballOnFloor("restitution: 0.9")));
  EXPECT_EQ(smooth.restitution, 0.9);
  EXPECT_EQ(smooth.restitution_slope, 0.0);
  EXPECT_EQ(smooth.friction, 0.0);
  const Surface rough =
      surfaceOf(load(ballOnFloor("restitution: 0.9, restitution_slope: 0.02, friction: 0.25, "
                                 "tangential_restitution: -0.3, rolling_resistance: 0.01, spin_friction: 0.002")));
  EXPECT_EQ(rough.restitution_slope, 0.02);
  EXPECT_EQ(rough.friction, 0.25);
  EXPECT_EQ(rough.tangential_restitution, -0.3);
  EXPECT_EQ(rough.rolling_resistance, 0.01);
  EXPECT_EQ(rough.spin_friction, 0.002);
  EXPECT_TRUE(std::isinf(surfaceOf(load(ballOnFloor("restitution: 1, friction: .inf"))).friction));
}

TEST_F(SceneLoader, KnowsSurfacePresets)
{
  struct Known
  {
    const char* name;
    double e, mu, e_t;  ///< e at 2.4 m/s
  };
  for (const Known& known : {Known{"table_match", 0.942, 0.24, 0.15}, Known{"table_rigid", 0.932, 0.24, 0},
                             Known{"table_ittf", 0.905, 0.25, 0}, Known{"rubber_inverted", 0.86492, INFINITY, 0.70},
                             Known{"net", 0.1, 0.3, 0}, Known{"floor", 0.8, 0.4, 0}, Known{"wall", 0.8, 0.4, 0}})
  {
    SCOPED_TRACE(known.name);
    const Surface surface = surfaceOf(load(ballOnFloor("preset: " + std::string(known.name))));
    EXPECT_NEAR(surface.restitutionAt(2.4), known.e, 1e-15);
    EXPECT_EQ(surface.friction, known.mu);
    EXPECT_EQ(surface.tangential_restitution, known.e_t);
  }
}

TEST_F(SceneLoader, ReadsInertia)
{
  const auto inertia = [&](const std::string& text) { return load("balls: " + text).balls.at(0).params.inertia; };
  EXPECT_EQ(inertia("[{position: [0, 0, 1]}]"), 2.0 / 3.0);
  EXPECT_EQ(inertia("[{position: [0, 0, 1], inertia: shell}]"), 2.0 / 3.0);
  EXPECT_EQ(inertia("[{position: [0, 0, 1], inertia: solid}]"), 2.0 / 5.0);
  EXPECT_EQ(inertia("[grid: {count: [1, 1, 1], spacing: 1, origin: [0, 0, 1], inertia: solid}]"), 2.0 / 5.0);
  EXPECT_EQ(inertia("[random: {count: 1, min: [0, 0, 1], max: [0, 0, 1], inertia: solid}]"), 2.0 / 5.0);
}

TEST_F(SceneLoader, ReadsTolerance)
{
  EXPECT_EQ(load("{}").tolerance, Scene().tolerance);
  EXPECT_EQ(load("tolerance: 1e-12").tolerance, 1e-12);
  EXPECT_EQ(load("tolerance: 0.1").tolerance, 0.1);
  EXPECT_EQ(load("{}").threads, 1u);
  EXPECT_EQ(load("threads: 64").threads, kMaxThreads);
}

struct BadScene
{
  const char* what;
  std::string from, to;  ///< edit of kScene
  int line;
  std::string key, value, expected;  ///< an empty value: text that is not YAML, which the library describes itself
};

const BadScene kBadScenes[] = {
    // keys
    {"unknown key", "forces:", "forcs:", 2, "forcs", "unknown key", "one of name, forces, floor"},
    {"unknown inner key", "gravity: 9.81", "gravity: 9.81, lift: 1", 2, "forces.lift", "unknown key", "one of gravity"},
    {"unknown ball key", "spin: [0", "spn: [0", 18, "balls[0].spn", "unknown key", "one of position"},
    {"repeated key", "dt: 0.002", "dt: 0.002\ndt: 0.002", 32, "dt", "repeated key", "each key once"},
    {"repeated inner key", "{speed: 20,", "{speed: 20, speed: 20,", 14, "bodies[1].limits.speed", "repeated key",
     "each"},
    {"merge key", "dt: 0.002", "<<: {dt: 1}", 31, "<<", "unknown key", "one of"},
    {"list as key", "dt: 0.002", "? [a]\n: 1", 31, "?", "unknown key", "one of"},
    // not this kind of file
    {"not YAML", "{gravity: 9.81}", "{gravity: 9.81", 3, "scene", "", ""},
    {"not a map", kScene, "- 1", 1, "scene", "[1]", "a map with the keys name"},
    {"empty", kScene, "", 1, "scene", "0 documents", "one YAML document"},
    {"two documents", "dt: 0.002", "---\ndt: 0.002", 1, "scene", "2 documents", "one YAML document"},
    {"a comma where a document should be", kScene, ", a", 1, "scene", "2 documents",
     "one YAML document"},  // endless in yaml-cpp 0.7
    {"deep nesting", "dt: 0.002", "dt: " + std::string(5000, '['), 31, "scene", "[", "at most 100 nested brackets"},
    {"alias without anchor", "dt: 0.002", "dt: *x", 31, "scene", "", ""},
    // types
    {"text for number", "dt: 0.002", "dt: fast", 31, "dt", "fast", "a finite number > 0"},
    {"quoted number", "dt: 0.002", "dt: \"0.002\"", 31, "dt", "0.002", "a finite number > 0"},
    {"unit in number", "dt: 0.002", "dt: 2ms", 31, "dt", "2ms", "a finite number > 0"},
    {"decimal comma", "9.81", "'9,81'", 2, "forces.gravity", "9,81", "a finite number >= 0"},
    {"hexadecimal", "dt: 0.002", "dt: 0x1", 31, "dt", "0x1", "a finite number > 0"},
    {"nothing for number", "dt: 0.002", "dt:", 31, "dt", "nothing", "a finite number > 0"},
    {"list for number", "dt: 0.002", "dt: [1]", 31, "dt", "[1]", "a finite number > 0"},
    {"map for number", "dt: 0.002", "dt: {a: 1}", 31, "dt", "a map", "a finite number > 0"},
    {"number for map", "{gravity: 9.81}", "9.81", 2, "forces", "9.81", "a map with the keys gravity"},
    {"map for list", "  - {pair: [ball, any], restitution: 0.8}\n", "  a: 1\n", 27, "scene", "", ""},
    {"text for list", "[0, 0, 0.5]", "middle", 8, "bodies[0].position", "middle", "three numbers [x, y, z]"},
    {"two components", "[0, 0, 0.5]", "[0, 0.5]", 8, "bodies[0].position", "[0, 0.5]", "three numbers [x, y, z]"},
    {"list for text", "name: sample", "name: [a]", 1, "name", "[a]", "a text"},
    {"empty text", "name: sample", "name: ''", 1, "name", "\"\"", "a text"},
    {"value of two lines", "euler_semi_implicit", "\"a\\nb\"", 30, "method", "a b", "one of"},
    // not finite
    {"NaN", "[0, 0, 0.5]", "[0, .nan, 0.5]", 8, "bodies[0].position[1]", ".nan", "a finite number"},
    {"infinite position", "[0, 0, 2]", "[0, 0, .inf]", 16, "balls[0].position[2]", ".inf", "a finite number"},
    {"NaN start", "    rpy:", "    velocity: [0, 0, .nan]\n    rpy:", 13, "bodies[1].velocity[2]", ".nan",
     "a finite number"},
    {"infinite start", "    rpy:", "    angular_velocity: [.inf, 0, 0]\n    rpy:", 13, "bodies[1].angular_velocity[0]",
     ".inf", "a finite number"},
    {"start of two components", "    rpy:", "    velocity: [1, 2]\n    rpy:", 13, "bodies[1].velocity", "[1, 2]",
     "three numbers [x, y, z]"},
    {"start of one number", "    rpy:", "    angular_velocity: 3\n    rpy:", 13, "bodies[1].angular_velocity", "3",
     "three numbers [x, y, z]"},
    {"start as text", "    rpy:", "    velocity: [fast, 0, 0]\n    rpy:", 13, "bodies[1].velocity[0]", "fast",
     "a finite number"},
    {"start above the limit", "    rpy:", "    velocity: [0, -12, 16.01]\n    rpy:", 13, "bodies[1].velocity",
     "[0, -12, 16.01]", "at most 20 m/s, what the limits of the body allow"},
    {"turn above the default limit", "    rpy:", "    angular_velocity: [0, 0, 60.01]\n    rpy:", 13,
     "bodies[1].angular_velocity", "[0, 0, 60.01]", "at most 60 rad/s, what the limits of the body allow"},
    {"overflow", "[0, 0, 2]", "[0, 0, 1e999]", 16, "balls[0].position[2]", "1e999", "a finite number"},
    {"NaN limit", "speed: 20", "speed: .nan", 14, "bodies[1].limits.speed", ".nan", "a number > 0 or .inf"},
    {"infinite velocity", "3e-1", "-.inf", 17, "balls[0].velocity[2]", "-.inf", "a finite number"},
    {"NaN spin", "[0, 50, 0]", "[0, nan, 0]", 18, "balls[0].spin[1]", "nan", "a finite number"},
    // out of range
    {"zero mass", "mass: 0.004", "mass: 0", 20, "balls[0].mass", "0", "a finite number > 0"},
    {"negative radius", "radius: 0.03", "radius: -0.03", 19, "balls[0].radius", "-0.03", "a finite number > 0"},
    {"no thread", "dt: 0.002", "threads: 0", 31, "threads", "0", "an integer from 1 to 64"},
    {"too many threads", "dt: 0.002", "threads: 65", 31, "threads", "65", "an integer from 1 to 64"},
    {"zero dt", "dt: 0.002", "dt: 0", 31, "dt", "0", "a finite number > 0"},
    {"negative dt", "dt: 0.002", "dt: -0.002", 31, "dt", "-0.002", "a finite number > 0"},
    {"infinite dt", "dt: 0.002", "dt: .inf", 31, "dt", ".inf", "a finite number > 0"},
    {"zero limit", "speed: 20", "speed: 0", 14, "bodies[1].limits.speed", "0", "a number > 0 or .inf"},
    {"negative limit", "acceleration: .inf", "acceleration: -.inf", 14, "bodies[1].limits.acceleration", "-.inf",
     "a number > 0"},
    {"upward gravity", "9.81", "-9.81", 2, "forces.gravity", "-9.81", "a finite number >= 0"},
    {"bouncy", "restitution: 0.8", "restitution: 1.01", 26, "surfaces[0].restitution", "1.01", "a number from 0 to 1"},
    {"negative e", "restitution: 0.8", "restitution: -0.1", 26, "surfaces[0].restitution", "-0.1",
     "a number from 0 to 1"},
    {"colour range", "[0.1, 0.2, 0.3]", "[0.1, 2, 0.3]", 21, "balls[0].color[1]", "2", "a number from 0 to 1"},
    {"colour name", "[0.1, 0.2, 0.3]", "mauve", 21, "balls[0].color", "mauve", "mixed, [r, g, b], or one of orange"},
    {"grid count", "[3, 2, 2]", "[3, 0, 2]", 23, "balls[1].grid.count[1]", "0", "an integer from 1 to 100000"},
    {"fractional count", "count: 40", "count: 4.5", 24, "balls[2].random.count", "4.5", "an integer from 1 to 100000"},
    {"too many balls", "[3, 2, 2]", "[900, 900, 900]", 23, "balls[1].grid.origin", "729000001 balls", "at most 100000"},
    {"zero spacing", "[0.06, 0.07, 0.08]", "0", 23, "balls[1].grid.spacing", "0", "a finite number > 0"},
    {"negative jitter", "origin: [1", "jitter: -1, origin: [1", 23, "balls[1].grid.jitter", "-1",
     "a finite number >= 0"},
    {"box inside out", "max: [2.5", "max: [1.5", 24, "balls[2].random.max", "[1.5, 2.5, 2.5]",
     "a corner that is not below min"},
    {"negative seed", "seed: 7", "seed: -7", 24, "balls[2].random.seed", "-7", "an integer >= 0"},
    {"huge seed", "seed: 7", "seed: 18446744073709551616", 24, "balls[2].random.seed", "18446744073709551616",
     "an integer"},
    {"full box", "max: [2.5, 2.5, 2.5]", "max: [2.1, 2.1, 2.1]", 24, "balls[2].random.count", "40",
     "fewer balls, or a box with room"},
    {"zero tolerance", "dt: 0.002", "tolerance: 0", 31, "tolerance", "0", "a number from 1e-12 to 0.1"},
    {"tolerance of a metre", "dt: 0.002", "tolerance: 1", 31, "tolerance", "1", "a number from 1e-12 to 0.1"},
    {"inertia", "mass: 0.004", "inertia: 0.5", 20, "balls[0].inertia", "0.5", "shell or solid"},
    // missing
    {"no centre", "- position: [0, 0, 2]\n    velocity", "- velocity", 16, "balls[0].position", "missing",
     "the centre [x, y, z]"},
    {"no count", "count: 40, ", "", 24, "balls[2].random.count", "missing", "the number of balls"},
    {"no kind", "    kind: static\n", "", 5, "bodies[0].kind", "missing", "static or kinematic"},
    {"no name", "- name: box\n    urdf", "- urdf", 5, "bodies[0].name", "missing", "the name of the body"},
    {"no urdf", "    urdf: box.urdf\n", "", 5, "bodies[0].urdf", "missing", "the path of a URDF file"},
    {"no restitution", ", restitution: 0.7", "", 27, "surfaces[1].restitution", "missing", "a number from 0 to 1"},
    {"no pair", "pair: [any, any], ", "", 29, "surfaces[3].pair", "missing", "two materials [a, b]"},
    {"no such file", "box.urdf", "../no.urdf", 6, "bodies[0].urdf", "../no.urdf", "a readable URDF file, but /"},
    // words
    {"method", "euler_semi_implicit", "magic", 30, "method", "magic",
     "one of: euler_explicit, euler_semi_implicit, verlet, rk4, rk4_located, impulse, exact, auto"},
    {"kind", "kind: static", "kind: dynamic", 7, "bodies[0].kind", "dynamic", "static or kinematic"},
    {"limits of furniture", "    kind: static\n", "    kind: static\n    limits: {}\n", 8, "bodies[0].limits", "a map",
     "no limits unless"},
    {"furniture in motion", "    kind: static\n", "    kind: static\n    velocity: [0, 0, 0]\n", 8,
     "bodies[0].velocity", "[0, 0, 0]", "no motion unless the kind is kinematic"},
    {"furniture that turns", "    kind: static\n", "    angular_velocity: [0, 0, 1]\n    kind: static\n", 7,
     "bodies[0].angular_velocity", "[0, 0, 1]", "no motion unless the kind is kinematic"},
    {"pattern and more", "- random: {", "- mass: 1\n    random: {", 24, "balls[2].mass", "unknown key",
     "one of random"},
    // names
    {"repeated name", "name: bat", "name: box", 9, "bodies[1].name", "box", "a name that no other body has"},
    {"name with slash", "name: box", "name: a/b", 5, "bodies[0].name", "a/b", "a frame name of letters"},
    {"name with blank", "name: box", "name: a b", 5, "bodies[0].name", "a b", "a frame name of letters"},
    {"name with digit first", "name: box", "name: 1box", 5, "bodies[0].name", "1box", "a frame name of letters"},
    {"world", "name: box", "name: world", 5, "bodies[0].name", "world", "a name other than world"},
    {"name of a ball", "name: box", "name: ball_12", 5, "bodies[0].name", "ball_12", "a name other than world"},
    {"name of the newest ball", "name: box", "name: newest_ball", 5, "bodies[0].name", "newest_ball",
     "a name other than world"},
    {"second floor", "name: box", "name: floor", 3, "floor", "a map", "no body of the name floor"},
    // surfaces
    {"unknown material", "[ball, any]", "[ball, ice]", 26, "surfaces[0].pair[1]", "ice",
     "a material of this scene: any, ball, wood"},
    {"three materials", "[ball, any]", "[ball, any, wood]", 26, "surfaces[0].pair", "[ball, any, wood]",
     "two materials [a, b]"},
    {"repeated pair", "[rubber, lawn]", "[any, ball]", 28, "surfaces[2].pair", "[any, ball]", "each pair once"},
    {"two fallbacks", "[rubber, lawn]", "[any, lawn]", 28, "surfaces[2].pair", "[any, lawn]",
     "a law for [ball, lawn] itself"},
    {"ball named any", "material: rubber", "material: any", 22, "balls[0].material", "any", "the name of a material"},
    {"uncovered body", "[any, any]", "[handle, handle]", 26, "surfaces", "a list", "a restitution for [wood, rubber]"},
    // forces
    {"number for drag", "{gravity: 9.81}", "{drag: 0.5}", 2, "forces.drag", "0.5",
     "{coefficient: ...}, {without_spin: ..., with_spin: ..., half_at: ...}, {table: ...}, or one of default, "
     "table_rally"},
    {"unknown drag", "{gravity: 9.81}", "{drag: viscous}", 2, "forces.drag", "viscous",
     "{coefficient: ...}, {without_spin: ..., with_spin: ..., half_at: ...}, {table: ...}, or one of default, "
     "table_rally"},
    {"drag of true", "{gravity: 9.81}", "{drag: true}", 2, "forces.drag", "true", "{coefficient: ...}"},
    {"no drag", "{gravity: 9.81}", "{drag:}", 2, "forces.drag", "nothing", "a text"},
    {"empty drag", "{gravity: 9.81}", "{drag: {}}", 2, "forces.drag", "a map", "one of {coefficient: ...}"},
    {"half a drag", "{gravity: 9.81}", "{drag: {with_spin: 0.5, half_at: 0.1}}", 2, "forces.drag.without_spin",
     "missing", "C_D without spin"},
    {"drag that never grows", "{gravity: 9.81}", "{drag: {without_spin: 0.3, with_spin: 0.5, half_at: 0}}", 2,
     "forces.drag.half_at", "0", "a finite number > 0"},
    {"pushing drag", "{gravity: 9.81}", "{drag: {coefficient: -1}}", 2, "forces.drag.coefficient", "-1",
     "a finite number >= 0"},
    {"NaN drag", "{gravity: 9.81}", "{drag: {coefficient: .nan}}", 2, "forces.drag.coefficient", ".nan",
     "a finite number >= 0"},
    {"two drags", "{gravity: 9.81}", "{drag: {coefficient: 1, table: {}}}", 2, "forces.drag", "a map",
     "one of {coefficient: ...}"},
    {"drag table without rows", "{gravity: 9.81}", "{drag: {table: {reynolds: [], spin_ratio: [0], values: []}}}", 2,
     "forces.drag.table.reynolds", "[]", "a list of at least one number"},
    {"drag table not increasing", "{gravity: 9.81}",
     "{drag: {table: {reynolds: [1, 1], spin_ratio: [0], values: [[1], [1]]}}}", 2, "forces.drag.table.reynolds[1]",
     "1", "a number above the one before it"},
    {"drag table with few rows", "{gravity: 9.81}",
     "{drag: {table: {reynolds: [1, 2], spin_ratio: [0], values: [[1]]}}}", 2, "forces.drag.table.values", "a list",
     "2 rows, one for each Reynolds number"},
    {"drag table with few columns", "{gravity: 9.81}",
     "{drag: {table: {reynolds: [1, 2], spin_ratio: [0, 1], values: [[1, 1], [1]]}}}", 2, "forces.drag.table.values[1]",
     "[1]", "2 numbers, one for each spin ratio"},
    {"drag table with flat values", "{gravity: 9.81}", "{drag: {table: {reynolds: [1], spin_ratio: [0], values: [1]}}}",
     2, "forces.drag.table.values[0]", "1", "1 numbers"},
    {"drag table without values", "{gravity: 9.81}", "{drag: {table: {reynolds: [1], spin_ratio: [0]}}}", 2,
     "forces.drag.table.values", "missing", "1 rows"},
    {"unknown law", "{gravity: 9.81}", "{magnus: {law: cubic}}", 2, "forces.magnus.law", "cubic",
     "linear, saturating, constant, or table"},
    {"no law", "{gravity: 9.81}", "{magnus: {slope: 1}}", 2, "forces.magnus.law", "missing",
     "linear, saturating, constant, or table"},
    {"unknown magnus", "{gravity: 9.81}", "{magnus: strong}", 2, "forces.magnus", "strong",
     "{law: ...}, or one of default, table_rally"},
    {"no slope", "{gravity: 9.81}", "{magnus: {law: linear}}", 2, "forces.magnus.slope", "missing",
     "dC_L/dS, a number"},
    {"linear with saturation", "{gravity: 9.81}", "{magnus: {law: linear, slope: 1, saturation: 1}}", 2,
     "forces.magnus.saturation", "unknown key", "one of law, slope"},
    {"infinite slope", "{gravity: 9.81}", "{magnus: {law: linear, slope: .inf}}", 2, "forces.magnus.slope", ".inf",
     "a finite number"},
    {"negative saturation", "{gravity: 9.81}", "{magnus: {law: saturating, slope: 1, saturation: -1}}", 2,
     "forces.magnus.saturation", "-1", "a finite number >= 0"},
    {"no coefficient", "{gravity: 9.81}", "{magnus: {law: constant}}", 2, "forces.magnus.coefficient", "missing",
     "C_L, a number"},
    {"lift table from zero", "{gravity: 9.81}", "{magnus: {law: table, spin_ratio: [0, 1], values: [0, 1]}}", 2,
     "forces.magnus.spin_ratio[0]", "0", "a finite number > 0"},
    {"lift table not increasing", "{gravity: 9.81}", "{magnus: {law: table, spin_ratio: [2, 1], values: [0, 1]}}", 2,
     "forces.magnus.spin_ratio[1]", "1", "a number above the one before it"},
    {"lift table too long", "{gravity: 9.81}", "{magnus: {law: table, spin_ratio: [1], values: [0, 1]}}", 2,
     "forces.magnus.values", "[0, 1]", "1 numbers, one for each spin ratio"},
    {"unknown preset", "{gravity: 9.81}", "{preset: golf}", 2, "forces.preset", "golf",
     "one of default, table_rally, table_rally_constant_drag, half_saturating, tebbe, mujoco_deepmind, ace"},
    {"preset and drag", "{gravity: 9.81}", "{preset: ace, drag: {coefficient: 1}}", 2, "forces.preset", "ace",
     "no preset beside drag or magnus"},
    {"preset and magnus", "{gravity: 9.81}", "{magnus: ace, preset: ace}", 2, "forces.preset", "ace",
     "no preset beside drag or magnus"},
    {"wind of one number", "{gravity: 9.81}", "{wind: 3}", 2, "forces.wind", "3", "three numbers [x, y, z]"},
    {"growing spin", "{gravity: 9.81}", "{spin_decay: -0.1}", 2, "forces.spin_decay", "-0.1", "a finite number >= 0"},
    {"buoyancy of one", "{gravity: 9.81}", "{buoyancy: 1}", 2, "forces.buoyancy", "1", "true or false"},
    {"quoted added mass", "{gravity: 9.81}", "{added_mass: 'true'}", 2, "forces.added_mass", "true", "true or false"},
    {"no air", "{gravity: 9.81}", "{air: {density: 0}}", 2, "forces.air.density", "0", "a finite number > 0"},
    {"ideal air", "{gravity: 9.81}", "{air: {viscosity: 0}}", 2, "forces.air.viscosity", "0", "a finite number > 0"},
    {"two airs", "{gravity: 9.81}", "{air: {density: 1, temperature: 20}}", 2, "forces.air.temperature", "20",
     "either density or temperature"},
    {"two airs again", "{gravity: 9.81}", "{air: {density: 1, altitude: 20}}", 2, "forces.air.altitude", "20",
     "either density or temperature"},
    {"air in kelvin", "{gravity: 9.81}", "{air: {temperature: 293}}", 2, "forces.air.temperature", "293",
     "a number from -100 to 100"},
    {"air in space", "{gravity: 9.81}", "{air: {altitude: 1e5}}", 2, "forces.air.altitude", "1e5",
     "a number from -500 to 11000"},
    // contact laws
    {"growing e", "restitution: 0.8", "restitution: 0.8, restitution_slope: -0.1", 26, "surfaces[0].restitution_slope",
     "-0.1", "a finite number >= 0"},
    {"negative friction", "restitution: 0.8", "restitution: 0.8, friction: -0.1", 26, "surfaces[0].friction", "-0.1",
     "a number >= 0 or .inf"},
    {"NaN friction", "restitution: 0.8", "restitution: 0.8, friction: .nan", 26, "surfaces[0].friction", ".nan",
     "a number >= 0 or .inf"},
    {"e_t too large", "restitution: 0.8", "restitution: 0.8, friction: 1, tangential_restitution: 1.1", 26,
     "surfaces[0].tangential_restitution", "1.1", "a number from -1 to 1"},
    {"e_t without friction", "restitution: 0.8", "restitution: 0.8, tangential_restitution: 0.5", 26,
     "surfaces[0].tangential_restitution", "0.5", "it only beside a friction > 0"},
    {"rolling without friction", "restitution: 0.8", "restitution: 0.8, friction: 0, rolling_resistance: 0.5", 26,
     "surfaces[0].rolling_resistance", "0.5", "it only beside a friction > 0"},
    {"negative rolling resistance", "restitution: 0.8", "restitution: 0.8, friction: 1, rolling_resistance: -1", 26,
     "surfaces[0].rolling_resistance", "-1", "a finite number >= 0"},
    {"spin without friction", "restitution: 0.8", "restitution: 0.8, spin_friction: 0.5", 26,
     "surfaces[0].spin_friction", "0.5", "it only beside a friction > 0"},
    {"infinite spin friction", "restitution: 0.8", "restitution: 0.8, friction: 1, spin_friction: .inf", 26,
     "surfaces[0].spin_friction", ".inf", "a finite number >= 0"},
    {"unknown surface", "restitution: 0.8", "preset: ice", 26, "surfaces[0].preset", "ice",
     "one of table_match, table_rigid, table_ittf, rubber_inverted, net, floor, wall"},
    {"preset and restitution", "restitution: 0.8", "preset: net, restitution: 0.8", 26, "surfaces[0].restitution",
     "unknown key", "one of pair, preset"},
    {"preset and friction", "restitution: 0.8", "friction: 0.1, preset: net", 26, "surfaces[0].friction", "unknown key",
     "one of pair, preset"},
    {"friction alone", "restitution: 0.8", "friction: 0.1", 26, "surfaces[0].restitution", "missing",
     "a number from 0 to 1, or a preset"},
    // overlap; ball_0 has a radius of 30 mm
    {"ball in box", "[0, 0, 2]", "[0, 0, 1.02]", 16, "balls[0].position", "[0, 0, 1.02]",
     "no overlap, but ball_0 is 10 mm deep in box"},
    {"ball inside box", "[0, 0, 2]", "[0, 0, 0.9]", 16, "balls[0].position", "[0, 0, 0.9]",
     "no overlap, but ball_0 is 130 mm deep in box"},
    {"ball in floor", "[0, 0, 2]", "[3, 0, -0.48]", 16, "balls[0].position", "[3, 0, -0.48]",
     "no overlap, but ball_0 is 10 mm deep in floor"},
    {"ball in bat", "[0, 0, 2]", "[5, 0, 1.035]", 16, "balls[0].position", "[5, 0, 1.035]",
     "no overlap, but ball_0 is 5 mm deep in bat"},
    {"ball in ball", "[0, 0, 2]", "[0.951, 1, 1]", 23, "balls[1].grid.origin", "[1, 1, 1]",
     "no overlap, but ball_1 is 1 mm deep in ball_0"},
    {"narrow grid", "[0.06, 0.07, 0.08]", "0.03", 23, "balls[1].grid.origin", "[1, 1, 1]",
     "no overlap, but ball_2 is 10 mm deep in ball_1"},
};

TEST_F(SceneLoader, NamesFileLineKeyValueAndExpectation)
{
  for (const BadScene& bad : kBadScenes)
  {
    SCOPED_TRACE(bad.what);
    const std::string message = errorOf(edited(kScene, bad.from, bad.to));
    const std::string place = file() + ":" + std::to_string(bad.line) + ": " + bad.key + ": ";
    expectMessage(message, bad.value.empty() ? place : place + bad.value + ": expected " + bad.expected);
    if (!bad.value.empty()) continue;  // the library's own words, then ours
    EXPECT_NE(message.find(": expected well-formed YAML"), std::string::npos) << message;
  }
}

TEST_F(SceneLoader, NeedsSurfacesOnlyForPairsThatMeet)
{
  EXPECT_EQ(errorOf("balls: [{position: [0, 0, 1]}]"), "");
  expectMessage(errorOf("balls: [{position: [0, 0, 1]}, {position: [0, 0, 2]}]"),
                file() + ":1: surfaces: missing: expected a restitution for [ball, ball]");
  expectMessage(errorOf("floor: {}\nballs: [{position: [0, 0, 1]}]"),
                file() + ":1: surfaces: missing: expected a restitution for [ball, floor]");
}

std::vector<std::string> shippedScenes()
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(SCENES_DIR))
    if (entry.path().extension() == ".yaml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(ShippedScenes, Load)
{
  ASSERT_GE(shippedScenes().size(), 4u);
  for (const std::string& path : shippedScenes())
  {
    const Scene scene = loadScene(path);
    EXPECT_EQ(scene.name, std::filesystem::path(path).stem().string());
    EXPECT_FALSE(scene.balls.empty()) << path;
  }
}

/// All shipped scenes, with paths of URDF files that hold from any folder, and the sample scenes.
std::vector<std::string> fuzzedTexts()
{
  std::vector<std::string> texts = {kScene, kAirScene};
  for (const std::string& path : shippedScenes())
  {
    std::string text = textOf(path);
    for (std::size_t at; (at = text.find("../../urdf/")) != std::string::npos;) text.replace(at, 10, URDF_DIR);
    texts.push_back(text);
  }
  return texts;
}

TEST_F(SceneLoader, SurvivesFilesThatEndEarly)
{
  for (const std::string& text : fuzzedTexts())
    for (std::size_t size = 0; size < text.size(); ++size)
      expectLoadsOrSaysWhy([&] { load(text.substr(0, size)); }, "/", "after " + std::to_string(size) + " bytes: ");
}

TEST_F(SceneLoader, SurvivesWrongCharacters)
{
  const std::string characters = " \t\n\r\0:-[]{}#&*!|>'\"%@`,?.0123456789eEnax_\x80\xff~<";
  std::mt19937 random(1);
  for (const std::string& text : fuzzedTexts())
    for (int i = 0; i < 400; ++i)
    {
      std::string wrong = text;
      const std::size_t at = random() % text.size();
      wrong[at] = characters[random() % characters.size()];
      expectLoadsOrSaysWhy([&] { load(wrong); }, "/", "byte " + std::to_string(at) + ": ");
    }
}
}  // namespace
}  // namespace ping_pong
