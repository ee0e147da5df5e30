using System.Globalization;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Nothing counts the motion of steppers: what is polled of them is what was commanded.</summary>
public class StepperRunTests
{
    private const string Profile = """{ "motorTypeX": 2, "motorTypeY": -2 }""";

    /// <summary>The shaft of X is blocked for a moment: the part is wrong by its record, which no host can see, and so none promises that it is right.</summary>
    [Fact]
    public async Task A_run_in_which_a_stepper_has_lost_steps_promises_no_more_than_was_commanded()
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        controller.Schedule(new ScheduledFault { Kind = FaultKind.Jam, Axis = "A", AtSeconds = 0.0 });
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        string[] run = ["run", SampleDrawing.PathOf("paper-001"), "--machine", folder.WithFile("stepper.json", Profile), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}"), "--journal", folder.PathOf("run.jsonl")];

        var told = await CliRun.RunAsync(run);

        Assert.True(told.ExitCode == ExitCode.Done, told.Error);
        Assert.Equal(0, controller.MotorPlace(0));
        Assert.Contains("the commanded positions were at worst 0.00", told.Out, StringComparison.Ordinal);
        Assert.Contains("nothing of it is missing, if the motors followed: those of X, Y are steppers, and nothing tells whether they lost steps.", told.Out, StringComparison.Ordinal);
    }

    /// <summary>The simulator's own record is no witness of what was commanded but of where the shafts were.</summary>
    [Fact]
    public async Task With_the_record_of_a_simulated_controller_the_judge_sees_where_the_motors_were()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--machine", folder.WithFile("stepper.json", Profile), "--connect", "sim:", "--json", "--journal", folder.PathOf("run.jsonl"));
        var report = JsonText.Of(run);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(("record", 0.0), (report.GetProperty("deviationSource").GetString(), report.GetProperty("missingLength").GetDouble()));
        Assert.Equal(["X", "Y"], report.GetProperty("openLoop").EnumerateArray().Select(axis => axis.GetString()));
    }
}
