# Not run yet.
class Counterpart < Formula
  desc "Dense correspondence of triangle meshes"
  homepage "https://github.com/counterpart/counterpart"
  url "https://github.com/counterpart/counterpart/archive/refs/tags/v@VERSION@.tar.gz"
  sha256 "@SHA256@"
  license "MIT"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "nanoflann" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "spectra" => :build
  depends_on "eigen"
  depends_on "fmt"
  depends_on "libpng"
  depends_on "pugixml"
  depends_on "tbb"

  uses_from_macos "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCOUNTERPART_TESTS=OFF",
                    "-DCOUNTERPART_BENCHMARKS=OFF", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"counterpart", "deform", "body", "a.obj", "-q"
    system bin/"counterpart", "deform", "a.obj", "b.obj", "--bend", "30", "--shuffle", "1", "--truth", "truth.txt", "-q"
    system bin/"counterpart", "match", "a.obj", "b.obj", "-o", "map.txt", "-q"
    assert_equal (testpath/"truth.txt").read, (testpath/"map.txt").read
  end
end
