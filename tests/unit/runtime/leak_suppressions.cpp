// OSMesa keeps its frame buffers and its screen until the process ends; LeakSanitizer, where it is linked in, asks here
// for what to leave out.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n";
}
