// What reading and writing of files asks of the system, where POSIX and Windows differ.
//
// Everything else (open, read, write, close, stat, unlink) has the same name on both. Failures are
// reported as there: by a negative number or false, and by errno.
#pragma once

#include <string>

namespace plumb::system_files {

/// Opens a file to read its bytes. A named pipe is opened without waiting for a program that
/// writes to it. Returns the descriptor.
int open_input(const std::string& path);

/// Waits until something can be read, but at most `milliseconds`. Returns whether it can. On
/// Windows, it returns true at once, so that it is the read itself that waits.
bool wait_for_input(int descriptor, int milliseconds);

/// Opens a device or a pipe to write to it. errno is ENXIO if no program reads a named pipe.
/// Returns the descriptor.
int open_device(const std::string& path);

/// Creates a file of its own. The last six characters of `name` are "XXXXXX", and are replaced.
/// Returns the descriptor.
int create_temporary(std::string& name);

/// Gives an open file the permissions of the file `model`. If there is no such file, gives it the
/// permissions of any file that the process creates. Windows derives permissions from the folder,
/// so nothing is done there.
void give_permissions(int descriptor, const std::string& model);

/// Waits until the bytes of an open file are on the device. Returns whether that succeeded.
bool synchronize(int descriptor);

/// Gives a file another name, in one step, even if there is a file of this name. Returns whether
/// that succeeded.
bool replace_file(const std::string& from, const std::string& to);

/// Returns where `path` leads if it is a link, else `path`.
std::string resolve_links(const std::string& path);

}  // namespace plumb::system_files
