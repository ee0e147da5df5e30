using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Engraver.App.Binding;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Settings;

namespace Engraver.App.FileDialogs;

/// <summary>The preview beside the list. It is created in the background when the selection has been unchanged for a moment, within a time limit, and
/// cancelled when the selection changes.</summary>
public sealed class PreviewModel(DesktopModel desk) : ObservableObject
{
    /// <summary>Delay, so that moving quickly through a list does not preview every file.</summary>
    internal static readonly TimeSpan Delay = TimeSpan.FromMilliseconds(120);

    internal static readonly TimeSpan Timeout = TimeSpan.FromSeconds(3);

    /// <summary>Pixels of a picture; it is shown at this size or smaller.</summary>
    private static readonly PixelSize s_size = new(400, 300);

    private Action? _stopMaking;
    private FileRow? _file;

    /// <summary>The picture of the drawing; null while there is none.</summary>
    public Bitmap? Picture { get; private set; }

    /// <summary>The first lines of a text.</summary>
    public string Lines { get; private set; } = "";

    public string Caption { get; private set; } = "";

    /// <summary>Reads and draws a file until it is cancelled.</summary>
    internal Func<FileRow, DrawingSettings, CanvasTheme, PixelSize, CancellationToken, FilePreview> PreviewFactory { get; set; } = FilePreview.Create;

    /// <param name="file">Null, or a folder: no preview.</param>
    public void Show(FileRow? file)
    {
        if (file == _file) return;
        _file = file;
        _stopMaking?.Invoke();
        _stopMaking = null;
        Apply(null, "", "");
        if (file is { IsFolder: false }) _ = MakeAsync(file);
    }

    private async Task MakeAsync(FileRow file)
    {
        using var making = new CancellationTokenSource();
        Action stopMaking = making.Cancel;
        _stopMaking = stopMaking;
        try
        {
            await Task.Delay(Delay, desk.Time, making.Token);
            var preview = await CreateAsync(file, making.Token);
            if (_stopMaking == stopMaking) Apply(preview.Picture is { } picture ? BitmapOf(picture) : null, preview.Lines, preview.Caption);
        }
        catch (OperationCanceledException)
        {
            if (_stopMaking == stopMaking) Apply(null, "", Text.Get("Files.PreviewTooSlow")); // otherwise another file was selected
        }
        finally
        {
            if (_stopMaking == stopMaking) _stopMaking = null;
        }
    }

    private async Task<FilePreview> CreateAsync(FileRow file, CancellationToken movedOn)
    {
        var theme = CanvasTheme.Of(desk.Session.View.Current.Theme);
        var settings = desk.Session.Document.Current.SettingsOfNext;
        using var limit = new CancellationTokenSource(Timeout, desk.Time);
        using var either = CancellationTokenSource.CreateLinkedTokenSource(limit.Token, movedOn);
        var stop = either.Token;
        return await Task.Run(() => PreviewFactory(file, settings, theme, s_size, stop), stop).WaitAsync(stop); // reading from a drive that does not respond ignores the cancellation
    }

    private void Apply(Bitmap? picture, string lines, string caption)
    {
        var before = Picture;
        (Picture, Lines, Caption) = (picture, lines, caption);
        OnPropertyChanged(null);
        before?.Dispose();
    }

    private static WriteableBitmap BitmapOf(Picture picture)
    {
        var bitmap = new WriteableBitmap(s_size, new Vector(96.0, 96.0), PixelFormat.Bgra8888, AlphaFormat.Opaque);
        using var locked = bitmap.Lock();
        var pixels = MemoryMarshal.Cast<uint, byte>(picture.Pixels.AsSpan()).ToArray();
        for (var row = 0; row < picture.Height; row++) Marshal.Copy(pixels, row * picture.Width * sizeof(uint), locked.Address + (row * locked.RowBytes), picture.Width * sizeof(uint));
        return bitmap;
    }
}
