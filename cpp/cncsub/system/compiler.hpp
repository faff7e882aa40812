// Attributes that compilers spell in words of their own.
#pragma once

// Marks a function to be inlined always, whatever the compiler thinks of its size.
#if defined(_MSC_VER) && !defined(__clang__)
#define CNCSUB_ALWAYS_INLINE [[msvc::forceinline]]
#else
#define CNCSUB_ALWAYS_INLINE [[gnu::always_inline]]
#endif
