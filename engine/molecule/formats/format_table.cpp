#include "engine/molecule/formats/format_table.h"

#include <algorithm>

namespace nacre {

// A function per format, in a file of its own. Their text has only '\n' as line end. Each returns at least one
// atom and the bonds that the file states; it throws Error with the line, and tooManyAtoms() at the first atom too
// many.
Molecule readPdb(const std::string& name, std::string_view text, const ReadOptions&);
/// Formats whose models share tables: the options' model, and all after it up to `lastModel`. Each has the file's
/// summary.
std::vector<Molecule> readMmcif(const std::string& name, std::string_view text, const ReadOptions&, int lastModel);
std::vector<Molecule> readMmjson(const std::string& name, std::string_view text, const ReadOptions&, int lastModel);
std::vector<Molecule> readBcif(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel);
std::vector<Molecule> readMmtf(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel);
Molecule readSdf(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readXyz(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readMol2(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPqr(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readGro(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPdbqt(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readCml(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPsf(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readPrmtop(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readTop(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readInpcrd(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readLammps(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readLammpstrj(const std::string& name, std::string_view text, const ReadOptions&);
std::vector<Molecule> readGsd(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel);
Molecule readPoscar(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readXsf(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readTinker(const std::string& name, std::string_view text, const ReadOptions&);
Molecule readMae(const std::string& name, std::string_view text, const ReadOptions&);
std::vector<Molecule> readH5md(const std::string& name, std::string_view bytes, const ReadOptions&, int lastModel);

namespace {

constexpr FormatRow kFormats[] = {
    {Format::pdb, "pdb", "PDB", "pdb ent", false, readPdb, nullptr, pdbSpans},
    {Format::mmcif, "mmcif", "mmCIF", "cif mmcif mcif", false, nullptr, readMmcif, mmcifSpans},
    {Format::mmjson, "mmjson", "mmJSON", "json mmjson", false, nullptr, readMmjson},
    {Format::bcif, "bcif", "BinaryCIF", "bcif", true, nullptr, readBcif},
    {Format::mmtf, "mmtf", "MMTF", "mmtf", true, nullptr, readMmtf},
    {Format::sdf, "sdf", "SDF/MOL", "sdf sd mol mdl", false, readSdf, nullptr, sdfSpans},
    {Format::xyz, "xyz", "XYZ", "xyz extxyz", false, readXyz, nullptr, xyzSpans},
    {Format::mol2, "mol2", "MOL2", "mol2", false, readMol2, nullptr, mol2Spans},
    {Format::pqr, "pqr", "PQR", "pqr", false, readPqr, nullptr, pdbSpans},
    {Format::gro, "gro", "GRO", "gro", false, readGro, nullptr, groSpans},
    {Format::pdbqt, "pdbqt", "PDBQT", "pdbqt", false, readPdbqt, nullptr, pdbSpans},
    {Format::cml, "cml", "CML", "cml", false, readCml},
    {Format::psf, "psf", "PSF", "psf", false, readPsf},
    {Format::prmtop, "prmtop", "PRMTOP", "prmtop parm7", false, readPrmtop},
    {Format::top, "top", "TOP", "top itp", false, readTop},
    {Format::inpcrd, "inpcrd", "INPCRD", "inpcrd rst7 restrt", false, readInpcrd},
    {Format::lammps, "lammps", "LAMMPS data", "lmp data", false, readLammps},
    {Format::lammpstrj, "lammpstrj", "LAMMPS dump", "lammpstrj dump", false, readLammpstrj, nullptr, dumpSpans},
    {Format::gsd, "gsd", "GSD", "gsd", true, nullptr, readGsd},
    {Format::poscar, "poscar", "POSCAR", "poscar vasp", false, readPoscar, nullptr, poscarSpans},
    {Format::xsf, "xsf", "XSF", "xsf axsf", false, readXsf, nullptr, xsfSpans},
    {Format::tinker, "tinker", "Tinker XYZ", "txyz arc", false, readTinker, nullptr, tinkerSpans},
    {Format::mae, "mae", "MAE", "mae maegz", false, readMae, nullptr, maeSpans},
    {Format::h5md, "h5md", "H5MD", "h5md", true, nullptr, readH5md},
};

std::string listed(std::string_view FormatRow::*column) {
    std::string list;
    for (const FormatRow& row : kFormats) list += (list.empty() ? "" : ", ") + std::string(row.*column);
    return list;
}

}  // namespace

std::span<const FormatRow> formatRows() { return kFormats; }

const FormatRow& formatRow(Format format) {
    return *std::find_if(std::begin(kFormats), std::end(kFormats),
                         [&](const FormatRow& row) { return row.format == format; });
}

std::optional<Format> formatFromName(std::string_view name) {
    for (const FormatRow& row : kFormats)
        if (name == row.name) return row.format;
    return std::nullopt;
}

std::string_view formatName(Format format) { return formatRow(format).name; }

std::vector<std::string> allFormatNames() {
    std::vector<std::string> names;
    for (const FormatRow& row : kFormats) names.emplace_back(row.name);
    return names;
}

std::string formatNames() { return listed(&FormatRow::name); }

std::string formatTitles() { return listed(&FormatRow::title); }

ModelSpans modelSpans(Format format, const TextSource& text) {
    const FormatRow& row = formatRow(format);
    return row.spans ? row.spans(text) : ModelSpans{};
}

}  // namespace nacre
