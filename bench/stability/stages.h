// The stages of random scenes, by what they are made of.
#pragma once

#include "stage.h"

namespace ping_pong::stability
{
// --- stages_corners.cpp: flat faces that meet ---
Stage floorAndWall(Dice& dice);
Stage groove(Dice& dice);
Stage trayCorner(Dice& dice);
Stage tray(Dice& dice);
Stage slope(Dice& dice);

// --- stages_seams.cpp: faces side by side ---
Stage flush(Dice& dice);
Stage nearlyFlush(Dice& dice);
Stage step(Dice& dice);

// --- stages_round.cpp: edges and curved surfaces ---
Stage cylinder(Dice& dice);
Stage edge(Dice& dice);
Stage blade(Dice& dice);
Stage spheres(Dice& dice);
Stage clutter(Dice& dice);

// --- stages_moving.cpp ---
Stage movingTray(Dice& dice);
Stage turningTable(Dice& dice);
Stage pushed(Dice& dice);
}  // namespace ping_pong::stability
