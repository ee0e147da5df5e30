namespace Engraver.Core.Sequencing;

/// <summary>In which order strokes are cut. In every order an inner stroke comes before the one around it.</summary>
public enum StrokeOrder
{
    /// <summary>File order of each contour's lowest row, drawn directions and start points.</summary>
    Drawn,

    /// <summary>Always the nearest next start, contours started where the tool is nearest.</summary>
    Nearest,
}
