// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "platform/files.hpp"

#include <algorithm>
#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace counterpart::platform {
namespace {

namespace fs = std::filesystem;

HANDLE handle_of(std::intptr_t handle) { return reinterpret_cast<HANDLE>(handle); }

// As the rest of the program knows errors.
int last_error() {
    switch (GetLastError()) {
        case ERROR_FILE_NOT_FOUND:
        case ERROR_PATH_NOT_FOUND:
        case ERROR_INVALID_NAME:
        case ERROR_BAD_NETPATH:
            return ENOENT;
        case ERROR_ACCESS_DENIED:
        case ERROR_SHARING_VIOLATION:
        case ERROR_LOCK_VIOLATION:
        case ERROR_USER_MAPPED_FILE:
            return EACCES;
        case ERROR_WRITE_PROTECT:
            return EROFS;
        case ERROR_DISK_FULL:
        case ERROR_HANDLE_DISK_FULL:
            return ENOSPC;
        case ERROR_TOO_MANY_OPEN_FILES:
            return EMFILE;
        case ERROR_NOT_ENOUGH_MEMORY:
            return ENOMEM;
        case ERROR_FILENAME_EXCED_RANGE:
            return ENAMETOOLONG;
        case ERROR_BROKEN_PIPE:
        case ERROR_NO_DATA:
            return EPIPE;
        case ERROR_DIRECTORY:
            return ENOTDIR;
        default:
            return EIO;
    }
}

bool is_there(const fs::path& name) { return GetFileAttributesW(name.c_str()) != INVALID_FILE_ATTRIBUTES; }

Opened opened(HANDLE handle) {
    if (handle == INVALID_HANDLE_VALUE) return {{}, last_error()};
    return {OpenFile(reinterpret_cast<std::intptr_t>(handle))};
}

}  // namespace

OpenFile::~OpenFile() {
    if (is_open()) CloseHandle(handle_of(handle_));
}

int OpenFile::write(std::string_view bytes) const {
    constexpr std::size_t most = 1U << 30U;  // at a time
    while (!bytes.empty()) {
        DWORD count = 0;
        const auto size = static_cast<DWORD>(std::min(bytes.size(), most));
        if (WriteFile(handle_of(handle_), bytes.data(), size, &count, nullptr) == 0) return last_error();
        bytes.remove_prefix(count);
    }
    return 0;
}

int OpenFile::make_empty() const {
    LARGE_INTEGER begin = {};
    const bool is_empty = SetFilePointerEx(handle_of(handle_), begin, nullptr, FILE_BEGIN) != 0 &&
                          SetEndOfFile(handle_of(handle_)) != 0;
    return is_empty ? 0 : last_error();
}

// A new file has those of its folder, as Windows knows them.
void OpenFile::take_permissions(const fs::path& /*of*/) const {}

int OpenFile::rename(const fs::path& /*from*/, const fs::path& to) const {
    // By the handle, so that no other writer can take the file between closing and renaming.
    const std::wstring name = fs::absolute(to).native();
    std::vector<char> bytes(sizeof(FILE_RENAME_INFO) + name.size() * sizeof(wchar_t));
    auto* const info = reinterpret_cast<FILE_RENAME_INFO*>(bytes.data());
    info->ReplaceIfExists = TRUE;
    info->FileNameLength = static_cast<DWORD>(name.size() * sizeof(wchar_t));
    std::copy(name.begin(), name.end(), info->FileName);
    const auto size = static_cast<DWORD>(bytes.size());
    return SetFileInformationByHandle(handle_of(handle_), FileRenameInfo, info, size) != 0 ? 0 : last_error();
}

void OpenFile::remove(const fs::path& /*name*/) const {
    FILE_DISPOSITION_INFO info = {TRUE};  // when it is closed
    SetFileInformationByHandle(handle_of(handle_), FileDispositionInfo, &info, sizeof info);
}

Opened open_stream(const fs::path& file) {
    if (!is_nameless_output(file))
        return opened(CreateFileW(file.c_str(), FILE_APPEND_DATA, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                                  OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr));
    std::fflush(stdout);
    HANDLE copy = INVALID_HANDLE_VALUE;
    const HANDLE self = GetCurrentProcess();
    if (DuplicateHandle(self, GetStdHandle(STD_OUTPUT_HANDLE), self, &copy, 0, FALSE,
                        DUPLICATE_SAME_ACCESS) == 0)
        return {{}, EBADF};
    return opened(copy);
}

Opened open_alone(const fs::path& name, bool may_be_new) {
    // Shared with nobody: the system ends that with the process.
    Opened result = opened(CreateFileW(name.c_str(), GENERIC_WRITE | DELETE, 0, nullptr,
                                       may_be_new ? OPEN_ALWAYS : OPEN_EXISTING,
                                       FILE_ATTRIBUTE_NORMAL | FILE_FLAG_OPEN_REPARSE_POINT, nullptr));
    if (!result.file.is_open() && result.error == EACCES && is_there(name)) return {};
    return result;
}

std::FILE* open_to_read(const fs::path& file) {
    if (file != standard_input) return _wfopen(file.c_str(), L"rb");
    const int opened = _dup(_fileno(stdin));
    if (opened >= 0) _setmode(opened, _O_BINARY);
    return opened < 0 ? nullptr : _fdopen(opened, "rb");
}

bool is_nameless_output(const fs::path& file) { return file == standard_output; }

bool names_open_file(const fs::path& /*link*/) { return false; }

int error_of_writing(const fs::path& file) {
    const DWORD attributes = GetFileAttributesW(file.c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_READONLY) != 0 ? EACCES : 0;
}

int error_of_making_files(const fs::path& folder) {
    const fs::path name = folder / (L".counterpart-" + std::to_wstring(GetCurrentProcessId()));
    return opened(CreateFileW(name.c_str(), GENERIC_WRITE | DELETE, 0, nullptr, CREATE_NEW,
                              FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr))
        .error;
}

}  // namespace counterpart::platform
