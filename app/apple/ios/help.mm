#include "app/apple/ios/help.h"

#include "app/apple/ios/document_access.h"
#include "app/shared/notices.h"
#include "app/viewer/commands.h"

namespace nacre::app {

NSString* helpText() {
    std::string text;
    for (const PointerBinding& binding : pointerBindings())
        text += std::string(binding.touch) + ": " + binding.what + "\n";
    text += "\nWith a keyboard\n";
    for (const Binding& binding : keyBindings())
        if (binding.listed && binding.command != ViewerCommand::panel && binding.command != ViewerCommand::quit)
            text += std::string(binding.keys) + ": " + binding.what + "\n";
    return stringOf(text);
}

void showNotices(UIViewController* over) {
    UITextView* text = [[UITextView alloc] init];
    text.editable = NO;
    text.font = [UIFont preferredFontForTextStyle:UIFontTextStyleFootnote];
    text.adjustsFontForContentSizeCategory = YES;
    text.text = stringOf(notices());
    UIViewController* page = [[UIViewController alloc] init];
    page.view = text;
    [over presentViewController:page animated:YES completion:nil];
}

}  // namespace nacre::app
