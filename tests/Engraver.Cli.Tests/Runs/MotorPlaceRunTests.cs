using System.Globalization;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>The motor positions of servo axes are judged, not only the commanded ones: over a network and over a serial line, with an output and with an axis
/// as tool drive.</summary>
public sealed class MotorPlaceRunTests
{
    private static readonly string[] s_links = ["tcp", "serial"];
    private static readonly string[] s_modes = ["stream", "calls", "program"];

    public static TheoryData<string, string, bool> Ways
    {
        get
        {
            var ways = new TheoryData<string, string, bool>();
            foreach (var link in s_links)
            {
                foreach (var mode in s_modes)
                {
                    ways.Add(link, mode, false);
                    if (mode != "calls") ways.Add(link, mode, true);
                }
            }

            return ways;
        }
    }

    /// <summary>X is blocked in the middle of a line that is cut at 20 mm/s: after 0.2 s the motor is 4 mm behind, and the controller itself ends the
    /// job.</summary>
    [Theory]
    [MemberData(nameof(Ways))]
    public async Task A_blocked_axis_is_never_a_perfect_part(string link, string mode, bool isMill)
    {
        foreach (var seconds in (double[])[mode == "calls" ? 0.6 : 0.3, 2.0]) // A call includes the time of its exchanges.
        {
            await using var bench = new Bench(link, isMill, ServoLag: TimeSpan.Zero);
            bench.Controller.Schedule(new ScheduledFault { Kind = FaultKind.Jam, Axis = "A", AtSegment = 1, ForSeconds = seconds });

            var run = await bench.RunAsync(mode);

            Assert.True(run.ExitCode != ExitCode.Done, $"{seconds} s: {run.Out}");
            Assert.NotEqual("complete", JsonText.Of(run).GetProperty("outcome").GetString());
            Assert.Equal(0, bench.Controller.Status.Outputs & 1);
        }
    }

    /// <summary>A servo with a lag of 10 ms is 0.2 mm behind at 20 mm/s: reported, and the part is correct.</summary>
    [Theory]
    [MemberData(nameof(Ways))]
    public async Task The_lag_of_a_healthy_servo_is_shown_and_no_deviation(string link, string mode, bool isMill)
    {
        await using var bench = new Bench(link, isMill, ServoLag: TimeSpan.FromMilliseconds(10));

        var run = await bench.RunAsync(mode);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        var report = JsonText.Of(run);
        Assert.Equal("complete", report.GetProperty("outcome").GetString());
        Assert.InRange(report.GetProperty("maxFollowingError").GetDouble(), 0.1, 0.5);
        Assert.InRange(report.GetProperty("tolerance").GetDouble(), 1.9, 2.0);
        Assert.True(report.GetProperty("maxDeviation").GetDouble() < report.GetProperty("tolerance").GetDouble());
    }

    private sealed record Bench(string Link, bool IsMill, TimeSpan ServoLag) : IAsyncDisposable
    {
        private readonly TemporaryFolder _folder = new();
        private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(120));

        public SimulatedController Controller { get; } = new(new SimulatorOptions { Speed = double.PositiveInfinity, ServoLag = ServoLag, Time = Link == "serial" ? new ManualTimeProvider() : TimeProvider.System });

        public async Task<CliRun> RunAsync(string mode)
        {
            var clock = (await Controller.ListenClockAsync(_limit.Token)).Port;
            var path = _folder.PathOf("line");
            var address = Link == "tcp" ? $"tcp://127.0.0.1:{(await Controller.ListenTcpAsync(0, _limit.Token)).Port}?clock={clock}" : $"serial://{path}?baud=19200&clock={clock}";
            if (Link == "serial") await Controller.ServeSerialAsync(path, 19200, _limit.Token);
            var drawing = _folder.WithFile("plate.dxf", Plate());
            string[] machine = IsMill ? ["--machine", _folder.WithFile("mill.json", """{ "axisZ": "C", "countsPerMillimetreZ": 400, "toolDrive": "axis", "clearanceHeight": 5, "retractHeight": 1, "cutDepth": 0.5 }""")] : [];
            return await CliRun.RunAsync(["run", drawing, "--connect", address, "--mode", mode, "--fit-arcs", "off", "--json", "--journal", _folder.PathOf("run.jsonl"), .. machine]);
        }

        public async ValueTask DisposeAsync()
        {
            await Controller.DisposeAsync();
            _limit.Dispose();
            _folder.Dispose();
        }

        /// <summary>Two lines of 40 mm with a corner between, which a blocked motor would cut off. The first is two lines, so that the fault is in the
        /// middle: they stay two segments.</summary>
        private static string Plate() => string.Create(CultureInfo.InvariantCulture, $"0\nSECTION\n2\nENTITIES\n{Line(0, 0, 4, 0)}{Line(4, 0, 40, 0)}{Line(40, 0, 40, 30)}{Line(40, 30, 0, 30)}0\nENDSEC\n0\nEOF\n");

        private static string Line(int x1, int y1, int x2, int y2) => $"0\nLINE\n8\n0\n10\n{x1}\n20\n{y1}\n11\n{x2}\n21\n{y2}\n";
    }
}
