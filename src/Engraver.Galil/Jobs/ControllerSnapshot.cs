using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The state in which a job finds the controller and has to leave it: as found now, or as found by an earlier run that failed and left the
/// program of a job in the memory.</summary>
internal sealed class ControllerSnapshot(ControllerSession session, ControllerProgramMemory memory, MachineProfile profile, JobOptions options, JobLog log)
{
    private readonly List<string> _lost = [];
    private CrashRecovery? _earlier;

    /// <summary>Reads the state, writes it to the journal and only then changes the program memory.</summary>
    /// <returns>The rejection, or null when <paramref name="resident"/> is in the memory.</returns>
    /// <exception cref="IOException">The journal or the copy of the program cannot be written.</exception>
    public async Task<Rejected?> BorrowAsync(string resident, CancellationToken stop)
    {
        var look = await memory.ReadProgramAsync(stop).ConfigureAwait(false);
        if (look is not Accepted { Data: var program }) return look as Rejected;
        var serial = (await session.Commands.ReadAsync("_BN", stop).ConfigureAwait(false)).ValuesOrEmpty;
        var now = new JournalFound(options.Address, session.Identity.Model, serial, session.Found);
        if (ResidentServer.IsOwn(program, profile)) Inherit(now);
        log.Found(now with { State = session.Found });
        var copy = options.JournalPath is { } journal ? CrashRecovery.CopyOf(journal) : null;
        return await memory.BorrowAsync(resident, _earlier?.Program ?? program, copy, stop).ConfigureAwait(false);
    }

    /// <summary>Restores the program, speeds and motors that were found. Call when the machine is at rest and the job's threads are halted.</summary>
    /// <param name="watch">Ended first; settings that it found changed by another host or program are left as they are.</param>
    /// <returns>What could not be restored, a sentence each.</returns>
    public async Task<IReadOnlyList<string>> RestoreAsync(JobWatch watch)
    {
        try
        {
            await watch.EndAsync().ConfigureAwait(false);
            var refused = await memory.GiveBackAsync(CancellationToken.None).ConfigureAwait(false);
            await session.AdoptPresentAsync(watch.Feed.SetByOthers).ConfigureAwait(false);
            var settings = await session.RestoreAsync(CancellationToken.None).ConfigureAwait(false);
            if (refused is not null) return [refused.Explain(), .. settings];
            if (settings.Count == 0) CloseEarlierRun();
            return [.. _lost, .. settings];
        }
        catch (Exception unwritten) when (unwritten is IOException or UnauthorizedAccessException)
        {
            return [Wording.Get("Job.EarlierJournalNotClosed", SystemErrorText.FromException(unwritten))];
        }
        catch (ControllerException failure)
        {
            return [Wording.Get("Job.ControllerNotRestored", failure.Message)];
        }
    }

    /// <summary>Program and settings are restored: the earlier run counts as ended.</summary>
    /// <exception cref="IOException">Its journal cannot be written.</exception>
    private void CloseEarlierRun()
    {
        if (_earlier is null || _earlier.JournalPath == options.JournalPath) return;
        using var journal = new JobJournal(_earlier.JournalPath);
        journal.Write(new JournalGivenBack(options.JournalPath ?? ""));
    }

    private void Inherit(JournalFound now)
    {
        _earlier = options.JournalPath is { } journal ? CrashRecovery.Last(journal, options.ResumedJournal, now) : null;
        if (_earlier is not null) session.AdoptFoundState(_earlier.Found.State);
        else _lost.Add(Wording.Get("ControllerSnapshot.PreviousStateUnknown"));
    }
}
