// Buffers with which the device lists the primitives of each bin (engine/tiles/device_lists.h).
//   work   for each bin: number of entries | kSmallBit; for each bin: where its next entry goes, or kNoRoom and more;
//          then two words per entry: step of depth, number of the primitive
//   lists  as HostLists::write()

layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
const uint kNoRoom = 0x80000000u;    // another round lists the bin
const uint kSmallBit = 0x80000000u;  // a primitive smaller than a pixel is among them
