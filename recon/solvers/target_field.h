#pragma once

#include <memory>
#include <vector>

#include "recon/solvers/interactions.h"
#include "recon/solvers/source_field.h"

namespace isostack {

/// The targets' side of the fast multipole method: the sources' spectra become fields at the nodes
/// of the target cells, and at the points of the leaves.
class TargetField {
 public:
  /// The tree must outlive this and be no deeper than the sources'. Has the sources prepare the translations.
  TargetField(SourceField& sources, const Octree& tree, const Interactions& interactions);

  /// Takes over what `sources` has gathered.
  void receive(const SourceField& sources);
  /// The field of a cell at its nodes; the level is at least SourceField::top_level.
  ExpansionView expansion(const SourceField& sources, int level, std::uint32_t cell) const;

  std::size_t bytes(const SourceField& sources) const;

 private:
  /// Up to four siblings and the far cells of any of them.
  struct TargetQuad {
    std::uint32_t first_cell, last_cell;
    std::uint32_t first_term, last_term;
  };
  /// Groups translated together: large enough to reuse the tables, small enough for the caches.
  struct Chunk {
    std::uint32_t first_group, last_group, first_quad, last_quad;
  };
  struct Level {
    SiblingGroups groups;
    std::vector<TargetQuad> quads;
    std::vector<QuadTerm> terms;
    std::vector<Chunk> chunks;
    std::unique_ptr<double[]> locals;  ///< [group][node][lane]
  };
  static void list_terms(Level& level, const TranslationTable& table, const Interactions::Level& lists);
  static void cut_into_chunks(Level& level, std::size_t frequencies);
  struct Scratch {
    std::vector<double> sums, re, im, halfway;
  };
  void translate_chunk(const SourceField& sources, int l, const Chunk& chunk, Scratch& scratch);
  void distribute(const SourceField& sources);

  const Octree& tree_;
  std::vector<Level> levels_;
};

}  // namespace isostack
