// stb_truetype's declarations. lettering.cpp has its functions.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop
