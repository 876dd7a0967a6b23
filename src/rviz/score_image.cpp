#include "score_image.h"

#include <QFontDatabase>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

namespace ping_pong_sim
{
namespace
{
const QColor kBright(236, 240, 248);
const QColor kFaint(170, 182, 200);
const QColor kGold(255, 214, 120);

QFont fontOf(int size, bool bold)
{
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(size);
  font.setBold(bold);
  return font;
}

/// Sizes in pixels that belong to one size of letters.
struct Layout
{
  explicit Layout(int letters)
      : size(letters), row(letters * 2), points(letters * 3 / 2), small(letters * 3 / 4), margin(letters / 2)
  {
  }
  int size, row, points, small, margin;
};

void drawRow(QPainter& painter, const Layout& layout, const ScoreBoard& board, std::size_t player, const QRect& row)
{
  const Score& score = board.score;
  const bool serves = score.server == player && score.winner < 0;
  if (serves)
  {
    painter.setBrush(kGold);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPoint(row.left() + layout.margin, row.center().y()), layout.size / 4, layout.size / 4);
  }
  QString name = QString::fromStdString(score.players[player]);
  if (board.player >= 0 && static_cast<int>(player) != board.player && board.level > 0)
    name += QString("  level %1").arg(board.level);
  painter.setPen(score.winner == static_cast<int>(player) ? kGold : kBright);
  painter.setFont(fontOf(layout.size, true));
  painter.drawText(row.adjusted(2 * layout.margin + layout.size / 4, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, name);
  painter.setFont(fontOf(layout.points, true));
  painter.setPen(kGold);
  painter.drawText(row.adjusted(0, 0, -layout.margin, 0), Qt::AlignVCenter | Qt::AlignRight,
                   QString::number(score.points[player]));
  painter.setFont(fontOf(layout.size, false));
  painter.setPen(kFaint);
  painter.drawText(row.adjusted(0, 0, -layout.points * 2 - layout.margin, 0), Qt::AlignVCenter | Qt::AlignRight,
                   QString::number(score.games[player]));
}

QString calledLine(const ScoreBoard& board)
{
  if (board.call != nullptr) return QString::fromStdString(callText(*board.call, board.score));
  if (board.score.winner >= 0)
    return QString::fromStdString(board.score.players[static_cast<std::size_t>(board.score.winner)]) +
           " wins the match";
  if (board.score.expedite) return "Expedite";
  return board.score.deuce ? "Deuce" : "";
}
}  // namespace

QImage scoreImage(const ScoreBoard& board, int size, const QColor& background)
{
  const Layout layout(size);
  const QString call = calledLine(board);
  const QFontMetrics call_metrics(fontOf(layout.size, false));
  const int board_width = layout.size * 18;
  const int width = (std::max(board_width, call_metrics.horizontalAdvance(call) + 4 * layout.margin) + 31) / 32 * 32;
  const int board_height = 2 * layout.row + layout.small * 2 + layout.margin;
  const int call_height = call.isEmpty() ? 0 : layout.row;
  QImage image(width, board_height + call_height, QImage::Format_ARGB32);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRect frame((width - board_width) / 2, 0, board_width, board_height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(background);
  painter.drawRoundedRect(frame, layout.margin, layout.margin);
  if (!call.isEmpty())
  {
    painter.drawRoundedRect(QRect(0, board_height + 2, width, call_height - 2), layout.margin, layout.margin);
    painter.setPen(kBright);
    painter.setFont(fontOf(layout.size, false));
    painter.drawText(QRect(0, board_height + 2, width, call_height - 2), Qt::AlignCenter, call);
  }
  for (std::size_t player = 0; player < 2; ++player)
  {
    const QRect row(frame.left() + layout.margin, static_cast<int>(player) * layout.row + layout.margin / 2,
                    board_width - 2 * layout.margin, layout.row);
    drawRow(painter, layout, board, player, row);
  }
  painter.setPen(kFaint);
  painter.setFont(fontOf(layout.small, false));
  painter.drawText(QRect(frame.left(), 2 * layout.row, board_width, layout.small * 2 + layout.margin), Qt::AlignCenter,
                   QString::fromStdString(strokeText(board.score)));
  return image;
}
}  // namespace ping_pong_sim
