// The sRGB curve between stored values and light, IEC 61966-2-1; 0 to 1, and on beyond.
#pragma once

namespace softgl::cli {

float from_srgb(float value);
float to_srgb(float light);

} // namespace softgl::cli
