using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Posting;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Programs;

/// <summary>The posts run in a simulated controller, judged by its axes and outputs.</summary>
public class PostInControllerTests
{
    private const byte Tool = 1;

    /// <summary>Half a diagonal count of rounding at each sample in addition to the count by which an arc may deviate, and a margin.</summary>
    private const double MaxDeviation = 2.5;

    /// <summary>Distance of samples at 20 counts per ms.</summary>
    private const double SampleSpacing = 25.0;

    private static readonly MachineProfile HundredCounts = MachineProfile.Default with { Axes = MachineAxes.FromScale(100, 100) };

    public static TheoryData<string, MotionStyle> Jobs => new()
    {
        { "paper", MotionStyle.Calls }, { "paper", MotionStyle.Continuous }, { "paper at 100", MotionStyle.Calls }, { "paper at 100", MotionStyle.Continuous },
        { "rings", MotionStyle.Calls }, { "rings", MotionStyle.Continuous }, { "mirrored rings", MotionStyle.Calls }, { "mirrored rings", MotionStyle.Continuous },
        { "wave", MotionStyle.Calls }, { "wave", MotionStyle.Continuous }, { "ellipses", MotionStyle.Continuous },
    };

    [Theory]
    [MemberData(nameof(Jobs))]
    public async Task A_post_cuts_the_drawing_and_nothing_else(string job, MotionStyle style)
    {
        var (toolpath, profile) = Drawing(job);
        var program = MotionProgramGenerator.Generate(toolpath, profile, new(0.001, 0.0), null, style).Program!;
        await using var bench = new ControllerBench();

        foreach (var chunk in Post(program, 1000).Chunks) bench.RunJob(chunk);

        var end = program.Strokes[^1].Sequences[^1].End;
        Assert.Equal((end.X, end.Y), ((int)bench.Value("_RPA"), (int)bench.Value("_RPB")));
        Assert.Equal((0, 0, 0.0), (bench.Status.Outputs, bench.Status.Underruns, bench.Value("_ED")));
        if (style == MotionStyle.Calls) Assert.Equal(program.SegmentCount + (3 * program.Strokes.Count), bench.Value("seq"));
        AssertCutAsDrawn(toolpath, profile.Scale, bench.Record);
    }

    /// <summary>MT needs the motor off, so that a program must not set it: it ends before anything moves and names the command to send.</summary>
    [Theory]
    [InlineData(MotionStyle.Calls, 2.0)]
    [InlineData(MotionStyle.Continuous, -2.5)]
    public async Task A_post_for_a_profile_with_motor_types_runs_on_a_controller_with_these_and_on_no_other(MotionStyle style, double type)
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.Default with { Y = MachineAxes.Default.Y with { MotorType = type } } };
        var (toolpath, _) = Drawing("paper");
        var text = Assert.Single(Post(MotionProgramGenerator.Generate(toolpath, profile, new(0.001, 0.0), null, style).Program!, 1000).Chunks);
        await using var other = new ControllerBench();
        other.Do("CFI;SB1");
        other.Download(text);
        other.Send("XQ#JOB\r");
        other.PassUntil(status => status.IsIdle, 1.0);
        await using var same = new ControllerBench();
        same.Do(string.Create(System.Globalization.CultureInfo.InvariantCulture, $"CFI;MOB;MTB={type};SHB"));
        same.RunJob(text);

        Assert.Equal((0, 0.0, 0.0, 0.0), (other.Status.Outputs, other.Value("_RPA"), other.Value("_RPB"), other.Value("_ED")));
        Assert.Contains("MTB IS", other.Received, StringComparison.Ordinal);
        Assert.Contains("SEND MOB THEN MTB=", other.Received, StringComparison.Ordinal);
        Assert.DoesNotContain("MTB IS", same.Received, StringComparison.Ordinal);
        AssertCutAsDrawn(toolpath, profile.Scale, same.Record);
    }

    [Theory]
    [InlineData(MotionStyle.Calls)]
    [InlineData(MotionStyle.Continuous)]
    public async Task Chunks_run_one_after_the_other_cut_the_same_drawing(MotionStyle style)
    {
        var (toolpath, profile) = Drawing("wave");
        var post = Post(MotionProgramGenerator.Generate(toolpath, profile, new(0.001, 0.0), null, style).Program!, 70);
        await using var bench = new ControllerBench();

        foreach (var chunk in post.Chunks) bench.RunJob(chunk);

        Assert.True(post.Chunks.Count > 2);
        Assert.Equal(0, bench.Status.Underruns);
        AssertCutAsDrawn(toolpath, profile.Scale, bench.Record);
    }

    [Theory]
    [InlineData(MotionStyle.Calls)]
    [InlineData(MotionStyle.Continuous)]
    public async Task From_wherever_the_position_stands_the_start_point_of_the_drawing_is_there(MotionStyle style)
    {
        var (wave, profile) = Drawing("wave");
        var toolpath = wave with { ToolStart = new Point2D(1.5, -2) };
        var post = Post(MotionProgramGenerator.Generate(toolpath, profile, new(0.001, 0.0), null, style).Program!, 70);
        await using var bench = new ControllerBench();
        bench.Do("DP 7000,-3000");

        foreach (var chunk in post.Chunks) bench.RunJob(chunk);

        Assert.True(post.Chunks.Count > 2);
        var drawn = bench.Record.Select(row => row with { A = row.A - 7000 + 1500, B = row.B + 3000 - 2000 }).ToList();
        AssertCutAsDrawn(toolpath, profile.Scale, drawn);
    }

    [Theory]
    [InlineData(MotionStyle.Calls, "x=0;y=0;JS#LINEAR")]
    [InlineData(MotionStyle.Continuous, "VP 0,0;VP 999999999,0")]
    public async Task A_refused_line_ends_the_job_with_the_tool_off(MotionStyle style, string refused)
    {
        var program = MotionProgramGenerator.Generate(Toolpaths.Paper, HundredCounts, new(0.001, 0.0), null, style).Program!;
        var text = Post(program, 1000).Text;
        var broken = style == MotionStyle.Calls
            ? text.Replace("x=0;y=10000;JS#LINEAR", refused, StringComparison.Ordinal)
            : text.Replace("VP 0,10000;CR 5000,0,180;VP -10000,0", refused, StringComparison.Ordinal);
        await using var bench = new ControllerBench();

        bench.RunJob(broken);

        Assert.NotEqual(text, broken);
        Assert.NotEqual(0.0, bench.Value("_ED"));
        Assert.Equal((15000, 5000, 0), ((int)bench.Value("_RPA"), (int)bench.Value("_RPB"), bench.Status.Outputs));
    }

    private static PostOutput Post(MotionProgram program, int lines)
    {
        var options = DmcPostOptions.Default with { MemoryLines = lines };
        return program.Style == MotionStyle.Calls ? DmcPost.Calls(program, options) : DmcPost.Sequences(program, options);
    }

    private static (Toolpath Toolpath, MachineProfile Profile) Drawing(string job)
    {
        var mirrored = MachineProfile.Default with { Axes = MachineAxes.FromScale(-1000, 1000) };
        var ellipses = MachineProfile.Default with { Axes = MachineAxes.FromScale(1000, 640) };
        return job switch
        {
            "paper" => (Toolpaths.Paper, MachineProfile.Default),
            "paper at 100" => (Toolpaths.Paper, HundredCounts),
            "rings" => (Rings(), MachineProfile.Default),
            "mirrored rings" => (Rings(), mirrored),
            "ellipses" => (Rings(), ellipses),
            "wave" => (Wave(), MachineProfile.Default),
            _ => throw new ArgumentOutOfRangeException(nameof(job)),
        };
    }

    /// <summary>Circles in both directions, an arc with a chord that forms corners, and a slot of lines and half circles.</summary>
    private static Toolpath Rings()
    {
        var sector = Toolpaths.Arc(12.3456, 3.1415, 2.7182, 33.3, 211.1);
        return Toolpaths.OfStrokes(
            [Toolpaths.Arc(3.00031, 2.00047, 1.23456, 180, 360)],
            [Toolpaths.Arc(3.5, 7.77777, 0.5, 0, -360)],
            [sector, Segment.FromLine(sector.End, sector.Start)],
            [Toolpaths.Line(2, 12, 8, 12), Toolpaths.Arc(8, 13, 1, -90, 180), Toolpaths.Line(8, 14, 2, 14), Toolpaths.Arc(2, 13, 1, 90, 180)]);
    }

    /// <summary>700 quarter arcs with smooth joints: more than the buffer holds, without a line that would absorb an error.</summary>
    private static Toolpath Wave() => Toolpaths.OfStroke(
        [.. Enumerable.Range(0, 700).Select(i => i % 2 == 0 ? Toolpaths.Arc(i * 0.13333, 0, 0.13333 / Math.Sqrt(2), 135, -90) : Toolpaths.Arc(i * 0.13333, 0.13333, 0.13333 / Math.Sqrt(2), -135, 90))]);

    /// <summary>All cutting samples are on the drawing, and every point of the drawing is near a cutting sample.</summary>
    internal static void AssertCutAsDrawn(Toolpath toolpath, CountsScale scale, IReadOnlyList<MotionSample> record)
    {
        var drawn = toolpath.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.Segment).ToList();
        var cut = record.Where(row => (row.Outputs & Tool) != 0).Select(row => scale.ToMillimetres(row.A, row.B)).Distinct().ToList();

        var at = 0;
        foreach (var place in cut)
        {
            if (Off(at) > MaxDeviation) at = Enumerable.Range(0, drawn.Count).MinBy(Off);
            Assert.InRange(Off(at), 0.0, MaxDeviation);

            double Off(int segment) => scale.Finer.CountsOf(drawn[segment].DistanceTo(place));
        }

        var reach = scale.Coarser.LengthOf(SampleSpacing);
        var cells = cut.ToLookup(place => Cell(place, reach));
        foreach (var place in drawn.SelectMany(segment => Enumerable.Range(0, 101).Select(i => segment.PointAt(i / 100.0))))
        {
            Assert.Contains(Around(Cell(place, reach)), cell => cells[cell].Any(sample => sample.IsNear(place, reach)));
        }
    }

    private static (int X, int Y) Cell(Point2D place, double size) => ((int)Math.Floor(place.X / size), (int)Math.Floor(place.Y / size));

    private static IEnumerable<(int X, int Y)> Around((int X, int Y) cell) =>
        from x in Enumerable.Range(cell.X - 1, 3) from y in Enumerable.Range(cell.Y - 1, 3) select (x, y);
}
