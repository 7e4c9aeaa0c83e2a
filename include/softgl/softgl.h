/* softgl's own functions, beside OpenGL 1.5 (GL/gl.h) and OSMesa (GL/osmesa.h). */
#ifndef SOFTGL_SOFTGL_H
#define SOFTGL_SOFTGL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the library that runs, "major.minor.patch". <softgl/version.h> has the one that a program
 * was compiled against: SOFTGL_VERSION_MAJOR, SOFTGL_VERSION_MINOR and SOFTGL_VERSION_PATCH.
 *
 * Versions are semantic. Up to 1.0 a new minor version may break a program or change a picture, from then on
 * a new major one. */
const char* softgl_version(void);

/* How many threads draw, the calling one included. The picture does not depend on it. The environment
 * variable SOFTGL_THREADS sets the number at the start; without it there is one per processor. Values below 1
 * count as 1. */
void softgl_set_threads(int count);
int softgl_threads(void);

/* The instruction set in use: "baseline", "v2", "v3" or "v4" (the levels of x86-64). The environment variable
 * SOFTGL_ISA forces a lower one than the processor has. The picture does not depend on it either. */
const char* softgl_isa(void);

/* Finishes all rendering of the current context and returns a hash of its colors, depth and stencil: equal
 * pictures have equal hashes, on every machine. 0 without a current context. The caller's buffer is not
 * touched. */
uint64_t softgl_frame_hash(void);

/* GL_SOFTGL_phong_illumination (reference/extensions): glLightModel and glGet with these names. The values
 * are those of no other extension: the registry gives out none above 108999. They are exact as floats. */
#define GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL 0x5F6000
#define GL_HALF_VECTOR_SOFTGL 0x5F6001       /* (n.h)^a, OpenGL's highlight; the initial value */
#define GL_REFLECTION_VECTOR_SOFTGL 0x5F6002 /* (v.r)^a, Phong's */
#define GL_LIGHT_MODEL_TERMS_SOFTGL 0x5F6003
#define GL_EMISSION_TERM_BIT_SOFTGL 1
#define GL_AMBIENT_TERM_BIT_SOFTGL 2
#define GL_DIFFUSE_TERM_BIT_SOFTGL 4
#define GL_SPECULAR_TERM_BIT_SOFTGL 8
#define GL_ALL_TERM_BITS_SOFTGL 15 /* the initial value */

/* An attribute of OSMesaCreateContextAttribs, beside OSMesa's own. 1: GL_QUADS are cut into triangles where
 * OSMesa 22.3.6 cuts them, which depends on lists, indices and clipping. 0: by the shade model alone. The
 * environment variable SOFTGL_QUADS=osmesa makes 1 the default. */
#define SOFTGL_OSMESA_QUADS 0x5F6010

/* An attribute of OSMesaCreateContextAttribs. 1: where OSMesa 22.3.6 leaves the specification and softgl
 * draws its bytes, the picture is the specification's (the rows of reference/FIDELITY.md that say so). 0: it
 * is OSMesa's. The environment variable SOFTGL_ANSWERS=specification makes 1 the default. */
#define SOFTGL_SPECIFICATION_ANSWERS 0x5F6012

/* An attribute for OSMesaCreateContextAttribs: samples of a pixel of the context's image, 0 (the default:
 * one) or 4. The caller's buffer gets the mean of a pixel's samples, and so does who reads pixels. The
 * environment variable SOFTGL_SAMPLES=4 gives 4 to the contexts of programs that do not know of it. */
#define SOFTGL_SAMPLES 0x5F6011

/* What the current context has done so far. */
struct softgl_statistics {
  uint64_t flushes;  /* times that waiting work was carried out */
  uint64_t resolves; /* times that the caller's buffer was written */
  uint64_t clears;   /* glClear calls with an effect */
  uint64_t reads;    /* glReadPixels calls with an effect */
};
/* All zeros without a current context. */
void softgl_get_statistics(struct softgl_statistics* statistics);

#ifdef __cplusplus
}
#endif

#endif
