// Sine and cosine of a float with the same bits on every host, for glRotate: its matrices reach the picture.
// libm's may differ between machines with and without FMA.
#pragma once

namespace softgl {

float sine(float radians);
float cosine(float radians);

} // namespace softgl
