// The name of the instruction set that a kernel file is being compiled for, as a string.
#pragma once

#define SOFTGL_STRING_(x) #x
#define SOFTGL_STRING(x) SOFTGL_STRING_(x)
#ifndef SOFTGL_ISA
#error "kernels are compiled with -DSOFTGL_ISA=<instruction set>"
#endif
