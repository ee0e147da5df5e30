using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Overlays;
using Engraver.App.Canvas.Scenes;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas.Pictures;

/// <summary>Everything that a picture shows, except the view. Immutable, because the picture is drawn on other threads.</summary>
internal sealed record CanvasContent
{
    public CanvasScene? Scene { get; init; }

    public OverlayScene Overlay { get; init; } = OverlayScene.Empty;

    public CanvasLayers Shown { get; init; } = CanvasLayers.Drawing;

    public bool Grid { get; init; } = true;

    public CanvasTheme Theme { get; init; } = CanvasTheme.Dark;

    /// <summary>Selected entities of the drawing, by index; null: none.</summary>
    public bool[]? Selected { get; init; }

    /// <summary>Number of moves of the job that are engraved, from the first on.</summary>
    public int EngravedMoves { get; init; }

    /// <summary>Pixels of the screen per pixel of the design.</summary>
    public double Scaling { get; init; } = 1.0;
}
