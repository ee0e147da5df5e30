using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Tests.Operations;

/// <summary>Damages the strokes of a job in a random place: the check finds each damage.</summary>
public class OperationCheckTests
{
    private const string Operations = """
        { "id": "h", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 2, "repeats": 2 },
        { "id": "m", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.5, "depthPerPass": 0.3 },
        { "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 3, "depthPerPass": 1, "finish": 0.2, "direction": "climb" }
        """;

    [Fact]
    public void The_path_as_made_has_no_finding()
    {
        var job = new OperationJob(OperationStrokesTests.Plate(), Operations);

        Assert.Empty(job.CheckOf(job.Path));
    }

    [Theory]
    [InlineData("pass missing")]
    [InlineData("pass repeated")]
    [InlineData("depth")]
    [InlineData("direction")]
    [InlineData("shifted")]
    [InlineData("move missing")]
    public void A_seeded_fault_is_found(string fault)
    {
        var job = new OperationJob(OperationStrokesTests.Plate(), Operations);
        var random = new Random(fault.Length);
        for (var round = 0; round < 40; round++)
        {
            var damaged = Damaged(job, fault, random);
            Assert.True(job.CheckOf(damaged).Count > 0, $"{fault} {round}");
        }
    }

    /// <summary>Damages what is added to the contours.</summary>
    [Theory]
    [InlineData("tab gone")]
    [InlineData("tab lower")]
    [InlineData("tab narrower")]
    [InlineData("lead in the part")]
    [InlineData("ramp steeper")]
    [InlineData("ramp gone")]
    [InlineData("ramp from the surface")]
    [InlineData("overcut shorter")]
    [InlineData("overcut beside")]
    public void A_fault_of_the_dressing_is_found(string fault)
    {
        var job = new OperationJob(OperationStrokesTests.Plate(), """{ "id": "cut", "kind": "profile", "select": {"layers": ["CUT"]}, "tool": 1, "depth": 3, "depthPerPass": 1.5, "start": {"rule": "longest"}, "ramp": {"angle": 10}, "overcut": 3, "leadIn": {"shape": "arc", "radius": 1.5}, "tabs": {"count": 2, "width": 1.5, "height": 1} }""");
        var strokes = job.Path.Strokes.ToList();
        Assert.Empty(job.CheckOf(job.Path));
        for (var index = 0; index < strokes.Count; index++)
        {
            var moves = strokes[index].Moves.ToList();
            var (tab, ramp) = (moves.FindIndex(move => move.Role == StrokeRole.Tab), moves.FindIndex(move => move.Role == StrokeRole.Ramp));
            if (fault.StartsWith("tab", StringComparison.Ordinal) && tab < 0) continue;
            List<StrokeMove> damaged = fault switch
            {
                "tab gone" => [.. moves.Take(tab), moves[tab + 1] with { StartZ = -3.0, EndZ = -3.0, Role = StrokeRole.Cut }, .. moves.Skip(tab + 3)],
                "tab lower" => [.. moves.Select(move => move.Role != StrokeRole.Tab ? move : move with { StartZ = Math.Min(move.StartZ, -2.1), EndZ = Math.Min(move.EndZ, -2.1) })],
                "tab narrower" => [.. moves.Select(move => move.Role == StrokeRole.Tab && move.Segment.Length > 0.0 ? move with { Segment = Segment.FromLine(move.Segment.Start, move.Segment.PointAt(0.9)) } : move)],
                "lead in the part" => [moves[0] with { Segment = Segment.FromLine(moves[0].Segment.End + ((moves[0].Segment.End - moves[0].Segment.Start) * 0.5), moves[0].Segment.End) }, .. moves.Skip(1)],
                "ramp steeper" => [.. moves.Take(ramp), moves[ramp] with { EndZ = moves[ramp].StartZ - (moves[ramp].Segment.Length * 0.2) }, moves[ramp + 1] with { StartZ = moves[ramp].StartZ - (moves[ramp].Segment.Length * 0.2) }, .. moves.Skip(ramp + 2)],
                "ramp gone" => [.. moves.Where(move => move.Role is StrokeRole.Cut or StrokeRole.Tab)],
                "ramp from the surface" => [.. moves.Take(ramp), moves[ramp] with { StartZ = moves[ramp].StartZ + 0.1 }, .. moves.Skip(ramp + 1)],
                "overcut shorter" => [.. moves.SkipLast(1), moves[^1] with { Segment = Segment.FromLine(moves[^1].Segment.Start, moves[^1].Segment.PointAt(0.9)) }],
                _ => [.. moves.SkipLast(1), moves[^1] with { Segment = Segment.FromLine(moves[^1].Segment.Start, moves[^1].Segment.End + new Vector2D(0.001, 0.001)) }],
            };
            Assert.True(job.CheckOf(job.Path with { Strokes = [.. strokes.Take(index), strokes[index] with { Moves = damaged }, .. strokes.Skip(index + 1)] }).Count > 0, $"{fault} {index}");
        }
    }

    private static Toolpath Damaged(OperationJob job, string fault, Random random)
    {
        var strokes = job.Path.Strokes.ToList();
        var isOfProfile = fault is "direction" or "move missing";
        int index;
        do index = random.Next(strokes.Count);
        while (isOfProfile && job.Passes.Strokes[index].Operation.Id != "cut");
        var other = Enumerable.Range(0, strokes.Count).First(i => i != index && job.Passes.Strokes[i].Operation.Id == job.Passes.Strokes[index].Operation.Id && job.Passes.Strokes[i].Stroke != job.Passes.Strokes[index].Stroke || job.Passes.Strokes[index].Operation.Id == "m" && i != index);
        strokes[index] = fault switch
        {
            "pass missing" => strokes[other],
            "pass repeated" => strokes[index] with { Moves = [.. strokes[index].Moves, .. strokes[index].Moves.Select(Raised)] },
            "depth" => strokes[index] with { Moves = [.. strokes[index].Moves.Select(move => move with { StartZ = move.StartZ - 0.01, EndZ = move.EndZ - 0.01 })] },
            "direction" => strokes[index] with { Moves = [.. strokes[index].Moves.Reverse().Select(move => move with { Segment = move.Segment.Reversed() })] },
            "shifted" => strokes[index] with { Moves = [.. strokes[index].Moves.Select(move => move with { Segment = Shifted(move.Segment) })] },
            _ => strokes[index] with { Moves = [.. strokes[index].Moves.Skip(1)] },
        };
        return job.Path with { Strokes = strokes };
    }

    private static StrokeMove Raised(StrokeMove move) => move with { StartZ = move.StartZ + 0.5, EndZ = move.EndZ + 0.5, Segment = Shifted(move.Segment) };

    private static Segment Shifted(in Segment segment)
    {
        var by = new Vector2D(0.01, 0.0);
        return segment.Kind == SegmentKind.Line ? Segment.FromLine(segment.Start + by, segment.End + by) : Segment.FromArc(segment.Arc with { Centre = segment.Arc.Centre + by }, segment.Start + by, segment.End + by);
    }
}
