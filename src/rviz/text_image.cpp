#include "text_image.h"

#include <QFontDatabase>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

namespace ping_pong_sim
{
namespace
{
constexpr int kMargin = 8;  ///< [pixels]
}  // namespace

QImage textImage(const std::vector<ColoredLine>& lines, int size, const QColor& background)
{
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPixelSize(size);
  const QFontMetrics metrics(font);
  int width = 0;
  for (const ColoredLine& line : lines) width = std::max(width, metrics.horizontalAdvance(line.first));
  const int height = metrics.lineSpacing() * static_cast<int>(lines.size());
  // Few sizes: a number that grows by a digit needs no new texture.
  QImage image((width + 2 * kMargin + 31) / 32 * 32, height + 2 * kMargin, QImage::Format_ARGB32);
  image.fill(background);
  QPainter painter(&image);
  painter.setFont(font);
  int y = kMargin + metrics.ascent();
  for (const ColoredLine& line : lines)
  {
    painter.setPen(line.second);
    painter.drawText(kMargin, y, line.first);
    y += metrics.lineSpacing();
  }
  return image;
}
}  // namespace ping_pong_sim
