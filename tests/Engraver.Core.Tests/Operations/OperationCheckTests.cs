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
