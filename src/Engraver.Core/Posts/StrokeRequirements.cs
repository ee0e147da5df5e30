using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts;

/// <summary>What a job with operations requires of a program, by place: a program does not state which stroke it cuts. Where several strokes pass a place, it
/// may do as any of them.</summary>
public sealed class StrokeRequirements
{
    private readonly List<(StrokeMove Move, int Stroke)> _moves = [];
    private readonly List<(Vector3D Start, Vector3D End, StrokeRequirement Required)> _strokes = [];
    private readonly BoxTree _boxes;
    private readonly BoxTree _starts;
    private readonly BoxTree _ends;
    private readonly double _near;

    /// <param name="path">The strokes of the job.</param>
    /// <param name="operations">Their operations.</param>
    /// <param name="feed">Feed of a stroke that states none, mm/min.</param>
    /// <param name="near">Distance from a stroke at which a place belongs to it, mm.</param>
    public StrokeRequirements(Toolpath path, PostOperations operations, double feed, double near)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(operations);
        _near = near;
        Tools = [.. operations.Sections.Select(section => section.Tool.Number)];
        Stops = [.. operations.Sections.Select(section => section.Repeat is not null)];
        StateSpindle = operations.StateSpindle;
        for (var i = 0; i < path.Strokes.Count; i++)
        {
            var stroke = path.Strokes[i];
            var required = new StrokeRequirement(stroke.FeedMmPerMinute ?? feed, stroke.PlungeMmPerMinute, operations.SpindleOf(i), operations.OperationOf(i).Power, operations.OperationOf(i).Overscan, operations.OperationOf(i).Tool, stroke.PierceSeconds, stroke.DwellSeconds) { Outputs = stroke.Outputs };
            _strokes.Add((At(stroke.Start, stroke.Moves[0].StartZ), At(stroke.End, stroke.Moves[^1].EndZ), required));
            _moves.AddRange(stroke.Moves.Select(move => (move, i)));
        }

        _boxes = BoxTree.Build([.. _moves.Select(move => move.Move.Segment.Bounds)]);
        _starts = BoxTree.Build([.. path.Strokes.Select(stroke => stroke.Start)]);
        _ends = BoxTree.Build([.. path.Strokes.Select(stroke => stroke.End)]);
    }

    /// <summary>Number of the tool of each section, in their order; a number is repeated where a tool comes twice.</summary>
    public IReadOnlyList<int> Tools { get; }

    /// <summary>For each section: the program stops before it, and the tool remains.</summary>
    public IReadOnlyList<bool> Stops { get; }

    /// <summary>An operation states the speed of its spindle.</summary>
    public bool StateSpindle { get; }

    /// <summary>The requirements of the strokes that pass a place; empty beside the path.</summary>
    /// <param name="height">Strokes at this height, if there are any; null: at any height.</param>
    public IReadOnlyList<StrokeRequirement> Passing(Point2D place, double? height)
    {
        List<(StrokeMove Move, int Stroke)> moves = [.. Near(_boxes, place).Select(index => _moves[index]).Where(move => move.Move.Segment.DistanceTo(place) <= _near)];
        if (height is { } z && moves.Where(move => z >= Math.Min(move.Move.StartZ, move.Move.EndZ) - _near && z <= Math.Max(move.Move.StartZ, move.Move.EndZ) + _near).ToList() is { Count: > 0 } level) moves = level;
        return [.. moves.Select(move => _strokes[move.Stroke].Required).Distinct()];
    }

    /// <summary>The waits that strokes require at their start, seconds; empty where no stroke starts.</summary>
    public IReadOnlyList<double> WaitsAtStart(Vector3D place) => [.. Near(_starts, new Point2D(place.X, place.Y)).Select(index => _strokes[index]).Where(stroke => (stroke.Start - place).Length <= _near).Select(stroke => stroke.Required.PierceSeconds).Distinct()];

    /// <summary>The waits that strokes require at their end, seconds; empty where no stroke ends.</summary>
    public IReadOnlyList<double> WaitsAtEnd(Vector3D place) => [.. Near(_ends, new Point2D(place.X, place.Y)).Select(index => _strokes[index]).Where(stroke => (stroke.End - place).Length <= _near).Select(stroke => stroke.Required.DwellSeconds).Distinct()];

    private List<int> Near(BoxTree boxes, Point2D place)
    {
        var found = new List<int>();
        boxes.Overlapping(Bounds2D.FromCorners(new Point2D(place.X - _near, place.Y - _near), new Point2D(place.X + _near, place.Y + _near)), found);
        return found;
    }

    private static Vector3D At(Point2D place, double height) => new(place.X, place.Y, height);
}
