// softgl_raycast: draws a scene by casting one ray through each pixel.
//   softgl_raycast shapes -o shapes.png
#include <cstdio>
#include <exception>
#include <string>

#include "scene.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

static const char kUsage[] = "usage: softgl_raycast SCENE [-o FILE.png] [--print]\n"
                             "  SCENE    a scene file, or one of the built-in scenes: sphere, shapes, spots\n"
                             "  -o FILE  the picture (raycast.png)\n"
                             "  --print  print the text of a built-in scene instead\n";

int main(int argc, char** argv) {
  std::string name, output = "raycast.png";
  bool print = false;
  for (int i = 1; i < argc; i++) {
    const std::string option = argv[i];
    if (option == "-o" && i + 1 < argc)
      output = argv[++i];
    else if (option == "--print")
      print = true;
    else if (option == "--help")
      return std::fputs(kUsage, stdout), 0;
    else if (name.empty() && option[0] != '-')
      name = option;
    else
      return std::fputs(kUsage, stderr), 2;
  }
  if (name.empty()) return std::fputs(kUsage, stderr), 2;
  try {
    using namespace softgl::raycast;
    const char* text = built_in_scene(name);
    if (print) return text ? std::fputs(text, stdout), 0 : (std::fputs(kUsage, stderr), 2);
    const Scene scene = text ? parse_scene(text, name) : read_scene(name);
    const auto rgb = render(scene);
    const auto& camera = scene.camera;
    if (stbi_write_png(output.c_str(), camera.width, camera.height, 3, rgb.data(), 3 * camera.width))
      return 0;
    std::fprintf(stderr, "softgl_raycast: cannot write %s\n", output.c_str());
  } catch (const std::exception& e) { std::fprintf(stderr, "softgl_raycast: %s\n", e.what()); }
  return 1;
}
