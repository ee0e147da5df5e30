using System.Diagnostics;
using System.Globalization;
using Engraver.Core.Dxf;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks.Stops;

/// <summary>Measures the time from STOP to the bytes that brake the axes on a TCP wire or a serial line, while a job streams to a simulated controller at speed 1 to which a fault of a faults file has just happened.</summary>
internal sealed class FaultStopBenchmark
{
    /// <summary>Controller second at which the fault happens at first, and how much later where the job does not stream by then.</summary>
    private const double FirstSecond = 0.8;
    private const double LaterPart = 0.25;

    /// <summary>STOP comes within so many seconds behind the fault.</summary>
    private const double PressWithin = 0.06;

    /// <summary>A stop that is not on the wire after this never comes there: the link is gone.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(2);

    private readonly Random _random = new(1);
    private readonly string _folder;
    private readonly PreparedJob _job;
    private readonly int? _baud;
    private double _faultSecond = FirstSecond;
    private bool _isTimed;

    /// <param name="folder">For the journals of the jobs, and the serial device; exists.</param>
    /// <param name="baud">Of a serial line; null for TCP.</param>
    public FaultStopBenchmark(string folder, int? baud)
    {
        (_folder, _baud) = (folder, baud);
        var settings = new DrawingSettings();
        _job = JobPreparation.Prepare(DxfReader.Read(Zigzag(), "stop.dxf", new DxfReadOptions(), CancellationToken.None), settings, JobPlan.StyleOf(JobMode.Stream));
    }

    /// <summary>The faults of <c>simulate --faults</c>, each with what stands in the file beside its moment; none first.</summary>
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

    /// <summary>So many presses under one fault.</summary>
    /// <param name="fault">Null for none.</param>
    /// <exception cref="ControllerException">The simulated controller could not be reached.</exception>
    public async Task<FaultStopFigure> RunAsync(string name, string? fault, int presses, CancellationToken stop)
    {
        var (times, behind, lost, before, pause) = (new List<double>(), new List<double>(), 0, 0, 0.0);
        while (times.Count + lost + before < presses)
        {
            switch (await PressAsync(fault is null ? null : string.Create(CultureInfo.InvariantCulture, $"{{\"faults\":[{{\"kind\":\"{name}\",\"atSeconds\":{_faultSecond}{fault}}}]}}"), stop).ConfigureAwait(false))
            {
                case { Pressed: false }: _faultSecond *= 1.0 + LaterPart; break; // this computer was too slow to start the job in time
                case { Milliseconds: { } time, Pause: var collecting, UnderWay: var underWay }:
                    times.Add(time);
                    behind.Add(Math.Max(0.0, time - underWay));
                    pause = Math.Max(pause, collecting);
                    break;
                case { Braked: true }: before++; break;
                default: lost++; break;
            }
        }

        times.Sort();
        behind.Sort();
        return new FaultStopFigure(name, times, before, lost) { LongestPause = pause, Behind = _baud is null ? null : behind };
    }

    private async Task<(bool Pressed, bool Braked, double? Milliseconds, double Pause, double UnderWay)> PressAsync(string? faults, CancellationToken stop)
    {
        await using var controller = ServedSimulator.Create(1.0, profile: null, faults, signColumn: false);
        var on = Stopwatch.GetTimestamp();
        await using var wire = _baud is { } baud ? await FaultStopSerialTap.OverSerialAsync(controller, Path.Combine(_folder, "line"), baud, stop).ConfigureAwait(false) : await FaultStopWire.OverTcpAsync(controller, stop).ConfigureAwait(false);
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.ConnectAsync(ControllerAddress.Parse(wire.Address), stop).ConfigureAwait(false);
        var heard = new TaskCompletionSource<long>(TaskCreationOptions.RunContinuationsAsynchronously);
        var pressed = long.MaxValue;
        var braked = false;
        wire.Heard += (text, at) =>
        {
            if (!text.Contains("STS", StringComparison.Ordinal)) return; // the end of the path, in the same line or before the end of the axes
            if (at >= Volatile.Read(ref pressed)) heard.TrySetResult(at);
            else Volatile.Write(ref braked, Stopwatch.GetElapsedTime(on, at).TotalSeconds >= _faultSecond);
        };
        var program = machine.FitToLink(_job.Motion.Program!, JobMode.Stream, _job.Drawing).Program;
        var run = machine.RunAsync(_job, program, address => new MachineRunOptions(address, JobMode.Stream) { JournalPath = Path.Combine(_folder, "stop.jsonl") }, stop);
        if (_baud is not null && faults is null && !_isTimed) _faultSecond = Math.Max(_faultSecond, await StreamsAtAsync(machine, run, on, stop).ConfigureAwait(false));
        var rest = TimeSpan.FromSeconds(_faultSecond + (PressWithin * _random.NextDouble())) - Stopwatch.GetElapsedTime(on);
        if (rest > TimeSpan.Zero) await Task.Delay(rest, stop).ConfigureAwait(false);
        var isUnderWay = machine.Progress is { SegmentsSent: > 0 };
        var collecting = GC.GetTotalPauseDuration();
        wire.Press(Stopwatch.GetTimestamp());
        Volatile.Write(ref pressed, Stopwatch.GetTimestamp());
        machine.Stop();
        var reached = await Task.WhenAny(heard.Task, Task.Delay(s_patience, stop)).ConfigureAwait(false) == heard.Task;
        var pause = (GC.GetTotalPauseDuration() - collecting).TotalMilliseconds;
        var underWay = wire.UnderWayMilliseconds;
        await EndAsync(run).ConfigureAwait(false);
        return (isUnderWay && rest > TimeSpan.Zero, braked, reached ? Stopwatch.GetElapsedTime(pressed, await heard.Task.ConfigureAwait(false)).TotalMilliseconds : null, pause, underWay);
    }

    /// <summary>Waits once until a job without a fault streams: a serial line takes seconds before the first segment.</summary>
    /// <returns>The controller second at which the next one certainly does.</returns>
    private async Task<double> StreamsAtAsync(MachineSession machine, Task run, long on, CancellationToken stop)
    {
        while (!run.IsCompleted && machine.Progress is not { SegmentsSent: > 0 }) await Task.Delay(TimeSpan.FromMilliseconds(10), stop).ConfigureAwait(false);
        _isTimed = true;
        return Stopwatch.GetElapsedTime(on).TotalSeconds * (1.0 + LaterPart);
    }

    /// <summary>However the job ends.</summary>
    private static async Task EndAsync(Task run)
    {
        try
        {
            await run.ConfigureAwait(false);
        }
        catch (ControllerException)
        {
            // The link is gone, as the fault wanted it.
        }
        catch (OperationCanceledException)
        {
            // Stopped before it began: this computer was too slow.
        }
    }

    /// <summary>2,000 lines of half a millimetre that rise and fall: 25 ms each at the default feed.</summary>
    private static byte[] Zigzag()
    {
        var text = new System.Text.StringBuilder("0\nSECTION\n2\nENTITIES\n");
        for (var i = 0; i < 2000; i++) text.Append(CultureInfo.InvariantCulture, $"0\nLINE\n8\n0\n10\n{i * 0.499}\n20\n{(i & 1) * 0.03}\n11\n{(i + 1) * 0.499}\n21\n{((i + 1) & 1) * 0.03}\n");
        return System.Text.Encoding.ASCII.GetBytes(text.Append("0\nENDSEC\n0\nEOF\n").ToString());
    }
}

/// <summary>One row of the table: how long stops took under one fault.</summary>
/// <param name="Milliseconds">From STOP to the wire, ascending.</param>
/// <param name="Braked">Stops that found the job braking already, because the fault had ended it.</param>
/// <param name="Lost">Stops that never reached the wire because the link was gone.</param>
internal sealed record FaultStopFigure(string Fault, IReadOnlyList<double> Milliseconds, int Braked, int Lost)
{
    /// <summary>The longest garbage collection between a press and the wire, milliseconds.</summary>
    public double LongestPause { get; init; }

    /// <summary>On a serial line: from the end of the bytes under way, ascending; null for TCP, where a stop does not wait for them.</summary>
    public IReadOnlyList<double>? Behind { get; init; }

    /// <summary>The head of the table for a serial line.</summary>
    public const string SerialHead = "| Fault | presses | braked already | without a wire | p50 ms | p99 ms | worst ms | collecting ms | behind the line under way: p50 ms | p99 ms | worst ms |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|";

    public const string MarkdownHead = "| Fault | presses | braked already | without a wire | p50 ms | p99 ms | worst ms | collecting ms |\n|---|---:|---:|---:|---:|---:|---:|---:|";

    public string ToMarkdown() => string.Create(CultureInfo.InvariantCulture, $"| {Fault} | {Milliseconds.Count + Braked + Lost} | {Braked} | {Lost} | {At(Milliseconds, 0.5)} | {At(Milliseconds, 0.99)} | {At(Milliseconds, 1.0)} | {LongestPause:0.00} |{(Behind is null ? "" : $" {At(Behind, 0.5)} | {At(Behind, 0.99)} | {At(Behind, 1.0)} |")}");

    private static string At(IReadOnlyList<double> times, double part) => times.Count == 0 ? "" : times[Math.Min(times.Count - 1, (int)(times.Count * part))].ToString("0.00", CultureInfo.InvariantCulture);
}
