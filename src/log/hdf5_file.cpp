// Opens and traverses HDF5 files.
#include "log/hdf5_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>

#include "element/refuse.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

// Returns true if the file has storage for the whole dataset.
bool isWritten(hid_t dataset, hid_t properties) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.get()) <= 0) {
    return true;
  }
  if (H5Pget_layout(properties) != H5D_CHUNKED) {
    return H5Dget_storage_size(dataset) > 0;
  }
  std::array<hsize_t, H5S_MAX_RANK> size{};
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  const int rank = H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
  H5Pget_chunk(properties, rank, chunk.data());
  hsize_t needed = 1;
  for (std::size_t i = 0; static_cast<int>(i) < rank; ++i) {
    needed *= (size[i] + chunk[i] - 1) / std::max<hsize_t>(chunk[i], 1);
  }
  hsize_t there = 0;
  return H5Dget_num_chunks(dataset, space.get(), &there) >= 0 && there >= needed;
}

void requireShallow(const std::string& path) {
  constexpr int kDeepestGroup = 32;
  element::refuseIf<std::runtime_error>(std::count(path.begin(), path.end(), '/') > kDeepestGroup,
                                        "groups nested more than {0} levels deep; accepted: at most {0}",
                                        kDeepestGroup);
}

}  // namespace

hid_t openHdf5(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown here instead of printed by the library
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  element::refuseIf<std::runtime_error>(file < 0,
                                        "cannot be read as HDF5; accepted: a complete file that can be opened");
  return file;
}

void requireOwnData(hid_t dataset, const std::string& name) {
  const Hdf5Handle properties(dataset < 0 ? -1 : H5Dget_create_plist(dataset), H5Pclose);
  element::refuseIf<std::runtime_error>(
      !properties || H5Pget_external_count(properties.get()) != 0 || H5Pget_layout(properties.get()) == H5D_VIRTUAL,
      "{}: its data lie in other files; accepted: data in the file itself", quoted(name));
  if (!isWritten(dataset, properties.get())) {
    throw std::runtime_error(fmt::format("{}: the data were never written; accepted: a complete file", quoted(name)));
  }
}

void requireOwnData(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (H5Fis_hdf5(path.c_str()) <= 0) {
    return;
  }
  const Hdf5Handle file(openHdf5(path), H5Fclose);
  visitObjects(file.get(), [](const std::string& object, const Hdf5Handle* dataset) {
    if (dataset != nullptr) {
      requireOwnData(dataset->get(), object);
    }
    return true;
  });
}

void visitObjects(hid_t file, const std::function<bool(const std::string& path, const Hdf5Handle* dataset)>& visit) {
  struct Visit {
    decltype(visit) object;
    std::exception_ptr error;  // an exception must not pass through the library, which is written in C
  };
  // The type of `info` has another name in HDF5 1.14 than in 1.10, so the compiler deduces the type.
  const auto call = [](hid_t root, const char* path, const auto* info, void* data) -> herr_t {
    auto& called = *static_cast<Visit*>(data);
    try {
      requireShallow(path);
      const bool is_dataset = info->type == H5O_TYPE_DATASET;
      const Hdf5Handle dataset(is_dataset ? H5Dopen2(root, path, H5P_DEFAULT) : -1, H5Dclose);
      return called.object(path, is_dataset ? &dataset : nullptr) ? 0 : 1;
    } catch (...) {
      called.error = std::current_exception();
      return -1;
    }
  };
  Visit visited{visit, nullptr};
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, call, &visited, H5O_INFO_BASIC) < 0) {
    if (visited.error) {
      std::rethrow_exception(visited.error);
    }
    throw std::runtime_error("damaged; accepted: a complete HDF5 file");
  }
}

std::string describeDatasets(hid_t file) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> found;
  visitObjects(file, [&](const std::string& object, const Hdf5Handle* dataset) {
    if (dataset != nullptr && *dataset) {
      const Hdf5Handle space(H5Dget_space(dataset->get()), H5Sclose);
      std::array<hsize_t, H5S_MAX_RANK> size{};
      const int rank = H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
      found.push_back(fmt::format(
          "{} of {}", quoted(object),
          rank <= 0 ? "one value" : fmt::format("{}", fmt::join(size.begin(), size.begin() + rank, " x "))));
    }
    return found.size() < kMost;
  });
  return found.empty() ? "no datasets" : join(found);
}

}  // namespace rubber_suspension::log
