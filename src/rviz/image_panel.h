// A picture over the 3D view, one texel per pixel.
#pragma once

#include <OgreMaterial.h>
#include <OgreTexture.h>

#include <string>

class QImage;

namespace Ogre
{
class Overlay;
class PanelOverlayElement;
}  // namespace Ogre

namespace ping_pong_sim
{
class ImagePanel
{
public:
  ImagePanel();
  ~ImagePanel();
  ImagePanel(const ImagePanel&) = delete;
  ImagePanel& operator=(const ImagePanel&) = delete;

  /// Null: nothing is shown until there is a picture again.
  void draw(const QImage& image);
  /// @param left, top  of the view [pixels]
  void place(int left, int top);
  void show(bool shown);
  int width() const { return width_; }
  int height() const { return height_; }

private:
  void upload(const QImage& image);
  void update();

  std::string name_;
  Ogre::Overlay* overlay_;
  Ogre::PanelOverlayElement* panel_;
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
  bool shown_ = false;
  bool empty_ = true;
  int width_ = 0;   ///< [pixels]
  int height_ = 0;  ///< [pixels]
};
}  // namespace ping_pong_sim
