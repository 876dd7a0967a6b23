// Lines of text over the 3D view, one texel per pixel.
#pragma once

#include <OgreMaterial.h>
#include <OgreTexture.h>

#include <QColor>
#include <QString>
#include <string>
#include <utility>
#include <vector>

class QImage;

namespace Ogre
{
class Overlay;
class PanelOverlayElement;
}  // namespace Ogre

namespace ping_pong_sim
{
class TextPanel
{
public:
  using Line = std::pair<QString, QColor>;

  TextPanel();
  ~TextPanel();
  TextPanel(const TextPanel&) = delete;
  TextPanel& operator=(const TextPanel&) = delete;

  /// @param size        height of the letters [pixels]
  /// @param background  its alpha counts
  void draw(const std::vector<Line>& lines, int size, const QColor& background);
  /// @param left, top  of the view [pixels]
  void place(int left, int top);
  void show(bool shown);

private:
  void upload(const QImage& image);

  std::string name_;
  Ogre::Overlay* overlay_;
  Ogre::PanelOverlayElement* panel_;
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
};
}  // namespace ping_pong_sim
