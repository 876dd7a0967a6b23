// Lengths that are none, for all who ask where a ball may be.
#pragma once

namespace ping_pong
{
/// Overlap that still counts as touching: far above the rounding of places in a hall (1e-15 m), far below what one could see or
/// measure [m].
inline constexpr double kOverlapTolerance = 1e-9;
}  // namespace ping_pong
