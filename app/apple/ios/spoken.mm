#import "app/apple/ios/spoken.h"

using nacre::app::ViewerCommand;

namespace {

struct SpokenAction {
    NSString* name;
    ViewerCommand command;
};
SpokenAction const kActions[] = {
    {@"Turn left", ViewerCommand::rotateLeft},     {@"Turn right", ViewerCommand::rotateRight},
    {@"Turn up", ViewerCommand::rotateUp},         {@"Turn down", ViewerCommand::rotateDown},
    {@"Show the whole", ViewerCommand::fit},       {@"Turn by itself, or stop", ViewerCommand::autoRotate},
    {@"Next colouring", ViewerCommand::nextColor},
};

}  // namespace

@implementation SpokenMoleculeView

- (instancetype)initWithFrame:(CGRect)frame {
    if ((self = [super initWithFrame:frame])) {
        self.isAccessibilityElement = YES;
        self.accessibilityTraits =
            UIAccessibilityTraitImage | UIAccessibilityTraitAdjustable | UIAccessibilityTraitAllowsDirectInteraction;
        NSMutableArray<UIAccessibilityCustomAction*>* actions = [NSMutableArray array];
        for (const SpokenAction& action : kActions) {
            const ViewerCommand command = action.command;
            __weak SpokenMoleculeView* weakSelf = self;
            [actions addObject:[[UIAccessibilityCustomAction alloc] initWithName:action.name
                                                                   actionHandler:^BOOL(UIAccessibilityCustomAction*) {
                                                                     return [weakSelf ask:command];
                                                                   }]];
        }
        self.accessibilityCustomActions = actions;
    }
    return self;
}

- (BOOL)ask:(ViewerCommand)command {
    [self.speaker spokenView:self command:command];
    return self.speaker != nil;
}

- (void)accessibilityIncrement {
    [self ask:ViewerCommand::zoomIn];
}

- (void)accessibilityDecrement {
    [self ask:ViewerCommand::zoomOut];
}

- (void)say:(NSString*)label value:(NSString*)value {
    self.accessibilityLabel = label;
    if ([self.accessibilityValue isEqualToString:value]) return;
    self.accessibilityValue = value;
    if (value.length > 0) UIAccessibilityPostNotification(UIAccessibilityAnnouncementNotification, value);
}

@end
