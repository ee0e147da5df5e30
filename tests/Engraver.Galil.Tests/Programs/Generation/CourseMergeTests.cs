using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs.Generation;

public sealed class CourseMergeTests
{
    private static readonly MotionTolerances s_fitting = new(0.001, 0.01) { FitsArcs = true };

    /// <summary>Every chord is an entity: the shares of all segments are the chords, in order and with their lengths.</summary>
    [Fact]
    public void Chords_of_a_circle_become_arcs_that_list_their_entities_with_lengths()
    {
        var chords = Chords(360, i => Point2D.Origin + Vector2D.FromPolar(10.0, Angle.FromDegrees(i)));
        var segments = Segments(Toolpaths.OfStroke(chords));

        Assert.InRange(segments.Count, 2, 6);
        Assert.All(segments, segment => Assert.Equal((VectorSegmentKind.Arc, 10_000), (segment.Kind, segment.Radius)));
        var shares = segments.SelectMany(segment => segment.Shares!).ToList();
        Assert.Equal(Enumerable.Range(0, 360), shares.Select(share => share.EntityIndex).Distinct());
        Assert.Equal(shares.Select(share => share.EntityIndex).Order(), shares.Select(share => share.EntityIndex));
        foreach (var share in shares.GroupBy(share => share.EntityIndex)) Assert.Equal(1000.0 * chords[share.Key].Length, share.Sum(part => part.Length), 2.0);
        Assert.All(segments, segment => Assert.Equal(segment.Length, segment.Shares!.Sum(share => share.Length), 1.0));
    }

    [Fact]
    public void Without_the_setting_every_chord_is_a_segment()
    {
        var path = Toolpaths.OfStroke(Chords(360, i => Point2D.Origin + Vector2D.FromPolar(10.0, Angle.FromDegrees(i))));
        var segments = Segments(path, s_fitting with { FitsArcs = false });

        Assert.True(segments.Count >= 360, $"{segments.Count}");
        Assert.All(segments, segment => Assert.Equal((1, null), (segment.Moves, segment.Shares)));
    }

    [Fact]
    public void Lines_on_one_line_are_one_and_arcs_on_one_circle_are_one()
    {
        var segments = Segments(Toolpaths.OfStroke(
            Toolpaths.Line(0, 0, 3, 0), Toolpaths.Line(3, 0, 4, 0), Toolpaths.Line(4, 0, 20, 0), Toolpaths.Arc(20, 10, 10, -90, 40), Toolpaths.Arc(20, 10, 10, -50, 50)));

        Assert.Equal([(VectorSegmentKind.Line, 0, 3), (VectorSegmentKind.Arc, 3, 2)], segments.Select(segment => (segment.Kind, segment.Move, segment.Moves)).Distinct());
        Assert.Equal([0, 1, 2], segments.Where(segment => segment.Kind == VectorSegmentKind.Line).SelectMany(segment => segment.Shares!).Select(share => share.EntityIndex).Distinct());
        Assert.Equal(90.0, segments.Where(segment => segment.Kind == VectorSegmentKind.Arc).Sum(segment => segment.DeltaDegrees), 0.01);
    }

    /// <summary>A corner of the drawing, a change of the tool's task, a gap and a turn back are kept.</summary>
    [Fact]
    public void What_is_no_curve_is_not_merged()
    {
        var corner = Segments(Toolpaths.OfStroke(Toolpaths.Line(0, 0, 5, 0), Toolpaths.Line(5, 0, 10, 0.1), Toolpaths.Line(10, 0.1, 0, 0.2)), s_fitting with { CornerMm = 0.0 });
        Assert.Equal(3, corner.Select(segment => segment.Move).Distinct().Count());

        StrokeMove[] moves = [new(Toolpaths.Line(0, 0, 5, 0), 0), new(Toolpaths.Line(5, 0, 10, 0), 1) { Role = StrokeRole.Lead }];
        Assert.Equal([0, 1], Segments(new Toolpath(default, [new ToolpathStroke(0, false, moves)])).Select(segment => segment.Move).Distinct());

        var gap = Segments(Toolpaths.OfStroke(Toolpaths.Line(0, 0, 5, 0), Toolpaths.Line(5, 0.01, 10, 0.01)));
        Assert.Equal([0, 1], gap.Select(segment => segment.Move).Distinct());

        var twoArcs = Segments(Toolpaths.OfStroke(Toolpaths.Arc(0, 0, 10, 0, 40), Toolpaths.Arc(0, 0, 10, 40, -40)));
        Assert.Equal([0, 1], twoArcs.Select(segment => segment.Move).Distinct());
    }

    /// <summary>A slot whose ends are drawn as chords between long lines: the lines stay whole, and the path has no corner.</summary>
    [Fact]
    public void Lines_beside_a_curve_stay_and_its_arcs_are_tangent_to_them()
    {
        List<Segment> drawn = [Toolpaths.Line(0, -5, 80, -5)];
        drawn.AddRange(Chords(90, i => new Point2D(80.0, 0.0) + Vector2D.FromPolar(5.0, Angle.FromDegrees(-90.0 + (2.0 * i)))));
        drawn.Add(Toolpaths.Line(80, 5, 0, 5));
        var program = Program(Toolpaths.OfStroke([.. drawn]), s_fitting);
        var segments = program.Strokes[0].Sequences.SelectMany(sequence => sequence.Segments).ToList();

        Assert.Single(program.Strokes[0].Sequences);
        Assert.InRange(segments.Count, 3, 9);
        Assert.Equal([new CountsPoint(80_000, -5_000), new CountsPoint(0, 5_000)], segments.Where(segment => segment is { Kind: VectorSegmentKind.Line, Moves: 1 }).GroupBy(segment => segment.Move).Select(line => line.Last().End));
        Assert.All(segments, segment => Assert.True(segment.Speed == 0 || segment.Speed > 15_000 || segment.Kind == VectorSegmentKind.Line, $"{segment}"));
    }

    /// <summary>The rest of a program from the middle of a segment has the entities that are left.</summary>
    [Fact]
    public void The_rest_of_a_merged_segment_has_the_rest_of_its_entities()
    {
        var program = Program(Toolpaths.OfStroke(Toolpaths.Line(0, 0, 3, 0), Toolpaths.Line(3, 0, 4, 0), Toolpaths.Line(4, 0, 20, 0)), s_fitting with { CornerMm = 0.0 });
        var rest = RemainingProgram.From(program, new JobPosition(0, 3500.0), 0.0, degrees => degrees).Program;
        var first = rest.Strokes[0].Sequences[0].Segments[0];

        Assert.Equal(1, first.EntityIndex);
        Assert.Equal([1, 2], first.Shares!.Select(share => share.EntityIndex));
        Assert.Equal((1, 2), (first.EntityAt(400.0), first.EntityAt(600.0)));
    }

    private static MotionProgram Program(Toolpath path, MotionTolerances tolerances) => MotionProgramGenerator.Generate(path, MachineProfile.Default, tolerances, null).Program!;

    private static List<VectorSegment> Segments(Toolpath path, MotionTolerances? tolerances = null) =>
        [.. Program(path, tolerances ?? s_fitting).Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments)];

    private static Segment[] Chords(int count, Func<int, Point2D> at) => [.. Enumerable.Range(0, count).Select(i => Segment.FromLine(at(i), at(i + 1)))];
}
