package org.nacre.viewer;

import android.content.ContentProvider;
import android.content.ContentValues;
import android.content.Context;
import android.database.Cursor;
import android.database.MatrixCursor;
import android.net.Uri;
import android.os.ParcelFileDescriptor;

import java.io.File;
import java.io.FileNotFoundException;

/** Gives a shared picture or view to the app that the user chose, and nothing else. */
public final class SharedPictures extends ContentProvider {
    static String typeOf(String name) {
        return name.endsWith(".png") ? "image/png" : "application/json";
    }

    static File folder(Context context) {
        File folder = new File(context.getCacheDir(), "shared");
        folder.mkdirs();
        return folder;
    }

    static Uri uriOf(Context context, String name) {
        return new Uri.Builder().scheme("content").authority(context.getPackageName() + ".pictures").appendPath(name)
                .build();
    }

    /** The file of this name in the folder; other paths are refused. */
    private File fileOf(Uri uri) throws FileNotFoundException {
        String name = uri.getLastPathSegment();
        File file = name == null || name.contains("/") || name.startsWith(".") ? null : new File(folder(getContext()), name);
        if (file == null || !file.isFile()) throw new FileNotFoundException(String.valueOf(uri));
        return file;
    }

    @Override
    public boolean onCreate() {
        return true;
    }

    @Override
    public String getType(Uri uri) {
        return typeOf(String.valueOf(uri.getLastPathSegment()));
    }

    @Override
    public ParcelFileDescriptor openFile(Uri uri, String mode) throws FileNotFoundException {
        if (!"r".equals(mode)) throw new FileNotFoundException("it is read-only");
        return ParcelFileDescriptor.open(fileOf(uri), ParcelFileDescriptor.MODE_READ_ONLY);
    }

    @Override
    public Cursor query(Uri uri, String[] columns, String selection, String[] arguments, String order) {
        MatrixCursor cursor = new MatrixCursor(new String[] {"_display_name", "_size"}, 1);
        try {
            File file = fileOf(uri);
            cursor.addRow(new Object[] {file.getName(), file.length()});
        } catch (FileNotFoundException none) {
            // An empty answer reports it.
        }
        return cursor;
    }

    @Override
    public Uri insert(Uri uri, ContentValues values) {
        return null;
    }

    @Override
    public int delete(Uri uri, String selection, String[] arguments) {
        return 0;
    }

    @Override
    public int update(Uri uri, ContentValues values, String selection, String[] arguments) {
        return 0;
    }
}
