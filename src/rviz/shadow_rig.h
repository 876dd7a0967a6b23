// Shadows of the scene: one set of rules for all lights that cast them. RViz has none of its own, and gets back what it
// had when the last light lets go.
#pragma once

#include <OgreColourValue.h>
#include <OgreSceneManager.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ping_pong_sim
{
class ShadowRig
{
public:
  /// The rig of a scene, shared by its lights; it ends with the last of them.
  static std::shared_ptr<ShadowRig> of(Ogre::SceneManager* scene);
  ~ShadowRig();
  ShadowRig(const ShadowRig&) = delete;
  ShadowRig& operator=(const ShadowRig&) = delete;

  /// Empty, or why there are no shadows.
  const std::string& problem() const { return problem_; }
  /// @param casts  false: the light is there and casts none
  void setLight(const Ogre::Light* light, bool casts);
  void removeLight(const Ogre::Light* light) { setLight(light, false); }
  /// @param shade  how much light stays in a shadow, 0 to 1
  void setShade(float shade);
  /// Parts of mesh names. What throws a shadow takes none, and a shadow falls on whatever is in line with the light,
  /// also above its thrower.
  /// @param receivers  surfaces that take shadows and throw none
  /// @param silent     what neither takes nor throws any
  void setRoles(const std::vector<std::string>& receivers, const std::vector<std::string>& silent);
  /// Now and then: new things in the scene get their roles.
  void assignRoles();

private:
  explicit ShadowRig(Ogre::SceneManager* scene);
  void update();

  class PickGuard;
  Ogre::SceneManager* scene_;
  std::unique_ptr<PickGuard> guard_;
  std::set<const Ogre::Light*> casting_;
  std::vector<std::string> receivers_;
  std::vector<std::string> silent_;
  Ogre::ColourValue shade_{0.45f, 0.45f, 0.45f};
  std::string problem_;
};
}  // namespace ping_pong_sim
