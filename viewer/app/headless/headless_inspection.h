#pragma once

#include "viewer/app/options.h"

namespace kerf::app {

/// Looks at a simulation without a window, once for each back end that was asked for: fixed steps, two ticks a frame.
/// Prints a report as JSON on standard output, messages on standard error. Gives the exit status: kUnusable when the
/// graphics driver complained.
/// @throws core::io::FileError, render::RenderError, std::invalid_argument
int run_headless_inspection(const Options& options);

}  // namespace kerf::app
