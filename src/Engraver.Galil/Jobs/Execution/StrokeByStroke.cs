using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The host commands each stroke: rapid to its start, its sequences one after the other, tool off.</summary>
internal sealed class StrokeByStroke(MotionProgram program, JobMachine machine, JobLedger ledger, JobLog log, ISequenceStrategy sequences) : IJobStrategy
{
    public Phase Whole => sequences.Whole;

    public ValueTask StartAsync() => sequences.StartAsync();

    public async ValueTask CutAsync()
    {
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++) await CutAsync(stroke).ConfigureAwait(false);
    }

    public ValueTask StoppedAsync(int counter)
    {
        sequences.StoppedAt(counter);
        return ValueTask.CompletedTask;
    }

    private async ValueTask CutAsync(int index)
    {
        var stroke = program.Strokes[index];
        ledger.Enter(index, 0);
        await machine.Tool.PrepareAsync(stroke.Terms).ConfigureAwait(false);
        await RapidMove.ToAsync(machine, stroke.Start).ConfigureAwait(false);
        for (var i = 0; i < stroke.Sequences.Count; i++)
        {
            ledger.Enter(index, i);
            await sequences.CutAsync(stroke.Sequences[i]).ConfigureAwait(false);
            log.SequenceDone(machine);
        }

        await machine.Tool.DwellAsync().ConfigureAwait(false);
        await machine.Tool.OffAsync().ConfigureAwait(false);
    }
}
