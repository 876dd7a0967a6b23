// Pieces that scenes of the chart are built from.
#pragma once

#include <string>

#include "chart_scene.h"

namespace ping_pong::bench
{
constexpr double kGravity = 9.81;  // of all scenes of the chart [m/s^2]

/// Gravity, materials "ball" and "wall", and one contact law for everything.
Scene emptyScene(const std::string& name, const Surface& law);

/// Drag and Magnus force; the lift law is the library's default.
void addAir(Scene& scene, const DragLaw& drag);

void addFloor(Scene& scene, double height = 0.0);
void addBox(Scene& scene, const std::string& name, BodyKind kind, const Vector3d& size, const Pose& pose);
void addBall(Scene& scene, const BallParams& params, const BallState& state);

/// A contact law without slope or rolling resistance.
Surface contactLaw(double restitution, double friction);
}  // namespace ping_pong::bench
