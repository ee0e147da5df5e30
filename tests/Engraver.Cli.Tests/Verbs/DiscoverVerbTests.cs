using System.Globalization;
using Engraver.Simulator;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Tests.Verbs;

public class DiscoverVerbTests
{
    [Fact]
    public async Task A_controller_that_answers_is_named_with_its_number_and_one_that_does_not_with_the_reason()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { SerialNumber = 4711 });
        var port = (await controller.ListenTcpAsync(0, CancellationToken.None)).Port;
        var address = string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}");

        var run = await CliRun.RunAsync("discover", "tcp://127.0.0.1:1", address, "--json");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        var found = JsonText.Of(run).GetProperty("controllers").EnumerateArray().Single(one => one.GetProperty("address").GetString() == address);
        Assert.Equal(("DMC2143 Rev 1.0o", 4711), (found.GetProperty("model").GetString(), found.GetProperty("serial").GetInt32()));
        Assert.Contains(JsonText.Of(run).GetProperty("silent").EnumerateArray(), one => one.GetProperty("address").GetString() == "tcp://127.0.0.1:1" && one.GetProperty("reason").GetString()!.Length > 0);
        Assert.Contains("serial number 4711", (await CliRun.RunAsync("discover", address)).Out, StringComparison.Ordinal);
        Assert.False(controller.Status.IsMoving);
    }

    [Theory]
    [InlineData("discover", "http://x")]
    [InlineData("discover", "--baud", "300")]
    public async Task What_is_no_address_and_no_rate_is_a_usage_error(params string[] words) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync(words)).ExitCode);

    [Fact]
    public void The_last_address_of_the_desktop_and_every_device_are_asked_once_and_its_settings_are_only_read()
    {
        using var folder = new TemporaryFolder();
        var settings = folder.WithFile("desktop.json", """{ "lastAddress": "tcp://10.0.0.7" }""");
        var broken = folder.WithFile("broken.json", "{ \"lastAddress\": ");
        var simulated = folder.WithFile("sim.json", """{ "lastAddress": "sim:" }""");

        Assert.Equal(["tcp://a", "tcp://10.0.0.7", "serial:///dev/ttyUSB0?baud=9600"], Discovery.Candidates(["tcp://a"], 9600, settings, ["/dev/ttyUSB0"]));
        Assert.Equal(["tcp://10.0.0.7"], Discovery.Candidates(["tcp://10.0.0.7"], 9600, settings, []));
        Assert.Empty(Discovery.Candidates([], 9600, broken, []));
        Assert.Empty(Discovery.Candidates([], 9600, simulated, []));
        Assert.True(File.Exists(broken));
    }
}
