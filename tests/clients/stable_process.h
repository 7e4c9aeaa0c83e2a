// A process in which two runs see the same time, the same process number, and children that have ended.
#pragma once

namespace softgl::test {

/// A frame has ended: the process's time goes on by a thirtieth of a second. Gives the number of frames so
/// far.
int end_of_frame();

} // namespace softgl::test
