using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that runs jobs, and knows of runs beside the one under way: the last one's trace or a kept one, an interrupted
/// one, a simulated one.</summary>
public sealed partial class MachineSession
{
    /// <summary>Runs a job on the connected controller. One at a time.</summary>
    /// <param name="options">Gives the options of the run for the address of the session.</param>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<MachineRunReport> RunAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched is not { Connection: { } connection, Address: { } address }) throw new InvalidOperationException("No controller is connected.");
        return await WithStopAsync(stop => RunWatchedAsync(connection, job, program, options(address), stop), cancellation).ConfigureAwait(false);
    }

    /// <summary>Where the machine was in the last run of which that is known, real or simulated; null before the first.</summary>
    public RecordedRun? Recorded { get; private set; }

    /// <summary>Shows a run that was kept, or none; the next run takes its place.</summary>
    /// <param name="run">Null for none.</param>
    /// <exception cref="InvalidOperationException">A job runs, whose own trace is shown.</exception>
    public void ShowRun(RecordedRun? run)
    {
        if (IsRunning) throw new InvalidOperationException("A job runs.");
        Recorded = run;
        RaiseChanged();
    }

    /// <summary>Where an interrupted job is to go on, by its journal and by what the connected controller has kept.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<ResumePlace> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        return _watched.Watch is { } watch && !IsRunning ? await watch.FindResumeAsync(program, strategy, journal, cancellation).ConfigureAwait(false) : throw new InvalidOperationException("No controller is connected, or a job runs.");
    }

    /// <summary>Runs a job on a simulated controller of its own, as fast as it can be computed; a connected machine is left alone.</summary>
    /// <exception cref="InvalidOperationException">A job runs already.</exception>
    public async Task<MachineRunReport> SimulateAsync(PreparedJob job, MotionProgram program, Func<ControllerAddress, MachineRunOptions> options, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        var address = new SimulatedAddress(double.PositiveInfinity);
        await using var connection = Families.At(address, program.Profile).Connect(address, _time, false, null);
        var report = await WithStopAsync(stop => MachineRun.RunAsync(job, program, connection, options(address), _time, Listener(null), stop), cancellation).ConfigureAwait(false);
        Recorded = report.Trace is { } trace ? new RecordedRun(job, trace) : Recorded;
        RaiseChanged();
        return report;
    }

    private Task<MachineRunReport> WithStopAsync(Func<CancellationToken, Task<MachineRunReport>> run, CancellationToken cancellation) => _work.RunAsync(
        async stop =>
        {
            Progress = null;
            return LastRun = await run(stop).ConfigureAwait(false);
        },
        cancellation);

    private async Task<MachineRunReport> RunWatchedAsync(MachineConnection connection, PreparedJob job, MotionProgram program, MachineRunOptions options, CancellationToken stop)
    {
        ShownJob = job;
        Recorded = null;
        var live = LiveTrace.Of(job, options.DryRun);
        _status.JobBegins(options.DryRun);
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var report = await MachineRun.RunAsync(job, program, connection, options with { Hold = Hold, Control = _overrides.Begin(), Placed = frame => _status.Placed(frame) }, _time, Listener(_status, live), stop).ConfigureAwait(false);
            Recorded = report.Trace is { } trace ? new RecordedRun(job, trace) : Recorded;
            _status.JobEnds(report.Result);
            if (report.Result.Outcome == JobOutcome.Complete && !options.DryRun) Part = null;
            return report;
        }
        finally
        {
            _overrides.End();
            await _watched.ResumeAsync(connection).ConfigureAwait(false);
        }
    }
}
