using System.Globalization;
using System.Text;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The power of a mill fails in the middle of a run: <c>home</c> and <c>run --resume</c> cut the rest at the position of the work, in machine counts
/// and to its depth.</summary>
public sealed class ResumeAfterPowerRunTests : IDisposable
{
    private const int TopOfWork = 4800;
    private const int Depth = 400;

    private const string Profile = """
        {
          "axisZ": "C", "countsPerMillimetreZ": 800,
          "toolDrive": "axis", "clearanceHeight": 4, "retractHeight": 1, "cutDepth": 0.5, "plungeMmPerMinute": 240,
          "spindleOutput": 3, "spindleSeconds": 0.2,
          "homing": [
            { "axis": "Z", "by": "switch", "direction": "plus", "zero": 20, "backOff": 14 },
            { "axis": "X", "by": "limit", "direction": "minus", "zero": -1, "backOff": 1 },
            { "axis": "Y", "by": "limit", "direction": "minus", "zero": -1, "backOff": 1 }
          ]
        }
        """;

    private readonly TemporaryFolder _folder = new();

    /// <summary>Full run only: the fast subset runs all modes in <c>ResumeAfterPowerTests</c> of the Workbench.</summary>
    public static TheoryData<string, int> Modes => new() { { "stream", 730_001 }, { "calls", 730_002 }, { "program", 730_003 } };

    [FullRunTheory]
    [MemberData(nameof(Modes))]
    public async Task Behind_a_power_cycle_and_a_homing_resume_cuts_what_is_left(string mode, int serialNumber)
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(120));
        var profile = _folder.WithFile("mill.json", Profile);
        var journal = _folder.PathOf("first.jsonl");
        string[] run = ["run", SampleDrawing.PathOf("paper-001"), "--machine", profile, "--mode", mode, "--json", "--journal"];
        List<MotionSample> first;
        await using (var before = SwitchedOn(serialNumber, 60, 25, 3))
        {
            var address = await AddressAsync(before, limit.Token);
            await DoneAsync("home", "--connect", address, "--machine", profile);
            await DoneAsync("goto", "10,12", "--machine-position", "--connect", address, "--machine", profile);
            await DoneAsync("zero", "--connect", address, "--machine", profile);
            await DoneAsync("zero", "--z", "--connect", address, "--machine", profile);
            var rows = before.Record.Count;

            var failed = await CutOffAsync(before, 240, [.. run, journal, "--connect", address]);

            Assert.True(failed.ExitCode == ExitCode.LinkLost, failed.Error);
            first = [.. before.Record.Snapshot().Skip(rows)];
        }

        Assert.Contains(first, sample => sample.C == TopOfWork - Depth); // in the work
        await using var controller = SwitchedOn(serialNumber, 44, 8, 15);
        var again = await AddressAsync(controller, limit.Token);
        string[] resume = [.. run, _folder.PathOf("second.jsonl"), "--connect", again, "--resume", journal, "--lead-in", "0.3"];
        var unhomed = await CliRun.RunAsync(resume);
        Assert.Contains("JOB0031", unhomed.Error, StringComparison.Ordinal); // not homed
        await DoneAsync("home", "--connect", again, "--machine", profile);
        var behind = controller.Record.Count;

        var resumed = await CliRun.RunAsync(resume);

        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.True(JsonText.Of(resumed).GetProperty("resumedFrom").GetProperty("segments").GetInt32() > 0);
        var rest = controller.Record.Snapshot().Skip(behind).ToList();
        var whole = await WholeAsync(profile, mode, serialNumber + 10_000, limit.Token);
        AssertSameDrawing([.. first, .. rest], whole);
        Assert.InRange(rest.Count(IsInWork), 1000, 0.85 * whole.Count(IsInWork)); // The first part is not cut again.
    }

    public void Dispose() => _folder.Dispose();

    private static bool IsInWork(MotionSample sample) => sample.C < TopOfWork;

    /// <summary>Both runs together cut every position of an undisturbed run, and no other position of the work.</summary>
    private static void AssertSameDrawing(IReadOnlyList<MotionSample> both, IReadOnlyList<MotionSample> whole)
    {
        var (cut, drawn) = (Squares(both), Squares(whole));
        Assert.Equal(TopOfWork - Depth, both.Min(sample => sample.C));
        Assert.DoesNotContain(drawn, square => !Near(cut, square));
        Assert.DoesNotContain(cut, square => !Near(drawn, square));
    }

    /// <summary>Squares of 50 counts that the tool was in, at its depth.</summary>
    private static HashSet<(int X, int Y)> Squares(IEnumerable<MotionSample> record) => [.. record.Where(sample => Math.Abs(sample.C - (TopOfWork - Depth)) <= 2).Select(sample => (sample.A / 50, sample.B / 50))];

    private static bool Near(HashSet<(int X, int Y)> squares, (int X, int Y) at)
    {
        for (var x = -1; x <= 1; x++)
        {
            for (var y = -1; y <= 1; y++)
            {
                if (squares.Contains((at.X + x, at.Y + y))) return true;
            }
        }

        return false;
    }

    /// <summary>The same job at the same place without a failure, on a machine without stored state.</summary>
    private async Task<IReadOnlyList<MotionSample>> WholeAsync(string profile, string mode, int serialNumber, CancellationToken limit)
    {
        await using var controller = SwitchedOn(serialNumber, 60, 25, 3);
        var address = await AddressAsync(controller, limit);
        await DoneAsync("home", "--connect", address, "--machine", profile);
        await DoneAsync("goto", "10,12", "--machine-position", "--connect", address, "--machine", profile);
        await DoneAsync("zero", "--connect", address, "--machine", profile);
        await DoneAsync("zero", "--z", "--connect", address, "--machine", profile);
        var rows = controller.Record.Count;
        await DoneAsync("run", SampleDrawing.PathOf("paper-001"), "--machine", profile, "--mode", mode, "--connect", address, "--journal", _folder.PathOf("whole.jsonl"));
        return [.. controller.Record.Snapshot().Skip(rows)];
    }

    private static async Task DoneAsync(params string[] words)
    {
        var done = await CliRun.RunAsync(words);
        Assert.True(done.ExitCode == ExitCode.Done, $"{string.Join(' ', words)}: {done.Error}");
    }

    /// <summary>The controller stops answering after a given progress report.</summary>
    private static async Task<CliRun> CutOffAsync(SimulatedController controller, int report, string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        int code;
        using (var streams = new ConsoleStreams(output, error)
        {
            Keys = () =>
            {
                if (report-- == 0) controller.DropConnections();
                return null;
            },
        })
        {
            code = await EngraverProgram.RunAsync(args, streams, CancellationToken.None);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }

    private static async Task<string> AddressAsync(SimulatedController controller, CancellationToken limit)
    {
        var port = (await controller.ListenTcpAsync(0, limit)).Port;
        var clock = (await controller.ListenClockAsync(limit)).Port; // A busy computer must not count as a silent host.
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
    }

    /// <summary>A machine with switches at -1 mm (A and B) and 20 mm (C), switched on at this place.</summary>
    private static SimulatedController SwitchedOn(int serialNumber, int x, int y, int z) => new(new SimulatorOptions
    {
        Speed = double.PositiveInfinity,
        SerialNumber = serialNumber,
        Switches =
        [
            new AxisSwitches(0) { ReverseLimitAt = (-1 - x) * 1000, ForwardLimitAt = (490 - x) * 1000 },
            new AxisSwitches(1) { ReverseLimitAt = (-1 - y) * 1000, ForwardLimitAt = (490 - y) * 1000 },
            new AxisSwitches(2) { HomeAt = (20 - z) * 800, ReverseLimitAt = (-5 - z) * 800, ForwardLimitAt = (25 - z) * 800 },
        ],
    });
}
