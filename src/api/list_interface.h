// What the doors use of the vertex builder and the list compiler.
#pragma once

#include "commands/vertices/list_compilation.h"
#include "context/context.h"
