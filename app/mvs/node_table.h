#pragma once
// The MolViewSpec nodes that Nacre knows, with their supported parameters. Source of the documentation's table and of
// warnings about scenes.

#include <span>
#include <string>
#include <string_view>

namespace nacre::app::mvs {

struct NodeRow {
    std::string_view kind;     ///< of the node; for a representation "representation:cartoon", for a primitive
                               ///< "primitive:tube"
    std::string_view parents;  ///< kinds of parent nodes below which it is drawn, separated by blanks
    std::string_view params;   ///< supported ones, separated by blanks
    std::string_view unused;   ///< read, but without effect
    std::string_view remark;   ///< a note; may be empty

    /// Whether a parameter is one of `params`; for nodes with subkinds, also one of the shared ones.
    bool knows(std::string_view param) const;
    /// Whether the node is drawn below a parent of this kind.
    bool isBelow(std::string_view parent) const;
};

std::span<const NodeRow> nodeRows();
/// The rows as a table in Markdown, for the documentation.
std::string nodeTable();

/// Null: nodes of this kind are not drawn.
const NodeRow* nodeRow(std::string_view kind);

}  // namespace nacre::app::mvs
