// For builds with the leak sanitizer only: what Mesa and LLVM keep until the process ends is not ours to free.
extern "C" const char* __lsan_default_suppressions(); // NOLINT: the sanitizer's own name

extern "C" const char* __lsan_default_suppressions() // NOLINT
{
    return "leak:libOSMesa.so\nleak:libEGL\nleak:swrast_dri.so\nleak:libgallium\nleak:libLLVM\nleak:libglapi.so\n";
}
