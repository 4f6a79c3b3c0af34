#pragma once
// Accessibility of the molecule's view: VoiceOver reads the title and the last pick, swipes zoom, and actions rotate.
// Also lists the panel's controls with their names and values.

#import "app/apple/ios/molecule_view.h"

NS_ASSUME_NONNULL_BEGIN

@interface SpokenMoleculeView : MoleculeView

/// @param controls  the picture first; its value is read aloud when it changes
- (void)say:(const std::vector<nacre::app::Control>&)controls;

@end

NS_ASSUME_NONNULL_END
