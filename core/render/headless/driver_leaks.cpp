// For builds with the leak sanitizer only: what Mesa and LLVM keep until the process ends is not ours to free.
// Weak, since a program may be handed these by more than one library; the names are the sanitizer's own.
extern "C" __attribute__((weak)) const char* __lsan_default_suppressions(); // NOLINT
extern "C" __attribute__((weak)) const char* __lsan_default_options();      // NOLINT

extern "C" const char* __lsan_default_suppressions() // NOLINT
{
    return "leak:libOSMesa.so\nleak:libEGL\nleak:swrast_dri.so\nleak:libgallium\nleak:libLLVM\nleak:libglapi.so\n";
}

extern "C" const char* __lsan_default_options() // NOLINT
{
    return "print_suppressions=0"; // standard error belongs to the program
}
