// The Android app: `./gradlew assembleRelease` in this folder, with VCPKG_ROOT set (see third_party/README.md).
// `./gradlew assembleDebug -PvalidationLayers=FOLDER` also packs Khronos' validation layer: FOLDER is the unpacked
// android-binaries-*.zip of github.com/KhronosGroup/Vulkan-ValidationLayers, with a folder for each ABI.
plugins {
    id("com.android.application") version "8.10.1"
}

val vcpkg = System.getenv("VCPKG_ROOT") ?: throw GradleException("VCPKG_ROOT names no vcpkg: see third_party/README.md")
val validationLayers = providers.gradleProperty("validationLayers")

android {
    namespace = "org.nacre.viewer"
    compileSdk = 36
    ndkVersion = "29.0.14206865"

    defaultConfig {
        applicationId = "org.nacre.viewer"
        // The first level with strtod_l, which parses numbers.
        minSdk = 26
        targetSdk = 36
        versionCode = 1
        versionName = "0.1.0"
        ndk {
            abiFilters += listOf("arm64-v8a", "x86_64")
        }
        externalNativeBuild {
            cmake {
                targets += "nacre_android"
                arguments += listOf(
                    "-DANDROID_STL=c++_static",
                    "-DCMAKE_TOOLCHAIN_FILE=${projectDir}/toolchain.cmake",
                    "-DNACRE_VCPKG_ROOT=${vcpkg}",
                    "-DVCPKG_MANIFEST_DIR=${projectDir}/../../third_party",
                    "-DNACRE_TESTS=OFF",
                )
            }
        }
    }
    externalNativeBuild {
        cmake {
            path = file("../../CMakeLists.txt")
            version = "3.25.0+"
        }
    }
    packaging {
        jniLibs {
            useLegacyPackaging = false  // libraries are stored aligned, and mapped from the APK
        }
    }
    sourceSets {
        getByName("debug") {
            validationLayers.orNull?.let { jniLibs.srcDir(it) }
        }
    }
    buildTypes {
        release {
            isMinifyEnabled = false  // native code calls the few Java classes by name
        }
    }
}
