using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>A stroke of a profile while it gets its depth, its tabs, its overcut and its descent.</summary>
/// <param name="contour">Lines and arcs in order and direction from the start, in plan.</param>
/// <param name="depth">Depth of the pass.</param>
internal sealed class DressedStroke(IReadOnlyList<StrokeMove> contour, double depth)
{
    private List<StrokeMove> _moves = [.. contour.Select(move => move with { StartZ = -depth, EndZ = -depth })];

    public IReadOnlyList<StrokeMove> Moves => _moves;

    /// <summary>Raises the tool over tabs.</summary>
    /// <param name="middles">Distances along the stroke of the middles of the tabs, in order; each tab is within one move.</param>
    /// <param name="span">Length of path on which the tool is above the tab: its width and the diameter of the tool.</param>
    /// <param name="tabDepth">Depth of the top of the tabs, above the depth of the pass.</param>
    /// <param name="slope">Rise of the tool beside a tab for each millimetre; infinite for straight up.</param>
    /// <param name="maxErrorMm">Largest distance of a chord of a slope from its arc.</param>
    public void AddTabs(IReadOnlyList<double> middles, double span, double tabDepth, double slope, double maxErrorMm)
    {
        var (dressed, along, beside) = (new List<StrokeMove>(), 0.0, (depth - tabDepth) / slope);
        foreach (var move in _moves)
        {
            var (length, from) = (move.Segment.Length, 0.0);
            foreach (var middle in middles.Where(middle => middle > along && middle < along + length))
            {
                var (up, down) = ((middle - along - (span / 2.0)) / length, (middle - along + (span / 2.0)) / length);
                var (foot, end) = (up - (beside / length), down + (beside / length));
                dressed.Add(Part(move, from, foot));
                dressed.AddRange(Slope(move, foot, up, -depth, -tabDepth, maxErrorMm));
                dressed.Add(Part(move, up, down) with { StartZ = -tabDepth, EndZ = -tabDepth, Role = StrokeRole.Tab });
                dressed.AddRange(Slope(move, down, end, -tabDepth, -depth, maxErrorMm));
                from = end;
            }

            dressed.Add(Part(move, from, 1.0));
            along += length;
        }

        _moves = dressed;
    }

    /// <summary>Cuts beyond the end along the first moves of the contour.</summary>
    /// <param name="length">At most the length of the contour.</param>
    public void AddOvercut(double length)
    {
        foreach (var move in contour.Select(move => move with { StartZ = -depth, EndZ = -depth }))
        {
            if (length <= 0.0) return;
            _moves.Add(length >= move.Segment.Length ? move : Part(move, 0.0, length / move.Segment.Length));
            length -= move.Segment.Length;
        }
    }

    /// <summary>Adds moves before the first one.</summary>
    public void Enter(IEnumerable<StrokeMove> moves) => _moves.InsertRange(0, moves);

    /// <summary>Adds moves after the last one.</summary>
    public void Leave(IEnumerable<StrokeMove> moves) => _moves.AddRange(moves);

    /// <summary>Straight up or down, or along the contour.</summary>
    private static IEnumerable<StrokeMove> Slope(in StrokeMove move, double from, double to, double startZ, double endZ, double maxErrorMm)
    {
        if (to > from) return ChordPath.Sloped(ChordPath.Of([Part(move, from, to)], maxErrorMm), startZ, endZ, StrokeRole.Tab);
        var place = move.Segment.PointAt(from);
        return [new StrokeMove(Segment.FromLine(place, place), move.EntityIndex, startZ, endZ) { Role = StrokeRole.Tab }];
    }

    private static StrokeMove Part(in StrokeMove move, double from, double to) => move with { Segment = SegmentPart.Of(move.Segment, from, to) };
}
