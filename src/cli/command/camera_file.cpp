#include "command/camera_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/file_writer.h"
#include "common/program_error.h"
#include "image/image_writer.h"

namespace softgl::cli {
namespace {

constexpr size_t kMostBytes = 1 << 20;

std::array<double, 3> triple(const nlohmann::json& value) {
  if (!value.is_array() || value.size() != 3) throw std::invalid_argument("three numbers stand in []");
  std::array<double, 3> numbers;
  for (size_t i = 0; i < 3; ++i) {
    if (!value[i].is_number()) throw std::invalid_argument("three numbers stand in []");
    numbers[i] = value[i].get<double>();
    if (!std::isfinite(numbers[i]) || std::fabs(numbers[i]) > 1e30)
      throw std::invalid_argument("a number is too large");
  }
  return numbers;
}

double within(const nlohmann::json& value, double low, double high) {
  const double number = value.is_number() ? value.get<double>() : NAN;
  if (!(number >= low && number <= high)) throw std::invalid_argument("fov is 1 to 150, height above 0");
  return number;
}

CameraPlacement parse(const nlohmann::json& file) {
  CameraPlacement place;
  if (!file.is_object() || !file.contains("eye")) throw std::invalid_argument("there is no \"eye\"");
  for (const auto& [key, value] : file.items()) {
    if (key == "eye")
      place.eye = triple(value);
    else if (key == "target")
      place.target = triple(value);
    else if (key == "up")
      place.up = triple(value);
    else if (key == "fov")
      place.field_of_view = within(value, 1e-3, 179);
    else if (key == "height")
      place.height = within(value, 1e-30, 1e30);
    else
      throw std::invalid_argument("known are eye, target, up, fov and height");
  }
  if (place.field_of_view > 0 && place.height > 0)
    throw std::invalid_argument("a camera has fov, or height for parallel rays");
  return place;
}

} // namespace

CameraPlacement read_camera(const std::string& path) { return parse_camera(SourceText::open(path)); }

CameraPlacement parse_camera(const SourceText& text) {
  std::string problem = "the file is too large";
  if (text.size() <= kMostBytes) {
    const nlohmann::json file = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    if (file.is_discarded())
      throw ProgramError(kCannotRead, text.name() + ": no camera: the file is no JSON");
    try {
      return parse(file);
    } catch (const std::invalid_argument& mistake) { problem = mistake.what(); }
  }
  throw ProgramError(kCannotRead, text.name() + ": no camera: " + problem);
}

void write_camera(const std::string& path, const CameraPlacement& place) {
  nlohmann::ordered_json file;
  file["eye"] = place.eye;
  if (place.target) file["target"] = *place.target;
  if (place.up) file["up"] = *place.up;
  if (place.height > 0)
    file["height"] = place.height;
  else
    file["fov"] = place.field_of_view;
  const std::string text = file.dump() + "\n";
  GrowingArray<uint8_t> bytes;
  bytes.append(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  write_file(path, bytes);
}

} // namespace softgl::cli
