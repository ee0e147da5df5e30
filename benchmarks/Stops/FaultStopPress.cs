using System.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Benchmarks.Stops;

/// <summary>Consecutive presses of STOP, each in a separate job on a separate controller: the job starts to move, the fault happens a little later, and
/// STOP is pressed within 60 ms after it.</summary>
internal sealed class FaultStopPress(string folder, int? baud, string? driver, PreparedJob job)
{
    /// <summary>The fault happens within this time after the first motion, so that it can be between any two commands; seconds.</summary>
    private const double EarliestFault = 0.1;
    private const double LatestFault = 0.5;

    /// <summary>STOP is pressed within this time after the fault, seconds.</summary>
    private const double PressWithin = 0.06;

    /// <summary>A stop that is not on the wire after this time will not arrive: the link is lost.</summary>
    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(2);

    private readonly Random _random = new(1);

    public bool IsSerial => baud is not null;

    /// <param name="fault">A faults file with a time in the past; null for none.</param>
    /// <returns>Null if the job ended before it moved, because this computer was busy: it does not count.</returns>
    /// <exception cref="ControllerException">The simulated controller could not be reached.</exception>
    public async Task<PressedStop?> RunAsync(string? fault, CancellationToken stop)
    {
        await using var controller = ServedSimulator.Create(new ServedSimulatorSettings(1.0));
        await using var wire = baud is { } rate ? await FaultStopSerialTap.OverSerialAsync(controller, Path.Combine(folder, "line"), rate, driver, stop).ConfigureAwait(false) : await FaultStopWire.OverTcpAsync(controller, stop).ConfigureAwait(false);
        var ear = new WireListener(wire);
        await using var machine = new MachineSession(TimeProvider.System);
        await machine.Connection.ConnectAsync(ControllerAddress.Parse(wire.Address), stop).ConfigureAwait(false);
        var program = machine.Connection.FitToLink(job.Motion.Program!, MachineFamilies.Default.DefaultStrategy, job.Drawing).Program;
        var run = machine.Runs.RunAsync(job, program, address => new MachineRunOptions(address, MachineFamilies.Default.DefaultStrategy) { JournalPath = Path.Combine(folder, "stop.jsonl") }, stop);
        try
        {
            if (await Task.WhenAny(ear.Moves, run).ConfigureAwait(false) == run) return null;
            await Task.Delay(TimeSpan.FromSeconds(EarliestFault + ((LatestFault - EarliestFault) * _random.NextDouble())), stop).ConfigureAwait(false);
            if (run.IsCompleted || machine.Runs.Progress is not { SegmentsSent: > 0 }) return null;
            ear.OnFault();
            if (fault is not null) controller.Schedule(fault);
            await Task.Delay(TimeSpan.FromSeconds(PressWithin * _random.NextDouble()), stop).ConfigureAwait(false);
            return await PressAsync(machine, wire, ear, run, stop).ConfigureAwait(false);
        }
        finally
        {
            wire.EndMeasurement();
            await EndAsync(run).ConfigureAwait(false);
        }
    }

    private static async Task<PressedStop> PressAsync(MachineSession machine, FaultStopWire wire, WireListener ear, Task run, CancellationToken stop)
    {
        var collecting = GC.GetTotalPauseDuration();
        wire.Press(Stopwatch.GetTimestamp());
        var pressed = ear.Press();
        machine.Controls.Stop();
        await Task.WhenAny(ear.Stop, Task.Delay(s_timeout, stop), GoneAsync(machine, run)).ConfigureAwait(false);
        var pause = (GC.GetTotalPauseDuration() - collecting).TotalMilliseconds;
        double? time = ear.Stop.IsCompleted && !ear.IsBraked ? Stopwatch.GetElapsedTime(pressed, await ear.Stop.ConfigureAwait(false)).TotalMilliseconds : null;
        return new PressedStop(time, ear.IsBraked, pause, wire.UnderWayMilliseconds);
    }

    /// <summary>Completes when the job has ended and no link is open; otherwise never.</summary>
    private static async Task GoneAsync(MachineSession machine, Task run)
    {
        await run.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        if (machine.Connection.Description is not null) await Task.Delay(Timeout.Infinite, CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>Waits for the end of the job, whatever its result.</summary>
    private static async Task EndAsync(Task run)
    {
        try
        {
            await run.ConfigureAwait(false);
        }
        catch (ControllerException)
        {
            // The link is lost, which is the purpose of the fault.
        }
        catch (OperationCanceledException)
        {
            // This program is ending.
        }
    }

    /// <summary>Detects on the wire the start of the motion along the path, and its braking.</summary>
    private sealed class WireListener
    {
        private static readonly char[] s_ends = ['\r', ';'];
        private readonly TaskCompletionSource _moves = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly TaskCompletionSource<long> _stop = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private long _faultAt = long.MaxValue;
        private long _pressedAt = long.MaxValue;
        private volatile bool _isBraked;

        public WireListener(FaultStopWire wire) => wire.CommandPassed += OnCommand;

        /// <summary>The path has started.</summary>
        public Task Moves => _moves.Task;

        /// <summary>The time stamp of the first braking command at or after the press.</summary>
        public Task<long> Stop => _stop.Task;

        /// <summary>The path was braked between the fault and the press.</summary>
        public bool IsBraked => _isBraked;

        public void OnFault() => Volatile.Write(ref _faultAt, Stopwatch.GetTimestamp());

        /// <returns>The time stamp of the press.</returns>
        public long Press()
        {
            var now = Stopwatch.GetTimestamp();
            Volatile.Write(ref _pressedAt, now);
            return now;
        }

        private void OnCommand(string text, long at)
        {
            if (Array.Exists(text.Split(s_ends), command => command == "BGS")) _moves.TrySetResult(); // a query of _BGS does not count
            if (!FaultStopWire.IsStop(text)) return;
            if (at >= Volatile.Read(ref _pressedAt)) _stop.TrySetResult(at);
            else if (at >= Volatile.Read(ref _faultAt)) _isBraked = true;
        }
    }
}

/// <summary>The result of one press.</summary>
/// <param name="Milliseconds">From STOP to the wire; null if it did not appear there, or was there before: what an ending job repeats after its own stop is
/// not a response to the press.</param>
/// <param name="IsBraked">The fault had ended the job, whose own stop was on the wire before the press.</param>
/// <param name="Pause">Garbage collection between the press and the wire, milliseconds.</param>
/// <param name="UnderWay">Remaining transmission time of a serial line at the press, milliseconds.</param>
internal readonly record struct PressedStop(double? Milliseconds, bool IsBraked, double Pause, double UnderWay);
