// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Preloaded, it is a name server that does not answer for one name until a file is there, $HANGS_UNTIL; then the name is
// 127.0.0.1, and $HANGS_UNTIL.found is made.
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <netdb.h>
#include <unistd.h>

extern "C" int getaddrinfo(char const* name, char const* service, addrinfo const* wanted, addrinfo** found)
{
    if (name != nullptr and std::strcmp(name, "hangs.example") == 0) {
        std::string const file = std::getenv("HANGS_UNTIL");
        while (::access(file.c_str(), F_OK) != 0) {
            ::usleep(10'000);
        }
        ::close(::open((file + ".found").c_str(), O_CREAT | O_WRONLY, 0600));
        name = "127.0.0.1";
    }
    using lookup = int (*)(char const*, char const*, addrinfo const*, addrinfo**);
    return reinterpret_cast<lookup>(::dlsym(RTLD_NEXT, "getaddrinfo"))(name, service, wanted, found);
}
