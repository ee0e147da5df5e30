using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Streams continuous vector sequences (galil-dmc.md F.1 method 1). A sequence that ran dry is closed at standstill, and the rest of it
/// becomes a new one.</summary>
internal sealed class StreamStrategy(JobMachine machine, JobLedger ledger) : ISequenceStrategy
{
    private SequenceFeed? _feed;

    public Phase Whole => Phase.Idle;

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    public async ValueTask CutAsync(VectorSequence sequence)
    {
        var next = 0;
        var cut = machine.Speed.Plan(sequence, hostFeeds: true);
        while (next < cut.Sequence.Segments.Count)
        {
            _feed = new SequenceFeed(machine, ledger, cut, next);
            await _feed.RunAsync().ConfigureAwait(false);
            next = _feed.Next;
        }

        _feed = null;
    }

    public void StoppedAt(int counter) => _feed?.ConfirmUpTo(counter);
}
