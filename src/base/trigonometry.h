// Sine, cosine and angle with the same bits on every host: matrices of glRotate and antialiased lines reach
// the picture. libm's may differ between machines with and without FMA.
#pragma once

namespace softgl {

float sine(float radians);
float cosine(float radians);
/// The angle of (x, y), finite and not both 0: -pi to pi.
float angle_of(float y, float x);

} // namespace softgl
