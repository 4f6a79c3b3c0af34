#import "app/apple/ios/molecule_controller.h"

#import <QuartzCore/QuartzCore.h>
#import <UniformTypeIdentifiers/UniformTypeIdentifiers.h>

#include <limits>
#include <memory>

#import "app/apple/ios/document_access.h"
#include "app/apple/ios/fetching.h"
#import "app/apple/ios/frame_clock.h"
#import "app/apple/ios/metal_surface.h"
#import "app/apple/ios/molecule_view.h"
#import "app/apple/ios/sharing.h"
#import "app/apple/ios/spoken.h"
#import "app/picture/option_values.h"

using namespace nacre::app;

namespace {

NSString* const kView = @"view";          // of the state: JSON
NSString* const kBookmark = @"bookmark";  // of the state: the access right to the file

constexpr double kHot = 0.94;
constexpr double kBackgroundPatience = 2;  // seconds; the system ends apps that take more than 5

/// For ResolutionControl::setHeat(): the system slows down from "serious" on.
double toHeat(NSProcessInfoThermalState state) {
    switch (state) {
        case NSProcessInfoThermalStateNominal:
            return 0;
        case NSProcessInfoThermalStateFair:
            return 0.85;
        case NSProcessInfoThermalStateSerious:
            return 0.95;
        default:
            return 1;
    }
}

}  // namespace

@interface MoleculeController () <MoleculeViewDelegate, UIDocumentPickerDelegate>
@end

@implementation MoleculeController {
    std::unique_ptr<PhoneSession> _session;
    PictureDescription _first;
    DocumentAccess* _document;
    SpokenMoleculeView* _molecule;
    FrameClock* _clock;
    BOOL _background;
}

- (instancetype)initWithState:(nullable NSDictionary*)state {
    if ((self = [super initWithNibName:nil bundle:nil])) {
        NSString* json = state[kView];
        NSData* bookmark = state[kBookmark];
        if (json) _first = viewOfState(toString(json)).value_or(PictureDescription());
        if (bookmark) _document = [DocumentAccess accessWithBookmark:bookmark];
        if (_document) _first.input.path = toString(_document.url.path);  // it may have moved
        if (_first.input.path.empty()) _first.input.path = "sample:dna";
    }
    return self;
}

- (void)dealloc {
    [_clock stop];
}

// --- views

- (void)viewDidLoad {
    [super viewDidLoad];
    _molecule = [[SpokenMoleculeView alloc] initWithFrame:self.view.bounds];
    _molecule.autoresizingMask = UIViewAutoresizingFlexibleWidth | UIViewAutoresizingFlexibleHeight;
    [self.view addSubview:_molecule];
    _molecule.delegate = self;
    __weak MoleculeController* weakSelf = self;
    _clock = [[FrameClock alloc] initWithStep:[weakSelf](double interval) {
        MoleculeController* controller = weakSelf;
        return controller ? [controller step:interval] : std::numeric_limits<double>::infinity();
    }];
    [self startSession:_first];
}

- (void)viewDidAppear:(BOOL)animated {
    [super viewDidAppear:animated];
    [_molecule becomeFirstResponder];  // for hardware keyboards
}

/// The view has its size: the device can be opened.
- (void)moleculeViewResized:(MoleculeView*)view {
    if (view.pixels.width == 0) return;
    _session->resize(view.pixels, view.contentScaleFactor);
    _session->setTextScale([UIFontMetrics.defaultMetrics scaledValueForValue:100] / 100);
    const UIEdgeInsets safe = view.safeAreaInsets;
    const auto pixels = [&](CGFloat points) { return static_cast<float>(points * view.contentScaleFactor); };
    _session->setInsets({pixels(safe.left), pixels(safe.top), pixels(safe.right), pixels(safe.bottom)});
    if (!_background && !_session->seen())
        [self attempt:^{
          self->_session->setSeen(true);
          self->_clock.suspended = NO;
        }];
    [_clock wake];
}

/// The size of text and other traits.
- (void)traitCollectionDidChange:(nullable UITraitCollection*)previous {
    [super traitCollectionDidChange:previous];
    if (_session) [self moleculeViewResized:_molecule];
}

/// Starts without a device until the view has its size.
- (void)startSession:(const PictureDescription&)first {
    nacre::app::setHttpFetch(nacre::app::fetchBySystem);
    __weak MoleculeController* weakSelf = self;
    PhoneHost host;
    host.clock = CACurrentMediaTime;
    host.surface = makeSurface(_molecule.metalLayer);
    host.readFile = readDocument;
    host.wake = [clock = _clock] {
        dispatch_async(dispatch_get_main_queue(), ^{
          [clock wake];
        });
    };
    host.cache = toString(findFolder(NSCachesDirectory).path);
    host.pickDocument = [weakSelf] { [weakSelf pickDocument]; };
    host.sharePicture = [weakSelf](const PictureBytes& picture, const std::string& name) {
        [weakSelf share:encodePng(picture) name:name];
    };
    host.shareText = [weakSelf](const std::string& text, const std::string& name) {
        [weakSelf share:[toNSString(text) dataUsingEncoding:NSUTF8StringEncoding] name:name];
    };
    host.askText = [weakSelf](const std::string& name, const std::string& text) {
        [weakSelf askFor:toNSString(name) text:toNSString(text)];
    };
    host.copyText = [](const std::string& text) { UIPasteboard.generalPasteboard.string = toNSString(text); };
    host.system =
        toString([NSString stringWithFormat:@"%@ %@, %@", UIDevice.currentDevice.systemName,
                                            UIDevice.currentDevice.systemVersion, UIDevice.currentDevice.model]);
    host.downloads = true;
    host.shakes = true;
    host.dark = self.traitCollection.userInterfaceStyle == UIUserInterfaceStyleDark;
    _molecule.session = nullptr;
    _session = std::make_unique<PhoneSession>(host, first);
    _molecule.session = _session.get();
}

/// Runs code that may throw, and shows its error.
- (BOOL)attempt:(dispatch_block_t)what {
    try {
        what();
        return YES;
    } catch (const std::exception& error) {
        tell(@"Nacre", toNSString(error.what()), self);
        return NO;
    }
}

- (double)step:(double)interval {
    __block double next = std::numeric_limits<double>::infinity();
    _session->viewer().schedule().setDisplayInterval(interval);
    const double heat = toHeat(NSProcessInfo.processInfo.thermalState);
    _session->viewer().schedule().setHeat(heat);
    if (_clock.hot != (heat > kHot)) _clock.hot = heat > kHot;
    const BOOL drawn = [self attempt:^{
      next = self->_session->step();
    }];
    if (!drawn) {
        _clock.suspended = YES;  // it would fail again with the next frame
        return next;
    }
    [_molecule say:_session->spoken()];
    self.view.window.windowScene.title = toNSString(_session->viewer().title());
    return next;
}

// --- user actions

- (void)moleculeViewTouched:(MoleculeView*)view {
    [_clock wake];
}

/// The keyboard, for a field of the panel.
- (void)askFor:(NSString*)name text:(NSString*)text {
    __weak MoleculeController* weakSelf = self;
    ask(name, text, self, ^(NSString* typed) {
      MoleculeController* controller = weakSelf;
      if (!controller) return;
      controller->_session->typed(toString(name), toString(typed));
      [controller->_clock wake];
    });
}

/// Shaking undoes, as everywhere on this system.
- (void)motionEnded:(UIEventSubtype)motion withEvent:(nullable UIEvent*)event {
    if (motion == UIEventSubtypeMotionShake) [_molecule run:ViewerCommand::undo];
}

- (void)share:(NSData*)data name:(const std::string&)name {
    if (data) share(data, toNSString(name), self, _molecule);
}

// --- documents

- (void)pickDocument {
    UIDocumentPickerViewController* picker =
        [[UIDocumentPickerViewController alloc] initForOpeningContentTypes:@[ UTTypeData ]];
    picker.delegate = self;
    [self presentViewController:picker animated:YES completion:nil];
}

- (void)documentPicker:(UIDocumentPickerViewController*)picker didPickDocumentsAtURLs:(NSArray<NSURL*>*)urls {
    NSURL* first = urls.firstObject;
    if (first) [self openDocument:first];
}

- (void)openDocument:(NSURL*)url {
    [self loadViewIfNeeded];
    _document = [[DocumentAccess alloc] initWithURL:url];
    const std::string path = toString(url.path);
    if ([url.lastPathComponent.lowercaseString hasSuffix:@".view.json"]) return [self openView:path];
    _session->open(path);
    [_clock wake];
}

/// Opens a saved view: starts another session with it.
- (void)openView:(const std::string&)path {
    [self attempt:^{
      [self startSession:parseSavedView(readDocument(path), path)];
      self->_document = nil;
      [self moleculeViewResized:self->_molecule];
    }];
}

- (NSDictionary*)state {
    [self loadViewIfNeeded];
    NSMutableDictionary* state = [NSMutableDictionary dictionary];
    state[kView] = toNSString(_session->state());
    state[kBookmark] = _document.bookmark;
    return state;
}

// --- life

- (void)enterForeground {
    _background = NO;
    [self moleculeViewResized:_molecule];
}

- (void)enterBackground {
    _background = YES;
    _clock.suspended = YES;
    if (!_session) return;
    _session->setSeen(false);
    // Metal rejects work after this method has returned, and MoltenVK then reports a lost device.
    _session->awaitSubmitted(kBackgroundPatience);
}

- (void)didReceiveMemoryWarning {
    [super didReceiveMemoryWarning];
    if (_session) _session->lowMemory();
}

@end
