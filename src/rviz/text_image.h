// Lines of text as a picture.
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <utility>
#include <vector>

namespace ping_pong_sim
{
using ColoredLine = std::pair<QString, QColor>;

/// @param size        height of the letters [pixels]
/// @param background  its alpha counts
QImage textImage(const std::vector<ColoredLine>& lines, int size, const QColor& background);
}  // namespace ping_pong_sim
