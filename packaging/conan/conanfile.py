"""Conan 2 recipe of the tree it lies in: conan create packaging/conan"""
import os

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class PlumbConan(ConanFile):
    name = "plumb"
    description = "Exact geometry: planar subdivisions and Nef polyhedra without rounding"
    license = "Apache-2.0"
    author = "The plumb authors"
    topics = ("geometry", "computational-geometry", "boolean", "nef-polyhedra", "exact")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "portable": [True, False]}
    default_options = {"shared": False, "fPIC": True, "portable": False}

    def _root(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        header = load(self, os.path.join(self._root(), "engine", "plumb", "base", "version.h"))
        self.version = header.split('PLUMB_VERSION_STRING "')[1].split('"')[0]

    def export_sources(self):
        for part in ("CMakeLists.txt", "LICENSE", "NOTICE", "cmake/*", "predicates/*", "engine/*"):
            copy(self, part, self._root(), self.export_sources_folder)

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("boost/[>=1.74 <2]", transitive_headers=True, options={"header_only": True})
        self.requires("gmp/[>=6.2 <7]", transitive_headers=True, transitive_libs=True)
        self.requires("mpfr/[>=4.1 <5]", transitive_headers=True, transitive_libs=True)
        self.requires("nlohmann_json/[>=3.11 <4]", visible=False)

    def validate(self):
        check_min_cppstd(self, 20)
        if self.settings.os == "Windows":
            raise ConanInvalidConfiguration("plumb does not build on Windows")

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.variables["PLUMB_PORTABLE"] = bool(self.options.portable)
        for part in ("PROGRAM", "C", "TESTS", "FUZZ"):
            toolchain.variables[f"PLUMB_BUILD_{part}"] = False
        for library in ("DRACO", "MESHOPT", "3MF", "PNG", "TEXT"):  # no dependencies that this recipe does not name
            toolchain.variables[f"PLUMB_WITH_{library}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "plumb")
        predicates = self.cpp_info.components["predicates"]
        predicates.set_property("cmake_target_name", "plumb::predicates")
        predicates.libs = ["plumb_predicates"]
        predicates.requires = ["boost::headers", "gmp::gmp", "mpfr::mpfr"]
        predicates.cxxflags = ["-ffp-contract=off"]  # the bounds of inline filters need it
        if self.options.portable:
            predicates.defines = ["PLUMB_PORTABLE=1"]
        engine = self.cpp_info.components["plumb"]
        engine.set_property("cmake_target_name", "plumb::plumb")
        engine.libs = ["plumb"]
        engine.requires = ["predicates"]
        if self.settings.os in ("Linux", "FreeBSD"):
            engine.system_libs = ["pthread"]
