#!/usr/bin/python3
"""Checks that package.xml, the build files, the imports, scripts/dependencies.txt and scripts/rosdep.yaml name the same
dependencies, and that package.xml, the build files, the scripts and the citation have the version of the last release.

Usage: dependencies.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

# rosdep key -> its names in the sources (CMake package, header folder or Python module), and its Debian packages
KEYS = {
    "boost": ({"Boost", "boost"}, {"libboost-dev", "libboost-iostreams-dev"}),
    "catkin": ({"catkin"}, {"catkin"}),
    "cli11": ({"CLI11", "CLI"}, {"libcli11-dev"}),
    "diagnostic_msgs": (
        {"diagnostic_msgs"},
        {"libdiagnostic-msgs-dev", "ros-diagnostic-msgs", "python3-diagnostic-msgs"},
    ),
    "diagnostic_updater": ({"diagnostic_updater"}, {"libdiagnostic-updater-dev"}),
    "eigen": ({"Eigen3", "Eigen", "unsupported"}, {"libeigen3-dev"}),
    "fmt": ({"fmt"}, {"libfmt-dev"}),
    "geometry_msgs": ({"geometry_msgs"}, {"libgeometry-msgs-dev", "ros-geometry-msgs", "python3-geometry-msgs"}),
    "google-mock": ({"gmock"}, {"libgmock-dev"}),
    "gtest": ({"GTest", "gtest"}, {"libgtest-dev"}),
    "hdf5": ({"HDF5_LIBRARY", "hdf5.h"}, {"libhdf5-dev"}),
    "libceres-dev": ({"Ceres", "ceres"}, {"libceres-dev"}),
    "libzip-dev": ({"LIBZIP_LIBRARY", "zip.h"}, {"libzip-dev"}),
    "matio": ({"matio", "matio.h", "MATIO_LIBRARY"}, {"libmatio-dev"}),
    "libssl-dev": ({"OpenSSL", "openssl"}, {"libssl-dev"}),
    "libudunits2-dev": ({"UDUNITS2_LIBRARY", "udunits2.h"}, {"libudunits2-dev"}),
    "message_generation": ({"message_generation", "GENCPP_TEMPLATES"}, {"ros-message-generation"}),
    "message_runtime": ({"message_runtime"}, {"ros-message-runtime"}),
    "nlohmann-json-dev": ({"nlohmann_json", "nlohmann"}, {"nlohmann-json3-dev"}),
    "nodelet": ({"nodelet"}, {"libnodelet-dev", "libnodeletlib-dev", "libnodeletlib-tools"}),
    "pluginlib": ({"pluginlib"}, {"pluginlib-dev"}),
    "pybind11-dev": ({"pybind11"}, {"pybind11-dev"}),
    "python3-dev": ({"Python3"}, {"python3-dev"}),
    "python3-jinja2": ({"jinja2", "markupsafe"}, {"python3-jinja2"}),
    "python3-matplotlib": ({"matplotlib"}, {"python3-matplotlib"}),
    "python3-numpy": ({"numpy"}, {"python3-numpy"}),
    "python3-pil": ({"PIL"}, {"python3-pil"}),
    "python3-tk": ({"tkinter"}, {"python3-tk"}),
    "python3-scipy": ({"scipy"}, {"python3-scipy"}),
    "python3-yaml": ({"yaml"}, {"python3-yaml"}),
    "rosbag": ({"py:rosbag", "pkg:rosbag"}, {"python3-rosbag"}),
    "rosbag_storage": ({"rosbag_storage", "rosbag"}, {"librosbag-storage-dev"}),
    "roscpp": ({"roscpp", "ros", "roscpp_msgs"}, {"libroscpp-dev"}),
    "rosgraph": ({"py:rosgraph"}, {"python3-rosgraph"}),
    "rosgraph_msgs": ({"rosgraph_msgs"}, {"libros-rosgraph-msgs-dev"}),
    "roslaunch": ({"py:roslaunch"}, {"python3-roslaunch"}),
    "rosnode": ({"py:rosnode"}, {"python3-rosnode"}),
    "rospy": ({"py:rospy"}, {"python3-rospy"}),
    "rosservice": ({"py:rosservice"}, {"python3-rosservice"}),
    "rostest": ({"rostest", "py:rostest"}, {"librostest-dev", "python3-rostest"}),
    "rostopic": ({"py:rostopic"}, {"python3-rostopic"}),
    "rosunit": ({"py:rosunit"}, {"python3-rosunit"}),
    "sensor_msgs": ({"sensor_msgs"}, {"libsensor-msgs-dev", "ros-sensor-msgs", "python3-sensor-msgs"}),
    "simbody": ({"Simbody"}, {"libsimbody-dev"}),
    "std_msgs": ({"std_msgs"}, {"libstd-msgs-dev", "ros-std-msgs", "python3-std-msgs"}),
    "std_srvs": ({"std_srvs"}, {"libstd-srvs-dev", "ros-std-srvs", "python3-std-srvs"}),
    "tf2_msgs": ({"tf2_msgs"}, {"python3-tf2-msgs"}),
    "tinyxml2": ({"TINYXML2_LIBRARY", "tinyxml2.h"}, {"libtinyxml2-dev"}),
    "topic_tools": ({"topic_tools", "pkg:topic_tools"}, {"libtopic-tools-dev"}),
    "yaml-cpp": ({"yaml-cpp"}, {"libyaml-cpp-dev"}),
    "zlib": ({"ZLIB", "zlib.h"}, {"zlib1g-dev"}),
}
# These are part of the language, or of a package that another key names.
IMPLIED = {"rosconsole", "rostime", "xmlrpcpp", "Threads", "CTest", "bits", "sys", "arpa", "net", "netinet", "gnu", "linux",
           "Python3"}
# These are used if they are installed, but have no rosdep key.
OPTIONAL = {"rapidcheck", "rapidcheck.h"}
# These tools and options have no rosdep key, so only scripts/dependencies.txt names them.
TOOLS = {"cmake", "g++", "ninja-build", "pkg-config", "rosbash", "python3-rosmsg", "librapidcheck-dev",
         "dpkg-dev", "file", "iproute2", "nftables", "munge", "slurm-client", "slurmctld", "slurmd", "g++-mingw-w64-x86-64", "wine64", "rviz", "chromium"}
TOOL_PREFIXES = ("clang", "libclang", "catkin-lint", "valgrind", "doxygen", "xvfb", "graphviz", "strace")
INTROSPECTION = {"python3-rosbag", "python3-rosnode", "python3-rosservice", "python3-rostopic", "python3-roslaunch"}
STANDARD_PYTHON = set(sys.stdlib_module_names) - {"tkinter"} | {
    "rubber_suspension", "rubber_suspension_core", "mpl_toolkits", "genpy", "actionlib"}

# Files with the version. The first version in a heading of CHANGELOG.rst is that of the last release.
VERSIONS = {
    "CHANGELOG.rst": r"^(\d+\.\d+\.\d+) \(\d{4}-\d\d-\d\d\)$",
    "package.xml": r"<version>(.*)</version>",
    "CMakeLists.txt": r"^project\(\w+ VERSION (\S+)",
    "CITATION.cff": r"^version: (.*)$",
    **{f"scripts/{name}": r'^VERSION = "(.*)"$'
       for name in ("generate_track", "live_plot", "reproduce_paper", "show_bush")},
}

FIND_PACKAGE = re.compile(r"^\s*find_package\((\w[\w+-]*)([^)]*)\)", re.MULTILINE | re.DOTALL)
FIND_OTHER = re.compile(r"^\s*(?:find_library|find_path)\((\w+)", re.MULTILINE)
INCLUDE = re.compile(r"^\s*#\s*include\s*<([\w.+-]+)/", re.MULTILINE)
IMPORT = re.compile(r"^\s*(?:import\s+(?=[\w.]+(?: as \w+)?$)|from\s+(?=[\w.]+ import))(\w+)", re.MULTILINE)
LAUNCHED = re.compile(r'\bpkg="(\w+)"')


def cmake_names(root):
    for folder in (".", "test", "test/fuzz"):
        path = root / folder / "CMakeLists.txt"
        text = path.read_text() if path.exists() else ""
        for name, rest in FIND_PACKAGE.findall(text):
            yield name, path
            if name == "catkin":
                words = rest.split()
                yield from ((word, path) for word in words if word not in ("REQUIRED", "COMPONENTS"))
        yield from ((name, path) for name in FIND_OTHER.findall(text) if not name.endswith("_INCLUDE_DIR"))


def include_names(root):
    for path in files(root, ("include", "src", "test"), (".h", ".cpp")):
        yield from ((name, path) for name in INCLUDE.findall(path.read_text()) if name != "rubber_suspension")


def python_names(root):
    scripts = [p for p in files(root, ("scripts", "src", "test"), (".py", "")) if is_python(p)]
    local = {path.stem for path in scripts} | {path.parent.name for path in scripts}
    for path in scripts:
        for name in IMPORT.findall(path.read_text()):
            if name not in STANDARD_PYTHON and name not in local:
                yield ("py:" + name if name.startswith("ros") else name), path


def is_python(path):
    if path.suffix == ".py":
        return True
    return path.is_file() and path.read_bytes()[:40].startswith(b"#!/usr/bin/python3")


def launch_names(root):
    for path in files(root, ("launch", "test"), (".launch", ".test")):
        yield from (("pkg:" + name, path) for name in LAUNCHED.findall(path.read_text()) if name != "rubber_suspension")


def files(root, folders, suffixes):
    """Return all files in these folders, except those of packages inside, which have a package.xml of their own."""
    return sorted(
        p
        for folder in folders
        for p in (root / folder).rglob("*")
        if p.suffix in suffixes and not (root / "test" / "install") in p.parents
    )


def declared_keys(root):
    tree = ElementTree.parse(root / "package.xml").getroot()
    return {node.text.strip() for node in tree if node.tag.endswith("depend")}


def debian_packages(root):
    lines = (root / "scripts" / "dependencies.txt").read_text().splitlines()
    return {line.split()[1] for line in lines if re.match(r"[a-z]", line)}


def own_rosdep_problems(root, declared):
    """Check that scripts/rosdep.yaml contains declared keys only, each with the package that is installed here."""
    text = (root / "scripts" / "rosdep.yaml").read_text()
    for key, package in re.findall(r"^([\w-]+):\n  debian: \[([\w-]+)\]$", text, re.MULTILINE):
        if key not in declared:
            yield f"scripts/rosdep.yaml: package.xml does not name `{key}`"
        elif package not in KEYS[key][1]:
            yield f"scripts/rosdep.yaml: `{key}` is {package}, not {', '.join(KEYS[key][1])}"


def version_problems(root):
    found = {}
    for path, pattern in VERSIONS.items():
        match = re.search(pattern, (root / path).read_text(), re.MULTILINE)
        found[path] = match.group(1) if match else "none"
    released = found["CHANGELOG.rst"]
    for path, version in found.items():
        if version != released:
            yield f"{path}: version {version}, but the last release in CHANGELOG.rst is {released}"


def check(root):
    key_of = {name: key for key, (names, _) in KEYS.items() for name in names}
    problems, used = set(), {"catkin", "message_runtime"}
    for source in (cmake_names, include_names, python_names, launch_names):
        for name, path in source(root):
            bare = name.split(":", 1)[-1]
            key = key_of.get(name) or key_of.get(bare) or (bare if name.startswith("pkg:") else None)
            if key is None:
                if bare not in IMPLIED | OPTIONAL:
                    problems.add(f"{path.relative_to(root)}: `{bare}` has no rosdep key in test/lint/dependencies.py")
            else:
                used.add(key)
    declared, installed = declared_keys(root), debian_packages(root)
    problems |= set(own_rosdep_problems(root, declared)) | set(version_problems(root))
    problems |= {f"package.xml: does not name `{key}`, which is used" for key in used - declared}
    problems |= {f"package.xml: names `{key}`, which nothing uses" for key in declared - used}
    known = {package for _, packages in KEYS.values() for package in packages}
    for key in declared & set(KEYS):
        problems |= {f"scripts/dependencies.txt: lacks {p}, for the key `{key}`" for p in KEYS[key][1] - installed}
    needed = {package for key in declared & set(KEYS) for package in KEYS[key][1]} | TOOLS | INTROSPECTION
    for package in installed - needed:
        if not package.startswith(TOOL_PREFIXES):
            reason = "no key of package.xml needs it" if package in known else "test/lint/dependencies.py does not know it"
            problems.add(f"scripts/dependencies.txt: {package}: {reason}")
    for problem in sorted(problems):
        print(problem)
    return problems


if __name__ == "__main__":
    sys.exit(1 if check(pathlib.Path(sys.argv[1]).resolve()) else 0)
