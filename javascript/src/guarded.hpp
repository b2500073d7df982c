// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>

#include <exception>
#include <memory>
#include <new>

#include <emscripten/val.h>

namespace counterpart::javascript {

/// { value: work() }, or { error: { kind, message } } for what it throws: C++ exceptions are nothing that
/// JavaScript can read.
template <class Work>
emscripten::val guarded(const Work& work) {
    using emscripten::val;
    const auto failed = [](const char* kind, const char* message) {
        val error = val::object(), outcome = val::object();
        error.set("kind", val(kind));
        error.set("message", val(message));
        outcome.set("error", error);
        return outcome;
    };
    try {
        val outcome = val::object();
        outcome.set("value", work());
        return outcome;
    } catch (const UnsuitableMesh& error) {
        return failed("UnsuitableMesh", error.what());
    } catch (const InvalidInput& error) {
        return failed("InvalidInput", error.what());
    } catch (const IoError& error) {
        return failed("IoError", error.what());
    } catch (const NumericalError& error) {
        return failed("NumericalError", error.what());
    } catch (const Canceled& error) {
        return failed("Canceled", error.what());
    } catch (const std::bad_alloc&) {
        return failed(
            "OutOfMemory",
            "there is not enough memory: WebAssembly has 4 GB at most. Use smaller meshes, or the program");
    } catch (const std::exception& error) {
        return failed("Failure", error.what());
    }
}

/// Calls `callback`, a function of JavaScript, or nothing where that is null or undefined.
inline Progress progress_of(const emscripten::val& callback) {
    if (callback.isNull() || callback.isUndefined()) return {};
    // Copies are made by threads that know nothing of the function: it belongs to the one that calls it.
    return [shared = std::make_shared<emscripten::val>(callback)](double fraction) {
        return (*shared)(fraction).as<bool>();
    };
}

}  // namespace counterpart::javascript
