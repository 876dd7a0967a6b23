#include "image_panel.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <Overlay/OgreOverlay.h>
#include <Overlay/OgreOverlayContainer.h>
#include <Overlay/OgreOverlayManager.h>
#include <Overlay/OgrePanelOverlayElement.h>

#include <QImage>

namespace ping_pong_sim
{
namespace
{
std::string uniqueName()
{
  static int count = 0;
  return "ping_pong_image_" + std::to_string(count++);
}
}  // namespace

ImagePanel::ImagePanel() : name_(uniqueName())
{
  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  overlay_ = overlays.create(name_);
  panel_ = static_cast<Ogre::PanelOverlayElement*>(overlays.createOverlayElement("Panel", name_));
  panel_->setMetricsMode(Ogre::GMM_PIXELS);
  material_ = Ogre::MaterialManager::getSingleton().create(name_, Ogre::RGN_DEFAULT);
  Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);
  pass->setDepthCheckEnabled(false);
  pass->setDepthWriteEnabled(false);
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  panel_->setMaterialName(name_, Ogre::RGN_DEFAULT);
  overlay_->add2D(panel_);
}

ImagePanel::~ImagePanel()
{
  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  overlay_->remove2D(panel_);
  overlays.destroyOverlayElement(panel_);
  overlays.destroy(overlay_);
  Ogre::MaterialManager::getSingleton().remove(material_);
  if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
}

void ImagePanel::draw(const QImage& image)
{
  empty_ = image.isNull();
  width_ = image.width();
  height_ = image.height();
  if (!empty_) upload(image);
  update();
}

void ImagePanel::place(int left, int top)
{
  panel_->setPosition(static_cast<Ogre::Real>(left), static_cast<Ogre::Real>(top));
}

void ImagePanel::show(bool shown)
{
  shown_ = shown;
  update();
}

void ImagePanel::update()
{
  if (shown_ && !empty_)
    overlay_->show();
  else
    overlay_->hide();
}

void ImagePanel::upload(const QImage& image)
{
  const auto width = static_cast<Ogre::uint32>(image.width());
  const auto height = static_cast<Ogre::uint32>(image.height());
  if (!texture_ || texture_->getWidth() != width || texture_->getHeight() != height)
  {
    Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
    pass->removeAllTextureUnitStates();
    if (texture_) Ogre::TextureManager::getSingleton().remove(texture_);
    texture_ = Ogre::TextureManager::getSingleton().createManual(name_, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, width,
                                                                 height, 0, Ogre::PF_A8R8G8B8, Ogre::TU_DEFAULT);
    pass->createTextureUnitState(name_)->setTextureFiltering(Ogre::TFO_NONE);
    panel_->setDimensions(static_cast<Ogre::Real>(width), static_cast<Ogre::Real>(height));
  }
  const Ogre::PixelBox pixels(width, height, 1, Ogre::PF_A8R8G8B8, const_cast<uchar*>(image.constBits()));
  texture_->getBuffer()->blitFromMemory(pixels);
}
}  // namespace ping_pong_sim
