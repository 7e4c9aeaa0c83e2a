// Takes the place of libwaffle-1.so.0, libGL.so.1 and libEGL.so.1 for the programs of piglit. Contexts and
// functions come from a library with the functions of OSMesa; a window is memory.
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include <waffle.h>

enum { kRgba = 0x1908, kUnsignedByte = 0x1401 };
typedef void (*Function)(void);

static void* (*create_context)(unsigned format, int depth, int stencil, int accumulation, void* share);
static void (*destroy_context)(void* context);
static unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height);
static Function (*get_proc_address)(const char* name);

struct waffle_display {
  int unused;
};
struct waffle_config {
  int unused;
};
struct waffle_context {
  void* osmesa;
};
struct waffle_window {
  int width, height;
  unsigned char* pixels;
};

static const char* problem = "";
static void* fail(const char* what) {
  problem = what;
  return NULL;
}

const struct waffle_error_info* waffle_error_get_info(void) {
  static struct waffle_error_info info;
  info.code = *problem ? WAFFLE_ERROR_UNSUPPORTED_ON_PLATFORM : WAFFLE_NO_ERROR;
  info.message = problem;
  return &info;
}
const char* waffle_error_to_string(enum waffle_error error) {
  return error == WAFFLE_NO_ERROR ? "no error" : "not supported";
}

static Function symbol(void* library, const char* name) {
  Function function;
  *(void**)&function = dlsym(library, name);
  if (!function) {
    fprintf(stderr, "SOFTGL_PIGLIT_LIBRARY has no %s\n", name);
    exit(1);
  }
  return function;
}

bool waffle_init(const int32_t* attributes) {
  (void)attributes;
  if (create_context) return true;
  const char* path = getenv("SOFTGL_PIGLIT_LIBRARY");
  void* library = path ? dlopen(path, RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!library) return fail(path ? dlerror() : "SOFTGL_PIGLIT_LIBRARY is not set") != NULL;
  create_context = (void* (*)(unsigned, int, int, int, void*))symbol(library, "OSMesaCreateContextExt");
  destroy_context = (void (*)(void*))symbol(library, "OSMesaDestroyContext");
  make_current = (unsigned char (*)(void*, void*, unsigned, int, int))symbol(library, "OSMesaMakeCurrent");
  get_proc_address = (Function(*)(const char*))symbol(library, "OSMesaGetProcAddress");
  return true;
}

void* waffle_get_proc_address(const char* name) {
  void* pointer;
  *(Function*)&pointer = get_proc_address(name);
  return pointer;
}
void* waffle_dl_sym(int32_t which, const char* name) {
  return which == WAFFLE_DL_OPENGL ? waffle_get_proc_address(name) : NULL;
}

int32_t waffle_attrib_list_length(const int32_t* list) {
  int32_t pairs = 0;
  while (list && list[2 * pairs]) ++pairs;
  return pairs;
}
static int32_t attribute(const int32_t* list, int32_t key, int32_t otherwise) {
  for (; list && *list; list += 2)
    if (*list == key) return list[1];
  return otherwise;
}

struct waffle_display* waffle_display_connect(const char* name) {
  (void)name;
  return calloc(1, sizeof(struct waffle_display));
}
bool waffle_display_disconnect(struct waffle_display* display) {
  free(display);
  return true;
}

struct waffle_config* waffle_config_choose(struct waffle_display* display, const int32_t* list) {
  (void)display;
  problem = "";
  if (attribute(list, WAFFLE_CONTEXT_API, WAFFLE_CONTEXT_OPENGL) != WAFFLE_CONTEXT_OPENGL ||
      attribute(list, WAFFLE_CONTEXT_PROFILE, 0) == WAFFLE_CONTEXT_CORE_PROFILE ||
      attribute(list, WAFFLE_CONTEXT_FORWARD_COMPATIBLE, 0) == 1 || attribute(list, WAFFLE_SAMPLES, 0) > 1)
    return fail("there are compatibility contexts of OpenGL alone, without samples");
  return calloc(1, sizeof(struct waffle_config));
}
bool waffle_config_destroy(struct waffle_config* config) {
  free(config);
  return true;
}

struct waffle_context* waffle_context_create(struct waffle_config* config, struct waffle_context* share) {
  (void)config;
  struct waffle_context* context = calloc(1, sizeof *context);
  context->osmesa = create_context(kRgba, 24, 8, 16, share ? share->osmesa : NULL);
  return context;
}
bool waffle_context_destroy(struct waffle_context* context) {
  if (context) destroy_context(context->osmesa);
  free(context);
  return true;
}

struct waffle_window* waffle_window_create(struct waffle_config* config, int32_t width, int32_t height) {
  (void)config;
  struct waffle_window* window = calloc(1, sizeof *window);
  window->width = width;
  window->height = height;
  window->pixels = calloc((size_t)width * (size_t)height, 4);
  return window;
}
bool waffle_window_destroy(struct waffle_window* window) {
  if (window) free(window->pixels);
  free(window);
  return true;
}
bool waffle_window_show(struct waffle_window* window) { return window != NULL; }
bool waffle_window_swap_buffers(struct waffle_window* window) {
  get_proc_address("glFinish")();
  return window != NULL;
}
union waffle_native_window* waffle_window_get_native(struct waffle_window* window) {
  (void)window;
  return fail("a window is memory");
}

bool waffle_make_current(struct waffle_display* display, struct waffle_window* window,
                         struct waffle_context* context) {
  (void)display;
  if (!window || !context) return make_current(NULL, NULL, 0, 0, 0), true;
  return make_current(context->osmesa, window->pixels, kUnsignedByte, window->width, window->height);
}

// libGL: piglit looks functions up with the first two, and wants the others to be there.
void* glXGetProcAddress(const unsigned char* name) { return waffle_get_proc_address((const char*)name); }
void* glXGetProcAddressARB(const unsigned char* name) { return waffle_get_proc_address((const char*)name); }

#define UNUSED(name) \
  void* name(void) { return NULL; }
UNUSED(glXChooseVisual)
UNUSED(glXCreateContext)
UNUSED(glXCreateNewContext)
UNUSED(glXCreatePixmap)
UNUSED(glXDestroyContext)
UNUSED(glXGetCurrentDisplay)
UNUSED(glXGetCurrentDrawable)
UNUSED(glXGetFBConfigAttrib)
UNUSED(glXGetFBConfigs)
UNUSED(glXGetVisualFromFBConfig)
UNUSED(glXMakeCurrent)
UNUSED(glXQueryExtension)
UNUSED(glXQueryExtensionsString)
UNUSED(glXQueryVersion)
// libEGL.
UNUSED(eglBindAPI)
UNUSED(eglGetDisplay)
UNUSED(eglGetError)
UNUSED(eglGetProcAddress)
UNUSED(eglQueryString)
