// The drop-in library looks like libOSMesa.so.8 to the dynamic linker.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <dlfcn.h>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "support/gl.h"
#include "test_paths.h"

using namespace softgl::test;

namespace {

const std::string kBuiltLibrary = std::string(SOFTGL_TEST_BINARY_DIR) + "/../lib/softgl/libOSMesa.so.8";
const std::string kOwnLibrary = std::string(SOFTGL_TEST_BINARY_DIR) + "/../lib/libsoftgl.so";

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe);
  std::array<char, 4096> buffer;
  for (size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
  REQUIRE(pclose(pipe) == 0);
  return text;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (char c : text + "\n")
    if (!isspace(static_cast<unsigned char>(c)))
      word += c;
    else if (!word.empty())
      words.push_back(std::exchange(word, {}));
  return words;
}

std::set<std::string> exported_names(const std::string& library) {
  const auto words =
      words_of(output_of("nm -D --defined-only --format=posix '" + library + "' | cut -d' ' -f1"));
  return {words.begin(), words.end()};
}

std::set<std::string> recorded_names() {
  std::ifstream file(std::string(SOFTGL_TEST_SOURCE_DIR) + "/src/api/generate/symbols.txt");
  std::set<std::string> names;
  for (std::string name; file >> name;) names.insert(name);
  return names;
}

} // namespace

TEST_CASE("The drop-in library exports exactly the names of libOSMesa.so.8", "[abi]") {
  const auto ours = exported_names(kBuiltLibrary), expected = recorded_names();
  CHECK(expected.size() == 1305);
  std::vector<std::string> missing, extra;
  std::set_difference(expected.begin(), expected.end(), ours.begin(), ours.end(),
                      std::back_inserter(missing));
  std::set_difference(ours.begin(), ours.end(), expected.begin(), expected.end(), std::back_inserter(extra));
  CHECK(missing == std::vector<std::string>{});
  CHECK(extra == std::vector<std::string>{});
}

TEST_CASE("The recorded names are those of the system's libOSMesa", "[abi]") {
  CHECK(exported_names(osmesa_library().path) == recorded_names());
}

TEST_CASE("libsoftgl exports its own functions besides, and nothing of C++", "[abi]") {
  auto ours = exported_names(kOwnLibrary);
  for (const std::string& name : recorded_names()) CHECK(ours.erase(name) == 1);
  CHECK(ours == std::set<std::string>{"softgl_frame_hash", "softgl_get_statistics", "softgl_isa",
                                      "softgl_set_threads", "softgl_threads", "softgl_version"});
}

TEST_CASE("The libraries carry the names that programs ask for", "[abi]") {
  CHECK(output_of("readelf -d '" + kBuiltLibrary + "'").find("Library soname: [libOSMesa.so.8]") !=
        std::string::npos);
  CHECK(output_of("readelf -d '" + kOwnLibrary + "'").find("Library soname: [libsoftgl.so.0]") !=
        std::string::npos);
  for (const char* link : {"/libOSMesa.so", "/libOSMesa.so.6"}) {
    const std::string folder = kBuiltLibrary.substr(0, kBuiltLibrary.rfind('/'));
    CHECK(std::ifstream(folder + link).good());
  }
}

TEST_CASE("The libraries need the C and C++ run time and nothing else", "[abi]") {
  for (const std::string& library : {kBuiltLibrary, kOwnLibrary}) {
    const std::string text = output_of("readelf -d '" + library + "' | grep NEEDED");
    std::set<std::string> needed;
    for (size_t at = 0; (at = text.find('[', at)) != std::string::npos; ++at)
      needed.insert(text.substr(at + 1, text.find(']', at) - at - 1));
    for (const std::string& name : needed) {
      if (name.rfind("libasan", 0) == 0 || name.rfind("libubsan", 0) == 0 || name.rfind("libtsan", 0) == 0 ||
          name.rfind("libclang_rt", 0) == 0)
        continue;
      INFO(library << " needs " << name);
      const bool run_time = name == "libc.so.6" || name == "libm.so.6" || name == "libstdc++.so.6" ||
                            name == "libgcc_s.so.1" || name == "ld-linux-x86-64.so.2";
      CHECK(run_time);
    }
  }
}

TEST_CASE("One pointer is all the static thread-local storage", "[abi]") {
  // glibc keeps little of it for libraries that are loaded late.
  const std::string text = output_of("readelf -lW '" + kBuiltLibrary + "' | awk '$1 == \"TLS\" {print $6}'");
  CHECK(std::stoul(text, nullptr, 16) <= 64);
}

TEST_CASE("GetProcAddress finds what is built, and only that", "[abi]") {
  const Gl& gl = softgl_library();
  void* library = dlopen(gl.path.c_str(), RTLD_NOW | RTLD_LOCAL);
  REQUIRE(library);
  int found = 0;
  for (const std::string& name : recorded_names()) {
    const auto door = gl.OSMesaGetProcAddress(name.c_str());
    if (!door) continue;
    ++found;
    INFO(name);
    CHECK(reinterpret_cast<void*>(door) == dlsym(library, name.c_str()));
  }
  CHECK(found > 400);
  CHECK(gl.OSMesaGetProcAddress("glBegin") != nullptr);
  CHECK(gl.OSMesaGetProcAddress("glActiveTextureARB") != nullptr);
  CHECK(gl.OSMesaGetProcAddress("OSMesaMakeCurrent") != nullptr);
  // Names that libOSMesa.so.8 does not export, either.
  CHECK(gl.OSMesaGetProcAddress("glStencilFuncSeparateATI") != nullptr);
  CHECK(gl.OSMesaGetProcAddress("glBlendEquationSeparateEXT") ==
        gl.OSMesaGetProcAddress("glBlendEquationSeparate"));
  for (const char* name :
       {"glUseProgram", "glUniform1f", "glNoSuchFunction", "OSMesaNoSuchFunction", "", "gl"})
    CHECK(gl.OSMesaGetProcAddress(name) == nullptr);
  CHECK(gl.OSMesaGetProcAddress(nullptr) == nullptr);
  dlclose(library);
}

TEST_CASE("A function that is not supported raises GL_INVALID_OPERATION", "[abi]") {
  const Gl& gl = softgl_library();
  void* library = dlopen(gl.path.c_str(), RTLD_NOW | RTLD_LOCAL);
  auto use_program = reinterpret_cast<void (*)(GLuint)>(dlsym(library, "glUseProgram"));
  auto create_shader = reinterpret_cast<GLuint (*)(GLenum)>(dlsym(library, "glCreateShader"));
  REQUIRE(use_program);
  REQUIRE(create_shader);
  use_program(1); // without a context: nothing
  std::vector<unsigned char> buffer(16 * 16 * 4);
  void* context = gl.OSMesaCreateContext(kOSMesaRgba, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16));
  CHECK(gl.GetError() == GL_NO_ERROR);
  use_program(1);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  CHECK(create_shader(GL_VERTEX_SHADER) == 0);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.OSMesaDestroyContext(context);
  dlclose(library);
}
