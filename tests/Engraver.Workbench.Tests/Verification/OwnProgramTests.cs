using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>For any drawing, machine and post options: verification with the same parameters accepts a posted program, and rejects one with another feed, wait
/// or position.</summary>
public class OwnProgramTests
{
    private static readonly string[] s_targets = ["galil", "galil-calls", "galil", "galil-calls", "galil", "galil-calls", "galil", "galil-calls", "cldata", "agie", "gcode", "gcode grbl", "hpgl", "xps-linearc", "xps-spline", "xps-pvt"];

    public static TheoryData<int> Seeds => [.. Enumerable.Range(0, TestExtent.Cases(perCommit: 8, full: 60, "ENGRAVER_OWN_PROGRAMS"))];

    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task No_program_that_was_posted_is_refused(int seed)
    {
        var refused = new List<string>();
        foreach (var (target, number) in s_targets.Select((target, number) => (target, number)))
        {
            var job = RandomJob.Of(new Random((seed * s_targets.Length) + number), target);
            if (job.Post() is not { } text) continue;
            var report = await job.VerifyAsync(text);
            if (!report.Ok) refused.Add($"{job}: {string.Join(' ', report.Diagnostics.Select(finding => $"{finding.Id} {finding.Sentence}"))} Extra: {report.ExtraLengthMm} mm.");
        }

        Assert.True(refused.Count == 0, string.Join('\n', refused));
    }

    /// <summary>Also split into parts, between strokes and inside one.</summary>
    [Theory]
    [InlineData("galil", "VS 20000", "VS 20600")]
    [InlineData("galil", "VS 20000;VA 256000", "VS 20000;VA 128000")]
    [InlineData("galil", ";SB1;WT 100", ";SB1;WT 200")]
    [InlineData("galil", ";SB1;WT 100", ";SB1;WT 10")]
    [InlineData("galil", "VE;BGS;AMS\n", "VE;BGS;AMS\nCB1;WT 100;SB1;WT 100\n")] // lifts where no part ends
    [InlineData("galil", "VE;BGS;AMS\n", "VE;BGS;AMS\nWT 100\n")]
    [InlineData("galil-calls", "f=20000", "f=20600")]
    [InlineData("galil-calls", "SB1;WT 100", "SB1;WT 200")]
    [InlineData("galil-calls", "JS#LINEAR\n", "JS#LINEAR\nJS#TOOLOFF\nJS#TOOLON\n")]
    [InlineData("galil-calls", "JS#LINEAR\n", "JS#LINEAR\nWT 100\n")]
    public async Task Another_speed_or_wait_is_noticed_in_each_part_of_a_program_whose_strokes_were_cut(string target, string was, string becomes)
    {
        var job = new RandomJob(target, Zigzag(), new DrawingSettings { CornerToleranceMm = 0.0 }, new Dictionary<string, string> { ["memory"] = "100" });
        var text = job.Post()!;
        var parts = text.Split("'CHUNK").Length - 1;
        Assert.InRange(parts, 2, 9);
        Assert.True((await job.VerifyAsync(text)).Ok);
        for (var part = 1; part <= parts; part++)
        {
            var from = text.IndexOf($"'CHUNK {part} OF", StringComparison.Ordinal);
            var at = text.IndexOf(was, from, StringComparison.Ordinal);
            var next = text.IndexOf("'CHUNK", from + 1, StringComparison.Ordinal);
            Assert.InRange(at, from, next < 0 ? text.Length : next);
            var report = await job.VerifyAsync(text[..at] + becomes + text[(at + was.Length)..]);

            Assert.False(report.Ok, $"part {part}");
            Assert.Equal("VER0015", Assert.Single(report.Diagnostics).Id);
        }
    }

    /// <summary>Arcs with a radius beyond the controller's limit become chords, more than its memory can hold.</summary>
    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    public async Task A_circle_that_is_cut_in_many_parts_is_the_job(string target)
    {
        var job = new RandomJob(target, new DrawingBuilder().Circle(0, 0, 20_000).Build(), new DrawingSettings { Machine = new MachineProfile { FeedMmPerMinute = 60_000 } }, PostedProgram.NoOptions);
        var report = await job.VerifyAsync(job.Post()!);

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
    }

    private static Drawing Zigzag()
    {
        var drawing = new DrawingBuilder();
        for (var i = 0; i < 60; i++) drawing.Line(i, i % 2 * 8, i + 1, (i + 1) % 2 * 8);
        return drawing.Build();
    }
}
