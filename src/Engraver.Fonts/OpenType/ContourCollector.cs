using Engraver.Fonts.OpenType.Outlines;

namespace Engraver.Fonts.OpenType;

/// <summary>Collects the contours of a glyph. The line that closes a contour becomes a piece; lines of no length, and contours of two
/// lines that bound no area, are left out.</summary>
/// <param name="shift">Added to every X.</param>
internal sealed class ContourCollector(double shift) : IOutlineSink
{
    private readonly List<GlyphContour> _contours = [];
    private List<GlyphPiece> _pieces = [];
    private FontPoint _start;
    private FontPoint _at;

    public IReadOnlyList<GlyphContour> Contours => _contours;

    public void MoveTo(FontPoint start)
    {
        _start = _at = Shifted(start);
        _pieces = [];
    }

    public void LineTo(FontPoint end) => AddLine(Shifted(end));

    public void QuadraticTo(FontPoint control, FontPoint end) => Add(GlyphPiece.Quadratic(Shifted(control), Shifted(end)));

    public void CubicTo(FontPoint control1, FontPoint control2, FontPoint end) => Add(GlyphPiece.Cubic(Shifted(control1), Shifted(control2), Shifted(end)));

    public void Close()
    {
        AddLine(_start);
        if (_pieces.Count > 2 || _pieces.Any(piece => piece.Kind != GlyphPieceKind.Line))
            _contours.Add(new GlyphContour(_start, _pieces, true));
    }

    private void AddLine(FontPoint end)
    {
        if (end != _at)
            Add(GlyphPiece.Line(end));
    }

    private void Add(GlyphPiece piece)
    {
        _pieces.Add(piece);
        _at = piece.End;
    }

    private FontPoint Shifted(FontPoint point) => new(point.X + shift, point.Y);
}
