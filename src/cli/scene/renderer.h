// The picture of a mesh, drawn through the GL and OSMesa functions.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/warnings.h"
#include "image/float_picture.h"
#include "mesh/mesh_builder.h"
#include "scene/camera.h"
#include "scene/lighting_options.h"
#include "scene/look.h"
#include "scene/pass.h"

namespace softgl::cli {

enum class Values { kBytes, kWords, kFloats };

struct RenderOptions {
  int width = 1024, height = 1024;
  int samples_per_side = 1; // 2: 4 samples per pixel
  LightingOptions lighting;
  Background background; // black for passes that are terms of the light, so that their sum is the color
  LineOptions lines;
  bool ground = false;        // the model's shadow below it, in pictures of the color
  UpAxis up = UpAxis::kPlusY; // of the ground
  bool srgb =
      false; // the mesh's colors are light already; the background's are not, and the picture is encoded
  Pass pass = Pass::kColor;
  Values values = Values::kBytes; // kFloats: colors may go beyond 1
};

struct RenderResult {
  Picture picture; // or, for kFloats:
  FloatPicture floats;
  bool visible = false;      // something was drawn
  bool as_wireframe = false; // the surfaces do not show, so their edges were drawn
  bool transparent = false;  // and they would show if they were opaque
  double upload_seconds = 0, draw_seconds = 0, average_seconds = 0;
};

// Draws one mesh as often as asked, in any size. Buffers and textures are made with the first picture. One
// thread draws all pictures of a renderer.
class MeshRenderer {
public:
  // The arguments outlive it. `linear`: textures are decoded from sRGB.
  MeshRenderer(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
               bool linear = false);
  ~MeshRenderer();

  // `warnings` gets those about textures with the first picture. Throws ProgramError if GL cannot draw a
  // picture of that size.
  RenderResult draw(const Camera& camera, const RenderOptions& options, Warnings& warnings);

private:
  class Drawing;
  struct Resources;
  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const ModelFrame& frame_;
  bool linear_;
  std::unique_ptr<Resources> resources_;
};

} // namespace softgl::cli
