// What the doors use of the vertex builder and the list compiler.
#pragma once

#include "lists/list_compiler.h"
#include "state/context.h"
