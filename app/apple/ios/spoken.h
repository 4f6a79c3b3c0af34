#pragma once
// The molecule's view for those who hear it: VoiceOver reads the title and the last pick, swipes zoom, and actions
// turn.

#import "app/apple/ios/molecule_view.h"

NS_ASSUME_NONNULL_BEGIN

@class SpokenMoleculeView;

@protocol SpokenViewDelegate <NSObject>
- (void)spokenView:(SpokenMoleculeView*)view command:(nacre::app::ViewerCommand)command;
@end

@interface SpokenMoleculeView : MoleculeView

@property(nonatomic, weak) id<SpokenViewDelegate> speaker;
/// @param label what is shown
/// @param value what was picked, measured or said last: read aloud when it changes
- (void)say:(NSString*)label value:(NSString*)value;

@end

NS_ASSUME_NONNULL_END
