// Sine, cosine and angle with the same bits on every host: matrices of glRotate and antialiased lines reach
// the picture. libm's may differ between machines with and without FMA.
#pragma once

namespace softgl {

float sine(float radians);
float cosine(float radians);
/// The angle of (x, y), which are finite: -pi to pi. That of (0, 0) is 0.
float angle_of(float y, float x);

} // namespace softgl
