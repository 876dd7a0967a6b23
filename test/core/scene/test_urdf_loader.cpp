// Bodies: URDF files give the shapes of the physics; bad ones name file, line, element, value and what was expected.
#include <iostream>
#include <random>

#include "testing/load_checks.h"

namespace ping_pong
{
namespace
{
// The line numbers in the table of errors count from the first line of this text.
constexpr char kUrdf[] = R"(<?xml version="1.0"?>
<robot name="sample">
  <material name="blue"><color rgba="0 0 1 1"/></material>
  <link name="body">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <visual><geometry><mesh filename="package://sample/body.dae"/></geometry><material name="blue"/></visual>
    <collision name="plate">
      <origin xyz="1 2 3" rpy="0.3 -0.4 0.5"/>
      <geometry><box size="0.2 0.4 0.6"/></geometry>
    </collision>
    <collision>
      <origin xyz="0 0 -1"/>
      <geometry><cylinder radius="0.1" length="0.5"/></geometry>
    </collision>
    <collision name="plate">
      <geometry><sphere radius="2.5e-1"/></geometry>
    </collision>
  </link>
</robot>
)";

class UrdfLoader : public ::testing::Test
{
protected:
  std::vector<Shape> load(const std::string& text) { return loadShapes(folder_.write("body.urdf", text), materials_); }
  std::string errorOf(const std::string& text)
  {
    return loadErrorOf([&] { load(text); });
  }
  std::string file() const { return folder_.path("body.urdf"); }

  TempFolder folder_;
  std::vector<std::string> materials_ = {"ball"};
};

TEST_F(UrdfLoader, ReadsShapesInTheLinkFrame)
{
  const std::vector<Shape> shapes = load(kUrdf);
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[0].kind, ShapeKind::Box);
  EXPECT_EQ(shapes[0].half_size, Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(shapes[0].p_BS, Vector3d(1, 2, 3));
  EXPECT_EQ(shapes[1].kind, ShapeKind::Cylinder);
  EXPECT_EQ(shapes[1].half_size, Vector3d(0.1, 0.1, 0.25));
  EXPECT_EQ(shapes[1].p_BS, Vector3d(0, 0, -1));
  EXPECT_EQ(shapes[1].R_BS, Matrix3d::Identity());
  EXPECT_EQ(shapes[2].kind, ShapeKind::Sphere);
  EXPECT_EQ(shapes[2].half_size, Vector3d(0.25, 0.25, 0.25));
}

TEST_F(UrdfLoader, TurnsShapesByRollPitchYawAboutFixedAxes)
{
  const auto rotation = [](double angle, const Vector3d& axis)
  { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); };
  const Matrix3d expected =
      rotation(0.5, Vector3d::UnitZ()) * rotation(-0.4, Vector3d::UnitY()) * rotation(0.3, Vector3d::UnitX());
  EXPECT_LT((load(kUrdf)[0].R_BS - expected).norm(), 1e-15);  // a few roundings
}

TEST_F(UrdfLoader, TakesMaterialsFromCollisionsOrTheLink)
{
  const std::vector<Shape> shapes = load(kUrdf);
  EXPECT_EQ(materials_, (std::vector<std::string>{"ball", "plate", "body"}));
  EXPECT_EQ(shapes[0].material, 1);
  EXPECT_EQ(shapes[1].material, 2);
  EXPECT_EQ(shapes[2].material, 1);
}

TEST_F(UrdfLoader, ReadsNumbersWhateverTheLocale)
{
  const DecimalComma comma;
  EXPECT_EQ(load(kUrdf)[2].half_size, Vector3d(0.25, 0.25, 0.25));
}

TEST_F(UrdfLoader, KeepsUrdfdomQuietAndPassesOnWhatItSays)
{
  // The check looks at collisions; what is wrong elsewhere only urdfdom finds.
  const std::string bad_visual =
      edited(kUrdf, R"(<mesh filename="package://sample/body.dae"/>)", "<box size=\"1 b\"/>");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string message = errorOf(bad_visual);
  std::cout.flush();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  expectMessage(message, file() + ":4: robot/link: ");
  EXPECT_NE(message.find("isual"), std::string::npos) << message;
  EXPECT_NE(message.find(": expected a model that urdfdom accepts"), std::string::npos) << message;
}

TEST_F(UrdfLoader, SaysThatAFileIsMissing)
{
  const std::string missing = folder_.path("no.urdf");
  expectMessage(loadErrorOf([&] { loadShapes(missing, materials_); }),
                missing + ":1: robot: No such file or directory: expected a readable URDF file");
}

struct BadUrdf
{
  const char* what;
  std::string from, to;  ///< edit of kUrdf
  int line;
  std::string key, value, expected;
};

const char kCollision[] = "robot/link/collision";
const std::string kGeometry = std::string(kCollision) + "/geometry";
const std::string kOrigin = std::string(kCollision) + "/origin";

const BadUrdf kBadUrdfs[] = {
    {"not XML", "</link>", "</lnk>", 4, "robot", "XML_ERROR_MISMATCHED_ELEMENT", "well-formed XML"},
    {"empty file", kUrdf, "", 1, "robot", "XML_ERROR_EMPTY_DOCUMENT", "well-formed XML"},
    {"another root", kUrdf, "<sdf/>", 1, "sdf", "unknown element", "robot as the outermost element"},
    {"two roots", "</robot>", "</robot><robot/>", 19, "robot", "second element", "one outermost element"},
    {"no link", kUrdf, "<robot name=\"a\"/>", 1, "robot", "no link", "one link"},
    {"two links", "</link>", "</link><link name=\"b\"/>", 18, "robot/link", "second link", "one link"},
    {"joint", "</link>", "</link><joint name=\"b\"/>", 18, "robot/joint", "joint",
     "no joints: one file is one rigid body"},
    {"robot without name", " name=\"sample\"", "", 2, "robot.name", "missing", "a name"},
    {"link without name", "<link name=\"body\"", "<link", 4, "robot/link.name", "missing", "a name"},
    {"empty link name", "<link name=\"body\"", "<link name=\"\"", 4, "robot/link.name", "\"\"", "a name"},
    {"misspelt collision",
     "<collision name=\"plate\">\n      <geometry><sphere radius=\"2.5e-1\"/></geometry>\n    </collision>",
     "<colision/>", 15, "robot/link/colision", "unknown element", "one of visual, collision, inertial"},
    {"no collision", kUrdf, "<robot name=\"a\"><link name=\"a\"/></robot>", 1, "robot/link", "no collision",
     "at least one"},
    {"unknown element in collision", "<collision>", "<collision><mass/>", 11, "robot/link/collision/mass",
     "unknown element", "one of origin, geometry"},
    {"unknown attribute of collision", "<collision>", "<collision group=\"a\">", 11, "robot/link/collision.group", "a",
     "no attribute other than name"},
    {"empty material", "<collision>", "<collision name=\"\">", 11, "robot/link/collision.name", "\"\"", "a name"},
    {"material any", "<collision>", "<collision name=\"any\">", 11, kCollision, "any", "another name"},
    {"text in collision", "<collision>", "<collision>soft", 11, kCollision, "text", "no text in this element"},
    {"second origin", "<origin xyz=\"0 0 -1\"/>", "<origin/><origin/>", 12, kOrigin, "second origin", "one"},
    {"second geometry", "<geometry><sphere", "<geometry/><geometry><sphere", 16, kGeometry, "second geometry", "one"},
    {"no geometry", "<geometry><sphere radius=\"2.5e-1\"/></geometry>", "", 15, kCollision, "no geometry",
     "one geometry"},
    {"no shape", "<sphere radius=\"2.5e-1\"/>", "", 16, kGeometry, "no shape", "box, cylinder or sphere as collision"},
    {"mesh", "<sphere radius=\"2.5e-1\"/>", "<mesh filename=\"a.stl\"/>", 16, kGeometry + "/mesh", "mesh",
     "box, cylinder or sphere as collision"},
    {"capsule", "<sphere radius", "<capsule radius", 16, kGeometry + "/capsule", "unknown element",
     "one of box, cylinder, sphere"},
    {"two shapes", "<sphere radius", "<sphere radius=\"1\"/><sphere radius", 16, kGeometry + "/sphere", "second shape",
     "one shape"},
    {"unknown attribute of origin", "xyz=\"0 0 -1\"", "xyzzy=\"0 0 -1\"", 12, kOrigin + ".xyzzy", "0 0 -1",
     "no attribute other than xyz, rpy"},
    {"two numbers", "0 0 -1", "0 -1", 12, kOrigin + ".xyz", "0 -1", "three finite numbers"},
    {"four numbers", "0 0 -1", "0 0 0 -1", 12, kOrigin + ".xyz", "0 0 0 -1", "three finite numbers"},
    {"NaN", "0 0 -1", "0 0 nan", 12, kOrigin + ".xyz", "0 0 nan", "three finite numbers"},
    {"infinite angle", "0.3 -0.4 0.5", "0 inf 0", 8, kOrigin + ".rpy", "0 inf 0", "three finite numbers"},
    {"text for number", "0 0 -1", "0 0 low", 12, kOrigin + ".xyz", "0 0 low", "three finite numbers"},
    {"repeated attribute", "xyz=\"0 0 -1\"", "xyz=\"0 0 1\" xyz=\"0 0 2\"", 12, "robot", "XML_ERROR_PARSING_ATTRIBUTE",
     "well-formed XML"},
    {"no size", " size=\"0.2 0.4 0.6\"", "", 9, kGeometry + "/box.size", "missing", "3 finite numbers > 0"},
    {"zero size", "0.2 0.4 0.6", "0.2 0 0.6", 9, kGeometry + "/box.size", "0.2 0 0.6", "3 finite numbers > 0"},
    {"negative size", "0.2 0.4 0.6", "0.2 -0.4 0.6", 9, kGeometry + "/box.size", "0.2 -0.4 0.6",
     "3 finite numbers > 0"},
    {"infinite size", "0.2 0.4 0.6", "0.2 1e999 0.6", 9, kGeometry + "/box.size", "0.2 1e999 0.6",
     "3 finite numbers > 0"},
    {"no length", " length=\"0.5\"", "", 13, kGeometry + "/cylinder.length", "missing", "a finite number > 0"},
    {"zero length", "length=\"0.5\"", "length=\"0\"", 13, kGeometry + "/cylinder.length", "0", "a finite number > 0"},
    {"unknown attribute", "length=\"0.5\"", "length=\"0.5\" axis=\"x\"", 13, kGeometry + "/cylinder.axis", "x",
     "no attribute other than radius, length"},
    {"decimal comma", "2.5e-1", "0,25", 16, kGeometry + "/sphere.radius", "0,25", "a finite number > 0"},
    {"negative radius", "2.5e-1", "-2", 16, kGeometry + "/sphere.radius", "-2", "a finite number > 0"},
};

TEST_F(UrdfLoader, NamesFileLineElementValueAndExpectation)
{
  for (const BadUrdf& bad : kBadUrdfs)
  {
    SCOPED_TRACE(bad.what);
    expectMessage(errorOf(edited(kUrdf, bad.from, bad.to)), file() + ":" + std::to_string(bad.line) + ": " + bad.key +
                                                                ": " + bad.value + ": expected " + bad.expected);
  }
}

std::vector<std::string> shippedUrdfs()
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(URDF_DIR))
    if (entry.path().extension() == ".urdf") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(ShippedUrdfs, Load)
{
  std::vector<std::string> materials;
  for (const std::string& path : shippedUrdfs()) EXPECT_FALSE(loadShapes(path, materials).empty()) << path;
}

std::vector<std::string> fuzzedTexts()
{
  std::vector<std::string> texts = {kUrdf};
  for (const std::string& path : shippedUrdfs()) texts.push_back(textOf(path));
  return texts;
}

TEST_F(UrdfLoader, SurvivesFilesThatEndEarly)
{
  for (const std::string& text : fuzzedTexts())
    for (std::size_t size = 0; size < text.size(); ++size)
      expectLoadsOrSaysWhy([&] { load(text.substr(0, size)); }, file(), "after " + std::to_string(size) + " bytes: ");
}

TEST_F(UrdfLoader, SurvivesWrongCharacters)
{
  const std::string characters = " \t\n\r</>=\"'&;!?-.0123456789eEnax_\x80\xff";
  std::mt19937 random(1);
  for (const std::string& text : fuzzedTexts())
    for (int i = 0; i < 1000; ++i)
    {
      std::string wrong = text;
      const std::size_t at = random() % text.size();
      wrong[at] = characters[random() % characters.size()];
      expectLoadsOrSaysWhy([&] { load(wrong); }, file(), "byte " + std::to_string(at) + ": ");
    }
}
}  // namespace
}  // namespace ping_pong
