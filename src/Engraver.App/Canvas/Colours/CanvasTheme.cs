using Engraver.Workbench.Settings;

namespace Engraver.App.Canvas.Colours;

/// <summary>The colours of the canvas itself, 0xAARRGGBB.</summary>
public sealed record CanvasTheme
{
    /// <summary>AutoCAD's dark model space.</summary>
    public static CanvasTheme Dark { get; } = new()
    {
        Background = 0xFF212830, Foreground = 0xFFFFFFFF, MinorGrid = 0xFF272F38, MajorGrid = 0xFF313B46, AxisX = 0xFF6B3A3A, AxisY = 0xFF35603C,
        Crosshair = 0xFFFFFFFF, Selected = 0xFF4FA3FF, Hover = 0xFF9CC9FF, Tool = 0xFFFFB000, Playback = 0xFF2EE6D6,
        ClosedContour = 0xFF4CC2FF, InsideContour = 0xFF9AD66B, OpenContour = 0xFFFF8A5B, Rapid = 0xFF8C96A3, Direction = 0xFFFFD866, Start = 0xFF7CE38B, Machine = 0xFFB59CFF, Finding = 0xFFFF5C8A, Engraved = 0xFF35D07F, Remaining = 0xFF6E7B8A,
        SlowCut = 0xFF3B6CFF, FastCut = 0xFFFF4B3B,
        Operations = [0xFF4CC2FF, 0xFFFFB347, 0xFF7CE38B, 0xFFE78BFF, 0xFFFFE45C, 0xFFFF7A7A, 0xFF5CF2E0, 0xFFB0A4FF],
    };

    public static CanvasTheme Light { get; } = new()
    {
        Background = 0xFFFFFFFF, Foreground = 0xFF000000, MinorGrid = 0xFFF1F3F5, MajorGrid = 0xFFDDE2E7, AxisX = 0xFFE0A0A0, AxisY = 0xFF9CCBA4,
        Crosshair = 0xFF000000, Selected = 0xFF0B63CE, Hover = 0xFF5B9BE6, Tool = 0xFFB86A00, Playback = 0xFF007F8C,
        ClosedContour = 0xFF0077B6, InsideContour = 0xFF4C8A14, OpenContour = 0xFFC8501E, Rapid = 0xFF7A8590, Direction = 0xFF9A7400, Start = 0xFF1E8E3E, Machine = 0xFF6A48C9, Finding = 0xFFD6215F, Engraved = 0xFF0B8A4B, Remaining = 0xFFA0A9B4,
        SlowCut = 0xFF2148C8, FastCut = 0xFFD1261A,
        Operations = [0xFF0077B6, 0xFFB35900, 0xFF1E8E3E, 0xFF9C27B0, 0xFF8A6D00, 0xFFC62828, 0xFF00796B, 0xFF5E4AC9],
    };

    /// <summary>Black background; the contrast of every mark is at least 7 to 1, except that of the grid, which is only an aid.</summary>
    public static CanvasTheme HighContrast { get; } = new()
    {
        Background = 0xFF000000, Foreground = 0xFFFFFFFF, MinorGrid = 0xFF1C1C1C, MajorGrid = 0xFF3A3A3A, AxisX = 0xFFB05050, AxisY = 0xFF4FA05F,
        Crosshair = 0xFFFFFFFF, Selected = 0xFF7CC4FF, Hover = 0xFFC4E2FF, Tool = 0xFFFFC640, Playback = 0xFF5CF2FF,
        ClosedContour = 0xFF66D4FF, InsideContour = 0xFFB4F085, OpenContour = 0xFFFFA581, Rapid = 0xFFB4BEC9, Direction = 0xFFFFE58A, Start = 0xFF98F5A6, Machine = 0xFFCDBBFF, Finding = 0xFFFF8FB0, Engraved = 0xFF5CF0A0, Remaining = 0xFFA4B0BE,
        SlowCut = 0xFF8FA9FF, FastCut = 0xFFFF8578,
        Operations = [0xFF66D4FF, 0xFFFFC266, 0xFF98F5A6, 0xFFF0B3FF, 0xFFFFF08A, 0xFFFFA3A3, 0xFF8FFFF0, 0xFFCDC4FF],
    };

    /// <summary>The colours of the operations in their order; the first follows the last.</summary>
    public required IReadOnlyList<uint> Operations { get; init; }

    public required uint Background { get; init; }

    /// <summary>The colour of ACI 7 on this background.</summary>
    public required uint Foreground { get; init; }

    public required uint MinorGrid { get; init; }

    public required uint MajorGrid { get; init; }

    /// <summary>The line y = 0 of the grid.</summary>
    public required uint AxisX { get; init; }

    /// <summary>The line x = 0 of the grid.</summary>
    public required uint AxisY { get; init; }

    public required uint Crosshair { get; init; }

    public required uint Selected { get; init; }

    public required uint Hover { get; init; }

    /// <summary>The position of the machine and its trail.</summary>
    public required uint Tool { get; init; }

    /// <summary>The position of the playback and the entity there.</summary>
    public required uint Playback { get; init; }

    public required uint ClosedContour { get; init; }

    /// <summary>A closed contour inside another contour.</summary>
    public required uint InsideContour { get; init; }

    public required uint OpenContour { get; init; }

    public required uint Rapid { get; init; }

    /// <summary>Order numbers and direction arrows.</summary>
    public required uint Direction { get; init; }

    /// <summary>Start points.</summary>
    public required uint Start { get; init; }

    /// <summary>Machine envelope and work origin.</summary>
    public required uint Machine { get; init; }

    /// <summary>Discontinuities and the findings of CHECK.</summary>
    public required uint Finding { get; init; }

    public required uint Engraved { get; init; }

    public required uint Remaining { get; init; }

    /// <summary>The cut path where the planned speed is lowest.</summary>
    public required uint SlowCut { get; init; }

    /// <summary>The cut path where the planned speed is highest.</summary>
    public required uint FastCut { get; init; }

    public static CanvasTheme Of(DesktopTheme theme) => theme switch
    {
        DesktopTheme.Light => Light,
        DesktopTheme.HighContrast => HighContrast,
        _ => Dark,
    };

    /// <summary>Index of the colour of an operation.</summary>
    /// <param name="place">In the list of operations, 0 is the first.</param>
    public static ushort OperationColour(int place) => (ushort)(place % Dark.Operations.Count);
}
