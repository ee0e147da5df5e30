using System.Globalization;
using System.Text;
using Avalonia;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Pictures;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.App.FileDialogs;

/// <summary>A preview of a file before it is opened: the picture of a drawing, or the first lines of a text.</summary>
/// <param name="Picture">Null if there is none.</param>
/// <param name="Lines">The first lines of a text; empty for a drawing.</param>
/// <param name="Caption">A summary of the file, or why there is no preview.</param>
internal sealed record FilePreview(Picture? Picture, string Lines, string Caption)
{
    /// <summary>Maximum length of a file that is read for a preview.</summary>
    public const long MaxBytes = 32_000_000;

    private const int MaxLines = 40;
    private const int MaxCharacters = 3000;

    /// <summary>Reads and draws a file on this thread; for a thread of the pool.</summary>
    /// <exception cref="OperationCanceledException">It took too long, or another file was selected.</exception>
    public static FilePreview Create(FileRow file, DrawingSettings settings, CanvasTheme theme, PixelSize size, CancellationToken stop)
    {
        if (file.Bytes > MaxBytes) return new FilePreview(null, "", Text.Get("Files.PreviewTooLarge", file.Size));
        if (FileKind.IsStream(file.Path)) return new FilePreview(null, "", "");
        try
        {
            return file.Name.EndsWith(".dxf", StringComparison.OrdinalIgnoreCase) ? OfDrawing(file.Path, settings, theme, size, stop) : OfText(file.Path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new FilePreview(null, "", Text.Get("Files.PreviewUnreadable"));
        }
    }

    private static FilePreview OfDrawing(string path, DrawingSettings settings, CanvasTheme theme, PixelSize size, CancellationToken stop)
    {
        var drawing = DrawingFile.Open(path, settings, stop);
        if (DrawingFile.IsUnreadable(drawing)) return new FilePreview(null, "", Text.Get("Files.PreviewUnreadable"));
        var scene = CanvasScene.From(drawing);
        stop.ThrowIfCancellationRequested();
        var view = CanvasView.Fitting(scene.Extents, size, 0.06);
        var layers = LayerStack.Create(new CanvasContent { Scene = scene, Theme = theme, Grid = false }, view);
        var picture = PictureRenderer.Render(layers, view, Backdrop.For(view, theme, grid: false), stop);
        var caption = string.Create(CultureInfo.InvariantCulture, $"{CountText.Format(drawing.Entities.Count, "Curve")}, {CountText.Format(drawing.Layers.Count, "Layer")}\n{scene.Extents.Width:0.###} × {scene.Extents.Height:0.###} {drawing.Unit.Name}");
        return new FilePreview(picture, "", scene.Extents.IsEmpty ? Text.Get("Files.PreviewEmpty") : caption);
    }

    private static FilePreview OfText(string path)
    {
        using var reader = new StreamReader(path, Encoding.UTF8);
        var letters = new char[MaxCharacters];
        var text = new string(letters, 0, reader.ReadBlock(letters, 0, letters.Length));
        if (text.Contains('\0', StringComparison.Ordinal)) return new FilePreview(null, "", "");
        return new FilePreview(null, string.Join('\n', text.ReplaceLineEndings("\n").Split('\n').Take(MaxLines)), "");
    }
}
