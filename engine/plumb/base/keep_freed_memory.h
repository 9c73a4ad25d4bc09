// Settings of malloc for programs that run one operation on large sets after another. The functions
// below change the whole process. Therefore the library never calls them, but the program `plumb`
// does. Call each function at most once, before other threads start. The functions do nothing if
// the C library is not glibc.
#pragma once

#pragma GCC visibility push(default)
namespace plumb {

/// Makes malloc keep freed memory for reuse. Otherwise malloc releases it to the system, which
/// clears every page again before the next use. With this setting, a union of meshes with 58,784
/// triangles that follows another union takes 0.9 times as long as without this setting.
void keep_freed_memory();

/// Reserves the next 64 MB for malloc and requests huge pages for this memory, if the system grants
/// huge pages on request. A page of 2 MB interrupts the program once, at its first access, whereas
/// 512 small pages interrupt the program 512 times. The first union of two fandisk meshes with
/// 12,946 triangles takes 0.9 times as long as without this setting. Requires a preceding call of
/// keep_freed_memory(), because malloc would release the reserved memory otherwise. The function
/// reserves nothing if malloc still has more than 1 MB of free memory.
void use_huge_pages();

}  // namespace plumb
#pragma GCC visibility pop
