#include "windows/ball_cache.h"

#include "base/prefault.h"
#include "state/world_state.h"

namespace ping_pong
{
namespace
{
constexpr std::uint8_t kAskRecord = 0, kAway = 1;

GlanceKind::How howOf(const BallRecord& ball)
{
  if (ball.away()) return GlanceKind::How::Away;
  if (ball.path.degree == 2) return GlanceKind::How::Flies;
  return ball.path.degree == 0 ? GlanceKind::How::Lies : GlanceKind::How::AskRecord;
}
}  // namespace

void Glances::reserve(std::size_t balls)
{
  takeMemory(list_, balls);
  kinds_.reserve(kMostKinds);
}

bool Glances::is(std::uint8_t kind, const BallRecord& ball) const
{
  const GlanceKind& it = kinds_[kind];
  return it.how == howOf(ball) && it.radius == ball.params().radius &&
         (it.how == GlanceKind::How::Lies || it.half_a == ball.path.c[2]);
}

std::uint8_t Glances::kindFor(const BallRecord& ball, std::uint8_t guess) const
{
  if (ball.away()) return kAway;
  if (is(guess, ball)) return guess;
  for (std::size_t kind = kAway + 1; kind < kinds_.size(); ++kind)
    if (is(static_cast<std::uint8_t>(kind), ball)) return static_cast<std::uint8_t>(kind);
  return kAskRecord;
}

float Glances::lookAt(const BallRecord& ball, std::size_t i, bool bent)
{
  Glance& glance = list_[i];
  glance.version = static_cast<std::uint16_t>(ball.version);
  glance.kind = kindFor(ball, glance.kind);
  glance.bent = bent;
  glance.start = ball.path.start;
  glance.p = ball.path.c[0];
  glance.v = ball.path.degree == 0 ? Vector3d(Vector3d::Zero()) : ball.path.c[1];
  return floatBefore(std::min(ball.next.time, ball.meetsMoving()));
}

// The kinds are found here: while windows run, several workers read them.
void Glances::lookAtAll(const std::vector<BallRecord>& balls, std::uint32_t edits)
{
  kinds_.resize(2);
  kinds_[kAway].how = GlanceKind::How::Away;
  list_.assign(balls.size(), Glance());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const BallRecord& ball = balls[i];
    list_[i].setNext(lookAt(ball, i, false));
    const GlanceKind::How how = howOf(ball);
    const bool new_kind = list_[i].kind == kAskRecord && how != GlanceKind::How::AskRecord;
    const bool rolls = how == GlanceKind::How::Flies && !ball.supports.none();
    if (!new_kind || rolls || kinds_.size() == kMostKinds) continue;
    kinds_.push_back(
        {how, ball.params().radius, how == GlanceKind::How::Flies ? ball.path.c[2] : Vector3d(Vector3d::Zero())});
    list_[i].kind = static_cast<std::uint8_t>(kinds_.size() - 1);
  }
  known_ = edits;
}
}  // namespace ping_pong
