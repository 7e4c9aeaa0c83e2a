// The commands of GL 1.5, 5.4.
#pragma once

#include "base/gl_types.h"

namespace softgl {

struct Context;

/// Plays the list of that name, if there is one and the nesting is not too deep.
void call_list(Context& context, GLuint name);

constexpr int kMaxListNesting = 64;

namespace gl {
void NewList(Context& context, GLuint list, GLenum mode);
void EndList(Context& context);
void CallList(Context& context, GLuint list);
void CallLists(Context& context, GLsizei n, GLenum type, const void* lists);
void ListBase(Context& context, GLuint base);
GLuint GenLists(Context& context, GLsizei range);
void DeleteLists(Context& context, GLuint list, GLsizei range);
GLboolean IsList(Context& context, GLuint list);
} // namespace gl
} // namespace softgl
