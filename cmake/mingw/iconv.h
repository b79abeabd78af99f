// What GNU libiconv declares, for checking the syntax on Windows without it (tools/check-windows).
#pragma once

#include <cstddef>

using iconv_t = void*;
iconv_t iconv_open(const char* to, const char* from);
std::size_t iconv(iconv_t converter, char** in, std::size_t* in_left, char** out, std::size_t* out_left);
int iconv_close(iconv_t converter);
