#import "app/apple/ios/molecule_controller.h"

#import <QuartzCore/QuartzCore.h>
#import <UniformTypeIdentifiers/UniformTypeIdentifiers.h>

#include <limits>
#include <memory>

#import "app/apple/ios/document_access.h"
#import "app/apple/ios/frame_clock.h"
#import "app/apple/ios/help.h"
#import "app/apple/ios/menus.h"
#import "app/apple/ios/metal_surface.h"
#import "app/apple/ios/molecule_view.h"
#import "app/apple/ios/overlay_view.h"
#import "app/apple/ios/sharing.h"
#import "app/apple/ios/spoken.h"
#import "app/apple/session.h"
#import "app/shared/option_values.h"
#import "engine/error.h"

using namespace nacre::app;

namespace {

NSString* const kView = @"view";          // of the state: JSON
NSString* const kBookmark = @"bookmark";  // of the state: the right to the file

NSURL* _Nullable cachedFile(NSString* name) { return [folderOf(NSCachesDirectory) URLByAppendingPathComponent:name]; }

std::vector<std::byte> loadPipelines() {
    NSURL* file = cachedFile(@"pipelines.bin");
    NSData* data = file ? [NSData dataWithContentsOfURL:file options:0 error:nil] : nil;
    const auto* bytes = static_cast<const std::byte*>(data.bytes);
    return data ? std::vector<std::byte>(bytes, bytes + data.length) : std::vector<std::byte>();
}

void savePipelines(const std::vector<std::byte>& bytes) {
    NSURL* file = cachedFile(@"pipelines.bin");
    NSData* data = [NSData dataWithBytes:bytes.data() length:bytes.size()];
    if (file) [data writeToURL:file options:NSDataWritingAtomic error:nil];
}

}  // namespace

@interface MoleculeController () <MoleculeViewDelegate, SpokenViewDelegate, UIDocumentPickerDelegate>
@end

@implementation MoleculeController {
    std::unique_ptr<MoleculeSession> _session;
    SavedView _first;
    DocumentAccess* _document;
    SpokenMoleculeView* _molecule;
    OverlayView* _overlay;
    UIButton* _menuButton;
    FrameClock* _clock;
    BOOL _background;
}

- (instancetype)initWithState:(nullable NSDictionary*)state {
    if ((self = [super initWithNibName:nil bundle:nil])) {
        NSString* json = state[kView];
        NSData* bookmark = state[kBookmark];
        if (json) [self restore:textOf(json)];
        if (bookmark) _document = [DocumentAccess accessWithBookmark:bookmark];
        if (_document) _first.input = textOf(_document.url.path);  // it may have moved
        if (_first.input.empty()) _first.input = "sample:dna";
    }
    return self;
}

/// A state that cannot be read counts as absent.
- (void)restore:(const std::string&)json {
    try {
        _first = parseSavedView(json, "the last view");
    } catch (const nacre::Error&) {
        _first = {};
    }
}

- (void)dealloc {
    [_clock stop];
}

// --- views

- (void)viewDidLoad {
    [super viewDidLoad];
    _molecule = [[SpokenMoleculeView alloc] initWithFrame:self.view.bounds];
    _overlay = [[OverlayView alloc] initWithFrame:self.view.bounds];
    for (UIView* view in @[ _molecule, _overlay ]) {
        view.autoresizingMask = UIViewAutoresizingFlexibleWidth | UIViewAutoresizingFlexibleHeight;
        [self.view addSubview:view];
    }
    _molecule.delegate = self;
    _molecule.speaker = self;
    __weak MoleculeController* weakSelf = self;
    _clock = [[FrameClock alloc] initWithStep:[weakSelf](double now, double interval) {
        MoleculeController* controller = weakSelf;
        return controller ? [controller step:now interval:interval] : std::numeric_limits<double>::infinity();
    }];
    [self addMenuButton];
}

- (void)viewDidAppear:(BOOL)animated {
    [super viewDidAppear:animated];
    [_molecule becomeFirstResponder];  // for the keys of a keyboard
}

- (void)addMenuButton {
    _menuButton = [UIButton buttonWithType:UIButtonTypeSystem];
    [_menuButton setImage:[UIImage systemImageNamed:@"ellipsis.circle"] forState:UIControlStateNormal];
    _menuButton.accessibilityLabel = @"Menu";
    _menuButton.showsMenuAsPrimaryAction = YES;
    __weak MoleculeController* weakSelf = self;
    UIDeferredMenuElement* fresh =
        [UIDeferredMenuElement elementWithUncachedProvider:^(void (^completion)(NSArray<UIMenuElement*>*)) {
          completion([weakSelf menu]);
        }];
    _menuButton.menu = [UIMenu menuWithTitle:@"" image:nil identifier:nil options:0 children:@[ fresh ]];
    _menuButton.translatesAutoresizingMaskIntoConstraints = NO;
    [self.view addSubview:_menuButton];
    UILayoutGuide* safe = self.view.safeAreaLayoutGuide;
    [NSLayoutConstraint activateConstraints:@[
        [_menuButton.trailingAnchor constraintEqualToAnchor:safe.trailingAnchor constant:-8],
        [_menuButton.topAnchor constraintEqualToAnchor:safe.topAnchor constant:8],
        [_menuButton.widthAnchor constraintEqualToConstant:48],
        [_menuButton.heightAnchor constraintEqualToConstant:48],
    ]];
}

/// The view has its size: the device can be opened.
- (void)moleculeViewResized:(MoleculeView*)view {
    if (!_session && !_background && view.pixels.width > 0) [self startSession];
    if (!_session) return;
    _session->resize(view.pixels, view.contentScaleFactor, CACurrentMediaTime());
    [_clock wake];
}

- (void)startSession {
    __weak MoleculeController* weakSelf = self;
    MoleculeHost host;
    host.surface = surfaceOf(_molecule.metalLayer);
    host.readFile = readDocument;
    host.wake = [weakSelf] {
        dispatch_async(dispatch_get_main_queue(), ^{
          [weakSelf wake];
        });
    };
    host.loadPipelines = loadPipelines;
    host.keepPipelines = savePipelines;
    host.occlusionCache = textOf(cachedFile(@"occlusion").path);
    [self attempt:^{
      self->_session = std::make_unique<MoleculeSession>(host, self->_first);
      self->_molecule.viewer = &self->_session->viewer();
      self->_clock.suspended = NO;
    }];
}

/// Runs what may throw, and says what went wrong.
- (BOOL)attempt:(dispatch_block_t)what {
    try {
        what();
        return YES;
    } catch (const std::exception& error) {
        tell(@"Nacre", stringOf(error.what()), self);
        return NO;
    }
}

- (void)wake {
    [_clock wake];
}

- (double)step:(double)now interval:(double)interval {
    __block double next = std::numeric_limits<double>::infinity();
    if (!_session) return next;
    _session->viewer().setDisplayInterval(interval);
    const BOOL drawn = [self attempt:^{
      next = self->_session->step(now);
    }];
    if (!drawn) {
        _clock.suspended = YES;  // it would fail again with the next frame
        return next;
    }
    const Viewer& viewer = _session->viewer();
    const BOOL more = UIAccessibilityDarkerSystemColorsEnabled() || UIAccessibilityIsReduceTransparencyEnabled();
    const LabelColors colors = labelColors(viewer.settings().background, more);
    [_overlay show:viewer.annotations() colors:colors];
    _menuButton.tintColor = colorOf(colors.bare);
    [_molecule say:stringOf(viewer.title()) value:stringOf(spokenValue(viewer.annotations()))];
    self.view.window.windowScene.title = stringOf(viewer.title());
    return next;
}

// --- what the user does

- (void)moleculeViewTouched:(MoleculeView*)view {
    [_clock wake];
}

- (void)moleculeView:(MoleculeView*)view command:(ViewerCommand)command {
    switch (command) {
        case ViewerCommand::savePicture:
            return [self sharePicture];
        case ViewerCommand::saveView:
            return [self shareView];
        case ViewerCommand::help:
            return tell(@"Help", helpText(), self);
        default:
            if (_session) _session->viewer().run(command, CACurrentMediaTime());
            [_clock wake];
    }
}

- (NSArray<UIMenuElement*>*)menu {
    if (!_session) return @[];
    __weak MoleculeController* weakSelf = self;
    const auto item = [weakSelf](const char* title, const char* symbol, void (^chosen)(MoleculeController*)) {
        return MenuItem{title, symbol, false, [weakSelf, chosen] {
                            if (MoleculeController* controller = weakSelf) chosen(controller);
                        }};
    };
    const auto sample = [&](const char* title, const char* input) {
        return item(title, "", ^(MoleculeController* controller) {
          [controller openSample:input];
        });
    };
    std::vector<MenuItem> items = {item("Open ...", "folder", ^(MoleculeController* controller) {
      [controller pickDocument];
    })};
    MenuItem samples{"Samples", "testtube.2"};
    samples.children = {sample("DNA", "sample:dna"), sample("Glucose", "sample:glucose"),
                        sample("Buckyball", "sample:buckyball")};
    items.push_back(std::move(samples));
    for (MenuItem& look : viewMenu(_session->viewer(), CACurrentMediaTime)) items.push_back(std::move(look));
    items.push_back(item("Share picture", "square.and.arrow.up", ^(MoleculeController* controller) {
      [controller sharePicture];
    }));
    items.push_back(item("Share view", "square.and.arrow.up.on.square", ^(MoleculeController* controller) {
      [controller shareView];
    }));
    items.push_back(item("Help", "questionmark.circle", ^(MoleculeController* controller) {
      tell(@"Help", helpText(), controller);
    }));
    items.push_back(item("Licences", "doc.text", ^(MoleculeController* controller) {
      showNotices(controller);
    }));
    return menuElements(items, ^{
      [weakSelf wake];
    });
}

- (void)sharePicture {
    if (!_session || !_session->viewer().document()) return;
    [self attempt:^{
      NSData* png = pngOf(self->_session->picture());
      NSString* name = [stringOf(self->_session->shareName()) stringByAppendingString:@".png"];
      if (png) share(png, name, self, self->_menuButton);
    }];
}

- (void)shareView {
    if (!_session) return;
    NSData* json = [stringOf(_session->state()) dataUsingEncoding:NSUTF8StringEncoding];
    share(json, [stringOf(_session->shareName()) stringByAppendingString:@".view.json"], self, _menuButton);
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
    _document = [[DocumentAccess alloc] initWithURL:url];
    const std::string path = textOf(url.path);
    if ([url.lastPathComponent.lowercaseString hasSuffix:@".view.json"]) return [self openView:path];
    [self open:path];
}

/// A saved view: another session, which starts with it.
- (void)openView:(const std::string&)path {
    [self attempt:^{
      self->_first = parseSavedView(readDocument(path), path);
      self->_document = nil;
      self->_molecule.viewer = nullptr;
      self->_session.reset();
      if (self.viewIfLoaded) [self moleculeViewResized:self->_molecule];
    }];
}

- (void)openSample:(const std::string&)input {
    _document = nil;
    [self open:input];
}

- (void)open:(const std::string&)input {
    if (_session) {
        _session->viewer().open(input, CACurrentMediaTime());
        [_clock wake];
    } else {
        _first = {};
        _first.input = input;
    }
}

- (NSDictionary*)state {
    NSMutableDictionary* state = [NSMutableDictionary dictionary];
    state[kView] = stringOf(_session ? _session->state() : savedViewJson(_first));
    state[kBookmark] = _document.bookmark;
    return state;
}

// --- life

- (void)enterForeground {
    _background = NO;
    if (!_session) return [_molecule setNeedsLayout];
    [self attempt:^{
      self->_session->enterForeground(CACurrentMediaTime());
      self->_clock.suspended = NO;
    }];
}

- (void)enterBackground {
    _background = YES;
    _clock.suspended = YES;
    if (_session) _session->enterBackground();
}

- (void)didReceiveMemoryWarning {
    [super didReceiveMemoryWarning];
    if (_session) _session->lowMemory();
}

// --- what a screen reader asks for

- (void)spokenView:(SpokenMoleculeView*)view command:(ViewerCommand)command {
    [self moleculeView:view command:command];
}

@end
