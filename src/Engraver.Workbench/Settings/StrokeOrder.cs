namespace Engraver.Workbench.Settings;

/// <summary>In which order strokes are cut. An inner contour always comes before the one around it.</summary>
public enum StrokeOrder
{
    /// <summary>File order of each contour's first entity.</summary>
    Drawn,

    /// <summary>Always the nearest next start.</summary>
    Nearest,
}
