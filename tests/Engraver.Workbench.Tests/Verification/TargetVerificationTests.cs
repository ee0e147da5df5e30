using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Programs of each plain-text target for the samples are read back as exactly the drawing.</summary>
public class TargetVerificationTests
{
    private static readonly string[] s_targets = ["cldata", "gcode", "gcode grbl", "hpgl", "hpgl 1000", "hpgl aa", "xps-linearc", "xps-spline", "xps-pvt"];

    private static readonly string[] s_samples = [.. Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(path => Path.GetFileNameWithoutExtension(path)!).Order(StringComparer.Ordinal)];

    public static TheoryData<string, string> Pairs
    {
        get
        {
            var pairs = new TheoryData<string, string>();
            foreach (var (sample, target, _) in TestExtent.IsFull ? TestExtent.Crossed(s_samples, s_targets, [0]) : s_targets.Select((target, number) => (target.StartsWith("xps", StringComparison.Ordinal) ? "paper-001" : s_samples[number % s_samples.Length], target, 0))) pairs.Add(sample, target);
            return pairs;
        }
    }

    [Theory]
    [MemberData(nameof(Pairs))]
    public async Task Every_samples_program_cuts_the_drawing_and_nothing_else(string sample, string target)
    {
        var drawing = DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), new DrawingSettings(), CancellationToken.None);
        var report = await VerifyAsync(drawing, new DrawingSettings(), target);

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, target switch { "hpgl" or "hpgl aa" => 0.025, "hpgl 1000" => 0.0025, "cldata" => 0.00002, _ => 0.0021 });
        Assert.Equal((0.0, 0.0), (report.MissingLengthMm, report.ExtraLengthMm));
        if (target.StartsWith("gcode", StringComparison.Ordinal)) Assert.Equal((1200.0, 1200.0), (report.SlowestMmPerMinute, report.FastestMmPerMinute));
    }

    [Theory]
    [InlineData("gcode", "")]
    [InlineData("gcode", "grbl")]
    public async Task A_part_with_two_depths_and_a_ramp_is_cut_by_G_code_at_its_heights(string target, string dialect)
    {
        var settings = Milling(depthPerPass: 0.9);
        var report = await VerifyAsync(Part(), settings, $"{target} {dialect}".TrimEnd());

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, 0.001);
        Assert.Equal(-2.0, report.LowestZMm!.Value, 1e-9);
        Assert.Equal((0.0, 0.0), (report.MissingLengthMm, report.ExtraLengthMm));
    }

    [Theory]
    [InlineData("Z-2 F", "Z-1.98 F", "VER0008")] // not deep enough
    [InlineData("Z-2 F", "Z-2.01 F", "VER0008")] // too deep
    [InlineData("F240", "F1200", "VER0010")] // plunges at the feed
    [InlineData("F1200", "F1210", "VER0010")]
    [InlineData("G1 Z", "G0 Z", "VER0010")] // a rapid into the work
    [InlineData("G0 Z1\n", "G0 Z-1\n", "VER0010")]
    public async Task Another_height_or_feed_is_no_faithful_program(string was, string becomes, string id)
    {
        var settings = Milling(depthPerPass: null);
        var text = PostedProgram.Create(Part(), settings, PostTable.Find("gcode").Post, PostedProgram.NoOptions).Text!;
        Assert.Contains(was, text, StringComparison.Ordinal);
        var report = await VerifyAsync(Part(), settings, text.Replace(was, becomes, StringComparison.Ordinal), PostTable.Find("gcode").Reader!);

        Assert.False(report.Ok);
        Assert.Contains(report.Diagnostics, finding => finding.Id == id);
    }

    /// <summary>Map coordinates: each format has its own limits, and only the Galil targets have 32-bit counts.</summary>
    [Theory]
    [InlineData("galil", true)]
    [InlineData("galil-calls", true)]
    [InlineData("agie", true)]
    [InlineData("agie", false)]
    [InlineData("cldata", false)]
    [InlineData("xps-linearc", false)]
    [InlineData("xps-spline", false)]
    [InlineData("xps-pvt", false)]
    public async Task A_drawing_far_from_its_zero_is_cut_from_a_start_beside_it(string target, bool isStartNear)
    {
        const double X = 3_500_000.0, Y = 5_400_000.0;
        var drawing = new DrawingBuilder().Line(X, Y, X + 20, Y).Arc(X + 20, Y + 5, 5, 270, 90).Line(X + 20, Y + 10, X, Y + 10).Line(X, Y + 10, X, Y).Circle(X + 10, Y + 5, 3).Build();
        var report = await VerifyAsync(drawing, new DrawingSettings { Start = isStartNear ? new Point2D(X - 1.0, Y) : default }, target);

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, 0.0021);
    }

    [Fact]
    public async Task A_plunge_feed_above_the_feed_is_right_straight_down_and_nowhere_else()
    {
        var settings = Milling(depthPerPass: null);
        settings = settings with { Machine = settings.Machine with { FeedMmPerMinute = 150.0 } };
        var text = PostedProgram.Create(Part(), settings, PostTable.Find("gcode").Post, PostedProgram.NoOptions).Text!;

        Assert.Contains("F240", text, StringComparison.Ordinal);
        Assert.True((await VerifyAsync(Part(), settings, text, PostTable.Find("gcode").Reader!)).Ok);
        Assert.False((await VerifyAsync(Part(), settings, text.Replace("F150", "F240", StringComparison.Ordinal), PostTable.Find("gcode").Reader!)).Ok);
    }

    [Theory]
    [InlineData("agie")]
    [InlineData("hpgl")]
    [InlineData("xps-linearc")]
    [InlineData("cldata")]
    public async Task A_form_without_heights_is_compared_in_plan_on_a_machine_with_a_tool_axis(string target)
    {
        var report = await VerifyAsync(Part(), Milling(depthPerPass: null), target);

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
    }

    /// <summary>Corners are rounded by P, and lines joined within the same tolerance (rs274-hpgl.md 1.4).</summary>
    [Theory]
    [InlineData("0.05", 0.0, "VER0011", 0.1)]
    [InlineData("0.05", 0.04, "VER0011", 0.1)]
    [InlineData("0.05", 0.05, "", 0.1)]
    [InlineData("0.0015", 0.0, "", 0.003)] // within what is allowed anyway
    [InlineData("0", 0.05, "", 0.0)]
    public async Task How_far_the_controller_may_round_corners_is_part_of_the_deviation_and_allowed_where_it_was_asked_for(string written, double allowed, string finding, double blend)
    {
        var (drawing, settings, entry) = (Plate(), new DrawingSettings(), PostTable.Find("gcode"));
        var text = PostedProgram.Create(drawing, settings, entry.Post, new Dictionary<string, string> { ["blend"] = written }).Text!;
        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), entry.Reader!, drawing, settings, progress: null, CancellationToken.None, new PostParameters { BlendMm = allowed });

        Assert.Equal(finding, string.Join(' ', report.Diagnostics.Select(found => found.Id)));
        Assert.Equal((finding.Length == 0, blend), (report.Ok, report.BlendMm));
        Assert.Equal(blend, report.MaxDeviationMm!.Value, 1e-5);
        Assert.Equal(0.0035 + (2.0 * allowed), report.ToleranceMm, 1e-9);
    }

    [Theory]
    [InlineData("G61", "G64")]
    [InlineData(" G61", "")] // as the controller starts
    public async Task A_program_that_sets_no_bound_to_rounding_is_not_ok_and_its_deviation_is_not_known(string was, string becomes)
    {
        var (drawing, entry) = (Plate(), PostTable.Find("gcode"));
        var text = PostedProgram.Create(drawing, new DrawingSettings(), entry.Post, PostedProgram.NoOptions).Text!;
        var unbounded = text.Replace(was, becomes, StringComparison.Ordinal);
        var report = await VerifyAsync(drawing, new DrawingSettings(), unbounded, entry.Reader!);

        var found = Assert.Single(report.Diagnostics);
        Assert.Equal(("VER0012", unbounded.Split('\n').ToList().FindIndex(line => line is ['G', >= '1' and <= '3', ' ', ..]) + 1), (found.Id, found.Source.Line));
        Assert.Equal((false, null, null), (report.Ok, report.MaxDeviationMm, report.BlendMm));
        Assert.True((await VerifyAsync(drawing, new DrawingSettings(), text.Replace("\n%\n", "\n", StringComparison.Ordinal).Replace("%\n", "", StringComparison.Ordinal).Replace(was, becomes.Replace("G64", "G61", StringComparison.Ordinal), StringComparison.Ordinal), entry.Dialects["grbl"])).Ok); // grbl does not round corners.
    }

    public static TheoryData<string> Targets => [.. PostTable.All.Select(entry => entry.Post.Name)];

    /// <summary>CL data names both ends of each move, so that a move may be too short, or a rapid missing, and the next begins as it should.</summary>
    [Theory]
    [InlineData(0.6, 0.01, false)]
    [InlineData(0.6, 1.0, false)] // the tolerance joins ends of the drawing, which has no gap here
    [InlineData(0.001, 0.01, true)]
    public async Task Cl_data_with_a_gap_between_two_cuts_is_ok_only_within_the_tolerance(double gap, double joinTolerance, bool isOk)
    {
        var settings = new DrawingSettings { JoinToleranceMm = joinTolerance };
        var text = PostedProgram.Create(Plate(), settings, PostTable.Find("cldata").Post, PostedProgram.NoOptions).Text!;
        var ends = "\n11\n20.0\n21\n0.0\n";
        Assert.Contains(ends, text, StringComparison.Ordinal);
        var report = await VerifyAsync(Plate(), settings, text.Replace(ends, FormattableString.Invariant($"\n11\n{20.0 - gap}\n21\n0.0\n"), StringComparison.Ordinal), PostTable.Find("cldata").Reader!);

        Assert.Equal(isOk, report.Ok);
        Assert.Equal(isOk ? [] : ["VER0013"], report.Diagnostics.Select(finding => finding.Id));
        if (!isOk) Assert.InRange(report.MissingLengthMm, 0.59, 0.61);
    }

    [Theory]
    [InlineData(0.01, false)]
    [InlineData(1.0, true)] // one stroke, which runs across
    public async Task Cl_data_cuts_across_a_gap_of_the_drawing_only_where_the_join_tolerance_does(double joinTolerance, bool isOk)
    {
        var drawing = new DrawingBuilder().Line(0, 0, 20, 0).Line(20.6, 0, 20.6, 10).Build();
        var settings = new DrawingSettings { JoinToleranceMm = joinTolerance };
        var text = PostedProgram.Create(drawing, settings, PostTable.Find("cldata").Post, PostedProgram.NoOptions).Text!;
        var withoutRapids = string.Join("\n0\n", text.Split("\n0\n").Where(entity => !entity.StartsWith("LINE", StringComparison.Ordinal) || !entity.Contains("RAPID", StringComparison.Ordinal)));

        Assert.True((await VerifyAsync(drawing, settings, text, PostTable.Find("cldata").Reader!)).Ok);
        Assert.Equal(isOk, (await VerifyAsync(drawing, settings, withoutRapids, PostTable.Find("cldata").Reader!)).Ok);
    }

    [Theory]
    [MemberData(nameof(Targets))]
    public async Task Line_ends_of_Windows_and_of_old_Macintoshes_mean_the_same(string target)
    {
        var (drawing, entry) = (Plate(), PostTable.Find(target));
        var text = PostedProgram.Create(drawing, new DrawingSettings(), entry.Post, PostedProgram.NoOptions).Text!;
        var usual = await VerifyAsync(drawing, new DrawingSettings(), text, entry.Reader!);
        foreach (var end in (string[])["\r\n", "\r"])
        {
            var report = await VerifyAsync(drawing, new DrawingSettings(), text.Replace("\n", end, StringComparison.Ordinal), entry.Reader!);
            Assert.True(report.Ok, target + string.Join(' ', report.Diagnostics.Select(finding => finding.Sentence)));
            Assert.Equal(usual.MaxDeviationMm, report.MaxDeviationMm);
        }
    }

    [Theory]
    [MemberData(nameof(Targets))]
    public async Task An_empty_file_half_a_program_and_the_program_of_another_drawing_are_not_ok(string target)
    {
        var (drawing, entry) = (Plate(), PostTable.Find(target));
        string Text(Drawing of) => PostedProgram.Create(of, new DrawingSettings(), entry.Post, PostedProgram.NoOptions).Text!;
        var whole = Text(drawing);
        var other = Text(new DrawingBuilder().Line(0, 0, 20, 0).Line(20, 0, 20, 10).Line(20, 10, 0, 10.1).Line(0, 10.1, 0, 0).Circle(10, 5, 3).Build());

        foreach (var bad in (string[])["", "\n", whole[..(whole.Length / 2)], other])
        {
            var report = await VerifyAsync(drawing, new DrawingSettings(), bad, entry.Reader!);
            Assert.False(report.Ok);
            Assert.NotEmpty(report.Diagnostics);
            if (bad.Length == 0) Assert.Equal("VER0001", report.Diagnostics[0].Id);
        }
    }

    private static Drawing Plate() => new DrawingBuilder().Line(0, 0, 20, 0).Line(20, 0, 20, 10).Line(20, 10, 0, 10).Line(0, 10, 0, 0).Circle(10, 5, 3).Build();

    private static async Task<VerificationReport> VerifyAsync(Drawing drawing, DrawingSettings settings, string targetAndChoice)
    {
        var words = targetAndChoice.Split(' ');
        var entry = PostTable.Find(words[0]);
        var options = words.Length == 1 ? PostedProgram.NoOptions : new Dictionary<string, string> { [words[1] switch { "grbl" => "dialect", "aa" => "arcs", _ => "units-per-mm" }] = words[1] };
        var posted = PostedProgram.Create(drawing, settings, entry.Post, options);
        Assert.True(posted.Text is not null, string.Join('\n', posted.Diagnostics.Select(finding => finding.Sentence)));
        return await VerifyAsync(drawing, settings, posted.Text, words is [_, "grbl"] ? entry.Dialects["grbl"] : entry.Reader!);
    }

    private static Task<VerificationReport> VerifyAsync(Drawing drawing, DrawingSettings settings, string text, IProgramReader reader) =>
        ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), reader, drawing, settings, progress: null, CancellationToken.None);

    private static DrawingSettings Milling(double? depthPerPass)
    {
        var mill = MachineProfileSource.Load(Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        return new DrawingSettings { Machine = mill with { Height = mill.Height! with { DepthPerPass = depthPerPass } } };
    }

    /// <summary>A line with an arc 1 mm deep, a circle 2 mm deep, and a ramp from 0.5 mm down to 2 mm.</summary>
    private static Drawing Part()
    {
        (int, object)[] arc = [(0, "ARC"), (8, "0"), (10, 35.0), (20, 10.0), (30, -1.0), (40, 5.0), (50, 270.0), (51, 0.0)];
        (int, object)[] circle = [(0, "CIRCLE"), (8, "0"), (10, 15.0), (20, 15.0), (30, -2.0), (40, 4.0)];
        var file = Path.Combine(Path.GetTempPath(), $"engraver-{Guid.NewGuid():N}.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities([.. Line(5, 5, -1, 35, 5, -1), .. arc, .. circle, .. Line(25, 10, -0.5, 35, 14, -2)]).ToAscii());
        var drawing = DrawingFile.Open(file, new DrawingSettings(), CancellationToken.None);
        File.Delete(file);
        return drawing;
    }

    private static (int Code, object Value)[] Line(double x1, double y1, double z1, double x2, double y2, double z2) =>
        [(0, "LINE"), (8, "0"), (10, x1), (20, y1), (30, z1), (11, x2), (21, y2), (31, z2)];
}
