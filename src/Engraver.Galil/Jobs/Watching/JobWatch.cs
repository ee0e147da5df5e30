using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Judges every poll of a job, and ends the job when the poll shows a fault: the program in the controller or its watchdog has ended, the tool is
/// not as it should be, another host has changed the feed, nothing moves, or the machine is beside the planned motion.</summary>
internal sealed class JobWatch(JobMachine machine, MotionProgram program, JobLedger ledger, ProgressWatch progress)
{
    private readonly ToolWatch _tool = new();
    private readonly StopHandleWatch _stopHandle = new(machine.Session, ledger);

    /// <summary>Why a motion ended early.</summary>
    public JobFault Fault { get; } = new(machine, program, ledger);

    /// <summary>The speed of the path.</summary>
    public FeedWatch Feed { get; } = new(machine);

    /// <summary>The watchdog of the controller has to run.</summary>
    public bool IsGuarded { private get; set; }

    /// <summary>The last poll saw the tool output other than planned: the next poll must be a whole one.</summary>
    public bool IsToolSuspicious => _tool.IsSuspicious;

    /// <summary>The job is at standstill on purpose.</summary>
    public void HasProgress() => progress.Acted();

    /// <summary>Ends the checks of the stop handle.</summary>
    public ValueTask EndAsync() => _stopHandle.EndAsync();

    /// <summary>Call with each poll.</summary>
    public async ValueTask CheckAsync()
    {
        await _stopHandle.LookAsync().ConfigureAwait(false);
        if ((await FaultAsync().ConfigureAwait(false) ?? machine.Phase.Expected?.Invoke(machine.State)) is { } end) throw end.ToException();
    }

    private async ValueTask<JobEnd?> FaultAsync()
    {
        if (machine.IsStopped) return null; // what this poll saw may be an effect of the stop
        var (state, tool) = (machine.State, machine.Tool);
        var isToolWrong = _tool.IsWrong(state, tool.IsOutputOn(state), tool.Wanted(state), machine.Phase.Program is not null);
        var hasProgramEnded = state.Trip != 0 || state.ProgramError != 0 || !state.ProgramRuns;
        ledger.IsToolMissing = _tool.IsMissing && !hasProgramEnded; // otherwise the controller has switched it off and stopped
        if (hasProgramEnded) return await Fault.ProgramEndedAsync().ConfigureAwait(false);
        if (IsGuarded && !state.WatchdogRuns) return Fault.Unwatched();
        if (isToolWrong) return Fault.ToolSwitched();
        if (Feed.IsForeign()) return await Fault.FeedChangedAsync().ConfigureAwait(false);
        return progress.IsStalled(state) ? await Fault.StalledAsync(progress.Seconds).ConfigureAwait(false) : null;
    }
}
