# The files that the apps open, as property lists state them: from one table
#   NACRE_IMPORTED_TYPES, NACRE_DOCUMENT_TYPES
# Imported, since the formats are others': an app of theirs that exports a type under the same name has the last word.

# name | type | endings (engine/molecule/formats/detect.cpp) | conforms to
set(formats
    "PDB structure|org.wwpdb.pdb|pdb ent|public.plain-text"
    "mmCIF structure|org.wwpdb.mmcif|cif mmcif mcif|public.plain-text"
    "mmJSON structure|org.pdbj.mmjson|mmjson|public.json"
    "BinaryCIF structure|org.molstar.bcif|bcif|public.data"
    "MMTF structure|org.rcsb.mmtf|mmtf|public.data"
    "SDF molecule|com.mdl.sdf|sdf sd mol mdl|public.plain-text"
    "XYZ coordinates|org.openmopac.xyz|xyz extxyz|public.plain-text"
    "MOL2 molecule|com.tripos.mol2|mol2|public.plain-text"
    "PQR structure|org.poissonboltzmann.pqr|pqr|public.plain-text"
    "GROMACS structure|org.gromacs.gro|gro|public.plain-text"
    "PDBQT structure|edu.scripps.pdbqt|pdbqt|public.plain-text"
    "Chemical Markup Language|org.xml-cml.cml|cml|public.xml")
# The systems' own: mmJSON and saved views under their plain ending, and each of the above compressed.
set(others "JSON|public.json" "Compressed structure|org.gnu.gnu-zip-archive")

set(NACRE_IMPORTED_TYPES "")
set(NACRE_DOCUMENT_TYPES "")
foreach(format ${formats})
    string(REPLACE "|" ";" format "${format}")
    list(GET format 0 name)
    list(GET format 1 type)
    list(GET format 2 endings)
    list(GET format 3 parent)
    string(REPLACE " " "</string><string>" endings "${endings}")
    string(APPEND NACRE_IMPORTED_TYPES "
        <dict>
            <key>UTTypeIdentifier</key><string>${type}</string>
            <key>UTTypeDescription</key><string>${name}</string>
            <key>UTTypeConformsTo</key><array><string>${parent}</string></array>
            <key>UTTypeTagSpecification</key>
            <dict><key>public.filename-extension</key><array><string>${endings}</string></array></dict>
        </dict>")
    list(APPEND documents "${name}|${type}|Default")
endforeach()
foreach(other ${others})
    list(APPEND documents "${other}|Alternate")
endforeach()
foreach(document ${documents})
    string(REPLACE "|" ";" document "${document}")
    list(GET document 0 name)
    list(GET document 1 type)
    list(GET document 2 rank)
    string(APPEND NACRE_DOCUMENT_TYPES "
        <dict>
            <key>CFBundleTypeName</key><string>${name}</string>
            <key>CFBundleTypeRole</key><string>Viewer</string>
            <key>LSHandlerRank</key><string>${rank}</string>
            <key>LSItemContentTypes</key><array><string>${type}</string></array>
        </dict>")
endforeach()
