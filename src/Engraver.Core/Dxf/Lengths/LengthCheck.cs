using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Lengths;

/// <summary>
/// Compares the length of every curve that was read with the length that its numbers describe: a curve that has lost almost all its length is an error that
/// names it, whatever the cause. Shares no code with the mapping, which it checks. Faces and multilines are left out: their lines join written points.
/// </summary>
internal sealed class LengthCheck(LayerTable layers)
{
    /// <summary>A curve shorter than this part of its written length is lost.</summary>
    private const double SmallestPart = 1e-6;

    /// <summary>Part of the distance from the origin below which a length is rounding.</summary>
    private const double Rounding = 1e-12;

    private readonly WrittenLength _written = new();

    /// <summary>Starts a POLYLINE, whose vertices follow.</summary>
    public void BeginPolyline() => _written.BeginVertices();

    public void AddVertex(EntityRecord vertex) => _written.AddVertex(vertex);

    /// <summary>The finding about a curve that is lost; null for any other curve, and for one that is not visible.</summary>
    public RecordIssue? Find(EntityRecord record, CurveShape shape) => IsVisible(record) ? Compare(record, _written.Of(record), shape) : null;

    /// <summary>The findings about the outlines of a record, in the order in which they were written.</summary>
    public IEnumerable<RecordIssue> FindAll(EntityRecord record, IReadOnlyList<CurveShape> outlines)
    {
        if (!IsVisible(record)) yield break;
        var written = _written.OfOutlines(record);
        for (var i = 0; i < written.Count; i++)
        {
            if (Compare(record, written[i], i < outlines.Count ? outlines[i] : null) is { } issue) yield return issue;
        }
    }

    private bool IsVisible(EntityRecord record) => !record.Invisible && !layers.IsHidden(record.Layer);

    private static RecordIssue? Compare(EntityRecord record, double written, CurveShape? shape)
    {
        if (!(written > Rounding * (Math.Abs(record.Number(10, 0.0)) + Math.Abs(record.Number(20, 0.0)))) || (shape is not null && IsAtLeast(shape, SmallestPart * written))) return null;
        return record.Finding(DxfRules.CurveLost, Wording.Get("LengthCheck.DescribedAndRead", written, shape is null ? 0.0 : Exact(shape)), refused: false);
    }

    /// <summary>Compares by chords first, which are never longer than the curve; they suffice for almost every curve.</summary>
    private static bool IsAtLeast(CurveShape shape, double length)
    {
        var sum = 0.0;
        foreach (ref readonly var part in shape.Parts)
        {
            sum += part.IsFreeCurve ? Chords(shape.Curves[part.CurveIndex]) : part.SpaceLength;
            if (sum >= length) return true;
        }

        return Exact(shape) >= length;
    }

    private static double Exact(CurveShape shape)
    {
        var sum = 0.0;
        foreach (ref readonly var part in shape.Parts) sum += part.IsFreeCurve ? shape.Curves[part.CurveIndex].SpaceLength : part.SpaceLength;
        return sum;
    }

    private static double Chords(Geometry.RationalCurve curve)
    {
        var sum = 0.0;
        foreach (var span in curve.Spans) sum += span.Start.DistanceTo(span.End);
        return sum;
    }
}
