using System.Text.RegularExpressions;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Galil.Programs.Posting;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Machines;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>A correct program passes, and every corruption is detected.</summary>
public class ProgramVerificationTests
{
    public static TheoryData<string, MotionStyle> Posts
    {
        get
        {
            var posts = new TheoryData<string, MotionStyle>();
            foreach (var path in Directory.GetFiles(RepositoryFolder.Samples, "*.dxf"))
            {
                posts.Add(Path.GetFileNameWithoutExtension(path), MotionStyle.Continuous);
                posts.Add(Path.GetFileNameWithoutExtension(path), MotionStyle.Calls);
            }

            return posts;
        }
    }

    public static TheoryData<MotionStyle> Styles => [MotionStyle.Continuous, MotionStyle.Calls];

    [Theory]
    [MemberData(nameof(Posts))]
    public async Task Every_samples_post_cuts_the_drawing_and_nothing_else(string sample, MotionStyle style)
    {
        var report = await VerifyAsync(sample, Post(sample, style));

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, 0.0035);
        Assert.Equal((0.0035, 0.0, 0.0), (report.ToleranceMm, report.MissingLengthMm, report.ExtraLengthMm));
    }

    /// <summary>A sample of the corpus, posted and verified: real drawings of every size, and difficult or damaged ones. tests/verify-corpus does it for all of
    /// them, with limits of time and memory.</summary>
    [CorpusTheory]
    [InlineData("files", 0, 60_000, 12)]
    [InlineData("files", 60_000, 250_000, 40)]
    [InlineData("files", 250_000, 2_000_000, 50)]
    [InlineData("pathological", 0, 250_000, 4)]
    public async Task A_sample_of_the_corpus_is_cut_as_drawn_or_refused_with_a_reason(string folder, int from, int to, int every)
    {
        var files = Directory.GetFiles(Path.Combine(RepositoryFolder.Corpus!, folder), "*.dxf", SearchOption.AllDirectories)
            .Where(file => new FileInfo(file).Length is var size && size >= from && size < to).Order(StringComparer.Ordinal).Where((_, number) => number % every == 0).ToList();
        Assert.NotEmpty(files);
        foreach (var file in files)
        {
            var drawing = DrawingFile.Open(file, new DrawingSettings(), CancellationToken.None);
            var posted = PostedProgram.Create(drawing, new DrawingSettings(), PostTable.Find("galil").Post, PostedProgram.NoOptions);
            if (posted.Text is not { } text)
            {
                Assert.NotEmpty(posted.Diagnostics);
                continue;
            }

            var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new DmcReader(), drawing, new DrawingSettings(), progress: null, CancellationToken.None);
            Assert.True(report.Ok || drawing.HasErrors, $"{file}: {string.Join(' ', report.Diagnostics.Select(finding => finding.Sentence))}");
            Assert.InRange(report.MaxDeviationMm ?? 0.0, 0.0, report.ToleranceMm);
        }
    }

    /// <summary>Ctrl-C: the stop is requested while the program is being run.</summary>
    [Fact]
    public async Task A_verification_under_way_is_stopped()
    {
        using var stop = new CancellationTokenSource();
        var progress = new StopOnProgress(stop);

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() =>
            ProgramVerification.VerifyAsync(ReadBackFile.FromText(Post("nameplate", MotionStyle.Continuous)), new DmcReader(), Open("nameplate"), new DrawingSettings(), progress, stop.Token));
        Assert.Equal(1, progress.Reports);
    }

    /// <summary>paper-001 takes about ten seconds of machine time, which the simulator does in one slice.</summary>
    [Fact]
    public async Task The_last_report_is_the_end_of_the_program()
    {
        var progress = new LastProgress();

        await ProgramVerification.VerifyAsync(ReadBackFile.FromText(Post("paper-001", MotionStyle.Continuous)), new DmcReader(), Open("paper-001"), new DrawingSettings(), progress, CancellationToken.None);

        Assert.InRange(progress.Value.MachineTime / progress.Value.Expected, 0.9, 1.2);
        Assert.True(progress.Value.Expected > TimeSpan.FromSeconds(1));
    }

    [Theory]
    [MemberData(nameof(Styles))]
    public async Task All_chunks_are_run_one_after_the_other(MotionStyle style)
    {
        var text = Post("nameplate", style, memoryLines: 90);
        var report = await VerifyAsync("nameplate", text);

        Assert.Contains("'CHUNK 2 OF ", text, StringComparison.Ordinal);
        Assert.True(report.Ok);
    }

    [Fact]
    public async Task The_start_point_and_the_machine_of_the_post_are_those_of_the_verification()
    {
        var settings = new DrawingSettings { Start = new Point2D(7.5, -3), Machine = new() { Axes = MachineAxes.FromScale(-400, 400), ToolOutput = 3 } };
        var text = Post("paper-001", MotionStyle.Continuous, settings: settings);

        Assert.True((await VerifyAsync("paper-001", text, settings)).Ok);
        Assert.False((await VerifyAsync("paper-001", text, settings with { Start = default })).Ok);
        Assert.False((await VerifyAsync("paper-001", text)).Ok);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous, "VP 0,100000;", "VP 6,100000;")]
    [InlineData(MotionStyle.Calls, "x=0;y=100000;JS#LINEAR", "x=6;y=100000;JS#LINEAR")]
    public async Task One_coordinate_changed_by_six_counts_is_noticed(MotionStyle style, string good, string bad)
    {
        var settings = new DrawingSettings { CornerToleranceMm = 0.0 };
        var report = await VerifyAsync("paper-001", Replaced(Post("paper-001", style, settings: settings), good, bad), settings);

        Assert.False(report.Ok);
        Assert.Contains(report.Diagnostics, finding => finding.Id == "VER0008");
        Assert.InRange(report.MaxDeviationMm!.Value, 0.005, 0.013);
        Assert.True(report.ExtraLengthMm > 1.0);
    }

    [Fact]
    public async Task A_deleted_stroke_is_missing_with_its_length()
    {
        var job = Prepare("nameplate", MotionStyle.Continuous, new DrawingSettings());
        var last = job.Motion.Program!.Strokes[^1];
        var shorter = job.Motion.Program with { Strokes = [.. job.Motion.Program.Strokes.SkipLast(1)] };
        var report = await VerifyAsync("nameplate", DmcPost.Sequences(shorter, DmcPostOptions.Default).Text);

        var length = last.Sequences.Sum(sequence => sequence.Length) / 1000.0;
        Assert.False(report.Ok);
        Assert.Equal("VER0009", Assert.Single(report.Diagnostics).Id);
        Assert.InRange(report.MissingLengthMm, 0.95 * length, 1.05 * length);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous, "SB1;")]
    [InlineData(MotionStyle.Calls, "JS#TOOLON\n")]
    public async Task A_tool_that_is_not_switched_on_cuts_nothing(MotionStyle style, string toolOn)
    {
        var report = await VerifyAsync("paper-001", Replaced(Post("paper-001", style), toolOn, ""));

        Assert.False(report.Ok);
        Assert.Null(report.MaxDeviationMm);
        Assert.True(report.MissingLengthMm > 400.0);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous, "\nCB1;WT 100\n")]
    [InlineData(MotionStyle.Calls, "JS#TOOLOFF\n")]
    public async Task A_tool_that_stays_on_in_a_rapid_is_noticed(MotionStyle style, string toolOff)
    {
        var report = await VerifyAsync("nameplate", Replaced(Post("nameplate", style), toolOff, "\n"));

        Assert.False(report.Ok);
        Assert.True(report.ExtraLengthMm > 1.0);
    }

    [Theory]
    [InlineData("", "VER0001", 0)]
    [InlineData("\n \n", "VER0001", 0)]
    [InlineData("%\nG0 X1 Y2\nM30\n", "VER0002", 1)]
    [InlineData("#JOB\nFROBNICATE 3\nEN\n", "VER0006", 2)]
    [InlineData("'a comment\n#JOB\nSHAB\n\nVP 1,1\nEN\n", "VER0006", 5)]
    [InlineData("#JOB\nJP#JOB\nEN\n", "VER0007", 1)]
    [InlineData("#JOB\nAI -1\nEN\n", "VER0007", 1)]
    [InlineData("#JOB\nSHAB\nJGA=1000\nBGA\nEN\n", "VER0007", 1)]
    [InlineData("#JOB\nSB1\nCB1\nJP#JOB\nEN\n", "VER0007", 1)]
    [InlineData("#JOB\nSHAB\nVMAB\nVP 1000,0\nBGS\nEN\n", "VER0007", 1)]
    [InlineData("#JOB\n#JOB\nEN\n", "VER0005", 1)]
    [InlineData("#JOB\nMG \"a\\b\"\nEN\n", "VER0004", 2)]
    [InlineData("'CHUNK 1 OF 2\n#JOB\nEN\n", "VER0003", 3)]
    [InlineData("'CHUNK 2 OF 2\n#JOB\nEN\n", "VER0003", 1)]
    [InlineData("#JOB\nEN\n'CHUNK 1 OF 1\n#JOB\nEN\n", "VER0003", 3)]
    [InlineData("'CHUNK 1 OF 2\n#JOB\nEN\n'CHUNK 2 OF 2\nEN\n", "VER0002", 4)]
    public async Task A_program_that_cannot_run_to_its_end_is_one_finding_at_its_line(string text, string id, long line)
    {
        var report = await VerifyAsync("paper-001", text);

        Assert.False(report.Ok);
        var finding = Assert.Single(report.Diagnostics);
        Assert.Equal((id, line), (finding.Id, finding.Source.Line));
    }

    [Fact]
    public async Task Lines_and_programs_that_are_too_long_are_named()
    {
        var line = await VerifyAsync("paper-001", $"#JOB\nMG \"{new string('x', 90)}\"\nEN\n");
        var program = await VerifyAsync("paper-001", "#JOB\n" + string.Concat(Enumerable.Repeat("NO\n", 1200)));

        Assert.Equal(("VER0004", 2), (line.Diagnostics[0].Id, line.Diagnostics[0].Source.Line));
        Assert.Equal("VER0005", program.Diagnostics[0].Id);
    }

    [Fact]
    public async Task A_job_that_cuts_round_and_round_is_given_up()
    {
        var report = await VerifyAsync("paper-001", Replaced(Post("paper-001", MotionStyle.Continuous), "MG \"DONE\"", "JP#JOB"));

        Assert.Equal("VER0007", Assert.Single(report.Diagnostics).Id);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous, 0.0)]
    [InlineData(MotionStyle.Continuous, 0.0095)]
    [InlineData(MotionStyle.Calls, 0.0095)]
    [InlineData(MotionStyle.Continuous, -0.009)]
    public async Task A_gap_that_the_join_tolerance_bridges_is_allowed_for_and_nothing_else_is(MotionStyle style, double aside)
    {
        var slow = new DrawingSettings { FitArcs = false, Machine = new() { FeedMmPerMinute = 60 } }; // One count per sample: the middle of the bridge is among them.
        var drawing = new DrawingBuilder().Line(0, 0, 10, 0).Line(10.003, aside, 20, aside).Line(0, 5, 10, 5).Build();
        var motion = JobPreparation.Prepare(drawing, slow, style).Motion.Program!;
        var text = style == MotionStyle.Calls ? DmcPost.Calls(motion, DmcPostOptions.Default).Text : DmcPost.Sequences(motion, DmcPostOptions.Default).Text;
        var good = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new DmcReader(), drawing, slow, progress: null, CancellationToken.None);
        var bad = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(Replaced(text, style == MotionStyle.Calls ? "x=10000;y=0" : "VP 10000,0", style == MotionStyle.Calls ? "x=10000;y=6" : "VP 10000,6")), new DmcReader(), drawing, slow, progress: null, CancellationToken.None);

        Assert.Empty(good.Diagnostics);
        Assert.True(good.Ok);
        Assert.InRange(good.MaxDeviationMm!.Value, 0.8 * Math.Abs(aside) / 2.0, good.ToleranceMm);
        Assert.InRange(good.ToleranceMm, 0.0035, 0.0035 + 0.005);
        Assert.False(bad.Ok);
    }

    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public async Task A_program_made_to_be_started_away_from_the_drawings_zero_cuts_the_drawing_from_there_and_from_nowhere_else(MotionStyle style)
    {
        var away = new DrawingSettings { Start = new Point2D(-31.25, 62.5) };
        var text = Post("gasket", style, settings: away);

        Assert.True((await VerifyAsync("gasket", text, away)).Ok);
        foreach (var start in new Point2D[] { new(-31.25, 62.51), new(-31.24, 62.5), new(31.25, 62.5), default })
        {
            var elsewhere = await VerifyAsync("gasket", text, away with { Start = start });
            Assert.False(elsewhere.Ok);
            Assert.Contains(elsewhere.Diagnostics, finding => finding.Id is "VER0008" or "VER0009");
        }
    }

    [Fact]
    public async Task A_drawing_that_cannot_be_read_is_never_ok()
    {
        var drawing = DrawingFile.Open("nowhere.dxf", new DrawingSettings(), CancellationToken.None);
        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(Post("paper-001", MotionStyle.Calls)), new DmcReader(), drawing, new DrawingSettings(), progress: null, CancellationToken.None);

        Assert.False(report.Ok);
        Assert.Null(report.MaxDeviationMm);
    }

    private static string Replaced(string text, string good, string bad)
    {
        Assert.Contains(good, text, StringComparison.Ordinal);
        return new Regex(Regex.Escape(good)).Replace(text, bad, 1);
    }

    private static Task<VerificationReport> VerifyAsync(string sample, string text, DrawingSettings? settings = null) =>
        ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new DmcReader(), Open(sample), settings ?? new DrawingSettings(), progress: null, CancellationToken.None);

    private static string Post(string sample, MotionStyle style, int memoryLines = 1000, DrawingSettings? settings = null)
    {
        var program = Prepare(sample, style, settings ?? new DrawingSettings()).Motion.Program!;
        var options = DmcPostOptions.Default with { MemoryLines = memoryLines };
        return style == MotionStyle.Calls ? DmcPost.Calls(program, options).Text : DmcPost.Sequences(program, options).Text;
    }

    private static PreparedJob Prepare(string sample, MotionStyle style, DrawingSettings settings) => JobPreparation.Prepare(Open(sample), settings, style);

    private static Drawing Open(string sample) => DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), new DrawingSettings(), CancellationToken.None);

    private sealed class LastProgress : IProgress<ReplayProgress>
    {
        public ReplayProgress Value { get; private set; }

        public void Report(ReplayProgress value) => Value = value;
    }

    private sealed class StopOnProgress(CancellationTokenSource stop) : IProgress<ReplayProgress>
    {
        public int Reports { get; private set; }

        public void Report(ReplayProgress value)
        {
            Reports++;
            stop.Cancel();
        }
    }
}
