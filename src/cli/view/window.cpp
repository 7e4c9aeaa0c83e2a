#include "view/window.h"

#include <SDL.h>

#include <utility>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw ProgramError(kCannotWrite, std::string("no window: ") + what + ": " + SDL_GetError());
}

template <class Object, void (*destroy)(Object*)> struct Destroy {
  void operator()(Object* object) const { destroy(object); }
};
using Texture = std::unique_ptr<SDL_Texture, Destroy<SDL_Texture, SDL_DestroyTexture>>;

std::string key_name(SDL_Keycode code) {
  switch (code) {
  case SDLK_EQUALS:
  case SDLK_KP_PLUS: return "+";
  case SDLK_KP_MINUS: return "-";
  default: break;
  }
  std::string name = SDL_GetKeyName(code);
  if (name.rfind("Keypad ", 0) == 0) name.erase(0, 7);
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') name[0] = char(name[0] + 32);
  return name;
}

// What a key that stays down does again and again.
bool repeats(const std::string& key) {
  return key == "Left" || key == "Right" || key == "Up" || key == "Down" || key == "+" || key == "-";
}

std::optional<Event> translate(const SDL_Event& from) {
  Event event;
  switch (from.type) {
  case SDL_QUIT: event.key = "q"; return event;
  case SDL_KEYUP: event.kind = Event::kKeyUp; [[fallthrough]];
  case SDL_KEYDOWN:
    if (from.key.keysym.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) return {};
    event.key = key_name(from.key.keysym.sym);
    if (from.key.repeat && !repeats(event.key)) return {};
    return event;
  case SDL_MOUSEBUTTONDOWN:
    event.kind = Event::kPress;
    event.button = from.button.button == SDL_BUTTON_LEFT     ? Event::kLeft
                   : from.button.button == SDL_BUTTON_MIDDLE ? Event::kMiddle
                                                             : Event::kRight;
    event.shift = (SDL_GetModState() & KMOD_SHIFT) != 0;
    return event;
  case SDL_MOUSEBUTTONUP: event.kind = Event::kRelease; return event;
  case SDL_MOUSEMOTION:
    event.kind = Event::kMove;
    event.x = from.motion.xrel;
    event.y = from.motion.yrel;
    return event;
  case SDL_MOUSEWHEEL:
    event.kind = Event::kWheel;
    event.y = from.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -from.wheel.y : from.wheel.y;
    return event;
  case SDL_WINDOWEVENT:
    if (from.window.event != SDL_WINDOWEVENT_SIZE_CHANGED) return {};
    event.kind = Event::kResize;
    event.x = from.window.data1;
    event.y = from.window.data2;
    return event;
  default: return {};
  }
}

} // namespace

struct Window::Parts {
  struct Library {
    ~Library() { SDL_Quit(); }
  } library; // ends after the others
  std::unique_ptr<SDL_Window, Destroy<SDL_Window, SDL_DestroyWindow>> window;
  std::unique_ptr<SDL_Renderer, Destroy<SDL_Renderer, SDL_DestroyRenderer>> renderer;
};

Window::Window(const std::string& title, int width, int height) : parts_(std::make_unique<Parts>()) {
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0"); // no GL of others
  if (SDL_Init(SDL_INIT_VIDEO) != 0) refuse("SDL finds no screen");
  parts_->window.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                        width, height, SDL_WINDOW_RESIZABLE));
  if (!parts_->window) refuse("SDL makes none");
  parts_->renderer.reset(SDL_CreateRenderer(parts_->window.get(), -1, SDL_RENDERER_SOFTWARE));
  if (!parts_->renderer) refuse("SDL does not draw");
}

Window::~Window() = default;

std::optional<Event> Window::wait(int milliseconds) {
  SDL_Event event;
  for (int left = milliseconds; SDL_WaitEventTimeout(&event, left) != 0; left = 0) {
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_EXPOSED) needs_showing_ = true;
    if (std::optional<Event> translated = translate(event)) return translated;
  }
  return {};
}

bool Window::needs_showing() { return std::exchange(needs_showing_, false); }

void Window::copy(const Picture& picture, bool fills, bool at_bottom) {
  if (picture.pixels.empty()) return;
  SDL_Renderer* renderer = parts_->renderer.get();
  const bool blended = picture.channels == 4;
  const Texture texture(SDL_CreateTexture(renderer, blended ? SDL_PIXELFORMAT_RGBA32 : SDL_PIXELFORMAT_RGB24,
                                          SDL_TEXTUREACCESS_STREAMING, picture.width, picture.height));
  if (!texture) refuse("SDL holds no picture");
  SDL_UpdateTexture(texture.get(), nullptr, picture.pixels.data(), picture.width * picture.channels);
  SDL_SetTextureBlendMode(texture.get(), blended ? SDL_BLENDMODE_BLEND : SDL_BLENDMODE_NONE);
  int width = 0, height = 0;
  SDL_GetRendererOutputSize(renderer, &width, &height);
  const SDL_Rect place = {0, at_bottom ? height - picture.height : 0, picture.width, picture.height};
  SDL_RenderCopy(renderer, texture.get(), nullptr, fills ? nullptr : &place);
}

void Window::show(const Picture& picture, const Picture& top, const Picture& bottom) {
  SDL_SetRenderDrawColor(parts_->renderer.get(), 0x2e, 0x33, 0x3a, 255);
  SDL_RenderClear(parts_->renderer.get());
  copy(picture, true, false);
  copy(top, false, false);
  copy(bottom, false, true);
  SDL_RenderPresent(parts_->renderer.get());
}

Picture Window::shot() const {
  Picture picture;
  SDL_GetRendererOutputSize(parts_->renderer.get(), &picture.width, &picture.height);
  picture.pixels.extend(size_t(3) * size_t(picture.width) * size_t(picture.height));
  if (SDL_RenderReadPixels(parts_->renderer.get(), nullptr, SDL_PIXELFORMAT_RGB24, picture.pixels.data(),
                           3 * picture.width) != 0)
    refuse("SDL reads no pixels");
  return picture;
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(parts_->window.get(), title.c_str()); }

void Window::set_size(int width, int height) { SDL_SetWindowSize(parts_->window.get(), width, height); }

} // namespace softgl::cli
