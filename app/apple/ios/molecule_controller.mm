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
    _molecule.autoresizingMask = UIViewAutoresizingFlexibleWidth | UIViewAutoresizingFlexibleHeight;
    [self.view addSubview:_molecule];
    _molecule.delegate = self;
    _molecule.speaker = self;
    __weak MoleculeController* weakSelf = self;
    _clock = [[FrameClock alloc] initWithStep:[weakSelf](double now, double interval) {
        MoleculeController* controller = weakSelf;
        return controller ? [controller step:now interval:interval] : std::numeric_limits<double>::infinity();
    }];
}

- (void)viewDidAppear:(BOOL)animated {
    [super viewDidAppear:animated];
    [_molecule becomeFirstResponder];  // for the keys of a keyboard
}

/// The view has its size: the device can be opened.
- (void)moleculeViewResized:(MoleculeView*)view {
    if (!_session && !_background && view.pixels.width > 0) [self startSession];
    if (!_session) return;
    _session->resize(view.pixels, view.contentScaleFactor, CACurrentMediaTime());
    const UIEdgeInsets safe = view.safeAreaInsets;
    const auto pixels = [&](CGFloat points) { return static_cast<float>(points * view.contentScaleFactor); };
    _session->setInsets({pixels(safe.left), pixels(safe.top), pixels(safe.right), pixels(safe.bottom)});
    [_clock wake];
}

- (void)startSession {
    nacre::app::setHttpFetch(nacre::app::fetchBySystem);
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
    host.pickDocument = [weakSelf] { [weakSelf pickDocument]; };
    host.share = [weakSelf](ViewerCommand what) {
        what == ViewerCommand::saveView ? [weakSelf shareView] : [weakSelf sharePicture];
    };
    host.askText = [weakSelf](const std::string& name, const std::string& text) {
        [weakSelf askFor:stringOf(name) text:stringOf(text)];
    };
    host.downloads = true;
    host.dark = self.traitCollection.userInterfaceStyle == UIUserInterfaceStyleDark;
    [self attempt:^{
      self->_session = std::make_unique<MoleculeSession>(host, self->_first);
      self->_molecule.session = self->_session.get();
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
    [_molecule say:_session->spoken()];
    self.view.window.windowScene.title = stringOf(_session->viewer().title());
    return next;
}

// --- what the user does

- (void)moleculeViewTouched:(MoleculeView*)view {
    [_clock wake];
}

- (void)moleculeView:(MoleculeView*)view command:(ViewerCommand)command {
    if (_session) _session->run(command, CACurrentMediaTime());
    [_clock wake];
}

/// The keyboard, for a field of the panel.
- (void)askFor:(NSString*)name text:(NSString*)text {
    __weak MoleculeController* weakSelf = self;
    ask(name, text, self, ^(NSString* typed) {
      MoleculeController* controller = weakSelf;
      if (!controller || !controller->_session) return;
      controller->_session->typed(textOf(name), textOf(typed));
      [controller wake];
    });
}

/// As everywhere on this system.
- (void)motionEnded:(UIEventSubtype)motion withEvent:(nullable UIEvent*)event {
    if (motion == UIEventSubtypeMotionShake) [self moleculeView:_molecule command:ViewerCommand::undo];
}

- (void)sharePicture {
    if (!_session || !_session->viewer().document()) return;
    [self attempt:^{
      NSData* png = pngOf(self->_session->picture());
      NSString* name = [stringOf(self->_session->shareName()) stringByAppendingString:@".png"];
      if (png) share(png, name, self, self->_molecule);
    }];
}

- (void)shareView {
    if (!_session) return;
    NSData* json = [stringOf(_session->state()) dataUsingEncoding:NSUTF8StringEncoding];
    share(json, [stringOf(_session->shareName()) stringByAppendingString:@".view.json"], self, _molecule);
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
      self->_molecule.session = nullptr;
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

- (void)spokenView:(SpokenMoleculeView*)view press:(const nacre::app::Control&)control {
    if (_session) _session->press(control.role, control.name, CACurrentMediaTime());
    [_clock wake];
}

- (void)spokenView:(SpokenMoleculeView*)view adjust:(const nacre::app::Control&)control up:(BOOL)up {
    if (_session) _session->adjust(control.name, up, CACurrentMediaTime());
    [_clock wake];
}

@end
