#include "viewer/app/painter.h"
#include "viewer/render/offscreen_context.h"

// Draws a picture, and forgets some memory on purpose: to see that the leak sanitizer looks.

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
    {
        const kerf::render::OffscreenContext context;
        const kerf::app::Painter painter(64, 36);
    }
    forget_memory();
}
