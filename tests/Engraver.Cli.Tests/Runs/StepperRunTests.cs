using System.Globalization;
using Engraver.Simulator;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Steppers have no feedback: their polled positions are the commanded ones.</summary>
public class StepperRunTests
{
    private const string Profile = """{ "motorTypeX": 2, "motorTypeY": -2 }""";

    /// <summary>The shaft of X is blocked for a moment: the record shows a wrong part, which the host cannot detect, so it must not report a correct
    /// one.</summary>
    [Fact]
    public async Task A_run_in_which_a_stepper_has_lost_steps_promises_no_more_than_was_commanded()
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        controller.Schedule(new ScheduledFault { Kind = FaultKind.Jam, Axis = "A", AtSeconds = 0.0 });
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        var drawing = folder.WithFile("steppers.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        string[] run = ["run", drawing, "--machine", folder.WithFile("stepper.json", Profile), "--connect", string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}"), "--journal", folder.PathOf("run.jsonl")];

        var told = await CliRun.RunAsync(run);

        Assert.True(told.ExitCode == ExitCode.Done, told.Error);
        Assert.Equal(0, controller.MotorPlace(0));
        Assert.Contains("maximum deviation of the commanded positions 0.00", told.Out, StringComparison.Ordinal);
        Assert.Contains("the whole drawing was cut; the motors of X, Y are steppers without feedback, lost steps are not detected.", told.Out, StringComparison.Ordinal);
        Assert.EndsWith(" mm commanded; lost steps are not detected (steppers: X, Y)", Assert.Single((await CliRun.RunAsync("history", "--search", drawing)).Out.TrimEnd().Split('\n')[..^1]), StringComparison.Ordinal); // The last line is the disk space limit of runs.
        Assert.Equal(["X", "Y"], JsonText.Of(await CliRun.RunAsync("history", "--search", drawing, "--json")).GetProperty("entries")[0].GetProperty("openLoop").EnumerateArray().Select(axis => axis.GetString()));
        await CliRun.RunAsync("report", drawing, "--machine", folder.PathOf("stepper.json"), "-o", folder.PathOf("page.html"));
        var page = await File.ReadAllTextAsync(folder.PathOf("page.html"));
        Assert.Equal(3, page.Split("The deviation is that of the commanded positions: the motors of X, Y are steppers without feedback, and lost steps are not detected.").Length); // Below the picture and above the figures.
        Assert.Contains("Maximum deviation of the commanded positions, mm", page, StringComparison.Ordinal);
        Assert.EndsWith(" mm Sollwert; verlorene Schritte werden nicht erkannt (Schrittmotoren: X, Y)", (await CliRun.RunAsync("history", "--search", drawing, "--culture", "de")).Out.TrimEnd().Split('\n')[^2], StringComparison.Ordinal);
        await CliRun.RunAsync("report", drawing, "--machine", folder.PathOf("stepper.json"), "-o", folder.PathOf("seite.html"), "--culture", "de");
        Assert.Contains("Die Abweichung ist die der Sollpositionen: Die Motoren von X, Y sind Schrittmotoren ohne Rückmeldung, verlorene Schritte werden nicht erkannt.", await File.ReadAllTextAsync(folder.PathOf("seite.html")), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Where_the_profile_is_silent_the_controller_tells_that_its_motors_are_steppers()
    {
        using var folder = new TemporaryFolder();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        var address = string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}");
        var set = await CliRun.Typing("confirm MO AB\nconfirm MT 2,-2\nconfirm SH AB\n", "terminal", "--connect", address);

        var told = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--journal", folder.PathOf("run.jsonl"));

        Assert.True(told.ExitCode == ExitCode.Done, set.Out + set.Error + told.Error);
        Assert.Contains("the motors of X, Y are steppers without feedback, lost steps are not detected", told.Out, StringComparison.Ordinal);
    }

    /// <summary>The simulator's record contains shaft positions, not commanded ones.</summary>
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
