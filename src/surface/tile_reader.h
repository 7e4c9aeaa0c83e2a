// Who wants to see finished tiles.
#pragma once

#include <cstdint>

namespace softgl {

/// Is told of every tile of the surface, by the worker that did the last work on it.
class TileReader {
public:
  virtual ~TileReader() = default;
  virtual void read(uint32_t tile) const = 0;
};

} // namespace softgl
