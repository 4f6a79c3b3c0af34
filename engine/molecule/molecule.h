#pragma once
// Plain data of one molecule. This header, like all that read_mmcif.cpp includes, must also compile as C++17: gemmi's
// CIF parser does not compile as C++20 with every compiler.

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/other_models.h"
#include "engine/molecule/read_notes.h"

namespace nacre {

/// Atomic number, 1 to 118; 0 = unknown; 119 = deuterium. Same numbering as gemmi::El.
using Element = std::uint8_t;

/// A name of at most eight bytes, stored inline ("CA", "HO5'"). Longer ones are truncated; no encoding is assumed.
struct Name {
    std::array<char, 8> bytes{};

    Name() = default;
    Name(std::string_view text) { text.copy(bytes.data(), bytes.size()); }
    std::string_view view() const {
        std::size_t length = 0;
        while (length < bytes.size() && bytes[length] != '\0') ++length;
        return {bytes.data(), length};
    }
    friend bool operator==(const Name& a, const Name& b) { return a.bytes == b.bytes; }
    friend bool operator!=(const Name& a, const Name& b) { return !(a == b); }
};

struct Atom {
    glm::vec3 position{};         ///< Å
    std::uint32_t residue = 0;    ///< index into Molecule::residues
    float occupancy = 1.0f;       ///< 0..1
    float temperatureFactor = 0;  ///< B factor, Å^2
    Name name;                    ///< "CA"; the element's symbol if the format has no names
    Element element = 0;
    char alternate = '\0';   ///< alternate location; '\0' = none
    bool hetero = false;     ///< HETATM
    std::int8_t charge = 0;  ///< formal charge, elementary charges
    float radius = 0;        ///< of a coarse grain, Å; 0: the element's radius
};

/// Mean square displacement of an atom: the tensor U in the frame of the positions, Å^2. All zero: not stated.
struct Displacement {
    float u11 = 0, u22 = 0, u33 = 0, u12 = 0, u13 = 0, u23 = 0;
    bool stated() const { return u11 != 0 || u22 != 0 || u33 != 0 || u12 != 0 || u13 != 0 || u23 != 0; }
};

/// Secondary structure from the file; `none` also if the file does not state it.
enum class SecondaryStructure : std::uint8_t { none, helix, strand };

/// The kind of entity that the file states for a residue; `unknown` also where it states none.
enum class EntityKind : std::uint8_t { unknown, protein, nucleic, nonPolymer, branched, water };

constexpr std::int32_t kNoLabelNumber = INT32_MIN;

/// A run of neighbouring atom records with the same chain, number, insertion code and name.
struct Residue {
    Name name;                ///< "ALA"; empty where the format has no residues
    std::int32_t number = 0;  ///< author's number
    /// mmCIF's label_seq_id, which counts the polymer's sequence; kNoLabelNumber outside polymers. In formats with only
    /// one number, that number.
    std::int32_t labelNumber = 0;
    char insertionCode = '\0';    ///< '\0' = none
    Name segment;                 ///< of simulation programs, "PROA"; empty: none
    std::uint32_t chain = 0;      ///< index into Molecule::chains
    std::uint32_t subchain = 0;   ///< index into Molecule::subchains
    std::uint32_t firstAtom = 0;  ///< index into Molecule::atoms
    std::uint32_t atomCount = 0;
    SecondaryStructure secondary = SecondaryStructure::none;
    EntityKind entityKind = EntityKind::unknown;
    std::uint32_t entity = 0;  ///< 1-based index into Molecule::entities; 0: not stated

    /// Residues of different names can share one position (sequence microheterogeneity).
    bool sharesPosition(const Residue& other) const {
        return chain == other.chain && number == other.number && insertionCode == other.insertionCode;
    }
};

struct Chain {
    std::string name;  ///< author's identifier; may be empty
    int model = 1;     ///< 1-based model, frame or record
};

/// Copies of some subchains: each transform maps position p to transform * vec4(p, 1).
struct AssemblyPart {
    std::vector<glm::mat4x3> transforms;   ///< rotation in columns 0 to 2, translation in column 3 (Å)
    std::vector<std::uint32_t> subchains;  ///< indices into Molecule::subchains, ascending, unique
    /// The file's names of the transforms, "X0-5" for a product; cut if very long. Empty: the format has none.
    std::vector<std::string> operators = {};
};

/// A biological assembly or the content of a unit cell, from the file.
struct Assembly {
    std::string id;       ///< "1", "PAU", "unit-cell"
    std::string details;  ///< the file's words; may be empty
    std::vector<AssemblyPart> parts;
};

enum class BondSource : std::uint8_t { file, residueTemplate, distance };

/// An unordered pair of different atoms, stored with a < b; no pair occurs twice.
struct Bond {
    std::uint32_t a = 0;  ///< index into Molecule::atoms
    std::uint32_t b = 0;
    std::uint8_t order = 1;  ///< 1, 2, 3; 4 = aromatic
    BondSource source = BondSource::file;
};

/// Contents of the file as a whole, as `nacre info` reports them. Keys that a format lacks are empty.
struct FileSummary {
    std::string format;  ///< "pdb", "mmcif", "mmjson", "bcif", "cif-core", "mmtf", "sdf-v2000", "sdf-v3000", "xyz",
                         ///< "mol2", "pqr", "gro", "pdbqt", "cml", "sample", or other names of Format
    std::string title;
    std::optional<std::int64_t> models;   ///< models or frames
    std::optional<std::int64_t> records;  ///< molecules of a multi-record file
    std::optional<std::int64_t> totalAtomsAllModels;
    std::optional<std::int64_t> totalAtomsAllRecords;
    std::optional<std::int64_t> totalBondsAllRecords;
    std::optional<std::int64_t> bonds;              ///< stated by the file for this record
    std::optional<std::int64_t> bondsAllModels;     ///< stated by the file for all models (MMTF)
    std::optional<std::int64_t> conectUniquePairs;  ///< unordered CONECT pairs whose atoms both exist
    std::optional<std::int64_t> chains;             ///< distinct chain characters (PDB)
    std::optional<std::int64_t> chainsAuth;         ///< distinct auth_asym_id (mmCIF)
    std::optional<std::int64_t> chainsLabel;        ///< distinct label_asym_id (mmCIF)
    std::optional<std::int64_t> biomtOperators;     ///< REMARK 350 BIOMT1 lines; MMTF: most transforms of an assembly
    std::optional<std::int64_t> assemblies;
    std::optional<std::int64_t> operators;          ///< _pdbx_struct_oper_list rows
    std::optional<double> resolution;               ///< Å, from the file
    std::string organism, method;                   ///< "Homo sapiens"; "X-ray diffraction"; comma-separated if several
    std::map<std::string, std::string> chainNames;  ///< of polymers: "A": "HIV-1 protease"
    std::map<std::string, std::string> componentNames;  ///< of non-standard residues: "478": "amprenavir"
    bool confidence = false;                      ///< the file is a prediction whose B factors are confidence (pLDDT)
    std::optional<std::array<glm::vec3, 3>> box;  ///< vectors of the simulation box, Å (GRO)
    glm::vec3 boxOrigin{};                        ///< its corner, Å
    std::array<bool, 3> boxRepeats{true, true, true};  ///< by vector; a slab repeats along two of them
    std::optional<std::array<double, 6>> cell;         ///< of a crystal: three lengths, Å, and three angles, degrees
    std::string spaceGroup;                            ///< Hermann-Mauguin, "P 21 21 21"; empty: not stated
    /// For a packed scene (cellPACK, PetWorld): the assembly that is the scene, and names of entities by their
    /// identifiers: "7": "root.membrane.spike", with the compartment before the last point. Empty: not such a scene.
    std::string packed;
    std::map<std::string, std::string> entityNames;
};

struct SceneGuide;

/// One model of one file, or all of them: every atom record in the file's order, so that an atom's 1-based position is
/// its id.
struct Molecule {
    std::vector<Atom> atoms;
    std::vector<Residue> residues;
    std::vector<Chain> chains;
    /// Units of assemblies: the names (label_asym_id) that separate a chain's ligands and waters from its polymer in
    /// mmCIF; in formats without them, the names of the chains.
    std::vector<std::string> subchains;
    std::vector<Bond> bonds;
    std::vector<Assembly> assemblies;
    std::vector<std::string> entities;        ///< identifiers of the file's entities (mmCIF label_entity_id)
    bool statesSecondaryStructure = false;    ///< the file states helices or strands of existing residues
    std::vector<float> partialCharges;        ///< by atom, elementary charges; empty if the format has none
    std::vector<float> radii;                 ///< by atom, Å, as PQR states them; empty otherwise
    std::vector<float> masses;                ///< by atom, u; empty if the format has none
    std::vector<Displacement> displacements;  ///< by atom, anisotropic; empty if the file states none
    std::vector<Name> types;                  ///< by atom, of its force field; empty if the format has none
    std::vector<std::int32_t> serials;        ///< by atom, its number in mmCIF (_atom_site.id); empty: 1, 2, 3, ...
    std::vector<std::string> warnings;        ///< leniently read data, one sentence each, bounded in number
    ReadNotes notes;                          ///< guessed and omitted items; listReadNotes() has the whole list
    bool lacksPositions = false;              ///< a topology without positions: a trajectory has to supply them
    bool modelsAreInputs = false;             ///< `Chain::model` indexes inputs
    std::vector<std::string> inputs;          ///< their names, in the order of their models; empty: there is one
    std::vector<FileSummary> inputFiles;      ///< summaries of the inputs' files
    OtherModels others;                       ///< if requested: the file's other models, for a shared camera
    std::string othersMissing;  ///< why other models could not be read; empty if they were, or if there are none
    FileSummary file;
    std::shared_ptr<const SceneGuide> guide;  ///< how a scene file draws it (scene_guide.h); null: no scene file
};

}  // namespace nacre
