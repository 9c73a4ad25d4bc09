// For programs that do one operation on large sets after another.
#pragma once

#pragma GCC visibility push(default)
namespace plumb {

/// Lets malloc keep what is freed, to be used again, instead of giving it back to the system, which clears each page anew
/// when it is touched again. Call once, before other threads are started; `plumb` does. It concerns the whole process, so no
/// function of the library calls it. A union of meshes of 58,784 triangles takes 0.9 of the time without it when it follows
/// another one. Does nothing where the C library is not glibc.
void keep_freed_memory();

}  // namespace plumb
#pragma GCC visibility pop
