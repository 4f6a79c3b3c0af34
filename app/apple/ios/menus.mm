#include "app/apple/ios/menus.h"

#include "app/apple/ios/document_access.h"

namespace nacre::app {
namespace {

UIMenuElement* elementOf(const MenuItem& item, dispatch_block_t chosen) {
    NSString* title = stringOf(item.title);
    UIImage* image = item.symbol.empty() ? nil : [UIImage systemImageNamed:stringOf(item.symbol)];
    if (!item.choose)
        return [UIMenu menuWithTitle:title
                               image:image
                          identifier:nil
                             options:0
                            children:menuElements(item.children, chosen)];
    const std::function<void()> choose = item.choose;
    UIAction* action = [UIAction actionWithTitle:title
                                           image:image
                                      identifier:nil
                                         handler:^(UIAction*) {
                                           choose();
                                           chosen();
                                         }];
    action.state = item.checked ? UIMenuElementStateOn : UIMenuElementStateOff;
    return action;
}

}  // namespace

NSArray<UIMenuElement*>* menuElements(const std::vector<MenuItem>& items, dispatch_block_t chosen) {
    NSMutableArray<UIMenuElement*>* elements = [NSMutableArray array];
    for (const MenuItem& item : items) [elements addObject:elementOf(item, chosen)];
    return elements;
}

}  // namespace nacre::app
