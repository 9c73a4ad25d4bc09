// Bytes inside text files (RFC 4648).
#pragma once

#include <string>
#include <string_view>

namespace plumb {

std::string base64(std::string_view bytes);

}  // namespace plumb
