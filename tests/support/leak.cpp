// Forgets some memory on purpose, to see that the leak sanitizer looks.

namespace {

[[gnu::noinline]] void forget_memory()
{
    int* volatile forgotten = new int[1000];
    forgotten[0] = 1;
    forgotten = nullptr;
}

}  // namespace

int main()
{
    forget_memory();
}
