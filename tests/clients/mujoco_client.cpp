// softgl_mujoco LIBRARY SCENE FILE: draws a scene of MuJoCo 2.2.2 with a library of OSMesa's ABI and writes
// what mjr_readPixels gives: width, height (int32), then the rows of RGB bytes from the bottom, then the rows
// of depths (float). softgl_mujoco --list prints the names of the scenes. MuJoCo looks for the loaded library
// whose name has libOSMesa.so in it, and asks it for OpenGL's functions.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <string>
#include <unistd.h>
#include <vector>

#include <mujoco/mujoco.h>

#include "clients/mujoco_scenes.h"

namespace {

constexpr int kWidth = 400, kHeight = 300;

[[noreturn]] void fail(const char* message) {
  std::fprintf(stderr, "softgl_mujoco: %s\n", message);
  std::exit(1);
}

// The window surface is an OSMesa context of the same size as the offscreen buffer.
void make_current(const char* library, std::vector<unsigned char>& window) {
  void* handle = dlopen(library, RTLD_NOW | RTLD_GLOBAL);
  if (!handle) fail(dlerror());
  auto create =
      reinterpret_cast<void* (*)(unsigned, int, int, int, void*)>(dlsym(handle, "OSMesaCreateContextExt"));
  auto make = reinterpret_cast<unsigned char (*)(void*, void*, unsigned, int, int)>(
      dlsym(handle, "OSMesaMakeCurrent"));
  if (!create || !make) fail("the library has not OSMesa's functions");
  constexpr unsigned kRgba = 0x1908, kUnsignedByte = 0x1401;
  void* context = create(kRgba, 24, 8, 8, nullptr);
  window.resize(size_t{4} * kWidth * kHeight);
  if (!context || !make(context, window.data(), kUnsignedByte, kWidth, kHeight)) fail("no context");
}

mjModel* load(const softgl::test::MujocoScene& scene) {
  const std::string path = "/tmp/softgl_mujoco." + std::to_string(getpid()) + "." + scene.name + ".xml";
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) fail("cannot write the model");
  std::fputs(scene.xml, file);
  std::fclose(file);
  char error[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  std::remove(path.c_str());
  if (!model) fail(error);
  return model;
}

// A height field's elevations are data, not text: waves over rows and columns.
void fill_height_fields(mjModel* model) {
  for (int field = 0; field < model->nhfield; ++field) {
    const int rows = model->hfield_nrow[field], columns = model->hfield_ncol[field];
    float* data = model->hfield_data + model->hfield_adr[field];
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        data[row * columns + column] = float((row * row + 3 * column + row * column) % 17) / 16.0F;
  }
}

} // namespace

int main(int count, char** arguments) {
  if (count == 2 && !std::strcmp(arguments[1], "--list")) {
    for (const softgl::test::MujocoScene& scene : softgl::test::mujoco_scenes()) std::puts(scene.name);
    return 0;
  }
  if (count < 4) fail("usage: softgl_mujoco LIBRARY SCENE FILE [FRAMES]");
  const softgl::test::MujocoScene* scene = nullptr;
  for (const softgl::test::MujocoScene& each : softgl::test::mujoco_scenes())
    if (!std::strcmp(each.name, arguments[2])) scene = &each;
  if (!scene) fail("no such scene");

  std::vector<unsigned char> window;
  make_current(arguments[1], window);
  mjModel* model = load(*scene);
  fill_height_fields(model);
  model->vis.quality.offsamples = scene->samples;
  mjData* data = mj_makeData(model);
  mj_forward(model, data);
  for (int step = 0; step < scene->steps; ++step) mj_step(model, data);

  mjvCamera camera;
  mjv_defaultFreeCamera(model, &camera);
  camera.distance *= scene->distance;
  mjvOption option;
  mjv_defaultOption(&option);
  mjvScene view;
  mjv_defaultScene(&view);
  mjv_makeScene(model, &view, 2000);
  mjrContext context;
  mjr_defaultContext(&context);
  mjr_makeContext(model, &context, mjFONTSCALE_100);
  mjr_setBuffer(scene->window ? mjFB_WINDOW : mjFB_OFFSCREEN, &context);
  const mjrRect viewport{0, 0, kWidth, kHeight};
  scene->adjust(option, view);

  // More frames than one measure time.
  const int frames = count > 4 ? std::atoi(arguments[4]) : 1;
  const std::clock_t start = std::clock();
  std::vector<unsigned char> colors(size_t{3} * kWidth * kHeight);
  std::vector<float> depths(size_t{kWidth} * kHeight);
  for (int frame = 0; frame < frames; ++frame) {
    mjv_updateScene(model, data, &option, nullptr, &camera, mjCAT_ALL, &view);
    mjr_render(viewport, &view, &context);
    scene->overlay(viewport, context);
    mjr_readPixels(colors.data(), depths.data(), viewport, &context);
  }
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  if (const int error = mjr_getError())
    std::fprintf(stderr, "softgl_mujoco: GL error 0x%04x\n", error), std::exit(1);
  if (frames > 1) std::printf("%s %.3f ms of processor time a frame\n", scene->name, seconds * 1000 / frames);

  std::FILE* file = std::fopen(arguments[3], "wb");
  if (!file) fail("cannot write the picture");
  const int size[2] = {kWidth, kHeight};
  std::fwrite(size, sizeof size, 1, file);
  std::fwrite(colors.data(), 1, colors.size(), file);
  std::fwrite(depths.data(), sizeof(float), depths.size(), file);
  std::fclose(file);
  mjr_freeContext(&context);
  mjv_freeScene(&view);
  mj_deleteData(data);
  mj_deleteModel(model);
}
