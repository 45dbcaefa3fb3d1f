/* A library that is loaded while the program runs, as importers do with FMUs. */
#ifndef STRIBECK_TEST_LIBRARY_H
#define STRIBECK_TEST_LIBRARY_H

#include <string.h>

#if defined _WIN32
#include <windows.h>
typedef HMODULE library;
static inline library open_library(const char *path) {
    return LoadLibraryA(path);
}
static inline void close_library(library loaded) {
    FreeLibrary(loaded);
}
static inline void *find(library loaded, const char *name) {
    FARPROC function = GetProcAddress(loaded, name);
    void *address = NULL;
    memcpy(&address, &function, sizeof address);
    return address;
}
#else
#include <dlfcn.h>
typedef void *library;
static inline library open_library(const char *path) {
    return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}
static inline void close_library(library loaded) {
    dlclose(loaded);
}
static inline void *find(library loaded, const char *name) {
    return dlsym(loaded, name);
}
#endif

#endif
