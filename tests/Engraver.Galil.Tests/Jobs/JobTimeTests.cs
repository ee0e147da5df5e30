using Engraver.Galil.Jobs;
using Engraver.Galil.Links;
using Engraver.Galil.Profiles;
using Engraver.Galil.Programs;
using Engraver.Galil.Tests.Programs;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>What is planned for a job on a link, against the same job on the simulated controller.</summary>
public class JobTimeTests
{
    [Theory]
    [InlineData(JobMode.Stream, 115200)]
    [InlineData(JobMode.Stream, 19200)]
    [InlineData(JobMode.Stream, 1200)]
    [InlineData(JobMode.Calls, 115200)]
    [InlineData(JobMode.Calls, 19200)]
    [InlineData(JobMode.Calls, 1200)]
    [InlineData(JobMode.Program, 115200)]
    [InlineData(JobMode.Program, 19200)]
    [InlineData(JobMode.Program, 1200)]
    public async Task Over_a_serial_line_a_part_of_many_strokes_takes_as_long_as_was_planned(JobMode mode, int baud)
    {
        await using var bench = new SimulatedBench();
        var program = ManyStrokes(mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var planned = JobTime.Of(program, new SerialLine(baud), mode).Total;

        var result = await bench.RunSerialAsync(baud, program, mode);

        Assert.Equal(JobOutcome.Complete, result.Outcome);
        Assert.InRange(planned, 0.95 * result.Seconds, 1.05 * result.Seconds);
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public void The_wire_lengthens_the_standing_and_nothing_else(JobMode mode)
    {
        var program = ManyStrokes(mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous);
        var network = JobTime.Of(program, null, mode);
        var fast = JobTime.Of(program, new SerialLine(115200), mode);
        var slow = JobTime.Of(program, new SerialLine(1200), mode);

        Assert.Equal((network.Cutting, network.Rapid), (slow.Cutting, slow.Rapid));
        Assert.True(network.Dwell < fast.Dwell && 5.0 * fast.Dwell < slow.Dwell);
    }

    [Fact]
    public void Without_a_wire_the_plan_is_that_of_the_network_and_nothing_to_cut_takes_no_time()
    {
        var program = ManyStrokes(MotionStyle.Continuous);

        Assert.Equal(MotionTime.Of(program), JobTime.Of(program, null, JobMode.Stream));
        foreach (var mode in Enum.GetValues<JobMode>()) Assert.Equal(0.0, JobTime.Of(program with { Strokes = [] }, new SerialLine(1200), mode).Total);
    }

    /// <summary>Lines, corners and arcs of one to forty millimetres, with rapids of all lengths between.</summary>
    private static MotionProgram ManyStrokes(MotionStyle style) => MotionProgramGenerator.Generate(
        Toolpaths.OfStrokes(
            [Toolpaths.Line(1, 1, 3, 1)], [Toolpaths.Arc(30, 5, 4, 0, 360)], [Toolpaths.Line(30, 9, 70, 9), Toolpaths.Line(70, 9, 70, 20)],
            [Toolpaths.Line(70, 21, 69, 21)], [Toolpaths.Arc(20, 30, 2, 90, 180)], [Toolpaths.Line(-5, 30, -5, -12)]),
        MachineProfile.Default, 0.001, null, style).Program!;
}
