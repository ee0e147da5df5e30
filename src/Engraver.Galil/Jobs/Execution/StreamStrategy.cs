using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Streams continuous vector sequences (galil-dmc.md F.1 method 1). A sequence that ran dry is closed at its standstill, and the rest of it
/// becomes a new one.</summary>
internal sealed class StreamStrategy(JobMachine machine, JobLedger ledger) : ISequenceStrategy
{
    private SequenceFeed? _feed;

    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public async ValueTask<JobStep> CutAsync(VectorSequence sequence)
    {
        var next = 0;
        machine.Hold.Speed.Bear(machine.Profile, [sequence], hostFeeds: true);
        while (next < sequence.Segments.Count)
        {
            _feed = new SequenceFeed(machine, ledger, sequence, next);
            if (await _feed.RunAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            next = _feed.Next;
        }

        _feed = null;
        return JobStep.Done;
    }

    public void StoppedAt(int counter) => _feed?.ConfirmUpTo(counter);
}
