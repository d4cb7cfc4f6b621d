// Graphics drivers leave memory behind that only their own code still knows of. The leak sanitizer looks for it at the
// end of the program, when the loader has thrown the drivers out and nobody can tell whose it was: every driver's
// memory would be reported, and ours among it. Programs that link this file never unload a library, so what drivers
// hold stays reachable, and what is reported is ours.

extern "C" int dlclose(void*) noexcept
{
    return 0;
}

// The address sanitizer guesses the size of blocks of dynamic thread-local storage from words in front of those whose
// address is 16 beyond a page, as an old loader kept them there. Where a driver's block lies so by chance the guess is
// garbage, and the leak check crashes on it after a test that passed. Without the interceptor nothing is guessed.
extern "C" const char* __asan_default_options()
{
    return "intercept_tls_get_addr=0";
}
