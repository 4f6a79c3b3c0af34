# File types that the programs open, from one table:
#   NACRE_IMPORTED_TYPES, NACRE_DOCUMENT_TYPES   as Apple's property lists state them
#   NACRE_MIME_TYPES, NACRE_MIME_INFO            as freedesktop's files do
# Imported, because others own the formats: an app that exports a type of the same name has precedence.

# name | type | conforms to | MIME type (chemical/x-) of Rzepa et al. 1998, if there is one, and extensions, as in
# engine/molecule/formats/format_table.cpp
set(formats
    "PDB structure|org.wwpdb.pdb|public.plain-text|pdb:pdb,ent"
    "mmCIF structure|org.wwpdb.mmcif|public.plain-text|cif:cif mmcif:mmcif,mcif"
    "mmJSON structure|org.pdbj.mmjson|public.json|:mmjson"
    "BinaryCIF structure|org.molstar.bcif|public.data|bcif:bcif"
    "MMTF structure|org.rcsb.mmtf|public.data|mmtf:mmtf"
    "SDF molecule|com.mdl.sdf|public.plain-text|mdl-sdfile:sdf,sd mdl-molfile:mol :mdl"
    "XYZ coordinates|org.openmopac.xyz|public.plain-text|xyz:xyz,extxyz"
    "MOL2 molecule|com.tripos.mol2|public.plain-text|mol2:mol2"
    "PQR structure|org.poissonboltzmann.pqr|public.plain-text|pqr:pqr"
    "GROMACS structure|org.gromacs.gro|public.plain-text|gro:gro"
    "PDBQT structure|edu.scripps.pdbqt|public.plain-text|pdbqt:pdbqt"
    "Chemical Markup Language|org.xml-cml.cml|public.xml|cml:cml"
    "Simulation topology|org.charmm.psf|public.plain-text|:psf :prmtop,parm7 :top,itp"
    "AMBER coordinates|org.ambermd.inpcrd|public.plain-text|:inpcrd,rst7,restrt"
    "LAMMPS simulation|org.lammps.data|public.plain-text|:lmp,data :lammpstrj,dump"
    "HOOMD simulation|org.glotzerlab.gsd|public.data|:gsd"
    "H5MD simulation|org.nongnu.h5md|public.data|:h5md"
    "VASP structure|at.vasp.poscar|public.plain-text|:poscar,vasp"
    "XCrySDen structure|org.xcrysden.xsf|public.plain-text|:xsf,axsf"
    "Tinker coordinates|edu.wustl.tinker|public.plain-text|:txyz,arc"
    "Maestro structure|com.schrodinger.mae|public.plain-text|:mae,maegz"
    "Density map|org.ccp4.map|public.data|:ccp4,mrc,map :dsn6,brix"
    "Values on a grid|org.opendx.dx|public.plain-text|:dx gaussian-cube:cube")
# First bytes of a file of a MIME type, if they identify it better than its extension.
set(magic_pdb "    <magic priority=\"50\"><match type=\"string\" offset=\"0:81\" value=\"HEADER    \"/></magic>\n")
set(magic_mol2 "    <magic priority=\"50\"><match type=\"string\" offset=\"0:1024\" value=\"@&lt;TRIPOS&gt;MOLECULE\"/></magic>\n")
set(parent_public.plain-text text/plain)
set(parent_public.data application/octet-stream)
set(parent_public.xml application/xml)
# The systems' own types: mmJSON and saved views under their plain extension, and compressed files of each type above.
set(others "JSON|public.json" "Compressed structure|org.gnu.gnu-zip-archive")

set(NACRE_IMPORTED_TYPES "")
set(NACRE_DOCUMENT_TYPES "")
set(NACRE_MIME_TYPES "")
set(NACRE_MIME_INFO "")
foreach(format ${formats})
    string(REPLACE "|" ";" format "${format}")
    list(GET format 0 name)
    list(GET format 1 type)
    list(GET format 2 parent)
    list(GET format 3 kinds)
    string(REPLACE " " ";" kinds "${kinds}")
    set(endings "")
    foreach(kind ${kinds})
        string(REGEX MATCH "^([^:]*):(.*)$" kind "${kind}")
        set(mime "${CMAKE_MATCH_1}")
        string(REPLACE "," ";" own "${CMAKE_MATCH_2}")
        list(APPEND endings ${own})
        if(mime)
            string(APPEND NACRE_MIME_TYPES "chemical/x-${mime};")
            list(TRANSFORM own REPLACE "^(.+)$" "    <glob pattern=\"*.\\1\"/>\n" OUTPUT_VARIABLE globs)
            list(JOIN globs "" globs)
            string(APPEND NACRE_MIME_INFO "  <mime-type type=\"chemical/x-${mime}\">
    <comment>${name}</comment>
    <sub-class-of type=\"${parent_${parent}}\"/>
    <generic-icon name=\"x-office-document\"/>
${magic_${mime}}${globs}  </mime-type>\n")
        endif()
    endforeach()
    list(JOIN endings "</string><string>" endings)
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
