#include "shadow_rig.h"

#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreResourceGroupManager.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>
#include <sys/stat.h>

#include <algorithm>
#include <map>

namespace ping_pong_sim
{
namespace
{
constexpr char kPrograms[] = "/usr/share/OGRE/Media/ShadowVolume";  ///< part of Ogre itself
constexpr char kGroup[] = "ping_pong_shadows";
constexpr unsigned short kTextureSize = 1024;

/// Ogre wants these programs even for texture shadows, and ends RViz without them.
bool loadPrograms()
{
  static bool loaded = false;
  struct stat info;
  if (loaded || stat(kPrograms, &info) != 0) return loaded;
  Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
  groups.createResourceGroup(kGroup, true);  // Ogre looks for them by name alone
  groups.addResourceLocation(kPrograms, "FileSystem", kGroup);
  groups.initialiseResourceGroup(kGroup);
  return loaded = true;
}

bool isClear(const Ogre::Entity& entity)
{
  for (std::size_t i = 0; i < entity.getNumSubEntities(); ++i)
  {
    const Ogre::MaterialPtr material = entity.getSubEntity(i)->getMaterial();
    if (material && material->isTransparent()) return true;
  }
  return false;
}

bool containsAny(const std::string& text, const std::vector<std::string>& parts)
{
  return std::any_of(parts.begin(), parts.end(),
                     [&](const std::string& part) { return text.find(part) != std::string::npos; });
}

unsigned short shadowUnits(const Ogre::Pass& pass)
{
  unsigned short count = 0;
  for (const Ogre::TextureUnitState* unit : pass.getTextureUnitStates())
    count += unit->getContentType() == Ogre::TextureUnitState::CONTENT_SHADOW ? 1 : 0;
  return count;
}

void addShadowUnit(Ogre::Pass& pass)
{
  Ogre::TextureUnitState* unit = pass.createTextureUnitState();
  unit->setContentType(Ogre::TextureUnitState::CONTENT_SHADOW);
  unit->setColourOperation(Ogre::LBO_MODULATE);
  // No shadow beyond the picture of what casts them.
  unit->setTextureAddressingMode(Ogre::TextureUnitState::TAM_BORDER);
  unit->setTextureBorderColour(Ogre::ColourValue::White);
  unit->setTextureFiltering(Ogre::FO_LINEAR, Ogre::FO_LINEAR, Ogre::FO_NONE);
}

/// A shadow is one more texture of the surface that takes it: drawing the surface again for it costs three times as much.
void takeShadows(Ogre::Entity& entity, std::size_t lights)
{
  for (std::size_t i = 0; i < entity.getNumSubEntities(); ++i)
  {
    const Ogre::MaterialPtr material = entity.getSubEntity(i)->getMaterial();
    if (!material || material->getNumTechniques() == 0) continue;
    Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
    for (std::size_t has = shadowUnits(pass); has < lights; ++has) addShadowUnit(pass);
    for (std::size_t has = shadowUnits(pass); has > lights; --has)  // ours are the last ones
      pass.removeTextureUnitState(static_cast<unsigned short>(pass.getNumTextureUnitStates() - 1));
  }
}
}  // namespace

/// RViz finds out what is under the mouse by rendering with a material scheme of its own, whose handler ends RViz when
/// the shadow pass asks it. So there are no shadows in such a view.
class ShadowRig::PickGuard : public Ogre::SceneManager::Listener
{
public:
  explicit PickGuard(Ogre::SceneManager* scene) : scene_(scene) { scene_->addListener(this); }
  ~PickGuard() override { scene_->removeListener(this); }

  void preUpdateSceneGraph(Ogre::SceneManager* /*scene*/, Ogre::Camera* camera) override
  {
    guard(camera->getViewport());
  }
  void preFindVisibleObjects(Ogre::SceneManager* /*scene*/, Ogre::SceneManager::IlluminationRenderStage /*stage*/,
                             Ogre::Viewport* viewport) override
  {
    guard(viewport);
  }

private:
  static void guard(Ogre::Viewport* viewport)
  {
    if (viewport != nullptr && viewport->getMaterialScheme() != Ogre::MaterialManager::DEFAULT_SCHEME_NAME)
    {
      viewport->setShadowsEnabled(false);
    }
  }
  Ogre::SceneManager* scene_;
};

std::shared_ptr<ShadowRig> ShadowRig::of(Ogre::SceneManager* scene)
{
  static std::map<Ogre::SceneManager*, std::weak_ptr<ShadowRig>> rigs;
  std::shared_ptr<ShadowRig> rig = rigs[scene].lock();
  if (!rig) rigs[scene] = rig = std::shared_ptr<ShadowRig>(new ShadowRig(scene));
  return rig;
}

ShadowRig::ShadowRig(Ogre::SceneManager* scene) : scene_(scene), guard_(std::make_unique<PickGuard>(scene))
{
  if (!loadPrograms()) problem_ = std::string("Ogre's shadow programs are missing: ") + kPrograms;
}

ShadowRig::~ShadowRig()
{
  casting_.clear();
  update();
}

void ShadowRig::setLight(const Ogre::Light* light, bool casts)
{
  const std::size_t before = casting_.size();
  if (casts && problem_.empty())
    casting_.insert(light);
  else
    casting_.erase(light);
  if (casting_.size() != before) update();
}

void ShadowRig::setShade(float shade)
{
  shade_ = Ogre::ColourValue(shade, shade, shade);
  if (!casting_.empty()) scene_->setShadowColour(shade_);
}

void ShadowRig::setRoles(const std::vector<std::string>& receivers, const std::vector<std::string>& silent)
{
  receivers_ = receivers;
  silent_ = silent;
}

void ShadowRig::update()
{
  assignRoles();
  if (casting_.empty())
  {
    scene_->setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    return;
  }
  scene_->setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED);
  scene_->setShadowTextureSelfShadow(false);
  scene_->setShadowTextureCount(casting_.size());
  scene_->setShadowTextureSize(kTextureSize);  // after the count: new textures are small
  scene_->setShadowColour(shade_);
  scene_->setShadowDirectionalLightExtrusionDistance(15.0f);
  scene_->setShadowFarDistance(12.0f);
}

void ShadowRig::assignRoles()
{
  for (const auto& object : scene_->getMovableObjects("Entity"))
  {
    auto& entity = static_cast<Ogre::Entity&>(*object.second);
    const std::string& mesh = entity.getMesh()->getName();
    const bool silent = containsAny(mesh, silent_);
    const bool receives = !silent && containsAny(mesh, receivers_);
    // Cones are arrowheads: handles, the lights' own bulbs.
    const bool casts = !silent && !receives && !isClear(entity) && mesh.find("rviz_cone") == std::string::npos;
    if (entity.getCastShadows() != casts) entity.setCastShadows(casts);
    takeShadows(entity, receives && !isClear(entity) ? casting_.size() : 0);
  }
  for (const char* type : {"ManualObject", "BillboardChain", "BillboardSet"})
  {
    for (const auto& object : scene_->getMovableObjects(type)) object.second->setCastShadows(false);
  }
}
}  // namespace ping_pong_sim
