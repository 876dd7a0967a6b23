#include "windows/ball_cache.h"

#include "base/prefault.h"
#include "state/world_state.h"

namespace ping_pong
{
namespace
{
constexpr std::uint8_t kAskRecord = 0, kAway = 1;

CachedType::How howOf(const BallRecord& ball)
{
  if (ball.away()) return CachedType::How::Away;
  if (ball.path.degree == 2) return CachedType::How::Flies;
  return ball.path.degree == 0 ? CachedType::How::Lies : CachedType::How::AskRecord;
}
}  // namespace

void BallCache::reserve(std::size_t balls)
{
  takeMemory(list_, balls);
  types_.reserve(kMostTypes);
}

bool BallCache::is(std::uint8_t type, const BallRecord& ball) const
{
  const CachedType& it = types_[type];
  return it.how == howOf(ball) && it.radius == ball.params().radius &&
         (it.how == CachedType::How::Lies || it.half_a == ball.path.c[2]);
}

std::uint8_t BallCache::typeFor(const BallRecord& ball, std::uint8_t guess) const
{
  if (ball.away()) return kAway;
  if (is(guess, ball)) return guess;
  for (std::size_t type = kAway + 1; type < types_.size(); ++type)
    if (is(static_cast<std::uint8_t>(type), ball)) return static_cast<std::uint8_t>(type);
  return kAskRecord;
}

float BallCache::read(const BallRecord& ball, std::size_t i, bool left_path)
{
  CachedBall& cached = list_[i];
  cached.version = static_cast<std::uint16_t>(ball.version);
  cached.type = typeFor(ball, cached.type);
  cached.left_path = left_path;
  cached.start = ball.path.start;
  cached.p = ball.path.c[0];
  cached.v = ball.path.degree == 0 ? Vector3d(Vector3d::Zero()) : ball.path.c[1];
  return floatBefore(std::min(ball.next.time, ball.meetsMoving()));
}

// The types are found here: while windows run, several workers read them.
void BallCache::readAll(const std::vector<BallRecord>& balls, std::uint32_t edits)
{
  types_.resize(2);
  types_[kAway].how = CachedType::How::Away;
  list_.assign(balls.size(), CachedBall());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const BallRecord& ball = balls[i];
    list_[i].setNext(read(ball, i, false));
    const CachedType::How how = howOf(ball);
    const bool new_type = list_[i].type == kAskRecord && how != CachedType::How::AskRecord;
    const bool rolls = how == CachedType::How::Flies && !ball.supports.none();
    if (!new_type || rolls || types_.size() == kMostTypes) continue;
    types_.push_back(
        {how, ball.params().radius, how == CachedType::How::Flies ? ball.path.c[2] : Vector3d(Vector3d::Zero())});
    list_[i].type = static_cast<std::uint8_t>(types_.size() - 1);
  }
  known_ = edits;
}
}  // namespace ping_pong
