using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>Compares the curves of a text with <see cref="LetterPlaces"/> at points of each curve.</summary>
internal sealed class LetterCheck
{
    /// <summary>Allowed distance as a part of the size of the text, and of its coordinates for rounding.</summary>
    private const double OfSize = 1e-9;
    private const double OfCoordinates = 1e-13;

    private static readonly double[] s_fractions = [0.0, 0.3, 0.7, 1.0];

    private readonly LetterPlaces _places;
    private readonly LetterCurves _curves;
    private int _next;
    private Misplacement? _worst;

    private LetterCheck(LetterPlaces places, LetterCurves curves) => (_places, _curves) = (places, curves);

    /// <param name="places">The second calculation for the same text.</param>
    /// <returns>Null if each curve is at its place and there is no other; otherwise the largest distance.</returns>
    public static Misplacement? Find(LetterPlaces places, LetterCurves curves)
    {
        ArgumentNullException.ThrowIfNull(places);
        ArgumentNullException.ThrowIfNull(curves);
        var check = new LetterCheck(places, curves);
        foreach (var letter in places.Letters)
        {
            foreach (var contour in letter.Curves.Contours) check.Compare(letter, contour);
        }

        foreach (var (from, to, above) in places.Lines) check.Compare((part, fraction) => places.OnLine(from + (fraction * (to - from)), above));
        if (check._next != curves.Parts.Count) check.Note(double.PositiveInfinity, places.OnLine(0.0, 0.0));
        return check._worst is { } worst && !(worst.Distance <= check.Allowed()) ? worst : null;
    }

    private double Allowed()
    {
        var (start, end, top) = (_places.OnLine(0.0, 0.0), _places.OnLine(_places.Advance, 0.0), _places.OnLine(0.0, _places.Height));
        var largest = ((Vector3D[])[start, end, top]).Max(point => Math.Max(Math.Abs(point.X), Math.Max(Math.Abs(point.Y), Math.Abs(point.Z))));
        return (OfSize * Math.Max((end - start).Length, (top - start).Length)) + (OfCoordinates * Math.Max(largest, _places.LargestTerm));
    }

    private void Compare(LetterPlaces.Letter letter, GlyphContour contour)
    {
        var from = contour.Start;
        foreach (var piece in contour.Pieces)
        {
            Compare(letter, from, piece);
            from = piece.End;
        }
    }

    private void Compare(LetterPlaces.Letter letter, FontPoint from, GlyphPiece piece)
    {
        var isPoint = from == piece.End && (piece.Kind is GlyphPieceKind.Line or GlyphPieceKind.Arc || (piece.Control1 == from && (piece.Kind == GlyphPieceKind.Quadratic || piece.Control2 == from)));
        if (isPoint) return;
        if (piece.Kind == GlyphPieceKind.Arc) CompareArc(letter, new GlyphArc(from, piece));
        else Compare((_, fraction) => _places.At(letter, On(from.X, piece.Control1.X, piece.Control2.X, piece.End.X, piece.Kind, fraction), On(from.Y, piece.Control1.Y, piece.Control2.Y, piece.End.Y, piece.Kind, fraction)));
    }

    /// <summary>An arc may have become an ellipse, whose parameter is not the angle: its points are brought back to the circle.</summary>
    private void CompareArc(LetterPlaces.Letter letter, GlyphArc arc)
    {
        var (centre, x, y) = (_places.At(letter, arc.Centre.X, arc.Centre.Y), _places.At(letter, arc.Centre.X + arc.Radius, arc.Centre.Y), _places.At(letter, arc.Centre.X, arc.Centre.Y + arc.Radius));
        var (u, v) = (x - centre, y - centre);
        var (uu, uv, vv) = (u.Dot(u), u.Dot(v), v.Dot(v));
        Compare((part, fraction) =>
        {
            var at = part.Kind == SegmentKind.Ellipse && fraction is > 0.0 and < 1.0 ? FractionOf(Of(part, fraction) - centre) : fraction;
            var point = arc.PointAt(at);
            return _places.At(letter, point.X, point.Y);
        });

        double FractionOf(Vector3D from)
        {
            var (fu, fv) = (from.Dot(u), from.Dot(v));
            return Math.Min(1.0, arc.FractionOf(Math.Atan2((uu * fv) - (uv * fu), (vv * fu) - (uv * fv))));
        }
    }

    private void Compare(Func<DrawingPart, double, Vector3D> expected)
    {
        if (_next >= _curves.Parts.Count)
        {
            Note(double.PositiveInfinity, expected(default, 0.0));
            return;
        }

        var part = _curves.Parts[_next++];
        foreach (var fraction in s_fractions)
        {
            var place = expected(part, fraction);
            Note((Of(part, fraction) - place).Length, place);
        }
    }

    private void Note(double distance, Vector3D at)
    {
        if (_worst is not { } worst || !(distance <= worst.Distance)) _worst = new Misplacement(distance, at);
    }

    /// <summary>A point of a curve that is cut, by its parameter; of an arc by the angle.</summary>
    private Vector3D Of(in DrawingPart part, double fraction)
    {
        if (part.IsFreeCurve)
        {
            var spans = _curves.Curves[part.CurveIndex].Spans;
            var at = fraction * spans.Length;
            var span = Math.Min((int)at, spans.Length - 1);
            return spans[span].EvaluateInSpace(at - span, out _);
        }

        if (part.Kind == SegmentKind.Line) return new(part.A + (fraction * (part.D - part.A)), part.B + (fraction * (part.E - part.B)), part.C + (fraction * (part.F - part.C)));
        var (sin, cos) = Math.SinCos((part.E + (fraction * part.F)) * Math.PI / 180.0);
        return new(part.A + (part.D * cos), part.B + (part.D * sin), part.C);
    }

    private static double On(double a, double b, double c, double d, GlyphPieceKind kind, double t) => kind switch
    {
        GlyphPieceKind.Line => a + (t * (d - a)),
        GlyphPieceKind.Quadratic => ((1.0 - t) * (1.0 - t) * a) + (2.0 * t * (1.0 - t) * b) + (t * t * d),
        _ => ((1.0 - t) * (1.0 - t) * (1.0 - t) * a) + (3.0 * t * (1.0 - t) * (((1.0 - t) * b) + (t * c))) + (t * t * t * d),
    };
}

/// <summary>The largest distance of a letter from its place, drawing units.</summary>
internal readonly record struct Misplacement(double Distance, Vector3D At);
