// SPDX-License-Identifier: AGPL-3.0-or-later
// Comes before everything else in ThreadSanitizer builds. There protobuf would give map fields two
// more members, but libprotobuf and the generated code are compiled without the sanitizer.
#pragma once

#include <memory>  // First: the standard library must see the macro.

#pragma push_macro("__SANITIZE_THREAD__")
#undef __SANITIZE_THREAD__
#include <google/protobuf/map_field.h>
#pragma pop_macro("__SANITIZE_THREAD__")
