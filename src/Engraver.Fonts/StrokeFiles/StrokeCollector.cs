namespace Engraver.Fonts.StrokeFiles;

/// <summary>Collects the strokes of a glyph from the movements of a pen. A stroke continues while each piece starts where the one before ended, and is closed
/// if it ends where it started.</summary>
internal sealed class StrokeCollector
{
    /// <summary>Far more than a letter has: a file that asks for more is broken.</summary>
    private const int MaxPieces = 20_000;
    private const double MaxCoordinate = 1_000_000;

    /// <summary>Sums of fractions that should be the same point differ by less.</summary>
    private const double Tolerance = 1e-6;

    private readonly List<GlyphContour> _contours = [];
    private List<GlyphPiece> _pieces = [];
    private FontPoint _start;
    private int _count;

    /// <summary>Where the pen is.</summary>
    public FontPoint At { get; private set; }

    /// <exception cref="BrokenFontException">The point is outside of every sensible letter.</exception>
    public void MoveTo(FontPoint point) => At = Checked(point);

    public void LineTo(FontPoint end) => Add(GlyphPiece.Line(end));

    public void ArcTo(FontPoint end, double bulge) => Add(bulge == 0 ? GlyphPiece.Line(end) : GlyphPiece.Arc(end, bulge));

    /// <summary>Adds strokes that were collected before.</summary>
    public void AddAll(IEnumerable<GlyphContour> contours)
    {
        foreach (var contour in contours)
        {
            MoveTo(contour.Start);
            foreach (var piece in contour.Pieces) Add(piece);
            Finish();
        }
    }

    /// <summary>Ends the last stroke.</summary>
    /// <returns>All strokes.</returns>
    public IReadOnlyList<GlyphContour> Finish()
    {
        if (_pieces.Count == 0) return _contours;
        var last = _pieces[^1];
        // A line that is drawn forth and back bounds no area and stays open.
        var isClosed = Math.Abs(last.End.X - _start.X) < Tolerance && Math.Abs(last.End.Y - _start.Y) < Tolerance && (_pieces.Count > 2 || _pieces.Any(piece => piece.Kind == GlyphPieceKind.Arc));
        if (isClosed) _pieces[^1] = last with { End = _start };
        _contours.Add(new GlyphContour(_start, _pieces, isClosed));
        _pieces = [];
        return _contours;
    }

    private void Add(GlyphPiece piece)
    {
        Checked(piece.End);
        if (piece.End == At) return;
        if (++_count > MaxPieces) throw new BrokenFontException("A glyph of the font has too many pieces.");
        if (_pieces.Count > 0 && _pieces[^1].End != At) Finish();
        if (_pieces.Count == 0) _start = At;
        _pieces.Add(piece);
        At = piece.End;
    }

    private static FontPoint Checked(FontPoint point) =>
        Math.Abs(point.X) <= MaxCoordinate && Math.Abs(point.Y) <= MaxCoordinate ? point : throw new BrokenFontException("A glyph of the font is too large.");
}
