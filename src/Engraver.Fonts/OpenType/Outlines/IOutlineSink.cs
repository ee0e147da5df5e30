namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Receives the contours of a glyph piece by piece, in font units, y up, exactly as the font describes them.</summary>
public interface IOutlineSink
{
    /// <summary>Begins a contour. At least one piece follows, then <see cref="Close"/>.</summary>
    void MoveTo(FontPoint start);

    void LineTo(FontPoint end);

    void QuadraticTo(FontPoint control, FontPoint end);

    void CubicTo(FontPoint control1, FontPoint control2, FontPoint end);

    /// <summary>Ends the contour, by a straight line if it is not yet back at its start.</summary>
    void Close();
}
