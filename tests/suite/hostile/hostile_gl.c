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
  return real(name);
}
EXPORT void* OSMesaCreateContextExt(unsigned format, int depth, int stencil, int accum, void* share) {
  if (is("no context")) return NULL;
  return ((void* (*)(unsigned, int, int, int, void*))real("OSMesaCreateContextExt"))(format, depth, stencil,
                                                                                     accum, share);
}
EXPORT unsigned char OSMesaMakeCurrent(void* context, void* buffer, unsigned type, int width, int height) {
  return ((unsigned char (*)(void*, void*, unsigned, int, int))real("OSMesaMakeCurrent"))(
      context, buffer, type, width, height);
}
EXPORT void OSMesaDestroyContext(void* context) { ((void (*)(void*))real("OSMesaDestroyContext"))(context); }
