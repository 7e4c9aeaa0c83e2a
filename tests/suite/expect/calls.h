// The specification's machine: its state, and a function for each group of calls. Each `play_...` gives false
// for a call that is not of its group, and throws std::logic_error for an argument that the machine does not
// know.
#pragma once

#include <set>
#include <stdexcept>

#include "expect/machine.h"
#include "expect/primitive.h"
#include "expect/render_mode.h"

namespace softgl::suite {

class Machine {
public:
  Machine(Expectation& picture, const Precision& precision);
  void play(const Call& call);
  /// Throws std::logic_error if the state changes what is read from the window.
  void check_reading() const;
  Claims claims() const { return claims_; }

private:
  Claims claim(const Call& call);
  Claims error_claim(const Call& call);
  std::vector<double> answer(GLenum name); // of glGetFloatv; empty if the machine does not know it
  const ArrayState* array_named(GLenum name) const;
  bool play_lists(const Call& call);
  void call_list(GLuint name);
  bool play_attributes(const Call& call);
  bool play_matrices(const Call& call);
  bool play_vertices(const Call& call);
  bool play_lighting(const Call& call);
  bool play_rasterization(const Call& call);
  bool play_textures(const Call& call);
  bool play_pixels(const Call& call);
  bool play_fragments(const Call& call);
  bool play_paint(const Call& call);
  bool play_special(const Call& call);
  bool play_evaluators(const Call& call);

  void enable(GLenum name, bool on);
  std::vector<Matrix4>& matrices(); // the stack of the matrix mode
  void light(const Call& call, const std::vector<double>& values);
  void light_model(GLenum name, const std::vector<double>& values);
  void material(GLenum face, GLenum name, const std::vector<double>& values);
  void set_material(int face, GLenum name, const std::vector<double>& values);
  void track_color();
  bool tracks(int face, GLenum name) const;
  void fog(GLenum name, const std::vector<double>& values);
  void color(double r, double g, double b, double a = 1);
  LitVertex transform(const Vec4& object) const;
  ColorBounds lit_color(const spec::Vec3Interval& eye, const spec::Vec3Interval& normal, int face) const;
  void to_window(LitVertex& vertex) const;
  void end();
  bool enable_texture(GLenum name, bool on);
  void generation(GLenum coordinate, GLenum name, const std::vector<double>& values);
  void generate_coordinates(const Vec4& object, const Vec4& eye, const Vec3& normal, LitVertex& vertex) const;
  bool play_texture_images(const Call& call);
  bool play_compressed_images(const Call& call);
  void draw_image(const PixelImage& image);
  void draw_polygon(const std::vector<int>& corners, int provoking, bool edge_flags);
  /// `begins`: the stipple begins with this line.
  void draw_line(int from, int to, bool begins, Interval along = 0);
  void clip_plane(int plane, const std::vector<double>& equation);
  bool play_arrays(const Call& call);
  void set_array(ArrayState& array, int size, GLenum type, int stride, const Argument& memory);
  void interleaved_arrays(const Call& call);
  void array_element(int index);
  void draw_elements(GLenum mode, const std::vector<int>& indices);
  void bitmap(const Call& call);
  void window_position(const Vec4& at);
  void paint_elements(const std::vector<Interval>& elements, const Call& call, size_t first);
  void receive(GLenum token, const std::vector<LitVertex>& vertices);
  bool receives_pixels(GLenum token); // false if they are to be drawn
  void paint_numbers(const std::vector<Interval>& numbers, int size, void (*paint)(Interval, Interval*));
  void set_map(const Call& call, int dimensions);
  void evaluate(int dimensions, double u, double v);
  void evaluate_mesh(const Call& call);
  bool enable_map(GLenum name, bool on);
  std::vector<double> map_answer(GLenum target, GLenum query) const; // of glGetMap
  std::vector<double> query_answer(const Call& call);                // of glGetQuery and glGetQueryObject

  State state_;
  Rasterizer raster_;
  bool open_ = false; // between Begin and End
  GLenum mode_ = 0;
  std::vector<LitVertex> vertices_;
  LitVertex raster_position_;
  bool raster_position_valid_ = true;
  GLenum expected_error_ = GL_NO_ERROR;
  bool skips_next_ = false;                              // a call that raises an error does nothing
  std::vector<std::pair<LitVertex, bool>> raster_saved_; // as state_.saved
  RenderModeState render_mode_;
  EvaluatorMaps evaluator_maps_;
  GLuint query_ = 0; // that counts, and what came of all
  std::map<GLuint, FragmentCount> queries_;
  std::set<GLuint> complete_; // queries whose result was asked for
  GLuint list_ = 0;           // that is compiled
  bool list_executes_ = false;
  Claims claims_ = Claims::Right;
};

/// A number each argument from `first` on.
std::vector<double> numbers_of(const Call& call, size_t first);
/// The numbers of a command like glVertex: those behind its pointer, or its arguments.
std::vector<double> values_of(const Call& call);
/// One to four numbers; y and z are 0 and w is 1 if they are not given.
Vec4 vec4(const std::vector<double>& v);
/// A signed integer of `bits` bits as a color or normal (table 2.9).
double signed_unit(double integer, int bits);
/// The target of an image, and the face of a cube map. Throws std::logic_error for what is no texture's
/// target.
TextureTarget texture_target(GLenum target, int* face);
/// A row of a matrix times a vector, with the accuracy of the subject's own arithmetic.
Interval row_times(const Matrix4& m, int row, const Vec4& v);
/// Throws std::logic_error where there is none.
Matrix4 inverse(Matrix4 m);
/// A matrix comes from the subject's own arithmetic: some operations of 2.1.1's accuracy.
constexpr double kMatrixAccuracy = 4 * spec::kAccuracy;

} // namespace softgl::suite
