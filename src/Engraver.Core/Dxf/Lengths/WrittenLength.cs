using System.Runtime.InteropServices;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Lengths;

/// <summary>The length of a curve, drawing units, from the numbers of its record alone: exact for lines, arcs and bulges, an estimate of the right magnitude
/// for ellipses and splines. 0 for a record without length in plan.</summary>
internal sealed class WrittenLength
{
    private const int FrameVertex = 16;
    private const int InSpace = 8;
    private readonly VertexChain _vertices = new();

    public void BeginVertices() => _vertices.Clear();

    public void AddVertex(EntityRecord vertex)
    {
        if ((vertex.Flags(70) & FrameVertex) == 0) _vertices.Add(vertex.Number(10, 0.0), vertex.Number(20, 0.0), vertex.Number(42, 0.0));
    }

    public double Of(EntityRecord record)
    {
        var pairs = CollectionsMarshal.AsSpan(record.Sequence);
        return record.Kind switch
        {
            RecordKind.Line => Distance(record.Number(11, 0.0) - record.Number(10, 0.0), record.Number(21, 0.0) - record.Number(20, 0.0)),
            RecordKind.Circle => Math.Tau * Math.Abs(record.Number(40, 0.0)),
            RecordKind.Arc => Math.Abs(record.Number(40, 0.0)) * WrittenSpan.Of(record.Number(50, 0.0), record.Number(51, 0.0), 360.0) * (Math.PI / 180.0),
            RecordKind.Ellipse => Ellipse(record),
            RecordKind.LwPolyline => Polyline(pairs, (record.Flags(70) & 1) != 0),
            RecordKind.Polyline => _vertices.Length((record.Flags(70) & 1) != 0, bent: (record.Flags(70) & InSpace) == 0),
            RecordKind.Spline or RecordKind.Helix => Spline(pairs, weightCode: 41),
            _ => 0.0,
        };
    }

    /// <summary>The lengths of the loops of a hatch boundary, or of the one outline of another record.</summary>
    public IReadOnlyList<double> OfOutlines(EntityRecord record)
    {
        var pairs = CollectionsMarshal.AsSpan(record.Sequence);
        if (record.Kind == RecordKind.Helix) return [Of(record)];
        if (record.Kind == RecordKind.Leader) return [Polyline(pairs, closed: false)];
        return record.Kind == RecordKind.Hatch ? Loops(pairs) : [];
    }

    /// <summary>From 92 to the next 92 or the 75 that follows the loops; edges begin at 72.</summary>
    private List<double> Loops(ReadOnlySpan<CodedNumber> pairs)
    {
        var lengths = new List<double>();
        var at = Next(pairs, 0, 92, 92);
        while (at < pairs.Length && pairs[at].Code == 92)
        {
            var end = Next(pairs, at + 1, 92, 75);
            lengths.Add(((int)pairs[at].Value & 2) != 0 ? Polyline(pairs[(at + 1)..end], First(pairs[at..end], 73, 1.0) != 0.0) : Edges(pairs[at..end]));
            at = end;
        }

        return lengths;
    }

    private static double Edges(ReadOnlySpan<CodedNumber> loop)
    {
        var sum = 0.0;
        for (var at = Next(loop, 0, 72, 72); at < loop.Length;)
        {
            var end = Next(loop, at + 1, 72, 72);
            sum += Edge(loop[at..end]);
            at = end;
        }

        return sum;
    }

    private static double Edge(ReadOnlySpan<CodedNumber> edge) => (int)edge[0].Value switch
    {
        1 => Distance(First(edge, 11, 0.0) - First(edge, 10, 0.0), First(edge, 21, 0.0) - First(edge, 20, 0.0)),
        2 => Math.Abs(First(edge, 40, 0.0)) * HatchSpan(edge),
        3 => HatchEllipse(edge),
        4 => Spline(edge, weightCode: 42),
        _ => 0.0,
    };

    /// <summary>Radians.</summary>
    private static double HatchSpan(ReadOnlySpan<CodedNumber> edge) => WrittenSpan.Of(First(edge, 50, 0.0), First(edge, 51, 360.0), 360.0) * (Math.PI / 180.0);

    /// <summary>The angles of such an edge are true angles: in the direction a the ellipse is 1 / sqrt((cos a / A)^2 + (sin a / B)^2) from its centre. A
    /// clockwise edge is the mirror image.</summary>
    private static double HatchEllipse(ReadOnlySpan<CodedNumber> edge)
    {
        var (major, ratio) = (Distance(First(edge, 11, 0.0), First(edge, 21, 0.0)), Math.Abs(First(edge, 40, 1.0)));
        if (ratio == 0.0) return 0.0; // not an ellipse
        return SampledChords.Length(First(edge, 50, 0.0) * (Math.PI / 180.0), HatchSpan(edge), angle =>
        {
            var (sin, cos) = Math.SinCos(angle);
            var reach = major * ratio / Distance(ratio * cos, sin);
            return (reach * cos, reach * sin);
        });
    }

    /// <summary>The length of the ellipse in its own plane.</summary>
    private static double Ellipse(EntityRecord record)
    {
        var major = Math.Sqrt((record.Number(11, 0.0) * record.Number(11, 0.0)) + (record.Number(21, 0.0) * record.Number(21, 0.0)) + (record.Number(31, 0.0) * record.Number(31, 0.0)));
        var (minor, start) = (major * record.Number(40, 0.0), record.Number(41, 0.0));
        return SampledChords.Length(start, WrittenSpan.Of(start, record.Number(42, Math.Tau), Math.Tau), angle =>
        {
            var (sin, cos) = Math.SinCos(angle);
            return (major * cos, minor * sin);
        });
    }

    private double Polyline(ReadOnlySpan<CodedNumber> pairs, bool closed)
    {
        _vertices.Clear();
        foreach (var (code, value) in pairs)
        {
            if (code == 10) _vertices.Add(value, 0.0, 0.0);
            else if (code == 20) _vertices.SetY(value);
            else if (code == 42) _vertices.SetBulge(value);
        }

        return _vertices.Length(closed, bent: true);
    }

    /// <summary>The control polygon, less the contraction that unequal weights can cause; for a spline through points the chords between these. The shorter
    /// where both are written.</summary>
    private static double Spline(ReadOnlySpan<CodedNumber> pairs, int weightCode)
    {
        var (controls, fits, lightest, heaviest) = (new PointTrail(), new PointTrail(), 1.0, 1.0);
        var first = true;
        foreach (var (code, value) in pairs)
        {
            if (code == 10) controls.Begin(value);
            else if (code == 20) controls.End(value);
            else if (code == 11) fits.Begin(value);
            else if (code == 21) fits.End(value);
            else if (code != weightCode || !(value > 0.0)) continue;
            else (lightest, heaviest, first) = first ? (value, value, false) : (Math.Min(lightest, value), Math.Max(heaviest, value), false);
        }

        var polygon = controls.Length * (lightest / heaviest);
        return fits.Count < 2 ? polygon : controls.Count < 2 ? fits.Length : Math.Min(polygon, fits.Length);
    }

    private static double Distance(double x, double y) => Math.Sqrt((x * x) + (y * y));

    private static int Next(ReadOnlySpan<CodedNumber> pairs, int from, int code, int other)
    {
        while (from < pairs.Length && pairs[from].Code != code && pairs[from].Code != other) from++;
        return from;
    }

    private static double First(ReadOnlySpan<CodedNumber> pairs, int code, double otherwise)
    {
        var at = Next(pairs, 0, code, code);
        return at < pairs.Length ? pairs[at].Value : otherwise;
    }

    /// <summary>The length along points whose x comes first and y second.</summary>
    private struct PointTrail
    {
        private Point2D _last;
        private double _x;

        public int Count { get; private set; }

        public double Length { get; private set; }

        public void Begin(double x) => _x = x;

        public void End(double y)
        {
            var place = new Point2D(_x, y);
            if (Count++ > 0) Length += Distance(place.X - _last.X, place.Y - _last.Y);
            _last = place;
        }
    }
}
