using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs.Generation;

/// <summary>Drawn heights in a motion program: if an axis moves the tool, each stroke is cut in its passes; heights that cannot be cut are refused.</summary>
public class HeightGenerationTests
{
    private static readonly MachineProfile s_mill = MachineProfile.Default with
    {
        Axes = MachineAxes.Default with { Z = new MachineAxis('C', 400.0) },
        Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, PlungeMmPerMinute = 300.0 },
    };

    [Fact]
    public void Lines_that_rise_make_a_sequence_in_three_axes_and_an_arc_beside_them_one_of_its_own()
    {
        var program = Generated(s_mill, Move(Toolpaths.Line(0, 0, 10, 0), -1, -1), Move(Toolpaths.Line(10, 0, 20, 0), -1, -2), Move(Toolpaths.Arc(20, 5, 5, 270, 90), -2, -2), Move(Toolpaths.Line(25, 5, 25, 10), -2, -2));

        var sequences = program.Strokes.Single().Sequences;
        Assert.Equal([true, false], sequences.Select(sequence => sequence.ChangesHeight)); // the level line is in the first: its bend down is below the sharp corner's 10 degrees
        Assert.Equal([-400, -800], sequences[0].Segments.Select(segment => segment.End.Z).Distinct()); // the machine brakes before the bend: the level line is divided
        Assert.All(sequences[1].Segments, segment => Assert.Equal(-800, segment.End.Z));
        Assert.Equal(new CountsPoint(0, 0, -400), program.Strokes[0].Start);
        Assert.Equal(Math.Sqrt((10000.0 * 10000.0) + (400.0 * 400.0)), sequences[0].Segments.Where(segment => segment.End.Z == -800).Sum(segment => segment.Length), 9);
    }

    [Fact]
    public void A_change_of_slope_sharper_than_a_sharp_corner_is_one()
    {
        var program = Generated(s_mill, Move(Toolpaths.Line(0, 0, 10, 0), -1, -1), Move(Toolpaths.Line(10, 0, 20, 0), -1, -9));

        Assert.Equal([false, true], program.Strokes.Single().Sequences.Select(sequence => sequence.ChangesHeight));
    }

    [Theory]
    [InlineData(-2.0, 1200.0)] // 20 mm/s along the path and 3.9 of them down: the feed in space
    [InlineData(-30.0, 300.0 / 0.948683)] // steep: limited by the plunge feed
    public void A_slope_is_cut_at_the_feed_in_space_and_falls_no_faster_than_the_plunge_feed(double depth, double feed)
    {
        var program = Generated(s_mill, Move(Toolpaths.Line(0, 0, 10, 0), 0, depth));

        var sequence = program.Strokes.Single().Sequences.Single();
        var counts = double.Hypot(10000.0, depth * 400.0);
        Assert.Equal(feed / 60.0 * counts / double.Hypot(10.0, depth), sequence.Speed, 2.0);
    }

    [Fact]
    public void A_stroke_is_cut_in_passes_of_whole_steps_from_above()
    {
        var program = Generated(s_mill with { Height = s_mill.Height! with { CutDepth = 2.5, DepthPerPass = 1.0 } }, Move(Toolpaths.Line(0, 0, 10, 0), 0, 0));

        Assert.Equal([-200, -600, -1000], program.Strokes.Select(stroke => stroke.Start.Z));
        Assert.Equal([0, 0, 0], program.Strokes.Select(stroke => stroke.Index));
        Assert.All(program.Strokes, stroke => Assert.Equal(stroke.Start.Z, stroke.Sequences[^1].End.Z));
    }

    [Theory]
    [InlineData(2.0, 1.0, 2)] // exactly two steps
    [InlineData(0.0, 1.0, 1)]
    [InlineData(0.5, 1.0, 1)]
    public void There_are_no_more_passes_than_the_depth_needs(double depth, double step, int passes) =>
        Assert.Equal(passes, Generated(s_mill with { Height = s_mill.Height! with { CutDepth = depth, DepthPerPass = step } }, Move(Toolpaths.Line(0, 0, 10, 0), 0, 0)).Strokes.Count);

    [Theory]
    [InlineData(double.NaN, double.NaN, "MOT0013")] // a piece of a curve that rises
    [InlineData(-1.0, 1.0, "MOT0014")] // ends at the retract height
    [InlineData(-1e9, -1e9, "MOT0015")]
    public void What_cannot_be_cut_in_height_is_refused_once_with_the_entity_named(double from, double to, string id)
    {
        var result = Generate(s_mill, Move(Toolpaths.Line(0, 0, 10, 0), from, to), Move(Toolpaths.Line(10, 0, 20, 0), from, to));

        Assert.Null(result.Program);
        var finding = Assert.Single(result.Diagnostics);
        Assert.Equal((id, 70L), (finding.Id, finding.Source.Line));
    }

    [Fact]
    public void A_tool_that_only_touches_the_work_is_told_and_runs()
    {
        var result = Generate(s_mill, Move(Toolpaths.Line(0, 0, 10, 0), 0, 0));

        Assert.Equal("MOT0016", Assert.Single(result.Diagnostics).Id);
        Assert.NotNull(result.Program);
    }

    [Fact]
    public void Where_an_output_is_the_tool_heights_leave_no_trace_in_the_program()
    {
        var level = Generated(MachineProfile.Default, Move(Toolpaths.Line(0, 0, 10, 0), 0, 0));
        var sloping = Generated(MachineProfile.Default, Move(Toolpaths.Line(0, 0, 10, 0), 5, -9));

        Assert.Equal(level.Strokes[0].Sequences[0].Segments, sloping.Strokes[0].Sequences[0].Segments);
        Assert.False(sloping.Strokes[0].Sequences[0].ChangesHeight);
    }

    private static StrokeMove Move(Segment segment, double from, double to) => new(segment, 7, from, to);

    private static MotionProgram Generated(MachineProfile profile, params StrokeMove[] moves)
    {
        var result = Generate(profile, moves);
        Assert.DoesNotContain(result.Diagnostics, finding => finding.Severity == Severity.Error);
        return result.Program!;
    }

    private static MotionGeneration Generate(MachineProfile profile, params StrokeMove[] moves) =>
        MotionProgramGenerator.Generate(new Toolpath(Point2D.Origin, [new ToolpathStroke(0, false, moves)]), profile, new(0.001, 0.0), entity => new SourceRef(10 * entity));
}
