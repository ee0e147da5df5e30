using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>Compares the curves of a text with <see cref="LetterPlaces"/> at points of each curve. Curves of outlines that were united with their neighbours
/// are allowed to be arcs on these outlines.</summary>
internal sealed class LetterCheck
{
    /// <summary>Allowed distance as a part of the size of the text, and of its coordinates for rounding.</summary>
    private const double OfSize = 1e-9;
    private const double OfCoordinates = 1e-13;

    /// <summary>Of a curve, for its area and its box.</summary>
    private const int Chords = 8;

    private static readonly double[] s_fractions = [0.0, 0.3, 0.7, 1.0];

    private readonly ILetterPlaces _places;
    private readonly LetterCurves _curves;
    private readonly Vector3D _origin;
    private readonly double _allowed;
    private readonly bool[] _isFound;
    private readonly List<Func<double, Vector3D>> _united = [];

    /// <summary>The starts of the parts that are not found yet.</summary>
    private readonly BoxTree _starts;
    private Misplacement? _worst;

    private LetterCheck(ILetterPlaces places, LetterCurves curves)
    {
        (_places, _curves, _isFound) = (places, curves, new bool[curves.Parts.Count]);
        _origin = places.Origin;
        _allowed = (OfSize * places.Size) + (OfCoordinates * places.LargestTerm);
        _starts = BoxTree.Build([.. curves.Parts.Select(part => InPlan(Of(part, 0.0)))]);
    }

    /// <param name="places">The second calculation for the same text.</param>
    /// <param name="maxError">Largest distance of the arcs of united outlines from the outlines.</param>
    /// <returns>Null if each curve is at its place and there is no other; otherwise the largest distance.</returns>
    public static Misplacement? Find(ILetterPlaces places, LetterCurves curves, double maxError)
    {
        ArgumentNullException.ThrowIfNull(places);
        ArgumentNullException.ThrowIfNull(curves);
        var check = new LetterCheck(places, curves);
        foreach (var letter in places.Letters)
        {
            foreach (var contour in letter.Curves.Contours) check.Compare(letter, contour);
        }

        foreach (var line in places.LineCurves) check.Compare((_, fraction) => line(fraction), isOutline: false);
        check.CompareRest(maxError);
        return check._worst;
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
        else Compare((_, fraction) => _places.At(letter, On(from.X, piece.Control1.X, piece.Control2.X, piece.End.X, piece.Kind, fraction), On(from.Y, piece.Control1.Y, piece.Control2.Y, piece.End.Y, piece.Kind, fraction)), letter.IsOutline);
    }

    /// <summary>An arc may have become an ellipse, whose parameter is not the angle: its points are brought back to the circle.</summary>
    private void CompareArc(LetterPlaces.Letter letter, GlyphArc arc)
    {
        var (centre, x, y) = (_places.At(letter, arc.Centre.X, arc.Centre.Y), _places.At(letter, arc.Centre.X + arc.Radius, arc.Centre.Y), _places.At(letter, arc.Centre.X, arc.Centre.Y + arc.Radius));
        var (u, v) = (x - centre, y - centre);
        var (uu, uv, vv) = (u.Dot(u), u.Dot(v), v.Dot(v));
        Compare(
            (part, fraction) =>
            {
                var isEllipse = part is { Kind: SegmentKind.Ellipse } && fraction is > 0.0 and < 1.0;
                var point = arc.PointAt(isEllipse ? FractionOf(Of(part!.Value, fraction) - centre) : fraction);
                return _places.At(letter, point.X, point.Y);
            },
            letter.IsOutline);

        double FractionOf(Vector3D from)
        {
            var (fu, fv) = (from.Dot(u), from.Dot(v));
            return Math.Min(1.0, arc.FractionOf(Math.Atan2((uu * fv) - (uv * fu), (vv * fu) - (uv * fv))));
        }
    }

    /// <summary>Finds the part of a curve; that of an outline may have been united.</summary>
    /// <param name="expected">A point of the curve by its fraction, and by the part that is compared where that has another parameter.</param>
    private void Compare(Func<DrawingPart?, double, Vector3D> expected, bool isOutline)
    {
        var start = expected(null, 0.0);
        var nearest = _starts.Nearest(InPlan(start), (part, _) => Distance(_curves.Parts[part], expected), isOutline ? _allowed : double.PositiveInfinity, out var distance);
        if (nearest >= 0 && distance <= _allowed)
        {
            _isFound[nearest] = true;
            _starts.Hide(nearest);
        }
        else if (isOutline)
        {
            _united.Add(fraction => expected(null, fraction));
        }
        else
        {
            Note(distance, start);
        }
    }

    private double Distance(DrawingPart part, Func<DrawingPart?, double, Vector3D> expected) => s_fractions.Max(fraction => (Of(part, fraction) - expected(part, fraction)).Length);

    /// <summary>Parts that are not curves of a font: those of united outlines are on outlines of letters.</summary>
    private void CompareRest(double maxError)
    {
        var rest = Enumerable.Range(0, _isFound.Length).Where(i => !_isFound[i]).Select(i => _curves.Parts[i]).ToList();
        if (rest.Count == 0 && HasArea(maxError) && !Reaches(maxError)) Note(double.PositiveInfinity, _united[0](0.0));
        var outlines = BoxTree.Build([.. _united.Select(BoxOf)]);
        foreach (var point in rest.SelectMany(part => s_fractions.Select(fraction => Of(part, fraction))))
        {
            var distance = Nearest(point, CurveDistance.FewPoints);
            if (distance > maxError + _allowed) distance = Nearest(point, CurveDistance.ManyPoints); // a curve that turns back on itself
            if (!(distance <= maxError + _allowed)) Note(distance, point);
        }

        double Nearest(Vector3D point, int points)
        {
            outlines.Nearest(InPlan(point), (curve, _) => CurveDistance.Of(point, _united[curve], points), double.PositiveInfinity, out var distance);
            return distance;
        }
    }

    /// <summary>A box that contains the curve: that of some of its points, grown by the largest step between them.</summary>
    private static Bounds2D BoxOf(Func<double, Vector3D> curve)
    {
        Point2D[] points = [.. Enumerable.Range(0, Chords + 1).Select(i => InPlan(curve((double)i / Chords)))];
        return points.Aggregate(Bounds2D.Empty, (box, point) => box.Including(point)).Grown(points.Zip(points.Skip(1), (one, other) => (other - one).Length).Max());
    }

    private static Point2D InPlan(Vector3D point) => new(point.X, point.Y);

    /// <summary>True if what is cut reaches as far as the united outlines: they may be inside another one.</summary>
    private bool Reaches(double maxError)
    {
        var cut = _curves.Parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(part.IsFreeCurve ? _curves.Curves[part.CurveIndex].Bounds : part.InPlan().Bounds));
        var error = maxError + _allowed;
        return _united.SelectMany(curve => s_fractions.Select(curve)).All(point => point.X >= cut.MinX - error && point.X <= cut.MaxX + error && point.Y >= cut.MinY - error && point.Y <= cut.MaxY + error);
    }

    /// <summary>Outlines that are narrower than the error on average enclose nothing: no part is left of them.</summary>
    private bool HasArea(double maxError)
    {
        var (area, length) = (0.0, 0.0);
        foreach (var curve in _united)
        {
            for (var i = 0; i < Chords; i++)
            {
                var (one, other) = (curve((double)i / Chords) - _origin, curve((i + 1.0) / Chords) - _origin);
                area += 0.5 * ((one.X * other.Y) - (one.Y * other.X));
                length += (other - one).Length;
            }
        }

        return Math.Abs(area) > maxError * length;
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
