// Which storage an internal format gets (GL 1.5, tables 3.15 to 3.17, and those of the extensions).
#include "texture/texel_format.h"

namespace softgl {

namespace {

constexpr TexelLayout k8 = TexelLayout::Rgba8, k16 = TexelLayout::Rgba16, kDepth = TexelLayout::Depth;
constexpr TexelFormat kRgba8{GL_RGBA, k8, true, {8, 8, 8, 8}}, kRgb8{GL_RGB, k8, true, {8, 8, 8, 0}};
constexpr TexelFormat kAlpha8{GL_ALPHA, k8, true, {0, 0, 0, 8}},
    kLuminance8{GL_LUMINANCE, k8, true, {8, 8, 8, 0}};
constexpr TexelFormat kLuminanceAlpha8{GL_LUMINANCE_ALPHA, k8, true, {8, 8, 8, 8}},
    kIntensity8{GL_INTENSITY, k8, true, {8, 8, 8, 8}};
constexpr TexelFormat kLuminanceAlpha4{GL_LUMINANCE_ALPHA, k8, false, {4, 4, 4, 4}};
constexpr TexelFormat kRgb332{GL_RGB, k8, false, {3, 3, 2, 0}}, kRgb4{GL_RGB, k8, false, {4, 4, 4, 0}};
constexpr TexelFormat kRgb5{GL_RGB, k8, false, {5, 5, 5, 0}}, kRgb565{GL_RGB, k8, false, {5, 6, 5, 0}};
constexpr TexelFormat kRgba4{GL_RGBA, k8, false, {4, 4, 4, 4}}, kRgb5a1{GL_RGBA, k8, false, {5, 5, 5, 1}};
constexpr TexelFormat kRgb10{GL_RGB, k16, false, {10, 10, 10, 0}},
    kRgb10a2{GL_RGBA, k16, false, {10, 10, 10, 2}};
constexpr TexelFormat kRgba16{GL_RGBA, k16, true, {16, 16, 16, 16}},
    kRgb16{GL_RGB, k16, true, {16, 16, 16, 0}};
constexpr TexelFormat kAlpha16{GL_ALPHA, k16, true, {0, 0, 0, 16}},
    kLuminance16{GL_LUMINANCE, k16, true, {16, 16, 16, 0}};
constexpr TexelFormat kLuminanceAlpha16{GL_LUMINANCE_ALPHA, k16, true, {16, 16, 16, 16}};
constexpr TexelFormat kIntensity16{GL_INTENSITY, k16, true, {16, 16, 16, 16}};
constexpr TexelFormat kDepth16{GL_DEPTH_COMPONENT, kDepth, true, {16, 0, 0, 0}},
    kDepth24{GL_DEPTH_COMPONENT, kDepth, true, {24, 0, 0, 0}};
constexpr TexelFormat kDepth32{GL_DEPTH_COMPONENT, kDepth, true, {32, 0, 0, 0}};
constexpr TexelFormat kDepth24Stencil8{GL_DEPTH_STENCIL, kDepth, true, {24, 0, 0, 0}};
constexpr TexelFormat kDepth32f{GL_DEPTH_COMPONENT, kDepth, true, {32, 0, 0, 0}, true};
constexpr TexelFormat kDepth32fStencil8{GL_DEPTH_STENCIL, kDepth, true, {32, 0, 0, 0}, true};

/// Components of one size.
constexpr TexelFormat format_of(GLenum base, TexelLayout layout, int bits, bool srgb = false) {
  const bool first = base != GL_ALPHA, second = first && base != GL_RED, third = second && base != GL_RG,
             alpha =
                 base == GL_RGBA || base == GL_ALPHA || base == GL_LUMINANCE_ALPHA || base == GL_INTENSITY;
  const auto size = [&](bool has) { return uint8_t(has ? bits : 0); };
  return {base, layout, true, {size(first), size(second), size(third), size(alpha)}, false, BlockFormat::None,
          srgb};
}
constexpr TexelFormat blocks_of(GLenum base, BlockFormat block, bool has_sign, bool srgb) {
  TexelFormat f = format_of(base, has_sign ? TexelLayout::Signed16 : k8, 8, srgb);
  f.block = block;
  return f;
}
template <GLenum base, int bits>
constexpr TexelFormat kUnsigned = format_of(base, bits == 8 ? k8 : k16, bits);
template <GLenum base, int bits> constexpr TexelFormat kSigned = format_of(base, TexelLayout::Signed16, bits);
template <GLenum base, int bits> constexpr TexelFormat kFloat = format_of(base, TexelLayout::Float, bits);
template <GLenum base> constexpr TexelFormat kSrgb = format_of(base, k8, 8, true);
template <GLenum base, BlockFormat block, bool has_sign = false, bool srgb = false>
constexpr TexelFormat kBlocks = blocks_of(base, block, has_sign, srgb);
constexpr TexelFormat kPackedFloat{GL_RGB, TexelLayout::Float, false, {11, 11, 10, 0}},
    kSharedExponent{GL_RGB, TexelLayout::Float, false, {9, 9, 9, 0}};

// Unsized internal formats take the client's own precision where OSMesa has a storage of just that form.
const TexelFormat* match_unsized(GLint internal_format, GLenum format, GLenum type, bool swap_bytes) {
  const bool rgba = format == GL_RGBA || format == GL_BGRA;
  if (!swap_bytes) {
    switch (internal_format) {
    case GL_ALPHA:
      if (format == GL_ALPHA && type == GL_UNSIGNED_SHORT) return &kAlpha16;
      break;
    case GL_LUMINANCE:
      if (format == GL_LUMINANCE && type == GL_UNSIGNED_SHORT) return &kLuminance16;
      break;
    case GL_RED:
      if (format == GL_RED && type == GL_UNSIGNED_SHORT) return &kUnsigned<GL_RED, 16>;
      break;
    case GL_RG:
      if (format == GL_RG && type == GL_UNSIGNED_SHORT) return &kUnsigned<GL_RG, 16>;
      break;
    case GL_LUMINANCE_ALPHA:
      if (format == GL_LUMINANCE_ALPHA && type == GL_UNSIGNED_SHORT) return &kLuminanceAlpha16;
      break;
    case GL_RGB:
      if (format == GL_RGB && (type == GL_UNSIGNED_SHORT_5_6_5 || type == GL_UNSIGNED_SHORT_5_6_5_REV))
        return &kRgb565;
      break;
    case GL_RGBA:
      if (rgba && (type == GL_UNSIGNED_SHORT_4_4_4_4 || type == GL_UNSIGNED_SHORT_4_4_4_4_REV))
        return &kRgba4;
      if (rgba && type == GL_UNSIGNED_SHORT_1_5_5_5_REV) return &kRgb5a1;
      if (format == GL_RGBA && type == GL_UNSIGNED_SHORT) return &kRgba16;
      if (rgba && type == GL_UNSIGNED_INT_10_10_10_2) return &kRgb10a2;
      break;
    case GL_DEPTH_COMPONENT:
      if (type == GL_UNSIGNED_SHORT) return &kDepth16;
      if (type == GL_UNSIGNED_INT) return &kDepth32;
      break;
    default: break;
    }
  }
  if (internal_format == GL_RGB && format == GL_RGB &&
      (type == GL_UNSIGNED_BYTE_3_3_2 || type == GL_UNSIGNED_BYTE_2_3_3_REV))
    return &kRgb332;
  if (type == GL_UNSIGNED_INT_2_10_10_10_REV)
    return internal_format == GL_RGB ? &kRgb10 : internal_format == GL_RGBA ? &kRgb10a2 : nullptr;
  if (type == GL_UNSIGNED_SHORT_5_5_5_1)
    return internal_format == GL_RGB ? &kRgb5 : internal_format == GL_RGBA ? &kRgb5a1 : nullptr;
  return nullptr;
}

} // namespace

GLenum base_internal_format(GLint internal_format) {
  const TexelFormat* f = choose_texel_format(internal_format, 0, 0, false);
  return f ? f->base : 0;
}

const TexelFormat* choose_texel_format(GLint internal_format, GLenum format, GLenum type, bool swap_bytes) {
  if (const TexelFormat* f = match_unsized(internal_format, format, type, swap_bytes)) return f;
  switch (internal_format) {
  case 4:
  case GL_RGBA:
  case GL_RGBA8:
  case GL_COMPRESSED_RGBA: return &kRgba8;
  case 3:
  case GL_RGB:
  case GL_RGB8:
  case GL_COMPRESSED_RGB: return &kRgb8;
  case 2:
  case GL_LUMINANCE_ALPHA:
  case GL_LUMINANCE6_ALPHA2:
  case GL_LUMINANCE8_ALPHA8:
  case GL_COMPRESSED_LUMINANCE_ALPHA: return &kLuminanceAlpha8;
  case 1:
  case GL_LUMINANCE:
  case GL_LUMINANCE4:
  case GL_LUMINANCE8:
  case GL_COMPRESSED_LUMINANCE: return &kLuminance8;
  case GL_ALPHA:
  case GL_ALPHA4:
  case GL_ALPHA8:
  case GL_COMPRESSED_ALPHA: return &kAlpha8;
  case GL_INTENSITY:
  case GL_INTENSITY4:
  case GL_INTENSITY8:
  case GL_COMPRESSED_INTENSITY: return &kIntensity8;
  case GL_LUMINANCE4_ALPHA4: return &kLuminanceAlpha4;
  case GL_R3_G3_B2: return &kRgb332;
  case GL_RGB4: return &kRgb4;
  case GL_RGB5: return &kRgb5;
  case GL_RGB565: return &kRgb565;
  case GL_RGB10: return &kRgb10;
  case GL_RGB12:
  case GL_RGB16: return &kRgb16;
  case GL_RGBA2:
  case GL_RGBA4: return &kRgba4;
  case GL_RGB5_A1: return &kRgb5a1;
  case GL_RGB10_A2: return &kRgb10a2;
  case GL_RGBA12:
  case GL_RGBA16: return &kRgba16;
  case GL_ALPHA12:
  case GL_ALPHA16: return &kAlpha16;
  case GL_LUMINANCE12:
  case GL_LUMINANCE16: return &kLuminance16;
  case GL_LUMINANCE12_ALPHA4:
  case GL_LUMINANCE12_ALPHA12:
  case GL_LUMINANCE16_ALPHA16: return &kLuminanceAlpha16;
  case GL_INTENSITY12:
  case GL_INTENSITY16: return &kIntensity16;
  case GL_DEPTH_COMPONENT16: return &kDepth16;
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT24: return &kDepth24;
  case GL_DEPTH_COMPONENT32: return &kDepth32;
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8: return &kDepth24Stencil8;
  case GL_DEPTH_COMPONENT32F: return &kDepth32f;
  case GL_DEPTH32F_STENCIL8: return &kDepth32fStencil8;
  case GL_RGB_S3TC: // GL_S3_s3tc
  case GL_RGB4_S3TC:
  case GL_COMPRESSED_RGB_S3TC_DXT1_EXT: return &kBlocks<GL_RGB, BlockFormat::Dxt1Rgb>;
  case GL_COMPRESSED_SRGB_S3TC_DXT1_EXT: return &kBlocks<GL_RGB, BlockFormat::Dxt1Rgb, false, true>;
  case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt1Rgba>;
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt1Rgba, false, true>;
  case GL_RGBA_S3TC:
  case GL_RGBA4_S3TC:
  case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt3>;
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt3, false, true>;
  case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt5>;
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT: return &kBlocks<GL_RGBA, BlockFormat::Dxt5, false, true>;
  case GL_COMPRESSED_RGB_FXT1_3DFX: return &kBlocks<GL_RGB, BlockFormat::Fxt1Rgb>;
  case GL_COMPRESSED_RGBA_FXT1_3DFX: return &kBlocks<GL_RGBA, BlockFormat::Fxt1Rgba>;
  case GL_COMPRESSED_RED_RGTC1: return &kBlocks<GL_RED, BlockFormat::Red>;
  case GL_COMPRESSED_SIGNED_RED_RGTC1: return &kBlocks<GL_RED, BlockFormat::Red, true>;
  case GL_COMPRESSED_RG_RGTC2: return &kBlocks<GL_RG, BlockFormat::RedGreen>;
  case GL_COMPRESSED_SIGNED_RG_RGTC2: return &kBlocks<GL_RG, BlockFormat::RedGreen, true>;
  case GL_COMPRESSED_LUMINANCE_LATC1_EXT: return &kBlocks<GL_LUMINANCE, BlockFormat::Luminance>;
  case GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT: return &kBlocks<GL_LUMINANCE, BlockFormat::Luminance, true>;
  case GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT:
    return &kBlocks<GL_LUMINANCE_ALPHA, BlockFormat::LuminanceAlpha>;
  case GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT:
    return &kBlocks<GL_LUMINANCE_ALPHA, BlockFormat::LuminanceAlpha, true>;
  case GL_SRGB:
  case GL_SRGB8:
  case GL_COMPRESSED_SRGB: return &kSrgb<GL_RGB>;
  case GL_SRGB_ALPHA:
  case GL_SRGB8_ALPHA8:
  case GL_COMPRESSED_SRGB_ALPHA: return &kSrgb<GL_RGBA>;
  case GL_SLUMINANCE:
  case GL_SLUMINANCE8:
  case GL_COMPRESSED_SLUMINANCE: return &kSrgb<GL_LUMINANCE>;
  case GL_SLUMINANCE_ALPHA:
  case GL_SLUMINANCE8_ALPHA8:
  case GL_COMPRESSED_SLUMINANCE_ALPHA: return &kSrgb<GL_LUMINANCE_ALPHA>;
  case GL_RGBA32F: return &kFloat<GL_RGBA, 32>;
  case GL_RGB32F: return &kFloat<GL_RGB, 32>;
  case GL_ALPHA32F_ARB: return &kFloat<GL_ALPHA, 32>;
  case GL_LUMINANCE32F_ARB: return &kFloat<GL_LUMINANCE, 32>;
  case GL_LUMINANCE_ALPHA32F_ARB: return &kFloat<GL_LUMINANCE_ALPHA, 32>;
  case GL_INTENSITY32F_ARB: return &kFloat<GL_INTENSITY, 32>;
  case GL_R32F: return &kFloat<GL_RED, 32>;
  case GL_RG32F: return &kFloat<GL_RG, 32>;
  case GL_RGBA16F: return &kFloat<GL_RGBA, 16>;
  case GL_RGB16F: return &kFloat<GL_RGB, 16>;
  case GL_ALPHA16F_ARB: return &kFloat<GL_ALPHA, 16>;
  case GL_LUMINANCE16F_ARB: return &kFloat<GL_LUMINANCE, 16>;
  case GL_LUMINANCE_ALPHA16F_ARB: return &kFloat<GL_LUMINANCE_ALPHA, 16>;
  case GL_INTENSITY16F_ARB: return &kFloat<GL_INTENSITY, 16>;
  case GL_R16F: return &kFloat<GL_RED, 16>;
  case GL_RG16F: return &kFloat<GL_RG, 16>;
  case GL_R11F_G11F_B10F: return &kPackedFloat;
  case GL_RGB9_E5: return &kSharedExponent;
  case GL_RED:
  case GL_R8:
  case GL_COMPRESSED_RED: return &kUnsigned<GL_RED, 8>;
  case GL_RG:
  case GL_RG8:
  case GL_COMPRESSED_RG: return &kUnsigned<GL_RG, 8>;
  case GL_R16: return &kUnsigned<GL_RED, 16>;
  case GL_RG16: return &kUnsigned<GL_RG, 16>;
  case GL_RED_SNORM:
  case GL_R8_SNORM: return &kSigned<GL_RED, 8>;
  case GL_R16_SNORM: return &kSigned<GL_RED, 16>;
  case GL_RG_SNORM:
  case GL_RG8_SNORM: return &kSigned<GL_RG, 8>;
  case GL_RG16_SNORM: return &kSigned<GL_RG, 16>;
  case GL_RGB_SNORM:
  case GL_RGB8_SNORM: return &kSigned<GL_RGB, 8>;
  case GL_RGB16_SNORM: return &kSigned<GL_RGB, 16>;
  case GL_RGBA_SNORM:
  case GL_RGBA8_SNORM: return &kSigned<GL_RGBA, 8>;
  case GL_RGBA16_SNORM: return &kSigned<GL_RGBA, 16>;
  case GL_ALPHA_SNORM:
  case GL_ALPHA8_SNORM: return &kSigned<GL_ALPHA, 8>;
  case GL_ALPHA16_SNORM: return &kSigned<GL_ALPHA, 16>;
  case GL_LUMINANCE_SNORM:
  case GL_LUMINANCE8_SNORM: return &kSigned<GL_LUMINANCE, 8>;
  case GL_LUMINANCE16_SNORM: return &kSigned<GL_LUMINANCE, 16>;
  case GL_LUMINANCE_ALPHA_SNORM:
  case GL_LUMINANCE8_ALPHA8_SNORM: return &kSigned<GL_LUMINANCE_ALPHA, 8>;
  case GL_LUMINANCE16_ALPHA16_SNORM: return &kSigned<GL_LUMINANCE_ALPHA, 16>;
  case GL_INTENSITY_SNORM:
  case GL_INTENSITY8_SNORM: return &kSigned<GL_INTENSITY, 8>;
  case GL_INTENSITY16_SNORM: return &kSigned<GL_INTENSITY, 16>;
  default: return nullptr;
  }
}

} // namespace softgl
