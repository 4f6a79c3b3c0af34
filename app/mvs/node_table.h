#pragma once
// The nodes of MolViewSpec that Nacre knows, and their parameters: what is drawn of each. The documentation's table and
// the warnings of scenes come from here.

#include <span>
#include <string>
#include <string_view>

namespace nacre::app::mvs {

struct NodeRow {
    std::string_view kind;     ///< of the node; of a representation "representation:cartoon", of a primitive
                               ///< "primitive:tube"
    std::string_view parents;  ///< kinds of nodes below which it is drawn, with blanks between them
    std::string_view params;   ///< that are drawn, with blanks between them
    std::string_view unused;   ///< that are read and change nothing
    std::string_view remark;   ///< what is to know; may be empty

    /// Whether a parameter is one of `params`. Of nodes with kinds of their own, also of the shared ones.
    bool knows(std::string_view param) const;
    /// Whether it is drawn below a node of a kind.
    bool isBelow(std::string_view parent) const;
};

std::span<const NodeRow> nodeRows();
/// The rows as a table in Markdown, for the documentation.
std::string nodeTable();

/// Null: nodes of this kind are not drawn.
const NodeRow* nodeRow(std::string_view kind);

}  // namespace nacre::app::mvs
