using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Verification;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>A program is read incrementally: for every target at most a line, a command or one block is read ahead of the motion. So memory does not grow with
/// its length.</summary>
public class LongProgramTests
{
    /// <summary>Maximum characters read ahead: a file buffer and a hundred lines of a controller's program.</summary>
    private const int MostAhead = 16_384;

    private static readonly Lazy<Drawing> s_zigzag = new(() => Zigzag(4000));

    public static TheoryData<string> Targets => [.. PostTable.All.Select(entry => entry.Post.Name)];

    [Theory]
    [MemberData(nameof(Targets))]
    public async Task No_more_is_read_ahead_of_the_motions_than_is_needed_for_the_next(string target)
    {
        var entry = PostTable.Find(target);
        var options = target.StartsWith("galil", StringComparison.Ordinal) ? new Dictionary<string, string> { ["memory"] = "100" } : PostedProgram.NoOptions;
        var text = PostedProgram.Create(s_zigzag.Value, new DrawingSettings(), entry.Post, options).Text!;
        using var program = new CountedText(text);
        var judge = new FarthestAhead(program);

        Assert.Empty(await entry.Reader!.ReplayAsync(program, Request(judge), progress: null, CancellationToken.None));
        Assert.True(text.Length > 2 * MostAhead, $"{target}: {text.Length} characters show nothing");
        Assert.InRange(judge.Most, 1, MostAhead);
    }

    [Fact]
    public async Task Places_of_one_plotter_command_are_told_while_it_is_read()
    {
        using var program = new CountedText("IN;SP1;PU0,0;PD" + string.Join(',', Enumerable.Range(1, 20_000).Select(i => $"{i % 7 * 40},{i % 11 * 40}")) + ";PU;");
        var judge = new FarthestAhead(program);

        Assert.Empty(await PostTable.Find("hpgl").Reader!.ReplayAsync(program, Request(judge), progress: null, CancellationToken.None));
        Assert.InRange(judge.Most, 1, MostAhead);
    }

    [Theory]
    [InlineData("gcode")]
    [InlineData("galil")]
    [InlineData("cldata")]
    [InlineData("agie")]
    [InlineData("hpgl")]
    [InlineData("xps-linearc")]
    public async Task A_line_without_an_end_is_not_gathered(string target)
    {
        using var program = new EndlessLine();
        var report = await ProgramVerification.VerifyAsync(new ReadBackFile(() => program), PostTable.Find(target).Reader!, s_zigzag.Value, new DrawingSettings(), progress: null, CancellationToken.None);

        Assert.False(report.Ok);
        Assert.Equal(target == "hpgl" ? "PST0001" : "DOC0001", Assert.Single(report.Diagnostics).Id);
        Assert.InRange(program.Count, 1, 100_000);
    }

    [Theory]
    [MemberData(nameof(Targets))]
    public async Task A_file_that_breaks_off_while_it_is_read_is_one_finding(string target)
    {
        var entry = PostTable.Find(target);
        var text = PostedProgram.Create(s_zigzag.Value, new DrawingSettings(), entry.Post, PostedProgram.NoOptions).Text!;
        var report = await ProgramVerification.VerifyAsync(new ReadBackFile(() => new CountedText(text) { BreaksAt = text.Length / 2 }), entry.Reader!, s_zigzag.Value, new DrawingSettings(), progress: null, CancellationToken.None);

        Assert.False(report.Ok);
        Assert.Equal("DOC0001", Assert.Single(report.Diagnostics).Id);
    }

    private static ReplayRequest Request(ITraceJudge judge) => new(MachineProfile.Default, default, TimeSpan.FromHours(1), TimeSpan.FromHours(1), [judge]) { Entry = default };

    /// <summary>One open contour with a corner every millimetre.</summary>
    private static Drawing Zigzag(int lines)
    {
        var drawing = new DrawingBuilder();
        for (var i = 0; i < lines; i++) drawing.Line(i * 0.5, i % 2, (i + 1) * 0.5, (i + 1) % 2);
        return drawing.Build();
    }

    /// <summary>Maximum number of characters read between two motions.</summary>
    private sealed class FarthestAhead(CountedText program) : ITraceJudge
    {
        private int _before;

        public int Most { get; private set; }

        public void Add(in TraceSample sample) => Look();

        public void Add(in TraceSpan span) => Look();

        public TraceVerdict Verdict() => throw new NotSupportedException();

        private void Look() => (Most, _before) = (Math.Max(Most, program.Count - _before), program.Count);
    }

    /// <summary>Counts the characters read.</summary>
    private sealed class CountedText(string text) : TextReader
    {
        public int Count { get; private set; }

        /// <summary>Fails after this number of characters.</summary>
        public int BreaksAt { get; init; } = int.MaxValue;

        public override int Peek() => Count < text.Length ? text[At()] : -1;

        public override int Read() => Count < text.Length ? text[Next()] : -1;

        private int At() => Count < BreaksAt ? Count : throw new IOException("the disk is gone");

        private int Next() => At() is var at && Count++ >= 0 ? at : -1;
    }

    private sealed class EndlessLine : TextReader
    {
        public int Count { get; private set; }

        public override int Peek() => '1';

        public override int Read()
        {
            Count++;
            return '1';
        }
    }
}
