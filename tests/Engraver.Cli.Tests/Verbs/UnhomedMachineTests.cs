namespace Engraver.Cli.Tests.Verbs;

/// <summary>Allowed actions and messages at the console with a machine that requires homing and is not homed.</summary>
public sealed class UnhomedMachineTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));

    /// <summary>Regression: <c>jog --x -500</c> ran at the rapid speed of 3000 mm/min into the limit switch.</summary>
    [Fact]
    public async Task It_is_jogged_no_faster_than_it_searches_its_switches_and_that_no_limit_stops_it_is_said()
    {
        await using var machine = new HomedSimulator(731_001);
        string[] at = ["--connect", await machine.AddressAsync(_limit.Token), "--machine", _folder.WithFile("homed.json", HomedSimulator.Profile())];

        var slow = await CliRun.RunAsync(["jog", "--x", "20", .. at]);
        var asked = await CliRun.RunAsync(["jog", "--y", "-5", "--feed", "3000", .. at]);

        Assert.All([slow, asked], run => Assert.Equal(ExitCode.Done, run.ExitCode));
        Assert.All([slow, asked], run => Assert.Contains("The machine is not homed, so the soft limits are not active and only the limit switches stop the machine. The speed is limited to 480 mm/min", run.Error, StringComparison.Ordinal));
        Assert.InRange(machine.MaxStepFrom(0), 7, 8); // 480 mm/min are 8 counts in a millisecond
        var beyond = await CliRun.RunAsync(["jog", "--x", "-500", .. at]);
        Assert.Equal(ExitCode.DrawingError, beyond.ExitCode);
        Assert.Contains("500 mm is longer than the travel of axis X, 300 mm", beyond.Error, StringComparison.Ordinal);

        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["home", .. at])).ExitCode);
        var rows = machine.Controller.Record.Count;
        var fast = await CliRun.RunAsync(["jog", "--x", "20", .. at]);
        Assert.DoesNotContain("not homed", fast.Error, StringComparison.Ordinal);
        Assert.InRange(machine.MaxStepFrom(rows), 45, 50);
    }

    [Fact]
    public async Task A_held_jog_is_as_slow()
    {
        await using var machine = new HomedSimulator(731_002);
        string[] at = ["--connect", await machine.AddressAsync(_limit.Token), "--machine", _folder.WithFile("homed.json", HomedSimulator.Profile())];

        using var nobody = new SilentReader();
        var held = await CliRun.Typing(nobody, _limit.Token, ["jog", "--hold", "X-", "--feed", "3000", .. at]); // into the limit switch, 21 mm away

        Assert.Contains("limited to 480 mm/min", held.Error, StringComparison.Ordinal);
        Assert.InRange(machine.MaxStepFrom(0), 7, 8);
    }

    /// <summary>Regression: <c>zero</c> stored an unusable origin, reported that its position is unknown, and deleted the origins that homing would have
    /// restored.</summary>
    [Fact]
    public async Task An_origin_is_not_set_before_the_homing_and_what_to_do_is_told_in_verbs()
    {
        await using var machine = new HomedSimulator(731_003);
        string[] at = ["--connect", await machine.AddressAsync(_limit.Token), "--machine", _folder.WithFile("homed.json", HomedSimulator.Profile())];

        var status = await CliRun.RunAsync(["status", .. at]);
        var zero = await CliRun.RunAsync(["zero", "--json", .. at]);
        var place = await CliRun.RunAsync(["goto", "3,4", .. at]);
        var park = await CliRun.RunAsync(["goto", "3,4", "--machine-position", .. at]);

        Assert.StartsWith("NOT HOMED", status.Out, StringComparison.Ordinal);
        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError, ExitCode.DrawingError), (zero.ExitCode, place.ExitCode, park.ExitCode));
        Assert.Contains("the work origin was not set", zero.Error, StringComparison.Ordinal);
        Assert.All([status.Out, zero.Error, place.Error, park.Error], said => Assert.Contains("engraver home", said, StringComparison.Ordinal));
        Assert.All([status.Out, zero.Error, place.Error, park.Error], said => Assert.DoesNotContain("CNC", said, StringComparison.Ordinal));
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["home", .. at])).ExitCode);
        var homed = await CliRun.RunAsync(["status", .. at]);
        Assert.Contains("G54: unknown. The work origin G54 is not set", homed.Out, StringComparison.Ordinal);
        Assert.Contains("engraver zero", homed.Out, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Refusals_name_the_axes_as_the_operator_does()
    {
        await using var machine = new HomedSimulator(731_004);
        string[] at = ["--connect", await machine.AddressAsync(_limit.Token), "--machine", _folder.WithFile("homed.json", HomedSimulator.Profile())];
        await CliRun.RunAsync(["home", .. at]);

        var far = await CliRun.RunAsync(["goto", "3,201", "--machine-position", .. at]);

        Assert.Contains("axis Y to 201 mm; its travel is 0 to 200 mm", far.Error, StringComparison.Ordinal);
    }

    public void Dispose()
    {
        _folder.Dispose();
        _limit.Dispose();
    }

    /// <summary>A console without input.</summary>
    private sealed class SilentReader : TextReader
    {
        public override async ValueTask<string?> ReadLineAsync(CancellationToken cancellationToken)
        {
            await new TaskCompletionSource().Task.WaitAsync(cancellationToken);
            return null;
        }
    }
}
