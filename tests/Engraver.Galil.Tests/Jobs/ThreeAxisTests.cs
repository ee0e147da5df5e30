using Engraver.Core.Machines;
using Engraver.Galil.Driver;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Links;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A machine with a Z axis: every poll, stop and rapid uses three axes, and machines with two axes send the same queries as before.</summary>
public class ThreeAxisTests
{
    private static readonly MachineAxes s_axes = MachineAxes.Default with { Z = new MachineAxis('D', 400.0) };

    [Fact]
    public async Task A_look_tells_the_height_and_which_of_three_motors_is_off()
    {
        await using var bench = new SimulatedBench();
        await using var connection = await GalilConnection.OpenAsync(_ => Task.FromResult<IControllerLink>(new StreamLink(bench.Controller.OpenConnection(), "memory")), null, bench.Clock, CancellationToken.None);
        await connection.ExecuteLineAsync("DP 10,20,30,-40", CancellationToken.None);
        Assert.Null(await connection.SetMotorsAsync(s_axes, on: false, CancellationToken.None));
        bench.Controller.SetLimitSwitch(3, forward: true, active: true);

        var found = await connection.ReadStatusAsync(s_axes, CancellationToken.None);
        var place = await connection.ReadPositionAsync(s_axes, CancellationToken.None);

        Assert.Equal((new CountsPoint(10, 20, -40), "ABD", "the forward limit of axis Z"), (found.Position, found.MotorsOff, found.Limit));
        Assert.Equal(new CountsPoint(10, 20, -40), place.Position);
    }

    [Theory]
    [InlineData(false, false, 1)]
    [InlineData(false, true, 2)]
    [InlineData(true, false, 2)]
    [InlineData(true, true, 2)]
    public void A_line_of_questions_never_exceeds_the_80_characters_of_a_command(bool isSlow, bool isTall, int lines)
    {
        var questions = new Engraver.Galil.Jobs.StateQuestions(isTall ? s_axes : MachineAxes.Default, isSlow, followed: "");

        Assert.Equal(lines, questions.Whole.Count);
        Assert.All(questions.Whole, question => Assert.InRange("MG ".Length + question.Text.Length, 1, 80));
    }

    [Fact]
    public void The_parts_of_a_poll_each_leave_what_they_did_not_ask_as_it_was()
    {
        var questions = new Engraver.Galil.Jobs.StateQuestions(s_axes, isSlow: false, followed: "");
        var motion = questions.Motion.Text.Split(',');
        var state = questions.Program.Update(default, [0, 0, 1, 5, 6, 7]);
        state = questions.Motion.Update(state, [.. motion.Select((_, i) => (double)(i + 1))]);

        Assert.Equal((true, true, true, 7), (state.AxesRunning, state.ProgramRuns, state.WatchdogRuns, state.ProgramError));
        Assert.Equal(new CountsPoint(5, 6, 7), state.Position);
        Assert.Equal((true, 2, 3, 4), (state.SequenceRunning, state.Counter, state.Calls, state.PathSpeed));
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_flat_job_on_three_axes_ends_on_its_counts_and_leaves_the_height(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        var program = MotionPrograms.Paper with { Profile = MachineProfile.Default with { Axes = s_axes } };

        var result = await bench.RunAsync(program, SimulatedBench.Job with { Strategy = mode.Strategy() });

        Assert.Equal("Done: 4 segments.", result.Message);
        Assert.Equal(new CountsPoint(5000, 5000), result.FinalPosition);
        CutRecord.AssertWholePathWasCut(bench, program);
    }

    [Fact]
    public async Task A_stop_brakes_the_third_axis_too_and_says_where_it_rests()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        foreach (var command in new[] { "JG ,,,20000", "BGD" }) Assert.IsType<Accepted>(await session.Commands.SendAsync(command, CancellationToken.None));

        var rest = await new OperatorStop(session, [1], [], s_axes.Letters).FinishAsync(TimeSpan.Zero, CancellationToken.None);

        Assert.Equal((0, 0), (rest.Position.X, rest.Position.Y));
        Assert.NotEqual(0, rest.Position.Z);
        Assert.False(bench.Controller.Status.IsMoving);
    }
}
