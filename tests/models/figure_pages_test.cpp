// softgl figure: pages of the lecture, their curves and their pictures.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "models/figure_files.h"
#include "models/picture_files.h"

using namespace softgl::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Figure {
  std::string name, title;
};

std::vector<Figure> figures(const char* language) {
  const ProgramRun run = run_softgl({"figure", "--list", "--lang", language});
  REQUIRE(run.exit_code == 0);
  std::vector<Figure> all;
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line);)
    all.push_back({line.substr(0, line.find(' ')), line.substr(line.find_first_not_of(' ', line.find(' ')))});
  return all;
}

std::string lecture(std::vector<std::string> options) {
  std::vector<std::string> arguments = {"figure", "-o", "-", "--format", "html", "--size", "24x24"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_softgl(arguments);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return run.output;
}

double radius(const std::pair<double, double>& p) { return std::hypot(p.first, p.second); }
double largest(const Curve& curve) {
  double most = 0;
  for (const auto& point : curve) most = std::max(most, point.second);
  return most;
}

// Every point of a lobe has the radius that belongs to its angle.
template <class Expected> void check_lobe(const Curve& curve, Expected expected) {
  REQUIRE(curve.size() > 100);
  int checked = 0;
  for (const auto& point : curve) {
    if (radius(point) < 0.02) continue; // no angle
    const double angle = std::atan2(point.first, point.second) / kDegree;
    REQUIRE(radius(point) == Approx(expected(angle)).margin(2e-3));
    ++checked;
  }
  REQUIRE(checked > 10);
}

template <class Expected> void check_curve(const Curve& curve, Expected expected) {
  REQUIRE(curve.size() > 100);
  for (const auto& [x, y] : curve) REQUIRE(y == Approx(expected(x)).margin(2e-3));
}

double power(double cosine, double exponent) { return cosine > 0 ? std::pow(cosine, exponent) : 0; }

int brightest(const TestPicture& picture) {
  return *std::max_element(picture.rgb.begin(), picture.rgb.end());
}

size_t different(const TestPicture& a, const TestPicture& b, int tolerance) {
  size_t count = 0;
  for (size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a.rgb[i + k] - b.rgb[i + k]));
    count += most > tolerance;
  }
  return count;
}

} // namespace

TEST_CASE("figure: the lecture has every figure in both languages, and refers to nothing outside",
          "[models][figure]") {
  const std::vector<Figure> english = figures("en"), german = figures("de");
  REQUIRE(english.size() == german.size());
  REQUIRE(english.size() >= 14);
  std::string texts[2];
  for (const bool in_german : {false, true}) {
    const std::string text = texts[in_german] = lecture({"--lang", in_german ? "de" : "en"});
    CHECK(xml_fault(text) == "");
    CHECK(outside_references(text).empty());
    CHECK(text.find(in_german
                        ? "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"de\">"
                        : "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">") != std::string::npos);
    for (size_t i = 0; i < english.size(); ++i) {
      const Figure& figure = (in_german ? german : english)[i];
      CHECK(english[i].name == german[i].name);
      INFO(figure.name);
      CHECK(english[i].title != german[i].title);
      const size_t at =
          text.find("<section id=\"" + figure.name + "\">\n<h2>" + figure.title + "</h2>\n<svg ");
      REQUIRE(at != std::string::npos);
      const std::string section = text.substr(at, text.find("</section>", at) - at);
      CHECK(section.find("</svg>\n<p") != std::string::npos); // something is said
    }
  }
  // Both languages show the same numbers and pictures.
  CHECK(curves_of(texts[0]) == curves_of(texts[1]));
  const auto pictures = pictures_of(texts[0]), same = pictures_of(texts[1]);
  REQUIRE(pictures.size() > 30);
  for (const auto& [name, picture] : pictures) CHECK(picture.rgb == same.at(name).rgb);
}

TEST_CASE("figure: the checks of files find what is wrong", "[models][figure]") {
  CHECK(xml_fault("<a><b x=\"1\"/>text &amp; more</a>") == "");
  for (const char* wrong :
       {"<a><b></a></b>", "<a>", "<a x=1/>", "<a>R&D</a>", "<a x=\"1\" x=\"2\"/>", "text"})
    CHECK(xml_fault(wrong) != "");
  CHECK(outside_references("<a href=\"#b\"/><image href=\"data:image/png;base64,\"/>").empty());
  CHECK(outside_references("<image href=\"b.png\"/>").size() == 1);
  CHECK(outside_references("<style>@import url(b.css)</style>").size() == 2);
}

TEST_CASE("figure: curves are the formulas that they stand for", "[models][figure]") {
  const auto cosine = curves_of(figure_svg("cosine"));
  check_curve(cosine.at("cosine"), [](double angle) { return std::max(0.0, std::cos(angle * kDegree)); });

  const auto diffuse = curves_of(figure_svg("diffuse"));
  check_lobe(diffuse.at("diffuse"), [](double angle) { return std::cos(angle * kDegree); });
  for (const int light : {0, 30, 60})
    check_lobe(diffuse.at("diffuse-" + std::to_string(light)),
               [&](double) { return std::cos(light * kDegree); });

  const auto specular = curves_of(figure_svg("specular"));
  for (const int a : {1, 4, 16, 64, 128}) {
    check_lobe(specular.at("specular-" + std::to_string(a)),
               [&](double angle) { return power(std::cos((angle - 40) * kDegree), a); });
    check_curve(specular.at("power-" + std::to_string(a)),
                [&](double angle) { return power(std::cos(angle * kDegree), a); });
  }

  const auto terms = curves_of(figure_svg("terms"));
  const double lit = std::cos(40 * kDegree);
  check_lobe(terms.at("ambient"), [](double) { return 0.2; });
  check_lobe(terms.at("ambient-diffuse"), [&](double) { return 0.2 + 0.4 * lit; });
  check_lobe(terms.at("sum"), [&](double angle) {
    return 0.2 + 0.4 * lit + 0.4 * power(std::cos((angle - 40) * kDegree), 20);
  });

  const auto vectors = curves_of(figure_svg("vectors"));
  check_curve(vectors.at("reflection"),
              [](double viewer) { return power(std::cos((viewer - 30) * kDegree), 16); });
  check_curve(vectors.at("half"),
              [](double viewer) { return power(std::cos((viewer - 30) / 2 * kDegree), 16); });
  check_curve(vectors.at("half-sharper"),
              [](double viewer) { return power(std::cos((viewer - 30) / 2 * kDegree), 64); });

  const auto energy = curves_of(figure_svg("energy"));
  const auto sum = [](double angle, double ka, double kd, double ks) {
    const double n_dot_s = std::cos(angle * kDegree);
    return ka + (n_dot_s > 0 ? kd * n_dot_s + ks * power(std::cos(2 * angle * kDegree), 12) : 0);
  };
  check_curve(energy.at("fit"), [&](double angle) { return sum(angle, 0.1, 0.55, 0.35); });
  check_curve(energy.at("over"), [&](double angle) { return sum(angle, 0.2, 1, 0.9); });
  check_curve(energy.at("clamped"), [&](double angle) { return std::min(1.0, sum(angle, 0.2, 1, 0.9)); });
}

TEST_CASE("figure: what goes wrong shows in the curves and in the pictures", "[models][figure]") {
  const std::string behind = figure_svg("behind");
  // Pixels against the formula: a sphere of radius 1, seen along -z, half the height 1.1.
  const auto pictures = pictures_of(behind);
  const double length = std::sqrt(0.85 * 0.85 + 0.2 * 0.2 + 0.5 * 0.5),
               s[3] = {0.85 / length, 0.2 / length, -0.5 / length};
  const double color[3] = {0.8, 0.35, 0.2};
  int dark = 0;
  for (const bool tested : {true, false}) {
    const TestPicture& picture = pictures.at(tested ? "tested" : "untested");
    REQUIRE((picture.width == 64 && picture.height == 64));
    for (int row = 1; row < 64; row += 3)
      for (int column = 1; column < 64; column += 3) {
        const double x = 1.1 * ((column + 0.5) / 32 - 1), y = 1.1 * (1 - (row + 0.5) / 32),
                     square = 1 - x * x - y * y;
        if (square < 0) continue;
        const double n[3] = {x, y, std::sqrt(square)}, n_dot_s = n[0] * s[0] + n[1] * s[1] + n[2] * s[2];
        const double v_dot_r = 2 * n_dot_s * n[2] - s[2];
        dark += n_dot_s < 0;
        for (int k = 0; k < 3; ++k) {
          double light = 0.25 * color[k];
          if (n_dot_s > 0 || !tested) light += 0.9 * (color[k] * n_dot_s + 0.8 * power(v_dot_r, 4));
          REQUIRE(std::abs(picture.at(column, row)[k] - 255 * std::clamp(light, 0.0, 1.0)) <= 0.51);
        }
      }
  }
  CHECK(dark > 100);
  const auto curves = curves_of(behind);
  CHECK(curves.at("tested").front().second == Approx(0.2).margin(2e-3)); // ambient light alone
  CHECK(curves.at("untested").front().second < 0);

  const std::string epsilon = figure_svg("epsilon");
  const auto shadows = pictures_of(epsilon);
  CHECK(different(shadows.at("zero"), shadows.at("small"), 20) > 64 * 64 / 20);
  CHECK(different(shadows.at("large"), shadows.at("small"), 20) > 20);
  const Curve wrong = curves_of(epsilon).at("wrong");
  REQUIRE(wrong.size() == 20);
  CHECK(wrong.front().second > 5);
  CHECK(wrong.back().second > 3);
  for (const auto& [exponent, percent] : wrong)
    if (exponent > -12 && exponent < -5) CHECK(percent == Approx(0).margin(0.01));

  // Along an edge the normal has the length of a chord, and the highlight its power.
  const auto unit = curves_of(figure_svg("unit"));
  const Curve &chord = unit.at("length"), &interpolated = unit.at("interpolated"),
              &normalized = unit.at("normalized");
  CHECK(chord[100].second == Approx(std::cos(35 * kDegree)).margin(2e-3));
  for (size_t i = 0; i < chord.size(); ++i)
    REQUIRE(interpolated[i].second ==
            Approx(normalized[i].second * std::pow(chord[i].second, 20)).margin(2e-2));
  CHECK(largest(normalized) == Approx(1).margin(2e-3));
  CHECK(largest(interpolated) < 0.2);
}

TEST_CASE("figure: triangles against exact shapes", "[models][figure]") {
  const auto missed = pictures_of(figure_svg("missed"));
  CHECK(brightest(missed.at("phong-1")) > 230);
  CHECK(brightest(missed.at("gouraud-1")) < 160);
  CHECK(different(missed.at("gouraud-32"), missed.at("phong-32"), 40) == 0);

  // The slope jumps where triangles meet.
  const auto mach = curves_of(figure_svg("mach"));
  const auto jump = [&](const char* name) {
    double most = 0;
    const Curve& curve = mach.at(name);
    REQUIRE(curve.size() > 30);
    for (size_t i = 1; i < curve.size(); ++i)
      most = std::max(most, std::abs(curve[i].second - curve[i - 1].second));
    return most;
  };
  CHECK(jump("gouraud-slope") > 3 * jump("phong-slope"));

  const auto truth = pictures_of(figure_svg("truth"));
  const TestPicture& exact = truth.at("ray-cast");
  CHECK(exact.colors() > 100);
  const size_t fine = different(exact, truth.at("triangles-64"), 4),
               coarse = different(exact, truth.at("triangles-8"), 4);
  CHECK(fine < 64 * 64 / 100);
  CHECK(coarse > 3 * fine);
}

TEST_CASE("figure: files are the same for every number of threads", "[models][figure]") {
  const std::string one = lecture({"--threads", "1"});
  CHECK(one == lecture({"--threads", "3"}));
}

TEST_CASE("figure: a file for each figure, and one figure as pixels", "[models][figure]") {
  const std::string folder = output_folder("figures") + "new/";
  const ProgramRun run =
      run_softgl({"figure", "cosine", "exponents", "-o", folder, "--size", "24x24", "--lang", "de"});
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  for (const char* name : {"cosine", "exponents"}) {
    const std::string text = read_bytes(folder + name + ".svg");
    CHECK(xml_fault(text) == "");
    CHECK(outside_references(text).empty());
    CHECK(text.find(" xml:lang=\"de\"") != std::string::npos);
  }
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2);

  // A picture keeps its pixels on a page of pixels.
  const std::vector<std::string> options = {"figure", "exponents", "-o",   "-",
                                            "--size", "64x64",     "--bg", "black"};
  std::vector<std::string> as_svg = options;
  as_svg.insert(as_svg.end(), {"--format", "svg"});
  const TestPicture page = decode_picture(run_softgl(options).output),
                    part = pictures_of(run_softgl(as_svg).output).at("exponent-16");
  bool found = false;
  for (int top = 0; top + 64 <= page.height && !found; ++top)
    for (int left = 0; left + 64 <= page.width && !found; ++left) {
      found = true;
      for (int row = 0; row < 64 && found; ++row)
        found = std::equal(part.at(0, row), part.at(0, row) + 3 * 64, page.at(left, top + row));
    }
  CHECK(found);
}

TEST_CASE("figure: a page of a model", "[models][figure]") {
  const std::string file = output_folder("figures") + "a_b & c.obj"; // nothing of it is a formula, or a tag
  std::ofstream(file) << "v -1 0 0\nv 0 -1 1\nv 1 0 0\nv 0 1 1\nvn -1 0 1\nvn 0 -1 1\nvn 1 0 1\nvn 0 1 1\nf "
                         "1//1 2//2 3//3 4//4\n";
  const std::string svg = figure_svg("gouraud", {file, "--lang", "de", "--view", "front", "--ns", "60"});
  CHECK(xml_fault(svg) == "");
  CHECK(svg.find("Dreiecke des Modells") != std::string::npos);
  CHECK(svg.find("jedes in 16 geteilt") != std::string::npos);
  const auto pictures = pictures_of(svg);
  CHECK(pictures.at("phong-1").colors() > 20);
  CHECK(different(pictures.at("gouraud-256"), pictures.at("phong-256"), 8) <
        different(pictures.at("gouraud-1"), pictures.at("phong-1"), 8));
  CHECK(run_softgl({"figure", "terms", file, file, "-o", "-"}).exit_code == 2); // one model
}

TEST_CASE("figure: the language of the environment", "[models][figure]") {
  const auto list = [](const std::vector<std::string>& environment) {
    return run_softgl({"figure", "--list"}, {}, environment).output;
  };
  const std::string english = run_softgl({"figure", "--list", "--lang", "en"}).output,
                    german = run_softgl({"figure", "--list", "--lang", "de"}).output;
  CHECK(english != german);
  CHECK(list({"LC_ALL=", "LC_MESSAGES=", "LANG=de_DE.UTF-8"}) == german);
  CHECK(list({"LC_ALL=C", "LC_MESSAGES=de_DE", "LANG=de_DE"}) == english);
  CHECK(list({"LC_ALL=", "LC_MESSAGES=de", "LANG=C"}) == german);
  CHECK(list({"LC_ALL=", "LC_MESSAGES=", "LANG=den"}) == english);
}

TEST_CASE("figure: its help, and wrong words", "[models][figure]") {
  const ProgramRun help = run_softgl({"figure", "--help"});
  CHECK(help.exit_code == 0);
  CHECK(std::count(help.output.begin(), help.output.end(), '\n') <= 100);
  const std::string examples = help.output.substr(help.output.find("Examples:"));
  size_t commands = 0;
  for (size_t at = examples.find("softgl figure"); at != std::string::npos;
       at = examples.find("softgl figure", at + 1))
    ++commands;
  CHECK(commands == 3);
  for (const Figure& figure : figures("en")) CHECK(help.output.find(figure.name) != std::string::npos);

  const std::string folder = output_folder("figures");
  const std::vector<std::vector<std::string>> wrong = {{"cosin", "-o", "-"},
                                                       {"cosine", "diffuse", "-o", folder + "x.svg"},
                                                       {"-o", folder + "x.tex"},
                                                       {"cosine", "-o", folder + "x.gif"},
                                                       {"cosine"},
                                                       {"--lang", "fr", "-o", "-"}};
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), "figure");
    const ProgramRun run = run_softgl(arguments);
    CHECK(run.exit_code == 2);
    CHECK(std::count(run.errors.begin(), run.errors.end(), '\n') == 1);
  }
  CHECK(run_softgl({"figure", "cosine", "-o", "/proc/nowhere/x.svg"}).exit_code == 4);
}
