# Where no costs are known yet, what is long begins before what is short: last, it would leave a core without work. COST is in
# seconds, about; those of suites stand beside them.
set(long_entries android_package/compiles_for_arm64 15 android_package/apk 13 python 110 docs/batch 19 docs/measure 14 apple/shaders 18
    apple/syntax 12 molecule/beside_rdkit 10 molecule/beside_plip 10)
while(long_entries)
    list(POP_FRONT long_entries entry cost)
    if(TEST ${entry})
        set_tests_properties(${entry} PROPERTIES COST ${cost})
    endif()
endwhile()
