#include "fuzz/arguments.h"

#include "fuzz/argument_forms.h"
#include "fuzz/input_memory.h"

#include <cstring>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

namespace softgl::test {
namespace {

// Values of arrays that are given with a count or a parameter. Long enough for control points and pixel maps.
constexpr size_t kArrayBytes = 1 << 17;
unsigned char* array_of(int parameter) {
  alignas(64) static unsigned char arrays[kMostParameters][kArrayBytes];
  return arrays[parameter];
}

// Names of what the library has beyond GL 1.5.
constexpr GLenum kExtensionNames[] = {
    GL_TEXTURE_RECTANGLE,
    GL_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_COLOR_ATTACHMENT0,
    GL_DEPTH_ATTACHMENT,
    GL_STENCIL_ATTACHMENT,
    GL_DEPTH_STENCIL_ATTACHMENT,
    GL_PIXEL_PACK_BUFFER,
    GL_PIXEL_UNPACK_BUFFER,
    GL_COPY_READ_BUFFER,
    GL_COPY_WRITE_BUFFER,
    GL_DEPTH_STENCIL,
    GL_UNSIGNED_INT_24_8,
    GL_DEPTH24_STENCIL8,
    GL_HALF_FLOAT,
    GL_RGBA16F,
    GL_R8,
    GL_RG,
    GL_RED,
    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL,
    GL_RENDERBUFFER_WIDTH,
    GL_RENDERBUFFER_INTERNAL_FORMAT,
    GL_RENDERBUFFER_SAMPLES,
    GL_RENDERBUFFER_DEPTH_SIZE,
};
constexpr GLenum kCompressedFormats[] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                                         GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                                         GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                                         GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                                         GL_COMPRESSED_RED_RGTC1,
                                         GL_COMPRESSED_SIGNED_RG_RGTC2,
                                         GL_COMPRESSED_RGB,
                                         GL_RGBA8,
                                         GL_RGBA,
                                         0};
constexpr GLenum kInternalFormats[] = {GL_RGBA,
                                       GL_RGB,
                                       GL_LUMINANCE,
                                       GL_ALPHA,
                                       GL_INTENSITY,
                                       GL_LUMINANCE_ALPHA,
                                       1,
                                       2,
                                       3,
                                       4,
                                       5,
                                       0,
                                       GL_RGBA8,
                                       GL_RGB5,
                                       GL_RGBA16,
                                       GL_DEPTH_COMPONENT,
                                       GL_DEPTH_COMPONENT24,
                                       GL_DEPTH24_STENCIL8,
                                       GL_COMPRESSED_RGBA,
                                       GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                                       GL_RGBA16F,
                                       GL_R8,
                                       GL_RG8,
                                       GL_COLOR_INDEX,
                                       GL_STENCIL_INDEX};

template <class List> auto one_of(const List& list, Choices& choices) {
  return list[size_t(choices.integer(0, int(std::size(list)) - 1))];
}

// The groups of names that parameters of commands have.
const std::vector<uint8_t>& groups() {
  static const std::vector<uint8_t> all = [] {
    std::set<uint8_t> found;
    for (const AnyCommand& command : any_commands())
      for (int i = 0; i < command.parameter_count; ++i) found.insert(command.parameters[i].group);
    for (uint8_t group : {kNoNames, kAnyName, kNamesOfParameter}) found.erase(group);
    return std::vector<uint8_t>(found.begin(), found.end());
  }();
  return all;
}

GLenum any_name(Choices& choices) {
  const int kind = choices.integer(0, 9);
  if (kind == 0) return GLenum(choices.pick({0, 1, 2, 7, 9, 0xdead, -1, 0x7fffffff}));
  if (kind <= 3) return one_of(kExtensionNames, choices);
  return one_of(names_of_group(one_of(groups(), choices)), choices).value;
}

GLenum name_in(uint8_t group, Choices& choices) {
  if (group <= kAnyName || group == kNamesOfParameter || choices.chance(15)) return any_name(choices);
  return one_of(names_of_group(group), choices).value;
}

double number(Choices& choices) {
  constexpr double kNumbers[] = {0,   1,    -1,    0.5,       2,        3,     4,     90,    91,   128, 129,
                                 180, 0.25, 0.125, 1048576.0, -65536.0, 1e-3f, 10.75, 255.5, -3.5, 16};
  return one_of(kNumbers, choices);
}

int64_t whole_number(Choices& choices) {
  constexpr int kNumbers[] = {
      -1, 0, 1, 2, 3, 4, 5, 7, 8, 16, 31, 32, 64, -100, 255, 0x7fffffff, -0x7fffffff - 1};
  return one_of(kNumbers, choices);
}

// By the letter of the form; false if the type decides.
bool choose_by_letter(char letter, Choices& choices, Argument& a) {
  const auto one = [&](std::initializer_list<int> values) {
    a.whole = choices.pick(values);
    return true;
  };
  const auto memory = [&](const void* bytes) {
    a.pointer = const_cast<void*>(bytes);
    return true;
  };
  switch (letter) {
  case 'n': return one({-1, 0, 1, 2, 3, 4, 7, 12, 20});
  case 'd': return one({-1, 0, 1, 1, 2, 3});
  case 'i': return one({0, 1, 5, 20, 0});
  case 'b': return one({0, 1, 3});
  case 'w': return one({-1, 0, 1, 2, 3, 4, 5, 8, 16, 33, 64, 20000});
  case 'v': return one({-1, 0, 1, 2, 3, 4, 8, 16, 5000});
  case 'r': return one({-1, 0, 1, 2, 4, 5, 8, 16, 33});
  case 's': return one({0, 0, 4, 16, 20, 64});
  case 'L': return one({0, 0, 0, 1, 2, 3, -1, 11, 20, 0x7fffffff});
  case 'B': return one({0, 0, 0, 0, 1, 2, -1});
  case 'o': return one({0, 0, 0, 1, 2, 4, -1, 8, 0x7fffffff});
  case 'c': return one({0, 0, 1, 8, 16, 64, -5, 1000});
  case 'S': return one({8, 16, 32, 64, 128, 4, 0, -1, 1024, 24});
  case 'z': return one({0, 1, 16, 64, 1000, 4096, -1});
  case 'y': return one({0, 0, 4, 16, 60, 4096, -1, 0x7fffffff});
  case 'h': return one({0, 1, 2, 3, 4, 5, 1, 2, 77});
  case 'g': return one({-1, 0, 1, 2, 3, 4});
  case 'D': return one({-1, 0, 1, 2, 10});
  case 't': return one({-1, 0, 1, 2, 3, 4, 5, 8, 64});
  case 'O': return one({-1, 0, 1, 2, 3, 4, 30, 31});
  case 'P': return one({-1, 0, 1, 2, 3, 4, 8, 16});
  case 'N': return one({-1, 0, 1, 2, 4, 32, 64, 256, 257});
  case 'q': return one({-1, 0, 1, 16, 1024});
  case '5': return one({0, 1, 2, 3, 4, 5, -1});
  case 'F': return a.whole = one_of(kCompressedFormats, choices), true;
  case 'f': return a.whole = choices.chance(80) ? one_of(kInternalFormats, choices) : any_name(choices), true;
  case 'k': return memory(input().indices);
  case 'T': return memory("a text that is longer than any length");
  case '0': return memory(nullptr);
  case 'K': return memory(input().index_arrays);
  case 'I': return memory(choices.chance(70) ? input().indices : nullptr);
  case 'l': return memory(input().indices + choices.integer(0, 3));
  case 'm': return memory(input().images + (1 << 20));
  case 'M': return memory(choices.chance(60) ? input().images : nullptr);
  case 'x': return memory(OutputMemory::bytes());
  default: return false;
  }
}

// The elements of an array, as many as any command reads.
void fill_array(const TraceParameter& p, uint8_t group, char letter, Choices& choices, unsigned char* bytes) {
  const size_t count = 260;
  uint64_t seed = choices.seed();
  Choices elements(seed);
  for (size_t i = 0; i < count; ++i) {
    Argument counted;
    const bool by_letter = choose_by_letter(letter, elements, counted);
    const bool named = !by_letter && group != kNoNames && elements.chance(85);
    const double real = by_letter ? double(counted.whole)
                        : named   ? double(name_in(group, elements))
                                  : number(elements);
    const int64_t whole = by_letter ? counted.whole
                          : named   ? name_in(group, elements)
                                    : whole_number(elements);
    const auto put = [&](auto value) { std::memcpy(bytes + i * sizeof value, &value, sizeof value); };
    switch (p.type) {
    case TraceType::Float: put(float(real)); break;
    case TraceType::Double: put(real); break;
    case TraceType::Byte:
    case TraceType::UnsignedByte: put(static_cast<unsigned char>(whole)); break;
    case TraceType::Boolean: put(static_cast<unsigned char>(whole & 1)); break;
    case TraceType::Short:
    case TraceType::UnsignedShort: put(uint16_t(whole)); break;
    case TraceType::UnsignedInt:
      put(uint32_t(by_letter || elements.chance(20) ? whole : elements.integer(0, 6)));
      break;
    default: put(int32_t(whole)); break;
    }
  }
}

} // namespace

unsigned char* OutputMemory::bytes() {
  alignas(64) static unsigned char memory[kBytes];
  return memory;
}

Arguments choose_arguments(const AnyCommand& command, Choices& choices) {
  Arguments all;
  const std::string_view letters = form_of(command.name);
  for (int i = 0; i < command.parameter_count; ++i) {
    const TraceParameter& p = command.parameters[i];
    Argument& a = all[size_t(i)];
    const char letter = size_t(i) < letters.size() ? letters[size_t(i)] : '.';
    const uint8_t group = p.group == kNamesOfParameter && i > 0
                              ? group_of_parameter(uint32_t(all[size_t(i) - 1].whole))
                              : p.group;
    const bool array =
        p.length != TraceLength::Value && p.type != TraceType::Pointer && p.type != TraceType::String;
    if (!array && choose_by_letter(letter, choices, a)) continue;
    if (p.out) {
      a.pointer = OutputMemory::bytes();
    } else if (p.type == TraceType::Pointer && p.length == TraceLength::Value) {
      a.pointer = array_of(i); // control points
      fill_array({p.name, TraceType::Float, kNoNames, p.length, 0, false}, kNoNames, '.', choices,
                 array_of(i));
    } else if (p.length != TraceLength::Value) {
      a.pointer = array_of(i);
      fill_array(p, group, letter, choices, array_of(i));
    } else {
      switch (p.type) {
      case TraceType::Float:
      case TraceType::Double:
        a.real = group != kNoNames && choices.chance(80) ? double(name_in(group, choices)) : number(choices);
        break;
      case TraceType::Enum: a.whole = name_in(group, choices); break;
      case TraceType::Bits:
        a.whole = choices.chance(70) && group > kAnyName ? name_in(group, choices)
                                                         : choices.pick({0, -1, 1, 2, 3, 0x4000, 0x4500});
        break;
      case TraceType::Boolean: a.whole = choices.integer(0, 1); break;
      default:
        a.whole = group != kNoNames && choices.chance(80) ? name_in(group, choices) : whole_number(choices);
        break;
      }
    }
  }
  return all;
}

} // namespace softgl::test
