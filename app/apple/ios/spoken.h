#pragma once
// The molecule's view for those who hear it: VoiceOver reads the title and the last pick, swipes zoom, and actions
// turn. Over it lie the panel's controls, each with its name and its value.

#import "app/apple/ios/molecule_view.h"

NS_ASSUME_NONNULL_BEGIN

@interface SpokenMoleculeView : MoleculeView

/// @param controls  the picture first; its value is read aloud when it changes
- (void)say:(const std::vector<nacre::app::Control>&)controls;

@end

NS_ASSUME_NONNULL_END
