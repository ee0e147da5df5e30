using System.Text;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Outputs and speeds of the spindle that operations state, from the file to the record.</summary>
public sealed class OperationOutputRunTests : IDisposable
{
    private const string Mill = """
        { "axisZ": "C", "countsPerMillimetreX": 1000, "countsPerMillimetreY": 1000, "countsPerMillimetreZ": 800, "toolDrive": "axis", "cutDepth": 0,
          "spindleOutput": 3, "spindleSeconds": 0.5, "spindleAxis": "D", "spindleVolts": 9, "spindleFullSpeed": 18000, "outputs": { "5": "air", "6": "mist" } }
        """;

    /// <summary>Two holes and a line.</summary>
    private static string Plate => Encoding.ASCII.GetString(DxfText.WithEntities(
        (0, "CIRCLE"), (8, "HOLES"), (10, 2.0), (20, 2.0), (40, 1.0), (0, "CIRCLE"), (8, "HOLES"), (10, 8.0), (20, 2.0), (40, 1.0), (0, "LINE"), (8, "MARKS"), (10, 0.0), (20, 5.0), (11, 10.0), (21, 5.0)).ToAscii());

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The holes with air and mist, the marks with neither.</summary>
    [Fact]
    public async Task A_run_switches_the_outputs_of_each_operation()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await controller.ListenTcpAsync(0, limit.Token);
        var clock = await controller.ListenClockAsync(limit.Token);
        var run = await CliRun.RunAsync(["run", .. Job("air\", \"MIST", 6000), "--json", "--journal", _folder.PathOf("a.jsonl"), "--connect", FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}")]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.DoesNotContain("OPR0014", run.Error, StringComparison.Ordinal);
        var record = controller.Record.Snapshot();
        Assert.Equal([0b000100, 0b110100], record.Where(sample => sample.C < 0).Select(sample => (int)sample.Outputs).Distinct().Order());
        Assert.All(record.Where(sample => sample.C < -1000), sample => Assert.Equal(0b110100, sample.Outputs)); // only holes are deeper than 1 mm
        Assert.Equal(0, record[^1].Outputs);
    }

    /// <summary>The program is right with its own operations, and not with those of others.</summary>
    [Fact]
    public async Task Verify_finds_outputs_that_a_program_does_not_switch()
    {
        var program = _folder.PathOf("a.dmc");
        await CliRun.RunAsync(["post", .. Job("air", 6000), "--target", "galil", "-o", program]);
        Assert.Contains("OFD=3", await File.ReadAllTextAsync(program), StringComparison.Ordinal);
        Assert.Contains("OFD=9;WT 500", await File.ReadAllTextAsync(program), StringComparison.Ordinal);

        var right = await CliRun.RunAsync(["verify", program, "--against", .. Job("air", 6000)]);
        Assert.True(right.ExitCode == ExitCode.Done, right.Error);
        var wrong = await CliRun.RunAsync(["verify", program, "--against", .. Job("mist", 6000)]);
        Assert.Equal(ExitCode.DrawingError, wrong.ExitCode);
        Assert.Contains("OPR0048", wrong.Error, StringComparison.Ordinal);
    }

    /// <summary>LinuxCNC numbers outputs from 0; grbl has none.</summary>
    [Fact]
    public async Task A_program_for_LinuxCNC_switches_them_and_one_for_grbl_says_that_it_does_not()
    {
        var program = _folder.PathOf("a.ngc");
        string[] post = ["--target", "gcode", "-o", program, "--spindle-speed", "9000"];
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["post", .. Job("air", 6000), .. post])).ExitCode);
        var lines = await File.ReadAllLinesAsync(program);
        Assert.Equal(["M65 P4", "M64 P4", "M65 P4"], lines.Where(line => line.StartsWith("M6", StringComparison.Ordinal)));
        Assert.True(Array.IndexOf(lines, "M64 P4") < Array.FindIndex(lines, line => line.StartsWith("G1", StringComparison.Ordinal)));
        string[] verify = ["verify", program, "--spindle-speed", "9000", "--against"];

        var right = await CliRun.RunAsync([.. verify, .. Job("air", 6000)]);
        Assert.True(right.ExitCode == ExitCode.Done, right.Error);
        foreach (var (damaged, expected) in ((string[], string)[])[([.. lines.Where(line => line != "M64 P4")], "M64 P4"), ([.. lines.Select(line => line == "M64 P4" ? "M64 P5" : line)], "VER0013")])
        {
            await File.WriteAllLinesAsync(program, damaged);
            var wrong = await CliRun.RunAsync([.. verify, .. Job("air", 6000)]);
            Assert.Equal(ExitCode.DrawingError, wrong.ExitCode);
            Assert.Contains(expected, wrong.Error, StringComparison.Ordinal);
        }

        var grbl = await CliRun.RunAsync(["post", .. Job("air", 6000), .. post, "--dialect", "grbl"]);
        Assert.Contains("OPR0038", grbl.Error, StringComparison.Ordinal);
    }

    /// <summary>Half the power at the holes and full power at the line; without the axis nothing moves.</summary>
    [Fact]
    public async Task The_power_of_a_beam_is_an_analog_output()
    {
        var program = _folder.PathOf("a.dmc");
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["post", .. Beam("""{ "powerAxis": "D", "powerVolts": 8 }"""), "--target", "galil", "-o", program])).ExitCode);
        var text = await File.ReadAllTextAsync(program);
        Assert.Equal(["MOD", "OFD=0", "OFD=4", "OFD=4", "OFD=8", "OFD=0"], text[..text.IndexOf("MG \"DONE\"", StringComparison.Ordinal)].Split('\n', ';').Where(command => command.StartsWith("OFD", StringComparison.Ordinal) || command == "MOD"));
        var run = await CliRun.RunAsync(["run", .. Beam("""{ "powerAxis": "D", "powerVolts": 8 }"""), "--connect", "sim:?speed=max", "--journal", _folder.PathOf("a.jsonl")]);
        Assert.True(run.ExitCode == ExitCode.Done, run.Error);

        var refused = await CliRun.RunAsync(["run", .. Beam("{ }"), "--connect", "sim:?speed=max"]);
        Assert.Equal(ExitCode.DrawingError, refused.ExitCode);
        Assert.Contains("OPR0037", refused.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("fan", 6000, "air, mist")]
    [InlineData("3", 6000, "tool and spindle")]
    [InlineData("air", 20000, "18000")]
    public async Task What_the_machine_does_not_have_is_refused_before_anything_moves(string output, int speed, string allowed)
    {
        var run = await CliRun.RunAsync(["run", .. Job(output, speed), "--connect", "sim:"]);

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains("OPR0003", run.Error, StringComparison.Ordinal);
        Assert.Contains(allowed, run.Error, StringComparison.Ordinal);
    }

    private string[] Beam(string profile) =>
    [
        _folder.WithFile("plate.dxf", Plate), "--machine", _folder.WithFile("laser.json", profile), "--operations", _folder.WithFile("beam.json", """
            { "version": "1.0", "tools": [{"number": 1, "kind": "laser", "diameter": 0.1}], "operations": [
              { "id": "holes", "kind": "engrave", "select": {"layers": ["HOLES"]}, "tool": 1, "power": 50 }, { "id": "marks", "kind": "engrave", "select": "rest", "tool": 1 }] }
            """),
    ];

    private string[] Job(string outputs, int speed) =>
    [
        _folder.WithFile("plate.dxf", Plate), "--machine", _folder.WithFile("mill.json", Mill), "--operations", _folder.WithFile("operations.json", $$"""
            { "version": "1.0", "tools": [{"number": 1, "diameter": 1}], "operations": [
              { "id": "holes", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 4, "spindle": {{speed}}, "outputs": ["{{outputs}}"] },
              { "id": "marks", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.2 }] }
            """),
    ];
}
