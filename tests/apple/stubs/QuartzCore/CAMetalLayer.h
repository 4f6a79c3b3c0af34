#pragma once
#import <QuartzCore/QuartzCore.h>
