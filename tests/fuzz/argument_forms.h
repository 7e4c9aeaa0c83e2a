// What the arguments of commands are, where their types do not tell.
#pragma once

#include <string_view>

namespace softgl::test {

/// A letter for each argument of a command, which says what its type does not. Empty for commands that do
/// harm with no number.
///   .  by its type             n  a count of elements        d  a count of names or arrays
///   i  an index of an element  b  what is added to an index  k  memory that holds indices
///   w  a size of an image      v  of a volume                r  of a rectangle of pixels
///   s  a stride of an array    L  a level                    B  a border
///   o  a place in an image     c  a place in the window      F  a compressed format
///   f  an internal format      S  bytes of an image          z  bytes of a buffer
///   y  a place in a buffer     h  a name of an object        g  a point of a grid
///   D  steps of a grid         t  a stride of control points O  an order
///   P  of pixel storage        N  a size of a pixel map      q  a size of a feedback buffer
///   m  memory of pixels        M  the same, or null          x  memory to write to
///   5  components of an array  l  memory that holds names of lists
///   K  arrays of indices       I  what a buffer begins with, or null
///   T  a text                  0  null
std::string_view form_of(std::string_view command);

} // namespace softgl::test
