#include "mpi/chunk_exchange.h"

#include <cstring>

#include "mpi/part_deal.h"

namespace softgl::cli {
namespace {

uint64_t weight_of(const ObjChunk& chunk) {
  return chunk.corner_vertices.values.size() + chunk.line_vertices.values.size() +
         chunk.point_vertices.values.size();
}

class Writer {
public:
  explicit Writer(std::vector<uint32_t>& words) : words_(words) {}

  void number(uint64_t value) {
    words_.push_back(uint32_t(value));
    words_.push_back(uint32_t(value >> 32));
  }
  template <class T> void array(const GrowingArray<T>& values) {
    static_assert(sizeof(T) == 4);
    number(values.size());
    const size_t first = words_.size();
    words_.resize(first + values.size());
    if (!values.empty()) std::memcpy(&words_[first], values.data(), 4 * values.size());
  }

private:
  std::vector<uint32_t>& words_;
};

class Reader {
public:
  explicit Reader(const std::vector<uint32_t>& words) : words_(words) {}

  bool at_end() const { return next_ == words_.size(); }
  uint64_t number() {
    next_ += 2;
    return words_[next_ - 2] | uint64_t(words_[next_ - 1]) << 32;
  }
  template <class T> void array(GrowingArray<T>& values) {
    const uint64_t count = number();
    T* to = values.extend(count);
    if (count) std::memcpy(to, &words_[next_], 4 * count);
    next_ += count;
  }

private:
  const std::vector<uint32_t>& words_;
  size_t next_ = 0;
};

// Places in the text become offsets.
void write(Writer out, const ObjChunk& chunk, const char* text) {
  out.number(uint64_t(chunk.begin - text));
  out.number(uint64_t(chunk.end - text));
  out.number(chunk.face_count);
  out.array(chunk.face_sizes);
  for (const IndexList* list : {&chunk.corner_vertices, &chunk.corner_texcoords, &chunk.corner_normals,
                                &chunk.line_vertices, &chunk.point_vertices})
    out.array(list->values);
  out.number(chunk.changes.size());
  for (const StateChange& change : chunk.changes) {
    out.number(change.kind);
    out.number(uint32_t(change.group));
    out.number(change.name.empty() ? 0 : uint64_t(change.name.data() - text));
    for (const uint64_t value :
         {uint64_t(change.name.size()), uint64_t(change.face), uint64_t(change.line), uint64_t(change.point)})
      out.number(value);
  }
}

ObjChunk read(Reader& in, const char* text) {
  ObjChunk chunk;
  chunk.begin = text + in.number();
  chunk.end = text + in.number();
  chunk.face_count = uint32_t(in.number());
  in.array(chunk.face_sizes);
  for (IndexList* list : {&chunk.corner_vertices, &chunk.corner_texcoords, &chunk.corner_normals,
                          &chunk.line_vertices, &chunk.point_vertices})
    in.array(list->values);
  chunk.changes.resize(in.number());
  for (StateChange& change : chunk.changes) {
    change.kind = StateChange::Kind(in.number());
    change.group = int32_t(in.number());
    const char* name = text + in.number();
    change.name = {name, in.number()};
    change.face = uint32_t(in.number());
    change.line = uint32_t(in.number());
    change.point = uint32_t(in.number());
  }
  return chunk;
}

} // namespace

void balance_chunks(std::vector<ObjChunk>& chunks, const SourceText& text, const Ranks& ranks) {
  std::string own;
  for (const ObjChunk& chunk : chunks) {
    const uint64_t weight = weight_of(chunk);
    own.append(reinterpret_cast<const char*>(&weight), sizeof weight);
  }
  std::vector<uint64_t> weights;
  size_t first = 0;
  const std::vector<std::string> all = ranks.gather_everywhere(own);
  for (size_t rank = 0; rank < all.size(); ++rank) {
    if (rank == size_t(ranks.rank())) first = weights.size();
    const size_t count = all[rank].size() / sizeof(uint64_t), before = weights.size();
    weights.resize(before + count);
    if (count) std::memcpy(&weights[before], all[rank].data(), all[rank].size());
  }
  const std::vector<int> takers = deal_parts(weights, ranks.count(), Deal::kBlocks);
  std::vector<std::vector<uint32_t>> messages(size_t(ranks.count()));
  std::vector<ObjChunk> kept;
  for (size_t i = 0; i < chunks.size(); ++i) {
    const int taker = takers[first + i];
    if (taker == ranks.rank())
      kept.push_back(std::move(chunks[i]));
    else
      write(Writer(messages[size_t(taker)]), chunks[i], text.begin());
    chunks[i] = ObjChunk();
  }
  chunks.clear();
  messages = ranks.swap(std::move(messages));
  for (size_t rank = 0; rank < messages.size(); ++rank) {
    if (rank == size_t(ranks.rank()))
      for (ObjChunk& chunk : kept) chunks.push_back(std::move(chunk));
    for (Reader in(messages[rank]); !in.at_end();) chunks.push_back(read(in, text.begin()));
    messages[rank] = {};
  }
  if (chunks.empty()) { // that later steps find one
    chunks.emplace_back();
    chunks.back().begin = chunks.back().end = text.end();
  }
}

} // namespace softgl::cli
