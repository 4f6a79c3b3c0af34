#pragma once
// The view that the molecule is drawn into, and its hands: fingers, pencil, mouse, trackpad, keys.

#import <QuartzCore/CAMetalLayer.h>
#import <UIKit/UIKit.h>

#include "app/apple/session.h"

NS_ASSUME_NONNULL_BEGIN

@class MoleculeView;

@protocol MoleculeViewDelegate <NSObject>
- (void)moleculeViewResized:(MoleculeView*)view;
/// The viewer was told of something, or has to be: a command that is not the viewer's alone.
- (void)moleculeViewTouched:(MoleculeView*)view;
- (void)moleculeView:(MoleculeView*)view command:(nacre::app::ViewerCommand)command;
@end

@interface MoleculeView : UIView

@property(nonatomic, weak) id<MoleculeViewDelegate> delegate;
/// Not owned. Without one every touch is let go.
@property(nonatomic, nullable) nacre::app::MoleculeSession* session;
@property(nonatomic, readonly) CAMetalLayer* metalLayer;
@property(nonatomic, readonly) nacre::PixelSize pixels;

@end

NS_ASSUME_NONNULL_END
