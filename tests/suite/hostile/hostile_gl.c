/* A library of OSMesa's ABI that misbehaves: the environment variable HOSTILE_GL says how. What it does not
 * spoil is done by the library that HOSTILE_GL_REAL names. */
#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))
typedef void (*function)(void);

static int is(const char* kind) {
  const char* wanted = getenv("HOSTILE_GL");
  return wanted && strcmp(wanted, kind) == 0;
}
static function real(const char* name) {
  static void* library;
  if (!library) library = dlopen(getenv("HOSTILE_GL_REAL"), RTLD_NOW | RTLD_LOCAL);
  return library ? (function)dlsym(library, name) : NULL;
}

static void crash(void) { raise(SIGSEGV); }
static void hang(void) {
  for (;;) pause();
}
static void leave(void) { _exit(0); }
static void nothing(void) {}
static const char* no_string(unsigned name) { return name ? NULL : NULL; }
static unsigned error(void) { return 0x0502; }
static unsigned error_once_read(void) {
  static int calls;
  return ++calls % 2 ? 0 : 0x0502;
}
typedef void (*get_integers)(unsigned, int*);
/* Says that colors have one bit, so that every value would be right. */
static void few_bits(unsigned name, int* value) {
  ((get_integers)real("glGetIntegerv"))(name, value);
  if (name >= 0x0D52 && name <= 0x0D55) *value = 1;
}
static void no_bits(unsigned name, int* value) {
  ((get_integers)real("glGetIntegerv"))(name, value);
  if (name >= 0x0D52 && name <= 0x0D55) *value = 0;
}
/* All extensions that a test may ask for, whatever the library has. */
static const char* all_extensions(unsigned name) {
  if (name == 0x1F03) return "GL_WIN_phong_shading GL_EXT_separate_specular_color GL_EXT_rescale_normal";
  return name == 0x1F02 ? "9.9 of everything" : ((const char* (*)(unsigned))real("glGetString"))(name);
}
static void no_shade_model(unsigned mode) { (void)mode; }
static void garbage(int x, int y, int width, int height, unsigned format, unsigned type, void* to) {
  unsigned char* bytes = to;
  (void)x, (void)y, (void)format, (void)type;
  for (int i = 0; i < 4 * width * height; i++) bytes[i] = (unsigned char)(rand() >> 7);
}

EXPORT function OSMesaGetProcAddress(const char* name) {
  const int light = strcmp(name, "glLightfv") == 0, query = strncmp(name, "glGet", 5) == 0;
  if (is("no version") && strcmp(name, "glGetString") == 0) return (function)no_string;
  if (is("missing") && light) return NULL;
  if (is("crash") && light) return crash;
  if (is("hang") && light) return hang;
  if (is("leave") && light) return leave;
  if (is("does nothing") && !query) return nothing;
  if (is("always errors") && strcmp(name, "glGetError") == 0) return (function)error;
  if (is("errors") && strcmp(name, "glGetError") == 0) return (function)error_once_read;
  if (is("garbage") && strcmp(name, "glReadPixels") == 0) return (function)garbage;
  if (is("one bit") && strcmp(name, "glGetIntegerv") == 0) return (function)few_bits;
  if (is("no bits") && strcmp(name, "glGetIntegerv") == 0) return (function)no_bits;
  if (is("says it has all") && strcmp(name, "glGetString") == 0) return (function)all_extensions;
  if (is("says it has all") && strcmp(name, "glShadeModel") == 0) return (function)no_shade_model;
  return real(name);
}

/* Windows of other kinds, which are no fault. */
static int is_565(void) { return is("565") || is("565 y down"); }
EXPORT void* OSMesaCreateContextExt(unsigned format, int depth, int stencil, int accum, void* share) {
  if (is("no context")) return NULL;
  if (is_565()) format = 0x5, depth = 16, stencil = 0; /* OSMESA_RGB_565 */
  if (is("bgra")) format = 0x1;
  if (is("no depth")) depth = 0, stencil = 0;
  return ((void* (*)(unsigned, int, int, int, void*))real("OSMesaCreateContextExt"))(format, depth, stencil,
                                                                                     accum, share);
}
EXPORT unsigned char OSMesaMakeCurrent(void* context, void* buffer, unsigned type, int width, int height) {
  static unsigned char large[4 * 200 * 150];
  unsigned char made;
  if (is("not current")) return 0;
  if (is_565()) type = 0x8363; /* GL_UNSIGNED_SHORT_5_6_5 */
  if (is("small window")) width = height = 48;
  if (is("large window")) buffer = large, width = 200, height = 150;
  made = ((unsigned char (*)(void*, void*, unsigned, int, int))real("OSMesaMakeCurrent"))(
      context, buffer, type, width, height);
  if (is("565 y down")) ((void (*)(int, int))real("OSMesaPixelStore"))(0x11, 0); /* OSMESA_Y_UP */
  return made;
}
EXPORT void OSMesaDestroyContext(void* context) { ((void (*)(void*))real("OSMesaDestroyContext"))(context); }
