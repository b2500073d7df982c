// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <fstream>
#include <sstream>

namespace counterpart {

MeshFile read_mesh(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw IoError(file.string() + ": cannot be opened");
    std::vector<double> xyz;
    std::vector<Index> abc;
    if (file.extension() == ".obj") {
        std::string line, word;
        while (std::getline(stream, line)) {
            std::istringstream words(line);
            words >> word;
            if (word == "v")
                for (double x; words >> x;) xyz.push_back(x);
            if (word == "f")
                while (words >> word) abc.push_back(std::stoi(word) - 1);
            word.clear();
        }
    } else {
        std::string off;
        int nv = 0, nf = 0, n = 0;
        stream >> off >> nv >> nf >> n;
        xyz.resize(static_cast<std::size_t>(nv) * 3);
        for (double& x : xyz) stream >> x;
        for (int i = 0; i < nf; ++i) {
            stream >> n;
            for (int c = 0; c < 3; ++c) {
                stream >> n;
                abc.push_back(n);
            }
        }
    }
    MeshFile result;
    result.mesh.vertices = Eigen::Map<Points>(xyz.data(), static_cast<Eigen::Index>(xyz.size() / 3), 3);
    result.mesh.triangles = Eigen::Map<Triangles>(abc.data(), static_cast<Eigen::Index>(abc.size() / 3), 3);
    require_valid(result.mesh);
    return result;
}

}  // namespace counterpart
