// Graphics drivers leave memory behind that only their own code still knows of. The leak sanitizer looks for it at the
// end of the program, when the loader has thrown the drivers out and nobody can tell whose it was: every driver's
// memory would be reported, and ours among it. Programs that link this file never unload a library, so what drivers
// hold stays reachable, and what is reported is ours.

extern "C" int dlclose(void*) noexcept
{
    return 0;
}
