namespace Engraver.Cli.Tests.Runs;

/// <summary>A rehearsal on <c>sim:</c> is refused for the same reasons as the job on the machine: it counts as homed, with its origin at 0 unless another is
/// given, which is reported as an assumption.</summary>
public sealed class RehearsalTests : IDisposable
{
    private const string Homing = """, "homing": [{"axis": "X", "by": "switch", "direction": "minus"}, {"axis": "Y", "by": "switch", "direction": "minus"}]""";
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("run", "")]
    [InlineData("run", Homing)]
    [InlineData("frame", "")]
    [InlineData("frame", Homing)]
    public async Task A_drawing_that_does_not_fit_into_the_travel_is_refused_on_every_link(string verb, string homing)
    {
        var profile = _folder.WithFile("small.json", $$"""{"travelX": {"min": 0, "max": 140}, "travelY": {"min": 0, "max": 220}{{homing}}}""");

        var rehearsed = await CliRun.RunAsync(verb, SampleDrawing.PathOf("paper-001"), "--machine", profile, "--connect", "sim:");

        Assert.Equal(1, rehearsed.ExitCode);
        Assert.Contains("The move would take axis X to 150 mm; its travel is 0 to 140 mm.", rehearsed.Error, StringComparison.Ordinal);
        Assert.Equal(homing.Length > 0, rehearsed.Error.Contains("note   The simulated machine is assumed to be homed, with its zero at the start position.", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("run", Homing)]
    [InlineData("frame", Homing)]
    [InlineData("frame", "")]
    public async Task A_drawing_that_fits_is_rehearsed_and_may_be_put_elsewhere(string verb, string homing)
    {
        var profile = _folder.WithFile("fits.json", $$"""{"travelX": {"min": 0, "max": 160}, "travelY": {"min": 0, "max": 200}{{homing}}}""");
        string[] words = [verb, SampleDrawing.PathOf("paper-001"), "--machine", profile, "--connect", "sim:"];

        var fits = await CliRun.RunAsync(words);

        Assert.True(fits.ExitCode == 0, fits.Error);
        if (verb == "frame") return;
        Assert.Contains("axis X to 170 mm; its travel is 0 to 160 mm", (await CliRun.RunAsync([.. words, "--origin", "20,0"])).Error, StringComparison.Ordinal);
        Assert.Equal(0, (await CliRun.RunAsync([.. words, "--origin", "5,0"])).ExitCode);
    }

    public void Dispose() => _folder.Dispose();
}
