// A window of SDL that shows pictures and gives events.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/picture.h"
#include "view/view_state.h"

namespace softgl::cli {

class Window {
public:
  // Throws ProgramError (kCannotWrite) where there is no screen.
  Window(const std::string& title, int width, int height);
  ~Window();

  // The next event, waited for at most so long. A window that is closed is the key q.
  std::optional<Event> wait(int milliseconds);
  // True once after something had covered the window.
  bool needs_showing();

  // `picture` is RGB and fills the window; `top` and `bottom`, RGBA or empty, lie over it.
  void show(const Picture& picture, const Picture& top, const Picture& bottom);
  // RGB, what the window shows.
  Picture shot() const;
  void set_title(const std::string& title);
  void set_size(int width, int height);

private:
  struct Parts;
  void copy(const Picture& picture, bool fills, bool at_bottom);

  std::unique_ptr<Parts> parts_;
  bool needs_showing_ = false;
};

} // namespace softgl::cli
