#include "texture/view_class.h"

namespace softgl {
namespace {

constexpr ViewFormat kFormats[] = {
    {GL_RGBA32F, ViewClass::Bits128, GL_RGBA, GL_FLOAT},
    {GL_RGB32F, ViewClass::Bits96, GL_RGB, GL_FLOAT},
    {GL_RGBA16F, ViewClass::Bits64, GL_RGBA, GL_HALF_FLOAT},
    {GL_RG32F, ViewClass::Bits64, GL_RG, GL_FLOAT},
    {GL_RGBA16, ViewClass::Bits64, GL_RGBA, GL_UNSIGNED_SHORT},
    {GL_RGBA16_SNORM, ViewClass::Bits64, GL_RGBA, GL_SHORT},
    {GL_RGB16F, ViewClass::Bits48, GL_RGB, GL_HALF_FLOAT},
    {GL_RGB16, ViewClass::Bits48, GL_RGB, GL_UNSIGNED_SHORT},
    {GL_RGB16_SNORM, ViewClass::Bits48, GL_RGB, GL_SHORT},
    {GL_RG16F, ViewClass::Bits32, GL_RG, GL_HALF_FLOAT},
    {GL_R11F_G11F_B10F, ViewClass::Bits32, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV},
    {GL_R32F, ViewClass::Bits32, GL_RED, GL_FLOAT},
    {GL_RGB10_A2, ViewClass::Bits32, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
    {GL_RGBA8, ViewClass::Bits32, GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_RG16, ViewClass::Bits32, GL_RG, GL_UNSIGNED_SHORT},
    {GL_RGBA8_SNORM, ViewClass::Bits32, GL_RGBA, GL_BYTE},
    {GL_RG16_SNORM, ViewClass::Bits32, GL_RG, GL_SHORT},
    {GL_SRGB8_ALPHA8, ViewClass::Bits32, GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_RGB9_E5, ViewClass::Bits32, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV},
    {GL_RGB8, ViewClass::Bits24, GL_RGB, GL_UNSIGNED_BYTE},
    {GL_RGB8_SNORM, ViewClass::Bits24, GL_RGB, GL_BYTE},
    {GL_SRGB8, ViewClass::Bits24, GL_RGB, GL_UNSIGNED_BYTE},
    {GL_R16F, ViewClass::Bits16, GL_RED, GL_HALF_FLOAT},
    {GL_RG8, ViewClass::Bits16, GL_RG, GL_UNSIGNED_BYTE},
    {GL_R16, ViewClass::Bits16, GL_RED, GL_UNSIGNED_SHORT},
    {GL_RG8_SNORM, ViewClass::Bits16, GL_RG, GL_BYTE},
    {GL_R16_SNORM, ViewClass::Bits16, GL_RED, GL_SHORT},
    {GL_R8, ViewClass::Bits8, GL_RED, GL_UNSIGNED_BYTE},
    {GL_R8_SNORM, ViewClass::Bits8, GL_RED, GL_BYTE},
    {GL_COMPRESSED_RED_RGTC1, ViewClass::Rgtc1, 0, 0},
    {GL_COMPRESSED_SIGNED_RED_RGTC1, ViewClass::Rgtc1, 0, 0},
    {GL_COMPRESSED_RG_RGTC2, ViewClass::Rgtc2, 0, 0},
    {GL_COMPRESSED_SIGNED_RG_RGTC2, ViewClass::Rgtc2, 0, 0},
    {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, ViewClass::S3tcDxt1Rgb, 0, 0},
    {GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, ViewClass::S3tcDxt1Rgb, 0, 0},
    {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, ViewClass::S3tcDxt1Rgba, 0, 0},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, ViewClass::S3tcDxt1Rgba, 0, 0},
    {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, ViewClass::S3tcDxt3, 0, 0},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, ViewClass::S3tcDxt3, 0, 0},
    {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, ViewClass::S3tcDxt5, 0, 0},
    {GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, ViewClass::S3tcDxt5, 0, 0},
};

} // namespace

const ViewFormat* view_format(GLenum internal_format) {
  for (const ViewFormat& f : kFormats)
    if (f.internal_format == internal_format) return &f;
  return nullptr;
}

int block_copy_bytes(ViewClass view_class) {
  switch (view_class) {
  case ViewClass::Bits64:
  case ViewClass::Rgtc1:
  case ViewClass::S3tcDxt1Rgb:
  case ViewClass::S3tcDxt1Rgba: return 8;
  case ViewClass::Bits128:
  case ViewClass::Rgtc2:
  case ViewClass::S3tcDxt3:
  case ViewClass::S3tcDxt5: return 16;
  default: return 0;
  }
}

} // namespace softgl
