package org.nacre.viewer;

import android.annotation.TargetApi;
import android.app.AlertDialog;
import android.app.NativeActivity;
import android.content.ActivityNotFoundException;
import android.content.ClipData;
import android.content.ClipboardManager;
import android.content.Intent;
import android.content.res.Configuration;
import android.graphics.Bitmap;
import android.graphics.Insets;
import android.hardware.display.DisplayManager;
import android.net.Uri;
import android.os.Build;
import android.os.Bundle;
import android.view.Choreographer;
import android.view.Display;
import android.view.View;
import android.view.WindowInsets;
import android.view.WindowManager;
import android.widget.EditText;
import android.window.OnBackInvokedCallback;
import android.window.OnBackInvokedDispatcher;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.URL;
import java.nio.charset.StandardCharsets;

/**
 * System functions for native code: picks documents, asks for text, shares pictures, describes controls to screen readers,
 * and reports the display and system bars.
 */
public final class NacreActivity extends NativeActivity
        implements DisplayManager.DisplayListener, Choreographer.FrameCallback {
    private static final int PICKED = 1, PATIENCE = 30_000; // milliseconds
    private PanelNodes nodes;
    private Back back; // registered while the app handles Back
    private boolean animated, awaited;

    // Native code registers these when the activity is created. `app` is the value from attach(); 0: the app has ended.
    static native void opened(long app, Uri document);
    static native void failed(long app, String why);
    static native String controls(long app);
    static native void press(long app, String role, String name);
    static native void adjust(long app, String name, boolean up);
    static native void back(long app);
    static native void insets(long app, int left, int top, int right, int bottom);
    static native void textScale(long app, float scale);
    static native void refreshes(long app, float rate, float most);
    static native void tick(long app, long nanoseconds);
    static native void trim(long app, int level);
    static native void typed(long app, String name, String text);
    static native boolean received(long transfer, byte[] bytes, int count, long all);

    private volatile long app;

    @Override
    protected void onCreate(Bundle state) {
        super.onCreate(state);
        View content = getWindow().getDecorView().findViewById(android.R.id.content);
        nodes = new PanelNodes(this, content);
        content.setOnApplyWindowInsetsListener((view, insets) -> {
            tellInsets(insets);
            return view.onApplyWindowInsets(insets);
        });
        displays().registerDisplayListener(this, null);
        onDisplayChanged(display().getDisplayId());
        tellTextScale(getResources().getConfiguration());
    }

    /** Opens another document in this activity: there is only one instance. */
    @Override
    protected void onNewIntent(Intent intent) {
        super.onNewIntent(intent);
        setIntent(intent);
        Uri document = documentOf(intent);
        if (app != 0 && document != null) opened(app, document);
    }

    /** The document that another app opens with or shares to this one; null: none. */
    private static Uri documentOf(Intent intent) {
        if (intent.getData() != null) return intent.getData();
        Object shared = intent.getParcelableExtra(Intent.EXTRA_STREAM);
        return shared instanceof Uri ? (Uri) shared : null;
    }

    /** Called if the window is hidden or memory is low. From API level 34 on, onLowMemory is not called. */
    @Override
    public void onTrimMemory(int level) {
        super.onTrimMemory(level);
        if (app != 0) trim(app, level);
    }

    @Override
    protected void onDestroy() {
        displays().unregisterDisplayListener(this);
        super.onDestroy();
    }

    long app() {
        return app;
    }

    // --- Back, while something covers the picture. Up to Android 12 it is a key.

    /** A separate class, which older systems do not load. */
    @TargetApi(33)
    private static final class Back implements OnBackInvokedCallback {
        private final NacreActivity activity;

        Back(NacreActivity activity) {
            this.activity = activity;
            activity.getOnBackInvokedDispatcher().registerOnBackInvokedCallback(
                    OnBackInvokedDispatcher.PRIORITY_DEFAULT, this);
        }

        void end() {
            activity.getOnBackInvokedDispatcher().unregisterOnBackInvokedCallback(this);
        }

        @Override
        public void onBackInvoked() {
            if (activity.app != 0) back(activity.app);
        }
    }

    // --- the window, partly covered by system bars, and the text size

    private void tellInsets(WindowInsets insets) {
        if (app == 0) return;
        if (Build.VERSION.SDK_INT < 30) {
            insets(app, insets.getSystemWindowInsetLeft(), insets.getSystemWindowInsetTop(),
                    insets.getSystemWindowInsetRight(), insets.getSystemWindowInsetBottom());
            return;
        }
        Insets covered = insets.getInsets(WindowInsets.Type.systemBars() | WindowInsets.Type.displayCutout()
                | WindowInsets.Type.systemGestures());
        insets(app, covered.left, covered.top, covered.right, covered.bottom);
    }

    private void tellTextScale(Configuration configuration) {
        if (app != 0) textScale(app, configuration.fontScale);
    }

    @Override
    public void onConfigurationChanged(Configuration configuration) {
        super.onConfigurationChanged(configuration);
        tellTextScale(configuration);
    }

    // --- the display, which may change its rate at any time

    private DisplayManager displays() {
        return getSystemService(DisplayManager.class);
    }

    private Display display() {
        Display own = Build.VERSION.SDK_INT < 30 ? null : getDisplay();
        return own != null ? own : displays().getDisplay(Display.DEFAULT_DISPLAY);
    }

    /** Reports the current refresh rate, and the highest one at this resolution. */
    @Override
    public void onDisplayChanged(int id) {
        Display display = display();
        if (app == 0 || display == null || id != display.getDisplayId()) return;
        Display.Mode now = display.getMode();
        float most = now.getRefreshRate();
        for (Display.Mode mode : display.getSupportedModes())
            if (mode.getPhysicalWidth() == now.getPhysicalWidth() && mode.getPhysicalHeight() == now.getPhysicalHeight())
                most = Math.max(most, mode.getRefreshRate());
        refreshes(app, display.getRefreshRate(), most);
    }

    @Override
    public void onDisplayAdded(int id) {}

    @Override
    public void onDisplayRemoved(int id) {}

    // --- called by native code, on any thread

    void attach(long to) {
        app = to;
    }

    String system() {
        return "Android " + Build.VERSION.RELEASE + " (" + Build.VERSION.SDK_INT + "), " + Build.MANUFACTURER + " " + Build.MODEL;
    }

    void wantsBack(boolean wanted) {
        runOnUiThread(() -> {
            if (Build.VERSION.SDK_INT < 33 || wanted == (back != null)) return;
            if (!wanted) back.end();
            back = wanted ? new Back(this) : null;
        });
    }

    /** Starts or stops calls of tick() for each frame of the display. */
    void animate(boolean on) {
        runOnUiThread(() -> {
            animated = on;
            await();
        });
    }

    private void await() {
        if (awaited || !animated || app == 0) return;
        awaited = true;
        Choreographer.getInstance().postFrameCallback(this);
    }

    @Override
    public void doFrame(long nanoseconds) {
        awaited = false;
        if (animated && app != 0) tick(app, nanoseconds);
        await();
    }

    void copyText(String text) {
        runOnUiThread(() -> getSystemService(ClipboardManager.class).setPrimaryClip(ClipData.newPlainText("Nacre", text)));
    }

    /** Shows why nothing can be drawn, and ends the activity when the dialog is closed. */
    void giveUp(String why) {
        runOnUiThread(() -> {
            if (isFinishing() || isDestroyed()) return;
            new AlertDialog.Builder(this).setTitle("Nacre cannot draw here").setMessage(why)
                    .setPositiveButton(android.R.string.ok, null).setOnDismissListener(it -> finish()).show();
        });
    }

    /** Handles explore by touch. Pixels of the window. On the main thread. */
    void explore(float x, float y, boolean inside) {
        if (nodes != null) nodes.explore(x, y, inside);
    }

    void pickDocument() {
        runOnUiThread(() -> {
            Intent pick = new Intent(Intent.ACTION_OPEN_DOCUMENT);
            pick.addCategory(Intent.CATEGORY_OPENABLE);
            pick.setType("*/*");
            try {
                startActivityForResult(pick, PICKED);
            } catch (ActivityNotFoundException none) {
                if (app != 0) failed(app, "no app on this device can open documents");
            }
        });
    }

    /** Downloads an address, and passes the data to native code until that has enough. Called on a native thread. */
    void fetch(String url, long transfer) throws IOException {
        HttpURLConnection connection = (HttpURLConnection) new URL(url).openConnection();
        try {
            connection.setConnectTimeout(PATIENCE);
            connection.setReadTimeout(PATIENCE);
            connection.setRequestProperty("Accept-Encoding", "identity");
            int code = connection.getResponseCode();
            if (code == HttpURLConnection.HTTP_NOT_FOUND) throw new IOException("there is no such entry (404)");
            if (code != HttpURLConnection.HTTP_OK) throw new IOException("the server answers " + code);
            long all = connection.getContentLengthLong();
            InputStream in = connection.getInputStream();
            byte[] part = new byte[1 << 16];
            for (int count = in.read(part); count >= 0; count = in.read(part))
                if (!received(transfer, part, count, all)) return;
        } finally {
            connection.disconnect();
        }
    }

    /** Asks for a line of text in a dialog, for a field that native code draws. */
    void askText(String name, String text) {
        runOnUiThread(() -> {
            EditText field = new EditText(this);
            field.setSingleLine();
            field.setText(text);
            field.setSelection(text.length());
            AlertDialog dialog = new AlertDialog.Builder(this).setTitle(name).setView(field)
                    .setPositiveButton(android.R.string.ok, (it, which) -> {
                        if (app != 0) typed(app, name, field.getText().toString());
                    }).setNegativeButton(android.R.string.cancel, null).create();
            dialog.getWindow().setSoftInputMode(WindowManager.LayoutParams.SOFT_INPUT_STATE_ALWAYS_VISIBLE);
            dialog.show();
            field.requestFocus();
        });
    }

    /** Colours as 0xAARRGGBB, rows from the top. */
    void sharePicture(int[] pixels, int width, int height, String name) {
        Bitmap bitmap = Bitmap.createBitmap(pixels, width, height, Bitmap.Config.ARGB_8888);
        share(name, out -> bitmap.compress(Bitmap.CompressFormat.PNG, 100, out));
    }

    void shareText(String text, String name) {
        share(name, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private interface Content {
        void write(OutputStream out) throws IOException;
    }

    private void share(String name, Content content) {
        try {
            File folder = SharedPictures.folder(this);
            File[] before = folder.listFiles();
            if (before != null) for (File file : before) file.delete();
            try (OutputStream out = new FileOutputStream(new File(folder, name))) {
                content.write(out);
            }
            Intent send = new Intent(Intent.ACTION_SEND);
            send.setType(SharedPictures.typeOf(name));
            send.putExtra(Intent.EXTRA_STREAM, SharedPictures.uriOf(this, name));
            send.addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION);
            runOnUiThread(() -> startActivity(Intent.createChooser(send, null)));
        } catch (IOException | RuntimeException error) {
            if (app != 0) failed(app, "cannot share " + name + ": " + error.getMessage());
        }
    }

    void controlsChanged() {
        runOnUiThread(() -> {
            if (nodes != null) nodes.changed();
        });
    }

    // --- results

    @Override
    protected void onActivityResult(int request, int result, Intent data) {
        super.onActivityResult(request, result, data);
        boolean chosen = request == PICKED && result == RESULT_OK && data != null && data.getData() != null;
        if (chosen && app != 0) opened(app, data.getData());
    }
}
