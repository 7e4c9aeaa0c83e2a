#include "options/light_options.h"

#include <algorithm>

#include "options/option_kinds.h"
#include "options/option_values.h"
#include "scene/lighting_setup.h"

namespace softgl::cli {

void LightingWords::add_shading(CLI::App& app, ProgramOptions& options) {
  add_word(app, "--shading", "HOW", "flat, gouraud (lit per vertex) or phong (lit per pixel) [gouraud]",
           shading, {"flat", "gouraud", "phong"});
  add_word(app, "--specular", "VECTOR", "vector of highlights: half (n.h)^ns or reflection (v.r)^ns [half]",
           specular, {"half", "reflection"});
  add_parsed(app, "--terms", "LIST",
             "terms of the light that are drawn: ambient,diffuse,specular,emission [all]",
             [&options](const std::string& text) { options.render.lighting.terms = parse_terms(text); })
      ->check(offers({"ambient", "diffuse", "specular", "emission", "all"}));
  app.add_option_function<double>(
         "--crease",
         [&options](double angle) {
           options.normals.crease_angle = angle;
           options.normals.ignore_groups = true;
         },
         "smooth generated normals up to this angle, whatever the groups [40]")
      ->check(range(0, 180))
      ->type_name("DEG");
}

void add_lights(CLI::App& app, ProgramOptions& options) {
  app.add_option_function<std::vector<std::string>>(
         "--light", checked([&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options.render.lighting.lights.push_back(parse_light(text));
         }),
         "key, headlight, three-point, x,y,z (direction as seen), +Y or model:x,y,z (in the model's "
         "axes), "
         "at:x,y,z (place); then /color:COLOR, and for a place /spot:x,y,z/cutoff:DEG/exponent:N/"
         "attenuation:C,L,Q; may be repeated [key]")
      ->check(offers({"key", "headlight", "three-point"}))
      ->allow_extra_args(false)
      ->type_name("LIGHT");
  add_parsed(app, "--ambient-light", "K",
             "light that comes from everywhere: a number, r,g,b or a color [0.2]",
             [&options](const std::string& text) {
               const auto rgb = parse_reflectance(text);
               std::copy(rgb.begin(), rgb.end(), options.render.lighting.ambient);
             });
}

void add_reflectances(CLI::App& app, ProgramOptions& options) {
  MaterialOptions& materials = options.materials;
  const auto add_reflectance = [&app](const char* name, const char* description,
                                      MaterialOptions::Reflectance& reflectance) {
    add_parsed(app, name, "K", description,
               [&reflectance](const std::string& text) { reflectance = parse_reflectance(text); });
  };
  add_reflectance("--ka", "ambient reflectance of all materials", materials.ambient);
  add_reflectance("--kd", "diffuse reflectance of all materials", materials.diffuse);
  add_reflectance("--ks", "specular reflectance of all materials", materials.specular);
  add_number(app, "--ns", "N", "specular exponent of all materials, 0 to 128", materials.shininess, 0, 128);
}

std::string LightingWords::complete(ProgramOptions& options, bool figure) const {
  LightingOptions& lighting = options.render.lighting;
  lighting.shading = shading == "flat" && !figure ? Shading::kFlat
                     : shading == "phong"         ? Shading::kPhong
                                                  : Shading::kGouraud;
  // The lecture is about Phong's equation.
  lighting.reflection_vector = specular == "reflection" || (figure && specular.empty());
  if (gl_lights_of(lighting) > kMostLights)
    return "--light: GL has 8 lights, and the key light takes two of them, three-point three";
  return {};
}

} // namespace softgl::cli
