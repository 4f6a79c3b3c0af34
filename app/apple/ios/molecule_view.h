#pragma once
// The view that the molecule is drawn into, and its input: fingers, pencil, mouse, trackpad, keys.

#import <QuartzCore/CAMetalLayer.h>
#import <UIKit/UIKit.h>

#include "app/phone/session.h"

NS_ASSUME_NONNULL_BEGIN

@class MoleculeView;

@protocol MoleculeViewDelegate <NSObject>
- (void)moleculeViewResized:(MoleculeView*)view;
/// The session received input.
- (void)moleculeViewTouched:(MoleculeView*)view;
@end

@interface MoleculeView : UIView

@property(nonatomic, weak) id<MoleculeViewDelegate> delegate;
/// Not owned. Without one touches are ignored.
@property(nonatomic, nullable) nacre::app::PhoneSession* session;
@property(nonatomic, readonly) CAMetalLayer* metalLayer;
@property(nonatomic, readonly) nacre::PixelSize pixels;
- (void)run:(nacre::app::ViewerCommand)command;

@end

NS_ASSUME_NONNULL_END
