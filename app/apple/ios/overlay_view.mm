#import "app/apple/ios/overlay_view.h"

#include "app/apple/ios/document_access.h"

namespace {

constexpr CGFloat kRing = 8, kMargin = 12;  // points

CAShapeLayer* strokes(CGFloat width) {
    CAShapeLayer* layer = [CAShapeLayer layer];
    layer.lineWidth = width;
    layer.fillColor = nil;
    return layer;
}

UILabel* line(UIFontTextStyle style) {
    UILabel* label = [[UILabel alloc] init];
    label.font = [UIFont preferredFontForTextStyle:style];
    label.adjustsFontForContentSizeCategory = YES;
    label.numberOfLines = 0;
    label.textAlignment = NSTextAlignmentCenter;
    label.layer.cornerRadius = 7;
    label.layer.masksToBounds = YES;
    label.isAccessibilityElement = NO;  // the molecule's view speaks for them
    return label;
}

}  // namespace

@implementation OverlayView {
    CAShapeLayer *_edges, *_marks;
    UILabel *_atom, *_measurement, *_message;
}

- (instancetype)initWithFrame:(CGRect)frame {
    if ((self = [super initWithFrame:frame])) {
        self.userInteractionEnabled = NO;
        _edges = strokes(5);
        _marks = strokes(2);
        [self.layer addSublayer:_edges];
        [self.layer addSublayer:_marks];
        _atom = line(UIFontTextStyleBody);
        _measurement = line(UIFontTextStyleHeadline);
        _message = line(UIFontTextStyleBody);
        UIStackView* lines = [[UIStackView alloc] initWithArrangedSubviews:@[ _atom, _measurement, _message ]];
        lines.axis = UILayoutConstraintAxisVertical;
        lines.alignment = UIStackViewAlignmentCenter;
        lines.spacing = 6;
        lines.translatesAutoresizingMaskIntoConstraints = NO;
        [self addSubview:lines];
        UILayoutGuide* safe = self.safeAreaLayoutGuide;
        [NSLayoutConstraint activateConstraints:@[
            [lines.centerXAnchor constraintEqualToAnchor:safe.centerXAnchor],
            [lines.widthAnchor constraintLessThanOrEqualToAnchor:safe.widthAnchor constant:-2 * kMargin],
            [lines.bottomAnchor constraintEqualToAnchor:safe.bottomAnchor constant:-kMargin],
        ]];
    }
    return self;
}

- (void)show:(const nacre::app::Annotations&)annotations colors:(const nacre::app::LabelColors&)colors {
    [self mark:annotations.atoms colors:colors];
    const auto fill = [&](UILabel* label, const std::string& text) {
        label.hidden = text.empty();
        // No-break spaces about the text are its padding.
        NSString* padded = [NSString stringWithFormat:@"\u00a0%@\u00a0", nacre::app::stringOf(text)];
        if (![label.text isEqualToString:padded]) label.text = padded;
        label.textColor = nacre::app::colorOf(colors.text);
        label.backgroundColor = nacre::app::colorOf(colors.ground);
    };
    fill(_atom, annotations.atom);
    fill(_measurement, annotations.measurement);
    fill(_message, annotations.message);
}

- (void)mark:(const std::vector<glm::dvec2>&)atoms colors:(const nacre::app::LabelColors&)colors {
    UIBezierPath* path = [UIBezierPath bezierPath];
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const CGPoint at = CGPointMake(atoms[i].x, atoms[i].y);
        if (i > 0) {
            [path moveToPoint:CGPointMake(atoms[i - 1].x, atoms[i - 1].y)];
            [path addLineToPoint:at];
        }
        [path appendPath:[UIBezierPath
                             bezierPathWithOvalInRect:CGRectMake(at.x - kRing, at.y - kRing, 2 * kRing, 2 * kRing)]];
    }
    [CATransaction begin];
    CATransaction.disableActions = YES;  // marks do not lag behind their atoms
    _edges.path = _marks.path = path.CGPath;
    _edges.strokeColor = nacre::app::colorOf(colors.ground).CGColor;
    _marks.strokeColor = nacre::app::colorOf(colors.text).CGColor;
    [CATransaction commit];
}

@end

namespace nacre::app {

UIColor* colorOf(const LabelColor& color) {
    return [UIColor colorWithRed:color[0] green:color[1] blue:color[2] alpha:color[3]];
}

}  // namespace nacre::app
