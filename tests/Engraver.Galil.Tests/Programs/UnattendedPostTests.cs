using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Posting;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Programs;

/// <summary>Posts that run from the controller's memory without a host: started by XQ, and then nothing more is sent to the controller.</summary>
public class UnattendedPostTests
{
    private const byte Tool = 1;
    private const byte Spindle = 1 << 2;

    private static readonly DmcPostOptions s_unattended = DmcPostOptions.Default with { Unattended = true };

    private static readonly MachineProfile s_mill = MachineProfile.Default with
    {
        Axes = new MachineAxes(new MachineAxis('A', 1000.0), new MachineAxis('B', 1000.0), new MachineAxis('C', 800.0)),
        Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, CutDepth = 0.5, PlungeMmPerMinute = 240.0 },
        Spindle = new Spindle { Output = 3, SpinUpSeconds = 1.5 },
    };

    public static TheoryData<MotionStyle> Styles => [MotionStyle.Calls, MotionStyle.Continuous];

    [Theory]
    [MemberData(nameof(Styles))]
    public async Task The_drawing_is_cut_though_no_host_is_heard_for_longer_than_a_watchdog_waits(MotionStyle style)
    {
        await using var bench = new ControllerBench();
        bench.RunJob(Post(Slot(), MachineProfile.Default, style, s_unattended).Text);

        Assert.True(bench.Record.Count > 3000);
        AssertEnded(bench);
        Assert.Equal(0.0, bench.Value("_ED"));
        PostInControllerTests.AssertCutAsDrawn(Slot(), MachineProfile.Default.Scale, bench.Record);
    }

    [Theory]
    [MemberData(nameof(Styles))]
    public async Task An_origin_that_is_given_is_where_the_drawing_is_cut_from_wherever_the_machine_stands(MotionStyle style)
    {
        var slot = Slot() with { ToolStart = new Point2D(1.5, -2) };
        await using var bench = new ControllerBench();
        bench.Do("DP 7000,-3000");
        bench.RunJob(Post(slot, MachineProfile.Default, style, s_unattended with { Origin = new PostOrigin(2000, -1000, null) }).Text);

        AssertEnded(bench);
        PostInControllerTests.AssertCutAsDrawn(slot, MachineProfile.Default.Scale, [.. bench.Record.Select(row => row with { A = row.A - 2000, B = row.B + 1000 })]);
    }

    [Theory]
    [MemberData(nameof(Styles))]
    public async Task A_mill_spins_up_before_it_plunges_cuts_at_its_depth_and_ends_up_with_the_spindle_off(MotionStyle style)
    {
        await using var bench = new ControllerBench();
        bench.Do("DP 0,0,-500");
        bench.RunJob(Post(Slot(), s_mill, style, s_unattended with { Origin = new PostOrigin(0, 0, 1600) }).Text);

        List<MotionSample> record = [.. bench.Record.SkipWhile(row => row.C < 1600 + 3200)];
        var spun = record.First(row => (row.Outputs & Spindle) != 0).Sample;
        var plunged = record.First(row => row.C < 1600).Sample;
        AssertEnded(bench);
        Assert.True(plunged - spun >= 1500);
        Assert.Equal((1600 - 400, 1600 + 3200), (record.Min(row => row.C), record[^1].C));
        Assert.All(record.Where(row => row.C < 1600), row => Assert.NotEqual(0, row.Outputs & Spindle));
    }

    [Theory]
    [InlineData(MotionStyle.Calls, "limit")]
    [InlineData(MotionStyle.Continuous, "limit")]
    [InlineData(MotionStyle.Calls, "motor")]
    [InlineData(MotionStyle.Continuous, "motor")]
    [InlineData(MotionStyle.Continuous, "message")]
    public async Task Whatever_happens_the_tool_goes_off_everything_stops_and_the_job_has_ended(MotionStyle style, string fault)
    {
        await using var bench = new ControllerBench();
        var text = Post(Slot(), MachineProfile.Default, style, s_unattended).Text;
        var lost = fault == "message" ? bench.Controller.OpenConnection() : null;
        if (lost is not null)
        {
            lost.Write("CFI\r"u8);
            await lost.DisposeAsync();
            text = text.Replace("#ROOM\n", "#ROOM\nEN\n#TALK\nWT 400\nMG \"ALIVE\"\nEN\n", StringComparison.Ordinal).Replace("XQ#WDOG,1\n", "XQ#WDOG,1;XQ#TALK,2\n", StringComparison.Ordinal);
        }

        bench.Download(text);
        bench.Do("ERA=500;ERB=500");
        bench.Do("XQ#JOB");
        if (lost is null)
        {
            Assert.True(bench.PassUntil(status => status.IsMoving && (status.Outputs & Tool) != 0, 60));
            bench.Pass(100);
            if (fault == "limit") bench.Controller.SetLimitSwitch(0, forward: true, active: true);
            else bench.Controller.HoldMotor(0, true);
        }

        Assert.True(bench.PassUntil(status => status.IsIdle, 10));
        AssertEnded(bench);
        Assert.True(bench.Value("_RPA") < 20000.0);
        Assert.True(bench.Record.Count < 3000);
    }

    [Fact]
    public async Task A_refused_line_ends_the_watchdog_too()
    {
        await using var bench = new ControllerBench();
        bench.RunJob(Post(Slot(), MachineProfile.Default, MotionStyle.Calls, s_unattended).Text.Replace("x=0;y=4000;JS#LINEAR", "x=0;y=0;JS#LINEAR", StringComparison.Ordinal));

        Assert.NotEqual(0.0, bench.Value("_ED"));
        AssertEnded(bench);
    }

    [Fact]
    public async Task A_tool_that_works_while_nothing_moves_is_switched_off_after_six_seconds()
    {
        await using var bench = new ControllerBench();
        bench.RunJob(Post(Slot(), MachineProfile.Default, MotionStyle.Calls, s_unattended).Text.Replace("x=0;y=4000;JS#LINEAR", "WT 30000", StringComparison.Ordinal));
        var last = bench.Record[^1];
        var on = bench.Record.First(row => (row.Outputs & Tool) != 0);

        AssertEnded(bench);
        Assert.Equal(0, last.Outputs & Tool);
        Assert.InRange(last.Sample - on.Sample, 6000, 9000);
    }

    [Fact]
    public void A_job_in_parts_is_warned_of_and_a_memory_that_is_too_small_is_refused()
    {
        var none = Post(Slot(), s_mill, MotionStyle.Calls, s_unattended with { MemoryLines = 90 });
        var needed = int.Parse(none.Diagnostics[0].Facts[0], System.Globalization.CultureInfo.InvariantCulture);
        var parts = Post(Slot(), s_mill, MotionStyle.Calls, s_unattended with { MemoryLines = needed });

        Assert.True(parts.Chunks.Count > 1);
        Assert.Contains(parts.Diagnostics, finding => finding.Id == "MOT0024");
        Assert.All(parts.Chunks, chunk => Assert.InRange(chunk.Count(letter => letter == '\n'), 1, needed));
        Assert.Equal(("MOT0025", 0), (Assert.Single(none.Diagnostics).Id, none.Chunks.Count));
    }

    [Fact]
    public void The_options_of_the_posts_give_origin_and_handlers_and_without_them_the_text_is_as_before()
    {
        var program = MotionProgramGenerator.Generate(Slot(), MachineProfile.Default, new(0.001, 0.0), null, MotionStyle.Continuous).Program!;
        string Text(params (string Name, string Value)[] options) => GalilPost.Sequences.Write(UsualOptions.Post(Slot(), program, null, options.ToDictionary(one => one.Name, one => one.Value))).Text;

        Assert.Equal(DmcPost.Sequences(program, DmcPostOptions.Default).Text, Text(("origin", "here"), ("unattended", "no")));
        Assert.Contains("CB1;SHAB;ox=10000;oy=-20500\n", Text(("origin", "10,-20.5")), StringComparison.Ordinal);
        Assert.Contains("\n#TCPERR\n", Text(("unattended", "yes")), StringComparison.Ordinal);
        Assert.Equal("MOT0001", Assert.Single(GalilPost.Sequences.Write(UsualOptions.Post(Slot(), program, null, new Dictionary<string, string> { ["origin"] = "99999999,0" })).Diagnostics).Id);
        Assert.All(["10", "a,b", "1,2,3,4", ""], place => Assert.False(GalilPost.Sequences.Options.Single(option => option.Name == "origin").IsValid(place)));
    }

    /// <summary>A slot of 20 by 4 mm and a line beside it.</summary>
    private static Toolpath Slot() => Toolpaths.OfStrokes(
        [Toolpaths.Line(2, 2, 22, 2), Toolpaths.Line(22, 2, 22, 6), Toolpaths.Line(22, 6, 2, 6), Toolpaths.Arc(2, 4, 2, 90, 180)],
        [Toolpaths.Line(3, 10, 13, 10)],
        [Toolpaths.Line(3, 12, 13, 12)],
        [Toolpaths.Line(3, 14, 13, 14)]);

    private static PostOutput Post(Toolpath path, MachineProfile profile, MotionStyle style, DmcPostOptions options)
    {
        var program = MotionProgramGenerator.Generate(path, profile, new(0.001, 0.0), null, style).Program!;
        return style == MotionStyle.Calls ? DmcPost.Calls(program, options) : DmcPost.Sequences(program, options);
    }

    private static void AssertEnded(ControllerBench bench)
    {
        Assert.Equal((0, false, 0), (bench.Status.Outputs, bench.Status.IsMoving, bench.Status.RunningThreads));
        Assert.Equal((-1.0, -1.0), (bench.Value("_XQ0"), bench.Value("_XQ1")));
    }
}
