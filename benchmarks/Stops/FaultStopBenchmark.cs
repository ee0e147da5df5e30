using System.Globalization;
using Engraver.Core.Dxf;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks.Stops;

/// <summary>Measures the time from STOP to the bytes that brake the axes on a TCP link or a serial line, while a job streams to a simulated controller at
/// speed 1 just after a fault of a faults file.</summary>
internal sealed class FaultStopBenchmark
{
    /// <summary>Number of consecutive jobs without motion after which the benchmark fails.</summary>
    private const int MaxUnstartedJobs = 50;

    private readonly FaultStopPress _press;

    /// <param name="folder">For the journals of the jobs, and the serial device; must exist.</param>
    /// <param name="baud">Of a serial line; null for TCP.</param>
    /// <param name="driver">Driver of the serial device; null for the default one.</param>
    public FaultStopBenchmark(string folder, int? baud, string? driver)
    {
        var job = JobPreparation.Prepare(DxfReader.Read(Zigzag(), "stop.dxf", new DxfReadOptions(), CancellationToken.None), new DrawingSettings(), MachineFamilies.Default.DefaultStrategy.Style);
        _press = new FaultStopPress(folder, baud, driver, job);
    }

    /// <summary>The faults of <c>simulate --faults</c>, each with its text in the file beside its time; the first row is without a fault.</summary>
    public static IReadOnlyList<(string Name, string? Fault)> Faults { get; } =
    [
        ("none", null),
        ("delay", ",\"seconds\":0.7,\"count\":3"),
        ("dropCommand", ""),
        ("dropReply", ""),
        ("garbage", ",\"count\":7"),
        ("reset", ""),
        ("limitSwitch", ",\"axis\":\"A\",\"forward\":true"),
        ("abortInput", ""),
        ("motorOff", ",\"axis\":\"B\""),
        ("jam", ",\"axis\":\"A\""),
        ("powerCycle", ""),
    ];

    /// <summary>Measures a number of presses under one fault.</summary>
    /// <param name="fault">Null for none.</param>
    /// <exception cref="ControllerException">The simulated controller could not be reached.</exception>
    public async Task<FaultStopFigure> RunAsync(string name, string? fault, int presses, CancellationToken stop)
    {
        var file = fault is null ? null : $"{{\"faults\":[{{\"kind\":\"{name}\",\"atSeconds\":0{fault}}}]}}";
        var (times, behind, lost, braked, pause, unbegun) = (new List<double>(), new List<double>(), 0, 0, 0.0, 0);
        while (times.Count + lost + braked < presses)
        {
            var pressed = await _press.RunAsync(file, stop).ConfigureAwait(false);
            unbegun = pressed is null ? unbegun + 1 : 0;
            if (unbegun == MaxUnstartedJobs) throw new ControllerTimeoutException($"{MaxUnstartedJobs} jobs in a row ended before they moved: this computer is too busy, or the link too slow.");
            switch (pressed)
            {
                case { Milliseconds: { } time, UnderWay: var underWay, Pause: var collecting }:
                    times.Add(time);
                    behind.Add(Math.Max(0.0, time - underWay));
                    pause = Math.Max(pause, collecting);
                    break;
                case null: break;
                case { IsBraked: true }: braked++; break;
                default: lost++; break;
            }
        }

        times.Sort();
        behind.Sort();
        return new FaultStopFigure(name, times, braked, lost) { LongestPause = pause, Behind = _press.IsSerial ? behind : null };
    }

    /// <summary>2,000 lines of half a millimetre in a zigzag: 25 ms each at the default feed.</summary>
    private static byte[] Zigzag()
    {
        var text = new System.Text.StringBuilder("0\nSECTION\n2\nENTITIES\n");
        for (var i = 0; i < 2000; i++) text.Append(CultureInfo.InvariantCulture, $"0\nLINE\n8\n0\n10\n{i * 0.499}\n20\n{(i & 1) * 0.03}\n11\n{(i + 1) * 0.499}\n21\n{((i + 1) & 1) * 0.03}\n");
        return System.Text.Encoding.ASCII.GetBytes(text.Append("0\nENDSEC\n0\nEOF\n").ToString());
    }
}
