using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The state in which a job finds the controller and has to leave it: as found now, or as found by an earlier run that died and left our program
/// in the memory.</summary>
internal sealed class ControllerSnapshot(ControllerSession session, ProgramMemory memory, MachineProfile profile, JobOptions options, JobLog log)
{
    private CrashRecovery? _earlier;

    /// <summary>What can no longer be restored, a sentence each.</summary>
    public List<string> Lost { get; } = [];

    /// <summary>Reads the state, writes it to the journal and only then changes the program memory.</summary>
    /// <returns>The refusal, or null when <paramref name="resident"/> is in the memory.</returns>
    /// <exception cref="IOException">The journal or the copy of the program cannot be written.</exception>
    public async Task<Rejected?> BorrowAsync(string resident, CancellationToken stop)
    {
        var look = await memory.LookAsync(stop).ConfigureAwait(false);
        if (look is not Accepted { Data: var program }) return look as Rejected;
        var serial = (await session.Commands.ReadAsync("_BN", stop).ConfigureAwait(false)).OrNothing;
        var now = new JournalFound(options.Address, session.Identity.Model, serial, session.Found);
        if (ResidentServer.IsOurs(program, profile)) Inherit(now);
        log.Found(now with { State = session.Found });
        var copy = options.JournalPath is { } journal ? CrashRecovery.CopyOf(journal) : null;
        return await memory.BorrowAsync(resident, _earlier?.Program ?? program, copy, stop).ConfigureAwait(false);
    }

    /// <summary>Called when program and settings are restored: the earlier run counts as ended.</summary>
    /// <exception cref="IOException">Its journal cannot be written.</exception>
    public void GivenBack()
    {
        if (_earlier is null || _earlier.JournalPath == options.JournalPath) return;
        using var journal = new JobJournal(_earlier.JournalPath);
        journal.Write(new JournalGivenBack(options.JournalPath ?? ""));
    }

    private void Inherit(JournalFound now)
    {
        _earlier = options.JournalPath is { } journal ? CrashRecovery.Last(journal, options.ResumedJournal, now) : null;
        if (_earlier is not null) session.Inherit(_earlier.Found.State);
        else Lost.Add(Wording.Get("ControllerSnapshot.PreviousStateUnknown"));
    }
}
