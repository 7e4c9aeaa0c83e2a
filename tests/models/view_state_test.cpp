// softgl view without a window: keys and the mouse change a state, and the state is a command line.
#include <catch2/catch.hpp>

#include "common/program_error.h"
#include "view/drawing_effort.h"
#include "view/script.h"
#include "view/text_box.h"
#include "view/view_arguments.h"
#include "view/view_keys.h"
#include "view/view_motion.h"

#include <cmath>
#include <set>
#include <sstream>

using namespace softgl::cli;

namespace {

ParsedOptions parse(std::vector<const char*> words) {
  words.insert(words.begin(), {"softgl", "view"});
  return parse_options(int(words.size()), words.data());
}

ViewState state(std::vector<const char*> options = {}) {
  options.insert(options.begin(), "a.obj");
  return state_of(parse(options), {"a.obj", "b.obj", "c.obj"});
}

ViewState key(const ViewState& before, const std::string& name) {
  Event event;
  event.key = name;
  return apply(before, event);
}

ViewState mouse(const ViewState& before, Event::Kind kind, int x = 0, int y = 0,
                Event::Button button = Event::kLeft, bool shift = false) {
  Event event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  event.button = button;
  event.shift = shift;
  return apply(before, event);
}

ViewState drag(ViewState now, int x, int y, Event::Button button = Event::kLeft, bool shift = false) {
  now = mouse(now, Event::kPress, 0, 0, button, shift);
  now = mouse(now, Event::kMove, x, y);
  now = mouse(now, Event::kRelease);
  return mouse(now, Event::kMove, 50, 50); // without a button
}

// The picture had this camera: ten units before the middle, of a height of six.
ViewState seen(const ViewState& before) {
  Event event;
  event.kind = Event::kSeen;
  event.seen.orbit.distance = 10;
  event.seen.height = 6;
  return apply(before, event);
}

std::string text(const ViewState& state) {
  std::string line;
  for (const std::string& word : to_arguments(state)) line += (line.empty() ? "" : " ") + word;
  return line;
}

const std::string kPlain = "a.obj --size 800x600";

} // namespace

TEST_CASE("view: options of a picture stand in the state, and come back", "[models][view]") {
  CHECK(text(state()) == kPlain);
  for (const char* option : {"--view front",
                             "--az 20",
                             "--el=-12.5",
                             "--view left --az 10 --el 5",
                             "--roll 10",
                             "--zoom 2.5",
                             "--ortho",
                             "--eye 1,2,3",
                             "--eye=-1,2,3 --target 0,0,1 --view-up 0,0,1",
                             "--shading phong",
                             "--shading flat --specular reflection --terms ambient,specular --light "
                             "headlight --light=-1,2,3/color:red",
                             "--wireframe",
                             "--wireframe --edges sharp",
                             "--points --hidden-lines",
                             "--edges all --ground --aa 16",
                             "--bg white",
                             "--up=-Z --kd 0.5",
                             "--srgb --quiet",
                             "--pass normal",
                             "--crease 30 --format ppm"}) {
    INFO(option);
    std::vector<std::string> words;
    std::string line = option;
    for (size_t at = 0; at <= line.size();) {
      const size_t end = std::min(line.find(' ', at), line.size());
      words.push_back(line.substr(at, end - at));
      at = end + 1;
    }
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    std::string sorted = text(state(pointers));
    // The order may be another one.
    CHECK(sorted.size() == (kPlain + " " + option).size());
    for (const std::string& word : words) CHECK(sorted.find(word) != std::string::npos);
  }
  CHECK(text(state({"-s", "64x32"})) == "a.obj --size 64x32");
  CHECK(text(state({"--aa", "1"})) == kPlain);
}

TEST_CASE("view: what no window has is refused", "[models][view]") {
  for (const std::vector<const char*>& options :
       std::vector<std::vector<const char*>>{{"--turntable", "4", "--format", "gif"},
                                             {"--sheet", "2"},
                                             {"--view", "front,left"},
                                             {"--pass", "color,depth"},
                                             {"--format", "exr"},
                                             {"--strict"},
                                             {"--camera", "x.json"},
                                             {"--stats", "json"},
                                             {"--timeout", "5"}})
    CHECK_THROWS_AS(state(options), ProgramError);
}

TEST_CASE("view: each key changes its part of the command line, and back", "[models][view]") {
  const struct {
    const char *keys, *options;
  } rows[] = {{"2", " --view front"},
              {"3", " --view back"},
              {"4", " --view left"},
              {"5", " --view right"},
              {"6", " --view top"},
              {"7", " --view bottom"},
              {"1", ""},
              {"f", " --shading flat"},
              {"p", " --shading phong"},
              {"g", ""},
              {"v", " --specular reflection"},
              {"F2", " --terms diffuse,specular,emission"},
              {"F3", " --terms ambient,specular,emission"},
              {"F4", " --terms ambient,diffuse,emission"},
              {"F5", " --terms ambient,diffuse,specular"},
              {"w", " --wireframe"},
              {"d", " --points"},
              {"e", " --edges all"},
              {"x", " --hidden-lines"},
              {"b", " --ground"},
              {"o", " --ortho"},
              {"a", " --aa 4"},
              {"+", " --zoom 1.15"},
              {"Z", ""}};
  for (const auto& row : rows) {
    INFO(row.keys);
    const ViewState changed = key(state(), row.keys);
    CHECK(text(changed) == kPlain + row.options);
    CHECK(text(key(changed, "r")) == kPlain);
  }
  CHECK(text(key(key(state(), "w"), "w")) == kPlain);
  CHECK(text(key(key(state(), "w"), "d")) == kPlain + " --points");
  CHECK(text(key(key(state(), "e"), "e")) == kPlain + " --edges sharp");
  CHECK(text(key(key(state(), "a"), "a")) == kPlain + " --aa 16");
  CHECK(text(key(key(key(state(), "a"), "a"), "a")) == kPlain);
  ViewState last_term = state({"--terms", "diffuse"});
  CHECK(text(key(last_term, "F3")) == kPlain + " --terms diffuse"); // no picture without light
  CHECK(text(key(last_term, "F2")) == kPlain + " --terms ambient,diffuse");
  CHECK(key(state(), "h").help);
  CHECK(!key(key(state(), "h"), "F1").help);
  CHECK(key(state(), "q").request == ViewState::Request::kQuit);
  CHECK(key(state(), "Escape").request == ViewState::Request::kQuit);
  CHECK(key(state(), "s").request == ViewState::Request::kSave);
  std::set<std::string> explained;
  for (const std::string& line : key_lines()) {
    std::istringstream words(line.substr(0, line.find('\t')));
    for (std::string word; words >> word;) explained.insert(word);
  }
  for (const auto& row : rows) CHECK(explained.count(row.keys) == (*row.keys != 'Z'));
}

TEST_CASE("view: the mouse turns, moves and magnifies", "[models][view]") {
  CHECK(text(drag(state(), 100, 0)) == kPlain); // there is no picture yet
  const ViewState start = seen(state());
  CHECK(text(start) == kPlain);
  // 600 pixels are half a turn.
  CHECK(text(drag(start, 300, 0)) == kPlain + " --eye=-10,0,0 --target 0,0,0 --view-up 0,1,0");
  CHECK(text(drag(start, 0, 100)) == kPlain + " --eye 0,5,8.6603 --target 0,0,0 --view-up 0,0.86603,-0.5");
  CHECK(text(drag(drag(start, 0, 1000), 0, -300)) == kPlain + " --eye 0,0,10 --target 0,0,0 --view-up 0,1,0");
  // 100 pixels are one unit.
  const std::string moved = kPlain + " --eye=-1,0.5,10 --target=-1,0.5,0 --view-up 0,1,0";
  CHECK(text(drag(start, 100, 50, Event::kMiddle)) == moved);
  CHECK(text(drag(start, 100, 50, Event::kLeft, true)) == moved);
  const ViewState near = mouse(start, Event::kWheel, 0, 5);
  CHECK(text(near) == kPlain + " --zoom 2.011");
  CHECK(text(drag(start, 0, -100, Event::kRight)) == text(near));
  CHECK(text(mouse(near, Event::kWheel, 0, -5)) == kPlain);
  CHECK(near.seen->height == Approx(6 / std::pow(1.15, 5)));
  CHECK(state_of(parse({"a.obj"}), {"a.obj"}).zoom == 1);
  CHECK(mouse(start, Event::kWheel, 0, 1000).zoom == 1000);
  // A drag keeps what was rounded for the options.
  ViewState turned = drag(start, 1, 1);
  const Orbit orbit = *turned.orbit;
  turned = seen(turned);
  CHECK(turned.seen->orbit.azimuth == orbit.azimuth);
  CHECK(text(key(turned, "2")) == kPlain + " --view front");
  CHECK(text(key(turned, "r")) == kPlain);
  // Parallel rays have the height of the view that was fitted.
  const ViewState parallel = drag(seen(state({"--ortho", "--view", "top"})), 300, 0);
  CHECK(text(parallel) == kPlain + " --view top --eye=-10,0,0 --target 0,0,0 --view-up 0,1,0 --ortho");
  CHECK(text(key(seen(key(start, "Left")), "Right")) ==
        kPlain + " --eye 0,0,10 --target 0,0,0 --view-up 0,1,0");
}

TEST_CASE("view: the first light turns while l is held", "[models][view]") {
  const auto turned = [](const ViewState& start, int x, int y) {
    ViewState now = key(start, "l");
    now = drag(now, x, y);
    Event up;
    up.kind = Event::kKeyUp;
    up.key = "l";
    return apply(now, up);
  };
  const auto with = [](const char* light) { return seen(state({"--light", light, "--light", "0,1,0"})); };
  const std::string rest = " --light 0,1,0";
  CHECK(text(turned(with("headlight"), 300, 0)) == kPlain + " --light 1,0,0" + rest);
  CHECK(text(turned(with("headlight"), 0, 300)) == kPlain + " --light 0,-1,0" + rest);
  CHECK(text(turned(with("headlight"), 150, 0)) == kPlain + " --light 1,0,1" + rest);
  CHECK(text(turned(with("model:0,0,1/color:red"), 300, 0)) ==
        kPlain + " --light model:1,0,0/color:1,0,0" + rest);
  CHECK(text(turned(with("at:0,0,5/spot:0,0,-1/cutoff:20/attenuation:1,0.5,0"), 300, 0)) ==
        kPlain + " --light at:5,0,0/spot:-1,0,0/cutoff:20/attenuation:1,0.5,0" + rest);
  CHECK(text(turned(seen(state()), 0, 0)) == kPlain + " --light=-0.5,0.7222,1");
  CHECK(text(drag(turned(seen(state()), 0, 0), 0, 0)).find("--eye") != std::string::npos); // l was let go
  CHECK(text(turned(state(), 300, 0)) == kPlain);                                          // no picture yet
}

TEST_CASE("view: other models keep the direction", "[models][view]") {
  ViewState now = seen(state({"--eye", "1,2,3", "--shading", "phong"}));
  CHECK(text(key(now, "PageDown")) == "b.obj --size 800x600 --shading phong");
  CHECK(text(key(now, "PageUp")) == "c.obj --size 800x600 --shading phong");
  now = drag(now, 300, 100);
  now = key(now, "PageDown");
  CHECK(text(now) == "b.obj --size 800x600 --az=-90 --el 30 --shading phong");
  CHECK(!now.seen);
  CHECK(text(key(now, "r")) == "b.obj --size 800x600 --shading phong");
  CHECK(key(key(now, "PageDown"), "PageDown").model == 0);
}

TEST_CASE("view: the size of the window is that of the picture", "[models][view]") {
  ViewState now = mouse(state({"--aa", "16"}), Event::kResize, 1000, 500);
  CHECK(text(now) == "a.obj --size 1000x500 --aa 16");
  now = mouse(now, Event::kResize, 6000, 500);
  CHECK(text(now) == "a.obj --size 6000x500 --aa 4"); // GL draws 16384 samples a side
  CHECK(text(key(now, "r")) == "a.obj --size 6000x500 --aa 4");
  CHECK(text(mouse(now, Event::kResize, 0, 0)) == "a.obj --size 1x1 --aa 16");
}

TEST_CASE("view: the camera of a picture is an orbit", "[models][view]") {
  ModelFrame frame;
  frame.center[0] = 100;
  frame.scale = 0.25;
  for (const UpAxis up : {UpAxis::kPlusY, UpAxis::kMinusX, UpAxis::kPlusZ})
    for (const double elevation : {-90.0, -30.0, 0.0, 25.0, 90.0})
      for (const double roll : {0.0, 20.0}) {
        if (roll != 0 && std::fabs(elevation) == 90) continue; // azimuth and roll are one there
        CameraOptions options;
        options.azimuth = 35;
        options.elevation = elevation;
        options.roll = roll;
        options.up = up;
        const Axes axes = camera_axes(options);
        Camera camera{};
        set_view(camera, axes, 0.25, 0.5, 2);
        set_perspective(camera, options, 1, 3);
        const SeenCamera seen = seen_camera(camera, frame, up);
        INFO(int(up) << " " << elevation << " " << roll);
        CHECK(seen.orbit.azimuth == Approx(35));
        CHECK(seen.orbit.elevation == Approx(elevation).margin(1e-5));
        CHECK(seen.orbit.roll == Approx(roll).margin(1e-5));
        CHECK(seen.orbit.distance == Approx(8));
        CHECK(seen.height == Approx(2 * std::tan(15 / 57.29577951) * 8));
        const OrbitPlace place = place_of(seen.orbit, up);
        for (size_t i = 0; i < 3; ++i) {
          const double eye = 0.25 * axes.right[i] + 0.5 * axes.up[i] + 2 * axes.back[i];
          CHECK(place.eye[i] == Approx(eye * 4 + frame.center[i]).margin(1e-4));
          CHECK(place.view_up[i] == Approx(axes.up[i]).margin(1e-5));
        }
      }
}

TEST_CASE("view: command lines are words of a shell", "[models][view]") {
  CHECK(command_line({"a.obj", "--eye=-1,2", "-o", "x.png"}) == "softgl a.obj --eye=-1,2 -o x.png");
  CHECK(command_line({"my model.obj", "it's", "#fff", ""}) == "softgl 'my model.obj' 'it'\\''s' '#fff' ''");
  CHECK(to_arguments(state_of(parse({"x"}), {"info"}))[0] == "./info");
  CHECK(to_arguments(state_of(parse({"x"}), {"-x.obj"}))[0] == "./-x.obj");
}

TEST_CASE("view: scripts are events", "[models][view]") {
  const auto steps = parse_script("# nothing\n\nkey p\ndrag light 10 -20 # turns it\nwheel -2\nsize 40x30\n"
                                  "save a.png\nsave\nshot b.ppm\nwait reload\n",
                                  "s");
  REQUIRE(steps.size() == 8);
  CHECK(steps[0].events.size() == 2);
  CHECK(steps[0].events[0].key == "p");
  REQUIRE(steps[1].events.size() == 5);
  CHECK(steps[1].events[2].x == 10);
  CHECK(steps[1].events[2].y == -20);
  CHECK(steps[2].events[0].y == -2);
  CHECK(steps[3].events[0].x == 40);
  CHECK(steps[4].file == "a.png");
  CHECK(steps[5].kind == ScriptStep::kSave);
  CHECK(steps[6].kind == ScriptStep::kShot);
  CHECK(steps[7].kind == ScriptStep::kReload);
  for (const char* wrong : {"jump", "key", "key a b", "drag up 1 2", "drag left 1", "wheel", "size",
                            "size 0x4", "shot", "wait", "wait forever"})
    CHECK_THROWS_WITH(parse_script(std::string("key a\n") + wrong, "s.txt"),
                      Catch::Contains("s.txt:2: no step of a script"));
}

TEST_CASE("view: slow pictures are drawn with less while the mouse moves", "[models][view]") {
  DrawingEffort effort;
  const auto drawn = [&effort](double seconds) { effort.took(seconds, effort.reduction()); };
  effort.took(0.02, {});
  CHECK(!effort.reduction().one_sample);
  effort.took(0.4, {});
  CHECK(effort.reduction().one_sample);
  CHECK(effort.reduction().divisor == 1);
  drawn(0.2);
  drawn(0.1);
  CHECK(effort.reduction().divisor == 4);
  drawn(0.03);
  CHECK(effort.reduction().divisor == 4);
  drawn(0.005);
  CHECK(effort.reduction().divisor == 2);
  effort.took(0.2, {true, 1}); // better ones, once it is still
  effort.took(0.4, {});
  CHECK(effort.reduction().divisor == 2);
  for (int i = 0; i < 20; ++i) drawn(1);
  CHECK(effort.reduction().divisor == 8);
  effort.took(0.01, {});
  CHECK(!effort.reduction().one_sample);
}

TEST_CASE("view: text over the picture", "[models][view]") {
  const Picture one = draw_text_box({"abc"}, 400, 400), two = draw_text_box({"abc", "def"}, 400, 400),
                folded = draw_text_box({"one two three four five six seven eight nine ten"}, 200, 400),
                columns = draw_text_box({"a\tb"}, 400, 400), small = draw_text_box({"abc", "def"}, 400, 50);
  CHECK(one.channels == 4);
  CHECK(one.pixels.size() == 4 * size_t(one.width) * size_t(one.height));
  CHECK(two.height > one.height);
  CHECK(folded.width <= 200);
  CHECK(folded.height > 2 * one.height);
  CHECK(columns.height == one.height);
  CHECK(small.height <= 50);
  size_t letters = 0;
  for (size_t i = 0; i < one.pixels.size(); i += 4) letters += one.pixels[i] > 200;
  CHECK(letters > 60);
  CHECK(letters < one.pixels.size() / 8);
}
