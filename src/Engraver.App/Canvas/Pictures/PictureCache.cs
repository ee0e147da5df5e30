using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Views;

namespace Engraver.App.Canvas.Pictures;

/// <summary>Keeps the last finished picture and draws the requested one. Until that is ready, the finished one is shown, moved and scaled to the requested
/// view.</summary>
/// <remarks>Called from one thread (that of the window); only the drawing itself runs on others.</remarks>
internal sealed class PictureCache
{
    private CanvasContent _drawnContent = new();
    private Picture? _picture;
    private Action? _stopDrawing;

    /// <summary>Raised on the thread that awaits <see cref="RefineAsync"/> after a new picture has been stored.</summary>
    public event EventHandler? Refined;

    public CanvasContent Content { get; set; } = new();

    public CanvasView View { get; set; }

    /// <summary>The finished picture shows exactly the requested content and view.</summary>
    public bool IsUpToDate => _picture is not null && _picture.View == View && ReferenceEquals(_drawnContent, Content);

    /// <summary>A picture is being drawn on other threads.</summary>
    public bool IsDrawing => _stopDrawing is not null;

    /// <summary>There is a finished picture, whatever it shows.</summary>
    public bool HasPicture => _picture is not null;

    /// <summary>There is a finished picture of this scene.</summary>
    public bool HasPictureOf(Scenes.CanvasScene? scene) => _picture is not null && ReferenceEquals(_drawnContent.Scene, scene);

    /// <summary>Writes what can be shown immediately. The time does not depend on the size of the drawing.</summary>
    /// <param name="target">Pixels 0xAARRGGBB.</param>
    /// <param name="stride">Pixels to a row of the target.</param>
    public void Show(Span<uint> target, int stride)
    {
        if (_picture is null) FillBackground(target, stride);
        else if (_picture.View == View) Copy(_picture, target, stride);
        else PictureMover.Move(_picture, View, Content.Theme.Background, target, stride);
    }

    /// <summary>Draws the requested picture on this thread (and the other cores).</summary>
    public void Refine(CancellationToken stop) => Store(Draw(Content, View, stop), Content);

    /// <summary>Draws the requested picture on other threads and stores it, unless another one is requested before it is done.</summary>
    /// <returns>False if another picture was requested in the meantime.</returns>
    public async Task<bool> RefineAsync()
    {
        CancelDrawing();
        using var drawing = new CancellationTokenSource();
        Action stop = drawing.Cancel;
        _stopDrawing = stop;
        var (content, view) = (Content, View);
        try
        {
            // Also a picture that is done immediately is stored asynchronously, because the caller may still cancel it.
            var picture = await Task.Run(() => Draw(content, view, drawing.Token), drawing.Token).ConfigureAwait(ConfigureAwaitOptions.ContinueOnCapturedContext | ConfigureAwaitOptions.ForceYielding);
            if (_stopDrawing != stop) return false;
            _stopDrawing = null;
            Store(picture, content);
            return true;
        }
        catch (OperationCanceledException)
        {
            return false; // another picture was requested
        }
    }

    /// <summary>Stops a picture that is being drawn.</summary>
    public void CancelDrawing()
    {
        _stopDrawing?.Invoke();
        _stopDrawing = null;
    }

    private static Picture Draw(CanvasContent content, CanvasView view, CancellationToken stop) =>
        PictureRenderer.Render(LayerStack.Create(content, view), view, Backdrop.For(view, content.Theme, content.Grid), stop);

    private void Store(Picture picture, CanvasContent content)
    {
        (_picture, _drawnContent) = (picture, content);
        Refined?.Invoke(this, EventArgs.Empty);
    }

    private void FillBackground(Span<uint> target, int stride)
    {
        for (var row = 0; row < View.Size.Height; row++) target.Slice(row * stride, View.Size.Width).Fill(Content.Theme.Background);
    }

    private static void Copy(Picture picture, Span<uint> target, int stride)
    {
        for (var row = 0; row < picture.Height; row++) picture.Pixels.AsSpan(row * picture.Width, picture.Width).CopyTo(target[(row * stride)..]);
    }
}
