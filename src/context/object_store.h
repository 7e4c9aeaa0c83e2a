// Named objects: textures, buffers, display lists and queries (GL 1.5, 2.9, 3.8.12, 4.1.7, 5.4). Contexts may
// share the first three; a store's lock is taken on object operations only, never per vertex or pixel.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/gl_types.h"

namespace softgl {

/// Names and their objects. A name is unused, reserved (generated, without an object yet) or names an object.
/// Name 0 is never in the table. An object lives as long as somebody holds a pointer to it: a binding keeps a
/// deleted object.
template <class T> class NameTable {
public:
  using Pointer = std::shared_ptr<T>;

  /// A block of `count` consecutive unused names, now reserved; 0 if there is no such block (GenLists).
  GLuint reserve_block(GLsizei count) {
    std::lock_guard lock(mutex_);
    const GLuint first = find_block(GLuint(count));
    if (first != 0)
      for (GLuint i = 0; i < GLuint(count); ++i) insert(first + i, nullptr);
    return first;
  }
  /// `count` unused names, now reserved (Gen*). False if so many names are not left.
  bool reserve(GLsizei count, GLuint* names) {
    std::lock_guard lock(mutex_);
    if (count <= 0) return true;
    if (GLuint first = find_block(GLuint(count)); first != 0) {
      for (GLsizei i = 0; i < count; ++i) insert(names[i] = first + GLuint(i), nullptr);
      return true;
    }
    for (GLsizei i = 0; i < count; ++i) {
      if ((names[i] = find_block(1)) == 0) {
        for (GLsizei k = 0; k < i; ++k) objects_.erase(names[k]);
        return false;
      }
      insert(names[i], nullptr);
    }
    return true;
  }
  /// The object, or null if the name is 0, unused or only reserved. Is* asks this.
  Pointer find(GLuint name) const {
    std::lock_guard lock(mutex_);
    auto it = objects_.find(name);
    return it == objects_.end() ? nullptr : it->second;
  }
  /// True if the name is reserved or names an object.
  bool used(GLuint name) const {
    std::lock_guard lock(mutex_);
    return objects_.count(name) != 0;
  }
  /// The object of `name`, created by `make()` if there is none (Bind*): in GL 1.5 any unused name will do.
  template <class Make> Pointer find_or_create(GLuint name, Make make) {
    std::lock_guard lock(mutex_);
    auto it = objects_.find(name);
    if (it != objects_.end() && it->second) return it->second;
    Pointer made = make();
    insert(name, made);
    return made;
  }
  /// Gives `name` the object, in place of an earlier one (EndList).
  void set(GLuint name, Pointer object) {
    Pointer old; // destroyed after the lock is released
    std::lock_guard lock(mutex_);
    auto& entry = objects_[name];
    old = std::move(entry);
    entry = std::move(object);
    highest_ = std::max(highest_, name);
  }
  /// Frees the name (Delete*) and hands out its object, so that the caller can end bindings to it. Null if
  /// unused.
  Pointer erase(GLuint name) {
    std::lock_guard lock(mutex_);
    auto it = objects_.find(name);
    if (it == objects_.end()) return nullptr;
    Pointer object = std::move(it->second);
    objects_.erase(it);
    return object;
  }
  /// Frees the used ones of `count` names from `first` on (DeleteLists). Behind the last name there are none.
  void erase_block(GLuint first, GLuint count) {
    std::vector<Pointer> gone; // destroyed after the lock is released
    count = GLuint(std::min<uint64_t>(count, (uint64_t(1) << 32) - first));
    std::lock_guard lock(mutex_);
    if (count < objects_.size()) {
      for (GLuint i = 0; i < count; ++i)
        if (auto it = objects_.find(first + i); it != objects_.end()) {
          gone.push_back(std::move(it->second));
          objects_.erase(it);
        }
    } else {
      for (auto it = objects_.begin(); it != objects_.end();)
        if (it->first - first < count) {
          gone.push_back(std::move(it->second));
          it = objects_.erase(it);
        } else {
          ++it;
        }
    }
  }

private:
  void insert(GLuint name, Pointer object) {
    objects_[name] = std::move(object);
    highest_ = std::max(highest_, name);
  }
  // Names behind the highest one ever used, as OSMesa gives them; gaps are searched only when those are gone.
  GLuint find_block(GLuint count) const {
    constexpr GLuint kLastName = 0xfffffffeu;
    if (count == 0) return 0;
    if (highest_ < kLastName && count <= kLastName - highest_) return highest_ + 1;
    std::vector<GLuint> names;
    names.reserve(objects_.size());
    for (const auto& entry : objects_) names.push_back(entry.first);
    std::sort(names.begin(), names.end());
    GLuint candidate = 1;
    for (GLuint name : names) {
      if (name - candidate >= count) return candidate;
      if (name >= kLastName) return 0;
      candidate = name + 1;
    }
    return kLastName - candidate + 1 >= count ? candidate : 0;
  }

  mutable std::mutex mutex_;
  std::unordered_map<GLuint, Pointer> objects_;
  GLuint highest_ = 0;
};

struct TextureObject; // texture/texture_object.h
struct BufferObject;  // vertex/buffer_objects.h
struct DisplayList;   // lists/display_list.h
struct Renderbuffer;  // framebuffer_objects.h
struct SamplerObject; // sampler_objects.h

/// What contexts may share. Queries are a context's own (occlusion_queries.h).
struct SharedObjects {
  NameTable<TextureObject> textures;
  std::shared_ptr<TextureObject> default_texture[5]; // by TextureTarget: the objects of name 0
  NameTable<BufferObject> buffers;
  NameTable<DisplayList> lists;
  NameTable<Renderbuffer> renderbuffers;
  NameTable<SamplerObject> samplers;
};

} // namespace softgl
