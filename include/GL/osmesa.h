/* Off-screen rendering: the OSMesa interface, by softgl.
 *
 * A program that was compiled against another osmesa.h runs with softgl unchanged, and the other way round.
 */
#ifndef SOFTGL_GL_OSMESA_H
#define SOFTGL_GL_OSMESA_H
#ifndef OSMESA_H /* the name that Mesa's header uses: whichever comes first declares everything */
#define OSMESA_H

#include <GL/gl.h>

#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* Formats of the image buffer, for OSMesaCreateContext. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* OSMesaPixelStore and OSMesaGetIntegerv. */
#define OSMESA_ROW_LENGTH 0x10 /* pixels from a row to the next; 0: as many as the image is wide */
#define OSMESA_Y_UP 0x11       /* nonzero: the first row in memory is the lowest */

/* OSMesaGetIntegerv. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* OSMesaCreateContextAttribs. */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context* OSMesaContext;
typedef void (*OSMESAproc)();

/* A context with 24 bits of depth, 8 of stencil and no accumulation buffer. It shares display lists, textures
 * and buffers with `sharelist`, if that is not NULL. NULL on failure. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist);
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                                      GLint accumBits, OSMesaContext sharelist);
/* attribList: pairs of attribute and value, ended by 0. Buffers that it does not mention do not exist. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int* attribList, OSMesaContext sharelist);
GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext ctx);

/* Makes the context current in this thread, with an image buffer of width x height pixels of `type`. The
 * buffer is written by glFlush and glFinish and when the context loses its thread. Both NULL: no current
 * context any more. */
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext ctx, void* buffer, GLenum type, GLsizei width,
                                             GLsizei height);
GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);

GLAPI void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value);
GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint* value);

/* A copy of the depth buffer, bottom row first, in 2 or 4 bytes per value; it is brought up to date at
 * glFlush and glFinish and lives as long as the context. */
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext c, GLint* width, GLint* height,
                                                GLint* bytesPerValue, void** buffer);
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext c, GLint* width, GLint* height, GLint* format,
                                                void** buffer);

/* NULL when there is no such function. */
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char* funcName);

GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);
/* Accepted and ignored: softgl has no postprocessing filters. */
GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext osmesa, const char* filter, unsigned enable_value);

#ifdef __cplusplus
}
#endif

#endif
#endif
