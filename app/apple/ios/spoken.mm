#import "app/apple/ios/spoken.h"

#import "app/apple/ios/document_access.h"

using nacre::app::Control;
using nacre::app::ViewerCommand;

namespace {

struct SpokenAction {
    NSString* name;
    ViewerCommand command;
};
SpokenAction const kActions[] = {
    {@"Turn left", ViewerCommand::rotateLeft},
    {@"Turn right", ViewerCommand::rotateRight},
    {@"Turn up", ViewerCommand::rotateUp},
    {@"Turn down", ViewerCommand::rotateDown},
    {@"Show all", ViewerCommand::fit},
    {@"Spin, or stop", ViewerCommand::autoRotate},
    {@"Next colouring", ViewerCommand::nextColor},
};

UIAccessibilityTraits toTraits(const Control& control) {
    if (control.role == "image")
        return UIAccessibilityTraitImage | UIAccessibilityTraitAdjustable | UIAccessibilityTraitAllowsDirectInteraction;
    UIAccessibilityTraits traits = UIAccessibilityTraitButton;
    if (control.role == "text") traits = UIAccessibilityTraitStaticText;
    if (control.role == "slider") traits = UIAccessibilityTraitAdjustable;
    if (control.role == "heading") traits = UIAccessibilityTraitHeader | UIAccessibilityTraitButton;
    const bool chosen =
        (control.role == "choice" || control.role == "tab" || control.role == "colour") && control.value == "on";
    if (chosen) traits |= UIAccessibilityTraitSelected;
    if (!control.enabled) traits |= UIAccessibilityTraitNotEnabled;
    return traits;
}

}  // namespace

/// One of the controls, as reported to VoiceOver.
@interface SpokenControl : UIAccessibilityElement
@property(nonatomic, weak) SpokenMoleculeView* view;
- (void)tell:(const Control&)control;
@end

@implementation SpokenControl {
    Control _control;
}

- (void)tell:(const Control&)control {
    _control = control;
    const CGFloat scale = self.view.contentScaleFactor;
    self.accessibilityLabel = nacre::app::toNSString(control.name);
    self.accessibilityValue = nacre::app::toNSString(control.value);
    self.accessibilityTraits = toTraits(control);
    self.accessibilityFrameInContainerSpace =
        CGRectMake(control.seenLeft / scale, control.seenTop / scale, (control.seenRight - control.seenLeft) / scale,
                   (control.seenBottom - control.seenTop) / scale);
}

- (BOOL)accessibilityActivate {
    if (_control.role == "image" || _control.role == "text") return NO;
    if (self.view.session) self.view.session->press(_control.role, _control.name);
    [self.view.delegate moleculeViewTouched:self.view];
    return YES;
}

- (void)accessibilityIncrement {
    [self step:YES];
}

- (void)accessibilityDecrement {
    [self step:NO];
}

- (void)step:(BOOL)up {
    if (_control.role == "image") return [self.view run:up ? ViewerCommand::zoomIn : ViewerCommand::zoomOut];
    if (self.view.session) self.view.session->adjust(_control.name, up);
    [self.view.delegate moleculeViewTouched:self.view];
}

@end

@implementation SpokenMoleculeView {
    NSMutableArray<SpokenControl*>* _elements;
    std::string _told, _value;
}

- (NSArray<UIAccessibilityCustomAction*>*)actions {
    NSMutableArray<UIAccessibilityCustomAction*>* actions = [NSMutableArray array];
    for (const SpokenAction& action : kActions) {
        const ViewerCommand command = action.command;
        __weak SpokenMoleculeView* weakSelf = self;
        [actions addObject:[[UIAccessibilityCustomAction alloc] initWithName:action.name
                                                               actionHandler:^BOOL(UIAccessibilityCustomAction*) {
                                                                 SpokenMoleculeView* view = weakSelf;
                                                                 [view run:command];
                                                                 return view != nil;
                                                               }]];
    }
    return actions;
}

/// Elements are reused while their number is equal: VoiceOver keeps its position.
- (void)say:(const std::vector<Control>&)controls {
    const std::string lines = nacre::app::controlLines(controls);
    if (lines == _told || controls.empty()) return;
    _told = lines;
    const bool others = _elements.count != controls.size();
    if (others) {
        _elements = [NSMutableArray array];
        for (std::size_t i = 0; i < controls.size(); ++i) {
            SpokenControl* element = [[SpokenControl alloc] initWithAccessibilityContainer:self];
            element.view = self;
            if (i == 0) element.accessibilityCustomActions = [self actions];
            [_elements addObject:element];
        }
        self.accessibilityElements = _elements;
    }
    std::size_t i = 0;
    for (SpokenControl* element in _elements) [element tell:controls[i++]];
    if (others) UIAccessibilityPostNotification(UIAccessibilityLayoutChangedNotification, nil);
    const std::string& value = controls.front().value;
    if (value != _value && !value.empty())
        UIAccessibilityPostNotification(UIAccessibilityAnnouncementNotification, nacre::app::toNSString(value));
    _value = value;
}

@end
