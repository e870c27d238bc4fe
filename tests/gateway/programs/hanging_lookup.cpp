// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Preloaded, it is a name server that never answers for one name.
#include <cstring>

#include <dlfcn.h>
#include <netdb.h>
#include <unistd.h>

extern "C" int getaddrinfo(char const* name, char const* service, addrinfo const* wanted, addrinfo** found)
{
    while (name != nullptr and std::strcmp(name, "hangs.example") == 0) {
        ::pause();
    }
    using lookup = int (*)(char const*, char const*, addrinfo const*, addrinfo**);
    return reinterpret_cast<lookup>(::dlsym(RTLD_NEXT, "getaddrinfo"))(name, service, wanted, found);
}
