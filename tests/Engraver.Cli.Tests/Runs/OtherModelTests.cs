using Engraver.Simulator;

namespace Engraver.Cli.Tests.Runs;

/// <summary>An unknown controller model runs with a warning, a single-axis controller is refused with the reason; an address needs no scheme if its type is
/// obvious.</summary>
public sealed class OtherModelTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("DMC2143 Rev 1.0o", 0, "")]
    [InlineData("DMC4143 Rev 1.2", 0, "warning JOB0049: DMC4143 Rev 1.2 is a controller of the family DMC-41x3; jobs have been tested on a simulated DMC-21x3 only.")]
    [InlineData("DMC52040", 0, "DMC-520x0")]
    [InlineData("DMC30010 Rev 1.2d", 4, "DMC30010 Rev 1.2d has one axis; a drawing needs two.")]
    public async Task A_job_on_another_model_runs_with_a_warning_and_not_on_one_axis(string model, int exit, string told)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Model = model });
        var address = $"127.0.0.1:{(await controller.ListenTcpAsync(0, CancellationToken.None)).Port}?clock={(await controller.ListenClockAsync(CancellationToken.None)).Port}";

        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", address, "--journal", _folder.PathOf("run.jsonl"));

        Assert.True(run.ExitCode == exit, run.Error);
        Assert.Contains(told, run.Error, StringComparison.Ordinal);
        Assert.Equal(told.Length > 0 && exit == 0, run.Error.Contains("JOB0049", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Sim_needs_no_colon() => Assert.Equal(0, (await CliRun.RunAsync("status", "--connect", "sim")).ExitCode);

    public void Dispose() => _folder.Dispose();
}
