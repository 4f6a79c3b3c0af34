// nacre._nacre: the compiled part of the package nacre. Exchanges arrays; long calls release the GIL.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>

#include "app/download/load_molecule.h"
#include "app/input/map_input.h"
#include "app/input/molecule_info.h"
#include "app/picture/usage_error.h"
#include "app/python/drawing.h"
#include "app/python/frames.h"
#include "app/python/interrupt.h"
#include "app/python/pickled.h"
#include "engine/error.h"
#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/element.h"
#include "engine/molecule/residue_facts.h"
#include "engine/srgb.h"

namespace py = pybind11;

namespace nacre::python {

namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;
constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

template <typename T>
py::array_t<T> toArray(const std::vector<T>& values, std::vector<py::ssize_t> shape) {
    py::array_t<T> array(std::move(shape));
    std::memcpy(array.mutable_data(), values.data(), values.size() * sizeof(T));
    return array;
}

/// One value per atom. @param value  of (atom, its residue)
template <typename T, typename Value>
py::array_t<T> ofAtoms(const Molecule& m, Value&& value) {
    py::array_t<T> array(static_cast<py::ssize_t>(m.atoms.size()));
    T* out = array.mutable_data();
    for (const Atom& atom : m.atoms) *out++ = static_cast<T>(value(atom));
    return array;
}

/// Texts of at most eight bytes, as numpy's fixed-width bytes, which Python converts to text.
template <typename Value>
py::array nameArray(const Molecule& m, Value&& value) {
    constexpr std::size_t kWidth = 8;
    py::array array(py::dtype("S8"), static_cast<py::ssize_t>(m.atoms.size()));
    char* out = static_cast<char*>(array.mutable_data());
    std::memset(out, 0, m.atoms.size() * kWidth);
    for (const Atom& atom : m.atoms) {
        const std::string_view text = value(atom);
        std::memcpy(out, text.data(), std::min(text.size(), kWidth));
        out += kWidth;
    }
    return array;
}

/// A character as a text, empty if there is none. The text refers to the character itself.
std::string_view toText(const char& character) { return {&character, character != '\0' ? 1u : 0u}; }

py::dict listAtoms(const Structure& structure) {
    const Molecule& m = *structure.molecule;
    py::array_t<float> positions({static_cast<py::ssize_t>(m.atoms.size()), py::ssize_t{3}});
    float* out = positions.mutable_data();
    for (const Atom& atom : m.atoms)
        for (int i = 0; i < 3; ++i) *out++ = atom.position[i];
    const auto residue = [&](const Atom& atom) -> const Residue& { return m.residues[atom.residue]; };
    py::dict atoms;
    atoms["position"] = positions;
    atoms["element"] = nameArray(m, [](const Atom& a) { return elementSymbol(a.element); });
    atoms["name"] = nameArray(m, [](const Atom& a) { return a.name.view(); });
    atoms["residue_name"] = nameArray(m, [&](const Atom& a) { return residue(a).name.view(); });
    atoms["residue_number"] = ofAtoms<std::int32_t>(m, [&](const Atom& a) { return residue(a).number; });
    atoms["insertion_code"] = nameArray(m, [&](const Atom& a) { return toText(residue(a).insertionCode); });
    atoms["altloc"] = nameArray(m, [](const Atom& a) { return toText(a.alternate); });
    atoms["chain"] = nameArray(m, [&](const Atom& a) -> std::string_view { return m.chains[residue(a).chain].name; });
    atoms["model"] = ofAtoms<std::int32_t>(m, [&](const Atom& a) { return m.chains[residue(a).chain].model; });
    atoms["b_factor"] = ofAtoms<float>(m, [](const Atom& a) { return a.temperatureFactor; });
    atoms["occupancy"] = ofAtoms<float>(m, [](const Atom& a) { return a.occupancy; });
    atoms["charge"] = ofAtoms<std::int8_t>(m, [](const Atom& a) { return a.charge; });
    atoms["hetero"] = ofAtoms<bool>(m, [](const Atom& a) { return a.hetero; });
    const ResidueFacts facts(m);
    atoms["secondary_structure"] = nameArray(m, [&](const Atom& a) -> std::string_view {
        if (facts.kinds()[a.residue] != ResidueKind::protein) return {};
        const SecondaryStructure fold = facts.folds()[a.residue];
        return fold == SecondaryStructure::helix ? "helix" : fold == SecondaryStructure::strand ? "strand" : "coil";
    });
    return atoms;
}

py::array_t<std::uint32_t> listBonds(const Structure& structure) {
    const std::vector<Bond>& bonds = structure.molecule->bonds;
    const std::vector<std::uint8_t> orders = drawnOrders(*structure.molecule);
    std::vector<std::uint32_t> rows;
    for (std::size_t i = 0; i < bonds.size(); ++i) rows.insert(rows.end(), {bonds[i].a, bonds[i].b, orders[i]});
    const auto count = static_cast<py::ssize_t>(bonds.size());
    return toArray(rows, {count, 3});
}

[[noreturn]] void refuse(const std::string& what) { throw app::UsageError("from_arrays(): " + what); }

void addBonds(Molecule& m, const Integers& bonds) {
    if (bonds.size() == 0) return;
    if (bonds.ndim() != 2 || (bonds.shape(1) != 2 && bonds.shape(1) != 3))
        refuse("bonds has rows (a, b) or (a, b, order)");
    const auto count = static_cast<std::int64_t>(m.atoms.size());
    for (py::ssize_t i = 0; i < bonds.shape(0); ++i) {
        const std::int64_t a = bonds.at(i, 0), b = bonds.at(i, 1), order = bonds.shape(1) == 3 ? bonds.at(i, 2) : 1;
        const std::string row = "bonds, row " + std::to_string(i) + ": ";
        if (std::min(a, b) < 0 || std::max(a, b) >= count)
            refuse(row + "there are atoms 0 to " + std::to_string(count - 1));
        if (a == b) refuse(row + "an atom is bonded to itself");
        if (order < 1 || order > 4) refuse(row + "an order is 1, 2, 3 or 4 (aromatic)");
        Bond bond;
        bond.a = static_cast<std::uint32_t>(std::min(a, b));
        bond.b = static_cast<std::uint32_t>(std::max(a, b));
        bond.order = static_cast<std::uint8_t>(order);
        m.bonds.push_back(bond);
    }
    const auto place = [](const Bond& x) { return std::pair(x.a, x.b); };
    std::sort(m.bonds.begin(), m.bonds.end(), [&](const Bond& x, const Bond& y) { return place(x) < place(y); });
    const auto same = [&](const Bond& x, const Bond& y) { return place(x) == place(y); };
    m.bonds.erase(std::unique(m.bonds.begin(), m.bonds.end(), same), m.bonds.end());
}

/// Atom data for from_arrays() in addition to position and element; empty if unknown.
struct AtomColumns {
    std::vector<std::string> names, residueNames, chains;
    std::vector<std::int32_t> residueNumbers;
    std::vector<float> temperatureFactors, occupancies;
};

template <typename T>
T entryOr(const std::vector<T>& column, std::size_t i, const T& otherwise) {
    return column.empty() ? otherwise : column[i];
}

template <typename T>
void checkLength(const std::vector<T>& column, std::size_t count, const char* name) {
    if (!column.empty() && column.size() != count)
        refuse(std::string(name) + " has " + std::to_string(column.size()) + " entries for " + std::to_string(count) +
               " atoms");
}

/// Begins a chain or a residue if its name or number changes.
void place(Molecule& m, const std::string& chain, const std::string& residueName, std::int32_t number) {
    const bool newChain = m.chains.empty() || m.chains.back().name != chain;
    if (newChain) {
        m.chains.push_back({chain, 1});
        m.subchains.push_back(chain);
    }
    if (newChain || m.residues.back().number != number || m.residues.back().name != Name(residueName)) {
        Residue residue;
        residue.name = Name(residueName);
        residue.number = number;
        residue.chain = residue.subchain = static_cast<std::uint32_t>(m.chains.size() - 1);
        residue.firstAtom = static_cast<std::uint32_t>(m.atoms.size());
        m.residues.push_back(residue);
    }
    ++m.residues.back().atomCount;
}

Structure fromArrays(const Floats& positions, const std::vector<std::string>& elements,
                     const std::optional<Integers>& bonds, const AtomColumns& columns, const std::string& name) {
    if (positions.ndim() != 2 || positions.shape(1) != 3) refuse("positions has rows (x, y, z)");
    const auto count = static_cast<std::size_t>(positions.shape(0));
    if (count == 0) refuse("there are no atoms");
    if (elements.size() != count)
        refuse("elements has " + std::to_string(elements.size()) + " entries for " + std::to_string(count) + " atoms");
    checkLength(columns.names, count, "names");
    checkLength(columns.residueNames, count, "residue_names");
    checkLength(columns.chains, count, "chains");
    checkLength(columns.residueNumbers, count, "residue_numbers");
    checkLength(columns.temperatureFactors, count, "b_factors");
    checkLength(columns.occupancies, count, "occupancies");
    Molecule m;
    m.file.format = "arrays";
    for (std::size_t i = 0; i < count; ++i) {
        Atom atom;
        for (int k = 0; k < 3; ++k) atom.position[k] = positions.at(static_cast<py::ssize_t>(i), k);
        if (!(std::abs(atom.position.x) < 1e6f && std::abs(atom.position.y) < 1e6f && std::abs(atom.position.z) < 1e6f))
            refuse("positions, row " + std::to_string(i) + ": not within 1,000,000 A");
        atom.element = elementFromSymbol(elements[i]);
        if (atom.element == 0 && elements[i] != "X")
            refuse("elements, entry " + std::to_string(i) + ": there is no element '" + elements[i] + "'");
        atom.name = Name(entryOr(columns.names, i, elements[i]));
        atom.temperatureFactor = entryOr(columns.temperatureFactors, i, 0.0f);
        atom.occupancy = entryOr(columns.occupancies, i, 1.0f);
        place(m, entryOr(columns.chains, i, std::string()), entryOr(columns.residueNames, i, std::string()),
              entryOr(columns.residueNumbers, i, 0));
        atom.residue = static_cast<std::uint32_t>(m.residues.size() - 1);
        m.atoms.push_back(atom);
    }
    if (bonds)
        addBonds(m, *bonds);
    else
        perceiveBonds(m);
    return {std::make_shared<const Molecule>(std::move(m)), {name}};
}

/// Keeps an array as a map under a name for pictures. An array's last axis is the fastest; a map's first axis is.
void keepDensity(const std::string& name, const Floats& values, const std::vector<double>& cell,
                 const std::vector<double>& origin, bool crystal) {
    if (values.ndim() != 3) throw app::UsageError("density_map(): the values are an array of three axes");
    if (cell.size() != 6 || origin.size() != 3)
        throw app::UsageError("density_map(): a cell is six numbers, an origin three");
    const glm::ivec3 size(static_cast<int>(values.shape(0)), static_cast<int>(values.shape(1)),
                          static_cast<int>(values.shape(2)));
    std::vector<float> turned(static_cast<std::size_t>(values.size()));
    const float* value = values.data();
    for (int x = 0; x < size.x; ++x)
        for (int y = 0; y < size.y; ++y)
            for (int z = 0; z < size.z; ++z) turned[(static_cast<std::size_t>(z) * size.y + y) * size.x + x] = *value++;
    const UnitCell edges{{cell[0], cell[1], cell[2]}, {cell[3], cell[4], cell[5]}};
    app::keepMap(name, std::make_shared<const DensityMap>(mapOfValues(
                           name, size, edges, {origin[0], origin[1], origin[2]}, crystal, std::move(turned))));
}

/// Rows of sRGB code values with straight alpha, as in a PNG.
py::array codeArray(Drawn drawn) {
    if (drawn.codes) {
        auto* const codes = new CodedPicture(std::move(*drawn.codes));
        const py::capsule owner(codes, [](void* picture) { delete static_cast<CodedPicture*>(picture); });
        return py::array_t<std::uint8_t>(
            {static_cast<py::ssize_t>(codes->height), static_cast<py::ssize_t>(codes->width), py::ssize_t{4}},
            codes->bytes.data(), owner);
    }
    const Picture& picture = drawn.picture;
    py::array_t<std::uint16_t> array(
        {static_cast<py::ssize_t>(picture.height), static_cast<py::ssize_t>(picture.width), py::ssize_t{4}});
    std::uint16_t* out = array.mutable_data();
    const py::gil_scoped_release others;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) codePixel(picture.rgba.data() + i, true, out + i);
    return array;
}

py::dict toDict(const LayerPicture& l) {
    const auto height = static_cast<py::ssize_t>(l.height), width = static_cast<py::ssize_t>(l.width);
    py::dict layers;
    layers["rgba"] = toArray(l.rgba, {height, width, 4});
    layers["z"] = toArray(l.z, {height, width});
    layers["normal"] = toArray(l.normal, {height, width, 3});
    layers["id"] = toArray(l.id, {height, width});
    layers["occlusion"] = toArray(l.occlusion, {height, width});
    return layers;
}

/// Runs a function without the GIL.
template <typename Work>
auto freely(Work&& work) {
    const py::gil_scoped_release others;
    return work();
}

void addReading(py::module_& m) {
    py::class_<Structure>(m, "Structure")
        .def_property_readonly("name", [](const Structure& s) { return s.inputs.front(); })
        .def_property_readonly("title", [](const Structure& s) { return py::bytes(s.molecule->file.title); })
        .def_property_readonly("format", [](const Structure& s) { return s.molecule->file.format; })
        .def_property_readonly("warnings", [](const Structure& s) { return s.molecule->warnings; })
        .def_property_readonly("said", [](const Structure& s) { return std::pair(s.warnings, s.notes); })
        .def("__len__", [](const Structure& s) { return s.molecule->atoms.size(); })
        .def("atoms", &listAtoms)
        .def("bonds", &listBonds)
        .def("info",
             [](const Structure& s) { return py::bytes(app::infoJson(*s.molecule).dump(-1, ' ', true, kReplace)); })
        .def("interactions",
             [](const Structure& s, const std::string& options) {
                 return py::bytes(freely([&] { return interactions(s, options); }).dump(-1, ' ', true, kReplace));
             })
        .def("select",
             [](const Structure& s, const std::string& selection) {
                 const std::vector<bool> chosen = freely([&] { return selected(s, selection); });
                 py::array_t<bool> mask(static_cast<py::ssize_t>(chosen.size()));
                 std::copy(chosen.begin(), chosen.end(), mask.mutable_data());
                 return mask;
             })
        .def(py::pickle(
            [](const Structure& s) {
                // Without the trajectory; atoms have the positions of its frame.
                return py::make_tuple(py::bytes(freely([&] { return pickled(*s.molecule); })), s.inputs, s.notes,
                                      s.reading.model, s.reading.conformations);
            },
            [](const py::tuple& state) {
                const std::string bytes = state[0].cast<py::bytes>();
                auto molecule = std::make_shared<const Molecule>(unpickled(bytes));
                Structure structure{std::move(molecule), state[1].cast<std::vector<std::string>>()};
                structure.notes = state[2].cast<std::vector<std::string>>();
                structure.reading.model = state[3].cast<int>();
                structure.reading.conformations = state[4].cast<bool>();
                return structure;
            }));
    py::class_<Frames>(m, "Frames")
        .def(py::init<const Structure&>())
        .def("__len__", &Frames::count)
        .def("at", [](const Frames& frames, std::uint64_t frame) { return freely([&] { return frames.at(frame); }); });
    m.def("open_inputs", [](const std::vector<std::string>& inputs, const std::string& options) {
        return interruptible([inputs, options] { return openInputs(inputs, options); });
    });
    m.def("open_bytes", [](const std::string& name, const py::bytes& bytes, const std::string& options) {
        return interruptible(
            [name, text = std::string(bytes), options]() mutable { return openBytes(name, std::move(text), options); });
    });
    m.def("from_arrays",
          [](const Floats& positions, const std::vector<std::string>& elements, const std::optional<Integers>& bonds,
             const std::vector<std::string>& names, const std::vector<std::string>& residueNames,
             const std::vector<std::int32_t>& residueNumbers, const std::vector<std::string>& chains,
             const std::vector<float>& temperatureFactors, const std::vector<float>& occupancies,
             const std::string& name) {
              return fromArrays(positions, elements, bonds,
                                {names, residueNames, chains, residueNumbers, temperatureFactors, occupancies}, name);
          });
}

void addDrawing(py::module_& m) {
    py::class_<Colors>(m, "Colors")
        .def(py::init([](const py::array_t<std::uint8_t, py::array::c_style>& rgb) {
            Colors colors;
            for (py::ssize_t i = 0; i < rgb.shape(0); ++i)
                colors.atoms.push_back(0xff000000u | static_cast<std::uint32_t>(rgb.at(i, 0)) |
                                       static_cast<std::uint32_t>(rgb.at(i, 1)) << 8 |
                                       static_cast<std::uint32_t>(rgb.at(i, 2)) << 16);
            return colors;
        }))
        .def(py::init())
        .def_static("of_values", &colorsOfValues);
    m.def("density_map", &keepDensity);
    m.def("render", [](const Structure& s, const std::string& options, const Colors& colors) {
        Drawn drawn = interruptible([s, options, colors] { return draw(s, options, colors); });
        std::vector<std::string> warnings = std::move(drawn.warnings);
        return std::pair(codeArray(std::move(drawn)), std::move(warnings));
    });
    m.def("render_all", [](const Structure& s, const std::vector<std::string>& options, const Colors& colors) {
        std::vector<Drawn> all = interruptible([s, options, colors] { return drawAll(s, options, colors); });
        py::list pictures;
        for (Drawn& drawn : all) {
            std::vector<std::string> warnings = std::move(drawn.warnings);
            pictures.append(py::make_tuple(codeArray(std::move(drawn)), std::move(warnings)));
        }
        return pictures;
    });
    m.def("layers", [](const Structure& s, const std::string& options, const Colors& colors) {
        const auto [layers, warnings] = interruptible([s, options, colors] {
            std::vector<std::string> said;
            LayerPicture drawn = drawLayers(s, options, colors, said);
            return std::pair(std::move(drawn), std::move(said));
        });
        return std::pair(toDict(layers), warnings);
    });
    m.def("save", [](const Structure& s, const std::string& path, const std::string& options, const Colors& colors) {
        return interruptible([s, path, options, colors] { return save(s, path, options, colors); });
    });
    m.def("export", [](const Structure& s, const std::string& path, const std::string& options, const Colors& colors) {
        return interruptible([s, path, options, colors] { return exportScene(s, path, options, colors); });
    });
    m.def("movie", [](const Structure& s, const std::string& path,
                      const std::vector<std::pair<std::string, std::string>>& motion, bool sequence, bool morph,
                      bool loop, const std::string& options, const Colors& colors) {
        if (sequence && morph) throw app::UsageError("models and morph exclude each other");
        using M = app::MovieModels;
        const M models = morph ? M::morph : sequence ? M::sequence : M::one;
        return interruptible([s, path, moving = Moving{motion, models, loop}, options, colors] {
            return movie(s, path, moving, options, colors, checkInterrupt);
        });
    });
    m.def("option_names", &optionNames);
    m.def("option_schema", &schemaOfOptions);
}

}  // namespace
}  // namespace nacre::python

PYBIND11_MODULE(_nacre, m) {
    using namespace nacre::python;
    m.attr("__version__") = NACRE_VERSION;
    static py::exception<nacre::Error> error(m, "Error", PyExc_RuntimeError);
    static py::exception<nacre::app::InputMissing> missing(m, "Missing", error.ptr());
    static py::exception<nacre::app::UsageError> usage(m, "UsageError", PyExc_ValueError);
    py::register_exception_translator([](std::exception_ptr failure) {
        try {
            if (failure) std::rethrow_exception(failure);
        } catch (const nacre::app::UsageError& e) {
            usage(e.what());
        } catch (const nacre::app::InputMissing& e) {
            PyErr_SetObject(missing.ptr(), py::make_tuple(e.what(), e.path()).ptr());
        } catch (const nacre::Error& e) {
            error(e.what());
        }
    });
    addReading(m);
    addDrawing(m);
}
